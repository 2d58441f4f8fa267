"""Parameters of a question by name: what nothing reads is refused, because a slip would change what is asked."""

from collections.abc import Collection, Iterable, Mapping, Sequence

from esicatalog.errors import InputError

_SHOWN = 40


def check_names(given: Iterable[str], known: Sequence[str], what: str = "parameter") -> None:
    """Raise :class:`InputError` for a name that nothing reads."""
    unknown = sorted(set(given) - set(known))
    if unknown:
        there_is = "there is only" if len(known) == 1 else "there are"
        raise InputError(f"unknown {what} {unknown[0][:_SHOWN]!r}; {there_is} {', '.join(known) or 'none'}")


def given_texts(
    texts: Mapping[str, Sequence[str]], known: Sequence[str], repeatable: Collection[str] = (), what: str = "parameter"
) -> dict[str, list[str]]:
    """The parameters that are given, by name; empty texts count as not given, because forms send every field.

    Raises :class:`InputError` for a name that nothing reads, and for a second text of what is not ``repeatable``.
    """
    check_names(texts, known, what)
    given = {name: present for name, values in texts.items() if (present := [text for text in values if text])}
    for name, values in given.items():
        if len(values) > 1 and name not in repeatable:
            raise InputError(f"{name} is given more than once")
    return given
