"""Elements of ESI documents as text: objects, data types, PDOs and OpModes of made-up devices."""

from typing import NamedTuple

_BITS = {"BOOL": 1, "SINT": 8, "USINT": 8, "INT": 16, "UINT": 16, "DINT": 32, "UDINT": 32, "STRING(8)": 64}
SIMPLE_TYPES = "".join(
    f"<DataType><Name>{name}</Name><BitSize>{bits}</BitSize></DataType>\n" for name, bits in _BITS.items()
)


class Mapped(NamedTuple):
    """An entry of a PDO."""

    index: int
    subindex: int
    data_type: str
    name: str


class Record(NamedTuple):
    """An object with members (name, type, default) after subindex 0."""

    index: int
    name: str
    members: tuple[tuple[str, str, int], ...]


def _data(data_type: str, value: int) -> str:
    size = max(1, _BITS[data_type] // 8)
    return (value % (1 << 8 * size)).to_bytes(size, "little").hex().upper()


def object_element(
    index: int, name: str, data_type: str, value: int | str, access: str = "ro", mapping: str = ""
) -> str:
    """An object without subindices."""
    default = (
        f"<DefaultString>{value}</DefaultString>"
        if isinstance(value, str)
        else f"<DefaultData>{_data(data_type, value)}</DefaultData>"
    )
    mapped = f"<PdoMapping>{mapping}</PdoMapping>" if mapping else ""
    return (
        f"<Object>\n<Index>#x{index:04X}</Index>\n<Name>{name}</Name>\n<Type>{data_type}</Type>\n"
        f"<BitSize>{_BITS[data_type]}</BitSize>\n<Info>{default}</Info>\n"
        f"<Flags><Access>{access}</Access>{mapped}</Flags>\n</Object>\n"
    )


def _record_size(record: Record) -> int:
    return 16 + sum(_BITS[data_type] for _, data_type, _ in record.members)


def record_type(record: Record) -> str:
    """The data type of an object with members."""
    items = [_sub_item(0, "SubIndex 000", "USINT", 0)]
    offset = 16
    for number, (name, data_type, _) in enumerate(record.members, 1):
        items.append(_sub_item(number, name, data_type, offset))
        offset += _BITS[data_type]
    name = f"DT{record.index:04X}"
    return f"<DataType>\n<Name>{name}</Name>\n<BitSize>{offset}</BitSize>\n{''.join(items)}</DataType>\n"


def _sub_item(number: int, name: str, data_type: str, offset: int) -> str:
    return (
        f"<SubItem>\n<SubIdx>{number}</SubIdx>\n<Name>{name}</Name>\n<Type>{data_type}</Type>\n"
        f"<BitSize>{_BITS[data_type]}</BitSize>\n<BitOffs>{offset}</BitOffs>\n"
        "<Flags><Access>ro</Access></Flags>\n</SubItem>\n"
    )


def record_object(record: Record) -> str:
    """An object with members."""
    members = (("SubIndex 000", "USINT", len(record.members)), *record.members)
    items = "".join(
        f"<SubItem><Name>{name}</Name><Info><DefaultData>{_data(data_type, value)}</DefaultData></Info></SubItem>\n"
        for name, data_type, value in members
    )
    return (
        f"<Object>\n<Index>#x{record.index:04X}</Index>\n<Name>{record.name}</Name>\n<Type>DT{record.index:04X}</Type>\n"
        f"<BitSize>{_record_size(record)}</BitSize>\n<Info>\n{items}</Info>\n<Flags><Access>ro</Access></Flags>\n</Object>\n"
    )


def pdo_element(direction: str, index: int, sm: int, name: str, entries: tuple[Mapped, ...]) -> str:
    """A fixed PDO; ``direction`` is Rx or Tx."""
    rows = "".join(
        f"<Entry>\n<Index>#x{entry.index:04X}</Index>\n<SubIndex>{entry.subindex}</SubIndex>\n"
        f"<BitLen>{_BITS[entry.data_type]}</BitLen>\n<Name>{entry.name}</Name>\n"
        f"<DataType>{entry.data_type}</DataType>\n</Entry>\n"
        for entry in entries
    )
    tag = f"{direction}Pdo"
    return (
        f'<{tag} Fixed="1" Sm="{sm}">\n<Index>#x{index:04X}</Index>\n<Name LcId="1033">{name}</Name>\n{rows}</{tag}>\n'
    )


def op_mode(name: str, assign_activate: int, sync1: bool = False) -> str:
    """An OpMode of the distributed clocks."""
    second = '<CycleTimeSync1 Factor="-1">0</CycleTimeSync1><ShiftTimeSync1>0</ShiftTimeSync1>' if sync1 else ""
    return (
        f"<OpMode>\n<Name>{name}</Name>\n<AssignActivate>#x{assign_activate:03X}</AssignActivate>\n"
        f'<CycleTimeSync0 Factor="1">0</CycleTimeSync0><ShiftTimeSync0>0</ShiftTimeSync0>{second}\n</OpMode>\n'
    )
