"""Rules that are checked while a document is read: markup, scalars, elements that nobody knows, missing documents."""

from collections.abc import Iterator

from esicatalog.esi.notes import REFUSED
from esicatalog.lint.registry import ERROR, WARNING, Found, found_by_reader, rule
from esicatalog.lint.subjects import InfoSubject

NO_ESI = "L02"
"""The rule for documents of which nothing can be checked, beside :data:`REFUSED`."""
SCHEMA_RULE = "L03"

found_by_reader(
    REFUSED,
    ERROR,
    "Not well-formed XML, or bytes that the declared encoding does not have.",
    "XML 1.0; a strict parser refuses the whole document",
)
found_by_reader(
    NO_ESI,
    ERROR,
    "The root element is none of ESI: EtherCATInfo, EtherCATInfoList, EtherCATModule, EtherCATDict, EtherCATDiag.",
    "ETG.2000; EtherCATConfig is an ENI file, the configuration of a master",
)
found_by_reader(
    SCHEMA_RULE,
    WARNING,
    "Violates the schema (all kinds with --schema; booleans and numbers always).",
    "ETG.2000 EtherCATInfo.xsd, EtherCATBase.xsd, EtherCATModule.xsd, EtherCATDict.xsd, EtherCATDiag.xsd",
)
found_by_reader(
    "L04",
    WARNING,
    "Child elements do not stand in the order of the schema.",
    "ETG.2000 schemas: xs:sequence; a strict parser refuses another order",
)
found_by_reader(
    "L05",
    WARNING,
    "Unknown or repeated element, attribute or text; its value is kept, but nothing reads it. What only holds others "
    "(Devices, Objects, Dc) is read as one with the first. Or elements of which the schema has one or the other.",
    "ETG.2000 schemas 1.14 to 1.17 and the later additions seen in real files",
)
found_by_reader(
    "L06",
    ERROR,
    "Malformed or out of range HexDecValue or integer; decimal is 402, hexadecimal #x1A00.",
    "ETG.2000 EtherCATBase.xsd HexDecValue, xs:int (32 bits); identities have 32 bits, indices and registers 16, "
    "ControlByte and subindices 8",
)
found_by_reader(
    "L07",
    ERROR,
    "hexBinary with an odd number of digits or with other characters.",
    "ETG.2000 EtherCATBase.xsd, xs:hexBinary",
)


@rule(
    "L60", WARNING, "ETG.2000 DictionaryFile, DiagFile, InfoReference, ImageFile16x14: paths relative to the document"
)
def missing_file(section: InfoSubject) -> Iterator[Found]:
    """A document or image that this one names is not found beside it."""
    if section.find_file is None:
        return
    for place, record in section.with_images():
        name = record.image_file
        if name and not section.find_file(name):
            advice = "or leave it out beside ImageData16x14" if record.image_data else "or give ImageData16x14"
            yield Found(
                f"ImageFile16x14 {name!r} was not found beside the document: ship it, {advice}",
                (*place, "image_file"),
            )
