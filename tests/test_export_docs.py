"""The pages on the exports show what the commands beside them print, and what they show compiles and runs.

On a page, the blocks below a command on one of our files belong to it, up to the next heading: together they are what
it prints, from the first line to the last; lines are left out only between blocks and where a line says …. A block that
begins with $ is a session: commands, each with all that it says.
"""

import ctypes
import re
import shlex
import sys
import types
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple
from xml.etree import ElementTree

import pytest
import yaml
from click.testing import CliRunner, Result
from test_export_compile import IGH_15, IGH_16, SOEM_2, SOEM_14, check_syntax, needs_gcc

from esicatalog.cli.export import command
from esicatalog.version import __version__

CHECKOUT = Path(__file__).parent.parent
PAGES = ("igh", "soem", "ros2", "linuxcnc")
_BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
_LEFT_OUT = re.compile(r"^ *…\n", re.MULTILINE)
_PROMPT = "$ "


class Example(NamedTuple):
    """A command on a page, without the name of the program, and the blocks that show what it prints."""

    page: str
    words: str
    blocks: tuple[str, ...]


def sections(page: str) -> list[list[tuple[str, str]]]:
    """The blocks of a page by its headings, each with its language."""
    text = (CHECKOUT / "docs" / f"{page}.md").read_text()
    return [_BLOCK.findall(section) for section in re.split(r"^##+ ", text, flags=re.MULTILINE)]


def examples(page: str) -> Iterator[Example]:
    for blocks in sections(page):
        commands = [block for language, block in blocks if not language and re.match(r"esicatalog .* data/", block)]
        if commands:
            (words,) = commands
            shown = tuple(block for language, block in blocks if language)
            yield Example(page, words.replace("\\\n", "").removeprefix("esicatalog export "), shown)


def sessions(page: str) -> Iterator[tuple[str, str]]:
    """Commands with what they say."""
    for blocks in sections(page):
        for _, block in blocks:
            if block.startswith(_PROMPT):
                for part in re.split(r"^\$ esicatalog export ", block, flags=re.MULTILINE)[1:]:
                    words, _, said = part.partition("\n")
                    yield words, said


def use(page: str, beginning: str) -> str:
    """The block that is no output and begins so."""
    (found,) = (text for blocks in sections(page) for _, text in blocks if text.startswith(beginning))
    return found


EXAMPLES = {f"{found.page} {found.words.split()[0]}": found for page in PAGES for found in examples(page)}
SESSIONS = [said for page in PAGES for said in sessions(page)]


def result_of(words: str) -> Result:
    return CliRunner().invoke(command, shlex.split(words), catch_exceptions=False)


@pytest.fixture
def printed(monkeypatch) -> dict[str, str]:
    """What the commands of the examples print."""
    monkeypatch.chdir(CHECKOUT)
    return {name: result_of(example.words).stdout for name, example in EXAMPLES.items()}


def test_every_page_has_an_example():
    assert list(EXAMPLES) == ["igh igh", "soem soem", "soem pysoem", "ros2 ros2", "linuxcnc linuxcnc"]


@pytest.mark.parametrize("name", EXAMPLES)
def test_a_page_shows_what_its_command_prints(printed, name):
    shown = re.sub(r"esicatalog \d+(\.\w+)+", f"esicatalog {__version__}", "…\n".join(EXAMPLES[name].blocks))
    pattern = r"(?:.*\n)*?".join(map(re.escape, _LEFT_OUT.split(shown)))
    assert re.fullmatch(pattern, printed[name]), f"docs/{EXAMPLES[name].page}.md shows something else than {name}"


@pytest.mark.parametrize(("words", "said"), SESSIONS)
def test_a_page_says_what_a_command_answers(monkeypatch, data_db, words, said):
    monkeypatch.chdir(CHECKOUT)
    monkeypatch.setenv("ESICATALOG_DB", str(data_db))
    assert result_of(words).output == said


@needs_gcc
@pytest.mark.parametrize(
    ("name", "version", "options"),
    [
        ("igh igh", "", IGH_15),
        ("igh igh", "", IGH_16),
        ("soem soem", " --soem 1.4", SOEM_14),
        ("soem soem", " --soem 2", SOEM_2),
    ],
)
def test_the_shown_headers_compile(monkeypatch, tmp_path, name, version, options):
    monkeypatch.chdir(CHECKOUT)
    check_syntax(tmp_path, [result_of(EXAMPLES[name].words.rstrip() + version).stdout], options)


IGH_DECLARATIONS = """
ec_master_t *ecrt_request_master(unsigned int index);
ec_domain_t *ecrt_master_create_domain(ec_master_t *master);
int ecrt_master_activate(ec_master_t *master);
uint8_t *ecrt_domain_data(ec_domain_t *domain);
"""
SOEM_DECLARATIONS = """
enum { EC_STATE_SAFE_OP = 4, EC_STATE_OPERATIONAL = 8, EC_TIMEOUTSTATE = 2000000 };
int ecx_init(ecx_contextt *context, const char *ifname);
int ecx_config_init(ecx_contextt *context);
int ecx_config_map_group(ecx_contextt *context, void *pIOmap, uint8 group);
boolean ecx_configdc(ecx_contextt *context);
uint16 ecx_statecheck(ecx_contextt *context, uint16 slave, uint16 reqstate, int timeout);
"""


@needs_gcc
@pytest.mark.parametrize(
    ("page", "beginning", "declarations", "options"),
    [("igh", "ec_master_t ", IGH_DECLARATIONS, IGH_16), ("soem", "static ecx_contextt ", SOEM_DECLARATIONS, SOEM_2)],
)
def test_the_shown_use_compiles(printed, tmp_path, page, beginning, declarations, options):
    body = f"static int use(void)\n{{\n{use(page, beginning)}return 0;\n}}\n"
    check_syntax(tmp_path, [f"{printed[f'{page} {page}']}\n{declarations}{body}"], options)


class FakeSlave:
    """What the shown program needs of a slave of pysoem: the L6N drive at position 1234."""

    man, id, rev = 0x4321, 0xE2, 1

    def __init__(self) -> None:
        self.setup_func = None
        self.output = bytes(8)
        self.input = (1234).to_bytes(4, "little").rjust(9, b"\0").ljust(19, b"\0")
        self.calls: list[str] = []

    def sdo_write(self, index: int, subindex: int, data: bytes) -> None:
        self.calls.append(f"sdo 0x{index:04x}:{subindex:02x} {data.hex()}")

    def dc_sync(self, act, sync0_cycle_time, sync0_shift_time=0) -> None:
        self.calls.append(f"dc {act} {sync0_cycle_time} {sync0_shift_time}")


class FakeMaster:
    """What the shown program needs of pysoem's master."""

    def __init__(self) -> None:
        self.slaves = [FakeSlave()]

    def open(self, ifname: str) -> None:
        pass

    def config_init(self) -> int:
        return len(self.slaves)

    def config_map(self) -> None:
        for slave in self.slaves:
            slave.setup_func(slave)

    def config_dc(self) -> None:
        pass

    def state_check(self, expected_state: int, timeout: int) -> int:
        return expected_state

    def send_processdata(self) -> None:
        pass

    def receive_processdata(self, timeout: int) -> None:
        pass


def test_the_shown_program_for_pysoem_runs(printed, monkeypatch):
    module = types.ModuleType("l6n")
    exec(printed["soem pysoem"], module.__dict__)
    pysoem = types.ModuleType("pysoem")
    pysoem.__dict__.update(Master=FakeMaster, SAFEOP_STATE=4)
    monkeypatch.setitem(sys.modules, "l6n", module)
    monkeypatch.setitem(sys.modules, "pysoem", pysoem)
    names: dict[str, object] = {}
    exec(use("soem", "import ctypes\nimport pysoem"), names)
    slave = names["slave"]
    assert isinstance(slave, FakeSlave)
    assert (slave.calls[0], slave.calls[-1]) == ("sdo 0x6060:00 08", "dc True 1000000 0")
    assert slave.output == bytes(2) + (1234).to_bytes(4, "little") + bytes(2)
    assert len(slave.output) == ctypes.sizeof(module.Outputs)


def test_the_shown_urdf_names_interfaces_of_the_slave_file(printed):
    channels = {
        (kind, channel[kind])
        for pdos in (yaml.safe_load(printed["ros2 ros2"])[key] for key in ("rpdo", "tpdo"))
        for pdo in pdos
        for channel in pdo["channels"]
        for kind in ("command_interface", "state_interface")
        if kind in channel
    }
    root = ElementTree.fromstring(use("ros2", "<ros2_control"))
    named = {(element.tag, element.get("name")) for element in root.iter() if element.tag.endswith("_interface")}
    assert named
    assert named <= channels


def test_the_shown_hal_file_names_pins_of_the_configuration(printed):
    root = ElementTree.fromstring(printed["linuxcnc linuxcnc"].encode())
    pins = {f"lcec.0.l6n.{element.get('halPin')}" for element in root.iter() if element.get("halPin")}
    named = re.findall(r"lcec\.0\.\S+", use("linuxcnc", "loadusr "))
    assert len(named) > 1
    assert set(named) <= pins
