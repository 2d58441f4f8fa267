"""Profile numbers: those of a profile and those of its channels say the same (ESI-FACTS section 5)."""

from collections.abc import Iterable
from typing import NamedTuple

from esicatalog.esi.records.profile import Profile

PROFILE_CIA402, PROFILE_CIA406 = 402, 406
PROFILE_MODULAR = 5001
"""The modular device profile, whose AddInfo tells what a module is."""
_MOTION_TERMINALS = range(700, 800)
"""AddInfo of motion terminals, drives with objects of their own in place of those of CiA 402."""


class ProfileNumber(NamedTuple):
    """A profile number as a profile or a channel gives it."""

    profile_no: int | None
    add_info: int | None


def profile_numbers(profiles: Iterable[Profile]) -> list[ProfileNumber]:
    """The numbers of profiles, those of their channels included, in document order."""
    found: list[ProfileNumber] = []
    for profile in profiles:
        found.append(ProfileNumber(profile.profile_no, profile.add_info))
        found += [ProfileNumber(channel.profile_no, channel.add_info) for channel in profile.channel_infos]
    return found


def has_profile_402(profiles: Iterable[Profile]) -> bool:
    """Whether one of them is that of CiA 402 drives."""
    return any(number.profile_no == PROFILE_CIA402 for number in profile_numbers(profiles))


def is_encoder(profiles: Iterable[Profile]) -> bool:
    """Whether they are those of an encoder (CiA 406), whose objects at the indices of CiA 402 are other ones."""
    numbers = {number.profile_no for number in profile_numbers(profiles)}
    return PROFILE_CIA406 in numbers and PROFILE_CIA402 not in numbers


def is_motion_terminal(profiles: Iterable[Profile]) -> bool:
    """Whether one of them is that of motion terminals."""
    return any(
        number.profile_no == PROFILE_MODULAR and number.add_info is not None and number.add_info in _MOTION_TERMINALS
        for number in profile_numbers(profiles)
    )
