"""Populations and matchings: the command's own numbers, and the same bytes on a cluster."""

import json
import os
import re
import shutil
import signal
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import gearlash
import gearlash.dask
import numpy as np
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
    """The result of the command, 600 assemblies."""
    folder = tmp_path_factory.mktemp("whole")
    command("tolerance", pair, "--assemblies", 600, "-o", folder, "-q")
    found: dict[str, object] = json.loads((folder / "result.json").read_text(encoding="utf-8"))
    return found


def test_the_population_is_the_commands(pair: Path, whole: dict[str, object]) -> None:
    found = gearlash.tolerance(pair, assemblies=600)
    assert found.record == whole
    assert found.assemblies == 600
    assert found.below.low_ppm <= found.below.ppm <= found.below.high_ppm
    assert found.below.ppm == pytest.approx(1e6 * found.below.count / 600, abs=1e-3)
    assert found.sentence in repr(found)
    assert gearlash.tolerance(pair, assemblies=600, seed=99).record["least"] != whole["least"]


def test_errors_are_exceptions(pair: Path, tmp_path: Path) -> None:
    file = tmp_path / "none.toml"
    file.write_text(pair.read_text(encoding="utf-8").split("[tolerance]")[0], encoding="utf-8")
    with pytest.raises(gearlash.InputError, match="tolerance: missing"):
        gearlash.tolerance(file)
    with pytest.raises(gearlash.GearlashError, match="0 assemblies"):
        gearlash.tolerance(pair, assemblies=0)


@pytest.mark.parametrize("target", [float("nan"), float("inf"), 1e300, -100_001.0])
def test_a_wanted_backlash_that_is_none_is_refused(
    pair: Path, tmp_path: Path, target: float
) -> None:
    with pytest.raises(gearlash.GearlashError, match="target_um is .*: a number of µm between"):
        gearlash.match(pair, tmp_path, tmp_path, target_um=target)


def test_draws_of_no_gear_stop_a_run(pair: Path, tmp_path: Path) -> None:
    """Teeth of 9 mm more: half of the draws are of no gear, and the first is named with its reason."""
    text = pair.read_text(encoding="utf-8")
    file = tmp_path / "thick.toml"
    thick = 'thickness = { scatter = "table", values_um = [0, 9000] }'
    file.write_text(re.sub("(?m)^thickness = { scatter.*", thick, text), encoding="utf-8")
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


def test_rows_are_those_of_the_command(pair: Path, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    file = tmp_path / "rows.csv"
    command("tolerance", pair, "--first", 31, "--assemblies", 50, "--rows", file, "-q")
    rows = gearlash.tolerance_rows(pair, first=31, assemblies=50)
    assert rows.to_csv() == file.read_text(encoding="utf-8")
    frame = rows.to_pandas()
    read = pandas.read_csv(file, comment="#")
    assert list(frame.columns) == list(read.columns) and len(rows) == len(read) == 50
    for name in ("assembly", "least_um", "greatest_um", "margin_um", "proven", "below", "above"):
        assert np.array_equal(frame[name], read[name]), name
    assert list(frame["outcome"]) == list(read["outcome"])
    assert rows.assembly.dtype == np.uint64 and rows.least_um.dtype == np.float64


def test_rows_give_the_statistics(pair: Path, whole: dict[str, object]) -> None:
    ranges = [(401, 200), (1, 250), (251, 150)]
    rows = [gearlash.tolerance_rows(pair, first=low, assemblies=n) for low, n in ranges]
    assert gearlash.tolerance(pair, assemblies=600, rows=rows).record == whole
    for given, message in (
        (rows[1:], "rows are missing, of 600 assemblies: assemblies 401 to 600"),
        ([*rows, rows[0]], r"rows are there twice: .* in rows\[3\] and rows\[0\]"),
        ([gearlash.tolerance_rows(pair, assemblies=600, seed=5)], "another run: seed 5"),
    ):
        with pytest.raises(gearlash.GearlashError, match=message):
            gearlash.tolerance(pair, assemblies=600, rows=given)
    for first, count in ((0, 5), (1, 0), (2**63, 2**63)):
        with pytest.raises(gearlash.GearlashError, match="one at least"):
            gearlash.tolerance_rows(pair, first=first, assemblies=count)


@pytest.mark.parametrize("ranges", [1, 3, 7])
def test_a_cluster_comes_to_the_same(
    cluster: object, pair: Path, whole: dict[str, object], ranges: int
) -> None:
    found = gearlash.dask.tolerance(cluster, pair, ranges=ranges, assemblies=600)
    assert json.dumps(found.record) == json.dumps(whole)


def after_a_kill(call: Any, arguments: Any) -> Any:
    """The results of calls on two workers, the first of which kills its process once: a file says that it has been done."""
    with local_cluster(True) as cluster, distributed.Client(cluster) as client:
        victim = next(iter(client.run(os.getpid).values()))
        mark = os.path.join(client.run(os.getcwd).popitem()[1], f"gearlash-killed-{os.getpid()}")

        def deadly(argument: int) -> Any:
            if os.getpid() == victim and not os.path.exists(mark):
                Path(mark).touch()
                os.kill(victim, signal.SIGKILL)
            return call(argument)

        try:
            found = client.gather(client.map(deadly, arguments, pure=False))
            assert os.path.exists(mark)
        finally:
            Path(mark).unlink(missing_ok=True)
    return found


def test_a_killed_worker_changes_nothing(pair: Path, whole: dict[str, object]) -> None:
    path = os.fspath(pair)
    found = after_a_kill(lambda first: gearlash._core.tolerance_rows(path, first, 75, None, 1), range(1, 600, 75))
    rows = [gearlash.Rows(text) for text, _ in found]
    result = gearlash.tolerance(pair, assemblies=600, rows=rows)
    assert json.dumps(result.record) == json.dumps(whole)
    files = *(os.fspath(path) for path in MATCHED), None
    found = after_a_kill(lambda block: gearlash._core.match_cells(files, (block, 6), 1), range(6))
    blocks = [(input_hash, cells) for input_hash, cells, _ in found]
    assert gearlash._core.match_result(files, blocks) == gearlash.match(*MATCHED).to_json()


MATCHED = (DOCS / "matching.toml", DOCS / "wheels", DOCS / "pinions")


def test_gears_are_matched_as_by_the_command(cluster: object, tmp_path: Path) -> None:
    file, wheels, pinions = MATCHED
    found = gearlash.match(*MATCHED)
    words = ("match", file, "--wheels", wheels, "--pinions", pinions, "-o", tmp_path / "out")
    assert found.to_json() == command(*words, "--format", "json")
    assert found.to_json() == (tmp_path / "out" / "match.json").read_text(encoding="utf-8")
    assert len(found.pairs) == 6 and all(pair.least_um >= 80 for pair in found.pairs)
    for blocks in (1, 3, 7, 64):
        assert gearlash.dask.match(cluster, *MATCHED, blocks=blocks).to_json() == found.to_json()


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
    wheels = shutil.copytree(MATCHED[1], tmp_path / "wheels")
    gear = sorted(wheels.glob("*.toml"))[0]
    band = "thickness = { allowance_um = { min = -80, max = -60 } }"
    text = re.sub("(?m)^thickness.*", band, gear.read_text(encoding="utf-8"))
    gear.write_text(text, encoding="utf-8")
    for call in (gearlash.match, lambda *files: gearlash.dask.match(cluster, *files)):
        with pytest.warns(gearlash.GearlashWarning, match="a band, whose middle is matched"):
            call(MATCHED[0], wheels, MATCHED[2])


def test_blocks_of_another_matching_are_named() -> None:
    paths = [os.fspath(path) for path in MATCHED]
    files = (*paths, None)
    first, other = (gearlash._core.match_cells((*paths, um), (0, 2))[:2] for um in (None, 100.0))
    with pytest.raises(gearlash.GearlashError, match=r"blocks\[1\] is of another pair file"):
        gearlash._core.match_result(files, [first, other])
    with pytest.raises(gearlash.GearlashError, match="number of cells of a matrix"):
        gearlash._core.match_result(files, [first])
