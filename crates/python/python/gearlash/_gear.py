"""One gear."""

import json
import os
from collections.abc import Mapping
from typing import Any

from gearlash import _core
from gearlash._gauged import Gauged
from gearlash._keys import Pitch, Rack, Runout, Thickness
from gearlash._picture import Picture
from gearlash._stated import Stated


class Gear(Stated[_core.Gear]):
    """A spur or helical gear by its drawing and its measurements.

    The arguments are the keys of ``[wheel]`` in a pair file, checked and refused as those of a file; deviations may be numpy arrays of
    shape (z,), µm, tooth 1 first.

    >>> import numpy as np
    >>> gear = Gear(
    ...     teeth=44, module_mm=3.0, pressure_angle_deg=20.0,
    ...     thickness={"span": {"teeth": 6, "mm": 50.55}},
    ...     runout={"total_um": 30.0, "high_tooth": 7},
    ...     pitch={"kind": "cumulative", "right_um": np.zeros(44), "left_um": np.zeros(44)},
    ... )

    Raises:
        InputError: with everything that is wrong.
    """

    def __init__(
        self,
        *,
        teeth: int,
        module_mm: float | None = None,
        diametral_pitch: float | None = None,
        system: str | None = None,
        pressure_angle_deg: float,
        helix_angle_deg: float | None = None,
        hand: str | None = None,
        face_width_mm: float | None = None,
        face_mm: tuple[float, float] | None = None,
        profile_shift: float | None = None,
        reference_face: str | None = None,
        tip_diameter_mm: float | None = None,
        rack: Rack | None = None,
        scale: float | None = None,
        thickness: Thickness | None = None,
        runout: Runout | None = None,
        pitch: Pitch | None = None,
        profile: Mapping[str, Any] | None = None,
        lead: Mapping[str, Any] | None = None,
        grade: int | None = None,
        expansion_per_k: float | None = None,
        title: str | None = None,
    ) -> None:
        table = {name: value for name, value in locals().items() if name not in ("self", "title")}
        values = {"title": title, "gear": table}
        self._set(self._stated(values))

    @classmethod
    def read(cls, path: str | os.PathLike[str], name: str | None = None) -> "Gear":
        """The gear of a gear file, or the one called ``wheel`` or ``pinion`` of a pair file.

        Raises:
            InputError: with everything that is wrong with the file.
        """
        gear = cls.__new__(cls)
        gear._set(_core.Gear.read(os.fspath(path), name))
        return gear

    def __repr__(self) -> str:
        angle = self.pressure_angle_deg
        wound = f", helix_angle_deg={self.helix_angle_deg:g}" if self.helix_angle_deg else ""
        return f"Gear(teeth={self.teeth}, module_mm={self.module_mm:g}, pressure_angle_deg={angle:g}{wound})"

    def _values(self) -> dict[str, Any]:
        return {"title": self.title, "gear": self.to_dict()}

    @property
    def teeth(self) -> int:
        """z."""
        return self._core.teeth

    @property
    def module_mm(self) -> float:
        """m, or m_n for a helical gear, mm."""
        return self._core.module_mm

    @property
    def pressure_angle_deg(self) -> float:
        """α, or α_n for a helical gear, degrees."""
        return self._core.pressure_angle_deg

    @property
    def helix_angle_deg(self) -> float:
        """β at the reference circle, degrees; 0 for a spur gear."""
        return self._core.helix_angle_deg

    def base_thickness_mm(self, material: str | None = None) -> float:
        """Mean base tooth thickness s_b, mm; by default for the most material, where there are two."""
        return self._core.base_thickness_mm(material)

    def diameters_mm(self, material: str | None = None) -> tuple[float, float, float]:
        """Tip, root form and root diameter, mm."""
        tip, form, root = self._core.diameters_mm(material)
        return tip, form, root

    def gauge(
        self,
        *,
        span_teeth: int | None = None,
        pin_mm: float | None = None,
        ball_mm: float | None = None,
        master_teeth: int | None = None,
        steps_per_pitch: int = 16,
        material: str | None = None,
        threads: int | None = None,
    ) -> Gauged:
        """Measure the gear on its outline as the shop does; what is not given is chosen as ``gearlash gauge`` does.

        ``threads``: as many of its own, or ``None`` for those that all calls share.
        """
        sizes = (span_teeth, pin_mm, ball_mm, master_teeth, steps_per_pitch)
        found = _core.gauge(self._core, sizes, material, threads)
        return Gauged(json.loads(found)["gears"][0])

    def chart(self, material: str | None = None) -> Picture:
        """Pitch, thickness and runout, tooth by tooth."""
        return Picture(_core.inspection(self._core, material))
