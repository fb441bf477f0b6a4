"""`gearlash schema` and `gearlash init`: an independent validator finds in the schema what the reader allows."""

import json
import sys
from collections.abc import Iterator
from typing import Any

import pytest
from conftest import FIXTURES, GEAR, command, of_command
from jsonschema import validators

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib


def smallest() -> Any:
    """The smallest pair file."""
    return {"wheel": {**GEAR}, "pinion": {**GEAR}, "assembly": {"center_distance_mm": 40.3}}


def validator(*files: str) -> Any:
    schema = of_command("schema", *files)
    kind = validators.validator_for(schema)
    kind.check_schema(schema)
    return kind(schema)


@pytest.fixture(scope="module")
def pairs() -> Any:
    return validator()


def test_a_gear_file_is_no_pair_file(pairs) -> None:
    gears = validator("gear")
    assert gears.is_valid({"gear": GEAR, "title": "Wheel"})
    assert gears.is_valid({"gear": {"outline": {"file": "gear.dxf"}}})
    for fault in [{"gear": {**GEAR, "teeth": 2}}, {"title": "Wheel"}, smallest()]:
        assert not gears.is_valid(fault), fault
    assert not pairs.is_valid({"gear": GEAR})


def test_the_schema_accepts_good_pair_files(pairs) -> None:
    folders = ["", "reference/lost_motion", "sheets"]
    files = [file for folder in folders for file in (FIXTURES / folder).glob("*.toml")]
    assert len(files) >= 20
    for text in [file.read_text() for file in files] + [command("init", "-")]:
        pairs.validate(tomllib.loads(text))


def test_the_schema_refuses_and_accepts_what_the_reader_does(pairs) -> None:
    # The command's tests give the same cases to the reader.
    cases = json.loads((FIXTURES / "../crates/cli/tests/cli/schema_cases.json").read_text())
    for kind in ["refused", "accepted"]:
        assert len(cases[kind]) > 10
        for pointer, value in cases[kind]:
            changed = place = smallest()
            *tables, key = pointer.split("/")[1:]
            for table in tables:
                place = place[table]
            place[key] = value
            assert pairs.is_valid(changed) == (kind == "accepted"), (pointer, value)


def explained(text: str) -> Iterator[tuple[str, Any, str]]:
    """Path, value and explanation of each key in a file of `init`; commented lines count."""
    table = ""
    for line in text.splitlines():
        said, _, words = line.removeprefix("# ").partition(" # ")
        if said.startswith("["):
            table = said.strip("[] ") + "."
        key = said.split(" = ")[0].strip()
        if " = " in said and key.isascii() and key.replace("_", "").isalpha() and key.islower():
            yield table + key, tomllib.loads(said)[key], words


def keys(node: Any) -> Iterator[str]:
    """The keys of all tables in a schema."""
    if isinstance(node, dict):
        yield from node.get("properties", {})
        node = list(node.values())
    if isinstance(node, list):
        for inner in node:
            yield from keys(inner)


def below(schema: Any, node: Any, key: str) -> Any:
    """The schema of `key` in the tables that `node` describes."""
    if "$ref" in node:
        node = schema["definitions"][node["$ref"].rsplit("/", 1)[1]]
        return below(schema, node, key)
    if key in node.get("properties", {}):
        return node["properties"][key]
    inner = [below(schema, one, key) for one in node.get("anyOf", []) + node.get("allOf", [])]
    return next((one for one in inner if one is not None), None)


def test_init_explains_every_key(pairs) -> None:
    found = list(explained(command("init", "-")))
    named = {key for path, *_ in found for key in path.split(".")}
    for path, value, words in found:
        node = pairs.schema
        for key in path.split("."):
            node = below(pairs.schema, node, key)
            assert node is not None, path
        pairs.evolve(schema=node).validate(value)
        named |= set(value) if isinstance(value, dict) else set()
        # An explanation that names a unit names that of the key.
        units = {"_um": "µm", "_mm": " mm", "_deg": "degrees"}
        if path.endswith(tuple(units)):
            others = [unit for suffix, unit in units.items() if not path.endswith(suffix)]
            assert not any(unit in words for unit in others), (path, words)
    assert set(keys(pairs.schema)) <= named
