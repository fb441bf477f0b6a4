"""A gear measured on its outline."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash._errors import GearlashError

Floats = NDArray[np.float64]


class Gauged:
    """The gauges' readings on the outline of a gear of z teeth: arrays of shape (z,), tooth 1 first.

    A reading that could not be taken raises :class:`GearlashError` with the reason.
    """

    def __init__(self, record: dict[str, Any]) -> None:
        self.record = record
        """The gear as in ``gearlash gauge --format json``, with error bounds, profiles, grades and the roll test's poses."""

    def _read(self, name: str) -> Any:
        read = self.record[name]
        if isinstance(read, dict) and "not_measured" in read:
            raise GearlashError(f"{name}: not measured: {read['not_measured']}")
        return read

    def _rows(self, name: str, key: str, rows: str = "readings") -> Floats:
        return np.array([row[key] for row in self._read(name)[rows]], dtype=np.float64)

    @property
    def material(self) -> str:
        """``most``, ``least`` or ``as-measured``."""
        return str(self.record["material"])

    @property
    def span_teeth(self) -> int:
        """k, teeth spanned."""
        return int(self._read("spans")["teeth"])

    @property
    def spans_mm(self) -> Floats:
        """Span W_k from each first tooth, mm."""
        return self._rows("spans", "mm")

    @property
    def pin_mm(self) -> float:
        """Diameter of the pins, mm."""
        return float(self._read("pins")["pin_mm"])

    @property
    def over_pins_mm(self) -> Floats:
        """Dimension over two pins, the first in the space after each tooth, mm."""
        return self._rows("pins", "mm", "two")

    @property
    def runout_um(self) -> float:
        """Runout F_r, µm."""
        return float(self._read("runout")["total_um"])

    @property
    def ball_radius_mm(self) -> Floats:
        """Distance of the runout's ball, in the space after each tooth, from the rotation axis, mm."""
        return self._rows("runout", "radius_mm")

    @property
    def thickness_mm(self) -> Floats:
        """Tooth thickness at the reference circle, an arc, mm."""
        return np.array(self._read("thickness")["arc_mm"], dtype=np.float64)

    def pitch_um(self, flank: str, axis: str = "own", kind: str = "cumulative") -> Floats:
        """Pitch deviation of the gear's own ``right`` or ``left`` flanks, µm.

        ``axis``: about the gear's ``own`` centre or the ``datum`` axis; ``kind``: ``cumulative`` or ``single``.
        """
        for name, value, allowed in (
            ("flank", flank, ("right", "left")),
            ("axis", axis, ("own", "datum")),
            ("kind", kind, ("cumulative", "single")),
        ):
            if value not in allowed:
                raise GearlashError(f'{name} = {value!r}: "{allowed[0]}" or "{allowed[1]}"')
        return np.array(self._read(f"pitch_{axis}")[flank][f"{kind}_um"], dtype=np.float64)

    @property
    def roll_um(self) -> tuple[float, float]:
        """Double-flank roll test: F_i'' and f_i'', µm."""
        roll = self._read("roll")
        return float(roll["total_um"]), float(roll["tooth_to_tooth_um"])
