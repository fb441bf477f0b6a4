"""The common part of a gear and a pair: stated with the keys of a file, and checked by the library."""

import json
import warnings
from collections.abc import Mapping
from typing import Any, Generic, TypeVar

from gearlash import _core
from gearlash._errors import GearlashWarning
from gearlash._text import text

Core = TypeVar("Core", _core.Gear, _core.Pair)
S = TypeVar("S", bound="Stated[Any]")


class Stated(Generic[Core]):
    """A gear or a pair."""

    _core: Core

    def _set(self, core: Core) -> None:
        self._core = core
        for warning in core.warnings:
            warnings.warn(warning, GearlashWarning, stacklevel=3)

    @classmethod
    def _made(cls: type[S], core: Core) -> S:
        made = cls.__new__(cls)
        made._core = core
        return made

    @classmethod
    def _stated(cls, values: Mapping[str, Any]) -> Any:
        """The Rust side of what ``values`` state, with the keys of a file."""
        return getattr(_core, cls.__name__).from_text(cls.__name__, text(values, cls.__name__))

    def _values(self) -> dict[str, Any]:
        """What states it again."""
        return self.to_dict()

    def __reduce__(self) -> tuple[Any, ...]:
        return (_restored, (type(self), self._values()))

    @property
    def title(self) -> str:
        """The title in pictures."""
        return self._core.title

    @property
    def materials(self) -> list[str]:
        """``as-measured`` alone, or ``most`` and ``least`` for a thickness with tolerance."""
        return self._core.materials

    @property
    def warnings(self) -> list[str]:
        """Likely slips."""
        return self._core.warnings

    @property
    def remarks(self) -> list[str]:
        """Notes."""
        return self._core.remarks

    def to_dict(self) -> dict[str, Any]:
        """The gear or the pair as understood: keys of its file, defaults filled in."""
        return dict(json.loads(self._core.spec()))


def _restored(kind: "type[Stated[Any]]", values: dict[str, Any]) -> "Stated[Any]":
    return kind._made(kind._stated(values))
