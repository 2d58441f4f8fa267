"""What is posted: forms with files, in memory, and scans."""

import io
from typing import Any, NamedTuple
from urllib.parse import parse_qsl

from python_multipart import parse_form
from python_multipart.exceptions import FormParserError

from esicatalog.errors import InputError
from esicatalog.scan.front import read_scan
from esicatalog.scan.records import Scan
from esicatalog.web.http import HttpError

MOST_IDENTITIES = 10_000
"""Asked at once: some seconds of work, and an answer of some 30 MB."""
_MOST_FIELDS = 20
_SHOWN = 60


class Form(NamedTuple):
    """What a form sent, by field: contents, and of files what they are called."""

    contents: dict[str, bytes]
    file_names: dict[str, str]


def read_form(content_type: str, body: bytes) -> Form:
    """Fields and files of a form by name, urlencoded or multipart; empty files are left out.

    Raises :class:`HttpError` for a body that is no form, and for what is given twice: one of both would be lost.
    """
    form = Form({}, {})

    def add(name: str, content: bytes) -> None:
        if name in form.contents:
            raise HttpError(400, f"{name[:_SHOWN]!a} is given more than once; give one")
        form.contents[name] = content

    def on_field(field: Any) -> None:
        add(_text(field.field_name), field.value or b"")

    def on_file(file: Any) -> None:
        file.file_object.seek(0)
        content = file.file_object.read()
        if content:
            name = _text(file.field_name)
            add(name, content)
            form.file_names[name] = _text(file.file_name)

    headers = {"Content-Type": content_type.encode("latin-1", "replace"), "Content-Length": str(len(body)).encode()}
    try:
        if not content_type.lower().startswith("multipart/form-data"):
            for name, value in parse_qsl(body, keep_blank_values=True, max_num_fields=_MOST_FIELDS):
                add(_text(name), value)
        else:
            parse_form(headers, io.BytesIO(body), on_field, on_file)
    except (FormParserError, ValueError) as error:
        raise HttpError(400, f"the form cannot be read: {error}") from error
    return form


def _text(sent: bytes | None) -> str:
    return (sent or b"").decode("utf-8", "replace")


def read_uploaded_scan(text: str) -> Scan:
    """A scan of a bounded number of slaves, and of one at least.

    Raises :class:`HttpError` 413, :class:`InputError` with the findings where no slave was read, and what reading a
    scan raises.
    """
    scan = read_scan(text)
    if not scan.slaves:
        raise InputError("; ".join(["no slave was read", *scan.finding_lines]))
    if len(scan.slaves) > MOST_IDENTITIES:
        raise HttpError(413, f"more than {MOST_IDENTITIES} slaves at once")
    return scan
