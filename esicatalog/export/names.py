"""Identifiers for entries: the profile's names where it has them, else the vendor's, as C and Python accept them."""

import re
import unicodedata
from collections import Counter
from collections.abc import Iterable, Sequence

from esicatalog.errors import InputError

_MAX_LENGTH = 48
_RESERVED = (
    # C11, C23 and gcc's gnu modes
    "auto break case char const continue default do double else enum extern float for goto if inline int long "
    "register restrict return short signed sizeof static struct switch typedef typeof typeof_unqual union unsigned "
    "void volatile while "
    # C++
    "alignas alignof and and_eq asm bitand bitor bool catch char8_t char16_t char32_t class compl concept "
    "const_cast consteval constexpr constinit co_await co_return co_yield decltype delete dynamic_cast explicit "
    "export false friend mutable namespace new noexcept not not_eq nullptr operator or or_eq private protected "
    "public reinterpret_cast requires static_assert static_cast template this thread_local throw true try typeid "
    "typename using virtual wchar_t xor xor_eq "
    # Python
    "as assert async await def del elif except finally from global import in is lambda none nonlocal pass raise with "
    "yield "
    # types that generated structures use: in C++ no member may be called so
    "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t "
    # macros of C libraries and of gcc's gnu modes
    "errno linux unix i386 stdin stdout stderr major minor"
)
_RESERVED_WORDS = frozenset(_RESERVED.split())
_NOT_IN_NAMES = re.compile(r"[^a-z0-9]+")
_CAMEL = re.compile(r"(?<=[a-z0-9])(?=[A-Z][a-z])")
_TRANSLITERATED = str.maketrans(
    {"ß": "ss", "ä": "ae", "ö": "oe", "ü": "ue", "Ä": "Ae", "Ö": "Oe", "Ü": "Ue", "µ": "u", "Ω": "ohm", "°": "deg"}
)
_PREFIX = re.compile(r"[A-Za-z][A-Za-z0-9]*(_[A-Za-z0-9]+)*")


def identifier(text: str | None, fallback: str) -> str:
    """A lower-case identifier made of a vendor's text; ``fallback`` where nothing usable is left of it."""
    plain = unicodedata.normalize("NFKD", (text or "").translate(_TRANSLITERATED)).encode("ascii", "ignore").decode()
    words = _NOT_IN_NAMES.sub("_", _CAMEL.sub("_", plain).lower()).strip("_")
    shortened = words if len(words) <= _MAX_LENGTH else words[:_MAX_LENGTH].rpartition("_")[0] or words[:_MAX_LENGTH]
    if not shortened:
        return fallback
    if shortened[0].isdigit():
        shortened = f"n{shortened}"
    return f"{shortened}_" if shortened in _RESERVED_WORDS else shortened


def checked_prefix(name: str) -> str:
    """A prefix of the user's own, in lower case. Raises :class:`InputError` when no identifier can begin so."""
    prefix = name.lower()
    refusals = {
        "use letters, digits and single _ between them, a letter first": _PREFIX.fullmatch(name) is None,
        f"it is longer than {_MAX_LENGTH} characters": len(name) > _MAX_LENGTH,
        "it is a word or macro of C, C++ or Python": prefix in _RESERVED_WORDS,
    }
    reason = next((words for words, is_so in refusals.items() if is_so), None)
    if reason is not None:
        raise InputError(f"{name!r} cannot begin names: {reason}")
    return prefix


def unique_names(candidates: Sequence[Sequence[str]], taken: Iterable[str] = ()) -> list[str]:
    """One name for each item out of its candidates, from plain to precise.

    All items that share a plain name take a more precise one, so that names do not depend on order; what is still
    equal is numbered from 1.
    """
    chosen = [0] * len(candidates)
    used = set(taken)
    while True:
        names = [options[level] for options, level in zip(candidates, chosen, strict=True)]
        counts = Counter(names)
        clashing = [
            at
            for at, name in enumerate(names)
            if (counts[name] > 1 or name in used) and chosen[at] + 1 < len(candidates[at])
        ]
        if not clashing:
            return _numbered(names, used)
        for at in clashing:
            chosen[at] += 1


def _numbered(names: list[str], used: set[str]) -> list[str]:
    counts = Counter(names)
    single = {name for name in names if counts[name] == 1 and name not in used} | used
    numbers: Counter[str] = Counter()
    result = []
    for name in names:
        if counts[name] == 1 and name not in used:
            result.append(name)
            continue
        numbered = name
        while numbered in single or numbered == name:
            numbers[name] += 1
            numbered = f"{name}_{numbers[name]}"
        single.add(numbered)
        result.append(numbered)
    return result
