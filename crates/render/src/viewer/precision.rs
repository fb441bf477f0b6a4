//! Precision of the viewer, by the size of the teeth.

use gearlash::outline::AssembledPair;
use gearlash::pair::Member;
use gearlash_text::numbers::{rounded, two_digits_up};

/// Chordal error of an outline, in modules: 0.05 µm at module 3. A backlash of a few micrometres is then visible, and the dot of
/// a contact is on both outlines.
const CHORD: f64 = 1.0 / 60_000.0;
/// Teeth of both gears together up to which the chord holds. Above it the chord grows with their square, because the number of
/// points is proportional to teeth/√chord: the outlines of a material stay at some 500 kB.
const TEETH: f64 = 130.0;
/// Coarsest chord, in modules; teeth still look like teeth.
const COARSEST: f64 = 1.0 / 50.0;
/// Coordinates have the decimals of the power of ten below this share of a module, 0.01 µm at module 3. For large gears, they
/// have as many as stay exact in a browser.
const PLACE: f64 = 1.0 / 150_000.0;
/// Whole numbers below it are exact in the single precision of browsers: 24 bits.
const EXACT: f64 = 16_777_216.0;
/// Greatest distance of a chord from its curve in the narrowest view, pixels, for a picture `PIXELS` wide.
const OFF: f64 = 2.0;
const PIXELS: f64 = 800.0;
/// Decimals of a rotation in degrees: 2 nm at a radius of 130 mm.
pub const DEGREES: usize = 6;

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Precision {
    pub chord: f64,
    pub decimals: usize,
}

impl Precision {
    pub fn of(assembly: &AssembledPair) -> Precision {
        let module = assembly.module();
        let [wheel, pinion] = Member::BOTH.map(|member| assembly.gear_reach(member));
        let exact = (EXACT / f64::max(wheel, pinion)).log10().floor();
        let [wheel, pinion] = Member::BOTH.map(|member| assembly.teeth(member));
        let many = f64::from(wheel + pinion) / TEETH;
        Precision {
            chord: module * (CHORD * many.max(1.0).powi(2)).min(COARSEST),
            // Between 0 and 8; `ceil` of a negative is 0.
            decimals: (-(PLACE * module).log10()).ceil().min(exact).max(0.0) as usize,
        }
    }

    /// Width of the narrowest view, mm; a narrower one would show chords.
    pub fn narrowest(&self) -> f64 {
        self.chord * PIXELS / OFF
    }

    pub fn unit(&self) -> String {
        match self.decimals {
            0 => "1".to_owned(),
            decimals => format!("0.{}1", "0".repeat(decimals - 1)),
        }
    }

    /// `value` in units of the last decimal.
    pub fn units(&self, value: f64) -> i64 {
        (value * 10f64.powi(self.decimals as i32)).round() as i64
    }

    pub fn chord_um(&self) -> f64 {
        two_digits_up(self.chord * 1e3)
    }

    /// The last decimal of a coordinate, µm.
    pub fn place_um(&self) -> f64 {
        rounded(10f64.powi(3 - self.decimals as i32), 6)
    }
}

/// A rotation, rad, in displayed degrees.
pub fn degrees(rotation: f64) -> f64 {
    rounded(rotation.to_degrees(), DEGREES)
}
