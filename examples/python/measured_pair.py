"""A measured pair, step by step: a notebook as a script (each ``# %%`` is a cell; Jupytext, VS Code and PyCharm open it as one)."""

# %% Two gears as the inspection sheet has them: mean span, runout with its high tooth, pitch of both flanks in µm.
import sys
from pathlib import Path

import numpy as np

import gearlash

wave = 4.0 * np.sin(2 * np.pi * 3 * np.arange(44) / 44)
pitch = {"kind": "cumulative", "right_um": wave, "left_um": wave}
span, runout = {"span": {"teeth": 6, "mm": 50.55}}, {"total_um": 30.0, "high_tooth": 7}
wheel = gearlash.Gear(teeth=44, module_mm=3.0, pressure_angle_deg=20.0, thickness=span, runout=runout, pitch=pitch, title="Wheel with a wave in its pitch")
span, runout = {"span": {"teeth": 5, "mm": 41.55}}, {"total_um": 20.0, "high_tooth": 1}
pinion = gearlash.Gear(teeth=43, module_mm=3.0, pressure_angle_deg=20.0, reference_face="back", thickness=span, runout=runout)

# %% Put together at 130.6 mm: does it go together, over all matings and every rotation?
pair = gearlash.Pair(wheel, pinion, 130.6, title="Measured pair 44/43")
print(pair.check().verdict)

# %% The wheel's deviations, the backlash over its teeth, and the teeth where that is least, drawn.
pictures = {"inspection": wheel.chart(), "revolution": pair.chart("revolution")}
least = pair.extremes().least
assert least is not None
pose = least.pose
pictures["contact"] = pair.snapshot(pose.wheel_tooth, pose.pinion_tooth, pose.flank, pose.fraction)

# %% 100 000 poses drawn at random: how the backlash is distributed.
rng, n = np.random.default_rng(1), 100_000
poses = pair.lost_motions(rng.integers(1, 45, n), rng.integers(1, 44, n), "right", rng.random(n), certify=False)
low, median, high = np.nanpercentile(poses.j_wt_um, [0.1, 50, 99.9])
print(f"99.8 % of the poses have {low:.1f} … {high:.1f} µm, half of them more than {median:.1f} µm")

# %% The pictures as files, in the folder that the command names.
for name, picture in pictures.items() if len(sys.argv) == 2 else []:
    picture.save(Path(sys.argv[1]) / f"python_{name}.svg")
