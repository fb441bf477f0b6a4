"""Many pairs: the share of a series that misses its requirement, and the assignment of measured gears."""

import json
import os
import warnings
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from gearlash import _core
from gearlash._errors import GearlashWarning
from gearlash._table import Codes, Table, columns_of, taken

Path = str | os.PathLike[str]


@dataclass(frozen=True)
class Share:
    """Parts per million, with the 95 % confidence interval of the whole population."""

    count: int
    """Drawn assemblies that miss the limit."""
    ppm: float
    low_ppm: float
    high_ppm: float


class Result(Table):
    """A whole result, as the command writes it."""

    def __init__(self, text: str) -> None:
        self._text = text
        self.record: dict[str, Any] = json.loads(text)
        """The whole result."""

    def to_json(self) -> str:
        """The bytes of the command's own JSON file."""
        return self._text


class Rows(Table):
    """Assemblies of a population, one per row.

    As a table (``to_pandas``, ``to_arrow``) the columns of a file of ``gearlash tolerance --rows``. Lengths are NaN where an assembly has none.
    """

    def __init__(self, text: str) -> None:
        self._text = text

    def to_csv(self) -> str:
        """The text of a file of rows, which ``gearlash tolerance --from-rows`` reads."""
        return self._text

    @cached_property
    def _read(self) -> "tuple[int, int, dict[str, np.ndarray[Any, Any]]]":
        return _core.rows_columns(self._text)

    @property
    def _arrays(self) -> "dict[str, np.ndarray[Any, Any]]":
        return self._read[2]

    @property
    def seed(self) -> int:
        """The seed."""
        return self._read[0]

    @property
    def assembly(self) -> np.ndarray[Any, Any]:
        """Numbers of the assemblies."""
        return self._arrays["assembly"]

    @property
    def least_um(self) -> np.ndarray[Any, Any]:
        """Least ``j_wt`` over the mesh cycle, µm."""
        return self._arrays["least_um"]

    @property
    def greatest_um(self) -> np.ndarray[Any, Any]:
        """Greatest ``j_wt`` over the mesh cycle, µm."""
        return self._arrays["greatest_um"]

    def columns(self) -> "dict[str, np.ndarray[Any, Any] | Codes]":
        """Assembly, outcome, least and greatest ``j_wt``, whether they are proven, whether a limit is missed, and the margin to the nearest one, µm."""
        words = {"outcome": (self._arrays["outcome"], tuple(_core.OUTCOMES))}
        return {**self._arrays, **words}

    def __len__(self) -> int:
        return len(self.assembly)

    def __repr__(self) -> str:
        return f"Rows({len(self)} assemblies from {self._read[1]} on, seed {self.seed})"


class Tolerance(Result):
    """The result of a population, as ``gearlash tolerance`` writes it; ``to_json`` has its ``result.json``.

    As a table (``to_pandas``, ``to_arrow``) what each quantity contributes: the extreme, first order and total with their standard errors.
    """

    @property
    def sentence(self) -> str:
        """The share that misses the requirement, and the main source of the spread."""
        return str(self.record["sentence"])

    @property
    def assemblies(self) -> int:
        """Number of drawn assemblies."""
        return int(self.record["assemblies"])

    @property
    def below(self) -> Share:
        """Assemblies with the least backlash below the requirement."""
        return taken(Share, self.record["below"])

    @property
    def above(self) -> Share:
        """Assemblies with the greatest backlash above it."""
        return taken(Share, self.record["above"])

    @property
    def is_met(self) -> bool | None:
        """Whether at most ``max_ppm`` miss it; ``None`` where none is stated."""
        met: bool | None = self.record["requirement"]["met"]
        return met

    def columns(self) -> "dict[str, np.ndarray[Any, Any] | Codes]":
        """The contribution of each quantity to the scatter of either extreme: shares of 1."""
        found = self.record["contributions"] or {}
        return columns_of(
            {"extreme": extreme, **row}
            for extreme in ("least", "greatest")
            for row in (found.get(extreme) or {"each": []})["each"]
        )

    def __repr__(self) -> str:
        return f"Tolerance({self.sentence})"


def warn(texts: Iterable[str]) -> None:
    """Issue the warnings of the command, attributed to the caller of this package's function."""
    for text in texts:
        warnings.warn(text, GearlashWarning, stacklevel=3)


@dataclass(frozen=True)
class MatchedPair:
    """A pair of the assignment: tooth 1 of the wheel meets ``pinion_tooth``, right flanks."""

    wheel: str
    pinion: str
    pinion_tooth: int
    least_um: float
    """Least ``j_wt`` over the mesh cycle, µm."""
    greatest_um: float
    """Greatest ``j_wt`` over the mesh cycle, µm."""


class Matched(Result):
    """Which gears go together: as ``gearlash match`` says it; ``to_json`` has its ``match.json``.

    As a table (``to_pandas``, ``to_arrow``) its pairs.
    """

    @property
    def sentence(self) -> str:
        """The number of pairs within the requirement, and the expectation of simpler methods."""
        return str(self.record["text"])

    @property
    def pairs(self) -> list[MatchedPair]:
        """In the order of the wheels' names."""
        return [taken(MatchedPair, pair) for pair in self.record["pairs"]]

    def columns(self) -> "dict[str, np.ndarray[Any, Any] | Codes]":
        """The pairs: names, the teeth that meet, least and greatest ``j_wt``, µm."""
        return columns_of(self.record["pairs"])

    def __repr__(self) -> str:
        return f"Matched({self.sentence})"


def tolerance_rows(
    path: Path,
    *,
    first: int = 1,
    assemblies: int | None = None,
    seed: int | None = None,
    threads: int | None = None,
) -> Rows:
    """The rows of ``assemblies`` from number ``first`` on, by default up to the last of the pair file.

    An assembly depends on the seed and its number alone: :func:`tolerance` takes rows computed anywhere.
    """
    text, warned = _core.tolerance_rows(os.fspath(path), first, assemblies, seed, threads)
    warn(warned)
    return Rows(text)


def tolerance(
    path: Path,
    *,
    assemblies: int | None = None,
    seed: int | None = None,
    rows: Iterable[Rows] | None = None,
    threads: int | None = None,
) -> Tolerance:
    """The statistics of the population that ``[tolerance]`` of a pair file states; ``assemblies`` and ``seed`` in place of the file's.

    ``rows`` are those of all its assemblies, in any order; without them they are drawn here.
    """
    given = None if rows is None else [each.to_csv() for each in rows]
    text, warned = _core.tolerance_result(os.fspath(path), assemblies, seed, given, threads)
    warn(warned)
    return Tolerance(text)


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
    files = os.fspath(path), os.fspath(wheels), os.fspath(pinions), target_um
    input_hash, cells, warned = _core.match_cells(files, (0, 1), threads)
    warn(warned)
    return Matched(_core.match_result(files, [(input_hash, cells)]))
