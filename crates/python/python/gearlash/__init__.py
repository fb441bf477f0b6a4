"""Backlash of a measured gear pair, found by turning one gear's true outline against the other's.

>>> import gearlash
>>> gear = gearlash.Gear(teeth=44, module_mm=3.0, pressure_angle_deg=20.0)
>>> mate = gearlash.Gear(teeth=44, module_mm=3.0, pressure_angle_deg=20.0, reference_face="back")
>>> pair = gearlash.Pair(gear, mate, center_distance_mm=132.1)
>>> round(pair.lost_motion(11, 11, "right").j_wt_um, 4)
73.0569

Lengths and angles carry their unit in their names; keys are those of pair files. What is wrong is raised as
:class:`GearlashError`, with the text that the command ``gearlash`` has for it.
"""

from gearlash._core import __version__
from gearlash._errors import GearlashError, GearlashWarning, InputError, Problem
from gearlash._extremes import Check, Checked, Extreme, Extremes, RunExtremes
from gearlash._gauged import Gauged
from gearlash._gear import Gear
from gearlash._pair import Pair, read
from gearlash._picture import Picture
from gearlash._population import (
    Matched,
    MatchedPair,
    Rows,
    Share,
    Tolerance,
    match,
    tolerance,
    tolerance_rows,
)
from gearlash._poses import Contact, Flank, Pose, Poses, Status

__all__ = [
    "Check",
    "Checked",
    "Contact",
    "Extreme",
    "Extremes",
    "Flank",
    "Gauged",
    "Gear",
    "GearlashError",
    "GearlashWarning",
    "InputError",
    "Matched",
    "MatchedPair",
    "Pair",
    "Picture",
    "Pose",
    "Poses",
    "Problem",
    "Rows",
    "RunExtremes",
    "Share",
    "Status",
    "Tolerance",
    "__version__",
    "match",
    "read",
    "tolerance",
    "tolerance_rows",
]
