"""Texts of an SII image: bytes whose encoding nobody declares."""

from esicatalog.sii.errors import SiiEncodeError

MAX_STRING_BYTES = 255
_GUESSES = ("ascii", "utf-8", "cp1252")
_STORED_AS = ("cp1252", "utf-8")


def decode_text(data: bytes) -> tuple[str, str]:
    """Text and guessed encoding: UTF-8 when valid, else Windows-1252 as vendor tools write it, else Latin-1.

    Zero bytes at the end, which some tools count as part of a string, are left out of the text.
    """
    shown = data.rstrip(b"\0")
    for encoding in _GUESSES:
        try:
            return shown.decode(encoding), encoding
        except UnicodeDecodeError:
            continue
    return shown.decode("latin-1"), "latin-1"


def encode_text(text: str) -> bytes:
    """The bytes of ``text``: Windows-1252 when it has the letters, else UTF-8, so that it reads as the same text.

    Raises :class:`SiiEncodeError` when no encoding gives the text back or it takes more than 255 bytes.
    """
    for encoding in _STORED_AS:
        try:
            data = text.encode(encoding)
        except UnicodeEncodeError:
            continue
        if decode_text(data)[0] == text:
            break
    else:
        raise SiiEncodeError(f"the text {text[:40]!r} cannot be stored in a string table")
    if len(data) > MAX_STRING_BYTES:
        raise SiiEncodeError(f"the text {text[:40]!r}… takes {len(data)} bytes; a string holds {MAX_STRING_BYTES}")
    return data
