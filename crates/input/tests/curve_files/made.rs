//! Curve files as a P40 writes them, MADE: no real one is public.

use crate::tables::formats::{others, tenths};
use std::f64::consts::TAU;

/// Points of a trace.
const POINTS: usize = 20;
/// Diameter of the probe, mm.
const PROBE: f64 = 2.0;

/// A spur gear of module 3, 20°.
pub struct Made {
    teeth: u32,
}

impl Made {
    pub fn new(teeth: u32) -> Made {
        Made { teeth }
    }

    fn base(&self) -> f64 {
        self.reference() * 20f64.to_radians().cos()
    }

    fn reference(&self) -> f64 {
        1.5 * f64::from(self.teeth)
    }

    fn ends(&self) -> [f64; 2] {
        [2.05 * self.base(), 3.0 * f64::from(self.teeth) + 5.0]
    }

    fn deviation(side: &str, index: usize) -> f64 {
        let sign = if side == "links" { 1.0 } else { -0.5 };
        sign * (index * index) as f64 / 100.0
    }

    pub fn text(&self) -> String {
        let z = self.teeth;
        let [start, end] = self.ends();
        let tip = 3 * (z + 2);
        let mut text = format!(
            "\u{feff}HEADER KS.MK.FILE\nTYPE STI ! MADE for the tests of gearlash\nUNDEFINED -2147483.648 ! Undefined\nUNITS mm\nANGLE degrees\nPROFILE diameter\nFILTER LEAD:    F:S 2\n\n  7 :ME/Seite/KS....: made : 1\n 21 :Normalmodul........[mm]..: 3.000\n 22 :Zähnezahl z..............: {z}  Außenverzahnung\n 24 :Eingriffswinkel..........: 20.0000\n 27 :Kopfkreisdurchmesser.[mm]..: {tip}\n 40 :Start Messbereich.....da  [mm]..:  {start:.12}  {start:.12}\n 43 :Ende der Messstrecke..de  [mm]..:  {end:.12}  {end:.12}\n 60 :Tasterdurchmesser....[mm]..: {PROBE:.3}\n\n"
        );
        let mut curve = |head: &str, title: &str, value: &dyn Fn(usize) -> String| {
            text += &format!("{title}\nZahn-Nr.: {head}\n");
            for line in 0..POINTS.div_ceil(12) {
                let values = (12 * line..POINTS.min(12 * line + 12)).map(value);
                text += &(values.collect::<Vec<_>>().join(" ") + "\n");
            }
        };
        curve("2 links / 20  Werte  x= 8.742", "Flankenlinie:", &|_| {
            "-.5".to_owned()
        });
        curve(
            "2k /Flankenlinie:1 links / 20  Werte  x= 8.742",
            "Verschränkung:",
            &|_| "1.0".to_owned(),
        );
        for side in ["links", "rechts"] {
            let value = |index| match index {
                0 => "-2147483.648".to_owned(),
                _ => format!("{:.2}", Made::deviation(side, index)).replace("0.", "."),
            };
            curve(
                &format!("2 {side} / 20  Werte  z= 7.500"),
                "Profil:",
                &value,
            );
        }
        text += "\nFußkreisdurchmesser / Höhe :     7.500\n  49.5 49.6\nKopfkreisdurchmesser / Höhe : 7.500\n  54.0 54.1\n";
        for (side, values) in [("linke", tenths as fn(u32) -> f64), ("rechte", others)] {
            text += &format!("\n    {side} Zahnflanke\n    Zahn-Nr.  fp  Fp  Fr\n\n");
            for tooth in 1..=z {
                let before = values(if tooth == 1 { z } else { tooth - 1 });
                let (now, fr) = (values(tooth), tenths(tooth));
                text += &format!("  {tooth}  {:.1}  {now:.1}  {fr:.1}\n", now - before);
            }
        }
        text += "\nTeilung:\nZ-Nr. Seite PHI X Y Z\n";
        // The centre of the probe 0.3 mm outside the reference circle. Nominal thickness less 60 µm: s_b = 2 r_b (π/2z + inv α), ISO 21771.
        let radius = self.reference() + 0.3;
        let alpha = 20f64.to_radians();
        let half = TAU / 4.0 / f64::from(z) + alpha.tan() - alpha;
        let thick = 2.0 * self.base() * half - 0.06 + PROBE;
        let roll = ((radius / self.base()).powi(2) - 1.0).sqrt();
        let half = thick / (2.0 * self.base()) - (roll - roll.atan());
        for tooth in (1..=z).chain([1]) {
            // The gear turns counter-clockwise, so that tooth after tooth comes to the probe.
            let phi = 360.0 / f64::from(z) * f64::from(tooth - 1);
            let phi = (phi * 1e4).round() / 1e4;
            let middle = TAU / 4.0 - f64::from(tooth - 1) * TAU / f64::from(z);
            for (side, sense) in [("R", -1.0), ("L", 1.0)] {
                let at = middle + sense * half + phi.to_radians();
                let (x, y) = (radius * at.cos(), radius * at.sin());
                text += &format!("  {tooth}  {side}  {phi:.4}  {x:.4}  {y:.4}  87.2302\n");
            }
        }
        text.replace('\n', "\r\n")
    }
}

/// A value file.
pub const MEW: &str = "\u{feff}HEADER KS.MW.FILE\r\nTYPE  STI ! MADE\r\n\r\n  7   :ME....: 1\r\n 22 :Zähnezahl z....: 17\r\n10111 : fHb links 1  :   -2.9\r\n10112 : fHb links 2  : -9999.0\r\n26411 : Fuß 1 : 49.5\r\n26450 : V Fuß : 8999.0\r\n26711 : Kopf 1 : 49.5\r\n";
