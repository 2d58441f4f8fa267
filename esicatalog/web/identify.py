"""The route /-/esi/identify.json: one identity by GET, many or a scan by POST."""

import asyncio
import codecs
from typing import Any

import msgspec

from esicatalog.api import Catalog
from esicatalog.errors import InputError
from esicatalog.identity import Identity, checked_number, parse_identity, parse_number
from esicatalog.parameters import check_names, given_texts
from esicatalog.scan.records import ScanError
from esicatalog.scan.text import decode_text
from esicatalog.web.http import HttpError, body_of, texts_of
from esicatalog.web.uploads import MOST_IDENTITIES, read_uploaded_scan

_SHOWN = 60
_PARAMETERS = ("vendor", "product", "revision")
_NAMES = {"vendor": "vendor_id", "product": "product_code", "revision": "revision_no"}
"""Members of an identity in JSON; the short and the long name mean the same."""


async def identify_one(request: Any, catalog: Catalog) -> tuple[Any, int]:
    """``?vendor=&product=&revision=``; 404 with the answer when nothing of the product is known."""
    texts = {name: given[0] for name, given in given_texts(texts_of(request), _PARAMETERS).items()}
    missing = [name for name in _PARAMETERS[:2] if name not in texts]
    if missing:
        raise HttpError(400, f"{missing[0]} is missing; write vendor=0x1097&product=0x2406&revision=0x8f")
    numbers = {_NAMES[name]: parse_number(text, name) for name, text in texts.items()}
    answer = catalog.identify(**numbers)
    return answer.as_json(), 200 if answer.device is not None else 404


async def identify_many(request: Any, catalog: Catalog) -> tuple[Any, int]:
    """A JSON list of identities, or the text of a scan; the answers are a list in the same order."""
    check_names(request.args, ())
    body = await body_of(request)
    return await asyncio.to_thread(_answers, body.removeprefix(codecs.BOM_UTF8), catalog), 200


def _answers(body: bytes, catalog: Catalog) -> list[dict[str, Any]]:
    """Lines of a log begin with a bracket too: what is no JSON may be a scan."""
    if body.lstrip()[:1] not in (b"[", b"{"):
        return _scan(body, catalog)
    try:
        given = msgspec.json.decode(body)
    except (msgspec.DecodeError, RecursionError) as error:
        try:
            return _scan(body, catalog)
        except ScanError:
            raise HttpError(400, f"the body is no JSON: {error}") from error
    return _identities(given, catalog)


def _scan(body: bytes, catalog: Catalog) -> list[dict[str, Any]]:
    scan = read_uploaded_scan(decode_text(body))
    return [slave.as_json() for bus in catalog.identify_scan(scan) for slave in bus.slaves]


def _identities(given: Any, catalog: Catalog) -> list[dict[str, Any]]:
    if not isinstance(given, list):
        raise HttpError(400, "the body is no list of identities")
    if len(given) > MOST_IDENTITIES:
        raise HttpError(400, f"more than {MOST_IDENTITIES} identities at once")
    wanted = [_identity(item, place) for place, item in enumerate(given)]
    return [catalog.identify(item.vendor_id, item.product_code, item.revision_no).as_json() for item in wanted]


def _identity(item: Any, place: int) -> Identity:
    """An identity as an object, as a list of three, or as ``V:P:R``."""
    try:
        if isinstance(item, str):
            identity = parse_identity(item)
            if identity.variant is not None:
                raise InputError(f"{item[:_SHOWN]!r} names a variant; leave it out, the answer holds all of them")
            if identity.without_revision:
                raise InputError(
                    f"{item[:_SHOWN]!r} asks for a description without revision; see /-/esi/device/V/P/-.json"
                )
            return identity
        if isinstance(item, list) and len(item) in (2, 3):
            item = dict(zip(_PARAMETERS, item, strict=False))
        if not isinstance(item, dict):
            raise InputError("expected an object, a list [vendor, product, revision] or a text V:P:R")
        if not item.keys() & {"revision", _NAMES["revision"]}:  # Another member may be meant as the revision.
            check_names(item, (*_NAMES, *_NAMES.values()), "member")
        repeated = [short for short, name in _NAMES.items() if short in item and name in item]
        if repeated:
            raise InputError(f"{repeated[0]} is given more than once")
        numbers = {name: _number(item.get(short, item.get(name)), short) for short, name in _NAMES.items()}
    except InputError as error:
        raise HttpError(400, f"identity {place}: {error}") from error
    vendor_id, product_code = numbers["vendor_id"], numbers["product_code"]
    if vendor_id is None or product_code is None:
        raise HttpError(400, f"identity {place}: vendor and product are needed")
    return Identity(vendor_id, product_code, numbers["revision_no"])


def _number(value: Any, name: str) -> int | None:
    if value is None or value == "":
        return None
    if isinstance(value, str):
        return parse_number(value, name)
    # JSON has one kind of numbers: 4247.0 is 4247.
    return checked_number(int(value) if isinstance(value, float) and value.is_integer() else value, name)
