// Answers of the page's program under node, as one line of JSON for each case. Input: {folder of the page, cases: [[file name, path] …]}.
const fs = require("fs");
const vm = require("vm");
const { page, cases } = JSON.parse(fs.readFileSync(0, "utf8"));
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
let heard = 0;
let silence = 0;
let said = "";
let where = "";
let main_file = "";
const listen = (stage) => {
  const now = performance.now();
  if (heard > 0 && now - heard > silence) [silence, where] = [now - heard, `${main_file}: ${said} to ${stage}`];
  [heard, said] = [now, stage];
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
  const main = files[0][0];
  main_file = main;
  const answers = [one.open(main)];
  const opened = JSON.parse(answers[0]);
  if (opened.stem !== undefined) {
    heard = performance.now();
    const result = timed(() => one.result());
    listen("result");
    heard = 0;
    const at = JSON.parse(result).start ?? { wheel: 1, pinion: 1, left: false, fraction: 0 };
    const a = opened.distances_mm[0];
    one.with_distance(main, "", a);
    one.too_large(main, 2 ** 20 + 1);
    one.said("tables", main);
    const place = [a, 0, at.wheel, at.pinion, at.left, at.fraction];
    answers.push(result, one.mark_of_jam(), timed(() => one.live_band(a, false)), ...["live", "mesh", "picture"].map((what) => one.pose(what, ...place)));
    // As the slider moves it, after the first.
    timed(() => [one.live_band(a + 0.01, false), one.pose("live", a + 0.01, ...place.slice(1))]);
  } else {
    answers.push(one.understand(main), one.of_drawings(main, files.at(-1)[0], ""));
  }
  answers.push(JSON.stringify(one.zip().length));
  process.stdout.write(`[${answers.join(",")}]\n`);
}
const last = wrapped(new program.Gearlash());
const [name, path] = cases[0][0];
last.add(name, fs.readFileSync(path));
last.open(name);
process.stdout.write(`[${last.report("2026-01-01")},${last.mark_of_mesh()}]\n`);
const all = [Object.getOwnPropertyNames(program.Gearlash.prototype), Object.getOwnPropertyNames(program.Gearlash)].flat();
const own = all.filter((key) => !key.startsWith("__") && !["constructor", "free", "length", "name", "prototype"].includes(key));
process.stdout.write(`${JSON.stringify({ uncalled: own.filter((key) => !called.has(key)), steps, silence, where, times })}\n`);
