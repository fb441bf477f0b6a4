"""What goes wrong."""

from typing import NamedTuple


class GearlashError(ValueError):
    """What cannot be computed: a gear or a pair that cannot exist, a tooth or a centre distance that it has not."""


class GearlashWarning(UserWarning):
    """What looks like a slip in a gear or a pair; its values are used as they are."""


class Problem(NamedTuple):
    """One thing that is wrong with one value."""

    key: str
    """Dotted path, such as ``wheel.runout.high_tooth``; empty for the whole file."""
    value: str | None
    """As written."""
    reason: str
    """What is wrong and what is allowed."""
    help: str
    """What to do."""


class InputError(GearlashError):
    """A gear, a pair or a file that says something wrong: all of it at once, a line each."""

    problems: tuple[Problem, ...]
    """Each of them."""

    def __init__(self, text: str, problems: tuple[tuple[str, str | None, str, str], ...] = ()) -> None:
        super().__init__(text)
        self.problems = tuple(Problem(*problem) for problem in problems)

    def __reduce__(self) -> tuple[type["InputError"], tuple[str, tuple[Problem, ...]]]:
        return (type(self), (str(self), self.problems))
