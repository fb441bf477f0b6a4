"""Tables, pictures, the command, types and examples."""

import os
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import numpy as np
import pytest

import gearlash
from conftest import FIXTURES, command

ROOT = Path(__file__).parents[3]


def pair() -> gearlash.Pair:
    return gearlash.read(FIXTURES / "karba_44x44.toml")


def test_pandas_and_arrow_have_the_columns() -> None:
    pandas = pytest.importorskip("pandas")
    arrow = pytest.importorskip("pyarrow")
    poses = pair().revolution(steps_per_pitch=1)
    frame = poses.to_pandas()
    assert list(frame.columns) == list(poses.columns())
    assert (frame["j_wt_um"].to_numpy() == poses.j_wt_um).all()
    assert set(frame["flank"]) == {"right"} and set(frame["status"]) == {"clear"}
    table = arrow.table(poses)
    assert table.column_names == list(frame.columns)
    assert table["status"].to_pylist() == list(frame["status"])
    runs = pair().extremes().to_pandas()
    assert len(runs) == 56 and isinstance(runs["least_low_um"].iloc[0], float)
    assert isinstance(runs["material"].dtype, pandas.CategoricalDtype)
    jammed = gearlash.Poses(
        poses.center_distance_mm, {**poses.columns(), "j_wt_um": np.full(len(poses), np.nan)}
    )
    assert jammed.to_arrow()["j_wt_um"].null_count == len(poses)


@pytest.mark.parametrize(("method", "package"), [("to_pandas", "pandas"), ("to_arrow", "pyarrow")])
def test_a_missing_package_is_named(monkeypatch, method: str, package: str) -> None:
    poses = pair().revolution(steps_per_pitch=1)
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(ModuleNotFoundError, match=f"{method} needs {package}: pip install"):
        getattr(poses, method)()


@pytest.mark.parametrize(
    "draw",
    [
        lambda: pair().snapshot(11, 11),
        lambda: pair().chart("revolution"),
        lambda: gearlash.read(FIXTURES / "karba_44x44_pitch.toml").chart("difference"),
        lambda: pair().chart("distance", mating=(11, 11)),
        lambda: gearlash.Gear.read(FIXTURES / "karba_44x44_pitch.toml", "wheel").chart(),
    ],
)
def test_pictures_are_svg(draw, tmp_path) -> None:
    picture = draw()
    root = ElementTree.fromstring(picture._repr_svg_())
    assert root.tag == "{http://www.w3.org/2000/svg}svg" and root.get("viewBox")
    path = tmp_path / "picture.svg"
    picture.save(path)
    assert path.read_text(encoding="utf-8") == picture.svg


def test_a_picture_is_that_of_the_command(tmp_path) -> None:
    path = tmp_path / "command.svg"
    command(
        "snapshot", FIXTURES / "karba_44x44.toml", "--mating", "11,11", "--flank", "right",
        "--center-distance", "132.21", "-o", path,
    )  # fmt: skip
    drawn = pair().snapshot(11, 11, center_distance_mm=132.21)
    assert path.read_text(encoding="utf-8").strip() == drawn.svg.strip()


def test_the_command_is_the_program() -> None:
    assert command("--version").strip() == f"gearlash {gearlash.__version__}"
    assert "Usage: gearlash" in command("--help")
    command("nonsense", code=2)
    command("check", FIXTURES / "tip_on_fillet_86x21.toml", code=1)


def test_the_types_hold() -> None:
    pytest.importorskip("mypy")
    for words in (
        ["mypy", "--config-file", str(ROOT / "pyproject.toml")],
        ["mypy.stubtest", "gearlash._core", "--ignore-missing-stub"],
    ):
        ran = subprocess.run(
            [sys.executable, "-m", *words], capture_output=True, text=True, cwd=os.getcwd()
        )
        assert ran.returncode == 0, ran.stdout + ran.stderr


def test_the_examples_in_docstrings_and_pages_run() -> None:
    import doctest

    from gearlash import _gear

    for module in (gearlash, _gear):
        assert doctest.testmod(module).failed == 0
    page = (ROOT / "docs" / "how-to" / "python.md").read_text(encoding="utf-8")
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    here = os.getcwd()
    for text, folder in ((page, ROOT / "docs"), (readme, ROOT)):
        blocks = text.split("```python\n")[1:]
        assert blocks
        names: dict[str, object] = {}
        try:
            os.chdir(folder)
            for block in blocks:
                exec(block.split("```")[0], names)
        finally:
            os.chdir(here)
