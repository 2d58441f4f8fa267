"""Work that is done once for what descriptions and documents share, and that nothing is mixed up by it."""

import pytest
from snippets import device, dictionary, esi, mapping_objects, pdo, read, write

import esicatalog.esi.reader as reader_module
from esicatalog.esi.containers import Folder
from esicatalog.esi.documents import parse_document
from esicatalog.esi.lines import Lines
from esicatalog.esi.reader import Reader
from esicatalog.esi.tree import DocumentTree
from esicatalog.lint.linter import Linter
from esicatalog.lint.objects import ObjectValues, ValuesOfType
from esicatalog.model.derivation import Deriver
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.resolver import Resolver

OUTPUTS = "<Sm ControlByte='#x64' DefaultSize='3'>Outputs</Sm>" + pdo("RxPdo", "#x1600", 16, attributes="Sm='0'")
SAMPLED = OUTPUTS.replace("Sm='0'", "Sm='0' OSFac='2'")
UINT = "<DataType><Name>UINT</Name><BitSize>16</BitSize></DataType>"
RECORD = (
    "<DataType><Name>DT1</Name><BitSize>48</BitSize>"
    "<SubItem><SubIdx>0</SubIdx><Name>Count</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>0</BitOffs></SubItem>"
    "<SubItem><SubIdx>1</SubIdx><Name>A</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>16</BitOffs></SubItem>"
    "<SubItem><SubIdx>2</SubIdx><Name>B</Name><Type>UINT</Type><BitSize>16</BitSize><BitOffs>32</BitOffs></SubItem>"
    "</DataType>"
)


def declared(info: str, type_name: str = "UINT", bits: int = 16, index: str = "#x2000") -> str:
    return (
        f"<Object><Index>{index}</Index><Name>O</Name><Type>{type_name}</Type><BitSize>{bits}</BitSize>"
        f"<Info>{info}</Info></Object>"
    )


def named(name: str, data: str) -> str:
    return f"<SubItem><Name>{name}</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem>"


class Folders(Folder):
    """A folder that notes what is read."""

    def __init__(self, root):
        super().__init__(root)
        self.reads = []

    def read(self, member):
        self.reads.append(member)
        return super().read(member)


@pytest.fixture
def referring(tmp_path):
    profile = "<Profile><DictionaryFile>d.xml</DictionaryFile></Profile>"
    objects = declared("<DefaultData>01</DefaultData>")
    text = f"<EtherCATDict><Dictionary><DataTypes>{UINT}</DataTypes>\n<Objects>\n{objects}</Objects></Dictionary>"
    return Folders(write(tmp_path, {"main.xml": esi(device(profile)), "d.xml": text + "</EtherCATDict>"}))


def pulled_dictionary(container):
    reader = Reader()
    reader.read_tree(container.read("main.xml"), "main.xml", container)
    return reader.pulled(container, "d.xml")


def test_the_tree_of_a_pulled_document_waits_for_its_findings(referring):
    pulled = pulled_dictionary(referring)
    (found,) = Linter().document(pulled.document, pulled.tree)
    assert (found.rule, found.line) == ("L45", 3)
    assert referring.reads == ["main.xml", "d.xml"]


def test_a_tree_asked_for_again_is_read_again(referring):
    pulled = pulled_dictionary(referring)
    for _ in range(2):
        assert [found.line for found in Linter().document(pulled.document, pulled.tree)] == [3]
    assert referring.reads == ["main.xml", "d.xml", "d.xml"]


def test_trees_of_long_documents_do_not_wait(referring, monkeypatch):
    monkeypatch.setattr(reader_module, "_MAX_TREES_BYTES", 10)
    pulled = pulled_dictionary(referring)
    assert [found.line for found in Linter().document(pulled.document, pulled.tree)] == [3]
    assert referring.reads == ["main.xml", "d.xml", "d.xml"]


def test_devices_with_the_same_process_data_share_what_follows_from_it():
    content = esi(device(OUTPUTS) + "\n" + device(OUTPUTS, revision="#x2") + "\n" + device(revision="#x3"))
    document = read(content)
    deriver = Deriver()
    first, second, other = (deriver.derive(item, ()) for item in document.document.infos[0].devices)
    assert first.process_data is second.process_data is not other.process_data
    assert first.facts == second.facts and first.facts.output_bytes == 2 and other.facts.output_bytes == 0


def test_what_a_rule_finds_in_shared_process_data_is_told_of_each_device():
    content = esi(device(OUTPUTS) + "\n" + device(OUTPUTS, revision="#x2")).encode()
    document, tree = Reader().read_tree(content)
    found = [(item.line, item.path) for item in Linter().document(document, tree) if item.rule == "L24"]
    assert found == [(n + 1, f"EtherCATInfo/Descriptions/Devices/Device[{n}]/Sm") for n in range(2)]


@pytest.mark.parametrize(
    "more",
    [
        "<Dc><OpMode><Name>m</Name><AssignActivate>0</AssignActivate></OpMode></Dc>",
        "<Sm>Inputs</Sm>",
        '<Mailbox><CoE PdoUpload="1"/></Mailbox>',
    ],
)
def test_what_process_data_depend_on_is_not_shared(more):
    devices = read(esi(device(OUTPUTS) + device(more + OUTPUTS))).document.infos[0].devices
    deriver = Deriver()
    first, second = (deriver.derive(item, ()).process_data for item in devices)
    assert first is not second


def test_samples_are_not_shared_with_devices_of_another_dictionary():
    """0x7000:01 and again by default, 0x6001:01 and 0x6001:02 with the mapping objects."""
    sampled = SAMPLED + '<Mailbox><CoE PdoAssign="1"/></Mailbox>'
    maps = mapping_objects((0x1600, "10010160"), (0x1601, "10020160"))
    devices = read(esi(device(sampled) + device(maps + sampled))).document.infos[0].devices
    deriver = Deriver()
    first, second = (deriver.derive(item, ()) for item in devices)
    assert first.process_data.image_signature != second.process_data.image_signature
    assert first.facts.output_bytes == second.facts.output_bytes == 4


def test_a_derivation_is_the_same_for_all_who_ask():
    (found,) = read(esi(device(OUTPUTS))).document.infos[0].devices
    deriver = Deriver()
    assert deriver.derive(found, ()) is deriver.derive(found, [])


def test_equal_dictionaries_have_one_view():
    profile = dictionary(UINT, declared("") + declared("<DefaultData>0100</DefaultData>"))
    reader = Reader()
    contents = [esi(device(profile)), esi(device(profile, product="#x2")), esi(device(dictionary(UINT, declared(""))))]
    read_ones = [reader.read(text.encode()).document.infos[0].devices[0] for text in contents]
    views = DictionaryViews()
    first, second, other = (views.view(item.profiles[0].dictionary) for item in read_ones)
    assert first is second is not other
    assert first.entries(0x2000)[0].default_raw is None, "of two with one index the first counts"
    assert first.entries(0x2001) is None
    calls = []
    assert first.once(calls.append) is None is first.once(calls.append)
    assert calls == [first]


@pytest.mark.parametrize(
    ("text", "is_resolved"),
    [
        (declared(""), False),
        (declared("<DefaultData>0100</DefaultData>"), False),
        (declared("<DefaultData>01</DefaultData>"), True),
        (declared("<DefaultValue>1</DefaultValue>"), False),
        (declared("<DefaultValue>9</DefaultValue><MaxValue>8</MaxValue>"), True),
        (declared("<MaxValue>8</MaxValue>"), False),
        (declared("<DefaultString>1</DefaultString>"), True),
        (declared(named("Count", "0200") + named("A", "0100") + named("B", "0100"), "DT1", 48), False),
        (declared(named("B", "0100"), "DT1", 48), False),
        (declared(named("B", "01"), "DT1", 48), True),
        (declared(named("C", "0100"), "DT1", 48), True),
    ],
)
def test_objects_are_resolved_only_where_their_values_could_be_wrong(text, is_resolved, monkeypatch):
    (held,) = read(esi(device(dictionary(UINT + RECORD, text)))).document.infos[0].devices
    found = held.profiles[0].dictionary
    asked = []

    class Watched(Resolver):
        def resolve(self, declared, types):
            asked.append(declared)
            return super().resolve(declared, types)

    resolver = Watched()
    types = resolver.types(found)
    sub_items = types.by_name[found.objects[0].type].sub_items
    of_type = ValuesOfType(sub_items, types) if sub_items else None
    values = ObjectValues(found.objects[0], of_type, types, resolver)
    assert values.is_sound is not is_resolved
    assert isinstance(values.with_values, list)
    assert bool(asked) is is_resolved


def test_values_of_no_sub_item_are_not_sound_even_if_they_say_nothing():
    text = declared("<SubItem><Name>C</Name></SubItem>", "DT1", 48)
    (held,) = read(esi(device(dictionary(UINT + RECORD, text)))).document.infos[0].devices
    found, resolver = held.profiles[0].dictionary, Resolver()
    types = resolver.types(found)
    of_type = ValuesOfType(types.by_name[found.objects[0].type].sub_items, types)
    values = ObjectValues(found.objects[0], of_type, types, resolver)
    assert not values.is_paired
    assert not values.is_sound
    assert values.with_values == []


@pytest.mark.parametrize("before", [10, 65_530, 65_540])
def test_lines_in_parts_that_were_cut_out_are_those_of_the_document(before):
    """The PDO is known from the document before; its second entry stands on its fourth line."""
    entry = "<Entry><Index>#x7000</Index><SubIndex>1</SubIndex>{}<Name>e</Name></Entry>"
    parts = ["<RxPdo>", "<Index>#x1600</Index><Name>P</Name>", entry.format("<BitLen>8</BitLen>"), entry.format("")]
    part = "\n".join(parts) + "\n\n\n\n\n</RxPdo>"
    reader = Reader()
    reader.read(esi(device(part)).encode())
    content = esi("\n" * before + device("\n" + part) + "\n" + device("\n" + part, revision="#x2")).encode()
    document, tree = reader.read_tree(content)
    assert tree().cut is not None
    plain = DocumentTree(parse_document(content).root, Lines(content))
    lines = [item.line for item in Linter().document(document, tree) if item.rule == "L33"]
    assert lines == [item.line for item in Linter().document(document, lambda: plain) if item.rule == "L33"]
    expected = [n for n, line in enumerate(content.decode().splitlines(), 1) if line == parts[3]]
    assert [line for line in lines if line <= 65_535] == [line for line in expected if line <= 65_535]
