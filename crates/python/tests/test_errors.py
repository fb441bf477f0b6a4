"""Errors are exceptions with the command's text."""

import pickle
import subprocess
import sys
from typing import Any

import numpy as np
import pytest

import gearlash
from conftest import GEAR


def pair(distance: float = 40.1, **assembly: Any) -> gearlash.Pair:
    return gearlash.Pair(gearlash.Gear(**GEAR), gearlash.Gear(**GEAR), distance, **assembly)


def test_a_file_is_refused_in_the_words_of_the_command(fixtures, tmp_path) -> None:
    text = (fixtures / "karba_86x21.toml").read_text().replace("teeth = 86", "teeth = 1", 1)
    path = tmp_path / "wrong.toml"
    path.write_text(text + "\n[compare]\ntolerence_um = 1\n")
    ran = subprocess.run(
        [sys.executable, "-m", "gearlash", "check", str(path)], capture_output=True, text=True
    )
    assert ran.returncode == 2
    with pytest.raises(gearlash.InputError) as raised:
        gearlash.read(path)
    for line in str(raised.value).splitlines():
        assert line.removeprefix(f"{path}: ") in ran.stderr
    assert len(raised.value.problems) == 2
    assert raised.value.problems[0].key == "wheel.teeth"
    assert isinstance(raised.value, ValueError)
    assert pickle.loads(pickle.dumps(raised.value)).problems == raised.value.problems


def test_all_problems_of_a_gear_are_told_at_once() -> None:
    with pytest.raises(gearlash.InputError) as raised:
        gearlash.Gear(teeth=2, module_mm=-1.0, pressure_angle_deg=20.0)
    assert [problem.key for problem in raised.value.problems] == ["gear.teeth", "gear.module_mm"]


@pytest.mark.parametrize(
    ("call", "text"),
    [
        (lambda: gearlash.Gear(**{**GEAR, "module_mm": float("nan")}), "gear.module_mm = nan"),
        (lambda: gearlash.Gear(**GEAR, profile=object()), "gear.profile = object"),
        (lambda: gearlash.Gear(**GEAR, lead={"crowning_um": 8}), "gear.face_width_mm"),
        (lambda: gearlash.Gear(**GEAR, pitch={"right_um": np.zeros(3)}), "gear.pitch"),
        (lambda: pair(misalignment={"in_plane_um": 8.0}), "assembly.misalignment.over_mm"),
        (lambda: pair(misalignment={"in_plane_um": 8.0, "over_mm": 90.0}), "wheel.face_width_mm"),
        (lambda: gearlash.read("no such file.toml"), "there is no such file"),
        (lambda: pair(30.0), "assembly.center_distance_mm"),
        (lambda: pair().at(30.0), "center_distance_mm"),
        (lambda: pair().at(float("nan")), "center_distance_mm"),
        (lambda: pair().lost_motion(21, 1), "the wheel has teeth 1 … 20, not 21"),
        (lambda: pair().lost_motion(1, -1), "the pinion has teeth 1 … 20, not -1"),
        (lambda: pair().lost_motion(1, 1, "up"), "flank"),
        (lambda: pair().lost_motion(1, 1, fraction=float("inf")), "fraction"),
        (lambda: pair().lost_motion(1, 1, material="most"), "as-measured"),
        (lambda: pair().lost_motion(1, 1, center_distance_mm=30.0), "center_distance_mm = 30"),
        (lambda: pair().lost_motions([1, 1 << 40], [1, 1]), "not 1099511627776"),
        (lambda: pair().lost_motions([1.5], [1]), "whole numbers"),
        (lambda: pair().lost_motions([1, 2], [1, 2, 3]), "shape"),
        (lambda: pair().lost_motions([[1]], [[1]]), "shape (n,)"),
        (lambda: pair().lost_motions([1], [1], ["up"]), "flank"),
        (lambda: pair().lost_motions([1], [1], [2]), "flank"),
        (lambda: pair().revolution(steps_per_pitch=0), "steps_per_pitch = 0"),
        (lambda: pair().revolution(threads=0), "threads = 0"),
        (lambda: pair().revolution(threads=20000), "threads = 20000: allowed is 1 … 1024"),
        (lambda: pair().chart("pie"), "kind"),
        (lambda: pair().chart("distance", mating=(21, 1)), "the wheel has teeth"),
        (lambda: gearlash.Gear(**GEAR).gauge(span_teeth=21), "span_teeth = 21"),
        (lambda: gearlash.Gear(**GEAR).gauge(pin_mm=0.1).over_pins_mm, "pins: not measured"),
    ],
)
def test_errors_name_what_is_wrong(call, text: str) -> None:
    with pytest.raises(gearlash.GearlashError) as raised:
        call()
    assert text in str(raised.value)


def test_an_empty_array_has_no_poses() -> None:
    none = np.array([], dtype=np.int64)
    assert len(pair().lost_motions(none, none)) == 0


def test_a_slip_is_a_warning() -> None:
    with pytest.warns(gearlash.GearlashWarning, match="0.022"):
        gear = gearlash.Gear(**GEAR, thickness={"allowance_um": -0.022})
    assert gear.warnings


def test_pairs_and_gears_can_be_pickled() -> None:
    one = pair()
    two = pickle.loads(pickle.dumps(one))
    assert two.to_dict() == one.to_dict()
    assert two.lost_motion(1, 1) == one.lost_motion(1, 1)
    gear = pickle.loads(pickle.dumps(gearlash.Gear(**GEAR)))
    assert gear.teeth == 20
