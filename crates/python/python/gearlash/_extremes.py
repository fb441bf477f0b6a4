"""Least and greatest backlash of the whole mesh cycle, and the checks of a pair."""

import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from gearlash._poses import Pose
from gearlash._table import Codes, Table, columns_of, taken


@dataclass(frozen=True)
class Extreme:
    """An extreme of the backlash over the whole mesh cycle and every rotation, and its pose."""

    j_wt_um: tuple[float, float]
    """Bracket of the circumferential backlash, µm; infinite at an unknown end."""
    found_j_wt_um: float
    """Circumferential backlash at ``pose``, µm."""
    wheel_arcmin: float
    pinion_arcmin: float
    proven: bool
    """Whether the bracket is at most 0.001 µm wide."""
    doubt: str | None
    """The reason why it is wider."""
    uncertainty_um: float | None
    """Expanded uncertainty, where the pair states uncertainties."""
    pose: Pose
    record: dict[str, Any] = field(repr=False, compare=False)
    """The extreme as in ``result.json``."""

    @classmethod
    def of(cls, record: dict[str, Any] | None) -> "Extreme | None":
        """The extreme from its entry in ``result.json``."""
        if record is None:
            return None
        low, high = record["j_wt_um"]
        return taken(
            cls,
            record,
            j_wt_um=(-math.inf if low is None else low, math.inf if high is None else high),
            wheel_arcmin=record["lost_motion_arcmin"]["wheel"],
            pinion_arcmin=record["lost_motion_arcmin"]["pinion"],
            pose=Pose.of(record["pose"]),
            record=record,
        )


@dataclass(frozen=True)
class RunExtremes:
    """The extremes at one centre distance, for one material and assembly phase."""

    center_distance_mm: float
    material: str
    """``most``, ``least`` or ``as-measured``."""
    phase: tuple[int, int] | None
    """Wheel and pinion tooth of the assembly phase, where there are several."""
    status: str
    """Status of the worst pose: ``clear``, ``interference``, ``jammed``, ``no_contact``."""
    least: Extreme | None
    """``None`` where a pose is jammed."""
    greatest: Extreme | None
    """``None`` where a pose is out of mesh."""
    assembles_from_mm: tuple[float, float] | None
    """Where the pair does not assemble: bracket of the least centre distance at which it assembles."""
    along_face_um: dict[str, float | None] | None
    """What ``lead``, ``wobble`` and ``shafts`` cost the least backlash each, µm, where any is stated."""
    record: dict[str, Any] = field(repr=False, compare=False)
    """The extremes as in ``result.json``, including the bearings' play."""

    @classmethod
    def of(cls, record: dict[str, Any]) -> "RunExtremes":
        """The extremes from their entry in ``result.json``."""
        phase, assembles = record["phase"], record["assembles_from_mm"]
        return taken(
            cls,
            record,
            phase=None if phase is None else (phase[0], phase[1]),
            least=Extreme.of(record["least"]),
            greatest=Extreme.of(record["greatest"]),
            assembles_from_mm=None if assembles is None else (assembles[0], assembles[1]),
            record=record,
        )


@dataclass(frozen=True)
class Extremes(Table):
    """The extremes of every centre distance, material and assembly phase of a pair."""

    runs: tuple[RunExtremes, ...]

    def __repr__(self) -> str:
        return f"Extremes({len(self.runs)} runs)"

    @property
    def least(self) -> Extreme | None:
        """The least of all runs; ``None`` where one is jammed."""
        return _first([run.least for run in self.runs], lambda extreme: extreme.j_wt_um[0])

    @property
    def greatest(self) -> Extreme | None:
        """The greatest of all runs; ``None`` where one is out of mesh."""
        return _first([run.greatest for run in self.runs], lambda extreme: -extreme.j_wt_um[1])

    def columns(self) -> dict[str, "np.ndarray[Any, Any] | Codes"]:
        """One row per run: brackets of least and greatest ``j_wt``, µm."""
        def row(run: RunExtremes) -> dict[str, Any]:
            row: dict[str, Any] = {
                "center_distance_mm": float(run.center_distance_mm),
                "material": run.material,
                "status": run.status,
            }
            for name, extreme in ("least", run.least), ("greatest", run.greatest):
                low, high = extreme.j_wt_um if extreme else (None, None)
                row |= {f"{name}_low_um": low, f"{name}_high_um": high}
            return row

        return columns_of(map(row, self.runs))


def _first(found: list[Extreme | None], order: Callable[[Extreme], float]) -> Extreme | None:
    known = [extreme for extreme in found if extreme]
    return min(known, key=order, default=None) if len(known) == len(found) else None


@dataclass(frozen=True)
class Check:
    """One check at one centre distance and material, by formula and on the outlines."""

    id: str
    gear: str | None
    title: str
    formula: float | None
    outlines: float | None
    limit: float | None
    margin: float | None
    unit: str
    verdict: str
    """``pass``, ``unproven``, ``fail`` …"""
    center_distance_mm: float
    material: str
    note: str


@dataclass(frozen=True)
class Checked:
    """A checked pair: the result of ``gearlash check``."""

    verdict: str
    """The first lines that the command prints."""
    assembles: bool | None
    """``None`` where it is not proven."""
    requirement: str
    """``none``, ``met``, ``not_met`` or ``not_proven``."""
    failed_checks: tuple[str, ...]
    extremes: Extremes
    checks: tuple[Check, ...]
    record: dict[str, Any] = field(repr=False, compare=False)
    """The file's entry in ``gearlash check --format json``."""

    def __repr__(self) -> str:
        return f"Checked({self.verdict})"

    @property
    def passed(self) -> bool:
        """Whether ``gearlash check`` exits with 0: the pair assembles, meets its limits and passes every check."""
        return bool(self.record["passed"])

    @classmethod
    def of(cls, record: dict[str, Any]) -> "Checked":
        """The result from the JSON of ``gearlash check`` for one file."""
        (record,) = record["files"]
        verdict = record["verdict"]
        return taken(
            cls,
            verdict,
            verdict=verdict["text"],
            failed_checks=tuple(verdict["failed_checks"]),
            extremes=Extremes(tuple(RunExtremes.of(run) for run in record["extremes"])),
            checks=tuple(taken(Check, check) for check in record["checks"]),
            record=record,
        )
