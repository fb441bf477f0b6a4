// Answers of the page's program under node, as one line of JSON for each case. Input: {folder of the page, cases: [[file name, path] …], slow: those with a report}.
const fs = require("fs");
const vm = require("vm");
const { page, cases, slow } = JSON.parse(fs.readFileSync(0, "utf8"));
// The glue declares its name for a page; a script run by name keeps it.
const glue = fs.readFileSync(`${page}/gearlash.js`, "utf8");
const program = vm.runInThisContext(`${glue}; wasm_bindgen`);
program.initSync({ module: new WebAssembly.Module(fs.readFileSync(`${page}/gearlash_bg.wasm`)) });
const called = new Set();
const wrapped = (object) => new Proxy(object, {
  get: (target, name) => {
    const found = target[name];
    return typeof found === "function" ? (...args) => { called.add(name); return found.apply(target, args); } : found;
  },
});
const Gearlash = wrapped(program.Gearlash);
let steps = 0;
// The longest time of the processor between two steps of a long answer, ms.
let silence = 0;
let where = "";
let heard = [];
const listen = (stage) => {
  const now = process.cpuUsage().user / 1e3;
  if (now - heard[0] > silence) [silence, where] = [now - heard[0], `${heard.slice(1)} to ${stage}`];
  heard = [now, main, stage];
};
let main = "";
const long = (name, act) => {
  heard = [];
  listen(name);
  const answer = act();
  listen("end");
  return answer;
};
Gearlash.on_progress((done, of, stage) => { steps += 1; listen(stage); });
Gearlash.version();

const times = [];
const timed = (act) => {
  const since = performance.now();
  const answer = act();
  times.at(-1).push(performance.now() - since);
  return answer;
};

for (const files of cases) {
  times.push([]);
  const one = wrapped(new program.Gearlash());
  one.add("gone.toml", new Uint8Array());
  one.clear();
  for (const [name, path] of files) one.add(name, fs.readFileSync(path));
  main = files[0][0];
  const answers = [one.open(main)];
  const opened = JSON.parse(answers[0]);
  if (opened.stem !== undefined) {
    steps = 0;
    const result = long("result", () => timed(() => one.result()));
    times.at(-1).push(steps);
    const at = JSON.parse(result).start;
    const a = opened.distances_mm[0];
    const place = [a, 0, at.wheel, at.pinion, at.left, at.fraction];
    const text = fs.readFileSync(files[0][1], "utf8");
    answers.push(one.with_distance(main, text, a + 0.01), one.too_large(main, 2 ** 20 + 1), one.said("tables", main));
    answers.push(result, long("jam", () => one.marks(0)), timed(() => one.live_band(a, false)), ...["live", "mesh", "picture"].map((what) => one.pose(what, ...place)));
    // As the slider moves it, after the first.
    answers.push(...timed(() => [one.live_band(a + 0.01, false), one.pose("live", a + 0.01, ...place.slice(1))]), long("band", () => one.live_band(a + 0.01, true)));
  } else {
    const drawings = [0, 20.1].map((a) => long("drawings", () => one.drawings(main, files.at(-1)[0], a, "")));
    answers.push(one.understand(main), ...drawings);
  }
  answers.push(JSON.stringify([one.zip().length, one.gone(2500)]));
  process.stdout.write(`[${answers.join(",")}]\n`);
}
for (const files of slow) {
  const one = wrapped(new program.Gearlash());
  for (const [name, path] of files) one.add(name, fs.readFileSync(path));
  main = files[0][0];
  const a = JSON.parse(one.open(main)).distances_mm[0] + 0.01;
  process.stdout.write(`[${long("report", () => one.report("2026-01-01"))},${long("mesh", () => one.marks(1))},${long("curve", () => one.curve(a))}]\n`);
}
const all = [Object.getOwnPropertyNames(program.Gearlash.prototype), Object.getOwnPropertyNames(program.Gearlash)].flat();
const own = all.filter((key) => !key.startsWith("__") && !["constructor", "free", "length", "name", "prototype"].includes(key));
process.stdout.write(`${JSON.stringify({ uncalled: own.filter((key) => !called.has(key)), silence, where, times })}\n`);
