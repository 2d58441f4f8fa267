"""What the structures of IgH EtherLab can hold (ecrt.h 1.5 and 1.6), for all that is built on that master.

And what the master does with them: it writes assignment and mapping of the SyncManagers that it is given PDOs for.
"""

from collections.abc import Iterator

from esicatalog.errors import InputError
from esicatalog.esi.records.device import Device
from esicatalog.export.configuration import Configuration
from esicatalog.export.init_cmds import StartCommand
from esicatalog.model.assignable_pdos import declares_pdo_config
from esicatalog.model.pdo_facts import PDO_ASSIGNMENTS
from esicatalog.words import index_words

MAX_SYNC_MANAGERS = 16
"""EC_MAX_SYNC_MANAGERS."""
MAX_BIT_LENGTH = 255
"""``bit_length`` of ec_pdo_entry_info_t is a uint8_t."""
_PIECE_BITS = 248
"""Whole bytes, so that what follows a piece stays where it is."""


def pieces(bit_length: int) -> Iterator[int]:
    """Lengths of the entries that stand for one entry of this length: one unless it is too long."""
    while bit_length > MAX_BIT_LENGTH:
        yield _PIECE_BITS
        bit_length -= _PIECE_BITS
    yield bit_length


def master_written(configuration: Configuration) -> frozenset[StartCommand]:
    """Start-up commands on assignments and mappings that the master writes itself.

    A SyncManager without described entries is not configured: what the description writes for it nobody else does.
    """
    configured = [sm for sm in configuration.sync_managers if sm.is_described]
    written = {PDO_ASSIGNMENTS.start + sm.number for sm in configured}
    written |= {pdo.pdo_index for sm in configured for pdo in sm.pdos}
    return frozenset(
        command
        for command in configuration.commands
        if command.writes_pdo_configuration and command.object_index in written
    )


def lrw_remarks(device: Device, advice: str) -> Iterator[str]:
    """That the master's datagrams may not reach the device, with what to do; see ec_datagram_pair_init()."""
    if device.use_lrd_lwr:
        yield (
            "the device takes no LRW (Type/@UseLrdLwr), and IgH exchanges a domain that has outputs and inputs with "
            f"LRW: {advice}"
        )


def check_limits(configuration: Configuration) -> None:
    """Raise :class:`InputError` for what the master's structures cannot hold.

    Whether a PDO is Fixed does not count: the master does not know it, and writes whatever mapping differs.
    """
    writes_mapping = declares_pdo_config(configuration.subject.device)
    for sm in configuration.sync_managers:
        if sm.pdos and not 0 <= sm.number < MAX_SYNC_MANAGERS:
            raise InputError(f"PDOs are assigned to SM{sm.number}; IgH knows SM0 to SM{MAX_SYNC_MANAGERS - 1}")
        for pdo in sm.pdos:
            long = next((entry for entry in pdo.entries if entry.bit_length > MAX_BIT_LENGTH), None)
            if long is not None and writes_mapping and sm.is_described:
                raise InputError(
                    f"entry {long.place} of PDO 0x{pdo.pdo_index:04X} has {long.bit_length} bits; IgH and CoE mappings "
                    f"hold at most {MAX_BIT_LENGTH}: choose other PDOs"
                )


def unassigned_remarks(configuration: Configuration) -> Iterator[str]:
    """Chosen PDOs that the master is told nothing of: they share a SyncManager with some without described entries."""
    chosen = {item.pdo_index for item in configuration.choice.pdos}
    for sm in configuration.sync_managers:
        indices = [pdo.pdo_index for pdo in sm.pdos if pdo.pdo_index in chosen]
        if indices and not sm.is_described:
            yield (
                f"PDO {', '.join(map(index_words, indices))} of SM{sm.number} {'is' if len(indices) == 1 else 'are'} "
                f"chosen in vain: the entries of PDOs of SM{sm.number} are not described, so nothing is assigned here "
                "and the device keeps the PDOs that it has"
            )
