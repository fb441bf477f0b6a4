//! Curve files as a P40 writes them, MADE: no real one is public.

use std::f64::consts::TAU;

/// Points of a trace.
pub const POINTS: usize = 20;
/// Diameter of the probe, mm.
pub const PROBE: f64 = 2.0;

/// A deviation of tooth `tooth`, in tenths of a µm.
pub fn tenths(tooth: u32) -> f64 {
    f64::from((tooth * 7) % 31) / 10.0 - 1.5
}

pub fn other(tooth: u32) -> f64 {
    tenths(tooth) + f64::from(tooth % 3) / 10.0
}

/// A gear of module 3, 20°, both of the normal section.
pub struct Made {
    pub teeth: u32,
    /// Helix angle, degrees, positive of a right-hand gear.
    pub beta_deg: f64,
    pub base_thickness: f64,
    /// What tooth `i` has more on the base circle, mm.
    pub each: fn(u32) -> f64,
    /// Whether the positions are the probe's centre.
    pub centre: bool,
    /// How far above the probe's plane the positions of left flanks stand, and below it those of right ones, mm.
    pub height: f64,
    /// Radius of the positions beyond the reference circle, mm.
    pub beyond: f64,
    /// Whether `X` and `Y` turn with the gear; else they are where the probe stands while `PHI` turns the gear.
    pub on_gear: bool,
    /// Whether the flanks are those of the space behind the tooth: its own R, L of the next.
    pub spaces: bool,
    /// Whether R is called L, and L R.
    pub exchanged: bool,
}

impl Made {
    pub fn base(&self) -> f64 {
        self.reference() * self.alpha().cos()
    }

    fn reference(&self) -> f64 {
        1.5 * f64::from(self.teeth) / self.beta_deg.to_radians().cos()
    }

    /// Transverse pressure angle. Source: tan α_t = tan α_n/cos β, ISO 21771.
    fn alpha(&self) -> f64 {
        let alpha = 20f64.to_radians();
        match self.beta_deg == 0.0 {
            true => alpha,
            false => (alpha.tan() / self.beta_deg.to_radians().cos()).atan(),
        }
    }

    /// Sine of the base helix angle, of either sign. Source: sin β_b = sin β cos α_n, ISO 21771.
    pub fn lean(&self) -> f64 {
        self.beta_deg.to_radians().sin() * 20f64.to_radians().cos()
    }

    /// Nominal less 60 µm. Source: s_b = 2 r_b (π/2z + inv α), ISO 21771.
    pub fn new(teeth: u32) -> Made {
        Made::helical(teeth, 0.0)
    }

    pub fn helical(teeth: u32, beta_deg: f64) -> Made {
        let mut made = Made {
            teeth,
            beta_deg,
            height: 0.0,
            base_thickness: 0.0,
            each: |_| 0.0,
            centre: true,
            beyond: 0.3,
            on_gear: false,
            spaces: false,
            exchanged: false,
        };
        let alpha = made.alpha();
        let half = TAU / 4.0 / f64::from(teeth) + alpha.tan() - alpha;
        made.base_thickness = 2.0 * made.base() * half - 0.06;
        made
    }

    fn ends(&self) -> [f64; 2] {
        [2.05 * self.base(), 3.0 * f64::from(self.teeth) + 5.0]
    }

    /// Rolls of the points.
    pub fn rolls(&self) -> Vec<f64> {
        let ends = self
            .ends()
            .map(|d| (0.25 * d * d - self.base().powi(2)).sqrt());
        let step = (ends[1] - ends[0]) / (POINTS - 1) as f64;
        (0..POINTS).map(|i| ends[0] + step * i as f64).collect()
    }

    pub fn deviation(side: &str, index: usize) -> f64 {
        let sign = if side == "links" { 1.0 } else { -0.5 };
        sign * (index * index) as f64 / 100.0
    }

    pub fn text(&self) -> String {
        let z = self.teeth;
        let [start, end] = self.ends();
        let tip = match self.beta_deg == 0.0 {
            true => (3 * (z + 2)).to_string(),
            false => format!("{:.4}", 2.0 * self.reference() + 6.0),
        };
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
        for (side, values) in [("linke", tenths as fn(u32) -> f64), ("rechte", other)] {
            text += &format!("\n    {side} Zahnflanke\n    Zahn-Nr.  fp  Fp  Fr\n\n");
            for tooth in 1..=z {
                let before = values(if tooth == 1 { z } else { tooth - 1 });
                let (now, fr) = (values(tooth), tenths(tooth));
                text += &format!("  {tooth}  {:.1}  {now:.1}  {fr:.1}\n", now - before);
            }
        }
        text += "\nTeilung:\nZ-Nr. Seite PHI X Y Z\n";
        let radius = self.reference() + self.beyond;
        let roll = ((radius / self.base()).powi(2) - 1.0).sqrt();
        // The centre of a ball lies on the involute that stands out by its radius over cos β_b (dimension over balls, ISO 21771).
        let out = match self.centre {
            true => PROBE / (1.0 - self.lean().powi(2)).sqrt(),
            false => 0.0,
        };
        // Source: design, numbering and flanks (ISO 1328-1): seen on the reference face, here with X to the right and Y up, teeth are
        // numbered clockwise, and R is the right-hand flank of a tooth that points up, its clockwise side. So R lies ahead of L in
        // the direction of the numbers.
        let pitch = TAU / f64::from(z);
        let flank = |tooth: u32, sense: f64| {
            let thick = self.base_thickness + (self.each)(tooth) + out;
            let half = thick / (2.0 * self.base()) - (roll - roll.atan());
            TAU / 4.0 - f64::from(tooth - 1) * pitch + sense * half
        };
        for tooth in (1..=z).chain([1]) {
            let left = match self.spaces {
                true => flank(tooth % z + 1, 1.0),
                false => flank(tooth, 1.0),
            };
            // The gear turns counter-clockwise, so that tooth after tooth comes to the probe.
            let phi = 360.0 / f64::from(z) * f64::from(tooth - 1);
            let phi = (phi * 1e4).round() / 1e4;
            let turned = if self.on_gear { 0.0 } else { phi.to_radians() };
            let names = if self.exchanged {
                ["L", "R"]
            } else {
                ["R", "L"]
            };
            // Right-hand teeth wind counter-clockwise towards the viewer.
            let wound = self.beta_deg.to_radians().tan() / self.reference();
            let right = flank(tooth, -1.0) - wound * self.height;
            let left = left + wound * self.height;
            let heights = [87.2302 - self.height, 87.2302 + self.height];
            for ((side, at), height) in names.into_iter().zip([right, left]).zip(heights) {
                let (x, y) = (radius * (at + turned).cos(), radius * (at + turned).sin());
                text += &format!("  {tooth}  {side}  {phi:.4}  {x:.4}  {y:.4}  {height:.4}\n");
            }
        }
        text.replace('\n', "\r\n")
    }
}

/// A value file.
pub const MEW: &str = "\u{feff}HEADER KS.MW.FILE\r\nTYPE  STI ! MADE\r\n\r\n  7   :ME....: 1\r\n 22 :Zähnezahl z....: 17\r\n10111 : fHb links 1  :   -2.9\r\n10112 : fHb links 2  : -9999.0\r\n26411 : Fuß 1 : 49.5\r\n26450 : V Fuß : 8999.0\r\n26711 : Kopf 1 : 49.5\r\n";
