"""Small ESI documents written for the tests."""

import sqlite3
from collections.abc import Iterator
from contextlib import closing
from pathlib import Path
from typing import Any

from esicatalog.esi.reader import ReadDocument, Reader


def esi(devices: str = "", modules: str = "", vendor: str = "<Id>#x00000E5C</Id><Name>Test vendor</Name>") -> str:
    """An EtherCATInfo document around Device and Module elements."""
    return (
        f"<EtherCATInfo><Vendor>{vendor}</Vendor><Descriptions>"
        "<Groups><Group><Type>G</Type><Name>Group</Name></Group></Groups>"
        f"<Devices>{devices}</Devices><Modules>{modules}</Modules></Descriptions></EtherCATInfo>"
    )


def faulty_vendor_texts(fault: str) -> str:
    """What goes into a Device and is looked for in VendorSpecific, each beside an element that only recovery reads."""

    def vendor_specific(said: str) -> str:
        return f"<VendorSpecific>{fault}<TwinCAT>{said}</TwinCAT></VendorSpecific>"

    alternative = '<AlternativeSmMapping><Name>A</Name><Sm No="0"><Pdo>#x1600</Pdo></Sm></AlternativeSmMapping>'
    modes = [
        f"<OpMode><Name>{name}</Name><AssignActivate>0</AssignActivate>{vendor_specific(said)}</OpMode>"
        for name, said in (("old", '<A IgnoreFromBuildNo="1"/>'), ("new", '<Oversampling MinCycleTime="5000"/>'))
    ]
    return f"<Info>{vendor_specific(alternative)}</Info><Dc>{''.join(modes)}</Dc>"


UNDECLARED_PREFIX, REPEATED_ATTRIBUTE = "<b:a c:d='1'/>", "<a b='1' b='2'/>"


def device(content: str = "", product: str = "#x1", revision: str = "#x1", type_text: str = "T1", name: str = "N"):
    """A Device element with an identity around further content."""
    codes = f'ProductCode="{product}" RevisionNo="{revision}"' if product else ""
    return (
        f'<Device Physics="YY"><Type {codes}>{type_text}</Type><Name>{name}</Name><GroupType>G</GroupType>'
        f"{content}</Device>"
    )


def dictionary(data_types: str, objects: str) -> str:
    """A Profile with a dictionary."""
    return (
        f"<Profile><ProfileNo>402</ProfileNo><Dictionary><DataTypes>{data_types}</DataTypes>"
        f"<Objects>{objects}</Objects></Dictionary></Profile>"
    )


def pdo(kind: str, index: str, *bits: int, attributes: str = "", extra: str = "") -> str:
    """A RxPdo or TxPdo whose entries have these lengths."""
    entries = "".join(
        f"<Entry><Index>#x7000</Index><SubIndex>{n}</SubIndex><BitLen>{length}</BitLen><Name>e{n}</Name></Entry>"
        for n, length in enumerate(bits, 1)
    )
    return f"<{kind} {attributes}><Index>{index}</Index><Name>{kind} {index}</Name>{extra}{entries}</{kind}>"


def mapping_objects(*mappings: tuple[int, str]) -> str:
    """A dictionary with PDO mappings of one entry: index of the object, and the default of its subindex 1 as bytes."""
    items = "".join(
        f"<SubItem><SubIdx>{n}</SubIdx><Name>SubIndex 00{n}</Name><Type>{kind}</Type><BitSize>{bits}</BitSize>"
        f"<BitOffs>{offset}</BitOffs></SubItem>"
        for n, (kind, bits, offset) in enumerate((("USINT", 8, 0), ("UDINT", 32, 16)))
    )
    objects = "".join(
        f"<Object><Index>#x{index:X}</Index><Name>Map</Name><Type>DTMAP</Type><BitSize>48</BitSize><Info>"
        f"<SubItem><Name>SubIndex 000</Name><Info><DefaultData>01</DefaultData></Info></SubItem>"
        f"<SubItem><Name>SubIndex 001</Name><Info><DefaultData>{data}</DefaultData></Info></SubItem></Info></Object>"
        for index, data in mappings
    )
    return dictionary(f"<DataType><Name>DTMAP</Name><BitSize>48</BitSize>{items}</DataType>", objects)


def read(text: str | bytes) -> ReadDocument:
    """Read a document without any container."""
    return Reader().read(text.encode() if isinstance(text, str) else text)


def only_device(text: str) -> Any:
    """The one device of a document."""
    (found,) = read(text).document.infos[0].devices
    return found


def write(folder: Path, files: dict[str, str | bytes]) -> Path:
    """Write files below a folder."""
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return folder


def rows(db: Path, sql: str, *values: Any) -> list[tuple[Any, ...]]:
    """Rows of a query on a catalog, by the standard library alone."""
    with closing(sqlite3.connect(db)) as connection:
        return connection.execute(sql, values).fetchall()


def one(db: Path, sql: str, *values: Any) -> Any:
    """The single value of a query."""
    ((value,),) = rows(db, sql, *values)
    return value


def elements(root: Any, *path: str) -> Iterator[Any]:
    """Elements at a path below ``root``, by plain iteration."""
    head, *rest = path
    for child in root.findall(head):
        if rest:
            yield from elements(child, *rest)
        else:
            yield child
