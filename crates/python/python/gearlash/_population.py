"""Many pairs: what share of a series misses its requirement, and which measured gears go together."""

import json
import os
from dataclasses import dataclass
from typing import Any

from gearlash import _core

Path = str | os.PathLike[str]


@dataclass(frozen=True)
class Share:
    """Parts of a million, with the interval that holds those of the whole population with 95 %."""

    count: int
    """Assemblies of those drawn that miss the limit."""
    ppm: float
    low_ppm: float
    high_ppm: float

    @classmethod
    def _of(cls, record: dict[str, Any]) -> "Share":
        return cls(*(record[name] for name in ("count", "ppm", "low_ppm", "high_ppm")))


class Tolerance:
    """What came of a population: as ``gearlash tolerance`` says it."""

    def __init__(self, record: dict[str, Any]) -> None:
        self.record = record
        """The whole result as the command's ``result.json``."""

    @property
    def sentence(self) -> str:
        """What share misses the requirement, and what most of the spread comes from."""
        return str(self.record["sentence"])

    @property
    def assemblies(self) -> int:
        """How many were drawn."""
        return int(self.record["assemblies"])

    @property
    def below(self) -> Share:
        """Least backlash below the requirement."""
        return Share._of(self.record["below"])

    @property
    def above(self) -> Share:
        """Greatest backlash above it."""
        return Share._of(self.record["above"])

    @property
    def is_met(self) -> bool | None:
        """Whether no more than ``max_ppm`` miss it; ``None`` where none is stated."""
        met: bool | None = self.record["requirement"]["met"]
        return met

    def __repr__(self) -> str:
        return f"Tolerance({self.sentence})"


@dataclass(frozen=True)
class MatchedPair:
    """A wheel and a pinion that go together: tooth 1 of the wheel meets ``pinion_tooth``, right flanks."""

    wheel: str
    pinion: str
    pinion_tooth: int
    least_um: float
    """Least ``j_wt`` over the mesh cycle, µm."""
    greatest_um: float
    """The greatest."""


class Matched:
    """Which gears go together: as ``gearlash match`` says it."""

    def __init__(self, record: dict[str, Any]) -> None:
        self.record = record
        """The whole result as the command's ``match.json``."""

    @property
    def sentence(self) -> str:
        """How many pairs keep the requirement, and what simpler ways would come to."""
        return str(self.record["text"])

    @property
    def pairs(self) -> list[MatchedPair]:
        """In the order of the wheels' names."""
        names = ("wheel", "pinion", "pinion_tooth", "least_um", "greatest_um")
        return [MatchedPair(*(pair[name] for name in names)) for pair in self.record["pairs"]]

    def __repr__(self) -> str:
        return f"Matched({self.sentence})"


def tolerance(
    path: Path,
    *,
    assemblies: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
) -> Tolerance:
    """Draws the population that ``[tolerance]`` of a pair file states; ``assemblies`` and ``seed`` in place of the file's."""
    part = _core.tolerance_part(os.fspath(path), assemblies, seed, (1, 1), threads)
    return Tolerance(json.loads(_core.tolerance_result([part])))


def match(
    path: Path,
    wheels: Path,
    pinions: Path,
    *,
    target_um: float | None = None,
    threads: int | None = None,
) -> Matched:
    """Which of the gears in the folders ``wheels`` and ``pinions`` go together by ``[require]`` of a pair file.

    ``target_um`` is the backlash from which each pair is to stray least over its mesh cycle, µm; by default the middle of what is required, or its one limit.
    """
    found = _core.match(
        os.fspath(path), os.fspath(wheels), os.fspath(pinions), target_um, threads
    )
    return Matched(json.loads(found))
