"""Pictures."""

import os
from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class Picture:
    """A picture, which notebooks display."""

    svg: str
    """One ``<svg>`` element."""

    def _repr_svg_(self) -> str:
        return self.svg

    def __repr__(self) -> str:
        return f"Picture({len(self.svg)} characters of SVG)"

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write the picture to the file at ``path``, which is replaced."""
        Path(path).write_text(self.svg, encoding="utf-8")
