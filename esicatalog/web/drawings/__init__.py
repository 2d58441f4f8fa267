"""Drawings for the pages of the web interface: pure functions from records to SVG text.

A page embeds ``DRAWING_CSS`` once; the drawings follow the reader's light or dark colour scheme.
"""

from esicatalog.web.drawings.dc_timing import dc_timing_svg
from esicatalog.web.drawings.memory_map import memory_map_svg
from esicatalog.web.drawings.process_image import process_image_legend, process_image_svg
from esicatalog.web.drawings.style import DRAWING_CSS

__all__ = ["DRAWING_CSS", "dc_timing_svg", "memory_map_svg", "process_image_legend", "process_image_svg"]
