"""The order of child elements."""

from collections.abc import Iterator

from esicatalog.lint.order import OrderSubject
from esicatalog.lint.registry import WARNING, Found, rule


@rule("L04", WARNING, "ETG.2000 schemas: xs:sequence; a strict parser refuses another order")
def out_of_order(subject: OrderSubject) -> Iterator[Found]:
    """Child elements do not stand in the order of the schema."""
    yield from subject.checker.document(subject.document, subject.root)
