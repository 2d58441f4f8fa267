"""Fixed layouts of SII records: one declaration per field serves the decoder and the encoder.

A field of a record is declared as ``Annotated[type, Part(code, doc)]``. The parts of a record lie behind each other
in declaration order, little endian, without gaps (ETG.1000.6, SII coding).
"""

import struct
import typing
from enum import IntFlag
from typing import Annotated, Any, Generic, TypeVar, get_args, get_origin, get_type_hints

import msgspec

from esicatalog.sii.errors import SiiEncodeError
from esicatalog.words import counted


@typing.dataclass_transform(frozen_default=True, kw_only_default=True)
class _RecordMeta(msgspec.StructMeta):
    """Tells type checkers that subclasses inherit the configuration of SiiRecord."""


class SiiRecord(msgspec.Struct, metaclass=_RecordMeta, frozen=True, gc=False, kw_only=True):
    """Base of all SII records: immutable, comparable; what is not given is zero or empty."""


class Part(msgspec.Struct, frozen=True):
    """How a field is stored: a code of the ``struct`` module (``B``, ``H``, ``12s``), and what it means."""

    code: str
    doc: str


R = TypeVar("R", bound=SiiRecord)


class Layout(Generic[R]):
    """The stored form of a record type. A field that holds records is stored as their number (one byte)."""

    def __init__(self, record_type: type[R]) -> None:
        self._record_type = record_type
        self._codes: dict[str, str] = {}
        self._docs: dict[str, str] = {}
        self._flags: dict[str, type[IntFlag]] = {}
        for name, hint in get_type_hints(record_type, include_extras=True).items():
            if get_origin(hint) is not Annotated:
                continue
            declared, part = get_args(hint)
            self._codes[name] = "<" + part.code
            self._docs[name] = part.doc.partition(";")[0]
            if isinstance(declared, type) and issubclass(declared, IntFlag):
                self._flags[name] = declared
        self._struct = struct.Struct("<" + "".join(code[1:] for code in self._codes.values()))
        self.size = self._struct.size
        """Bytes that a record takes."""

    def values(self, data: bytes, offset: int = 0) -> dict[str, Any]:
        """The stored values by field name; ``data`` must hold ``size`` bytes from ``offset``."""
        found = dict(zip(self._codes, self._struct.unpack_from(data, offset), strict=True))
        for name, flag in self._flags.items():
            found[name] = flag(found[name])
        return found

    def read(self, data: bytes, offset: int = 0) -> R:
        """The record stored at ``offset``."""
        return self._record_type(**self.values(data, offset))

    def read_all(self, data: bytes) -> tuple[tuple[R, ...], bytes]:
        """The records that fill ``data``, and the bytes after the last whole one."""
        end = len(data) - len(data) % self.size
        return tuple(self.read(data, offset) for offset in range(0, end, self.size)), data[end:]

    def write(self, record: R) -> bytes:
        """The stored form. Raises :class:`SiiEncodeError` naming the field whose value does not fit."""
        return b"".join(self._pack(name, code, getattr(record, name)) for name, code in self._codes.items())

    def _pack(self, name: str, code: str, value: Any) -> bytes:
        stored = len(value) if isinstance(value, tuple) else value
        record, size = self._record_type.__name__, struct.calcsize(code)
        if isinstance(stored, bytes) and len(stored) != size:
            raise SiiEncodeError(f"{record}: {name} does not fit: {counted(size, 'byte')} needed, {len(stored)} given")
        try:
            return struct.pack(code, stored)
        except struct.error as error:
            raise SiiEncodeError(
                f"{record}: {name} {stored} does not fit into {8 * size} bits ({self._docs[name]})"
            ) from error
