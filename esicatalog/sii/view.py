"""An SII image as JSON: every stored field, its meaning beside it, and string numbers with their texts."""

import inspect
from enum import IntFlag
from typing import Any

from esicatalog.sii.codes import CATEGORY_NAMES, flag_words
from esicatalog.sii.encode import category_offsets
from esicatalog.sii.findings import STRING_NUMBER
from esicatalog.sii.image import SiiImage
from esicatalog.sii.layout import SiiRecord


def sii_json(image: SiiImage) -> dict[str, Any]:
    """Plain values for JSON. Bytes are hex digits; flags come as number and as ``…_words``.

    ``name_string_number`` is followed by ``name``, the text, null when there is none. Categories say at which byte
    ``offset`` they start.
    """
    offsets = category_offsets(image)
    return {
        "header": _record(image.header, image),
        "categories": [
            {
                "offset": offset,
                "category_type": category.category_type,
                "category": CATEGORY_NAMES.get(category.category_type),
                **_record(category, image),
            }
            for offset, category in zip(offsets, image.categories, strict=False)
        ],
        "end_mark": image.end_mark,
        "trailing": image.trailing.hex(),
        "findings": list(image.findings),
    }


def _record(record: SiiRecord, image: SiiImage) -> dict[str, Any]:
    derived = [name for name, _ in inspect.getmembers(type(record), lambda member: isinstance(member, property))]
    found: dict[str, Any] = {}
    for name in (*record.__struct_fields__, *derived):
        value = getattr(record, name)
        found[name] = _plain(value, image)
        if isinstance(value, IntFlag):
            found[f"{name}_words"] = flag_words(value)
        if name.endswith(STRING_NUMBER):
            found[name.removesuffix(STRING_NUMBER)] = image.text(value)
    return found


def _plain(value: Any, image: SiiImage) -> Any:
    if isinstance(value, SiiRecord):
        return _record(value, image)
    if isinstance(value, tuple):
        return [_plain(item, image) for item in value]
    if isinstance(value, bytes):
        return value.hex()
    return int(value) if isinstance(value, IntFlag) else value
