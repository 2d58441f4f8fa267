"""What came out of comparing an EEPROM image with the catalog."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from esicatalog.catalog.results import FoundDevice, Identification
from esicatalog.counting import counted
from esicatalog.export.sii_verify import ImageDifference


class Verification(NamedTuple):
    """The description that fits the image best among those of its identity, and how they differ."""

    identification: Identification
    device: FoundDevice | None
    """None when the identity is not described exactly; then nothing was compared."""
    findings: tuple[str, ...]
    """What is odd about the image itself."""
    unusable: tuple[str, ...]
    """Which descriptions of the identity were left out, because they hold an image that is none."""
    differences: tuple[ImageDifference, ...]

    @property
    def agrees(self) -> bool:
        """Whether image and description say the same of everything that a master uses."""
        return self.device is not None and not any(item.used_by_master for item in self.differences)

    def lines(self) -> Iterator[str]:
        """The result as text."""
        known = self.device
        yield (
            f"{known.type or ''}  {known.identity_text}".strip()
            if known is not None
            else f"not compared: {self.identification.reason}"
        )
        yield from (f"  image: {finding}" for finding in self.findings)
        yield from (f"  left out: {description}" for description in self.unusable)
        if known is None:
            return
        for item in self.differences:
            yield f"  {'!' if item.used_by_master else ' '} {item.part}: {item.text}"
        used = sum(item.used_by_master for item in self.differences)
        yield f"{counted(len(self.differences), 'difference')}, {used} in what a master uses (marked !)"

    def as_json(self) -> dict[str, Any]:
        """The result for JSON."""
        return {
            "agrees": self.agrees,
            "identification": self.identification.as_json(),
            "device": self.device.as_json() if self.device is not None else None,
            "findings": list(self.findings),
            "unusable": list(self.unusable),
            "differences": [item._asdict() for item in self.differences],
        }
