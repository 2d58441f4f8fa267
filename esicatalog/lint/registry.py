"""The registry of rules: every rule documents itself (``esicatalog lint --list``, the help texts of SARIF).

A rule is a function of one subject that gives what it found; its docstring says what is wrong, the annotation of its
argument says what it looks at (a union: several kinds of subjects). Rules that the reader checks while it reads have
no function: their findings are the reader's.
"""

import types
import typing
from collections.abc import Callable, Iterable, Sequence
from typing import Any, NamedTuple, TypeVar, get_args, get_origin, get_type_hints

from esicatalog.errors import InputError
from esicatalog.words import one_line

ERROR, WARNING, INFORMATION = "E", "W", "I"
SEVERITY_WORDS = {ERROR: "error", WARNING: "warning", INFORMATION: "info"}

_SHOWN = 3

Place = tuple[str | int, ...]
"""Where in a record: field names, each with the position behind it where the field is a list: ``("rx_pdos", 2)``."""


class Found(NamedTuple):
    """What a rule found: one line that says what is wrong and what to do, and the place below the rule's subject."""

    message: str
    place: Place = ()
    severity: str | None = None
    """Where it differs from the rule's own."""


Check = Callable[[Any], Iterable[Found]]


class Rule(NamedTuple):
    """A rule; ``check`` is None where the reader finds it."""

    id: str
    severity: str
    title: str
    reference: str
    subjects: tuple[Any, ...]
    check: Check | None


def listed(items: Sequence[str]) -> str:
    """The first items in words, with the number of the others."""
    shown = ", ".join(items[:_SHOWN])
    return f"{shown} and {len(items) - _SHOWN} more" if len(items) > _SHOWN else shown


Function = TypeVar("Function", bound=Callable[[Any], Iterable[Found]])

RULES: dict[str, Rule] = {}
"""All rules by id; complete once :mod:`esicatalog.lint.rules` is imported."""


def rule(rule_id: str, severity: str, reference: str) -> Callable[[Function], Function]:
    """Register a function as a rule: subject in, :class:`Found` out."""

    def register(check: Function) -> Function:
        subject, *_ = get_type_hints(check).values()
        subjects = get_args(subject) if get_origin(subject) in (types.UnionType, typing.Union) else (subject,)
        _add(Rule(rule_id, severity, one_line(check.__doc__ or ""), reference, subjects, check))
        return check

    return register


def found_by_reader(rule_id: str, severity: str, title: str, reference: str) -> None:
    """Register a rule whose findings come from reading the document."""
    _add(Rule(rule_id, severity, title, reference, (), None))


def _add(new: Rule) -> None:
    if new.id in RULES:
        raise ValueError(f"rule {new.id} is registered twice")
    RULES[new.id] = new


def chosen_rules(rules: Iterable[Rule], select: Iterable[str], ignore: Iterable[str]) -> list[Rule]:
    """The rules named by ``select`` (all when empty) without those named by ``ignore``, in the order of their ids.

    Raises :class:`InputError` for an id that no rule has.
    """
    known = {item.id: item for item in rules}
    wanted, unwanted = ({_known_id(name, known) for name in names} for names in (select, ignore))
    return [known[name] for name in sorted((wanted or known.keys()) - unwanted)]


def _known_id(name: str, known: dict[str, Rule]) -> str:
    rule_id = name.strip().upper()
    if rule_id not in known:
        raise InputError(f"no lint rule {name.strip()!r}; lint --list prints all rules")
    return rule_id
