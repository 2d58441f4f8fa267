"""Opening documents: bytes in, an XML tree out, hardened and tolerant.

External entities are never loaded, DTDs never fetched. What a strict parser refuses is tried again, first with its XML
declaration in front and with the encoding that the bytes really have, then with the recovery of libxml2; the reasons
are reported, never hidden. A document beyond a limit that bounds time and memory is refused, not cut: those of libxml2
(256 elements deep, 10 MB of text or start tag, entities that expand the document five times) and those below.
"""

import codecs
import contextlib
import re
from collections.abc import Iterable, Iterator
from itertools import starmap
from typing import NamedTuple

from lxml import etree

from esicatalog.errors import BrokenDocument, NotAnEsiDocument
from esicatalog.esi.containers import MAX_DOCUMENT_BYTES, TOO_LARGE
from esicatalog.words import counted, one_line

ESI_ROOTS = ("EtherCATInfo", "EtherCATInfoList", "EtherCATModule", "EtherCATDict", "EtherCATDiag")
_OTHER_ROOTS = {"EtherCATConfig": "an ENI file (EtherCATConfig: master configuration), not ESI"}
MAX_ATTRIBUTES = 1_000
"""Of one element; the schema has 12 at most. Reading them takes time that grows with the square of their number."""
MAX_NAMESPACES = 100
"""Prefixes declared in one document; real ones declare two. Each is written with every part of the document."""
NAMESPACE_PREFIX = re.compile(rb"xmlns:([^\s=]+)")
"""Declares one, in ASCII."""
_BOMS = {
    codecs.BOM_UTF8: ("UTF-8", "utf8"),
    codecs.BOM_UTF32_LE: ("UTF-32LE", "utf-32 utf32 iso-10646-ucs-4 ucs-4"),
    codecs.BOM_UTF32_BE: ("UTF-32BE", "utf-32 utf32 iso-10646-ucs-4 ucs-4"),
    codecs.BOM_UTF16_LE: ("UTF-16LE", "utf-16 utf16 iso-10646-ucs-2 ucs-2 unicode"),
    codecs.BOM_UTF16_BE: ("UTF-16BE", "utf-16 utf16 iso-10646-ucs-2 ucs-2 unicode unicodefffe"),
}
"""What the bytes are that begin with a byte order mark, and the other names by which a document may declare that. The
longer ones come first: one begins as another does."""
_WIDE_BOMS = tuple(bom for bom in _BOMS if bom != codecs.BOM_UTF8)
_WIDE = frozenset(name for bom in _WIDE_BOMS for name in (_BOMS[bom][0].lower(), *_BOMS[bom][1].split()))
"""Names of encodings whose characters have 16 or 32 bits."""
_LONGEST_DECLARATION = 1_000
_LIMITS = {
    "amplification": "its entities and attribute defaults expand too far",
    "depth": "nests more than 256 elements",
    "Text node": "holds a text of more than 10 MB",
    "Buffer size": "holds a start tag of more than 10 MB",
}
"""What libxml2 says beyond a limit, in words that name the limit."""
_LONGEST_REASON = 200
_SHOWN = 60
_PARAMETER_ENTITY = re.compile(rb"<!ENTITY\s+%")
_HAS_TOO_MANY_ATTRIBUTES = etree.XPath(f"boolean(/descendant::*/@*[{MAX_ATTRIBUTES + 1}])")
_UNSAFE_ENCODINGS = ("UTF-7", "UTF7")
"""They spell the same text in many ways, so that no look at the bytes tells what it says."""
_DECLARED_ENCODING = re.compile(rb"""\s*<\?xml[^>]*?encoding\s*=\s*["']([\w.:-]+)["']""")
_CODE_PAGES = {
    label: code_page
    for code_page, labels in {
        "cp932": "shift_jis shift-jis sjis x-sjis ms_kanji windows-31j windows-932 ms932",
        "gb18030": "gb2312 gb_2312-80 euc-cn gbk x-gbk cp936 ms936 windows-936",
        "cp949": "euc-kr ks_c_5601-1987 ksc5601 ms949 uhc windows-949 x-windows-949",
        "cp950": "big5 big-5 ms950 windows-950 x-windows-950",
    }.items()
    for label in labels.split()
}
"""What documents hold that declare an East Asian encoding: Windows calls its code pages by the names of standards that
have fewer characters. GB 18030 has all of code page 936."""
_ROOT_STARTS = re.compile(rf"<(?:{'|'.join(ESI_ROOTS)})(?=[\s/>])".encode())
_LEADING_MARKUP = re.compile(rb"\s*<")
_LATE_DECLARATION = re.compile(rb"(\xef\xbb\xbf)?((?>\s+|<!--.*?-->)+)(<\?xml\s[^>]*?\?>)", re.DOTALL)
"""An XML declaration with blanks or comments before it, where XML 1.0 section 2.8 has nothing but a byte order mark."""
_MOST_DAMAGED_LINES = 20
"""That are told one by one; behind a tag that does not end, libxml2 stumbles over every end tag."""
_REPLACED = "; what is no character from here on is read as U+FFFD"


class Problem(NamedTuple):
    """Why a document cannot be read as it stands, and in which line."""

    line: int
    message: str


class ParsedDocument(NamedTuple):
    """The tree of a document, the encoding it was read with, and why it was not read as it stands."""

    root: etree._Element
    encoding: str
    problems: tuple[Problem, ...]
    """The one that stopped a strict parser comes first; one for each damaged line, of many not all."""
    is_whole: bool
    """Whether nothing of it may be lost: it is well-formed once its encoding is known, and has no entities."""

    @property
    def recovered(self) -> str | None:
        """The first problem and the lines of the others, None where there is none."""
        if not self.problems:
            return None
        first, *others = self.problems
        lines = ", ".join(str(line) for line in dict.fromkeys(problem.line for problem in others))
        return f"{first.message}; more in line {lines}" if others else first.message


def make_parser(recover: bool = False, encoding: str | None = None) -> etree.XMLParser:
    """A parser for untrusted XML: no entities, no DTD, no network, no huge trees."""
    return etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        remove_comments=True,
        remove_pis=True,
        remove_blank_text=True,
        collect_ids=False,
        recover=recover,
        encoding=encoding,
    )


def parse_document(content: bytes) -> ParsedDocument:
    """Parse an ESI document of any root kind.

    Raises :class:`NotAnEsiDocument` for other content (ENI, other XML, no XML) and :class:`BrokenDocument` when it
    looks like ESI but nothing can be read.
    """
    if len(content) > MAX_DOCUMENT_BYTES:
        raise BrokenDocument(TOO_LARGE)
    if not content.strip():
        raise BrokenDocument("the file is empty")
    if not _looks_like_xml(content):
        raise NotAnEsiDocument("no XML document")
    _check_namespaces(content)
    try:
        root = etree.fromstring(content, make_parser())
    except etree.XMLSyntaxError as error:
        return _recover(content, error)
    # Shift_JIS by the letter has a yen sign and an overline where ASCII has \ and ~; nobody who declares it means them.
    meant = _read_as(content, "cp932") if _code_page(content) == "cp932" else None
    return _known(content, meant if meant is not None else root)


def parse_as_it_is(content: bytes) -> ParsedDocument | None:
    """Parse an ESI document that needs no leniency; None for one that :func:`parse_document` has to look at."""
    _check_namespaces(content)
    try:
        root = etree.fromstring(content, make_parser())
    except etree.XMLSyntaxError:
        return None
    return _known(content, root) if root.tag in ESI_ROOTS else None


def _check_namespaces(content: bytes) -> None:
    text = _plain(content)
    if text.count(b"xmlns") > MAX_NAMESPACES and len(set(NAMESPACE_PREFIX.findall(text))) > MAX_NAMESPACES:
        raise BrokenDocument(f"more than {MAX_NAMESPACES} namespaces declared; no ESI document does")


def _check_doctype(content: bytes, root: etree._Element) -> None:
    """Refuse parameter entities: they could declare what nobody sees in the bytes."""
    if root.getroottree().docinfo.internalDTD is not None and _PARAMETER_ENTITY.search(_plain(content)) is not None:
        raise BrokenDocument("parameter entities declared; no ESI document does: remove its DOCTYPE")


def _plain(content: bytes) -> bytes:
    """ASCII as such, whether the bytes are UTF-8, UTF-16 or UTF-32."""
    return content.replace(b"\0", b"") if b"\0" in content else content


def _looks_like_xml(content: bytes) -> bool:
    head = content[:4096]
    if head.startswith(_WIDE_BOMS) or head[:4] in (b"<\0?\0", b"\0<\0?", b"<\0\0\0", b"\0\0\0<"):
        return True
    return _LEADING_MARKUP.match(head.removeprefix(codecs.BOM_UTF8)) is not None


def _recover(content: bytes, error: etree.XMLSyntaxError) -> ParsedDocument:
    line, reason = error.lineno or 0, _one_line(error.msg or str(error))
    _check_limits(error.code, reason, line)
    if b"<EtherCAT" not in content and not content.startswith(_WIDE_BOMS):
        raise NotAnEsiDocument(f"XML without an EtherCAT root, and not well-formed: {reason}", line)
    late = _LATE_DECLARATION.match(content)
    if late is not None:
        mark, before, declaration = late.groups(b"")
        parsed = parse_document(b"".join((mark, declaration, before, content[late.end() :])))
        told = Problem(line, f"{reason}; read as if it stood there")
        return parsed._replace(problems=_one_a_line([told, *parsed.problems]))
    label = (declared_encoding(content) or b"").decode()
    # Programs that write XML into a string of UTF-16 declare that, whatever the string is saved as.
    is_narrow = label in _WIDE
    if is_narrow:
        line, reason = 1, f"declared as {label}, but it begins with characters of 8 bits"
    if is_narrow or "encoding" in reason.lower() or "utf-8" in reason.lower():
        for encoding in ("utf-8", _code_page(content), "windows-1252"):
            root = _read_as(content, encoding) if encoding is not None else None
            if root is not None:
                return _known(content, root, [Problem(line, f"{reason}; read as {encoding}")])
    parser, rest = make_parser(recover=True, encoding="utf-8" if is_narrow else None), None
    with contextlib.suppress(etree.XMLSyntaxError):
        rest = etree.fromstring(content, parser)
    for entry in parser.error_log:
        _check_limits(entry.type, entry.message, entry.line)
    if rest is None:
        raise BrokenDocument(f"not well-formed and nothing could be recovered: {reason}", line)
    if not _is_text(rest):
        raise BrokenDocument("a character reference between &#xD800; and &#xDFFF; means no character: remove it", line)
    first = Problem(line, f"{reason}; read by recovery{_left_out(content, rest)}")
    try:
        found = _known(content, rest, _damages(first, parser.error_log))
    except NotAnEsiDocument as other:
        raise BrokenDocument(f"not well-formed: {reason}", line) from other
    return found._replace(is_whole=False)


def _damages(first: Problem, log: "etree._ListErrorLog") -> Iterator[Problem]:
    """What a strict parser stopped at and then what recovery stumbled over, one for each line: libxml2 follows up.

    Past an error of encoding it goes on with U+FFFD for what is no character.
    """
    messages = {first.line: first.message}
    for entry in log.filter_from_errors():
        messages.setdefault(entry.line, f"{_one_line(entry.message)}; read by recovery")
        if entry.type == etree.ErrorTypes.ERR_INVALID_ENCODING and _REPLACED not in messages[entry.line]:
            messages[entry.line] += _REPLACED
    yield Problem(first.line, messages.pop(first.line))
    further = sorted(messages.items())
    yield from starmap(Problem, further[:_MOST_DAMAGED_LINES])
    if len(further) > _MOST_DAMAGED_LINES:
        line, more = further[_MOST_DAMAGED_LINES][0], len(further) - _MOST_DAMAGED_LINES
        # libxml2 itself stops telling at some number.
        yield Problem(line, f"at least {counted(more, 'more damaged line')} from here on; read by recovery")


def _is_text(root: etree._Element) -> bool:
    """Whether all that recovery left can be read: libxml2 keeps half of a surrogate pair that a reference names."""
    try:
        for element in root.iter():
            _ = element.text, element.tail, element.items()
    except UnicodeDecodeError:
        return False
    return True


def _left_out(content: bytes, root: etree._Element) -> str:
    """Words about documents behind the one that was read, as they lie in a file that several were written to."""
    found = [start.start() for start in _ROOT_STARTS.finditer(content)]
    read = sum(1 for _ in root.iter(*ESI_ROOTS))
    if len(found) <= read:
        return ""
    line = content.count(b"\n", 0, found[read]) + 1
    return (
        f"; the document in line {line} and all behind it is left out: make a file of each, as for each slave, or put "
        "them into one EtherCATInfoList"
    )


def _code_page(content: bytes) -> str | None:
    """What the bytes are likely to be where a document declares an East Asian encoding."""
    declared = declared_encoding(content)
    return _CODE_PAGES.get(declared.decode()) if declared is not None else None


def declared_encoding(content: bytes) -> bytes | None:
    """The encoding that a document of an encoding based on ASCII declares, in small letters; None if it declares none.

    A byte order mark may not stand before it.
    """
    declared = _DECLARED_ENCODING.match(content)
    return declared[1].lower() if declared is not None else None


def _mislabelled(content: bytes) -> str | None:
    """Words about a document that declares another encoding than its byte order mark says; the parser reads by that.

    XML 1.0 section 4.3.3: such a declaration is a fatal error, and other parsers stop there.
    """
    bom = next(filter(content.startswith, _BOMS), None)
    if bom is None:
        return None
    declared = declared_encoding(_plain(content[len(bom) : _LONGEST_DECLARATION]))
    encoding, other_names = _BOMS[bom]
    if declared is None or declared.decode() in (encoding.lower(), *other_names.split()):
        return None
    return f"declared as {declared.decode()}, but its byte order mark says {encoding}; read as {encoding}"


def _read_as(content: bytes, encoding: str) -> etree._Element | None:
    with contextlib.suppress(etree.XMLSyntaxError):
        return etree.fromstring(content, make_parser(encoding=encoding))
    return None


def _check_limits(code: int, reason: str, line: int) -> None:
    """Refuse a document that libxml2 read to a limit only: recovery would leave out all that follows."""
    if code == etree.ErrorTypes.ERR_NO_MEMORY:
        raise MemoryError
    if code == etree.ErrorTypes.ERR_RESOURCE_LIMIT:
        words = next((words for part, words in _LIMITS.items() if part in reason), reason)
        raise BrokenDocument(f"{words}; no ESI document does", line)


def _known(content: bytes, root: etree._Element, problems: Iterable[Problem] = ()) -> ParsedDocument:
    if root.tag in ESI_ROOTS:
        encoding = root.getroottree().docinfo.encoding or "UTF-8"
        _check_doctype(content, root)
        if encoding.upper() in _UNSAFE_ENCODINGS:
            raise BrokenDocument(f"encoded as {encoding}: save it as UTF-8")
        if _has_too_many_attributes(root):
            raise BrokenDocument(f"an element has more than {MAX_ATTRIBUTES} attributes; none of ESI has")
        found = list(problems)
        mislabelled = _mislabelled(content)
        if mislabelled is not None:
            found.append(Problem(1, mislabelled))
        entity = next(root.iter(etree.Entity), None)
        if entity is not None:
            message = f"entity {entity.text} and others are not expanded; left out"
            found.append(Problem(entity.sourceline or 0, message))
            etree.strip_elements(root, etree.Entity, with_tail=False)
        return ParsedDocument(root, encoding, _one_a_line(found), is_whole=entity is None)
    raise NotAnEsiDocument(_other_root(root), root.sourceline or 0)


def _one_a_line(problems: Iterable[Problem]) -> tuple[Problem, ...]:
    messages: dict[int, list[str]] = {}
    for problem in problems:
        messages.setdefault(problem.line, []).append(problem.message)
    return tuple(Problem(line, "; ".join(of_line)) for line, of_line in messages.items())


def _has_too_many_attributes(root: etree._Element) -> bool:
    try:
        return bool(_HAS_TOO_MANY_ATTRIBUTES(root))
    except etree.XPathEvalError as error:  # libxml2 puts at most 10,000,000 elements into one set
        raise MemoryError from error


def _other_root(root: etree._Element) -> str:
    """Why a root is none of ESI; ESI documents have no XML namespace."""
    name = local_name(root)
    if name in ESI_ROOTS:
        namespace = str(root.tag).removesuffix(name)[1:-1]
        return f"{name} in the XML namespace {namespace[:_SHOWN]!r}; ESI documents have none: remove its xmlns"
    return _OTHER_ROOTS.get(name, f"root element {str(root.tag)[:_SHOWN]!r} is not one of ESI")


def local_name(element: etree._Element) -> str:
    """The name of an element without its namespace."""
    return str(element.tag).rpartition("}")[2]


def _one_line(message: str) -> str:
    message = re.sub(r"\s*\((<string>|line).*?\)$", "", one_line(message))
    return message if len(message) <= _LONGEST_REASON else message[: _LONGEST_REASON - 1] + "…"
