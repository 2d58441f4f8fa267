"""Small drives to judge: parts of their descriptions, and what is found for them."""

from esicatalog.esi.reader import Reader
from esicatalog.esi.records.device import Device
from esicatalog.model.drive_modes import DriveModes, DriveModeVerdict, drive_modes

SMS = "".join(f"<Sm>{usage}</Sm>" for usage in ("MBoxOut", "MBoxIn", "Outputs", "Inputs"))


def one_drive(body: str, profile: str = "402", sync_managers: str = SMS) -> DriveModes:
    """Modes of a drive with this content after its profile's opening."""
    return drive_modes(one_device(body, profile, sync_managers))


def one_device(body: str, profile: str = "402", sync_managers: str = SMS) -> Device:
    """The drive itself."""
    text = f"""<EtherCATInfo><Vendor><Id>1</Id><Name>V</Name></Vendor><Descriptions><Groups/><Devices>
      <Device Physics="YY"><Type ProductCode="#x1" RevisionNo="#x1">D</Type><Name>D</Name><GroupType>G</GroupType>
      <Profile><ProfileNo>{profile}</ProfileNo>{body}{sync_managers}</Device></Devices></Descriptions></EtherCATInfo>"""
    return Reader().read(text.encode()).document.infos[0].devices[0]


def dictionary(*objects: str, types: str = "") -> str:
    return f"<Dictionary><DataTypes>{types}</DataTypes><Objects>{''.join(objects)}</Objects></Dictionary></Profile>"


def supported_modes(data: str, index: str = "6502") -> str:
    info = f"<Info><DefaultData>{data}</DefaultData></Info>" if data else ""
    return f"<Object><Index>#x{index}</Index><Name>m</Name><Type>UDINT</Type><BitSize>32</BitSize>{info}</Object>"


def rx_pdo(*entries: tuple[str, int], name: str = "Outputs") -> str:
    rows = "".join(f"<Entry><Index>#x{i}</Index><SubIndex>0</SubIndex><BitLen>{b}</BitLen></Entry>" for i, b in entries)
    return f'<RxPdo Sm="2"><Index>#x1600</Index><Name>{name}</Name>{rows}</RxPdo>'


def init_cmd(mode: int) -> str:
    """A start-up command that writes a mode's code to 0x6060."""
    command = f"<Transition>PS</Transition><Index>#x6060</Index><SubIndex>0</SubIndex><Data>{mode:02X}</Data>"
    return f"<Mailbox><CoE><InitCmd>{command}</InitCmd></CoE></Mailbox>"


DC = "<Dc><OpMode><Name>DC</Name><AssignActivate>#x300</AssignActivate></OpMode></Dc>"


def verdicts(found: DriveModes, axis: int = 0) -> dict[str, str]:
    return {item.mode: item.verdict for item in found.verdicts if item.axis == axis}


def verdict_of(found: DriveModes, mode: str) -> DriveModeVerdict:
    """The verdict about a mode, of which there is one."""
    (verdict,) = [item for item in found.verdicts if item.mode == mode]
    return verdict
