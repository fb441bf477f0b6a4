"""Two gears and their assembly."""

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from gearlash import _core
from gearlash._errors import GearlashError, one_of
from gearlash._extremes import Checked, Extremes, RunExtremes
from gearlash._gear import Gear
from gearlash._picture import Picture
from gearlash._poses import Flank, Pose, Poses, is_left
from gearlash._stated import Stated


class Pair(Stated[_core.Pair]):
    """Two gears at one or several centre distances.

    ``center_distance_mm`` is what a pair file may have there: a number, several, a band
    (``{"nominal_mm": 132.18, "tolerance_um": 30}``), distances at two places (``{"ends_mm": [[-50, 132.15], [50, 132.165]]}``) or a
    designation (``"132.18 js7"``). The other arguments are the keys of ``[assembly]`` and
    the tables ``[require]`` and ``[uncertainty]``.

    Where a thickness has two ends, methods that take a ``material`` take ``most`` unless one is named; those that take a
    ``center_distance_mm`` take the pair's least unless one is given.

    Raises:
        InputError: with everything that is wrong.
    """

    def __init__(
        self,
        wheel: Gear,
        pinion: Gear,
        center_distance_mm: float | Sequence[float] | str | Mapping[str, Any],
        *,
        bearing_clearance_mm: float | Mapping[str, Any] | None = None,
        face_offset_mm: float | None = None,
        misalignment: Mapping[str, Any] | None = None,
        locked: str | None = None,
        temperature_c: float | None = None,
        housing_expansion_per_k: float | None = None,
        require: Mapping[str, Any] | None = None,
        uncertainty: Mapping[str, Any] | None = None,
        title: str | None = None,
    ) -> None:
        values = {
            "title": title,
            "wheel": wheel.to_dict(),
            "pinion": pinion.to_dict(),
            "assembly": {
                "center_distance_mm": center_distance_mm,
                "bearing_clearance_mm": bearing_clearance_mm,
                "face_offset_mm": face_offset_mm,
                "misalignment": misalignment,
                "locked": locked,
                "temperature_c": temperature_c,
                "housing_expansion_per_k": housing_expansion_per_k,
            },
            "require": require,
            "uncertainty": uncertainty,
        }
        self._set(self._stated(values))

    def __repr__(self) -> str:
        wheel, pinion = self._core.teeth
        return f"Pair({self.title!r}, {wheel}/{pinion}, center_distances_mm={self.center_distances_mm})"

    @property
    def center_distances_mm(self) -> list[float]:
        """Centre distances of the runs, mm; the least, the nominal and the greatest of a band."""
        return self._core.center_distances_mm

    @property
    def face_mm(self) -> tuple[float, float] | None:
        """Ends of the common face, mm from the wheel's measuring plane; ``None`` where all sections are equal."""
        face = self._core.face_mm
        return None if face is None else (face[0], face[1])

    def at(self, center_distance_mm: float | Sequence[float]) -> "Pair":
        """The same gears at other centre distances, mm. A band or a designation needs a new pair."""
        try:
            distances = np.atleast_1d(np.asarray(center_distance_mm, dtype=np.float64))
        except (TypeError, ValueError) as reason:
            raise GearlashError(f"center_distance_mm: numbers are needed: {reason}") from None
        return Pair._made(self._core.at(distances.tolist()))

    def lost_motion(
        self,
        wheel_tooth: int,
        pinion_tooth: int,
        flank: str | Flank = "right",
        fraction: float = 0.0,
        *,
        center_distance_mm: float | None = None,
        material: str | None = None,
    ) -> Pose:
        """Lost motion where these teeth mate: the exact method, proven and checked by polygons. For many poses: :meth:`lost_motions`.

        Without ``center_distance_mm`` and ``material`` it is that of the first run: of a band the least distance, and most material.
        """
        teeth = (wheel_tooth, pinion_tooth)
        found = _core.lost_motion(
            self._core, teeth, is_left(flank), fraction, center_distance_mm, material
        )
        return Pose.of(json.loads(found))

    def lost_motions(
        self,
        wheel_tooth: ArrayLike,
        pinion_tooth: ArrayLike,
        flank: ArrayLike = "right",
        fraction: ArrayLike = 0.0,
        *,
        center_distance_mm: float | None = None,
        material: str | None = None,
        certify: bool = True,
        threads: int | None = None,
    ) -> Poses:
        """Lost motion at n poses: whole numbers, flanks (``"right"``/``"left"`` or :class:`Flank`) and numbers of pitches, each a value or
        of shape (n,). Bearing clearance is not applied. Distance and material by default: as :meth:`lost_motion`.

        ``certify=False`` leaves out the proof of each pose, which takes a few times as long as the pose.
        ``threads``: as many of its own, or ``None`` for those that all calls share. The interpreter's lock is released.
        """
        teeth = _whole("wheel_tooth", wheel_tooth), _whole("pinion_tooth", pinion_tooth)
        flanks = _left(flank)
        try:
            fractions = np.asarray(fraction, dtype=np.float64)
            wheel, pinion, left, fractions = np.broadcast_arrays(*teeth, flanks, fractions)
        except ValueError as reason:
            raise GearlashError(f"poses: {reason}") from None
        if wheel.ndim > 1:
            raise GearlashError(f"poses: arrays of shape (n,) are needed, not {wheel.shape}")
        found = _core.lost_motions(
            self._core,
            (np.atleast_1d(wheel), np.atleast_1d(pinion)),
            np.atleast_1d(left),
            np.atleast_1d(fractions),
            (center_distance_mm, material, certify, threads),
        )
        return Poses(**found)

    def revolution(
        self,
        *,
        steps_per_pitch: int = 16,
        start: tuple[int, int] = (1, 1),
        flank: str | Flank = "right",
        hunting: bool = False,
        center_distance_mm: float | None = None,
        material: str | None = None,
        certify: bool = True,
        threads: int | None = None,
    ) -> Poses:
        """One wheel revolution from the mating ``start`` on, or, ``hunting``, until the same teeth meet again: ``steps_per_pitch`` poses a pitch.

        Further arguments as of :meth:`lost_motions`.
        """
        if not 1 <= steps_per_pitch <= 10_000:
            raise GearlashError(f"steps_per_pitch = {steps_per_pitch}: allowed is 1 … 10000")
        found = _core.revolution(
            self._core,
            steps_per_pitch,
            start,
            hunting,
            is_left(flank),
            (center_distance_mm, material, certify, threads),
        )
        return Poses(**found)

    def extremes(self, *, threads: int | None = None) -> Extremes:
        """Least and greatest backlash over the whole mesh cycle and every rotation, proven: of each centre distance and material."""
        found = json.loads(_core.extremes(self._core, threads))
        return Extremes(tuple(RunExtremes.of(run) for run in found))

    def check(self, *, threads: int | None = None) -> Checked:
        """Verdict, extremes and every check: the result of ``gearlash check``."""
        return Checked.of(json.loads(_core.check(self._core, threads)))

    def snapshot(
        self,
        wheel_tooth: int,
        pinion_tooth: int,
        flank: str | Flank = "right",
        fraction: float = 0.0,
        *,
        center_distance_mm: float | None = None,
        material: str | None = None,
    ) -> Picture:
        """The contact at one pose, true to scale."""
        teeth = (wheel_tooth, pinion_tooth)
        return Picture(
            _core.snapshot(self._core, teeth, is_left(flank), fraction, center_distance_mm, material)
        )

    def chart(
        self,
        kind: str = "revolution",
        *,
        center_distance_mm: float | None = None,
        material: str | None = None,
        mating: tuple[int, int] | None = None,
    ) -> Picture:
        """Backlash as a curve.

        ``kind``: ``revolution`` over the wheel's teeth, ``difference`` from the formula there, ``distance`` over the centre
        distance, of the teeth ``mating`` or else of what binds, or ``field`` along the face at the least backlash.
        """
        if kind == "distance":
            return Picture(_core.over_distance(self._core, mating))
        if kind == "field":
            return Picture(_core.field(self._core, center_distance_mm, material))
        one_of("kind", kind, "revolution", "difference", "distance", "field")
        return Picture(
            _core.over_teeth(self._core, kind == "difference", center_distance_mm, material)
        )


def read(path: str | os.PathLike[str]) -> Pair:
    """The pair of the pair file at ``path`` (TOML or JSON); its gears are given by their data or by outlines.

    Of a pair with an outline, what needs a module or an involute is ``None`` or NaN.

    Raises:
        InputError: with everything that is wrong with the file.
    """
    pair = Pair.__new__(Pair)
    pair._set(_core.Pair.read(os.fspath(path)))
    return pair


def _whole(name: str, values: ArrayLike) -> NDArray[np.int64]:
    array = np.asarray(values)
    if array.dtype.kind not in "iu":
        raise GearlashError(f"{name}: whole numbers are needed, not {array.dtype}")
    return array.astype(np.int64, copy=False)


def _left(flank: ArrayLike) -> NDArray[np.bool_]:
    array = np.asarray(flank)
    if array.dtype.kind in "iu" and np.isin(array, (Flank.RIGHT, Flank.LEFT)).all():
        return np.asarray(array == Flank.LEFT)
    if array.dtype.kind in "UO" and np.isin(array, ("right", "left")).all():
        return np.asarray(array == "left")
    raise GearlashError('flank: "right" or "left" (Flank.RIGHT or Flank.LEFT) of each pose')
