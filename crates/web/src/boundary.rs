//! The boundary to JavaScript: the functions that the page calls, each of texts and bytes.

use crate::answers::{LivePlace, Page};
use std::cell::RefCell;
use std::ops::ControlFlow;
use wasm_bindgen::prelude::*;

thread_local! {
    /// Receives the progress of long work: steps begun, steps in all, stage.
    static PROGRESS: RefCell<Option<js_sys::Function>> = const { RefCell::new(None) };
}

/// The files and the pair of a page.
#[wasm_bindgen]
#[derive(Debug, Default)]
pub struct Gearlash {
    page: Page,
}

#[wasm_bindgen]
impl Gearlash {
    /// No files and no pair. A panic becomes a fault in JavaScript, in its words.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Gearlash {
        std::panic::set_hook(Box::new(|panic| {
            wasm_bindgen::throw_str(&panic.to_string())
        }));
        Gearlash::default()
    }

    /// The version of the program.
    pub fn version() -> String {
        env!("CARGO_PKG_VERSION").to_owned()
    }

    /// Names the function that receives the progress: steps begun, steps in all, stage.
    pub fn on_progress(function: js_sys::Function) {
        PROGRESS.set(Some(function));
    }

    /// Adds a file, in place of one with the same name.
    pub fn add(&mut self, name: &str, bytes: Vec<u8>) {
        self.page.files.add(name, bytes);
    }

    /// Takes all files out.
    pub fn clear(&mut self) {
        self.page.files = gearlash_text::Files::default();
    }

    /// The files in a zip archive.
    pub fn zip(&self) -> Vec<u8> {
        self.page.zip()
    }

    /// The centre distance from which the pair assembles (`end` 0), or up to which it is in mesh (1): `[{mm, kind, words}]`, empty without one.
    pub fn marks(&self, end: usize) -> String {
        self.page.marks(end, &progress).to_string()
    }

    /// The pair file `name` with the centre distance `mm`: `{text, said}`, or `{failed}`.
    pub fn with_distance(&self, name: &str, text: &str, mm: f64) -> String {
        self.page.with_distance(name, text, mm).to_string()
    }

    /// A problem with files that the program does not see: `{title, problems}`.
    pub fn said(&self, what: &str, names: &str) -> String {
        self.page.said(what, names).to_string()
    }

    /// The problem of the file `name` with this number of `bytes`: `{title, problems}`; null where it is not too large.
    pub fn too_large(&self, name: &str, bytes: f64) -> String {
        self.page.too_large(name, bytes as u64).to_string()
    }

    /// Reads the pair file `main`: `{title, stem, notes, teeth, distances_mm, materials}`, or `{title, problems}`; and
    /// the `files` that it names, without their folders.
    pub fn open(&mut self, main: &str) -> String {
        self.page.open(main).to_string()
    }

    /// Verdict, checks, remedies and curve of the pair that is open.
    pub fn result(&self) -> String {
        self.page.result(&progress).to_string()
    }

    /// The curve over the teeth at the centre distance `a`, mm: `{curve}`, or `{failed}`.
    pub fn curve(&self, a: f64) -> String {
        self.page.curve(a, &progress).to_string()
    }

    /// The report of the pair that is open: `{html}`. `date` is its day, as printed.
    pub fn report(&self, date: &str) -> String {
        self.page.report(date, &progress).to_string()
    }

    /// The pose `what` of: `live`, `mesh` or `picture`, at the centre distance `a`, mm. `material` counts the materials of the pair.
    pub fn pose(
        &self,
        what: &str,
        a: f64,
        material: usize,
        wheel: u32,
        pinion: u32,
        left: bool,
        fraction: f64,
    ) -> String {
        let at = LivePlace {
            distance: a,
            material,
            teeth: [wheel, pinion],
            left,
            fraction,
        };
        let answer = match what {
            "mesh" => self.page.mesh(&at),
            "picture" => self.page.picture(&at),
            _ => self.page.live(&at),
        };
        answer.to_string()
    }

    /// Least and greatest backlash of the whole mesh cycle at the centre distance `a`, mm, by a part or all of the effort of a verdict.
    pub fn live_band(&self, a: f64, is_whole: bool) -> String {
        let tick = |_| progress(0, 0, "Searching the whole cycle");
        self.page.live_band(a, is_whole, &tick).to_string()
    }

    /// A time of `ms` milliseconds as shown.
    pub fn gone(&self, ms: f64) -> String {
        format!("{} s", (ms / 1e3) as u64)
    }

    /// The content of a table among the files, and the lines of a pair file that name it.
    pub fn understand(&self, name: &str) -> String {
        self.page.understand(name).to_string()
    }

    /// A pair file for the drawings `wheel` and `pinion` at a centre distance, mm, or at the one without play; `unit` is that of drawings
    /// without one.
    pub fn drawings(&self, wheel: &str, pinion: &str, distance: f64, unit: &str) -> String {
        let drawings = self
            .page
            .drawings([wheel, pinion], distance, unit, &progress);
        drawings.to_string()
    }
}

/// Reports a step. Work ends when the page ends its worker.
fn progress(done: u64, of: u64, stage: &str) -> ControlFlow<()> {
    PROGRESS.with_borrow(|function| {
        if let Some(function) = function {
            let (done, of) = (JsValue::from(done as f64), JsValue::from(of as f64));
            // The page shows an error of its own; the work goes on.
            let _ = function.call3(&JsValue::NULL, &done, &of, &JsValue::from(stage));
        }
    });
    ControlFlow::Continue(())
}
