"""What can be asked of a catalog, for comparisons of two of them."""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from esicatalog import Catalog
from esicatalog.catalog.device_filter import IDENTIFICATIONS, MODES, PROTOCOLS
from esicatalog.identity import Bounds, parse_identity

BOUNDS = (Bounds(0, 0), Bounds(1, None), Bounds(None, 16), Bounds(100_000, 1_000_000), Bounds(-100, None))
FILTERS: tuple[dict[str, Any], ...] = (
    {},
    {"all_variants": True},
    {"include_hidden": True},
    {"vendor_id": 0x1097},
    *({"vendor": part} for part in ("eyou", "BECK", "100%", "é")),
    {"product_code": 0x0D080808},
    *({"profile_no": number} for number in (402, 5001)),
    *({"modes": (mode,), "strict": strict} for mode in MODES for strict in (False, True)),
    {"modes": ("CSP", "CSV"), "include_hidden": True},
    *({"sync": signal} for signal in ("sync0", "sync1")),
    *({"protocol": name} for name in PROTOCOLS),
    *({name: True} for name in ("complete_access", "pdo_assign", "pdo_config", "bootstrap", "needs_dc", "no_lrw")),
    *({"identification": method} for method in IDENTIFICATIONS),
    *({"physics": ports} for ports in ("YY", "KK", "YY  ")),
    *({name: bounds} for name in ("bytes_in", "bytes_out", "min_cycle_ns", "e_bus_ma", "axes") for bounds in BOUNDS),
    {"maps": ((0x6040, 0),)},
    {"maps": ((0x60FF, None),), "bits": 32},
    {"maps": ((0x6040, None),), "not_maps": ((0x6840, None),)},
    {"objects": ((0x6502, None),)},
    {"objects": ((0x1C32, 5),), "include_hidden": True},
    {"limit": 3},
)
"""Every filter of ``devices`` but ``text`` and ``like``."""


def answers(
    target: str | Path, filters: Iterable[dict[str, Any]], texts: Sequence[str] = (), like: Sequence[str] = ()
) -> dict[str, Any]:
    """What ``devices`` says, as JSON, question by question."""
    asked = [*filters, *({"text": text} for text in texts), *({"like": parse_identity(item)} for item in like)]
    with Catalog.open(target) as catalog:
        return {repr(wanted): [found.as_json() for found in catalog.devices(**wanted)] for wanted in asked}
