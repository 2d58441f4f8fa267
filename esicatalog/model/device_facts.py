"""What engineers filter devices by and no single element says: sizes, SYNC support, cycle, layout, safety."""

from typing import Annotated

from esicatalog.esi.binding import Doc, Record
from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.device import Device, Eeprom
from esicatalog.model.dictionary_views import DictionaryViews
from esicatalog.model.drive_modes import DriveModes
from esicatalog.model.process_data import ProcessData
from esicatalog.model.safety import FsoeEvidence
from esicatalog.model.sm_facts import INPUT, OUTPUT
from esicatalog.model.sync_parameters import INPUT_SYNC, OUTPUT_SYNC, SYNC_TYPES, min_cycle_ns, sync_parameters

_BOOTSTRAP_BYTES = slice(2 * 0x14, 2 * 0x18)

_SIZE = (
    "Bytes that the master {} in the default process image; 0 = none, NULL = not known: PDOs without SyncManagers, too "
    "long for them or of a length that is not described, a SyncManager without PDO that has a DefaultSize or whose "
    "device uploads its PDOs (PdoUpload), or a required slot without a preset and with several ModuleIdents or a "
    "ModuleClass for modules with PDOs, with an ident of several that differ, or naming a module that is not described"
)


class DeviceFacts(Record):
    """Derived facts of a device description."""

    output_bytes: Annotated[int | None, Doc(_SIZE.format("writes"))] = None
    input_bytes: Annotated[int | None, Doc(_SIZE.format("reads"))] = None
    dc_supported: Annotated[bool, Doc("Has an OpMode with active sync unit, or TimeLoopControlOnly")] = False
    dc_needed: Annotated[bool, Doc("Has OpModes, and every valid one uses distributed clocks")] = False
    runs_without_dc: Annotated[bool, Doc("Has an OpMode without sync unit (free run or SM synchronous), or no Dc")] = (
        True
    )
    supports_sync0: Annotated[bool, Doc("Some OpMode generates SYNC0")] = False
    supports_sync1: Annotated[bool, Doc("Some OpMode generates SYNC1")] = False
    uses_latch: Annotated[
        bool,
        Doc(
            "Some OpMode gives a latch unit to the slave, or uses DC time without pulses; not with TimeLoopControlOnly"
        ),
    ] = False
    output_sync_types: Annotated[
        int | None, Doc("Default of 0x1C32:04, supported sync types: weak evidence, kept apart from AssignActivate")
    ] = None
    input_sync_types: Annotated[int | None, Doc("Default of 0x1C33:04, supported sync types: weak evidence")] = None
    min_cycle_ns: Annotated[
        int | None,
        Doc(
            "Smallest bus cycle: default of 0x1C32:05 or 0x1C33:05, the larger one; else that with the preset "
            "oversampling, TwinCAT DefaultFactor times MinCycleTime"
        ),
    ] = None
    axis_count: Annotated[int, Doc("Axes with CiA 402 evidence, those of modules for further slots included")] = 0
    has_bootstrap: Annotated[bool, Doc("The EEPROM description has a bootstrap mailbox")] = False
    image_signature: Annotated[
        str | None, Doc("Digest of the default process image: equal = same layout, as far as it is described")
    ] = None
    pdo_signature: Annotated[
        str | None,
        Doc("Digest of all PDOs of the device itself with their entries, those of modules left out; NULL without any"),
    ] = None
    fsoe: Annotated[str | None, Doc("Evidence of FSoE: high or medium; not a safety statement")] = None
    fsoe_evidence: Annotated[str | None, Doc("That evidence in words")] = None


def device_facts(
    device: Device, data: ProcessData, modes: DriveModes, fsoe: FsoeEvidence | None, views: DictionaryViews
) -> DeviceFacts:
    """Facts of a device from what else follows from it and from its dictionaries."""
    signals, valid = data.signals, data.valid_signals
    sync = sync_parameters(device, views)
    return DeviceFacts(
        output_bytes=data.byte_size(OUTPUT),
        input_bytes=data.byte_size(INPUT),
        dc_supported=any(signal.dc_active for signal in signals) or bool(device.dc_time_loop_control_only),
        dc_needed=bool(valid) and all(signal.dc_active for signal in valid),
        runs_without_dc=not valid or any(signal.dc_active is False for signal in valid),
        supports_sync0=any(signal.sync0 for signal in signals),
        supports_sync1=any(signal.sync1 for signal in signals),
        uses_latch=not device.dc_time_loop_control_only
        and any(signal.latch0_pdi or signal.latch1_pdi or signal.time_only for signal in signals),
        output_sync_types=sync[OUTPUT_SYNC].get(SYNC_TYPES),
        input_sync_types=sync[INPUT_SYNC].get(SYNC_TYPES),
        min_cycle_ns=min_cycle_ns(device, sync),
        axis_count=len({item.axis for item in modes.evidence}),
        has_bootstrap=device.eeprom is not None and _has_bootstrap(device.eeprom),
        image_signature=data.image_signature,
        pdo_signature=data.pdo_signature,
        fsoe=fsoe.level if fsoe is not None else None,
        fsoe_evidence=fsoe.words if fsoe is not None else None,
    )


def _has_bootstrap(eeprom: Eeprom) -> bool:
    """Whether the mailbox of state BOOT has offsets or sizes; words 0x14 to 0x17 of an image that is given whole.

    ESI-FACTS section 13.
    """
    if eeprom.data is None:
        return bool((eeprom.boot_strap or "").strip("0"))
    image = decode_hex_binary(eeprom.data) or b""
    return any(image[_BOOTSTRAP_BYTES])
