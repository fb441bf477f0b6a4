"""Errors."""

from typing import NamedTuple


class GearlashError(ValueError):
    """A value that cannot be computed: a gear or a pair that cannot exist, a tooth or a centre distance that it does not have."""


class GearlashWarning(UserWarning):
    """A likely slip in a gear or a pair; its values are used unchanged."""


class Problem(NamedTuple):
    """One fault of one value."""

    key: str
    """Dotted path, such as ``wheel.runout.high_tooth``; empty for the whole file."""
    value: str | None
    """As written."""
    reason: str
    """The fault, and the allowed values."""
    help: str
    """The remedy."""


class InputError(GearlashError):
    """A gear, a pair or a file with faults: all of them, one line each."""

    problems: tuple[Problem, ...]
    """Each of them."""

    def __init__(self, text: str, problems: tuple[tuple[str, str | None, str, str], ...] = ()) -> None:
        super().__init__(text)
        self.problems = tuple(Problem(*problem) for problem in problems)

    def __reduce__(self) -> tuple[type["InputError"], tuple[str, tuple[Problem, ...]]]:
        return (type(self), (str(self), self.problems))


def one_of(name: str, value: str, *allowed: str) -> None:
    """Refuses a value that is not allowed."""
    if value not in allowed:
        names = [f'"{each}"' for each in allowed]
        raise GearlashError(f"{name} = {value!r}: {', '.join(names[:-1])} or {names[-1]}")
