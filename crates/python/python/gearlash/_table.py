"""Columns as a table of pandas or Arrow, where these are installed."""

from abc import abstractmethod
from collections.abc import Callable, Iterable, Mapping
from dataclasses import fields
from importlib import import_module
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np

if TYPE_CHECKING:
    import pandas
    import pyarrow

Codes = tuple[np.ndarray[Any, Any], tuple[str, ...]]
"""Numbers, and their words."""

T = TypeVar("T")


def taken(cls: Callable[..., T], record: Mapping[str, Any], /, **own: Any) -> T:
    """A dataclass with the fields ``own``; all others are values of ``record`` under their names, ``None`` where it has none."""
    names = (field.name for field in fields(cls) if field.name not in own)  # type: ignore[arg-type]
    return cls(**{name: record.get(name) for name in names}, **own)


def columns_of(records: Iterable[Mapping[str, Any]]) -> dict[str, "np.ndarray[Any, Any] | Codes"]:
    """The columns of rows as results have them: words as :data:`Codes`, whole numbers as integers, other numbers with NaN for null."""
    rows = list(records)

    def column(values: list[Any]) -> "np.ndarray[Any, Any] | Codes":
        if any(isinstance(value, str) for value in values):
            names = tuple(dict.fromkeys(values))
            places = {name: place for place, name in enumerate(names)}
            return np.array([places[value] for value in values], dtype=np.int32), names
        if values and all(isinstance(value, int) for value in values):
            return np.array(values, dtype=np.int64)
        return np.array(values, dtype=float)

    return {name: column([row[name] for row in rows]) for name in (rows[0] if rows else ())}


def needed(package: str, extra: str, what: str) -> Any:
    """The package, or an error that names it if it is missing."""
    try:
        return import_module(package)
    except ModuleNotFoundError as missing:
        if missing.name != package:
            raise
        text = f"{what} needs {package}: pip install {package}, or gearlash[{extra}]"
        raise ModuleNotFoundError(text, name=package) from None


class Table:
    """Columns of equal length."""

    @abstractmethod
    def columns(self) -> dict[str, "np.ndarray[Any, Any] | Codes"]:
        """The columns by name."""

    def to_pandas(self) -> "pandas.DataFrame":
        """The columns as a ``pandas.DataFrame``; words as categories. Needs pandas."""
        pandas = needed("pandas", "pandas", "to_pandas")

        def column(values: "np.ndarray[Any, Any] | Codes") -> Any:
            if isinstance(values, tuple):
                return pandas.Categorical.from_codes(values[0], list(values[1]))
            return values

        frame = {name: column(values) for name, values in self.columns().items()}
        return pandas.DataFrame(frame)

    def to_arrow(self) -> "pyarrow.Table":
        """The columns as a ``pyarrow.Table``: NaN as null, words as a dictionary. Needs pyarrow."""
        arrow = needed("pyarrow", "arrow", "to_arrow")

        def column(values: "np.ndarray[Any, Any] | Codes") -> Any:
            if isinstance(values, tuple):
                few = len(values[1]) <= np.iinfo(np.int8).max
                codes = arrow.array(values[0].astype(np.int8 if few else np.int32))
                return arrow.DictionaryArray.from_arrays(codes, list(values[1]))
            return arrow.array(values, from_pandas=True)

        columns = {name: column(values) for name, values in self.columns().items()}
        return arrow.table(columns)

    def __arrow_c_stream__(self, requested_schema: object = None) -> object:
        """The columns for any program that reads Arrow (polars, duckdb, …). Needs pyarrow."""
        return self.to_arrow().__arrow_c_stream__(requested_schema)
