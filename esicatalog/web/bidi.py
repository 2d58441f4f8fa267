"""Right-to-left words of documents in sentences: without care they drag the numbers beside them along.

Unicode orders a line as a whole (UAX #9): a number behind a Hebrew word is shown before it, and what follows an
override that nobody ends is shown backwards. Where a name is an element of its own, ``<bdi>`` keeps it apart.
"""

import re

_CONTROLS = re.compile("[\u202a-\u202e\u2066-\u2069]")
_LETTER = "[\u0590-\u08ff\u200f\ufb1d-\ufdff\ufe70-\ufefc\U00010800-\U00010fff\U0001e800-\U0001efff]"
_WORDS = re.compile(f'{_LETTER}+(?:[ ."-]{{1,2}}{_LETTER}+)*')
_ISOLATE, _END_OF_ISOLATE = "\u2068", "\u2069"


def isolated(text: object) -> str:
    """A sentence in which right-to-left words move nothing but themselves, without the characters that order text.

    For what holds names of documents among words and numbers, also where there are no elements: tooltips, drawings,
    options.
    """
    return _WORDS.sub(rf"{_ISOLATE}\g<0>{_END_OF_ISOLATE}", _CONTROLS.sub("", str(text)))
