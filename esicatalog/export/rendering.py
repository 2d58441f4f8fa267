"""The Jinja2 templates of text exports. They only lay out; everything that decides is Python."""

import functools
from typing import Any

import jinja2


@functools.cache
def _environment() -> jinja2.Environment:
    # What is rendered is C, YAML, Python or XML, made safe where it is put together; HTML escapes would break it.
    return jinja2.Environment(
        loader=jinja2.PackageLoader("esicatalog.export"),
        autoescape=False,  # noqa: S701
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        undefined=jinja2.StrictUndefined,
    )


def render(template: str, **values: Any) -> str:
    """The text of a template."""
    return _environment().get_template(template).render(**values)
