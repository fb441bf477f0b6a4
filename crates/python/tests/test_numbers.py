"""Numbers: closed forms, published values, and those of the command's own JSON."""

import math

import numpy as np
import pytest

import gearlash
from conftest import of_command


def perfect(teeth: int, module: float = 3.0, face: str = "front", **more) -> gearlash.Gear:
    return gearlash.Gear(teeth=teeth, module_mm=module, pressure_angle_deg=20.0, reference_face=face, **more)


def involute_backlash_um(teeth: int, module: float, distance: float) -> float:
    """j_wt of two equal nominal gears, ISO 21771: j_bn = p_bt of both flanks' involutes; 2 r_w (ψ-sum)."""
    alpha = math.radians(20.0)
    working = math.acos(teeth * module * math.cos(alpha) / distance)
    inv = lambda angle: math.tan(angle) - angle  # noqa: E731
    return 1e3 * 2.0 * distance * (inv(working) - inv(alpha))


def test_a_nominal_pair_has_the_backlash_of_the_closed_form() -> None:
    pair = gearlash.Pair(perfect(44), perfect(44, face="back"), 132.1)
    expected = involute_backlash_um(44, 3.0, 132.1)
    # Published for this pair: src/lib.rs.
    assert expected == pytest.approx(73.0569413863697, abs=1e-9)
    pose = pair.lost_motion(11, 11)
    assert pose.j_wt_um == pytest.approx(expected, abs=1e-6)
    # Both gears alike, r = 66 mm, r_w = 132.1/2 mm.
    assert pose.j_wt_um is not None
    arcmin = math.degrees(pose.j_wt_um * 1e-3 / 66.05) * 60.0
    for name, value in {
        "j_t_um": pose.j_wt_um * 132.0 / 132.1,
        "j_bn_um": pose.j_wt_um * 132.0 * math.cos(math.radians(20.0)) / 132.1,
        "wheel_arcmin": arcmin,
        "pinion_arcmin": arcmin,
    }.items():
        assert getattr(pose, name) == pytest.approx(value, rel=1e-12), name
        assert getattr(pair.lost_motions([11], [11]), name)[0] == getattr(pose, name), name
    assert pose.proof is not None
    right, left = pose.proof["sides"]
    assert (right["side"], left["side"]) == ("right", "left")
    # Nothing touches between both, more open than either contact.
    assert right["open_rad"] < right["until_rad"] and left["until_rad"] < left["open_rad"]
    poses = pair.revolution(steps_per_pitch=4)
    assert len(poses) == 44 * 4 and np.abs(poses.j_wt_um - expected).max() < 1e-6
    least = pair.extremes().least
    assert least is not None and least.proven
    assert least.j_wt_um[0] - 1e-6 <= expected <= least.j_wt_um[1] + 1e-6
    # A helix turned by f on one gear takes f/cos α_wt: each side binds at another end.
    turned = perfect(44, face_width_mm=20.0, lead={"helix_slope_um": "8 r", "over": "face"})
    (run,) = gearlash.Pair(turned, perfect(44, face="back", face_width_mm=20.0), 132.1).extremes().runs
    cost = 8.0 * 132.1 / (132.0 * math.cos(math.radians(20.0)))
    assert run.along_face_um is not None and run.along_face_um["lead"] == pytest.approx(cost, abs=1e-3)


def test_a_nominal_helical_pair_has_the_backlash_of_the_closed_form() -> None:
    beta, alpha_n, teeth, module = math.radians(18.0), math.radians(20.0), (31, 52), 2.5
    wound = {"module_mm": module, "pressure_angle_deg": 20.0, "helix_angle_deg": 18.0}
    wheel = gearlash.Gear(teeth=teeth[0], hand="right", face_width_mm=40.0, **wound)
    pinion = gearlash.Gear(teeth=teeth[1], hand="left", face_mm=(-10.0, 40.0), reference_face="back", **wound)
    distance = 0.5 * sum(teeth) * module / math.cos(beta) + 0.2
    pair = gearlash.Pair(wheel, pinion, distance, face_offset_mm=2.0)
    assert pair.face_mm == (-8.0, 20.0) and "helix_angle_deg=18" in repr(wheel)
    # ISO 21771, transverse section: j_wt = 2 a (inv α_wt − inv α_t), j_bn = j_wt cos α_wt cos β_b.
    alpha = math.atan(math.tan(alpha_n) / math.cos(beta))
    working = math.acos((distance - 0.2) * math.cos(alpha) / distance)
    inv = lambda angle: math.tan(angle) - angle  # noqa: E731
    expected = 2e3 * distance * (inv(working) - inv(alpha))
    poses = pair.revolution(steps_per_pitch=4)
    assert np.abs(poses.j_wt_um - expected).max() < 1e-6
    normal = expected * math.cos(working) * math.cos(math.asin(math.sin(beta) * math.cos(alpha_n)))
    assert pair.lost_motion(1, 1).j_bn_um == pytest.approx(normal, rel=1e-9)
    least = pair.extremes().least
    assert least is not None and least.proven and "Proven" in pair.check().verdict


@pytest.mark.parametrize("name", ["karba_44x44.toml", "profiled_44x44.toml", "hunting_51x23.toml"])
def test_poses_are_those_of_simulate(fixtures, name: str) -> None:
    path = fixtures / name
    result = of_command("simulate", path, "--no-files", "--format", "json")
    pair = gearlash.read(path)
    for run in result["runs"]:
        mating = [pose["mating"] for pose in run["poses"]]
        poses = pair.lost_motions(
            [each["wheel_tooth"] for each in mating],
            [each["pinion_tooth"] for each in mating],
            [each["flank"] for each in mating],
            [each["fraction"] for each in mating],
            center_distance_mm=run["center_distance_mm"],
            material=run["material"],
        )
        assert poses.j_wt_um.tolist() == [pose["j_wt_um"] for pose in run["poses"]]
        assert poses.error_bound_um.tolist() == [pose["error_bound_um"] for pose in run["poses"]]
        statuses = [gearlash.Status(status).name.lower() for status in poses.status]
        assert statuses == [pose["status"] for pose in run["poses"]]
    run = result["runs"][0]
    one = run["poses"][0]
    found = pair.lost_motion(
        **one["mating"], center_distance_mm=run["center_distance_mm"], material=run["material"]
    )
    assert found.j_wt_um == one["j_wt_um"] and found.j_r_um == one["j_r_um"]
    assert found.right is not None and list(found.right.point_mm) == one["right"]["point_mm"]


def test_a_pair_with_drawn_gears_is_a_pair(fixtures) -> None:
    path = fixtures / "outlines" / "drawn_20x20.toml"
    (run,) = of_command("simulate", path, "--no-files", "--format", "json")["runs"]
    pair = gearlash.read(path)
    poses = pair.revolution()
    assert poses.j_wt_um.tolist() == [pose["j_wt_um"] for pose in run["poses"]]
    # A drawing has no base circle.
    assert np.isnan(poses.j_bn_um).all() and pair.lost_motion(1, 1).j_bn_um is None
    checked = pair.check()
    assert checked.assembles is False and not checked.passed and not checked.checks
    remedy, *offsets = checked.record["remedies"]
    assert len(offsets) == 3
    assert remedy["what"] == "center_distance_mm"
    assert pair.at(remedy["value"]).check().assembles
    assert "<svg" in pair.snapshot(7, 7).svg
    assert all("<svg" in pair.chart(kind).svg for kind in ("revolution", "distance"))
    with pytest.raises(gearlash.GearlashError, match="no formula"):
        pair.chart("difference")


def test_verdict_extremes_and_checks_are_those_of_check(fixtures) -> None:
    path = fixtures / "karba_44x44.toml"
    (result,) = of_command("check", path, "--format", "json")["files"]
    pair = gearlash.read(path)
    checked = pair.check()
    assert checked.record == {**result, "file": path.stem}
    assert checked.verdict == result["verdict"]["text"] and checked.passed == result["passed"] and repr(checked) == f"Checked({checked.verdict})"
    assert [run.record for run in pair.extremes().runs] == result["extremes"]
    assert {check.id for check in checked.checks} == {check["id"] for check in result["checks"]}


def test_a_jammed_and_an_unmeshed_pair_are_results() -> None:
    wheel, pinion = perfect(20, 2.0), perfect(20, 2.0, "back")
    jammed = gearlash.Pair(wheel, pinion, 38.0)
    pose = jammed.lost_motion(1, 1)
    assert pose.status is gearlash.Status.JAMMED and pose.j_wt_um is None and jammed.extremes().least is None
    assert np.isnan(jammed.lost_motions(1, [1, 2]).j_wt_um).all()
    apart = gearlash.Pair(wheel, pinion, 45.0)
    assert apart.lost_motions([1], [1]).status.tolist() == [gearlash.Status.NO_CONTACT]
    assert apart.extremes().greatest is None


def test_the_gauge_is_that_of_the_command(fixtures) -> None:
    path = fixtures / "karba_44x44_pitch.toml"
    result = of_command("gauge", path, "--gear", "pinion", "--no-files", "--format", "json")
    found = gearlash.Gear.read(path, "pinion").gauge()
    assert found.record == result["gears"][0]
    spans = found.record["spans"]
    assert found.spans_mm.tolist() == [reading["mm"] for reading in spans["readings"]] and found.span_teeth == spans["teeth"]


def test_deviations_may_be_arrays() -> None:
    deviation = np.round(4.0 * np.cos(np.arange(44) * 6.0 * np.pi / 44), 1)
    deviation -= deviation.mean()
    gear = gearlash.Gear(
        teeth=44,
        module_mm=3.0,
        pressure_angle_deg=20.0,
        pitch={"kind": "cumulative", "right_um": deviation, "left_um": deviation},
    )
    for flank in ("right", "left"):
        assert gear.gauge().pitch_um(flank) == pytest.approx(deviation, abs=1e-3)
    assert isinstance(gear.to_dict()["pitch"]["right_um"], list)


def test_a_pair_of_the_gears_of_a_file_is_that_of_the_file(fixtures, tmp_path, monkeypatch) -> None:
    for name in ("karba_44x44_pitch.toml", "profiled_44x44.toml"):
        path = fixtures / name
        read = gearlash.read(path)
        gears = [gearlash.Gear.read(path, gear) for gear in ("wheel", "pinion")]
        # Elsewhere, where the files that the pair file names are not found.
        monkeypatch.chdir(tmp_path)
        made = gearlash.Pair(gears[0], gears[1], read.center_distances_mm)
        for material in read.materials:
            found = [pair.revolution(material=material, certify=False) for pair in (read, made)]
            assert (found[0].j_wt_um == found[1].j_wt_um).all()


@pytest.mark.parametrize(("name", "distances"), [("karba_44x44_pitch.toml", [130.0, 132.0, 137.9]), ("tip_on_fillet_86x21.toml", [160.2])])
def test_without_certificates_poses_are_the_same(fixtures, name: str, distances: list[float]) -> None:
    pair = gearlash.read(fixtures / name)
    for distance in distances:
        for flank in ("right", "left"):
            at = {"center_distance_mm": distance, "flank": flank}
            one, other = (pair.revolution(certify=certify, **at) for certify in (True, False))
            for column in ("j_wt_um", "error_bound_um", "status", "wheel_tooth", "fraction"):
                both = getattr(one, column), getattr(other, column)
                assert np.array_equal(*both, equal_nan=True), column


def test_flanks_start_and_hunting_cycle() -> None:
    pair = gearlash.Pair(perfect(9, 2.0), perfect(6, 2.0, "back"), 15.4)
    whole = pair.revolution(steps_per_pitch=2, hunting=True, start=(3, 5))
    assert len(whole) == 2 * 18 and (whole.wheel_tooth[0], whole.pinion_tooth[0]) == (3, 5)
    assert (pair.revolution(steps_per_pitch=2, flank="left").flank == gearlash.Flank.LEFT).all()
