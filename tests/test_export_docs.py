"""docs/igh.md shows what the command beside it prints, and that compiles."""

import re
import shlex
from pathlib import Path

import pytest
from click.testing import CliRunner
from test_export_compile import IGH_15, IGH_16, check_syntax, needs_gcc

from esicatalog.cli.export import command
from esicatalog.version import __version__

CHECKOUT = Path(__file__).parent.parent


@pytest.fixture(scope="module")
def page() -> str:
    return (CHECKOUT / "docs" / "igh.md").read_text()


@pytest.fixture(scope="module")
def shown(page) -> str:
    """The generated header on the page."""
    (header,) = re.findall(r"```c\n(/\*.*?)```", page, re.DOTALL)
    return header


def test_the_header_is_what_the_command_prints(page, shown, monkeypatch):
    (words,) = re.findall(r"esicatalog export (igh --esi data/l6n_drive.xml \\\n.*?)\n```", page, re.DOTALL)
    monkeypatch.chdir(CHECKOUT)
    printed = CliRunner().invoke(command, shlex.split(words.replace("\\\n", "")), catch_exceptions=False)
    assert re.sub(r"esicatalog \d+(\.\w+)+", f"esicatalog {__version__}", shown) == printed.stdout


@needs_gcc
@pytest.mark.parametrize("options", [IGH_15, IGH_16], ids=["1.5", "1.6"])
def test_the_shown_header_compiles(shown, tmp_path, options):
    check_syntax(tmp_path, [shown], options)


@needs_gcc
def test_the_shown_use_compiles(page, shown, tmp_path):
    (use,) = re.findall(r"```c\n(ec_master_t .*?)```", page, re.DOTALL)
    declarations = (
        "ec_master_t *ecrt_request_master(unsigned int index);\n"
        "ec_domain_t *ecrt_master_create_domain(ec_master_t *master);\n"
        "int ecrt_master_activate(ec_master_t *master);\n"
        "uint8_t *ecrt_domain_data(ec_domain_t *domain);\n"
    )
    check_syntax(tmp_path, [f"{shown}\n{declarations}static int use(void)\n{{\n{use}return 0;\n}}\n"], IGH_16)
