"""Populations and matchings: the command's own numbers, and the same bytes on a cluster."""

import json
import os
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import gearlash
import gearlash.dask
import pytest
from conftest import command

DOCS = Path(__file__).parents[3] / "docs" / "files"

distributed = pytest.importorskip("distributed")


@pytest.fixture(scope="module")
def pair(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page's pair, with few rows for the contributions: they take most of the time."""
    text = (DOCS / "tolerances.toml").read_text(encoding="utf-8")
    file = tmp_path_factory.mktemp("pair") / "pair.toml"
    short = text.replace("contribution_rows = 1000", "contribution_rows = 32", 1)
    file.write_text(short, encoding="utf-8")
    return file


@pytest.fixture(scope="module")
def whole(pair: Path, tmp_path_factory: pytest.TempPathFactory) -> dict[str, object]:
    """What the command finds, 600 assemblies."""
    folder = tmp_path_factory.mktemp("whole")
    command("tolerance", pair, "--assemblies", 600, "-o", folder, "-q")
    found: dict[str, object] = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    return found


def test_the_population_is_the_commands(pair: Path, whole: dict[str, object]) -> None:
    found = gearlash.tolerance(pair, assemblies=600)
    assert found.record == whole
    assert found.assemblies == 600
    assert found.below.low_ppm <= found.below.ppm <= found.below.high_ppm
    assert found.sentence in repr(found)


def test_another_seed_draws_others(pair: Path, whole: dict[str, object]) -> None:
    assert gearlash.tolerance(pair, assemblies=600, seed=99).record["least"] != whole["least"]


def test_errors_are_exceptions(pair: Path, tmp_path: Path) -> None:
    file = tmp_path / "none.toml"
    file.write_text(pair.read_text(encoding="utf-8").split("[tolerance]")[0], encoding="utf-8")
    with pytest.raises(gearlash.InputError, match="tolerance: missing"):
        gearlash.tolerance(file)
    with pytest.raises(gearlash.GearlashError, match="0 assemblies"):
        gearlash.tolerance(pair, assemblies=0)


def test_a_share_counts_those_that_miss(whole: dict[str, object], pair: Path) -> None:
    below = gearlash.tolerance(pair, assemblies=600).below
    assert below.ppm == pytest.approx(1e6 * below.count / 600, abs=1e-3)


@pytest.mark.parametrize("target", [float("nan"), float("inf"), 1e300, -100_001.0])
def test_a_wanted_backlash_that_is_none_is_refused(
    pair: Path, tmp_path: Path, target: float
) -> None:
    with pytest.raises(gearlash.GearlashError, match="target_um is .*: a number of µm between"):
        gearlash.match(pair, tmp_path, tmp_path, target_um=target)


def test_draws_of_no_gear_stop_a_part(pair: Path, tmp_path: Path) -> None:
    """Teeth of 9 mm more: half of the draws are of no gear, and the first is named with its reason."""
    text = pair.read_text(encoding="utf-8")
    file = tmp_path / "thick.toml"
    thick = 'thickness = { scatter = "table", values_um = [0, 9000] }'
    lines = [
        thick if line.startswith("thickness = { scatter") else line for line in text.splitlines()
    ]
    file.write_text("\n".join(lines), encoding="utf-8")
    with pytest.raises(gearlash.GearlashError, match="are of no gear, .*; assembly [0-9]+: .+"):
        gearlash.tolerance(file, assemblies=40_000)


def local_cluster(processes: bool) -> Any:
    """Two workers of this machine, none of whose ports is open to others."""
    inside = {"host": "127.0.0.1"} if processes else {"protocol": "inproc"}
    return distributed.LocalCluster(
        n_workers=2,
        threads_per_worker=1,
        processes=processes,
        dashboard_address="127.0.0.1:0",
        **inside,
    )


@pytest.fixture(scope="module", params=[False, True], ids=["threads", "processes"])
def cluster(request: pytest.FixtureRequest) -> Iterator[object]:
    with local_cluster(request.param) as cluster, distributed.Client(cluster) as client:
        yield client


@pytest.mark.parametrize("shards", [1, 7])
def test_a_cluster_comes_to_the_same(
    cluster: object, pair: Path, whole: dict[str, object], shards: int
) -> None:
    found = gearlash.dask.tolerance(cluster, pair, shards=shards, assemblies=600)
    assert json.dumps(found.record) == json.dumps(whole)


def test_a_killed_worker_changes_nothing(pair: Path, whole: dict[str, object]) -> None:
    with local_cluster(True) as cluster, distributed.Client(cluster) as client:
        victim = next(iter(client.run(os.getpid).values()))
        # Its first part kills the worker's process, once: the file says that it has been done.
        mark = os.path.join(client.run(os.getcwd).popitem()[1], f"gearlash-killed-{os.getpid()}")

        def deadly(shard: int) -> tuple[str, list[str]]:
            if os.getpid() == victim and not os.path.exists(mark):
                Path(mark).touch()
                os.kill(victim, signal.SIGKILL)
            return gearlash.dask._part(os.fspath(pair), 600, None, (shard, 8), 1)

        try:
            parts = client.gather(client.map(deadly, range(1, 9), pure=False))
            assert os.path.exists(mark)
        finally:
            Path(mark).unlink(missing_ok=True)
    found = json.loads(gearlash._core.tolerance_result([text for text, _ in parts]))
    assert json.dumps(found) == json.dumps(whole)


MATCHED = (DOCS / "matching.toml", DOCS / "wheels", DOCS / "pinions")


def test_gears_are_matched_as_by_the_command(cluster: object, tmp_path: Path) -> None:
    file, wheels, pinions = MATCHED
    found = gearlash.match(*MATCHED)
    words = ("match", file, "--wheels", wheels, "--pinions", pinions, "-o", tmp_path / "out")
    assert found.to_json() == command(*words, "--format", "json")
    assert found.to_json() == (tmp_path / "out" / "match.json").read_text(encoding="utf-8")
    assert len(found.pairs) == 6 and all(pair.least_um >= 80 for pair in found.pairs)
    for shards in (1, 7, 64):
        assert gearlash.dask.match(cluster, *MATCHED, shards=shards).to_json() == found.to_json()


def test_a_worker_killed_while_gears_are_matched_changes_nothing() -> None:
    whole = gearlash.match(*MATCHED)
    file, wheels, pinions = (os.fspath(path) for path in MATCHED)
    with local_cluster(True) as cluster, distributed.Client(cluster) as client:
        victim = next(iter(client.run(os.getpid).values()))
        mark = os.path.join(client.run(os.getcwd).popitem()[1], f"gearlash-matched-{os.getpid()}")

        def deadly(shard: int) -> tuple[str, list[str]]:
            if os.getpid() == victim and not os.path.exists(mark):
                Path(mark).touch()
                os.kill(victim, signal.SIGKILL)
            return gearlash.dask._match_part(file, (wheels, pinions), None, (shard, 8), 1)

        try:
            parts = client.gather(client.map(deadly, range(1, 9), pure=False))
            assert os.path.exists(mark)
        finally:
            Path(mark).unlink(missing_ok=True)
    assert gearlash._core.match_result([text for text, _ in parts]) == whole.to_json()


def test_results_are_tables(pair: Path) -> None:
    pandas = pytest.importorskip("pandas")
    arrow = pytest.importorskip("pyarrow")
    matched = gearlash.match(*MATCHED)
    frame = matched.to_pandas()
    assert list(frame["wheel"]) == [pair.wheel for pair in matched.pairs]
    assert list(frame["greatest_um"]) == [pair.greatest_um for pair in matched.pairs]
    assert matched.to_arrow().column("pinion").to_pylist() == list(frame["pinion"])
    found = gearlash.tolerance(pair, assemblies=20)
    each = found.record["contributions"]["greatest"]["each"]
    frame = found.to_pandas()
    greatest = frame[frame["extreme"] == "greatest"]
    assert list(greatest["quantity"]) == [row["quantity"] for row in each]
    assert list(greatest["total_error"]) == [row["total_error"] for row in each]
    assert isinstance(frame, pandas.DataFrame)
    assert isinstance(found.to_arrow(), arrow.Table)
    assert found.to_arrow().num_rows == len(frame) == 2 * len(each)


def test_warnings_are_the_commands(tmp_path: Path, cluster: object) -> None:
    """A band of thickness, of which the middle is matched."""
    wheels = tmp_path / "wheels"
    wheels.mkdir()
    for file in MATCHED[1].glob("*.toml"):
        (wheels / file.name).write_text(file.read_text(encoding="utf-8"), encoding="utf-8")
    gear = sorted(wheels.glob("*.toml"))[0]
    band = "thickness = { allowance_um = { min = -80, max = -60 } }"
    lines = gear.read_text(encoding="utf-8").splitlines()
    text = "\n".join(band if line.startswith("thickness") else line for line in lines)
    gear.write_text(text, encoding="utf-8")
    for call in (gearlash.match, lambda *files: gearlash.dask.match(cluster, *files)):
        with pytest.warns(gearlash.GearlashWarning, match="a band, whose middle is matched"):
            call(MATCHED[0], wheels, MATCHED[2])


def test_parts_of_another_run_are_named(pair: Path) -> None:
    part, _ = gearlash.dask._part(os.fspath(pair), 20, None, (1, 2), None)
    other, _ = gearlash.dask._part(os.fspath(pair), 20, 5, (2, 2), None)
    with pytest.raises(gearlash.GearlashError, match="is of another run"):
        gearlash._core.tolerance_result([part, other])
    with pytest.raises(gearlash.GearlashError, match="missing: 2"):
        gearlash._core.tolerance_result([part])
    with pytest.raises(gearlash.GearlashError, match="name each part once"):
        gearlash._core.tolerance_result([part, part])


def test_parts_of_another_matching_are_named() -> None:
    file, wheels, pinions = (os.fspath(path) for path in MATCHED)
    parts = [
        gearlash.dask._match_part(file, (wheels, pinions), um, (k, 2), None)[0]
        for k, um in ((1, None), (2, None), (2, 100.0))
    ]
    with pytest.raises(gearlash.GearlashError, match="is of another run than .*: input"):
        gearlash._core.match_result([parts[0], parts[2]])
    with pytest.raises(gearlash.GearlashError, match="missing: 2"):
        gearlash._core.match_result(parts[:1])
    with pytest.raises(gearlash.GearlashError, match="name each part once"):
        gearlash._core.match_result([parts[0], parts[0]])
    with pytest.raises(gearlash.GearlashError, match="is no part of a run"):
        gearlash._core.match_result([parts[0], "{}"])
