"""The tables of gear and pair files as dicts, with the keys and units of docs/reference/pair-file.md."""

from collections.abc import Mapping, Sequence
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

Numbers = Sequence[float] | NDArray[np.floating[Any]] | NDArray[np.integer[Any]]
"""One number per tooth, shape (z,), tooth 1 first."""


class Rack(TypedDict, total=False):
    """Basic rack, in modules."""

    addendum: float
    dedendum: float
    root_radius: float


class Thickness(TypedDict, total=False):
    """Mean tooth thickness: one statement."""

    span: Mapping[str, Any]
    """``teeth`` and ``mm`` (or ``min_mm`` and ``max_mm``)."""
    over_pins: Mapping[str, Any]
    """``pin_mm`` and ``mm`` (or ``min_mm`` and ``max_mm``)."""
    designation: str
    """DIN 3967, such as ``25cd``."""
    allowance_um: float | Mapping[str, float]
    flank_offset_mm: float | Mapping[str, float]
    base_thickness_mm: float | Mapping[str, float]
    per_tooth_um: Numbers
    """Added to the thickness, tooth by tooth."""
    cross_check: Mapping[str, Any]


class Runout(TypedDict, total=False):
    """Radial runout."""

    total_um: float
    """F_r: twice the eccentricity."""
    high_tooth: float
    """The tooth of the runout; without it every direction counts."""
    planes: Sequence[Mapping[str, float]]
    """Runouts at two heights in place of both: ``from_reference_face_mm``, ``total_um``, ``high_tooth``."""
    face_runout: Mapping[str, Any]
    """Axial runout of a shoulder: ``um``, ``diameter_mm``, ``high_tooth``, ``face``."""
    file: str
    """Readings in place of both, + = outwards; with the keys of a table."""
    at: str
    """Place of the readings: ``tooth`` or ``space``."""
    ball_mm: float


class Pitch(TypedDict, total=False):
    """Pitch deviation of both flanks."""

    kind: str
    """``cumulative`` or ``single``."""
    axis: str
    """``own`` or ``datum``."""
    sense: str
    """``numbers`` or ``material``."""
    right_um: Numbers
    left_um: Numbers
    file: str
    eccentricity: str
