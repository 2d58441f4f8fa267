"""Distributed clocks: operation modes and their times (ETG.2000 Dc)."""

from typing import Annotated

from esicatalog.esi.binding import RAW, Record, Xml
from esicatalog.esi.numbers import BOOL, HEX, HEX16, INT


class OpModePdo(Record):
    """PDO assigned in an OpMode."""

    pdo_index: Annotated[int | None, Xml(".", HEX16, "PDO index")] = None
    os_fac: Annotated[int | None, Xml("@OSFac", INT, "Oversampling factor")] = None


class OpModeSm(Record):
    """SyncManager settings of an OpMode: the PDO assignment of this mode."""

    no: Annotated[int | None, Xml("@No", INT, "SyncManager number")] = None
    sync_type: Annotated[int | None, Xml("SyncType", INT, "Sync type (obsolete)")] = None
    cycle_time_ns: Annotated[int | None, Xml("CycleTime", INT, "Cycle time (obsolete)")] = None
    cycle_time_factor: Annotated[int | None, Xml("CycleTime@Factor", INT, "Factor (obsolete)")] = None
    shift_time_ns: Annotated[int | None, Xml("ShiftTime", INT, "Shift time (obsolete)")] = None
    min_after_sync_ns: Annotated[int | None, Xml("ShiftTime@MinAfterSync", INT, "Least time after SYNC")] = None
    min_before_frame_ns: Annotated[int | None, Xml("ShiftTime@MinBeforeFrame", INT, "Least time before frame")] = None
    pdos: Annotated[tuple[OpModePdo, ...], Xml("Pdo", doc="PDOs assigned in this mode")] = ()


class OpMode(Record):
    """Operation mode of the distributed clocks; the first valid one is the default."""

    name: Annotated[str | None, Xml("Name", doc="Name of the OpMode")] = None
    description: Annotated[str | None, Xml("Desc", doc="Description shown by tools")] = None
    assign_activate: Annotated[
        int | None, Xml("AssignActivate", HEX16, "AssignActivate: registers 0x0981 (high byte) and 0x0980 (low byte)")
    ] = None
    cycle_time_sync0_ns: Annotated[
        int | None, Xml("CycleTimeSync0", INT, "SYNC0 cycle time in ns; 0 = by the factor")
    ] = None
    cycle_time_sync0_factor: Annotated[
        int | None, Xml("CycleTimeSync0@Factor", INT, "f > 0: f times the bus cycle; f < 0: bus cycle divided by |f|")
    ] = None
    shift_time_sync0_ns: Annotated[int | None, Xml("ShiftTimeSync0", INT, "SYNC0 shift time in ns")] = None
    shift_time_sync0_factor: Annotated[
        int | None, Xml("ShiftTimeSync0@Factor", INT, "SYNC0 shift as a fraction of the cycle")
    ] = None
    shift_time_sync0_input: Annotated[
        bool | None, Xml("ShiftTimeSync0@Input", BOOL, "SYNC0 shift is relative to the input reference")
    ] = None
    shift_time_sync0_output_delay_ns: Annotated[
        int | None, Xml("ShiftTimeSync0@OutputDelayTime", INT, "Output delay time after SYNC0 in ns")
    ] = None
    shift_time_sync0_input_delay_ns: Annotated[
        int | None, Xml("ShiftTimeSync0@InputDelayTime", INT, "Input delay time after SYNC0 in ns")
    ] = None
    cycle_time_sync1_ns: Annotated[
        int | None, Xml("CycleTimeSync1", INT, "SYNC1 cycle time in ns; 0 = by the factor")
    ] = None
    cycle_time_sync1_factor: Annotated[
        int | None, Xml("CycleTimeSync1@Factor", INT, "f > 0: f times the SYNC0 cycle; f < 0: |f| times the bus cycle")
    ] = None
    shift_time_sync1_ns: Annotated[int | None, Xml("ShiftTimeSync1", INT, "Time from SYNC0 to SYNC1 in ns")] = None
    shift_time_sync1_factor: Annotated[int | None, Xml("ShiftTimeSync1@Factor", INT, "For future use")] = None
    shift_time_sync1_input: Annotated[
        bool | None, Xml("ShiftTimeSync1@Input", BOOL, "SYNC1 shift is relative to the input reference")
    ] = None
    shift_time_sync1_output_delay_ns: Annotated[
        int | None, Xml("ShiftTimeSync1@OutputDelayTime", INT, "Output delay time after SYNC1 in ns")
    ] = None
    shift_time_sync1_input_delay_ns: Annotated[
        int | None, Xml("ShiftTimeSync1@InputDelayTime", INT, "Input delay time after SYNC1 in ns")
    ] = None
    activate_additional: Annotated[
        int | None, Xml("ActivateAdditional", HEX, "Further activation bits (schemas after 1.17)")
    ] = None
    cycle_time_sync2_ns: Annotated[int | None, Xml("CycleTimeSync2", INT, "SYNC2 cycle time (after 1.17)")] = None
    cycle_time_sync2_factor: Annotated[int | None, Xml("CycleTimeSync2@Factor", INT, "SYNC2 factor")] = None
    shift_time_sync2_ns: Annotated[int | None, Xml("ShiftTimeSync2", INT, "SYNC2 shift time (after 1.17)")] = None
    cycle_time_sync3_ns: Annotated[int | None, Xml("CycleTimeSync3", INT, "SYNC3 cycle time (after 1.17)")] = None
    cycle_time_sync3_factor: Annotated[int | None, Xml("CycleTimeSync3@Factor", INT, "SYNC3 factor")] = None
    shift_time_sync3_ns: Annotated[int | None, Xml("ShiftTimeSync3", INT, "SYNC3 shift time (after 1.17)")] = None
    sm_assignments: Annotated[
        tuple[OpModeSm, ...], Xml("Sm", doc="SyncManager settings and PDO assignment of this mode, as JSON")
    ] = ()
    vendor_specific: Annotated[str | None, Xml("VendorSpecific", RAW)] = None
