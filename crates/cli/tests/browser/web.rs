//! The page that runs the program in the browser (`crates/web/build`), opened from disk.

use crate::chromium::{Chromium, Script, Tab};
use crate::firefox::{self, Firefox};
use crate::page::{Site, gearlash};
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
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let target = target.unwrap_or_else(|| root.join("target"));
    let file = target.join("page").join(name);
    file.is_file().then_some(file)
}

/// The files of an example, its pair file first.
const EXAMPLES: [&[&str]; 5] = [
    &["docs/files/drawing.toml"],
    &[
        "fixtures/outlines/drawn_20x20.toml",
        "fixtures/outlines/wheel_20.dxf",
        "fixtures/outlines/pinion_20.svg",
    ],
    &["docs/files/sheet.toml", "docs/files/wheel.csv"],
    &["docs/files/jams.toml"],
    &["docs/files/helical.toml"],
];

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name)
}

fn opened(browser: &Chromium, [width, height]: [u32; 2]) -> Tab {
    let mut tab = browser.tab(width, height);
    tab.open(&built().expect("the page is built"));
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

/// Drops files onto the page.
fn drop_files(tab: &mut impl Script, files: &[(String, Vec<u8>)]) {
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

fn read(names: &[&str]) -> Vec<(String, Vec<u8>)> {
    let each = names.iter().map(|name| {
        let file = Path::new(name).file_name().expect("a file has a name");
        let bytes = std::fs::read(path(name)).expect("an example is in the repository");
        (file.to_string_lossy().into_owned(), bytes)
    });
    each.collect()
}

/// The visible text of an element.
fn text(tab: &mut impl Script, id: &str) -> String {
    tab.text(&format!("document.getElementById('{id}').innerText"))
}

/// The verdict that the page shows is that of the program. Source: `check --format json`.
fn assert_verdict(tab: &mut impl Script, file: &Path) {
    let shown = text(tab, "verdict");
    let told = gearlash(&["check", &file.display().to_string(), "--format", "json"]);
    let told: Value = serde_json::from_slice(&told).expect("check writes JSON");
    let verdict = &told["files"][0]["verdict"];
    let lines = verdict["text"].as_str().expect("a verdict has lines");
    let status = lines.split(['.', '\n']).next().expect("a first sentence");
    assert!(
        shown.contains(status),
        "{}: {shown}\n{lines}",
        file.display()
    );
    for end in ["least", "greatest"] {
        let Some(line) = lines.lines().find(|line| line.trim().starts_with(end)) else {
            continue;
        };
        let value = line.split_whitespace().nth(1).expect("a value");
        assert!(
            shown.contains(value),
            "{}: {value} in {shown}",
            file.display()
        );
    }
}

/// The page has shown no error and sent no request.
fn assert_silent(tab: &Tab) {
    for event in [
        "Log.entryAdded",
        "Runtime.exceptionThrown",
        "Runtime.consoleAPICalled",
    ] {
        assert_eq!(tab.events(event), Vec::<&Value>::new());
    }
    let requests = tab.events("Network.requestWillBeSent");
    let sent = requests
        .iter()
        .map(|event| &event["params"]["request"]["url"]);
    let outside: Vec<&Value> = sent
        .filter(|url| {
            let url = url.as_str().unwrap_or_default();
            !["file:", "blob:", "data:"]
                .iter()
                .any(|own| url.starts_with(own))
        })
        .collect();
    assert!(outside.is_empty(), "{outside:?}");
}

/// Each example gives the verdict of the program.
pub fn page_examples_have_the_verdict_of_the_program(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    for names in EXAMPLES {
        drop_files(&mut tab, &read(names));
        settled(&mut tab);
        assert_verdict(&mut tab, &path(names[0]));
    }
    assert_silent(&tab);
}

/// A server of one page: its address. It ends with the process.
fn serve(page: PathBuf) -> String {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a free port");
    let address = listener.local_addr().expect("an address");
    std::thread::spawn(move || {
        let page = std::fs::read(page).expect("the page is built");
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else { continue };
            let mut request = [0; 4096];
            let read = stream.read(&mut request).unwrap_or(0);
            let is_page = request[..read].starts_with(b"GET /gearlash.html ");
            let (status, body) = if is_page {
                ("200 OK", page.as_slice())
            } else {
                ("404 Not Found", &b""[..])
            };
            let head = format!(
                "HTTP/1.1 {status}\r\nContent-Type: text/html\r\nContent-Length: {}\r\nConnection: close\r\n\r\n",
                body.len()
            );
            // A browser may hang up.
            let _ = stream
                .write_all(head.as_bytes())
                .and_then(|()| stream.write_all(body));
        }
    });
    format!("http://{address}/gearlash.html")
}

/// A first visit from a server shows the first example; time to it is printed.
pub fn page_opens_from_a_server(browser: &Chromium, _: &Site) {
    let address = serve(built().expect("the page is built"));
    let mut tab = browser.tab(1280, 900);
    let start = Instant::now();
    tab.open_address(&address);
    settled(&mut tab);
    println!(
        "opened and calculated in {:.2} s",
        start.elapsed().as_secs_f64()
    );
    assert_verdict(&mut tab, &path(EXAMPLES[0][0]));
}

/// Firefox gives the same verdicts from disk and from a server, for the first example and for a table that is dropped.
pub fn page_runs_in_firefox(_: &Chromium, _: &Site) {
    let Some(program) = firefox::find() else {
        println!(
            "Firefox skipped: not found (looked on PATH for firefox-esr and firefox; FIREFOX names another)"
        );
        return;
    };
    let page = built().expect("the page is built");
    let mut tab = Firefox::start(&program);
    for address in [format!("file://{}", page.display()), serve(page)] {
        tab.open_address(&address);
        settled(&mut tab);
        assert_verdict(&mut tab, &path(EXAMPLES[0][0]));
        drop_files(&mut tab, &read(EXAMPLES[2]));
        settled(&mut tab);
        assert_verdict(&mut tab, &path(EXAMPLES[2][0]));
    }
}

/// A workbook beside its pair file, and two drawings without one.
pub fn page_takes_workbooks_and_drawings(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    let gear = "teeth = 44\nmodule_mm = 3\npressure_angle_deg = 20\nthickness.span = { teeth = 6, mm = 50.555 }\n";
    let pair = format!(
        "[wheel]\n{gear}pitch = {{ kind = \"cumulative\", file = \"pitch.xlsx\" }}\n[pinion]\n{gear}[assembly]\ncenter_distance_mm = 132.21\n"
    );
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("book.toml");
    std::fs::write(&file, &pair).expect("a file is written");
    std::fs::copy(
        path("fixtures/sheets/pitch.xlsx"),
        folder.path().join("pitch.xlsx"),
    )
    .expect("a fixture");
    let mut files = read(&["fixtures/sheets/pitch.xlsx"]);
    files.push(("book.toml".to_owned(), pair.into_bytes()));
    drop_files(&mut tab, &files);
    settled(&mut tab);
    assert_verdict(&mut tab, &file);
    for name in ["book.toml", "pitch.xlsx"] {
        tab.eval(&format!(
            "[...document.querySelectorAll('#files li')].find((item) => item.textContent.includes('{name}'))?.querySelector('button').click()"
        ));
        settled(&mut tab);
    }
    drop_files(
        &mut tab,
        &read(&[
            "fixtures/outlines/wheel_20.dxf",
            "fixtures/outlines/pinion_20.svg",
        ]),
    );
    tab.until_within(
        "document.getElementById('text').value.includes('wheel_20.dxf')",
        CALCULATION,
    );
    settled(&mut tab);
    assert!(text(&mut tab, "verdict").contains("Assembles"));
}

/// The mesh is drawn once and follows the distance: each backlash is that of the program. Source: the library, natively.
pub fn page_mesh_moves_with_the_distance(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    tab.until("document.getElementById('viewer-picture') !== null && document.getElementById('cycle').dataset.a !== undefined");
    tab.eval("(() => { window.drawn = document.getElementById('viewer-picture'); window.outline = document.querySelector('#viewer defs path').getAttribute('d'); })()");
    let a = tab.number("Number(document.getElementById('a-number').value)");
    let shown = tab.eval(&format!(
        "(async () => {{ const field = document.getElementById('a-number'), found = []; const begun = performance.now();          for (let step = 1; step <= 50; step++) {{ field.value = ({a} + 0.004 * step).toFixed(3); field.dispatchEvent(new Event('input'));          const place = `translate(${{Number(field.value)}} 0)`;          while (!document.getElementById('viewer-pinion').getAttribute('transform').startsWith(place)) await new Promise(requestAnimationFrame);          found.push([Number(field.value), Number(document.getElementById('viewer-backlash').dataset.um)]); }}          return {{ found, frames: 50000 / (performance.now() - begun) }}; }})()"
    ));
    println!(
        "{:.0} frames a second while dragging",
        shown["frames"].as_f64().expect("a number")
    );
    assert_eq!(
        tab.eval("window.drawn === document.getElementById('viewer-picture') && window.outline === document.querySelector('#viewer defs path').getAttribute('d')"),
        json!(true)
    );
    let found = shown["found"].as_array().expect("50 steps");
    assert_eq!(found.len(), 50);
    let field =
        |tab: &mut Tab, id: &str| tab.text(&format!("document.getElementById('{id}').value"));
    let [material, wheel, pinion] = ["material", "wheel", "pinion"]
        .map(|id| field(&mut tab, id).parse::<u32>().expect("a whole number"));
    let mating = Mating {
        wheel_tooth: wheel,
        pinion_tooth: pinion,
        flank: if field(&mut tab, "flank") == "left" {
            Side::Left
        } else {
            Side::Right
        },
        fraction: field(&mut tab, "turn").parse().expect("a number"),
    };
    let study = gearlash_files::read(&path(EXAMPLES[0][0]))
        .expect("an example")
        .study;
    for step in found {
        let [a, shown] = [0, 1].map(|i| step[i].as_f64().expect("a number"));
        let (_, pair) = study
            .pairs(a)
            .expect("a distance")
            .remove(material as usize);
        let own = pair
            .lost_motion(mating)
            .expect("a pose")
            .backlash
            .expect("a backlash")
            * 1e3;
        assert!((shown - own).abs() < 1e-6, "{a}: {shown} for {own}");
    }
    assert_silent(&tab);
}

/// Marks stand where the pair assembles from and is in mesh to; a click leads there. Source: `check` at a jam, `assembles_from_mm`.
pub fn page_marks_the_ends_of_the_distance(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(EXAMPLES[3]));
    settled(&mut tab);
    tab.until("document.querySelector('#marks .jams button') !== null && document.querySelector('#marks .apart button') !== null");
    let told = gearlash(&["check", &path(EXAMPLES[3][0]).display().to_string()]);
    let told = String::from_utf8(told).expect("text is UTF-8");
    let (_, from) = told.split_once("Assembles from a = ").expect("it jams");
    let from: f64 = from
        .split(' ')
        .next()
        .expect("a distance")
        .parse()
        .expect("a number");
    let shown = tab.text("document.querySelector('#marks .jams').innerText");
    let marked = shown
        .split(' ')
        .find_map(|word| word.parse::<f64>().ok())
        .expect("a distance");
    assert!((marked - from).abs() < 2e-4, "{shown}: {from}");
    tab.eval("document.querySelector('#marks .jams button').click()");
    tab.until("Math.abs(Number(document.getElementById('cycle').dataset.a) - Number(document.getElementById('a-number').value)) < 1e-9 && document.querySelector('#ticks .jams') !== null");
    assert!(!text(&mut tab, "cycle").contains("jammed"));
}

/// A report can be cancelled; the page goes on at once. The pair file that it saves has the same verdict in the program.
pub fn page_cancels_and_saves(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(EXAMPLES[4]));
    settled(&mut tab);
    tab.eval("document.getElementById('save-report').click()");
    tab.until("!document.getElementById('working').hidden");
    let start = Instant::now();
    tab.eval("document.getElementById('cancel').click()");
    tab.until("document.getElementById('working').hidden");
    drop_files(&mut tab, &read(EXAMPLES[0]));
    settled(&mut tab);
    println!(
        "cancelled and calculated in {:.2} s",
        start.elapsed().as_secs_f64()
    );
    assert_verdict(&mut tab, &path(EXAMPLES[0][0]));
    tab.eval(KEEP_SAVED);
    tab.eval("document.getElementById('a-number').value = 30.1");
    tab.eval("document.getElementById('keep').click()");
    settled(&mut tab);
    tab.eval("document.getElementById('save-pair').click()");
    let saved = tab.text("window.saved");
    assert!(saved.contains("30.1"), "{saved}");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("saved.toml");
    std::fs::write(&file, saved).expect("a file is written");
    assert_verdict(&mut tab, &file);
    tab.eval("document.getElementById('save-zip').click()");
    tab.until("window.kind === 'application/zip'");
    let begin = tab.text("window.saved");
    assert!(begin.starts_with("PK"), "{begin}");
}

/// Keeps what the page saves in `window.saved` in place of a download.
const KEEP_SAVED: &str = "(() => { const make = URL.createObjectURL; URL.createObjectURL = (blob) => { window.kind = blob.type; window.saved = blob.text(); return make(blob); }; \
     HTMLAnchorElement.prototype.click = () => {}; })()";

/// By Tab alone every control is reached, in the order of the page, and is seen to have the focus.
pub fn page_works_by_keyboard(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    tab.until("document.getElementById('viewer-picture') !== null");
    let mut reached = Vec::new();
    for _ in 0..120 {
        tab.key("Tab", false);
        let now = tab.eval("(() => { const at = document.activeElement; const style = getComputedStyle(at.id === 'open' ? at.parentNode : at); \
             return [at === document.body ? 'BODY' : at.id || at.textContent || at.name, style.outlineStyle !== 'none']; })()");
        if now[0] == "BODY" || reached.iter().any(|known| *known == now[0]) && now[0] == "open" {
            break;
        }
        assert_eq!(now[1], true, "{} shows its focus", now[0]);
        reached.push(now[0].clone());
    }
    let wanted = [
        "open",
        "examples",
        "text",
        "calculate",
        "save-pair",
        "a",
        "a-number",
        "keep",
        "turn",
        "wheel",
        "viewer-picture",
    ];
    let places = wanted.map(|id| {
        reached
            .iter()
            .position(|known| known == id)
            .unwrap_or_else(|| panic!("{id} in {reached:?}"))
    });
    assert!(places.is_sorted(), "{reached:?}");
    // Arrow keys move the distance by 1 µm, with Shift by 10.
    tab.eval("document.getElementById('a').focus()");
    let a = tab.number("Number(document.getElementById('a-number').value)");
    tab.key("ArrowRight", false);
    tab.key("ArrowRight", true);
    let moved = tab.number("Number(document.getElementById('a-number').value)");
    assert!((moved - a - 0.011).abs() < 1e-9, "{a} {moved}");
    tab.eval("document.getElementById('a-number').focus()");
    tab.key("ArrowDown", true);
    tab.key("ArrowUp", false);
    let back = tab.number("Number(document.getElementById('a-number').value)");
    assert!((moved - back - 0.009).abs() < 1e-9, "{moved} {back}");
}

/// axe-core has no finding on any state, light, dark and narrow.
pub fn page_has_no_findings_of_axe(browser: &Chromium, _: &Site) {
    let Some(axe) = in_target("axe.min.js") else {
        println!(
            "axe-core skipped: target/page/axe.min.js is not there; `.ci/page tools` fetches it"
        );
        return;
    };
    let axe = std::fs::read_to_string(axe).expect("a script");
    for (width, scheme) in [(1280, "light"), (1280, "dark"), (390, "light")] {
        let mut tab = opened(browser, [width, 900]);
        let media = json!({ "features": [{ "name": "prefers-color-scheme", "value": scheme }] });
        tab.call("Emulation.setEmulatedMedia", media);
        tab.until("document.getElementById('viewer-picture') !== null");
        tab.call("Runtime.evaluate", json!({ "expression": axe }));
        let check = |tab: &mut Tab, state: &str| {
            let found = tab.eval("axe.run(document, { resultTypes: ['violations'] }).then(({ violations }) => violations.map(({ id, nodes }) => \
                 [id, nodes.map(({ html, failureSummary }) => html.slice(0, 160) + ' ' + failureSummary)]))");
            assert_eq!(found, json!([]), "{state}, {width}, {scheme}: {found:#}");
        };
        check(&mut tab, "first visit");
        drop_files(&mut tab, &read(EXAMPLES[4]));
        settled(&mut tab);
        tab.until("document.querySelector('#viewer-section') !== null");
        check(&mut tab, "helical pair");
        drop_files(&mut tab, &read(&["docs/files/wheel.csv"]));
        tab.until("document.getElementById('understood-toml').textContent.includes('wheel.csv')");
        settled(&mut tab);
        check(&mut tab, "a table");
        drop_files(
            &mut tab,
            &[("wrong.toml".to_owned(), b"[wheel]\nteeth = 2.5\n".to_vec())],
        );
        tab.until("!document.getElementById('problems').hidden");
        check(&mut tab, "problems");
    }
}

/// Three problems are listed with their places, and a button marks one in the text.
pub fn page_problems_have_their_places(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    let wrong = b"[wheel]\nteeth = 20.5\nmodul_mm = 2\npressure_angle_deg = 20\n[pinion]\nteeth = 30\nmodule_mm = 2\npressure_angle_deg = 200\n[assembly]\ncenter_distance_mm = 50\n";
    drop_files(&mut tab, &[("wrong.toml".to_owned(), wrong.to_vec())]);
    tab.until("document.querySelectorAll('#problem-list li').length >= 3");
    let shown = text(&mut tab, "problems");
    for key in [
        "wheel.teeth = 20.5",
        "modul_mm",
        "pinion.pressure_angle_deg = 200",
    ] {
        assert!(shown.contains(key), "{key}: {shown}");
    }
    tab.eval("document.querySelector('#problem-list button').click()");
    let marked = tab.text(
        "(() => { const t = document.getElementById('text'); return t.value.slice(t.selectionStart, t.selectionEnd); })()",
    );
    assert!(
        !marked.is_empty() && shown.contains(marked.split(' ').next().unwrap_or(&marked)),
        "{marked}"
    );
    // A table that is not there is named.
    drop_files(&mut tab, &read(&["docs/files/sheet.toml"]));
    tab.until("document.getElementById('problem-list').innerText.includes('wheel.csv')");
}

/// The centre distance moves least and greatest as the program has them there. Source: `simulate --center-distance`.
pub fn page_slider_gives_the_extremes_of_the_program(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(&["docs/files/drawing.toml"]));
    settled(&mut tab);
    let a = tab.number("Number(document.getElementById('a-number').value)");
    for step in 1..=3 {
        let a = ((a + 0.05 * f64::from(step)) * 1e3).round() / 1e3;
        tab.eval(&format!(
            "(() => {{ const a = document.getElementById('a-number'); a.value = {a}; \
             a.dispatchEvent(new Event('input')); }})()"
        ));
        tab.until(&format!(
            "document.getElementById('cycle').dataset.a === '{a}'"
        ));
        let shown = text(&mut tab, "cycle");
        let pair = path("docs/files/drawing.toml").display().to_string();
        let told = gearlash(&[
            "simulate",
            &pair,
            "--center-distance",
            &a.to_string(),
            "--no-files",
        ]);
        let told = String::from_utf8(told).expect("text is UTF-8");
        for end in ["least", "greatest"] {
            let line = told.lines().find(|line| line.trim().starts_with(end));
            let value = line.and_then(|line| line.split_whitespace().nth(1));
            let value = value.expect("a verdict has both ends");
            assert!(shown.contains(value), "{a}: {value} in {shown}");
        }
    }
}

/// A pose comes before a band that takes long, and the band of the newest distance comes in the end.
pub fn page_poses_do_not_wait_for_the_band(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(
        &mut tab,
        &read(&["docs/files/lead_helical.toml", "docs/files/lead.csv"]),
    );
    settled(&mut tab);
    tab.until("document.getElementById('viewer-pinion')?.getAttribute('transform') && document.getElementById('viewer-section') !== null");
    let a = tab.number("Number(document.getElementById('a-number').value)");
    let shown = tab.eval(&format!(
        "(async () => {{ const field = document.getElementById('a-number'); let behind = 0; for (let step = 1; step <= 10; step++) {{ \
         field.value = ({a} + 0.01 * step).toFixed(3); field.dispatchEvent(new Event('input')); const place = `translate(${{Number(field.value)}} 0)`; \
         while (!document.getElementById('viewer-pinion').getAttribute('transform').startsWith(place)) await new Promise(requestAnimationFrame); \
         behind += document.getElementById('live').classList.contains('behind'); }} return behind; }})()"
    ));
    assert!(
        shown.as_u64() >= Some(5),
        "{shown} of 10 poses came before their band"
    );
    tab.until_within(
        "document.getElementById('cycle').dataset.a === String(Number(document.getElementById('a-number').value)) \
         && !document.getElementById('live').classList.contains('behind')",
        CALCULATION,
    );
}

/// No width lets the page scroll sideways.
pub fn page_fits_its_window(browser: &Chromium, _: &Site) {
    for width in [360, 800, 1280] {
        let mut tab = opened(browser, [width, 900]);
        let wide = tab.number("document.documentElement.scrollWidth");
        assert!(wide <= f64::from(width), "{wide} of {width}");
    }
}

/// A saved page opens with its own pair.
pub fn page_saved_has_its_pair(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(EXAMPLES[2]));
    settled(&mut tab);
    let verdict = text(&mut tab, "verdict");
    tab.eval(KEEP_SAVED);
    tab.eval("document.getElementById('save-page').click()");
    let page = tab.text("window.saved");
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("saved.html");
    std::fs::write(&file, page).expect("a file is written");
    tab.open(&file);
    settled(&mut tab);
    assert_eq!(text(&mut tab, "verdict"), verdict);
    assert!(text(&mut tab, "files").contains("wheel.csv"));
}

/// A table alone is shown as understood, with the lines that name it. A pair in the link opens with it.
pub fn page_tables_and_links_are_understood(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
    drop_files(&mut tab, &read(&["docs/files/wheel.csv"]));
    tab.until("document.getElementById('understood-toml').textContent.includes('wheel.csv')");
    drop_files(&mut tab, &read(&["docs/files/jams.toml"]));
    settled(&mut tab);
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
    archive
        .start_file("xl/workbook.xml", zip::write::SimpleFileOptions::default())
        .and_then(|()| Ok((0..300).try_for_each(|_| archive.write_all(&[b' '; 1 << 20]))?))
        .expect("an archive in memory");
    archive.finish().expect("an archive in memory").into_inner()
}

/// Noise, long and nested files, archives and names with markup are problems in words; no script of theirs runs.
pub fn page_hostile_files_are_problems(browser: &Chromium, _: &Site) {
    let mut tab = opened(browser, [1280, 900]);
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
    let mut archive_noise = b"PK\x03\x04".to_vec();
    archive_noise.extend(noise(16 << 20));
    let cases: [Vec<(String, Vec<u8>)>; 6] = [
        vec![(format!("{marked}.toml"), noise(200_000))],
        vec![(
            "title.toml".to_owned(),
            format!("'{marked}' = 1\n").into_bytes(),
        )],
        vec![("long.toml".to_owned(), vec![b'#'; 3 << 20])],
        vec![("deep.toml".to_owned(), deep.into_bytes())],
        vec![
            ("p.xlsx".to_owned(), archive_noise),
            ("book.toml".to_owned(), book.clone().into_bytes()),
        ],
        vec![
            ("p.xlsx".to_owned(), bomb()),
            ("book.toml".to_owned(), book.into_bytes()),
        ],
    ];
    for files in &cases {
        let name = &files[0].0;
        tab.eval("document.getElementById('problems').hidden = true");
        drop_files(&mut tab, files);
        tab.until("!document.getElementById('problems').hidden && document.getElementById('working').hidden");
        let shown = text(&mut tab, "problem-list");
        assert!(
            !shown.is_empty() && !shown.contains("internal fault"),
            "{name}: {shown}"
        );
        if name == "p.xlsx" {
            assert!(shown.contains(".xlsx workbook"), "{shown}");
        }
    }
    assert_eq!(tab.eval("window.ran === undefined"), json!(true));
    assert_eq!(tab.events("Runtime.exceptionThrown"), Vec::<&Value>::new());
    // The page goes on.
    assert_eq!(tab.text("document.getElementById('examples').value"), "");
    tab.eval("(() => { const examples = document.getElementById('examples'); examples.value = '0'; examples.dispatchEvent(new Event('change')); })()");
    tab.until("document.getElementById('problems').hidden && document.querySelector('#verdict .status') !== null && document.getElementById('working').hidden");
}
