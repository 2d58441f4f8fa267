"""The rules, one function each, one module a part of a device; importing the package registers all of them."""

from esicatalog.lint.registry import RULES, Rule
from esicatalog.lint.rules import (  # noqa: F401
    clocks,
    data_types,
    drives,
    identity,
    mailbox,
    mapping,
    pdos,
    reading,
    slots,
    sync_managers,
    texts,
    values,
)

ALL_RULES: tuple[Rule, ...] = tuple(RULES[rule_id] for rule_id in sorted(RULES))
