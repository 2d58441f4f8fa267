"""Rules about the mailbox, its start-up commands and the EEPROM (ESI-FACTS sections 10 and 13)."""

from collections.abc import Iterator

from esicatalog.esi.numbers import decode_hex_binary
from esicatalog.esi.records.mailbox import InitCmd
from esicatalog.lint.registry import WARNING, Found, Place, rule
from esicatalog.lint.subjects import (
    FIRST_OBJECT,
    DeviceSubject,
    Dictionaries,
    ModuleSubject,
    is_absent,
    is_off,
    joined_dictionaries,
)
from esicatalog.model.access import states_to_write
from esicatalog.model.base_types import BASE_TYPES
from esicatalog.model.device_words import init_cmd_target
from esicatalog.model.start_up import SENT_IN, TRANSITIONS, transition_of, unusable_part
from esicatalog.model.sync import listed_pdos
from esicatalog.model.values import byte_length, fills
from esicatalog.words import counted

_LEAST_EEPROM_BYTES = 128


@rule("L56", WARNING, "ETG.2000 CoE/InitCmd: the master writes Data to the object; a device refuses what does not fit")
def init_cmd(subject: DeviceSubject | ModuleSubject) -> Iterator[Found]:
    """An InitCmd writes an object that is unknown, read-only or not writable then, or data of another length; or it is
    never sent: without Index, Data or a Transition that is known.
    """
    yield from _never_sent(subject)
    if not subject.coe_init_cmds:
        return
    others = () if isinstance(subject, DeviceSubject) else tuple(subject.hosts)
    dictionaries = joined_dictionaries((subject, *others))
    if not dictionaries:
        return
    is_complete = (
        bool(subject.own)
        and subject.is_complete
        and dictionaries.is_complete
        and not (isinstance(subject, DeviceSubject) and subject.is_modular)
    )
    for number, command in enumerate(subject.coe_init_cmds):
        problem = _init_cmd_problem(command, dictionaries, is_complete)
        if problem is not None:
            yield Found(f"{_words(command)} {problem}", ("mailbox", "coe_init_cmds", number))


def _never_sent(subject: DeviceSubject | ModuleSubject) -> Iterator[Found]:
    for number, command in enumerate(subject.coe_init_cmds):
        unknown = [text for text in command.transitions if transition_of(text) not in TRANSITIONS]
        if not command.transitions:
            problem = "has no Transition, so it is never sent: give one"
        elif unknown:
            problem = f"has the Transition {', '.join(map(repr, unknown))}, which is none of {', '.join(TRANSITIONS)}"
        elif not command.data and "data" not in (command.spelling or {}):
            problem = "has no Data, so it is never sent: give them"
        elif is_absent(command, "object_index"):
            problem = "is never sent: give it"
        else:
            continue
        yield Found(f"{_words(command)} {problem}", ("mailbox", "coe_init_cmds", number))


def _words(command: InitCmd) -> str:
    target = init_cmd_target(command)
    return f"InitCmd for {target}" if target else "InitCmd without Index"


def _init_cmd_problem(command: InitCmd, dictionaries: Dictionaries, is_complete: bool) -> str | None:
    index = command.object_index
    if index is None or index < FIRST_OBJECT or unusable_part(command) is not None:
        return None
    entries = dictionaries.entries(index)
    if entries is None:
        return "writes an object that the dictionary does not have: describe or remove it" if is_complete else None
    if command.complete_access:
        return None
    entry = entries.get(command.subindex or 0)
    if entry is None:
        return "writes a subindex that the dictionary does not have: correct it" if dictionaries.is_complete else None
    writable = states_to_write(entry.access_word)
    if not writable:
        return f"writes an object that is {entry.access}: remove it, or correct Access"
    refused = [text for text in command.transitions if SENT_IN.get(transition_of(text), writable) & ~writable]
    if refused:
        return f"is sent at {', '.join(refused)}, when WriteRestrictions forbid to write the object: correct Transition"
    data = decode_hex_binary(command.data)
    if not data or entry.bit_size is None:
        return None
    if fills(len(data), BASE_TYPES[entry.base_type] if entry.base_type is not None else None, entry.bit_size):
        return None
    return (
        f"has {counted(len(data), 'byte')} of Data, {entry.data_type} has {byte_length(entry.bit_size)}: correct Data"
    )


@rule("L61", WARNING, "ETG.2000 Mailbox/CoE: objects are read and written through CoE")
def dictionary_without_coe(subject: DeviceSubject) -> Iterator[Found]:
    """A dictionary without CoE, or CoE of which neither the document nor the device tells the objects."""
    mailbox = subject.device.mailbox
    dictionaries = joined_dictionaries((subject, *subject.modules))
    if mailbox is None or not mailbox.coe:
        if subject.own and not (mailbox is not None and mailbox.soe):
            yield Found("the device has a dictionary but no CoE: nothing can read its objects", _mailbox_place(subject))
    elif not dictionaries and dictionaries.is_complete and is_off(mailbox, "coe_sdo_info"):
        yield Found(
            "CoE without dictionary and without SdoInfo: nothing tells which objects the device has",
            ("mailbox", "coe"),
        )


def _mailbox_place(subject: DeviceSubject) -> Place:
    return ("mailbox",) if subject.device.mailbox is not None else ()


@rule("L62", WARNING, "ETG.2000 CoE/@PdoAssign, @PdoConfig: 0x1C1x, 0x16xx and 0x1Axx are writable")
def pdo_choice_without_service(subject: DeviceSubject) -> Iterator[Found]:
    """Optional PDOs that no OpMode lists without PdoAssign, or PDOs that are not Fixed without PdoConfig."""
    mailbox = subject.device.mailbox
    if mailbox is None or not mailbox.coe:
        return
    pdos = [pdo for pdo in (*subject.device.rx_pdos, *subject.device.tx_pdos) if not pdo.virtual]
    listed = listed_pdos(subject.device.op_modes)
    optional = [pdo for pdo in pdos if is_absent(pdo, "sm") and pdo.pdo_index not in listed]
    if optional and is_off(mailbox, "coe_pdo_assign"):
        yield Found(
            f"{counted(len(optional), 'PDO is', 'PDOs are')} optional (no Sm, in no OpMode), but CoE has no PdoAssign: "
            "nobody can assign what is optional",
            ("mailbox", "coe"),
        )
    free = [pdo for pdo in pdos if is_off(pdo, "fixed") and pdo.entries]
    if free and is_off(mailbox, "coe_pdo_config"):
        yield Found(
            f"{counted(len(free), 'PDO is', 'PDOs are')} not Fixed, but CoE has no PdoConfig: mark as Fixed what "
            "nobody can change",
            ("mailbox", "coe"),
        )


@rule("L63", WARNING, "ETG.2000 Eeprom, ETG.2010: ByteSize, ConfigData (words 0 to 6 of the image)")
def eeprom(subject: DeviceSubject) -> Iterator[Found]:
    """The EEPROM is smaller than its header or has no ConfigData."""
    held = subject.device.eeprom
    if held is None or held.data:
        return
    if held.byte_size is not None and held.byte_size < _LEAST_EEPROM_BYTES:
        yield Found(
            f"Eeprom ByteSize {held.byte_size}: the header alone takes {_LEAST_EEPROM_BYTES} bytes",
            ("eeprom", "byte_size"),
        )
    if not held.config_data:
        yield Found("Eeprom without ConfigData: the slave controller cannot be configured", ("eeprom", "config_data"))
