"""Rules about who a device is: vendor, product, revision, group, what it hides."""

from collections.abc import Iterator

from esicatalog.identity import UINT32_MAX
from esicatalog.lint.library import DeviceFact, Library
from esicatalog.lint.registry import ERROR, INFORMATION, WARNING, Found, Place, rule
from esicatalog.lint.subjects import DeviceSubject, InfoSubject, is_absent, is_off
from esicatalog.model.ports import port_kind
from esicatalog.model.revisions import CHECK_REVISION_NO, hidden_by, is_known
from esicatalog.model.vendor_names import may_be_same

_SECONDARY_VENDOR = 0xE
_IDENTITY_OBJECT = 0x1018


@rule(
    "L08",
    ERROR,
    "ETG.2000 Vendor/Id: the number that the ETG assigned; masters compare it with the EEPROM and 0x1018:01",
)
def vendor_id_missing(section: InfoSubject) -> Iterator[Found]:
    """Vendor/Id is missing or 0."""
    vendor = section.info.vendor
    if vendor is None:
        yield Found("Vendor is missing: no master can match these devices; add Vendor with the id of the ETG")
    elif vendor.vendor_id == 0 or is_absent(vendor, "vendor_id"):
        words = "is missing" if vendor.vendor_id is None else "is 0"
        yield Found(f"Vendor/Id {words}: give the id that the ETG assigned", ("vendor", "vendor_id"))


@rule("L09", WARNING, "ETG vendor id policy: ids 0xE....... are handed to stack and module makers for samples")
def secondary_vendor_id(subject: InfoSubject | Library) -> Iterator[Found]:
    """A vendor id for samples, or one that documents give to vendors of quite different names."""
    if isinstance(subject, Library):
        yield from _names_of_one_vendor(subject)
        return
    vendor = subject.info.vendor
    if vendor is not None and vendor.vendor_id is not None and vendor.vendor_id >> 28 == _SECONDARY_VENDOR:
        yield Found(
            f"Vendor/Id 0x{vendor.vendor_id:08X} is a secondary one, for samples of stack makers: "
            "a product needs the id of its own vendor",
            ("vendor", "vendor_id"),
        )


def _names_of_one_vendor(library: Library) -> Iterator[Found]:
    """One finding a name that shares no word with the first one of the id."""
    first: dict[int, tuple[str, str]] = {}
    reported = set()
    for number, fact in enumerate(library.facts):
        if fact.vendor_id is None or not fact.vendor_name:
            continue
        name, document = first.setdefault(fact.vendor_id, (fact.vendor_name, fact.document))
        key = (fact.vendor_id, fact.vendor_name)
        if key not in reported and not may_be_same(name, fact.vendor_name):
            reported.add(key)
            yield Found(
                f"Vendor/Id 0x{fact.vendor_id:08X} belongs to {fact.vendor_name!r} here, to {name!r} in {document}: "
                "only the ETG assigns ids",
                (number,),
            )


@rule("L12", WARNING, "ETG.2000: masters and catalogs find a description by vendor, product and revision alone")
def described_differently(library: Library) -> Iterator[Found]:
    """Two documents, or two EtherCATInfo of an EtherCATInfoList, describe one identity differently."""
    variants: dict[tuple[int, int, int], dict[bytes, DeviceFact]] = {}
    for number, fact in enumerate(library.facts):
        if fact.identity is None or fact.vendor_name is None:  # without vendor name: what a master printed
            continue
        known = variants.setdefault(fact.identity, {})
        others = [other for other in known.values() if other.section != fact.section]
        if others and fact.signature not in known:
            other = others[0]
            what = "with other content" if other.type == fact.type else f"as {other.type!r}"
            where = other.document if other.document != fact.document else f"line {other.line} of this document"
            yield Found(
                f"{fact.type!r} (product 0x{fact.product_code:08X}, revision 0x{fact.revision_no:08X}) is also "
                f"described {what} in {where}: a new content needs a new RevisionNo",
                (number,),
            )
        known.setdefault(fact.signature, fact)


@rule("L10", WARNING, "ETG.2000 Type/@ProductCode, @RevisionNo: the identity in EEPROM words 10 to 13")
def code_missing(subject: DeviceSubject) -> Iterator[Found]:
    """ProductCode or RevisionNo is missing on a device that has a slave controller."""
    device = subject.device
    if not is_off(device, "invisible"):
        return
    for field, name in (("product_code", "ProductCode"), ("revision_no", "RevisionNo")):
        if is_absent(device, field):
            yield Found(
                f"Type {device.type or ''!r} has no {name}: a scan cannot be matched; "
                f"give it, or Invisible=1 when there is no slave controller",
                (field,),
            )


@rule("L11", ERROR, "ETG.2000: vendor, ProductCode and RevisionNo identify one Device")
def identity_twice(section: InfoSubject) -> Iterator[Found]:
    """The same vendor, product and revision twice in one document."""
    first: dict[tuple[int, int], int] = {}
    for number, device in enumerate(section.info.devices):
        if device.product_code is None or device.revision_no is None:
            continue
        key = (device.product_code, device.revision_no)
        if key in first:
            other = section.info.devices[first[key]]
            yield Found(
                f"{device.type!r} has the ProductCode 0x{key[0]:08X} and RevisionNo 0x{key[1]:08X} "
                f"of {other.type!r} (Device {first[key] + 1} of the document): give it codes of its own",
                ("devices", number, "product_code"),
            )
        first.setdefault(key, number)


@rule("L13", WARNING, "CoE object 0x1018 (ETG.1000.6) and ETG.2000 Type; the reference for a scan is Type")
def identity_object(subject: DeviceSubject) -> Iterator[Found]:
    """A default of 0x1018 differs from Vendor or Type (product and vendor W, revision I)."""
    device, vendor = subject.device, subject.info.vendor
    compared = (
        (1, "Vendor/Id", vendor.vendor_id if vendor is not None else None, WARNING),
        (2, "ProductCode", device.product_code, WARNING),
        (3, "RevisionNo", device.revision_no, INFORMATION),
    )
    entries = subject.own.entries(_IDENTITY_OBJECT) or {}
    for subindex, name, expected, severity in compared:
        default = entries[subindex].default_int if subindex in entries else None
        if not default or expected is None:
            continue
        default &= UINT32_MAX  # as it is on the bus, be the type signed or not
        if default != expected:
            reversed_bytes = default == int.from_bytes(expected.to_bytes(4, "little"), "big")
            why = "its bytes are reversed" if reversed_bytes else "it looks taken over from another device"
            yield Found(
                f"0x1018:{subindex:02} has the default 0x{default:08X}, {name} is 0x{expected:08X}: {why}; correct it",
                subject.object_place(_IDENTITY_OBJECT),
                severity,
            )


@rule("L14", WARNING, "ETG.2000 PhysicsType: Y MII, K E-bus, H fast hot connect, blank unused, at most four ports")
def physics(subject: DeviceSubject) -> Iterator[Found]:
    """Physics is missing or empty on a visible device, or has letters that no port has."""
    device = subject.device
    text = device.physics
    if not text:
        if is_off(device, "invisible"):
            words = "is missing" if text is None else "is empty"
            yield Found(f"Physics {words}: name each port, e.g. YY for two 100BASE-TX ports", ("physics",))
        return
    kinds = [(letter, port_kind(letter)) for letter in text]
    if len(text) > 4 or any(kind is None or kind.is_old for _, kind in kinds):
        old = {f"; {letter} ({kind.words}) is of schemas before 1.6" for letter, kind in kinds if kind and kind.is_old}
        yield Found(f"Physics {text!r} is not up to four of Y, K, H and blank{''.join(old)}", ("physics",))


@rule("L68", WARNING, "ETG.2000 Type/@CheckRevisionNo; later files of Beckhoff have L24_EQ_H8_EQ_OR_G too")
def check_revision_no_unknown(subject: DeviceSubject) -> Iterator[Found]:
    """CheckRevisionNo names no test of found revisions."""
    check = subject.device.check_revision_no
    if not is_known(check):
        yield Found(
            f"CheckRevisionNo {check!r} is none of {', '.join(CHECK_REVISION_NO)}: no master knows what it accepts",
            ("check_revision_no",),
        )


@rule("L15", WARNING, "ETG.2000 GroupType names a Group/Type of the document; ParentGroup likewise, two levels")
def group_unknown(section: InfoSubject) -> Iterator[Found]:
    """A device or group names a group that the document does not define or itself, or groups nest three levels deep."""
    groups = {group.type: group for group in section.info.groups}
    for number, group in enumerate(section.info.groups):
        if group.parent_group is None:
            continue
        parent = groups.get(group.parent_group)
        place: Place = ("groups", number, "parent_group")
        if parent is None:
            yield Found(f"ParentGroup {group.parent_group!r} is no Group of this document: define it", place)
        elif parent is group:
            yield Found(f"Group {group.type!r} is its own ParentGroup: name another, or none", place)
        elif parent.parent_group is not None:
            yield Found(f"Group {group.type!r} is nested three levels deep; two are allowed", place)
    for number, device in enumerate(section.info.devices):
        if device.group_type and device.group_type not in groups:
            yield Found(
                f"GroupType {device.group_type!r} is no Group of this document: define it",
                ("devices", number, "group_type"),
            )


@rule("L16", INFORMATION, "ETG.2000 HideType: selection lists leave out the named revision; usually an older one")
def hide_type(subject: DeviceSubject | Library) -> Iterator[Found]:
    """HideType names no revision, a newer one, its own device, or one that no document describes."""
    if isinstance(subject, Library):
        yield from _hidden_unknown(subject)
        return
    device = subject.device
    for number, hidden in enumerate(device.hide_types):
        place = ("hide_types", number)
        revision, product = hidden.revision_no, hidden.product_code
        if is_absent(hidden, "revision_no"):
            yield Found("HideType without RevisionNo hides nothing: name the revision", place)
        elif revision is None or (product is not None and product != device.product_code):
            continue
        elif revision == device.revision_no:
            yield Found(f"HideType names RevisionNo 0x{revision:08X}, that of the device itself: remove it", place)
        elif device.revision_no is not None and revision > device.revision_no:
            yield Found(
                f"HideType hides RevisionNo 0x{revision:08X}, a newer one than 0x{device.revision_no:08X}", place
            )


def _hidden_unknown(library: Library) -> Iterator[Found]:
    described = {fact.identity for fact in library.facts}
    for number, fact in enumerate(library.facts):
        if fact.vendor_id is None:
            continue
        for product, revision in hidden_by(fact.product_code, fact.revision_no, fact.hide_types):
            if (fact.vendor_id, product, revision) not in described:
                yield Found(
                    f"HideType names product 0x{product:08X}, revision 0x{revision:08X}, "
                    "which no document at hand describes",
                    (number,),
                )
