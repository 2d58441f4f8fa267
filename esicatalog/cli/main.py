"""The command group; every command is loaded only when it is called."""

import importlib
import os
import sys
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import click

from esicatalog.cli.common import EXIT_UNUSABLE, say_interrupted
from esicatalog.version import __version__
from esicatalog.words import one_line

COMMANDS = {
    "ingest": "Read ESI files, folders and archives into the catalog.",
    "devices": "List the devices that fulfil conditions, with evidence.",
    "identify": "Say what a device is, or every slave of a bus.",
    "sii": "Read EEPROM (SII) images.",
    "show": "Print the sheet of one device.",
    "diff": "Compare two devices or two ESI files.",
    "export": "Generate configuration for a master, an EEPROM image or ESI XML.",
    "lint": "Check ESI files by documented rules.",
    "serve": "Browse the catalog in Datasette.",
    "snapshot": "Copy a catalog into one read-only file.",
    "check": "Verify the catalog and print its content hash.",
    "migrate": "Bring a catalog of an older version up to date.",
}


class _LazyGroup(click.Group):
    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = importlib.import_module(f"esicatalog.cli.{cmd_name}").command
        return command

    def format_commands(self, ctx: click.Context, formatter: Any) -> None:
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))

    def main(self, args: Sequence[str] | None = None, *rest: Any, **options: Any) -> Any:
        """Run a command; wrong usage is one line and exit code 2, as every other error is."""
        run: Callable[..., Any] = super().main
        words = sys.argv[1:] if args is None else list(args)
        if not options.pop("standalone_mode", True):
            return run(words, *rest, standalone_mode=False, **options)
        for name in ("stdout", "stderr"):
            if getattr(sys, name) is None:  # closed by the shell: >&-
                setattr(sys, name, open(os.devnull, "w"))  # noqa: SIM115
        try:
            code = run(words, *rest, standalone_mode=False, **options)
        except click.exceptions.NoArgsIsHelpError as error:
            error.show()
            sys.exit(EXIT_UNUSABLE)
        except click.ClickException as error:
            click.echo(_one_line(error, self._path(words)), err=True)
            sys.exit(EXIT_UNUSABLE)
        except click.Abort as error:
            sys.exit(say_interrupted(error))
        sys.exit(code if isinstance(code, int) else 0)

    def _path(self, words: Iterable[str]) -> str:
        """The command that words call; not every error of click knows it."""
        command: click.Command = self
        path = ["esicatalog"]
        for word in words:
            found = command.get_command(click.Context(command), word) if isinstance(command, click.Group) else None
            if found is None:
                break
            command = found
            path.append(word)
        return " ".join(path)


def _one_line(error: click.ClickException, path: str) -> str:
    """What is wrong, after the command that it was said to, and where to look."""
    message = one_line(error.format_message()).removesuffix(".")
    return f"{path}: {message[:1].lower()}{message[1:]} (see {path} --help)"


@click.group(cls=_LazyGroup, context_settings={"help_option_names": ["-h", "--help"]})
@click.version_option(__version__, prog_name="esicatalog")
def cli() -> None:
    """The catalog of EtherCAT devices, made from the vendors' ESI files."""
