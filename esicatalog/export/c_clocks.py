"""Distributed clocks as C expressions, for headers in which the bus cycle is the macro CYCLE_NS."""

from typing import NamedTuple

from esicatalog.export.c_text import comment_text
from esicatalog.export.clocks import Condition, Notation
from esicatalog.export.configuration import Configuration
from esicatalog.export.headings import op_mode_words

_C = Notation("CYCLE_NS", either="||", divide="/", number="INT64_C({})")


class ClockCode(NamedTuple):
    """What the template ``c_clocks.h.j2`` defines."""

    words: str
    assign_activate: str
    sync0_cycle: str
    sync0_shift: str
    sync1_delay: str
    conditions: tuple[Condition, ...]
    """Of CYCLE_NS."""

    @property
    def needs_cycle(self) -> bool:
        """Whether a time depends on the bus cycle, or the bus cycle on a time."""
        return bool(self.conditions) or _C.cycle in self.sync0_cycle + self.sync1_delay


def clock_code(configuration: Configuration) -> ClockCode | None:
    """The clocks of a configuration; None without distributed clocks."""
    found = configuration.clocks
    if found is None:
        return None
    return ClockCode(
        comment_text(op_mode_words(configuration)),
        f"0x{found.assign_activate:04x}",
        found.sync0_cycle.expression(_C),
        f"({found.sync0_shift_ns})" if found.sync0_shift_ns < 0 else str(found.sync0_shift_ns),
        found.sync1_delay.expression(_C),
        tuple(found.conditions(_C, configuration.cycle_ns)),
    )
