"""A gear measured on its outline."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from gearlash._errors import GearlashError, one_of

Floats = NDArray[np.float64]


class Gauged:
    """The gauges' readings on the outline of a gear of z teeth: arrays of shape (z,), tooth 1 first.

    A reading that could not be taken raises :class:`GearlashError` with the reason.
    """

    def __init__(self, record: dict[str, Any]) -> None:
        self.record = record
        """The gear as in ``gearlash gauge --format json``, with error bounds, profiles, grades and the roll test's poses."""

    def _read(self, name: str, record: dict[str, Any] | None = None) -> Any:
        read = (record or self.record)[name]
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
        one_of("flank", flank, "right", "left")
        one_of("axis", axis, "own", "datum")
        one_of("kind", kind, "cumulative", "single")
        return np.array(self._read(f"pitch_{axis}")[flank][f"{kind}_um"], dtype=np.float64)

    def lead_um(self, flank: str, axis: str = "own", kind: str = "helix_slope") -> Floats:
        """Lead deviation of the gear's own ``right`` or ``left`` flanks, µm, of a gear that deviates along the face.

        ``axis``: as of :meth:`pitch_um`; ``kind``: ``helix_slope`` f_Hβ, ``crowning`` C_β, ``form`` f_fβ or ``total`` F_β.
        """
        one_of("flank", flank, "right", "left")
        one_of("axis", axis, "own", "datum")
        one_of("kind", kind, "helix_slope", "crowning", "form", "total")
        if not self.record.get("along_face"):
            raise GearlashError("leads: the gear does not deviate along the face")
        read = self._read(f"lead_{axis}", self.record["along_face"])
        return np.array(read[flank][f"{kind}_um"], dtype=np.float64)

    @property
    def roll_um(self) -> tuple[float, float]:
        """Double-flank roll test: F_i'' and f_i'', µm."""
        roll = self._read("roll")
        return float(roll["total_um"]), float(roll["tooth_to_tooth_um"])
