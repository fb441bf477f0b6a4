"use strict";
// Lays out what gearlash answers. Numbers, sentences and pictures come from the program in the workers; this file moves them.
(() => {
  // The page as it was sent, to save it with another pair.
  const source = "<!doctype html>\n" + document.documentElement.outerHTML;
  const byId = (id) => document.getElementById(id);
  const make = (tag, text, properties = {}) => Object.assign(document.createElement(tag), text === undefined ? {} : { textContent: text }, properties);
  const examples = JSON.parse(byId("example-files").textContent);
  const own = JSON.parse(byId("own").textContent);

  // ---- the program, in three workers: long work; poses; and whole cycles while the slider moves, for which no pose waits
  const workers = {};
  // The fault of calls whose worker was ended for newer work.
  const STOPPED = Symbol("stopped");
  let module = null;
  let calls = 0;

  // The bytes of a text by crates/web/build: 86 digits of base 126, the lowest first, are 75 bytes, of which the first three are their number.
  function bytesOf(text) {
    const bytes = new Uint8Array((text.length / 86) * 75);
    const parts = new Uint32Array(25);
    for (let block = 0; block * 86 < text.length; block++) {
      parts.fill(0);
      for (let at = 85; at >= 0; at--) {
        const code = text.charCodeAt(block * 86 + at);
        let carry = code - (code > 13 ? 2 : 1);
        const used = Math.min(25, Math.ceil(((86 - at) * 7) / 24));
        for (let part = 0; part < used; part++) {
          carry += parts[part] * 126;
          parts[part] = carry & 0xffffff;
          carry >>>= 24;
        }
      }
      for (let byte = 0; byte < 75; byte++) bytes[block * 75 + byte] = parts[(byte / 3) | 0] >> (8 * (byte % 3));
    }
    const length = bytes[0] + 256 * bytes[1] + 65536 * bytes[2];
    return bytes.subarray(3, 3 + length);
  }

  async function unpacked(text) {
    const packed = bytesOf(text);
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
  }

  const url = URL.createObjectURL(new Blob([byId("worker").textContent], { type: "text/javascript" }));
  function begin(name) {
    workers[name]?.worker.terminate();
    for (const call of workers[name]?.waiting.values() ?? []) call.failed(STOPPED);
    const worker = new Worker(url);
    const waiting = new Map();
    worker.onmessage = ({ data }) => {
      if (data.progress) return name === "long" && showProgress(data.progress);
      const call = waiting.get(data.id);
      waiting.delete(data.id);
      if (data.fault === undefined) return call.done(data.answer);
      const fails = () => call.failed(new Error(data.fault));
      // A panic leaves the program in no known state: the next call meets a new one.
      if (call.begun) begin(name).then(fails, fails);
      else fails();
    };
    workers[name] = { worker, waiting };
    return ask(name, "start", module);
  }

  function ask(name, call, ...args) {
    const { worker, waiting } = workers[name];
    return new Promise((done, failed) => {
      const id = ++calls;
      waiting.set(id, { done, failed, begun: call !== "start" });
      worker.postMessage({ id, call, args });
    });
  }

  // A worker that is still busy, with marks say, is ended for newer work.
  const free = async (name) => { if (workers[name].waiting.size > 0) await begin(name); };
  const answer = async (name, call, ...args) => JSON.parse(await ask(name, call, ...args));

  const onClick = (name, act) => byId(name).addEventListener("click", () => quietly(act()));
  // Work that newer work may end.
  const quietly = (work) => work.catch((fault) => { if (fault !== STOPPED) fail(fault); });
  // Words of the page that need no program stand in its HTML.
  const words = (id, name = "words") => byId(id).dataset[name];
  function fail(fault) {
    for (const timer of [lagging, resting, settling]) clearTimeout(timer);
    showProblems([{ reason: `${words("problem-list", "fault")} ${fault.message}`, help: words("problem-list", "report"), link: byId("report")?.href }]);
  }
  const say = async (what, names = "") => {
    const { problems, title } = await answer("live", "said", what, names);
    showProblems(problems, title);
  };

  // ---- files: names and bytes; one of them is the pair file in the editor
  const files = new Map();
  let main = "pair.toml";
  // The files that the pair file names, as the program reads it. Before its first answer all may be named.
  let named = new Set();
  const isNamed = (name, among = named) => among.has(name.toLowerCase());
  const small = (each) => new Set([...each].map((name) => name.toLowerCase()));
  const text = byId("text");
  const isText = (name) => /\.(toml|json)$/i.test(name);
  const isDrawing = (name) => /\.(dxf|svg)$/i.test(name);
  // A link holds the text of the pair in its fragment, which browsers never send.
  const LINK = "#pair=";
  let inLink = null;
  const isJson = (text) => text.trimStart().startsWith("{");
  const decoded = (bytes) => new TextDecoder("utf-8", { fatal: true }).decode(bytes);

  // The text as it was opened or saved.
  let saved = "";
  const write = (content) => {
    text.focus();
    text.select();
    // The browser can undo it.
    if (!document.execCommand("insertText", false, content)) text.value = content;
  };

  function edit(name) {
    main = name;
    named = small(files.keys());
    noted = null;
    text.value = decoded(files.get(name));
    // As the editor has it: with its own ends of lines.
    saved = text.value;
    byId("text-label").textContent = name;
    byId("understood").hidden = true;
    edited();
    listFiles();
  }

  // Numbers of lines are layout, as the lines are.
  function number() {
    const lines = text.value.split("\n").length;
    byId("lines").textContent = Array.from({ length: lines }, (_, i) => i + 1).join("\n");
  }

  function listFiles() {
    const buttons = () => [...byId("files").querySelectorAll("button")];
    const focused = buttons().indexOf(document.activeElement);
    byId("files").replaceChildren(...[...files.keys()].map((name) => {
      const isMain = name === main;
      const item = make("li", name, { className: isMain ? "now" : "" });
      if (!isMain && !isNamed(name)) item.append(" ", make("span", words("files", "unused"), { className: "grey" }));
      const out = make("button", "×", { type: "button" });
      out.setAttribute("aria-label", `Remove ${name}`);
      out.addEventListener("click", () => {
        files.delete(name);
        byId("understood").hidden = true;
        if (isMain) {
          byId("examples").value = "";
          files.set("pair.toml", new Uint8Array());
          edit("pair.toml");
          named.clear();
        }
        if (isMain || (isDrawing(name) && !isNamed(name))) quietly(useDrawings());
        else calculate();
      });
      item.append(" ", out);
      return item;
    }));
    // Where the button with the focus left, the next one has it.
    if (focused >= 0) (buttons()[focused] ?? buttons().at(-1) ?? byId("open")).focus();
  }

  // The text whose files are all known.
  let noted = null;
  // With problems, it may name the files of its last answer too.
  const note = ({ problems, files }, of) => {
    named = small([...(problems ? named : []), ...files]);
    noted = problems ? null : of;
  };
  async function noteNames() {
    const content = text.value;
    files.set(main, new TextEncoder().encode(content));
    await send("live");
    if (content !== noted) note(await answer("live", "open", main), content);
  }

  // The files of the former pair leave; those stay that came with the next one, or that only the next one names.
  function dismiss(next, others) {
    const isFormer = (name) => name === main || isNamed(name) || !isNamed(name, next);
    for (const name of files.keys()) if (!others.includes(name) && isFormer(name)) files.delete(name);
    byId("examples").value = "";
  }

  async function take(given) {
    const added = new Map();
    for (const file of given) {
      const large = await answer("live", "too_large", file.name, file.size);
      if (large) return showProblems(large.problems, large.title);
      let bytes;
      try {
        bytes = new Uint8Array(await file.arrayBuffer());
      } catch {
        return say("unreadable", file.name);
      }
      added.set(file.name, bytes);
      try {
        if (isText(file.name)) decoded(bytes);
      } catch {
        return say("not UTF-8", file.name);
      }
    }
    byId("drawn").hidden = true;
    byId("unit").value = byId("drawn-a").value = "";
    byId("understood").hidden = true;
    const names = [...added.keys()];
    // A text that a pair file names is the file of a gear.
    const texts = names.filter(isText);
    supersede();
    byId("found").classList.add("old");
    await noteNames();
    const namedBy = {};
    for (const [name, bytes] of added) await ask("live", "add", name, bytes);
    for (const name of texts) namedBy[name] = small((await answer("live", "open", name)).files);
    const isOfOther = (name) => texts.some((other) => other !== name && isNamed(name, namedBy[other]));
    const pair = texts.find((name) => !isOfOther(name) && (name === main || !isNamed(name)));
    if (pair) dismiss(namedBy[pair], names);
    for (const [name, bytes] of added) files.set(name, bytes);
    listFiles();
    const drawings = names.filter(isDrawing);
    const tables = names.filter((name) => !isText(name) && !isDrawing(name));
    if (!pair && tables.length === 1 && drawings.length === 0 && !isNamed(tables[0])) await understand(tables[0]);
    if (!pair && tables.filter((name) => !isNamed(name)).length > 1) {
      supersede();
      return say("tables", tables.join(", "));
    }
    if (pair) edit(pair);
    else if (drawings.length > 0) return useDrawings();
    calculate();
  }

  // Drawings that the pair file does not name: two become a pair.
  async function useDrawings() {
    const drawings = [...files.keys()].filter((name) => isDrawing(name) && !isNamed(name));
    if (drawings.length === 0) return calculate();
    if (drawings.length === 2) return (await startFromDrawings(drawings)) && calculate();
    supersede();
    listFiles();
    await say(drawings.length === 1 ? "one drawing" : "drawings", drawings.join(", "));
  }

  // The drawings of the last start, for another unit.
  let offered = [];
  // Two drawings without a pair file: a text to go on from, at the distance without play.
  async function startFromDrawings([wheel, pinion]) {
    const now = ++run;
    offered = [wheel, pinion];
    byId("found").classList.add("old");
    byId("examples").value = "";
    work("drawings");
    let made;
    try {
      await free("long");
      await send("long");
      made = await answer("long", "drawings", wheel, pinion, Number(byId("drawn-a").value), byId("unit").value);
    } finally {
      if (now === run) byId("working").hidden = true;
    }
    if (now !== run) return false;
    byId("drawn").hidden = false;
    if (!made.text) {
      // Their lines are not those of the text that is shown.
      showProblems((made.problems ?? [{ reason: made.failed }]).map((problem) => ({ ...problem, line: null })), made.title);
      return false;
    }
    dismiss(new Set(), [wheel, pinion]);
    files.set("pair.toml", new TextEncoder().encode(made.text));
    edit("pair.toml");
    return true;
  }

  // A table without a pair file: what is understood of it, and the lines that name it.
  async function understand(name) {
    const found = await answer("live", "understand", name);
    byId("understood").hidden = false;
    byId("understood-title").textContent = found.title;
    byId("understood-text").textContent = found.text ?? found.failed;
    byId("understood-toml").textContent = found.toml ?? "";
    byId("paste").hidden = !found.toml || isJson(text.value) || isNamed(name);
  }

  async function send(name) {
    await ask(name, "clear");
    for (const [file, bytes] of files) await ask(name, "add", file, bytes);
  }

  // ---- calculate
  let run = 0;
  // No calculation that runs, or is to begin, may end a worker or show its result.
  function supersede() {
    run += 1;
    clearTimeout(typing);
    byId("working").hidden = true;
  }
  let opened = null;
  // Time of the last run, ms: a short one follows the keys.
  let took = Infinity;
  const FOLLOWED = 1000;
  const PAUSE = 400;
  let typing = null;
  // What was said of the text before no longer holds.
  function edited() {
    number();
    for (const id of ["linked", "kept"]) byId(id).textContent = "";
    // The address holds no other pair than the one that is open.
    if (location.hash.startsWith(LINK) && text.value !== inLink) history.replaceState(null, "", location.href.split("#")[0]);
  }
  text.addEventListener("input", () => {
    edited();
    byId("found").classList.add("old");
    // The places of problems are those of the text before.
    byId("problem-list").inert = true;
    clearTimeout(typing);
    if (took < FOLLOWED) typing = setTimeout(calculate, PAUSE);
  });

  async function calculate() {
    const now = ++run;
    const content = text.value;
    files.set(main, new TextEncoder().encode(content));
    listFiles();
    clearTimeout(typing);
    clearTimeout(settling);
    byId("found").classList.add("old");
    work("reading");
    for (const name of Object.keys(workers)) quietly(free(name));
    const since = performance.now();
    try {
      await send("long");
      const found = await answer("long", "open", main);
      if (now !== run) return;
      note(found, content);
      listFiles();
      if (found.problems || found.failed) {
        showProblems(found.problems ?? [{ reason: found.failed }], found.title);
        return;
      }
      const result = await answer("long", "result");
      if (now !== run) return;
      if (result.failed) {
        showProblems([{ reason: result.failed }]);
        return;
      }
      for (const name of ["live", "band"]) {
        await send(name);
        await ask(name, "open", main);
      }
      if (now !== run) return;
      opened = { ...found, sought: [0, 1] };
      byId("problems").hidden = true;
      show(result);
      byId("found").classList.toggle("old", text.value !== content);
    } catch (fault) {
      if (now === run && fault !== STOPPED) fail(fault);
    } finally {
      if (now === run) {
        took = performance.now() - since;
        if (document.activeElement === byId("cancel")) byId("calculate").focus();
        byId("working").hidden = true;
      }
    }
  }

  // ---- what is being done, and the time gone; a second without news is told
  let begun = 0;
  let heard = 0;

  function work(stage) {
    begun = heard = performance.now();
    byId("working").hidden = false;
    byId("problems").hidden = true;
    byId("stage").textContent = words("stage", stage);
    for (const id of ["silence", "cancelled", "searching"]) byId(id).textContent = "";
    byId("progress").removeAttribute("value");
  }

  function showProgress({ done, of, stage }) {
    heard = performance.now();
    // The marks are searched behind a result.
    if (byId("working").hidden) {
      byId("searching").textContent = stage;
      return;
    }
    byId("progress").max = of;
    byId("progress").value = Math.min(done, of);
    byId("stage").textContent = stage || words("stage", "poses");
  }

  setInterval(() => {
    if (byId("working").hidden) return;
    const now = performance.now();
    quietly(ask("live", "gone", now - begun).then((gone) => { byId("gone").textContent = gone; }));
    byId("silence").textContent = now - heard > 1000 ? words("silence") : "";
  }, 250);

  function cancel() {
    run += 1;
    byId("working").hidden = true;
    quietly(rest(true));
    byId("cancelled").textContent = words("cancelled");
    byId("calculate").focus();
  }

  // Work on the distance at rest: the gears as drawn there, then in the long worker the band by all effort, the curve, and the marks that are
  // not found yet. Newer work ends it; a new worker opens the pair.
  async function rest(isNew = false) {
    if (!byId("working").hidden) return;
    const [a, now] = [distance(), run];
    if (mesh && mesh.a !== a) quietly(drawMesh(place()));
    const isOld = () => byId("curve").classList.contains("old");
    const isBusy = workers.long.waiting.size > 0;
    if (isBusy && !(isNew || isOpen || isOld())) return;
    if (isBusy || isNew) {
      await begin("long");
      if (!isFresh()) return;
      await send("long");
      await ask("long", "open", main);
    }
    if (isOpen) await bandAt("long", a, true);
    if (isOld()) {
      const { curve } = await answer("long", "curve", a);
      if (curve && a === distance()) showCurve(a, curve);
    }
    while (now === run && opened.sought.length > 0) {
      const found = await answer("long", "marks", opened.sought[0]);
      if (now !== run) return;
      opened.sought.shift();
      opened.marks.push(...found);
      marks(opened.marks);
    }
    byId("searching").textContent = "";
  }

  // A result that is greyed answers nothing, and nothing of it is saved.
  const isFresh = () => !byId("found").hidden && !byId("found").classList.contains("old");
  function keepUsable() {
    for (const id of ["live", "viewer"]) byId(id).inert = !isFresh();
    for (const id of ["save-report", "save-picture"]) byId(id).disabled = !isFresh() || !byId("working").hidden;
  }
  for (const id of ["found", "working"]) new MutationObserver(keepUsable).observe(byId(id), { attributes: true });

  // ---- problems, each with its place in the text
  function showProblems(problems, title = words("problem-list", "title")) {
    document.title = "gearlash";
    byId("found").hidden = true;
    byId("found").classList.remove("old");
    byId("problems").hidden = false;
    byId("problems-title").textContent = title;
    byId("problem-list").inert = false;
    byId("problem-list").replaceChildren(...problems.map(({ file, key, value, reason, help, line, from, to, link }) => {
      const item = make("li");
      if (file && file !== main) item.append(`${file}: `);
      if (key) item.append(make("code", value === null || value === undefined ? key : `${key} = ${value}`), ": ");
      item.append(help ? `${reason}; ${help}` : reason);
      if (line) {
        const go = make("button", `Line ${line}`, { type: "button" });
        go.addEventListener("click", () => mark(from, to, line));
        item.append(" ", go);
      }
      if (link) item.append(" ", make("a", link, { href: link }));
      return item;
    }));
  }

  function mark(from, to, line) {
    text.focus();
    text.setSelectionRange(from, to);
    const height = text.scrollHeight / text.value.split("\n").length;
    text.scrollTop = Math.max(0, (line - 4) * height);
  }

  // ---- result
  function verdict(into, { state, word, rows, text, left_out }) {
    const list = make("dl", undefined, { className: "extremes" });
    for (const [name, value] of rows) {
      const row = make("div");
      row.append(make("dt", name), make("dd", value, { className: "number" }));
      list.append(row);
    }
    into.className = `verdict ${state}`;
    into.replaceChildren(make("p", word, { className: "word" }), list, make("pre", text, { className: "status" }), ...left_out.map((line) => make("p", line)));
  }

  function checks(table) {
    // A heading without words is no header.
    const cell = (tag) => (value, i) => make(value ? tag : "td", value, { className: table.left[i] ? "left" : "" });
    const head = make("thead");
    const heads = make("tr");
    heads.append(...table.headings.map(cell("th")));
    head.append(heads);
    const body = make("tbody");
    for (const row of table.rows) {
      const line = make("tr");
      line.append(...row.map(cell("td")));
      body.append(line);
    }
    return [head, body];
  }

  function show(result) {
    byId("found").hidden = false;
    byId("found").classList.remove("old");
    verdict(byId("verdict"), result.verdict);
    showCurve(opened.marks[0].mm, result.curve);
    byId("remedies").textContent = result.remedies.trim();
    byId("checks-title").hidden = !result.checks && !result.remedies.trim();
    byId("checks").replaceChildren(...(result.checks ? checks(result.checks) : []));
    byId("notes").hidden = opened.notes.length === 0;
    byId("notes").querySelector("summary").textContent = opened.notes_title;
    byId("notes").querySelector("ul").replaceChildren(...opened.notes.map((note) => make("li", note)));
    document.title = `${opened.title}: gearlash`;
    startLive(result.start);
  }

  function showCurve(a, curve) {
    byId("curve").innerHTML = curve.join("");
    byId("curve").dataset.a = a;
    byId("curve").classList.remove("old");
  }

  // ---- live: one pose and the whole cycle at another centre distance, each in its own worker
  const fields = { a: byId("a"), number: byId("a-number"), turn: byId("turn"), wheel: byId("wheel"), pinion: byId("pinion"), flank: byId("flank"), material: byId("material") };
  const distance = () => Number(fields.number.value);
  const counted = (field) => Math.min(Math.max(1, Math.round(Number(field.value) || 1)), Number(field.max));
  const isDistance = () => fields.number.value !== "" && distance() > 0;
  const place = () => [distance(), Number(fields.material.value), counted(fields.wheel), counted(fields.pinion), fields.flank.value === "left", Number(fields.turn.value)];
  let mesh = null;
  let resting = null;
  let settling = null;
  let lagging = null;
  // Whether all effort may prove more of the band.
  let isOpen = false;
  // Ends of the axis of the band, µm.
  let axis = null;

  // Of several requests the newest wins; one is on its way.
  function newest(act) {
    let wanted = false;
    let busy = false;
    const work = async () => {
      wanted = true;
      if (busy) return;
      busy = true;
      try {
        while (wanted) {
          wanted = false;
          await act();
        }
      } finally {
        busy = false;
      }
    };
    return () => quietly(work());
  }

  const livePose = newest(async () => {
    const at = place();
    if (!mesh) await drawMesh(at);
    const pose = await answer("live", "pose", "live", ...at);
    if (isDistance()) showPose(pose);
  });
  // A part of the effort while the slider moves; all of it at rest, where that leaves a band unproven.
  async function bandAt(name, a, isWhole) {
    const band = await answer(name, "live_band", a, isWhole);
    if (!isDistance() || (isWhole && a !== distance())) return;
    clearTimeout(lagging);
    showBand(band);
    isOpen = !isWhole && band.is_proven === false;
    byId("cycle").dataset.a = a;
    byId("live").classList.toggle("behind", a !== distance());
    clearTimeout(resting);
    clearTimeout(settling);
    resting = setTimeout(() => {
      if (a !== distance()) return;
      const spoken = new Set(["here", "cycle"].map((name) => byId(name).dataset.spoken));
      byId("spoken").replaceChildren(...[...spoken].map((words) => make("span", words)));
    }, 1000);
    if (!isWhole) settling = setTimeout(() => quietly(rest()), 150);
  }
  const liveBand = newest(() => bandAt("band", distance(), false));

  function live() {
    if (!isDistance()) {
      showPose({ failed: words("here", "none") });
      showBand({ failed: words("here", "none") });
      return;
    }
    const isBehind = Number(byId("cycle").dataset.a) !== distance();
    byId("live").classList.toggle("behind", isBehind);
    byId("curve").classList.toggle("old", Number(byId("curve").dataset.a) !== distance());
    for (const timer of [resting, lagging, settling]) clearTimeout(timer);
    // The band of another distance does not stand beside the pose for long.
    if (isBehind) lagging = setTimeout(() => showBand({ failed: "…" }), 500);
    livePose();
    liveBand();
  }

  function startLive(at) {
    const [low, high] = opened.range_mm;
    for (const field of [fields.a, fields.number]) [field.min, field.max] = [low, high];
    [fields.wheel.max, fields.pinion.max] = opened.teeth;
    fields.a.value = fields.number.value = at.distance_mm;
    [fields.wheel.value, fields.pinion.value] = [at.wheel, at.pinion];
    fields.flank.value = at.left ? "left" : "right";
    fields.material.replaceChildren(...opened.materials.map((name, i) => make("option", name, { value: i })));
    fields.material.value = Math.max(0, opened.materials.indexOf(at.material));
    byId("material-label").hidden = opened.materials.length < 2;
    // One pitch, about the start where that is farther off.
    const middle = Math.abs(at.fraction) > 0.5 ? at.fraction : 0;
    [fields.turn.min, fields.turn.max, fields.turn.value] = [middle - 0.5, middle + 0.5, at.fraction];
    mesh = null;
    for (const id of ["here", "cycle"]) byId(id).textContent = "…";
    byId("viewer").classList.add("old");
    delete byId("cycle").dataset.a;
    axis = null;
    scale(null);
    live();
    marks(opened.marks);
  }

  // The picture is drawn for two gears, then moved. Drawn again at rest, it keeps zoom and focus.
  async function drawMesh(at) {
    const drawn = await answer("live", "pose", "mesh", ...at);
    const pose = await answer("live", "pose", "live", ...at);
    if (drawn.failed || pose.failed || (mesh && String(at) !== String(place()))) return;
    // A new element has no listeners of the picture before.
    const viewer = byId("viewer").cloneNode(false);
    viewer.innerHTML = drawn.html;
    if (mesh) {
      const [old, now] = [byId("viewer-picture"), viewer.querySelector("#viewer-picture")];
      const isHome = old.getAttribute("viewBox") === old.dataset.home;
      Object.assign(old.dataset, { ...now.dataset });
      old.querySelector("defs").replaceWith(now.querySelector("defs"));
      if (isHome) byId("viewer-home").click();
      showPose(pose);
    } else {
      const focused = byId("viewer").contains(document.activeElement) && document.activeElement.id;
      byId("viewer").replaceWith(viewer);
      byId("viewer-backlash").setAttribute("aria-live", "off");
      mesh = gearlashMesh(pose.mesh, (by) => {
        fields.turn.value = Number(fields.turn.value) + 0.02 * by;
        live();
      });
      if (focused) byId(focused)?.focus();
    }
    mesh.a = at[0];
  }

  // Words at once, and those that are spoken when the slider rests.
  function showWords(name, { failed, words = failed, spoken = failed }) {
    byId(name).textContent = words;
    byId(name).dataset.spoken = spoken;
  }

  function showPose(pose) {
    showWords("here", pose);
    byId("viewer").classList.toggle("old", Boolean(pose.failed));
    byId("viewer-picture")?.setAttribute("aria-label", pose.failed ?? pose.picture);
    if (pose.failed || !mesh) return;
    mesh.show(pose.mesh.runs[0], 0, pose.mesh.words);
  }

  // Places on the slider: each has its distance and words; where the pair does not assemble is shaded.
  function marks(each) {
    const [low, high] = opened.range_mm;
    const part = (mm) => (mm - low) / (high - low);
    byId("ticks").replaceChildren(...each.filter(({ mm }) => mm >= low && mm <= high).map(({ mm, kind }) => {
      const tick = make("span", "", { className: kind });
      tick.style.setProperty("--at", part(mm));
      return tick;
    }));
    const focused = byId("marks").contains(document.activeElement) && document.activeElement.textContent;
    byId("marks").replaceChildren(...each.map(({ mm, kind, words }) => {
      const item = make("li", undefined, { className: kind });
      const go = make("button", words, { type: "button" });
      go.addEventListener("click", () => { fields.a.value = fields.number.value = mm; live(); });
      item.append(go);
      return item;
    }));
    [...byId("marks").querySelectorAll("button")].find((go) => go.textContent === focused)?.focus();
  }

  function showBand(band) {
    showWords("cycle", band);
    scale(band.failed ? null : band);
  }

  // Least to greatest as a band, with the limits of the requirement as lines. The axis stays until the band leaves it, so that the band
  // is seen to move.
  function scale(band) {
    const drawing = byId("scale");
    drawing.replaceChildren();
    byId("scale-words").replaceChildren();
    if (!band || band.least_um === null || band.greatest_um === null) return;
    const ends = [0, band.least_um, band.greatest_um, ...band.limits.map(({ um }) => um)];
    const [least, most] = [Math.min(...ends), Math.max(...ends)];
    if (!axis || least < axis[0] || most > axis[1]) axis = [2 * least - most, 2 * most - least];
    const [low, high] = axis;
    const x = (um) => 10 + (580 * (um - low)) / (high - low || 1);
    const add = (tag, attributes) => {
      const part = document.createElementNS("http://www.w3.org/2000/svg", tag);
      for (const [name, value] of Object.entries(attributes)) part.setAttribute(name, value);
      drawing.append(part);
    };
    add("rect", { x: x(band.least_um), y: 8, width: Math.max(2, x(band.greatest_um) - x(band.least_um)), height: 18, fill: "var(--band)" });
    add("line", { x1: x(0), x2: x(0), y1: 2, y2: 32, stroke: "var(--ink)" });
    for (const { um } of band.limits) add("line", { x1: x(um), x2: x(um), y1: 2, y2: 32, stroke: "var(--fail)", "stroke-width": 3 });
    byId("scale-words").replaceChildren(...[{ um: 0, words: "0" }, ...band.limits].map(({ um, words }) => {
      const label = make("span", words);
      label.style.setProperty("--at", x(um) / 600);
      return label;
    }));
  }

  fields.a.addEventListener("input", () => { fields.number.value = fields.a.value; live(); });
  fields.number.addEventListener("input", () => {
    if (isDistance()) fields.a.value = fields.number.value;
    live();
  });
  for (const field of [fields.a, fields.number, fields.turn]) field.addEventListener("keydown", (event) => {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    // In the number field these move the cursor.
    const isInText = field === fields.number && /Left|Right/.test(event.key);
    if (!steps || isInText) return;
    event.preventDefault();
    const many = steps * (event.shiftKey ? 10 : 1);
    if (field === fields.turn) field.value = Number((Number(field.value) + many / 200).toFixed(6));
    else fields.number.value = fields.a.value = Number((distance() + many / 1000).toFixed(6));
    live();
  });
  for (const field of [fields.wheel, fields.pinion, fields.flank, fields.material]) field.addEventListener("input", live);
  fields.turn.addEventListener("input", () => { fields.turn.value = Number(fields.turn.value).toFixed(3); live(); });
  // The tooth that is shown.
  for (const field of [fields.wheel, fields.pinion]) field.addEventListener("change", () => { field.value = counted(field); });

  onClick("keep", async () => {
    const before = text.value;
    const made = await answer("live", "with_distance", main, before, distance());
    if (text.value !== before) return;
    if (made.text) {
      write(made.text);
      edited();
      await calculate();
      byId("keep").focus();
    }
    byId("kept").textContent = made.failed ?? made.said;
  });

  // ---- saves
  function save(name, type, content) {
    const link = make("a", "", { href: URL.createObjectURL(new Blob([content], { type })), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
  }

  const base64 = (bytes) => btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));

  byId("save-pair").addEventListener("click", () => {
    saved = text.value;
    save(main, "text/plain", saved);
  });
  onClick("save-picture", async () => {
    const picture = await answer("live", "pose", "picture", ...place());
    if (!picture.svg) showPose(picture);
    else save(`${opened.stem}.svg`, "image/svg+xml", picture.svg);
  });
  async function report() {
    const now = run;
    work("report");
    try {
      await free("long");
      await send("long");
      await ask("long", "open", main);
      return await answer("long", "report", new Date().toISOString().slice(0, 10));
    } catch (fault) {
      if (fault === STOPPED && now !== run) byId("cancelled").textContent = words("cancelled", "report");
      throw fault;
    } finally {
      if (now === run) {
        byId("working").hidden = true;
        if (isFresh()) quietly(rest());
      }
    }
  }
  // Report and picture are in it where the pair has a result.
  onClick("save-zip", async () => {
    files.set(main, new TextEncoder().encode(text.value));
    const isShown = isFresh();
    byId("linked").textContent = isShown ? "" : words("linked", "alone");
    const { html } = isShown ? await report() : {};
    const { svg } = isShown ? await answer("live", "pose", "picture", ...place()) : {};
    await send("live");
    const made = { [`report of ${opened?.stem}.html`]: html, [`picture of ${opened?.stem}.svg`]: svg };
    for (const [name, content] of Object.entries(made)) if (content) await ask("live", "add", name, new TextEncoder().encode(content));
    save("gearlash.zip", "application/zip", await ask("live", "zip"));
  });
  onClick("save-report", async () => {
    const made = await report();
    if (made.failed) showProblems([{ reason: made.failed }]);
    else save(`${opened.stem}.html`, "text/html", made.html);
  });
  byId("save-page").addEventListener("click", () => {
    files.set(main, new TextEncoder().encode(text.value));
    const held = { main, files: Object.fromEntries([...files].map(([name, bytes]) => [name, base64(bytes)])) };
    const empty = '<script type="application/json" id="own">' + byId("own").textContent;
    const full = '<script type="application/json" id="own">' + JSON.stringify(held).replaceAll("<", "\\u003c");
    save("gearlash.html", "text/html", source.replace(empty, () => full));
  });

  // ---- links
  const MOST_OF_LINK = 8192;
  const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

  onClick("link", async () => {
    await noteNames();
    const packed = await through(new TextEncoder().encode(text.value), new CompressionStream("gzip"));
    const code = base64(new Uint8Array(packed)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
    const isAlone = ![...files.keys()].some((name) => name !== main && isNamed(name));
    const fits = isAlone && code.length <= MOST_OF_LINK;
    if (fits) {
      inLink = text.value;
      location.hash = LINK + code;
    }
    byId("linked").textContent = words("linked", fits ? "held" : "long");
  });

  async function linked() {
    if (!location.hash.startsWith(LINK)) return null;
    const code = location.hash.slice(LINK.length).replaceAll("-", "+").replaceAll("_", "/");
    const packed = Uint8Array.from(atob(code), (char) => char.charCodeAt(0));
    const parts = [];
    let size = 0;
    const reader = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")).getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      size += part.value.length;
      if (await answer("live", "too_large", main, size)) throw new Error("too large");
      parts.push(part.value);
    }
    const content = decoded(await new Blob(parts).arrayBuffer());
    const name = isJson(content) ? "pair.json" : "pair.toml";
    inLink = content.replaceAll("\r\n", "\n");
    return { main: name, texts: { [name]: content } };
  }

  // Opens the pair of the link; without one, `other`. The link of the pair that is open changes nothing.
  async function openLinked(other) {
    let held = other;
    try {
      held = (await linked()) ?? other;
    } catch {
      supersede();
      byId("examples").value = "";
      files.clear();
      files.set("pair.toml", new Uint8Array());
      edit("pair.toml");
      await say("link");
      return;
    }
    if (other || (held && held.texts?.[held.main] !== text.value)) open(held);
  }

  // ---- input
  byId("paste").addEventListener("click", () => {
    write(`${text.value.trimEnd()}\n\n${byId("understood-toml").textContent}`);
    byId("understood").hidden = true;
    edited();
    calculate();
  });

  function open(held) {
    byId("drawn").hidden = true;
    files.clear();
    byId("examples").value = examples.includes(held) ? examples.indexOf(held) : "";
    for (const [name, content] of Object.entries(held.texts ?? {})) files.set(name, new TextEncoder().encode(content));
    for (const [name, content] of Object.entries(held.files ?? {})) files.set(name, Uint8Array.from(atob(content), (char) => char.charCodeAt(0)));
    edit(held.main);
    calculate();
  }

  byId("examples").append(make("option", "choose", { value: "", disabled: true }), ...examples.map(({ title }, i) => make("option", title, { value: i })));
  byId("examples").addEventListener("change", (event) => open(examples[event.target.value]));
  byId("open").addEventListener("change", (event) => {
    const given = [...event.target.files];
    // The same file can be opened again.
    event.target.value = "";
    quietly(take(given));
  });
  byId("drawn").addEventListener("change", () => {
    if (offered.every((name) => files.has(name))) quietly(startFromDrawings(offered).then((made) => made && calculate()));
  });
  byId("calculate").addEventListener("click", calculate);
  byId("cancel").addEventListener("click", cancel);
  text.addEventListener("scroll", () => { byId("lines").scrollTop = text.scrollTop; });
  document.addEventListener("keydown", (event) => { if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) calculate(); });
  const hasFiles = (event) => event.dataTransfer.types.includes("Files");
  document.addEventListener("dragover", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    document.body.classList.add("over");
  });
  document.addEventListener("dragleave", () => document.body.classList.remove("over"));
  document.addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    document.body.classList.remove("over");
    quietly(take(event.dataTransfer.files));
  });

  // Folded where the result stands below.
  byId("saves").open = matchMedia("(min-width: 60rem)").matches;
  (async () => {
    module = await unpacked(byId("wasm").textContent);
    await Promise.all(["long", "live", "band"].map(begin));
    await openLinked(own ?? examples[0]);
    window.addEventListener("hashchange", () => quietly(openLinked(null)));
    window.addEventListener("beforeunload", (event) => { if (text.value !== saved) event.preventDefault(); });
  })().catch((fault) => showProblems([{ reason: `${words("problem-list", "browser")} ${fault.message}`, help: words("problem-list", "browsers") }]));
})();
