//! The page that runs the program in the browser (`crates/web/build`), opened from disk.

use crate::browsers::{self, Chromium, Firefox, Script, Tab};
use crate::page::{Site, gearlash};
use crate::paper;
use data_encoding::BASE64;
use gearlash::gear::Side;
use gearlash::pair::Mating;
use serde_json::{Value, json};
use std::io::{Cursor, Read, Write};
use std::net::TcpListener;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The page; `None` where it was not built.
pub fn built() -> Option<PathBuf> {
    in_target("gearlash.html")
}

/// A file beside the built page.
fn in_target(name: &str) -> Option<PathBuf> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map(PathBuf::from);
    let file = target.unwrap_or_else(|| path("target"));
    let file = file.join("page").join(name);
    file.is_file().then_some(file)
}

/// The files of the examples, the pair file first.
const DRAWING: [&str; 1] = ["docs/files/drawing.toml"];
const DRAWN: [&str; 3] = [
    "fixtures/outlines/drawn_20x20.toml",
    "fixtures/outlines/wheel_20.dxf",
    "fixtures/outlines/pinion_20.svg",
];
const EXAMPLE: [&str; 3] = [
    "crates/web/page/example/drawn.toml",
    "crates/web/page/example/wheel.dxf",
    "crates/web/page/example/tooth.svg",
];
const SHEET: [&str; 2] = ["docs/files/sheet.toml", "docs/files/wheel.csv"];
const JAMS: [&str; 1] = ["docs/files/jams.toml"];
const HELICAL: [&str; 1] = ["docs/files/helical.toml"];

/// A file of the repository.
fn path(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    root.join(name)
}

fn opened(browser: &Chromium, width: u32) -> Tab {
    let mut tab = browser.tab(width, 900);
    tab.open(&built().unwrap());
    settled(&mut tab);
    tab
}

/// Most time of a calculation on a busy machine.
const CALCULATION: Duration = Duration::from_secs(240);

/// Waits until a verdict, or problems, are shown and nothing is worked at.
fn settled(tab: &mut impl Script) {
    tab.until_within(
        "document.getElementById('working').hidden && (!document.getElementById('problems').hidden \
         || document.querySelector('#verdict .status') !== null) && !document.getElementById('found').classList.contains('old')",
        CALCULATION,
    );
}

type File = (String, Vec<u8>);

/// Drops files onto the page.
fn drop_files(tab: &mut impl Script, files: &[File]) {
    let files = files
        .iter()
        .map(|(name, bytes)| json!([name, BASE64.encode(bytes)]));
    let files = json!(files.collect::<Vec<_>>());
    tab.eval(&format!(
        "(() => {{ const given = new DataTransfer(); for (const [name, text] of {files}) given.items.add(new File([Uint8Array.from(atob(text), \
         (c) => c.charCodeAt(0))], name)); document.getElementById('found').classList.add('old'); \
         document.dispatchEvent(new DragEvent('drop', {{ dataTransfer: given, bubbles: true }})); }})()"
    ));
}

/// Files of the repository, by their own names.
fn read(names: &[&str]) -> Vec<File> {
    let each = names.iter().map(|name| {
        let (_, own) = name.rsplit_once('/').unwrap();
        (own.to_owned(), std::fs::read(path(name)).unwrap())
    });
    each.collect()
}

/// Drops files of the repository, and waits for the result.
fn give(tab: &mut impl Script, names: &[&str]) {
    drop_files(tab, &read(names));
    settled(tab);
}

/// The visible text of an element.
fn text(tab: &mut impl Script, id: &str) -> String {
    tab.text(&format!("document.getElementById('{id}').innerText"))
}

/// The value of a field.
fn value(tab: &mut impl Script, id: &str) -> String {
    tab.text(&format!("document.getElementById('{id}').value"))
}

fn distance(tab: &mut impl Script) -> f64 {
    value(tab, "a-number").parse().unwrap()
}

fn set_distance(tab: &mut Tab, a: &str) {
    tab.eval(&format!("(() => {{ const a = document.getElementById('a-number'); a.value = '{a}'; a.dispatchEvent(new Event('input')); }})()"));
}

/// The values of least and greatest in the lines of a verdict.
fn ends(verdict: &str) -> Vec<&str> {
    let lines = verdict.lines().map(str::trim);
    let ends = lines.filter(|line| line.starts_with("least") || line.starts_with("greatest"));
    ends.map(|line| line.split_whitespace().nth(1).unwrap())
        .collect()
}

/// The verdict that the page shows is that of the program, word for word. Source: `check --format json`.
fn assert_verdict(tab: &mut impl Script, file: &Path) {
    let shown = tab.text("document.querySelector('#verdict .status').textContent");
    let printed = gearlash(&["check", file.to_str().unwrap(), "--format", "json"]);
    let printed: Value = serde_json::from_str(&printed).unwrap();
    let verdict = printed["files"][0]["verdict"]["text"].as_str().unwrap();
    assert_eq!(shown, verdict, "{file:?}");
    let numbers = text(tab, "verdict");
    assert!(ends(verdict).iter().all(|number| numbers.contains(number)));
}

/// A folder with one file.
fn written(name: &str, content: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(name);
    std::fs::write(&file, content).unwrap();
    (folder, file)
}

/// A server of one page: its address. It ends with the process.
fn serve(page: PathBuf) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let address = listener.local_addr().unwrap();
    std::thread::spawn(move || {
        let page = std::fs::read(page).unwrap();
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else { continue };
            let mut request = [0; 4096];
            let read = stream.read(&mut request).unwrap_or(0);
            let (status, body) = match &request[..read] {
                [b'G', b'E', b'T', b' ', b'/', b'g', ..] => ("200 OK", page.as_slice()),
                _ => ("404 Not Found", &b""[..]),
            };
            let head = format!(
                "HTTP/1.1 {status}\r\nContent-Type: text/html\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
                body.len()
            );
            // A browser may hang up.
            let sent = stream.write_all(head.as_bytes());
            let _ = sent.and_then(|()| stream.write_all(body));
        }
    });
    format!("http://{address}/gearlash.html")
}

/// A first visit from a server shows the first example; time to it is printed. Each example has the verdict of the program.
pub fn page_examples_have_the_verdict_of_the_program(browser: &Chromium, _: &Site) {
    let address = serve(built().unwrap());
    let mut tab = browser.tab(1280, 900);
    let start = Instant::now();
    tab.open_address(&address);
    settled(&mut tab);
    println!("opened and calculated in {:.2?}", start.elapsed());
    tab.holds("document.querySelectorAll('*').length < 2000");
    assert_verdict(&mut tab, &path(DRAWING[0]));
    for names in [&DRAWN[..], &EXAMPLE, &SHEET, &JAMS, &HELICAL] {
        give(&mut tab, names);
        assert_verdict(&mut tab, &path(names[0]));
    }
}

/// Firefox gives the same verdicts from disk and from a server, for the first example and for a table that is dropped.
pub fn page_runs_in_firefox(_: &Chromium, _: &Site) {
    let Some(program) = browsers::firefox() else {
        return println!("Firefox skipped: not found, as firefox-esr, firefox or $FIREFOX");
    };
    let page = built().unwrap();
    let mut tab = Firefox::start(&program);
    for address in [format!("file://{}", page.display()), serve(page)] {
        tab.open_address(&address);
        settled(&mut tab);
        assert_verdict(&mut tab, &path(DRAWING[0]));
        give(&mut tab, &SHEET);
        assert_verdict(&mut tab, &path(SHEET[0]));
    }
}

/// A workbook beside its pair file, and two drawings without one.
pub fn page_takes_workbooks_and_drawings(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    let gear = "teeth = 44\nmodule_mm = 3\npressure_angle_deg = 20\nthickness.span = { teeth = 6, mm = 50.555 }\n";
    let pair = format!(
        "[wheel]\n{gear}pitch = {{ kind = \"cumulative\", file = \"pitch.xlsx\" }}\n[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.21\n"
    );
    let (folder, file) = written("book.toml", &pair);
    let book = "fixtures/sheets/pitch.xlsx";
    std::fs::copy(path(book), folder.path().join("pitch.xlsx")).unwrap();
    let mut files = read(&[book]);
    files.push(("book.toml".to_owned(), pair.into_bytes()));
    drop_files(&mut tab, &files);
    settled(&mut tab);
    assert_verdict(&mut tab, &file);
    // The drawings come one after the other.
    drop_files(&mut tab, &read(&DRAWN[1..2]));
    tab.until("document.getElementById('problem-list').innerText.includes('dxf is not named')");
    drop_files(&mut tab, &read(&DRAWN[2..]));
    let is_made = "document.getElementById('text').value.includes('wheel_20.dxf')";
    tab.until_within(is_made, CALCULATION);
    settled(&mut tab);
    assert!(text(&mut tab, "verdict").contains("Assembles"));
    let files = text(&mut tab, "files");
    let is_gone = !files.contains("book.toml") && !files.contains("pitch.xlsx");
    assert!(is_gone, "{files}");
    // Without a pair file they make one again, at another distance.
    tab.eval("document.getElementById('drawn-a').value = 40.3; document.querySelector('#files .now button').click()");
    let is_made = "document.getElementById('text').value.includes('center_distance_mm = 40.3')";
    tab.until_within(is_made, CALCULATION);
    settled(&mut tab);
}

/// The live bar has a word for a pair that fails, and the page says what it cannot read or replaces.
pub fn page_says_in_words_what_fails(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    set_distance(&mut tab, "29.85");
    tab.until("document.getElementById('cycle').innerText.startsWith('Does not assemble')");
    tab.until("document.getElementById('here').innerText.startsWith('interference')");
    tab.eval("document.getElementById('keep').click()");
    tab.until("document.getElementById('kept').innerText.includes('30 js7')");
    settled(&mut tab);
    let latin = b"title = \"Pr\xfcf\"".to_vec();
    drop_files(&mut tab, &[("latin.toml".to_owned(), latin)]);
    tab.until("document.getElementById('problem-list').innerText.includes('not UTF-8')");
    tab.eval("location.hash = '#pair=garbage'");
    tab.until("document.getElementById('problem-list').innerText.includes('link')");
}

/// Moves the distance to `a` plus each of `count` steps of `step` mm, waits for the mesh, and returns the list of `then`.
fn moved(tab: &mut Tab, step: f64, count: u32, then: &str) -> Value {
    let a = distance(tab);
    tab.eval(&format!(
        "(async () => {{ const field = document.getElementById('a-number'), found = []; for (let step = 1; step <= {count}; step++) {{ \
         field.value = ({a} + {step} * step).toFixed(3); field.dispatchEvent(new Event('input')); const place = `translate(${{Number(field.value)}} 0)`; \
         while (!document.getElementById('viewer-pinion').getAttribute('transform').startsWith(place)) await new Promise(requestAnimationFrame); \
         found.push({then}); }} return found; }})()"
    ))
}

/// The mesh is drawn once and follows the distance: each backlash is that of the program, as are least and greatest of the cycle. Source: the
/// library, natively, and `simulate --center-distance`.
pub fn page_mesh_moves_with_the_distance(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    tab.until("document.getElementById('viewer-picture') !== null && document.getElementById('cycle').dataset.a !== undefined");
    tab.eval("(() => { window.drawn = document.getElementById('viewer-picture'); window.elements = document.querySelectorAll('#viewer *').length; window.path = document.querySelector('#viewer defs path'); window.outline = document.querySelector('#viewer defs path').getAttribute('d'); })()");
    let begun = Instant::now();
    let um = "Number(document.getElementById('viewer-backlash').dataset.um)";
    let shown = moved(&mut tab, 0.004, 50, &format!("[Number(field.value), {um}]"));
    println!("50 frames of dragging in {:.2?}", begun.elapsed());
    tab.holds("window.drawn === document.getElementById('viewer-picture') && window.elements === document.querySelectorAll('#viewer *').length && window.outline === document.querySelector('#viewer defs path').getAttribute('d')");
    let found: Vec<[f64; 2]> = serde_json::from_value(shown).unwrap();
    assert_eq!(found.len(), 50);
    let [material, wheel_tooth, pinion_tooth] =
        ["material", "wheel", "pinion"].map(|id| value(&mut tab, id).parse().unwrap());
    let is_left = value(&mut tab, "flank") == "left";
    let flank = if is_left { Side::Left } else { Side::Right };
    let mating = Mating {
        fraction: value(&mut tab, "turn").parse().unwrap(),
        ..Mating::at(wheel_tooth, pinion_tooth, flank)
    };
    let study = gearlash_input::read(&path(DRAWING[0])).unwrap().study;
    for [a, shown] in found {
        let (_, pair) = study.pairs(a).unwrap().remove(material as usize);
        let pose = gearlash::contact::lost_motion_at(&pair, mating).unwrap();
        let own = 1e3 * pose.backlash.unwrap();
        assert!((shown - own).abs() < 1e-6, "{a}: {shown} for {own}");
    }
    let mut place = 0.0;
    for a in ["30.05", "30.1", "30.15"] {
        set_distance(&mut tab, a);
        let is_there = format!("document.getElementById('cycle').dataset.a === '{a}'");
        tab.until(&is_there);
        let shown = text(&mut tab, "cycle");
        let pair = path(DRAWING[0]).display().to_string();
        let printed = gearlash(&["simulate", &pair, "--center-distance", a, "--no-files"]);
        let mut printed = ends(&printed).into_iter().take(2);
        assert!(printed.all(|value| shown.contains(value)), "{a}: {shown}");
        // The axis stays.
        let moved = tab.number("Number(document.querySelector('#scale rect').getAttribute('x'))");
        assert!(moved > place + 10.0, "{place} {moved}");
        place = moved;
    }
    tab.until("document.querySelector('#curve:not(.old)')?.textContent.includes('a = 30.15')");
    // At rest the gears are drawn again, about their new place.
    tab.until("window.path !== document.querySelector('#viewer defs path') && window.drawn.isConnected && window.drawn.getAttribute('viewBox') === window.drawn.dataset.home");
}

/// Marks stand where the pair assembles from and is in mesh to; a click leads there. Source: `check` at a jam, `assembles_from_mm`.
pub fn page_marks_the_ends_of_the_distance(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    give(&mut tab, &JAMS);
    tab.until("document.querySelector('#marks .jams button') !== null && document.querySelector('#marks .apart button') !== null");
    let printed = gearlash(&["check", path(JAMS[0]).to_str().unwrap()]);
    let number = |text: &str| text.split(' ').find_map(|word| word.parse::<f64>().ok());
    let (_, from) = printed.split_once("Assembles from a = ").unwrap();
    let shown = tab.text("document.querySelector('#marks .jams').innerText");
    let [from, marked] = [from, &shown].map(|text| number(text).unwrap());
    assert!((marked - from).abs() < 2e-4, "{shown}: {from}");
    tab.eval("document.querySelector('#marks .jams button').click()");
    tab.until("Math.abs(Number(document.getElementById('cycle').dataset.a) - Number(document.getElementById('a-number').value)) < 1e-9 && document.querySelector('#ticks .jams') !== null");
    assert!(!text(&mut tab, "cycle").contains("jammed"));
}

/// A report can be cancelled; the page goes on at once. Its saved pair file has the same verdict in the program. A saved page opens its own pair.
pub fn page_cancels_and_saves(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    give(&mut tab, &HELICAL);
    tab.until("document.getElementById('viewer-section') !== null && document.getElementById('cycle').dataset.a === document.getElementById('a-number').value");
    tab.eval("document.getElementById('save-report').click()");
    tab.until("!document.getElementById('working').hidden");
    tab.eval("(() => { const post = Worker.prototype.postMessage; window.sent = []; Worker.prototype.postMessage = function (message) { sent.push(message.call); \
         post.call(this, message); }; WebAssembly.compile = () => sent.push('compile'); })()");
    let start = Instant::now();
    tab.eval("(() => { sent.length = 0; document.getElementById('cancel').click(); })()");
    tab.until("document.getElementById('working').hidden && sent.length > 3");
    // Four messages make it usable again.
    let sent = tab.eval("sent.slice(0, 4)");
    assert_eq!(sent, json!(["start", "clear", "add", "open"]));
    give(&mut tab, &DRAWING);
    println!("cancelled and calculated in {:.2?}", start.elapsed());
    assert_verdict(&mut tab, &path(DRAWING[0]));
    tab.eval(KEEP_SAVED);
    tab.eval("document.getElementById('a-number').value = 30.1");
    tab.eval("document.getElementById('keep').click()");
    tab.until("document.getElementById('text').value.includes('= 30.1')");
    settled(&mut tab);
    tab.eval("document.getElementById('save-pair').click()");
    let saved = tab.text("window.saved");
    assert!(saved.contains("30.1"), "{saved}");
    let (_folder, file) = written("saved.toml", &saved);
    assert_verdict(&mut tab, &file);
    tab.eval("document.getElementById('save-zip').click()");
    tab.until("window.kind === 'application/zip'");
    let begin = tab.text("window.saved");
    assert!(begin.starts_with("PK"), "{begin}");
    give(&mut tab, &SHEET);
    tab.eval("document.getElementById('save-page').click()");
    let (_folder, file) = written("saved.html", &tab.text("window.saved"));
    tab.open(&file);
    settled(&mut tab);
    assert_verdict(&mut tab, &path(SHEET[0]));
    let files = text(&mut tab, "files");
    assert!(files.contains("wheel.csv") && !files.contains("not used"));
}

/// Keeps what the page saves in `window.saved` in place of a download.
const KEEP_SAVED: &str = "(() => { const make = URL.createObjectURL; URL.createObjectURL = (blob) => { window.kind = blob.type; window.saved = blob.text(); return make(blob); }; \
     HTMLAnchorElement.prototype.click = () => {}; })()";

/// Tab reaches every control, in the order of the page, with a visible focus. Keys alone edit, calculate and save a pair file.
pub fn page_works_by_keyboard(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    tab.until("document.getElementById('viewer-picture') !== null");
    let mut reached = Vec::new();
    for _ in 0..120 {
        tab.key("Tab", false);
        let now = tab.eval("(() => { const at = document.activeElement; const style = getComputedStyle(at.id === 'open' ? at.parentNode : at); \
             return [at === document.body ? 'BODY' : at.id || at.textContent || at.name, style.outlineStyle !== 'none']; })()");
        if now[0] == "BODY" || now[0] == "open" && reached.contains(&now[0]) {
            break;
        }
        assert_eq!(now[1], true, "{} shows its focus", now[0]);
        reached.push(now[0].clone());
    }
    let wanted = "open examples text calculate save-pair a a-number keep turn wheel viewer-picture";
    let place = |id| reached.iter().position(|known| known == id);
    let known = |id| place(id).unwrap_or_else(|| panic!("{id} in {reached:?}"));
    assert!(wanted.split(' ').map(known).is_sorted(), "{reached:?}");
    tab.eval(KEEP_SAVED);
    let tab_to = |tab: &mut Tab, id: &str| {
        while tab.text("document.activeElement.id") != id {
            tab.key("Tab", false);
        }
    };
    tab_to(&mut tab, "text");
    tab.call("Input.insertText", json!({ "text": "# by hand\n" }));
    tab.key("Control+Enter", false);
    tab.until("document.getElementById('found').classList.contains('old')");
    settled(&mut tab);
    tab_to(&mut tab, "save-pair");
    tab.key("Enter", false);
    assert!(tab.text("window.saved").contains("# by hand\n"));
    // Arrow keys move the distance by 1 µm, with Shift by 10.
    for (field, [key, with_shift], by) in [
        ("a", ["ArrowRight", "ArrowRight"], 0.011),
        ("a-number", ["ArrowUp", "ArrowDown"], -0.009),
    ] {
        tab.eval(&format!("document.getElementById('{field}').focus()"));
        let before = distance(&mut tab);
        tab.key(key, false);
        tab.key(with_shift, true);
        let moved = distance(&mut tab) - before;
        assert!((moved - by).abs() < 1e-9, "{field}: {moved}");
    }
}

/// axe-core has no finding on any state, light, dark and narrow, and none scrolls sideways.
pub fn page_has_no_findings_of_axe(browser: &Chromium, _: &Site) {
    let axe = in_target("axe.min.js").map(|axe| std::fs::read_to_string(axe).unwrap());
    if axe.is_none() {
        println!("axe-core skipped: target/page/axe.min.js is not there, see `.ci/page tools`");
    }
    for (width, scheme) in [(1280, "light"), (800, "dark"), (360, "light")] {
        let mut tab = opened(browser, width);
        let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": scheme }] });
        tab.call("Emulation.setEmulatedMedia", media);
        tab.until("document.getElementById('viewer-picture') !== null");
        let script = json!({ "expression": axe.as_deref().unwrap_or("") });
        tab.call("Runtime.evaluate", script);
        let check = |tab: &mut Tab, state: &str| {
            let wide = tab.number("document.documentElement.scrollWidth");
            assert!(wide <= f64::from(width), "{state}, {width}: {wide}");
            if axe.is_none() {
                return;
            }
            let found = tab.eval("axe.run(document, { resultTypes: ['violations'] }).then(({ violations }) => violations.map(({ id, nodes }) => \
                 [id, nodes.map(({ html, failureSummary }) => html.slice(0, 160) + ' ' + failureSummary)]))");
            assert_eq!(found, json!([]), "{state}, {width}, {scheme}: {found:#}");
        };
        check(&mut tab, "first visit");
        give(&mut tab, &HELICAL);
        tab.until("document.querySelector('#viewer-section') !== null");
        check(&mut tab, "helical pair");
        drop_files(&mut tab, &read(&SHEET[1..]));
        tab.until("document.getElementById('understood-toml').textContent.includes('wheel.csv')");
        settled(&mut tab);
        check(&mut tab, "a table");
        let wrong = b"[wheel]\nteeth = 2.5\n".to_vec();
        drop_files(&mut tab, &[("wrong.toml".to_owned(), wrong)]);
        tab.until("!document.getElementById('problems').hidden");
        check(&mut tab, "problems");
        // A drawing that states no unit.
        let mut drawings = read(&DRAWN[1..]);
        let mut dxf = String::from_utf8_lossy(&drawings[0].1).into_owned();
        for unit in ["$INSUNITS", "$MEASUREMENT", "unit: mm"] {
            dxf = dxf.replace(unit, "$UNKNOWN");
        }
        drawings[0].1 = dxf.into_bytes();
        drop_files(&mut tab, &drawings);
        tab.until("!document.getElementById('drawn').hidden");
        check(&mut tab, "a drawing without a unit");
        give(&mut tab, &JAMS);
        tab.eval("for (const id of ['notes', 'saves']) document.getElementById(id).open = true");
        check(&mut tab, "a pair that fails, notes open");
        set_distance(&mut tab, "");
        tab.eval("document.getElementById('found').classList.add('old')");
        check(&mut tab, "no distance, edited");
        tab.eval("document.getElementById('found').classList.remove('old')");
        tab.eval("document.getElementById('save-report').click()");
        tab.until("!document.getElementById('working').hidden");
        check(&mut tab, "at work");
        tab.holds("!document.getElementById('working').hidden");
        tab.eval("document.getElementById('cancel').click()");
        check(&mut tab, "cancelled");
    }
}

/// Three problems are listed with their places, and a button marks one in the text.
pub fn page_problems_have_their_places(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    let wrong = b"[wheel]\nteeth = 20.5\nmodul_mm = 2\npressure_angle_deg = 20\n[pinion]\nteeth = 30\nmodule_mm = 2\npressure_angle_deg = 200\n[assembly]\ncenter_distance_mm = 50\n";
    drop_files(&mut tab, &[("wrong.toml".to_owned(), wrong.to_vec())]);
    tab.until("document.querySelectorAll('#problem-list li').length >= 3");
    let shown = text(&mut tab, "problems");
    let keys = "wheel.teeth = 20.5, modul_mm, pinion.pressure_angle_deg = 200";
    for key in keys.split(", ") {
        assert!(shown.contains(key), "{key}: {shown}");
    }
    let marked = tab.eval("(() => { const t = document.getElementById('text'); return [...document.querySelectorAll('#problem-list li')].filter((one) => one.querySelector('button')).map((one) => \
         { one.querySelector('button').click(); return [one.innerText, t.value.slice(t.selectionStart, t.selectionEnd)]; }); })()");
    let marked: Vec<[String; 2]> = serde_json::from_value(marked).unwrap();
    assert!(marked.len() >= 3, "{marked:?}");
    for [problem, marked] in marked {
        let key = marked.split(' ').next().unwrap();
        let is_named = !key.is_empty() && problem.contains(key);
        assert!(is_named, "{problem}: {marked}");
    }
    // A table that is not there is named.
    drop_files(&mut tab, &read(&SHEET[..1]));
    tab.until("document.getElementById('problem-list').innerText.includes('wheel.csv')");
}

/// A pose comes before a band that takes long, and the band of the newest distance comes in the end.
pub fn page_poses_do_not_wait_for_the_band(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    let files = ["docs/files/lead_helical.toml", "docs/files/lead.csv"];
    give(&mut tab, &files);
    tab.until("document.getElementById('viewer-pinion')?.getAttribute('transform') && document.getElementById('viewer-section') !== null");
    let behind = "document.getElementById('live').classList.contains('behind')";
    let shown = moved(&mut tab, 0.01, 10, behind);
    let shown = shown.as_array().unwrap().iter();
    let before = shown.filter(|behind| **behind == json!(true)).count();
    assert!(before >= 5, "{before} of 10 poses came before their band");
    tab.until_within(
        &format!("document.getElementById('cycle').dataset.a === String(Number(document.getElementById('a-number').value)) && !{behind}"),
        CALCULATION,
    );
}

/// A fault of a pose or of a band is printed with version and help, and stays until the next calculation.
pub fn page_tells_internal_faults(browser: &Chromium, _: &Site) {
    let page = std::fs::read_to_string(built().unwrap()).unwrap();
    let call = "answer = gearlash[call](...args)";
    for name in ["pose", "live_band"] {
        let fails =
            format!("if (call === '{name}' && args.includes(30.2)) throw 'a panic'; {call}");
        let (_folder, file) = written("faulty.html", &page.replace(call, &fails));
        let mut tab = browser.tab(1280, 900);
        tab.open(&file);
        settled(&mut tab);
        tab.until("document.getElementById('cycle').dataset.a !== undefined && document.getElementById('viewer-picture') !== null");
        set_distance(&mut tab, "30.2");
        tab.until("/internal fault.*panic.*version/.test(document.getElementById('problem-list').innerText)");
        std::thread::sleep(Duration::from_millis(600));
        tab.holds("!document.getElementById('problems').hidden");
        tab.key("Control+Enter", false);
        tab.until("document.getElementById('problems').hidden && document.getElementById('working').hidden");
    }
}

/// The printed page shows verdict, mesh and curve. It is no wider than A4. It has no input and no controls. Nothing moves by itself
/// where the user prefers reduced motion.
pub fn page_prints_its_result(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    tab.until("document.getElementById('viewer-picture') !== null");
    let reduced = json!({ "features": [{ "name": "prefers-reduced-motion", "value": "reduce" }] });
    let transitions = "getComputedStyle(document.getElementById('scale')).transitionProperty";
    tab.holds(&format!("{transitions} !== 'none'"));
    tab.call("Emulation.setEmulatedMedia", reduced);
    tab.holds(&format!("{transitions} === 'none'"));
    let height = paper::print(&mut tab, "page.pdf");
    for shown in ["#verdict", "#viewer-picture", "#curve svg"] {
        let frame: [f64; 2] = tab.numbers(&format!(
            "(() => {{ const all = [...document.querySelectorAll('{shown}')].map((one) => one.getBoundingClientRect()); \
             return [Math.max(...all.map((one) => one.height)), Math.max(...all.map((one) => one.right)) - innerWidth]; }})()"
        ));
        let is_on_paper = frame[0] > 0.0 && frame[0] < height && frame[1] <= 0.0;
        assert!(is_on_paper, "{shown}: {frame:?}");
    }
    for hidden in [".input", "#live", "#viewer-controls"] {
        tab.holds(&format!(
            "document.querySelector('{hidden}').getBoundingClientRect().height === 0"
        ));
    }
}

/// A table alone is shown as understood, with the lines that name it. A pair in the link opens with it.
pub fn page_tables_and_links_are_understood(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    drop_files(&mut tab, &read(&SHEET[1..]));
    tab.until("document.getElementById('understood-toml').textContent.includes('wheel.csv')");
    // Lines of the table are shown though no folder holds it.
    assert!(text(&mut tab, "understood-text").contains("\"Max\""));
    give(&mut tab, &JAMS);
    assert!(!text(&mut tab, "files").contains("drawing.toml"));
    tab.eval("[...document.querySelectorAll('#files li:not(.now) button')].forEach((out) => out.click())");
    settled(&mut tab);
    let verdict = text(&mut tab, "verdict");
    tab.eval("document.getElementById('link').click()");
    tab.until("location.hash.startsWith('#pair=')");
    let address = tab.text("location.href");
    let mut other = browser.tab(1280, 900);
    other.open_address(&address);
    settled(&mut other);
    assert_eq!(text(&mut other, "verdict"), verdict);
}

/// A zip archive of one part that unpacks to 300 MiB.
fn bomb() -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    let options = zip::write::SimpleFileOptions::default();
    archive.start_file("xl/workbook.xml", options).unwrap();
    for _ in 0..300 {
        archive.write_all(&[b' '; 1 << 20]).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// Noise, long and nested files, archives and names with markup are problems in words; no script of theirs runs.
pub fn page_hostile_files_are_problems(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, 1280);
    let noise = |size: u32| -> Vec<u8> {
        let bytes = (0..size).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8);
        bytes.collect()
    };
    let deep = format!("a = {}1{}", "[".repeat(10_000), "]".repeat(10_000));
    let gear = "teeth = 20\nmodule_mm = 1\npressure_angle_deg = 20\n";
    let book = format!(
        "[wheel]\n{gear}pitch = {{ kind = \"single\", file = \"p.xlsx\" }}\n[pinion]\n{gear}[assembly]\ncenter_distance_mm = 20.1\n"
    );
    let marked = "<img src=x onerror=\"window.ran = true\">";
    let marked_toml = format!("{marked}.toml");
    let marked_key = format!("'{marked}' = 1\n");
    let archive_noise = [b"PK\x03\x04".to_vec(), noise(16 << 20)].concat();
    let book = ("book.toml", book.into_bytes());
    let cases = [
        vec![(&marked_toml[..], noise(200_000))],
        vec![("title.toml", marked_key.into_bytes())],
        vec![("long.toml", vec![b'#'; 3 << 20])],
        vec![("deep.toml", deep.into_bytes())],
        vec![("p.xlsx", archive_noise), book.clone()],
        vec![("p.xlsx", bomb()), book],
    ];
    for files in cases {
        let name = files[0].0;
        tab.eval("document.getElementById('problems').hidden = true");
        let named = files
            .iter()
            .map(|(name, bytes)| ((*name).to_owned(), bytes.clone()));
        drop_files(&mut tab, &named.collect::<Vec<_>>());
        tab.until("!document.getElementById('problems').hidden && document.getElementById('working').hidden");
        let shown = text(&mut tab, "problem-list");
        let is_told = !shown.is_empty() && !shown.contains("internal fault");
        assert!(is_told, "{name}: {shown}");
        let is_named = name != "p.xlsx" || shown.contains(".xlsx workbook");
        assert!(is_named, "{shown}");
    }
    tab.holds("window.ran === undefined");
    // The page goes on.
    assert_eq!(value(&mut tab, "examples"), "");
    tab.eval("(() => { const examples = document.getElementById('examples'); examples.value = '0'; examples.dispatchEvent(new Event('change')); })()");
    tab.until("document.getElementById('problems').hidden && document.querySelector('#verdict .status') !== null && document.getElementById('working').hidden");
}
