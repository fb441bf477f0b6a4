"use strict";
// Moves the picture of a mesh: turns the gears, marks contacts, zooms and pans, and chooses the section. The
// report and the page that runs the program use it alike. Everything about gears (rotations, contacts, classes, backlash) comes
// in columns of poses; this file only sets transforms and texts. Angles are degrees counter-clockwise, lengths mm, y up.
//
// `data` has the free gear, the words of the columns and the constants of gears that vary along the face. `step` goes to another pose, by arrow
// keys.
function gearlashMesh(data, step) {
  const byId = (name) => document.getElementById("viewer-" + name);
  const root = document.getElementById("viewer");
  const picture = byId("picture");
  const members = ["wheel", "pinion"];
  const sides = ["right", "left"];

  // ---- what is shown: a pose of a run, and the contact the free gear is held in
  const shown = { run: null, pose: 0, side: "right" };
  const run = () => shown.run;
  const value = (column) => run()[column]?.[shown.pose] ?? null;
  let words = data.words;
  const word = (column) => words[column][value(column)];
  const other = { right: "left", left: "right" };
  // The number of a pose, where the page holds only some of a run.
  const numberIn = (run, pose) => run.number?.[pose] ?? pose + 1;

  // The place of the contact on a side in the picture, y down; null without one.
  function contactAt(side) {
    const [x, y] = [value(side + "_x_mm"), value(side + "_y_mm")];
    return x === null ? null : [x, -y];
  }

  function draw() {
    const lost = value("lost_motion_deg") ?? 0;
    const free = value("free_deg") + (shown.side === "left" ? lost : 0);
    const axes = { wheel: 0, pinion: run().center_distance_mm };
    for (const member of members) {
      const turn = member === data.free ? free : value("locked_deg");
      const place = `translate(${axes[member]} 0) rotate(${turn})`;
      byId(member).setAttribute("transform", place);
      byId(member === "wheel" ? "clip-shape" : "overlap").setAttribute("transform", place);
    }
    root.querySelectorAll(".viewer-touching").forEach((number) => number.classList.remove("viewer-touching"));
    for (const side of sides) showContact(side, lost, axes[data.free]);
    showTexts();
    if (data.helical) showSection();
  }

  // The points on the two gears coincide in contact; else the free gear's point is off by the lost motion.
  function showContact(side, lost, axis) {
    const [x, y] = [value(side + "_x_mm"), value(side + "_y_mm")];
    byId(side + "-contact").setAttribute("display", x === null ? "none" : "inline");
    byId(side + "-contact").classList.toggle("viewer-overlapping", value("j_wt_um") < 0);
    if (x === null) return;
    const touches = side === shown.side;
    const back = touches ? 0 : side === "left" ? -lost : lost;
    const place = `translate(${x} ${y})`;
    byId("normal-" + side).parentNode.setAttribute("transform", place);
    byId("normal-" + side).setAttribute("transform", `rotate(${value(side + "_normal_deg")})`);
    for (const gear of ["locked", "free"]) {
      const dot = byId(`${gear}-${side}`);
      dot.classList.toggle("viewer-open", !touches);
      for (const part of dot.children) part.setAttribute("transform", place);
    }
    byId("free-" + side).setAttribute("transform", `rotate(${back} ${axis} 0)`);
    for (const member of members) {
      byId(`${member}-tooth-${value(`${side}_${member}_tooth`)}`)?.classList.add("viewer-touching");
    }
  }

  // ---- texts
  const TEXTS = ["pose", "status", "backlash", "overlapping", "bound", "right", "left"];
  function showTexts() {
    byId("run").textContent = run().label;
    for (const name of TEXTS) byId(name).textContent = word(name + "_text");
    byId("backlash").dataset.um = value("j_wt_um") ?? "";
  }

  // ---- the section: turns the outlines and their numbers by the twist of the teeth, about the gears' own
  // centres, which do not wind
  function showSection() {
    const slider = byId("section");
    const z = (byId("section-follow").checked ? value(shown.side + "_section_mm") : null) ?? Number(slider.value);
    slider.value = z;
    byId("section-at").value = slider.value;
    byId("section-contacts").textContent = word("section-contacts_text");
    members.forEach((member, i) => {
      const twist = data.helical.twist_deg_a_mm[i] * z;
      for (const part of root.querySelectorAll(`[data-winds="${member}"]`)) {
        const [x, y] = part.dataset.centre.split(" ");
        part.setAttribute("transform", part.dataset.then === undefined
          ? `translate(${x} ${y}) rotate(${twist})`
          : `rotate(${twist} ${x} ${y}) ${part.dataset.then}`);
      }
    });
    for (const side of sides) {
      const at = value(side + "_section_mm");
      const here = at !== null && Math.abs(at - z) < 5e-3;
      byId(side + "-contact").setAttribute("opacity", here ? 1 : 0.3);
    }
  }

  // ---- zoom and pan: the viewBox
  const box = (name) => picture.dataset[name].split(" ").map(Number);
  const home = box("home");
  const NARROWEST = Math.min(Number(picture.dataset.narrowest), home[2]);
  const WIDEST = box("whole")[2] * 2;
  let view = home;

  function look(to) {
    view = to;
    picture.setAttribute("viewBox", view.join(" "));
    showScale();
    showDashes();
  }

  // Draws only the visible part of the dashed lines, within `reach` of the middle. Invisible dashes cost the browser as much
  // as visible ones, and dashes keep their length on the screen. On paper the picture has another shape.
  const PIECES = 128;
  function showDashes() {
    const box = picture.getBoundingClientRect();
    const scale = picture.getScreenCTM().a;
    const reach = Math.hypot(box.width, box.height) / scale;
    const middle = [view[0] + view[2] / 2, -(view[1] + view[3] / 2)];
    const [from, to] = [middle[0] - reach, middle[0] + reach].map((x) => Math.min(Math.max(x, 0), run().center_distance_mm));
    byId("centres").setAttribute("d", from < to && Math.abs(middle[1]) < reach ? `M${from} 0H${to}` : "");
    // Keeps the dashes in place when the ends of the line change.
    byId("centres").setAttribute("stroke-dashoffset", from * scale % 38);
    members.forEach((member, i) => {
      const r = run().pitch_radius_mm[i];
      const [x, y] = [middle[0] - i * run().center_distance_mm, middle[1]];
      const away = Math.hypot(x, y);
      // The half angle h of the arc by sin² h/2, which does not cancel where the reach is far below the radius.
      const square = (reach ** 2 - (away - r) ** 2) / (4 * away * r);
      const half = square >= 1 || away === 0 ? Math.PI : square > 0 ? 2 * Math.asin(Math.sqrt(square)) : 0;
      const first = half < Math.PI ? Math.atan2(y, x) - half : 0;
      const spots = Array.from({ length: PIECES + 1 }, (_, k) => first + 2 * half * k / PIECES)
        .map((angle) => `${r * Math.cos(angle)} ${r * Math.sin(angle)}`);
      const circle = byId("pitch-" + member);
      circle.setAttribute("d", half > 0 ? "M" + spots.join("L") : "");
      circle.setAttribute("stroke-dashoffset", first * r * scale % 22);
    });
  }

  // Width of the picture on the screen, in millimetres.
  function showScale() {
    const wide = picture.getBoundingClientRect().width / picture.getScreenCTM().a;
    byId("scale").textContent = `${wide.toPrecision(3)} mm wide`;
  }

  const inView = (at) => at && at[0] > view[0] && at[0] < view[0] + view[2] && at[1] > view[1] && at[1] < view[1] + view[3];

  // The side of the contact about which keys and buttons zoom: the shown one, or else the other, where it is in view.
  const heldSide = () => [shown.side, other[shown.side]].find((side) => inView(contactAt(side)));
  const held = () => { const side = heldSide(); return side && { side, at: contactAt(side) }; };

  // ---- to another pose; another run has other outlines, axes and circles
  function show(run, pose, wordsOfRun = data.words) {
    const before = shown.run && held();
    const isOther = shown.run !== run;
    words = wordsOfRun;
    shown.run = run;
    shown.pose = pose;
    if (isOther) {
      root.querySelectorAll("[data-outline]").forEach((use) => {
        use.setAttribute("href", `#viewer-${use.dataset.outline}-${run.outlines}`);
      });
      members.forEach((member, i) => {
        byId("pitch-" + member).setAttribute("transform", `translate(${i * run.center_distance_mm} 0)`);
      });
    }
    draw();
    follow(before);
    if (isOther) {
      showScale();
      showDashes();
    }
  }

  // A close view follows the contact from pose to pose.
  const NEAR = home[2] / 8;
  function follow(before) {
    const now = before && contactAt(before.side);
    if (now && view[2] < NEAR) pan(now[0] - before.at[0], now[1] - before.at[1]);
  }

  // The other flank's gap, or the overlap there, a quarter of the picture wide.
  function lookAtGap() {
    const at = contactAt(other[shown.side]);
    if (!at) return;
    const width = Math.min(Math.max(Math.abs(value("j_wt_um")) / 1000 * 4, NARROWEST), home[2]);
    const height = width * home[3] / home[2];
    look([at[0] - width / 2, at[1] - height / 2, width, height]);
  }

  // `at`: the fixed place, in units of the viewBox.
  function zoom(factor, at = held()?.at ?? [view[0] + view[2] / 2, view[1] + view[3] / 2]) {
    const width = Math.min(Math.max(view[2] / factor, NARROWEST), WIDEST);
    const part = width / view[2];
    look([at[0] + (view[0] - at[0]) * part, at[1] + (view[1] - at[1]) * part, width, view[3] * part]);
  }

  function pan(right, down) {
    look([view[0] + right, view[1] + down, view[2], view[3]]);
  }

  function placeIn(svg, event) {
    const place = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [place.x, place.y];
  }

  const pointers = new Map();
  const spread = () => {
    const [a, b] = [...pointers.values()];
    return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
  };

  function drag(event) {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    if (pointers.size === 1) {
      const [from, to] = [placeIn(picture, before), placeIn(picture, event)];
      pan(from[0] - to[0], from[1] - to[1]);
    }
    const two = pointers.size === 2;
    const apart = two ? spread() : 0;
    pointers.set(event.pointerId, event);
    // Two fingers on one spot give no ratio.
    if (two && apart > 0 && spread() > 0) {
      const [a, b] = [...pointers.values()].map((pointer) => placeIn(picture, pointer));
      zoom(spread() / apart, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
    }
  }

  picture.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    pointers.set(event.pointerId, event);
    picture.setPointerCapture(event.pointerId);
  });
  picture.addEventListener("pointermove", drag);
  for (const end of ["pointerup", "pointercancel"]) {
    picture.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  // A notch of a mouse's wheel is 100 pixels or so or 3 lines: a fifth. A trackpad sends many small steps.
  const PIXELS_A_STEP = [1, 33, 800];
  const NOTCH = 100;
  picture.addEventListener("wheel", (event) => {
    if (Math.abs(event.deltaY) <= Math.abs(event.deltaX)) return; // the page's own
    event.preventDefault();
    const pixels = event.deltaY * PIXELS_A_STEP[event.deltaMode];
    zoom(Math.exp(-0.2 * Math.min(Math.max(pixels / NOTCH, -1), 1)), placeIn(picture, event));
  }, { passive: false });

  // ---- keys: anywhere in the viewer, but arrows stay with the slider and the lists
  const ZOOM = 1.5;
  const keys = {
    "+": () => zoom(ZOOM), "=": () => zoom(ZOOM), "-": () => zoom(1 / ZOOM), "0": () => look(box("home")),
    ArrowLeft: () => step(-1), ArrowRight: () => step(1),
  };
  const shifted = {
    "+": keys["+"],
    ArrowLeft: () => pan(-view[2] / 10, 0), ArrowRight: () => pan(view[2] / 10, 0),
    ArrowUp: () => pan(0, -view[3] / 10), ArrowDown: () => pan(0, view[3] / 10),
  };
  root.addEventListener("keydown", (event) => {
    const typed = event.target.matches("input, select") && event.key.startsWith("Arrow");
    const act = (event.shiftKey ? shifted : keys)[event.key];
    if (!act || typed || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    act();
  });

  // ---- controls
  root.querySelectorAll("[name=viewer-side]").forEach((radio) => radio.addEventListener("change", () => {
    shown.side = radio.value;
    draw();
  }));
  const clicks = {
    in: () => zoom(ZOOM), out: () => zoom(1 / ZOOM), home: () => look(box("home")), whole: () => look(box("whole")), gap: lookAtGap,
  };
  for (const [name, act] of Object.entries(clicks)) byId(name).addEventListener("click", act);
  picture.setAttribute("tabindex", "0");
  picture.setAttribute("role", "application");
  root.classList.add("viewer-js");
  byId("controls").hidden = false;
  // A browser may keep a radio as it was before a reload.
  shown.side = root.querySelector("[name=viewer-side]:checked")?.value ?? "right";
  if (data.helical) {
    const slider = byId("section");
    [slider.min, slider.max] = data.helical.face_mm;
    slider.value = data.helical.start_mm;
    const chosen = () => { byId("section-follow").checked = false; showSection(); };
    slider.addEventListener("input", chosen);
    byId("section-at").addEventListener("change", ({ target }) => { slider.value = target.value; chosen(); });
    // The field has it.
    byId("section-here").hidden = true;
    byId("section-follow").addEventListener("change", showSection);
    byId("section-row").hidden = false;
  }
  new ResizeObserver(() => { if (shown.run && picture.isConnected) { showScale(); showDashes(); } }).observe(picture);
  return { show, placeIn, numberIn };
}
