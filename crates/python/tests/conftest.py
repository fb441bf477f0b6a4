"""Common parts of the tests: the repository's fixtures, and the numbers of the command itself."""

import json
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

FIXTURES = Path(__file__).parents[3] / "fixtures"

# The data of a gear without deviations.
GEAR = {"teeth": 20, "module_mm": 2.0, "pressure_angle_deg": 20.0}


@pytest.fixture
def fixtures() -> Path:
    return FIXTURES


def command(*words: object, code: int = 0) -> str:
    """The standard output of the command."""
    words_ = [str(word) for word in words]
    ran = subprocess.run([sys.executable, "-m", "gearlash", *words_], capture_output=True, text=True)
    assert ran.returncode == code, ran.stderr
    return ran.stdout


def of_command(*words: object) -> Any:
    """The JSON that the command prints."""
    return json.loads(command(*words))
