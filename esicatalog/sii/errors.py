"""What can go wrong between bytes and SII records."""

from esicatalog.errors import DocumentError, InputError


class SiiImageError(DocumentError):
    """The bytes are no SII image, or one that is cut; ``line`` is set when they are Intel HEX."""


class SiiEncodeError(InputError):
    """Records that no SII image can hold: a number too large, too many strings or entries, an odd length."""
