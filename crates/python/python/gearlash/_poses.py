"""Poses and their results."""

from collections.abc import Mapping
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
    """Status of a pose."""

    CLEAR = 0
    """The free gear has room to turn."""
    INTERFERENCE = 1
    """The teeth overlap: the backlash is negative, the pair cannot be assembled here."""
    JAMMED = 2
    """A tip sits in a root: no rotation is free of overlap, and there is no value."""
    NO_CONTACT = 3
    """Out of mesh: no value."""
    UNPROVEN = 4
    """Unproven: no value."""


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
    """The contact on one side."""

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
    section_mm: float | None
    """Place along the axes, mm from the wheel's measuring plane, away from the viewer."""
    at: str | None
    """``near_end``, ``far_end``, ``inside`` or ``tip_edge``, where deviations along the face are stated."""


@dataclass(frozen=True)
class Pose:
    """Lost motion at one pose. Values are ``None`` where it is jammed, out of mesh or unproven."""

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
    """Circumferential backlash at the reference circle, µm."""
    j_bn_um: float | None
    """Normal backlash."""
    j_r_um: float | None
    """Radial backlash: how far the centre distance can decrease."""
    lost_motion_rad: float | None
    """Lost motion of the gear that turns."""
    wheel_arcmin: float | None
    """Rotation of the wheel with the pinion locked."""
    pinion_arcmin: float | None
    right: Contact | None
    left: Contact | None
    proof: dict[str, Any] | None = field(repr=False, compare=False)
    """The directions that keep all teeth apart a little more open, and a point in the metal of both teeth a little more closed."""
    record: dict[str, Any] = field(repr=False, compare=False)
    """The pose as in ``result.json``, including the formulas' values (``analytic``) and rotations."""

    @classmethod
    def of(cls, record: dict[str, Any]) -> "Pose":
        """The pose from its entry in ``result.json``."""
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


class Poses(Table):
    """Lost motion at n poses of one pair at one centre distance, in the given order.

    Each column is an attribute, an array of shape (n,); :meth:`columns` has all by name:

    - ``wheel_tooth``, ``pinion_tooth``, ``flank`` (numbers of :class:`Flank`), ``fraction`` (pitches beyond the pose in which the flank
      passes through the operating pitch point): the pose
    - ``j_wt_um``: circumferential backlash, µm; negative: interference; NaN where jammed, out of mesh or unproven
    - ``j_t_um``, ``j_bn_um``: the same at the reference circle, and normal to the flanks, µm
    - ``wheel_arcmin``, ``pinion_arcmin``: how far each gear turns where its mate stands still, arcmin
    - ``error_bound_um``: bound on the error of ``j_wt_um``
    - ``status``: numbers of :class:`Status`
    """

    center_distance_mm: float

    def __init__(
        self, center_distance_mm: float, columns: Mapping[str, "np.ndarray[Any, Any] | Codes"]
    ) -> None:
        self.center_distance_mm = center_distance_mm
        self._columns = dict(columns)

    def __getattr__(self, name: str) -> NDArray[Any]:
        column = self.__dict__.get("_columns", {}).get(name)
        if column is None:
            raise AttributeError(f"Poses has no column {name!r}")
        return np.asarray(column[0] if isinstance(column, tuple) else column)

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._columns]

    def __repr__(self) -> str:
        return f"Poses(center_distance_mm={self.center_distance_mm}, n={len(self)})"

    def __len__(self) -> int:
        return len(self.status)

    def columns(self) -> dict[str, "np.ndarray[Any, Any] | Codes"]:
        """The columns by name, words as :data:`Codes`."""
        return dict(self._columns)
