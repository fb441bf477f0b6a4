"""Writes keys and values of Python as the text of a gear or pair file, which the library reads and checks."""

import json
import math
import os
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from gearlash._errors import InputError


def text(values: Mapping[str, Any], name: str) -> str:
    """The values as JSON; keys without a value (``None``) are left out. Messages call it ``name``."""
    return json.dumps(_plain(values, "", name), allow_nan=False)


def _plain(value: Any, key: str, name: str) -> Any:
    if isinstance(value, Mapping):
        return {
            str(of): _plain(each, f"{key}.{of}" if key else str(of), name)
            for of, each in value.items()
            if each is not None
        }
    if isinstance(value, (str, bool, int)):
        return value
    if isinstance(value, np.ndarray):
        return _plain(value.tolist(), key, name)
    if isinstance(value, np.generic):
        return _plain(value.item(), key, name)
    if isinstance(value, float):
        if not math.isfinite(value):
            raise _wrong(name, key, repr(value), "is no finite number", "give one")
        return value
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if isinstance(value, Sequence):
        return [_plain(each, key, name) for each in value]
    kind = type(value).__name__
    raise _wrong(name, key, kind, "cannot be a value", "give a number, text, a list, a numpy array or a dict")


def _wrong(name: str, key: str, value: str, reason: str, help: str) -> InputError:
    return InputError(f"{name}: {key} = {value}: {reason}; {help}", ((key, value, reason, help),))
