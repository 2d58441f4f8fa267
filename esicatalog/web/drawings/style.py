"""The style sheet of all drawings; a page embeds it once."""

_PALETTES = {
    "light": {
        "background": "#ffffff",
        "text": "#1c2126",
        "muted": "#57606a",
        "line": "#6e7781",
        "alarm": "#b91c26",
        "alarm-fill": "#ffb3ad",
        "0": "#cfe3fb",
        "1": "#fde3bd",
        "2": "#d0efd3",
        "3": "#e8daf8",
        "4": "#fbd4dc",
        "5": "#c6ecec",
        "6": "#f4efb2",
        "7": "#e1e0d9",
    },
    "dark": {
        "background": "#15191e",
        "text": "#f0f3f6",
        "muted": "#a9b3bd",
        "line": "#8b949e",
        "alarm": "#ff7b72",
        "alarm-fill": "#8c1d18",
        "0": "#1f4a7d",
        "1": "#70450f",
        "2": "#205c2c",
        "3": "#523883",
        "4": "#7d2d46",
        "5": "#135558",
        "6": "#57530f",
        "7": "#4a4a45",
    },
}
"""Colours by the reader's colour scheme; the numbered ones are those of PDOs, in turn."""

PDO_COLOURS = 8
"""Colour classes ``pdo-0`` to ``pdo-7``."""


def _properties(scheme: str) -> str:
    return "".join(f"--drawing-{name}:{colour};" for name, colour in _PALETTES[scheme].items())


_RULES = """
svg.drawing{display:block;width:100%;max-width:30rem;height:auto;background:var(--drawing-background);border-radius:4px}
svg.drawing text{font:11px system-ui,"Segoe UI",Roboto,Helvetica,Arial,sans-serif;fill:var(--drawing-text);\
pointer-events:none}
svg.drawing .label{text-anchor:middle}
svg.drawing .axis{font-size:10px;fill:var(--drawing-muted)}
svg.drawing .offset{text-anchor:end}
svg.drawing .words{font-size:10px}
svg.drawing .alarm{fill:var(--drawing-alarm);font-weight:bold}
svg.drawing path,svg.drawing rect{fill:var(--drawing-fill,none);stroke:var(--drawing-line)}
svg.drawing .entry:hover path:not(.hatch),svg.drawing .sm:hover rect{stroke:var(--drawing-text);stroke-width:2}
svg.drawing .gap path,svg.drawing .left-out{fill:var(--drawing-background)}
svg.drawing .left-out,svg.drawing .not-enabled rect{stroke-dasharray:4 3}
svg.drawing .gap .hatch,svg.drawing .band{stroke:var(--drawing-line);stroke-dasharray:1 4;opacity:.6;\
pointer-events:none}
svg.drawing .no-size{stroke-dasharray:2 3}
svg.drawing .overlap rect{fill:var(--drawing-alarm-fill);stroke:var(--drawing-alarm);stroke-width:2}
svg.drawing .grid{stroke:var(--drawing-line);stroke-dasharray:2 3;opacity:.6}
svg.drawing .pulse{stroke:var(--drawing-text);stroke-width:2}
svg.drawing .shift{stroke:var(--drawing-text);stroke-width:1.5}
.drawing-legend{list-style:none;margin:.5em 0;padding:0;display:flex;flex-wrap:wrap;gap:.25em 1em;font-size:.85rem}
.drawing-legend li{overflow-wrap:anywhere}
.drawing-legend .swatch{display:inline-block;width:.9em;height:.9em;margin-right:.4em;vertical-align:-.1em;\
border:1px solid var(--drawing-line);background:var(--drawing-fill)}
"""

DRAWING_CSS = (
    f"svg.drawing,.drawing-legend{{{_properties('light')}}}\n"
    "@media (prefers-color-scheme:dark){svg.drawing,.drawing-legend{"
    + _properties("dark")
    + "}}\n"
    + "".join(f".pdo-{at}{{--drawing-fill:var(--drawing-{at})}}" for at in range(PDO_COLOURS))
    + _RULES
)
"""Colours, strokes and text sizes of all drawings and of the legend, for light and dark; embed it once in a page."""
