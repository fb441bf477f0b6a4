// Steps the mesh of a report through the poses of a run, and keeps the chart's cursor with it.
(() => {
  const byId = (name) => document.getElementById("viewer-" + name);
  const data = JSON.parse(byId("data").textContent);
  const root = document.getElementById("viewer");
  const slider = byId("slider");
  const { show, placeIn, numberIn } = gearlashMesh(data, step);
  const shown = { run: data.start[0], pose: data.start[1] };
  const run = () => data.runs[shown.run];
  const poses = () => run().pose_text.length;
  const poseNumber = () => numberIn(run(), shown.pose);

  // ---- stepping
  function choosePose(pose) {
    shown.pose = Math.min(Math.max(pose, 0), poses() - 1);
    show(run(), shown.pose);
    slider.value = shown.pose;
    slider.setAttribute("aria-valuetext", byId("pose").textContent);
    showCursor();
  }

  // Shows the same pose of another run, or the nearest one in the page.
  function samePose(number) {
    const wanted = poseNumber();
    const off = (pose) => Math.abs(numberIn(data.runs[number], pose) - wanted);
    return data.runs[number].pose_text.reduce((best, _, pose) => (off(pose) < off(best) ? pose : best), 0);
  }

  function chooseRun(number, pose) {
    shown.run = number;
    byId("runs").value = number;
    slider.max = poses() - 1;
    for (const control of [slider, ...["back", "on", "play"].map(byId)]) control.disabled = poses() === 1;
    choosePose(pose);
  }

  let playing = null;
  const MILLISECONDS_A_POSE = 80;
  function play(on) {
    clearInterval(playing);
    playing = on ? setInterval(() => choosePose((shown.pose + 1) % poses()), MILLISECONDS_A_POSE) : null;
    const button = byId("play");
    button.textContent = on ? "Pause" : "Play";
    button.setAttribute("aria-pressed", on);
    // A screen reader cannot keep up with a running picture.
    byId("backlash").setAttribute("aria-live", on ? "off" : "polite");
  }

  function step(by) {
    play(false);
    choosePose(shown.pose + by);
  }

  // ---- charts: a cursor at the pose, and a click to the nearest pose
  // The page contains each curve twice: for a wide and for a narrow screen.
  const drawn = (each) => ["", "-narrow"].map((width) => each.chart && document.getElementById(each.chart + width)).filter(Boolean);
  const charts = new Map();
  data.runs.forEach((each, number) => {
    for (const svg of drawn(each)) charts.set(svg, [...(charts.get(svg) ?? []), number]);
  });
  const cursors = new Map([...charts.keys()].map((svg) => {
    const cursor = document.createElementNS("http://www.w3.org/2000/svg", "line");
    cursor.setAttribute("class", "viewer-cursor");
    return [svg, cursor];
  }));

  const frame = (svg) => Object.fromEntries(
    ["left", "right", "top", "bottom", "x0", "x1", "y0", "y1"].map((name) => [name, Number(svg.dataset[name])]));

  const place = () => run().chart_x[shown.pose] ?? null;

  function showCursor() {
    cursors.forEach((cursor) => cursor.remove());
    byId("no-curve").hidden = drawn(run()).length > 0;
    if (place() === null) return;
    for (const svg of drawn(run())) {
      const f = frame(svg);
      const x = f.left + (place() - f.x0) / (f.x1 - f.x0) * (f.right - f.left);
      const cursor = cursors.get(svg);
      for (const [name, at] of [["x1", x], ["x2", x], ["y1", f.top], ["y2", f.bottom]]) cursor.setAttribute(name, at);
      // Labels stay readable above it.
      svg.insertBefore(cursor, svg.querySelector(".gearlash-labels"));
    }
  }

  // A cursor in a collapsed curve would be invisible.
  function unfoldCurve() {
    const folded = document.getElementById(run().chart)?.closest("details:not([open])");
    if (folded) folded.open = true;
  }

  // Takes the horizontally nearest pose of each curve (a run and a flank); among these, the one with the backlash nearest to
  // the click.
  function jump(svg, event) {
    const f = frame(svg);
    const [left, down] = placeIn(svg, event);
    const x = f.x0 + (left - f.left) / (f.right - f.left) * (f.x1 - f.x0);
    const y = f.y0 + (f.bottom - down) / (f.bottom - f.top) * (f.y1 - f.y0);
    const nearest = [];
    for (const number of charts.get(svg)) {
      const { chart_x, j_wt_um, flank } = data.runs[number];
      for (const one of new Set(flank)) {
        let best = null;
        chart_x.forEach((place, pose) => {
          if (place === null || flank[pose] !== one) return;
          const across = Math.abs(place - x);
          if (!best || across < best.across) {
            best = { number, pose, across, up: j_wt_um[pose] === null ? Infinity : Math.abs(j_wt_um[pose] - y) };
          }
        });
        if (best) nearest.push(best);
      }
    }
    const [best] = nearest.sort((a, b) => (a.up === b.up ? a.across - b.across : a.up - b.up));
    if (!best) return;
    play(false);
    chooseRun(best.number, best.pose);
  }

  for (const svg of charts.keys()) {
    svg.classList.add("viewer-charted");
    svg.addEventListener("click", (event) => jump(svg, event));
  }

  // ---- controls
  data.runs.forEach((each, number) => byId("runs").add(new Option(each.label, number)));
  byId("runs").addEventListener("change", (event) => {
    const number = Number(event.target.value);
    chooseRun(number, samePose(number));
    unfoldCurve();
  });
  slider.addEventListener("input", () => { play(false); choosePose(Number(slider.value)); });
  const clicks = { back: () => step(-1), on: () => step(1), play: () => play(playing === null) };
  for (const [name, act] of Object.entries(clicks)) byId(name).addEventListener("click", act);
  chooseRun(shown.run, shown.pose);
})();
