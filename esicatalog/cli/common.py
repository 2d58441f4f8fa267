"""What all commands share: the catalog option, number types, error handling, output formats."""

import contextlib
import csv
import functools
import os
import shlex
import signal
import sys
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click

from esicatalog.catalog.results import json_bytes
from esicatalog.errors import DocumentError, EsiCatalogError, InputError, NotFound
from esicatalog.identity import (
    Identity,
    parse_bounds,
    parse_identity,
    parse_modes,
    parse_number,
    parse_object,
    parse_plugged,
)

if TYPE_CHECKING:
    from esicatalog.api import Catalog

EXIT_NO = 1
"""The answer is "no": not found, failed documents, problems."""
EXIT_UNUSABLE = 2
"""Wrong usage or unusable input."""

_WIDEST_CELL = 60

Function = TypeVar("Function", bound=Callable[..., Any])
Result = TypeVar("Result")


class Command(click.Command):
    """A command that refuses a second value for an option that takes one: the first would be lost in silence."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """As click does it; raises :class:`click.UsageError`."""
        _, _, given = self.make_parser(ctx).parse_args(list(args))
        for option in given:
            takes_one = isinstance(option, click.Option) and not (option.multiple or option.is_flag)
            if takes_one and given.count(option) > 1:
                raise click.UsageError(f"{option.opts[-1]} is given more than once", ctx)
        return super().parse_args(ctx, args)


class Group(click.Group):
    """A group of such commands."""

    command_class = Command


db_option = click.option(
    "--db",
    metavar="FILE|URL",
    default="catalog.db",
    envvar="ESICATALOG_DB",
    show_default=True,
    show_envvar=True,
    help="The catalog.",
)


def format_option(*formats: str) -> Callable[[Function], Function]:
    """The option ``--format``; the first is the default."""
    return click.option(
        "--format",
        "output_format",
        type=click.Choice(formats),
        default=formats[0],
        show_default=True,
        help="How to print.",
    )


@contextlib.contextmanager
def catalog_to_ask(db: str, read_only: bool = False) -> "Iterator[Catalog]":
    """The catalog, closed at the end; stderr says first when not all may be in it that it was given."""
    from esicatalog.api import Catalog
    from esicatalog.catalog.unfinished import CUT_SHORT

    with Catalog.open(db, read_only=read_only) as catalog:
        if catalog.is_unfinished():
            click.echo(f"esicatalog: {CUT_SHORT}", err=True)
        yield catalog


class Terminated(KeyboardInterrupt):
    """SIGTERM, where a command takes it as Ctrl-C."""


def say_interrupted(error: BaseException) -> int:
    """One line about an interrupt, with what a command has noted of it; returns the exit code that shells give it."""
    click.echo("; ".join(["esicatalog: interrupted", *getattr(error, "__notes__", ())]), err=True)
    return 128 + (signal.SIGTERM if isinstance(error, Terminated) else signal.SIGINT)


def say_no_document(paths: Iterable[str]) -> None:
    """One line where paths are there and hold nothing: one of them may be mistyped."""
    click.echo(f"esicatalog: no ESI document was found in {', '.join(paths)}", err=True)


def reporting_errors(function: Function) -> Function:
    """Turn named errors into one line on stderr and the exit code of the contract."""

    @functools.wraps(function)
    def wrapped(*args: Any, **kwargs: Any) -> Any:
        try:
            try:
                return function(*args, **kwargs)
            finally:
                _flush_stdout()
        except EsiCatalogError as error:
            hint = error.hint if isinstance(error, NotFound) else None
            click.echo(f"esicatalog: {error}; see: {hint}" if hint else f"esicatalog: {error}", err=True)
            sys.exit(EXIT_NO if isinstance(error, NotFound) else EXIT_UNUSABLE)
        except KeyboardInterrupt as error:
            sys.exit(say_interrupted(error))
        except (MemoryError, RecursionError):
            click.echo("esicatalog: the input is too large or too deep to be read", err=True)
            sys.exit(EXIT_UNUSABLE)
        except BrokenPipeError:
            sys.exit(EXIT_NO)
        except OSError as error:
            what = f"{error.filename}: " if error.filename else ""
            click.echo(f"esicatalog: {what}{error.strerror or error}", err=True)
            sys.exit(EXIT_UNUSABLE)

    return wrapped  # type: ignore[return-value]


def _flush_stdout() -> None:
    """Write what was printed; what could not be written before fails again here, and is named."""
    try:
        sys.stdout.flush()
    except OSError as error:
        error.filename = "standard output"
        # What is still buffered cannot be written; the interpreter would try again at its end, and say so.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        raise


class _Parsed(click.ParamType[Any]):
    """An argument that a parser of :mod:`esicatalog.identity` reads; its errors are one line that names the option."""

    def __init__(self, name: str, parse: Callable[..., Any], takes_name: bool = False) -> None:
        """``takes_name``: the parser says in its errors what argument or option it reads."""
        self.name = name
        self._parse = parse
        self._takes_name = takes_name

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        if not isinstance(value, str):
            return value
        option = f"{param.opts[0]}: " if isinstance(param, click.Option) else ""
        try:
            return self._parse(value, param.opts[0]) if self._takes_name and param is not None else self._parse(value)
        except EsiCatalogError as error:
            click.echo(f"esicatalog: {'' if self._takes_name else option}{error}", err=True)
            sys.exit(EXIT_UNUSABLE)


def _identity(text: str) -> Identity:
    """An identity; what cannot be one is taken for a name that was meant."""
    try:
        return parse_identity(text)
    except InputError as error:
        if ":" in text:
            raise
        raise InputError(f"{error}; to find one: esicatalog devices --text {shlex.quote(text)}") from error


def named_file(text: str) -> Path:
    """The file of this name. Raises :class:`InputError` for none, which would be the folder that we are in."""
    if not text:
        raise InputError("the name is empty; give a file")
    return Path(text)


def _output(text: str) -> str | None:
    """The file to write, None for standard output."""
    if not text:
        raise InputError("the name is empty; give a file, or - for standard output")
    return None if text == "-" else text


class IntegerRange(click.IntRange):
    """Integers from one to another; what is none is told as such, not as "no valid integer range"."""

    name = "integer"


FILE = _Parsed("file", named_file)
OUTPUT = _Parsed("file", _output)
NUMBER = _Parsed("number", parse_number, takes_name=True)
IDENTITY = _Parsed("identity", _identity)
OBJECT = _Parsed("index[:subindex]", parse_object)
BOUNDS = _Parsed("amount", parse_bounds, takes_name=True)
MODES = _Parsed("modes", parse_modes)
_PLUGGED = _Parsed("slot=ident[/type]", parse_plugged)


def module_option(help_text: str) -> Callable[[Function], Function]:
    """The option ``--module``, once for each slot."""
    return click.option(
        "--module", "modules", metavar="SLOT=IDENT[/TYPE]", multiple=True, type=_PLUGGED, help=help_text
    )


def read_bytes(path: Path) -> bytes:
    """The bytes of a file, of standard input for ``-``. Raises :class:`InputError`."""
    from esicatalog.esi.containers import MAX_DOCUMENT_BYTES

    try:
        if str(path) == "-":
            content = sys.stdin.buffer.read(MAX_DOCUMENT_BYTES + 1)
        else:
            with path.open("rb") as stream:  # a pipe too: <(ethercat slaves -v)
                content = stream.read(MAX_DOCUMENT_BYTES + 1)
    except (OSError, ValueError) as error:
        raise InputError(f"{path}: {getattr(error, 'strerror', None) or error}") from error
    if len(content) > MAX_DOCUMENT_BYTES:
        raise InputError(f"{path}: larger than {MAX_DOCUMENT_BYTES // 2**20} MB; give what a master or a device wrote")
    return content


def read_as(path: Path, read: Callable[[bytes], Result]) -> Result:
    """What a reader makes of a file, of standard input for ``-``. Raises :class:`InputError` that names the file."""
    content = read_bytes(path)
    try:
        return read(content)
    except (DocumentError, InputError) as error:
        named = "standard input" if str(path) == "-" else path
        raise InputError(f"{named}: {error}") from error


def read_text_as(path: Path, read: Callable[[str], Result]) -> Result:
    """What a reader makes of the text in a file, as masters and shells write it; like :func:`read_as`."""
    from esicatalog.scan.text import decode_text

    return read_as(path, lambda content: read(decode_text(content)))


def print_json(value: Any) -> None:
    """JSON alone on stdout, UTF-8."""
    sys.stdout.buffer.write(json_bytes(value))
    sys.stdout.buffer.flush()


def print_rows(rows: Sequence[Mapping[str, Any]], columns: Sequence[str], output_format: str) -> None:
    """Rows as JSON (whole) or CSV (the named columns)."""
    if output_format == "json":
        print_json(rows)
        return
    writer = csv.writer(sys.stdout, lineterminator="\n")
    writer.writerow(columns)
    writer.writerows([_cell(row[column]) for column in columns] for row in rows)


def print_table(rows: Sequence[Sequence[str]], head: Sequence[str]) -> None:
    """An aligned table with a head line; the last column is not padded."""
    for line in table_lines(rows, head):
        click.echo(line)


def table_lines(rows: Iterable[Sequence[str]], head: Sequence[str]) -> list[str]:
    """Lines of an aligned table."""
    cells = [list(head), *map(list, rows)]
    widths = [max(len(row[at]) for row in cells) for at in range(len(head))]
    widths[-1] = 0
    widths[:-1] = [min(width, _WIDEST_CELL) for width in widths[:-1]]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip() for row in cells]


def _cell(value: Any) -> str:
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, list | tuple):
        return "; ".join(map(str, value))
    return str(value)
