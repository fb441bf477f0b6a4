"""A measured pair, step by step: a notebook as a script (each ``# %%`` is a cell; Jupytext, VS Code and PyCharm open it as one).

``python examples/python/measured_pair.py FOLDER`` writes the pictures that the cells show into FOLDER.
"""

# %% Two gears of module 3 as the inspection sheet has them: mean span, runout with its high tooth, pitch of both flanks in µm.
import sys
from pathlib import Path

import numpy as np

import gearlash

teeth = np.arange(44)
wave = 4.0 * np.sin(2 * np.pi * 3 * teeth / 44)
wheel = gearlash.Gear(
    teeth=44,
    module_mm=3.0,
    pressure_angle_deg=20.0,
    thickness={"span": {"teeth": 6, "mm": 50.55}},
    runout={"total_um": 30.0, "high_tooth": 7},
    pitch={"kind": "cumulative", "right_um": wave, "left_um": wave},
    title="Wheel with a wave in its pitch",
)
pinion = gearlash.Gear(
    teeth=43,
    module_mm=3.0,
    pressure_angle_deg=20.0,
    reference_face="back",
    thickness={"span": {"teeth": 5, "mm": 41.55}},
    runout={"total_um": 20.0, "high_tooth": 1},
)
inspection = wheel.chart()
inspection

# %% Put together at 130.6 mm: does it go together, over all matings and every rotation?
pair = gearlash.Pair(wheel, pinion, 130.6, title="Measured pair 44/43")
print(pair.check().verdict)

# %% The backlash over the wheel's teeth.
revolution = pair.chart("revolution")
revolution

# %% The teeth where it is least, drawn.
least = pair.extremes().least
assert least is not None
pose = least.pose
contact = pair.snapshot(pose.wheel_tooth, pose.pinion_tooth, pose.flank, pose.fraction)
contact

# %% 100 000 poses drawn at random: how the backlash is distributed.
rng = np.random.default_rng(1)
n = 100_000
poses = pair.lost_motions(
    rng.integers(1, 45, n), rng.integers(1, 44, n), "right", rng.random(n), certify=False
)
low, median, high = np.nanpercentile(poses.j_wt_um, [0.1, 50, 99.9])
print(f"99.8 % of the poses have {low:.1f} … {high:.1f} µm, half of them more than {median:.1f} µm")

# %% The pictures as files.
if len(sys.argv) == 2:
    folder = Path(sys.argv[1])
    inspection.save(folder / "python_inspection.svg")
    revolution.save(folder / "python_revolution.svg")
    contact.save(folder / "python_contact.svg")
