"""esicatalog diff"""

import sys
from collections.abc import Iterator, Sequence
from itertools import groupby
from pathlib import Path
from typing import Any, NamedTuple

import click
import msgspec

from esicatalog.catalog.results import identity_json
from esicatalog.cli.common import (
    EXIT_NO,
    FILE,
    IDENTITY,
    Command,
    catalog_to_ask,
    db_option,
    format_option,
    print_json,
    reporting_errors,
)
from esicatalog.errors import InputError
from esicatalog.esi.notes import REFUSED
from esicatalog.esi.reader import read_esi
from esicatalog.esi.records.common import display_text
from esicatalog.identity import Identity, identity_text
from esicatalog.ingest.this_process import limited
from esicatalog.model.compare import compare_devices, images_are_known, summary_words
from esicatalog.model.compare_device import revision_verdict
from esicatalog.model.compare_documents import DescribedDevice, described_devices, paired_devices
from esicatalog.model.compare_facts import ADDED, CHANGED, REMOVED, Difference, excerpts
from esicatalog.words import counted, one_line

_TOLD = (REFUSED, "L60")
"""Findings that bear on a comparison: the document had to be repaired, or a part of it was not found."""
_WIDEST_PLACE, _WIDEST_VALUE = 44, 76
_WORDS = {ADDED: "only right: {right}", REMOVED: "only left: {left}", CHANGED: "{left} -> {right}"}
_SCREEN_LINES = 40
"""From more lines on the summary stands before them too: nobody sees both ends."""
_LEGEND = "! counts: a master's configuration made for the left device may not fit the right one"


class _Side(NamedTuple):
    """One of two devices, with where its description comes from."""

    described: DescribedDevice
    variant: int
    source: str


class _Pair(NamedTuple):
    """Two devices and what is different between them."""

    left: _Side
    right: _Side
    differences: list[Difference]

    @property
    def counting(self) -> int:
        """How many differences count."""
        return sum(item.counts for item in self.differences)


class _Comparison(NamedTuple):
    """All pairs, and the devices that only one file has."""

    pairs: list[_Pair]
    only_left: list[_Side]
    only_right: list[_Side]


@click.command("diff", cls=Command)
@click.argument("identities", metavar="[IDENTITY IDENTITY]", nargs=-1, type=IDENTITY)
@click.option(
    "--esi",
    "files",
    metavar="A B",
    nargs=2,
    type=FILE,
    help="Compare the devices of two ESI files; no catalog is opened.",
)
@db_option
@format_option("table", "json")
@reporting_errors
def command(identities: tuple[Identity, ...], files: tuple[Path, Path] | None, db: str, output_format: str) -> None:
    """Say what is different between two devices, revisions or ESI files, and whether a configuration can stay.

    IDENTITY is VENDOR:PRODUCT[:REVISION][@VARIANT]; without REVISION the latest. A difference counts when a master's
    configuration that was made for the first device may not fit the second. Exit code 1 when one counts, or when the
    second file lacks a device of the first.
    """
    ways = "IDENTITY IDENTITY, or --esi A B"
    if identities and files:
        raise InputError(f"give only one of {ways}")
    if not files and len(identities) != 2:
        raise InputError(f"say what to compare: {ways}")
    comparison = _of_files(*files) if files else _of_catalog(identities, db)
    if output_format == "json":
        print_json(_as_json(comparison))
    else:
        lines = list(_lines(comparison))
        for line in [lines[-1], "", *lines] if len(lines) > _SCREEN_LINES else lines:
            click.echo(line)
    if comparison.only_left or any(pair.counting for pair in comparison.pairs):
        sys.exit(EXIT_NO)


def _of_catalog(identities: Sequence[Identity], db: str) -> _Comparison:
    with catalog_to_ask(db) as catalog:
        found = [catalog.device(identity) for identity in identities]
    for words in dict.fromkeys(words for item in found for words in item.warnings):
        click.echo(words, err=True)
    left, right = (
        _Side(
            DescribedDevice(item.found.vendor_id, item.found.vendor, item.device, item.modules, 0),
            item.found.variant,
            "; ".join(f"{source.member}, line {source.line}" for source in item.sources),
        )
        for item in found
    )
    return _Comparison([_compared(left, right)], [], [])


def _of_files(left: Path, right: Path) -> _Comparison:
    def side(path: Path, item: DescribedDevice) -> _Side:
        return _Side(item, 1, f"{path}, line {item.line}")

    comparison = _Comparison([], [], [])
    for ours, theirs in paired_devices(_devices(left), _devices(right)):
        if ours is not None and theirs is not None:
            comparison.pairs.append(_compared(side(left, ours), side(right, theirs)))
        elif ours is not None:
            comparison.only_left.append(side(left, ours))
        elif theirs is not None:
            comparison.only_right.append(side(right, theirs))
    return comparison


def _devices(path: Path) -> list[DescribedDevice]:
    with limited():
        read = read_esi(path)
    for finding in read.findings:
        if finding.rule in _TOLD:
            click.echo(f"{path}, line {finding.line}: {finding.message}", err=True)
    found = described_devices(read.document)
    if not found:
        raise InputError(f"{path}: describes no device")
    return found


def _compared(left: _Side, right: _Side) -> _Pair:
    return _Pair(left, right, compare_devices(left.described, right.described))


def _lines(comparison: _Comparison) -> Iterator[str]:
    different = [pair for pair in comparison.pairs if pair.differences]
    for pair in different if len(comparison.pairs) > 1 else comparison.pairs:
        yield from _pair_lines(pair)
        yield ""
    for words, sides in (("left", comparison.only_left), ("right", comparison.only_right)):
        if sides:
            yield f"Only in the {words} file"
            yield from (f"    {_title(side)}" for side in sides)
            yield ""
    if any(pair.counting for pair in different):
        yield _LEGEND
    yield _summary(comparison)


def _pair_lines(pair: _Pair) -> Iterator[str]:
    yield f"left   {_title(pair.left)}"
    yield f"right  {_title(pair.right)}"
    verdict = revision_verdict(pair.left.described.device, pair.right.described.device)
    if verdict is not None:
        yield f"       {verdict}"
    for (module, area), group in groupby(pair.differences, key=lambda item: (item.module, item.area)):
        items = list(group)
        yield ""
        yield f"{module}: {area}" if module else area[:1].upper() + area[1:]
        width = min(max(len(item.place) for item in items), _WIDEST_PLACE)
        for item in items:
            left, right = excerpts(item.left, item.right, _WIDEST_VALUE)
            shown = _WORDS[item.kind].format(left=left, right=right)
            yield f"  {'!' if item.counts else ' '} {item.place.ljust(width)}  {shown}"


def _summary(comparison: _Comparison) -> str:
    different = [pair for pair in comparison.pairs if pair.differences]
    differences = [item for pair in different for item in pair.differences]
    words = summary_words(
        differences, all(images_are_known(pair.left.described, pair.right.described) for pair in different)
    )
    if len(comparison.pairs) == 1 and not comparison.only_left and not comparison.only_right:
        return words
    same = sum(not pair.differences for pair in comparison.pairs)
    parts = [
        f"{counted(len(comparison.pairs), 'device')} compared, {same} without difference",
        *([f"{len(comparison.only_left)} only in the left file"] if comparison.only_left else []),
        *([f"{len(comparison.only_right)} only in the right file"] if comparison.only_right else []),
    ]
    return ", ".join(parts) + (f": {words}" if comparison.pairs else "")


def _title(side: _Side) -> str:
    device = side.described.device
    words = dict.fromkeys(filter(None, (device.type, one_line(display_text(device.names) or ""))))
    return f"{_identity(side)}  {', '.join(words)}  ({side.source})"


def _identity(side: _Side) -> str:
    device = side.described.device
    return identity_text(side.described.vendor_id, device.product_code, device.revision_no, side.variant)


def _as_json(comparison: _Comparison) -> dict[str, Any]:
    return {
        "pairs": [
            {
                "left": _side_json(pair.left),
                "right": _side_json(pair.right),
                "revision_check": revision_verdict(pair.left.described.device, pair.right.described.device),
                "counting": pair.counting,
                "differences": msgspec.to_builtins(pair.differences),
            }
            for pair in comparison.pairs
        ],
        "only_left": _sides_json(comparison.only_left),
        "only_right": _sides_json(comparison.only_right),
        "summary": _summary(comparison),
    }


def _sides_json(sides: Sequence[_Side]) -> list[dict[str, Any]]:
    return [_side_json(side) for side in sides]


def _side_json(side: _Side) -> dict[str, Any]:
    device = side.described.device
    return {
        **identity_json(side.described.vendor_id, device.product_code, device.revision_no),
        "variant": side.variant,
        "vendor": side.described.vendor,
        "type": device.type,
        "name": display_text(device.names),
        "source": side.source,
    }
