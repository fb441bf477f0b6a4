"""The Rust side; `Gear`, `Pair` and their results are what to use."""

from typing import Any, final

import numpy as np
from numpy.typing import NDArray

__version__: str
STATUSES: list[str]
OUTCOMES: list[str]

_MatchFiles = tuple[str, str, str, float | None]
_Cell = tuple[int, int, float | None, float | None, bool, bool, int]

@final
class Gear:
    title: str
    teeth: int
    module_mm: float
    pressure_angle_deg: float
    helix_angle_deg: float
    materials: list[str]
    warnings: list[str]
    remarks: list[str]
    @staticmethod
    def from_text(name: str, text: str) -> Gear: ...
    @staticmethod
    def read(path: str, name: str | None = None) -> Gear: ...
    def spec(self) -> str: ...
    def base_thickness_mm(self, material: str | None = None) -> float: ...
    def diameters_mm(self, material: str | None = None) -> list[float]: ...

@final
class Pair:
    title: str
    teeth: list[int]
    materials: list[str]
    center_distances_mm: list[float]
    face_mm: list[float] | None
    warnings: list[str]
    remarks: list[str]
    @staticmethod
    def from_text(name: str, text: str) -> Pair: ...
    @staticmethod
    def read(path: str) -> Pair: ...
    def at(self, distances: list[float]) -> Pair: ...
    def spec(self) -> str: ...

def run(words: list[str]) -> int: ...
def lost_motion(
    pair: Pair,
    teeth: tuple[int, int],
    left: bool,
    fraction: float,
    distance: float | None,
    material: str | None,
) -> str: ...
def lost_motions(
    pair: Pair,
    teeth: tuple[NDArray[np.int64], NDArray[np.int64]],
    left: NDArray[np.bool_],
    fraction: NDArray[np.float64],
    how: tuple[float | None, str | None, bool, int | None],
) -> dict[str, Any]: ...
def revolution(
    pair: Pair,
    steps_per_pitch: int,
    start: tuple[int, int],
    hunting: bool,
    left: bool,
    how: tuple[float | None, str | None, bool, int | None],
) -> dict[str, Any]: ...
def extremes(pair: Pair, threads: int | None = None) -> str: ...
def check(pair: Pair, threads: int | None = None) -> str: ...
def tolerance_assemblies(path: str) -> int: ...
def tolerance_rows(
    path: str, first: int, count: int | None, seed: int | None, threads: int | None = None
) -> tuple[str, list[str]]: ...
def rows_columns(text: str) -> tuple[int, int, dict[str, NDArray[Any]]]: ...
def tolerance_result(
    path: str,
    assemblies: int | None,
    seed: int | None,
    rows: list[str] | None = None,
    threads: int | None = None,
) -> tuple[str, list[str]]: ...
def match_cells(
    files: _MatchFiles, block: tuple[int, int], threads: int | None = None
) -> tuple[str, list[_Cell], list[str]]: ...
def match_result(files: _MatchFiles, blocks: list[tuple[str, list[_Cell]]]) -> str: ...
def gauge(
    gear: Gear,
    sizes: tuple[int | None, float | None, float | None, int | None, int],
    material: str | None,
    threads: int | None,
) -> str: ...
def snapshot(
    pair: Pair,
    teeth: tuple[int, int],
    left: bool,
    fraction: float,
    distance: float | None,
    material: str | None,
) -> str: ...
def over_teeth(
    pair: Pair, difference: bool, distance: float | None, material: str | None
) -> str: ...
def over_distance(pair: Pair, teeth: tuple[int, int] | None) -> str: ...
def field(pair: Pair, distance: float | None, material: str | None) -> str: ...
def inspection(gear: Gear, material: str | None) -> str: ...
