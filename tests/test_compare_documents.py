"""Which devices of two files are compared with each other."""

from snippets import device, esi, read

from esicatalog.model.compare_documents import described_devices, paired_devices


def pairs(left: list[str], right: list[str]) -> list[tuple[str | None, str | None]]:
    """Names of the devices that belong together."""

    def names(devices: list[str]):
        return described_devices(read(esi("".join(devices))).document)

    return [
        tuple(item.device.names[0].text if item is not None else None for item in pair)
        for pair in paired_devices(names(left), names(right))
    ]


def one(name: str, product: str, revision: str, type_text: str = "T") -> str:
    return device(product=product, revision=revision, type_text=type_text, name=name)


def test_two_files_with_one_device_each():
    assert pairs([one("a", "1", "1")], [one("b", "2", "7")]) == [("a", "b")]


def test_the_same_revision_comes_first():
    left = [one("a1", "1", "1"), one("a2", "1", "2"), one("b", "2", "1")]
    right = [one("b'", "2", "1"), one("a2'", "1", "2"), one("a3'", "1", "3")]
    assert pairs(left, right) == [("a1", None), ("a2", "a2'"), ("b", "b'"), (None, "a3'")]


def test_of_one_revision_the_same_type_comes_first():
    left = [one("a", "1", "1", "A"), one("b", "1", "1", "B"), one("c", "1", "1", "C")]
    right = [one("b'", "1", "1", "B"), one("x'", "1", "1", "X"), one("a'", "1", "1", "A")]
    assert pairs(left, right) == [("a", "a'"), ("b", "b'"), ("c", "x'")]


def test_a_product_with_other_revisions_only():
    left = [one("a", "1", "1", "A"), one("b", "1", "2", "B"), one("c", "2", "1")]
    right = [one("b'", "1", "4", "B"), one("a'", "1", "3", "A"), one("c'", "2", "2"), one("d'", "3", "1")]
    assert pairs(left, right) == [("a", "a'"), ("b", "b'"), ("c", "c'"), (None, "d'")]


def test_devices_without_codes_go_by_their_type():
    left = [device(product="", type_text="cap", name="cap"), device(product="", type_text="feed", name="feed")]
    right = [device(product="", type_text="feed", name="feed'"), one("a'", "1", "1")]
    assert pairs(left, right) == [("cap", None), ("feed", "feed'"), (None, "a'")]


def test_lines_and_modules_come_with_the_device():
    slots = '<Slots><Slot MinInstances="1" MaxInstances="1"><ModuleIdent>1</ModuleIdent></Slot></Slots>'
    modules = "".join(f'<Module><Type ModuleIdent="{n}">M</Type><Name>M</Name></Module>' for n in (1, 2))
    (found,) = described_devices(read(esi("\n\n" + device(slots), modules)).document)
    assert (found.line, found.vendor_id, found.vendor) == (3, 0xE5C, "Test vendor")
    assert [module.module_ident for module in found.modules] == [1]
