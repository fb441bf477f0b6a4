"use strict";
// The section of helical gears that the viewer shows: turns the outlines and their numbers by the twist of the teeth, about the
// gears' own centres, which do not wind. Twist, face and where each contact is come from #viewer-data. Angles are degrees, lengths mm.
(() => {
  const byId = (name) => document.getElementById("viewer-" + name);
  const { helical, runs } = JSON.parse(byId("data").textContent);
  const [slider, follow, text] = ["section", "section-follow", "section-text"].map(byId);
  const members = ["wheel", "pinion"];
  const sides = ["right", "left"];
  const mm = (place) => `${Number(place.toFixed(2))} mm`.replace("-", "−");

  // The place of contact of the shown pose; null without a contact.
  const touches = (side) => runs[Number(byId("runs").value)][side + "_section_mm"]?.[Number(byId("slider").value)] ?? null;
  const heldSide = () => document.querySelector("[name=viewer-side]:checked").value;

  function show(z) {
    slider.value = z;
    byId("section-at").textContent = "z = " + mm(z);
    slider.setAttribute("aria-valuetext", mm(z));
    members.forEach((member, i) => {
      const twist = helical.twist_deg_a_mm[i] * z;
      for (const part of document.querySelectorAll(`[data-winds="${member}"]`)) {
        const [x, y] = part.dataset.centre.split(" ");
        part.setAttribute("transform", part.dataset.then === undefined
          ? `translate(${x} ${y}) rotate(${twist})`
          : `rotate(${twist} ${x} ${y}) ${part.dataset.then}`);
      }
    });
    const where = sides.map((side) => {
      const at = touches(side);
      const here = at !== null && Math.abs(at - z) < 5e-3;
      byId(side + "-contact").setAttribute("opacity", here ? 1 : 0.3);
      return at === null ? `no ${side} contact` : `${side} contact at z = ${mm(at)}`;
    });
    text.textContent = `Drawn in the section at z = ${mm(z)}. ${where[0][0].toUpperCase()}${where[0].slice(1)}, ${where[1]}; pale where it is in another section.`;
  }

  function update() {
    const at = follow.checked ? touches(heldSide()) : null;
    show(at ?? Number(slider.value));
  }

  [slider.min, slider.max] = helical.face_mm;
  slider.addEventListener("input", () => { follow.checked = false; show(Number(slider.value)); });
  follow.addEventListener("change", update);
  // viewer.js writes the name of each pose that it shows.
  new MutationObserver(update).observe(byId("pose"), { childList: true });
  slider.value = helical.start_mm;
  byId("section-row").hidden = false;
  update();
})();
