"""C header for SOEM 1.4 and 2: configuration hook, distributed clocks, process image."""

from typing import NamedTuple

from esicatalog.export.c_clocks import clock_code
from esicatalog.export.c_text import c_bytes, comment_lines, comment_text
from esicatalog.export.configuration import Configuration
from esicatalog.export.esc_registers import register_remarks
from esicatalog.export.headings import heading_lines
from esicatalog.export.init_cmds import SentCommand, StartCommand, by_transition
from esicatalog.export.rendering import render
from esicatalog.export.soem_image import image_code
from esicatalog.export.soem_startup import (
    HOOK_REGISTERS,
    RegisterWrite,
    command_remarks,
    hook_commands,
    later_commands,
    soem_clocks,
    start_mode_remarks,
)
from esicatalog.model.sm_facts import INPUT, OUTPUT


class Api(NamedTuple):
    """Names and arguments of one version of SOEM; calls end where their own arguments begin."""

    include: str
    parameters: str
    arguments: str
    slave: str
    write_sdo: str
    write_idn: str
    write_register: str
    sync0: str
    sync01: str


VERSIONS = ("1.4", "2")
_APIS = {
    "1.4": Api(
        include="ethercat.h",
        parameters="uint16 slave",
        arguments="slave",
        slave="ec_slave[slave]",
        write_sdo="ec_SDOwrite(slave, ",
        write_idn="ec_SoEwrite(slave, ",
        write_register="ec_FPWR(ec_slave[slave].configadr, ",
        sync0="ec_dcsync0(slave, ",
        sync01="ec_dcsync01(slave, ",
    ),
    "2": Api(
        include="soem/soem.h",
        parameters="ecx_contextt *context, uint16 slave",
        arguments="context, slave",
        slave="context->slavelist[slave]",
        write_sdo="ecx_SDOwrite(context, slave, ",
        write_idn="ecx_SoEwrite(context, slave, ",
        write_register="ecx_FPWR(&context->port, context->slavelist[slave].configadr, ",
        sync0="ecx_dcsync0(context, slave, ",
        sync01="ecx_dcsync01(context, slave, ",
    ),
}


class ClockCalls(NamedTuple):
    """How SOEM can set the clocks."""

    call: str | None
    """What is called of SOEM, None when it has nothing for the mode."""
    written: SentCommand | None
    """The registers that are written afterwards, None when SOEM's own values are right."""


def soem_header(configuration: Configuration, version: str = "2") -> str:
    """The header for one device and one of :data:`VERSIONS`, whose names and signatures differ."""
    api = _APIS[version]
    images = [image_code(configuration, direction) for direction in (OUTPUT, INPUT)]
    remarks = (
        *configuration.remarks,
        *start_mode_remarks(configuration, f"{configuration.prefix}_send_so"),
        *configuration.copy_remarks,
        *register_remarks(configuration.subject.device, "SOEM", HOOK_REGISTERS),
        *command_remarks(configuration, "SOEM"),
        *(remark for image in images for remark in image.remarks),
    )
    heading = heading_lines(configuration, _target(version), remarks)
    clocks = clock_code(configuration)
    return render(
        "soem.h.j2",
        configuration=configuration,
        name=configuration.prefix,
        api=api,
        heading=comment_lines(heading),
        images=images,
        commands=[_sent(command, api) for command in hook_commands(configuration)],
        later=by_transition(later_commands(configuration), lambda command: _sent(command, api)),
        clocks=clocks,
        calls=_clock_calls(configuration, api),
        cycle_ns=configuration.cycle_ns,
        needs_cycle=clocks is not None and clocks.needs_cycle,
        needs_bits=any(image.needs_bits for image in images),
    )


def _target(version: str) -> str:
    return f"SOEM {version} configuration"


def _sent(command: StartCommand | RegisterWrite, api: Api) -> SentCommand:
    if isinstance(command, RegisterWrite):
        call = f"{api.write_register}0x{command.register:04x}, sizeof(data), data, EC_TIMEOUTRET)"
    else:
        index, access = f"0x{command.object_index:04x}", "TRUE" if command.complete_access else "FALSE"
        call = f"{api.write_sdo}{index}, 0x{command.subindex:02x}, {access}, sizeof(data), data, EC_TIMEOUTRXM)"
        if command.protocol == "SoE":
            call = f"{api.write_idn}{command.channel}, EC_SOE_VALUE_B, {index}, sizeof(data), data, EC_TIMEOUTRXM)"
    return SentCommand(comment_text(command.words), call, c_bytes(command.data))


def _clock_calls(configuration: Configuration, api: Api) -> ClockCalls | None:
    found = configuration.clocks
    if found is None:
        return None
    prefix = configuration.prefix.upper()
    calls = soem_clocks(found)
    call = None
    if calls.has_sync01_call:
        call = f"{api.sync01}TRUE, {prefix}_SYNC0_CYCLE_NS, {prefix}_SYNC1_DELAY_NS, {prefix}_SYNC0_SHIFT_NS);"
    elif calls.has_sync0_call:
        call = f"{api.sync0}TRUE, {prefix}_SYNC0_CYCLE_NS, {prefix}_SYNC0_SHIFT_NS);"
    return ClockCalls(call, _sent(calls.written, api) if calls.written is not None else None)
