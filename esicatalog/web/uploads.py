"""What is posted: forms with files, in memory, and scans."""

import io
from typing import Any, NamedTuple
from urllib.parse import parse_qsl

from python_multipart import parse_form
from python_multipart.exceptions import FormParserError

from esicatalog.scan.front import read_scan
from esicatalog.scan.records import Scan
from esicatalog.web.http import HttpError

MOST_IDENTITIES = 10_000
"""Asked at once: some seconds of work, and an answer of some 30 MB."""
_MOST_FIELDS = 20


class Form(NamedTuple):
    """What a form sent, by field: contents, and of files what they are called."""

    contents: dict[str, bytes]
    file_names: dict[str, str]


def read_form(content_type: str, body: bytes) -> Form:
    """Fields and files of a form by name, urlencoded or multipart; empty files are left out.

    Raises :class:`HttpError` for a body that is no form.
    """
    form = Form({}, {})

    def on_field(field: Any) -> None:
        form.contents[_text(field.field_name)] = field.value or b""

    def on_file(file: Any) -> None:
        file.file_object.seek(0)
        content = file.file_object.read()
        if content:
            name = _text(file.field_name)
            form.contents[name] = content
            form.file_names[name] = _text(file.file_name)

    headers = {"Content-Type": content_type.encode("latin-1", "replace"), "Content-Length": str(len(body)).encode()}
    try:
        if not content_type.lower().startswith("multipart/form-data"):
            fields = parse_qsl(body, keep_blank_values=True, max_num_fields=_MOST_FIELDS)
            return Form({_text(name): value for name, value in fields}, {})
        parse_form(headers, io.BytesIO(body), on_field, on_file)
    except (FormParserError, ValueError) as error:
        raise HttpError(400, f"the form cannot be read: {error}") from error
    return form


def _text(sent: bytes | None) -> str:
    return (sent or b"").decode("utf-8", "replace")


def read_uploaded_scan(text: str) -> Scan:
    """A scan of a bounded number of slaves. Raises :class:`HttpError` 413 and what reading a scan raises."""
    scan = read_scan(text)
    if len(scan.slaves) > MOST_IDENTITIES:
        raise HttpError(413, f"more than {MOST_IDENTITIES} slaves at once")
    return scan
