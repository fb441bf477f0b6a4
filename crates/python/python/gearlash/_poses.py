"""Poses and what was found there."""

from dataclasses import dataclass, field
from enum import IntEnum
from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash import _core
from gearlash._errors import GearlashError
from gearlash._table import Codes, Table, taken


class Flank(IntEnum):
    """The flank, seen from the front, that passes through the operating pitch point."""

    RIGHT = 0
    LEFT = 1


class Status(IntEnum):
    """How a pose ended."""

    CLEAR = 0
    """The free gear has room to turn."""
    INTERFERENCE = 1
    """The teeth overlap: the backlash is negative, the pair cannot be assembled here."""
    JAMMED = 2
    """A tip sits in a root: no rotation is free of overlap, and there is no value."""
    NO_CONTACT = 3
    """Out of mesh: no value."""
    UNPROVEN = 4
    """Nothing vouches for what was found: no value."""


assert _core.STATUSES == [status.name.lower() for status in Status]


def is_left(flank: "str | int") -> bool:
    """Whether a flank, ``"right"`` or ``"left"``, is the left one."""
    if isinstance(flank, str):
        if flank in ("right", "left"):
            return flank == "left"
    elif flank in (0, 1):
        return bool(flank)
    raise GearlashError(f'flank = {flank!r}: "right" or "left"')


@dataclass(frozen=True)
class Contact:
    """Where the gears touch on one side."""

    wheel_tooth: int
    pinion_tooth: int
    wheel_curve: str
    """``involute``, ``fillet``, ``tip`` or ``root``."""
    pinion_curve: str
    wheel_radius_mm: float
    """Radius about the gear's own centre."""
    pinion_radius_mm: float
    point_mm: tuple[float, float]
    """In the picture: wheel axis at 0, 0, pinion axis at a, 0."""
    normal: tuple[float, float]
    """Out of the wheel's metal; of length 1."""
    contact_class: str
    """``involute-involute``, ``tip-involute`` …"""


@dataclass(frozen=True)
class Pose:
    """Lost motion at one pose. What has no value (jammed, out of mesh, unproven) is ``None``."""

    wheel_tooth: int
    pinion_tooth: int
    flank: str
    fraction: float
    """Pitches beyond the pose in which the flank passes through the operating pitch point."""
    status: Status
    j_wt_um: float | None
    """Circumferential backlash, µm at the operating pitch circle; negative: interference."""
    error_bound_um: float | None
    """Bound on the error of ``j_wt_um``."""
    j_t_um: float | None
    """The same at the reference circle."""
    j_bn_um: float | None
    """Normal backlash."""
    j_r_um: float | None
    """Radial backlash: how far the centre distance can fall."""
    lost_motion_rad: float | None
    """Of the gear that turns."""
    wheel_arcmin: float | None
    """How far the wheel turns where the pinion stands still."""
    pinion_arcmin: float | None
    right: Contact | None
    left: Contact | None
    proof: dict[str, Any] | None = field(repr=False, compare=False)
    """The directions that keep all teeth apart a little more open, and a point in the metal of both teeth a little more closed."""
    record: dict[str, Any] = field(repr=False, compare=False)
    """The pose as ``result.json`` has it: the formulas' values (``analytic``) and rotations too."""

    @classmethod
    def of(cls, record: dict[str, Any]) -> "Pose":
        """Of a pose as ``result.json`` has it."""
        arcmin = record.get("lost_motion_arcmin") or {}
        return taken(
            cls,
            {**record, **record["mating"]},
            status=Status[record["status"].upper()],
            wheel_arcmin=arcmin.get("wheel"),
            pinion_arcmin=arcmin.get("pinion"),
            right=_contact(record["right"]),
            left=_contact(record["left"]),
            proof=record.get("proof"),
            record=record,
        )


def _contact(record: dict[str, Any] | None) -> Contact | None:
    if record is None:
        return None
    point, normal = tuple(record["point_mm"]), tuple(record["normal"])
    return taken(Contact, record, contact_class=record["class"], point_mm=point, normal=normal)


@dataclass(frozen=True, eq=False)
class Poses(Table):
    """Lost motion at n poses of one pair at one centre distance, in the order asked for: arrays of shape (n,)."""

    center_distance_mm: float
    wheel_tooth: NDArray[np.uint32]
    pinion_tooth: NDArray[np.uint32]
    flank: NDArray[np.uint8]
    """Numbers of :class:`Flank`."""
    fraction: NDArray[np.float64]
    """Pitches beyond the pose in which the flank passes through the operating pitch point."""
    j_wt_um: NDArray[np.float64]
    """Circumferential backlash, µm; negative: interference; NaN where jammed, out of mesh or unproven."""
    error_bound_um: NDArray[np.float64]
    """Bound on the error of ``j_wt_um``; NaN where that is."""
    status: NDArray[np.uint8]
    """Numbers of :class:`Status`."""
    units: tuple[float, float, float, float] = field(repr=False)
    """``j_t_um``, ``j_bn_um``, ``wheel_arcmin`` and ``pinion_arcmin`` of a ``j_wt`` of 1 µm."""

    def __len__(self) -> int:
        return len(self.j_wt_um)

    @property
    def j_t_um(self) -> NDArray[np.float64]:
        """Backlash at the reference circle, µm."""
        return self.j_wt_um * self.units[0]

    @property
    def j_bn_um(self) -> NDArray[np.float64]:
        """Normal backlash, µm."""
        return self.j_wt_um * self.units[1]

    @property
    def wheel_arcmin(self) -> NDArray[np.float64]:
        """How far the wheel turns where the pinion stands still, arcmin."""
        return self.j_wt_um * self.units[2]

    @property
    def pinion_arcmin(self) -> NDArray[np.float64]:
        """How far the pinion turns where the wheel stands still, arcmin."""
        return self.j_wt_um * self.units[3]

    def columns(self) -> dict[str, "np.ndarray[Any, Any] | Codes"]:
        """The columns of the table, named as in ``result.csv``."""
        return {
            "wheel_tooth": self.wheel_tooth,
            "pinion_tooth": self.pinion_tooth,
            "flank": (self.flank, tuple(flank.name.lower() for flank in Flank)),
            "fraction": self.fraction,
            "j_wt_um": self.j_wt_um,
            "error_bound_um": self.error_bound_um,
            "status": (self.status, tuple(status.name.lower() for status in Status)),
        }
