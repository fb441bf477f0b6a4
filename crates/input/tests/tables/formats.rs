//! The formats of text tables, and their correct content.

use super::*;
use oracle::{Rows, column, delimited, protocol, shop};

/// Lists of values, one a column.
pub type Lists = Vec<Vec<f64>>;

/// The right data of a table for a number of teeth; `None` where it is malformed.
pub type Oracle = fn(&[u8], u32) -> Option<Lists>;

/// A format: the file's name, the keys that name it, a table for a number of teeth, and the content of its rows.
pub struct Format {
    pub name: &'static str,
    pub keys: &'static str,
    pub table: fn(u32) -> Vec<u8>,
    pub oracle: Oracle,
    /// The understood values, in the same order.
    pub understood: fn(&PairFile) -> Lists,
    /// The allowed difference of both for a value and a number of teeth: 0 where values are copied.
    pub tolerance: fn(f64, u32) -> f64,
}

impl Format {
    pub fn agrees(&self, study: &PairFile, expected: &Lists, teeth: u32) -> bool {
        let understood = (self.understood)(study);
        let near =
            |(one, other): (&f64, &f64)| (one - other).abs() <= (self.tolerance)(*other, teeth);
        understood.len() == expected.len()
            && understood
                .iter()
                .zip(expected)
                .all(|(one, other)| one.len() == other.len() && one.iter().zip(other).all(near))
    }
}

/// A deviation of tooth `tooth`, in tenths of a µm.
pub fn tenths(tooth: u32) -> f64 {
    f64::from((tooth * 7) % 31) / 10.0 - 1.5
}

/// The deviation of the tooth's other flank, which is correlated as on real gears.
pub fn others(tooth: u32) -> f64 {
    tenths(tooth) + f64::from(tooth % 3) / 10.0
}

fn rows(teeth: u32, row: impl Fn(u32) -> String) -> String {
    (1..=teeth).map(row).collect()
}

pub fn flanks(rows: Rows) -> Lists {
    vec![column(&rows, 0), column(&rows, 1)]
}

pub fn pitch_lists(study: &PairFile) -> Lists {
    ["right_um", "left_um"]
        .map(|list| echoed(study, "pitch", list))
        .to_vec()
}

const PITCH: Format = Format {
    name: "pitch.csv",
    keys: "pitch = { kind = \"cumulative\", file = \"pitch.csv\" }",
    table: |teeth| {
        let row = |tooth| format!("{tooth},{:.1},{:.1}\n", tenths(tooth), others(tooth));
        format!("tooth,left (µm),right (µm)\n{}", rows(teeth, row)).into_bytes()
    },
    oracle: |bytes, teeth| {
        delimited(bytes, teeth, &[["right", "recht"], ["left", "link"]]).map(flanks)
    },
    understood: pitch_lists,
    tolerance: |_, _| 0.0,
};

pub const FORMATS: [Format; 6] = [
    PITCH,
    Format {
        name: "german.csv",
        keys: "pitch = { kind = \"cumulative\", file = \"german.csv\" }",
        table: |teeth| {
            let row = |tooth| {
                format!("{tooth};{:.1};{:.1}\r\n", tenths(tooth), others(tooth)).replace('.', ",")
            };
            let text = format!("Zahn-Nr.;rechts (µm);links (µm)\r\n{}", rows(teeth, row));
            // Windows-1252 has these letters at their Unicode numbers.
            text.chars().map(|letter| letter as u8).collect()
        },
        ..PITCH
    },
    Format {
        name: "shop.csv",
        keys: "pitch = { kind = \"cumulative\", file = \"shop.csv\" }",
        table: |teeth| {
            let row = |tooth| {
                let (left, right) = (others(tooth), tenths(tooth));
                let values = format!("0.1;{left:.1};0.2;0.3;{right:.1};0.4").replace('.', ",");
                format!("{tooth};{values};12.03.2026\r\n")
            };
            let head = "Prüfprotokoll 4711;;;;;;;\r\n# Zahnrad 17;;;;;;;\r\n\r\n;Linke Flanke;;;Rechte Flanke;;;\r\n\
                        Zahn-Nr.;fp;Fp;fu;fp;Fp;fu;Datum\r\n-;µm;µm;µm;µm;µm;µm;\r\n";
            let foot = "\r\nMax;0,1;1,5;0,2;0,3;1,7;0,4;\r\nMittelwert;0,1;0,0;0,2;0,3;0,0;0,4;\r\nPrüfer: Kunz;;;;;;;\r\n";
            format!("{head}{}{foot}", rows(teeth, row)).into_bytes()
        },
        oracle: |bytes, teeth| shop(bytes, teeth).map(flanks),
        ..PITCH
    },
    Format {
        name: "thickness.csv",
        keys: "thickness.per_tooth_um = { file = \"thickness.csv\" }",
        table: |teeth| {
            let row = |tooth| format!("{:.1}\t{tooth}\n", tenths(tooth));
            format!("\u{feff}thickness\ttooth\n{}", rows(teeth, row)).into_bytes()
        },
        oracle: |bytes, teeth| {
            delimited(bytes, teeth, &[["thickness", "dicke"]]).map(|rows| vec![column(&rows, 0)])
        },
        understood: |study| vec![echoed(study, "thickness", "per_tooth_um")],
        ..PITCH
    },
    Format {
        name: "runout.csv",
        keys: "runout = { file = \"runout.csv\", at = \"tooth\" }",
        table: |teeth| {
            let row = |tooth| format!("{tooth},{:.1}\n", tenths(tooth));
            format!("tooth,runout (µm)\n{}", rows(teeth, row)).into_bytes()
        },
        oracle: |bytes, teeth| {
            let readings = column(&delimited(bytes, teeth, &[["runout", "rundlauf"]])?, 0);
            let step = std::f64::consts::TAU / f64::from(teeth);
            let sum = |wave: fn(f64) -> f64| -> f64 {
                readings
                    .iter()
                    .enumerate()
                    .map(|(i, reading)| reading * wave(i as f64 * step))
                    .sum()
            };
            // Twice the amplitude of the discrete Fourier transform.
            let total = 4.0 / f64::from(teeth) * sum(f64::cos).hypot(sum(f64::sin));
            Some(vec![vec![total]])
        },
        understood: |study| vec![vec![study.spec.wheel.data().unwrap().runout.total()]],
        // The rounding of a sum of 10 000 floats, µm; and the harmonic for a small e. Readings go as √(r² − e² sin²), of third
        // order in e; r is 3 z/2 for module 3 mm.
        tolerance: |total, teeth| {
            let e_to_r = total / 1000.0 / (3.0 * f64::from(teeth));
            1e-6 + total * e_to_r * e_to_r
        },
    },
    Format {
        name: "protocol.txt",
        keys: "pitch = { kind = \"single\", file = \"protocol.txt\" }",
        table: |teeth| {
            let block = |side: &str, deviation: fn(u32) -> f64| {
                let row = |tooth: u32| {
                    let before = if tooth == 1 { teeth } else { tooth - 1 };
                    let (now, before) = (deviation(tooth), deviation(before));
                    format!(
                        "{tooth:8}{:8.1}{now:8.1}{:8.1}\n",
                        now - before,
                        tenths(tooth)
                    )
                };
                format!(
                    "\n   {side} Zahnflanke\n   Zahn-Nr.   fp   Fp   Fr\n\n{}",
                    rows(teeth, row)
                )
            };
            let header = format!("  21 :Normalmodul....: 3.000\n  22 :Zähnezahl....: {teeth}\n");
            format!(
                "{header}{}{}\n",
                block("linke", tenths),
                block("rechte", others)
            )
            .into_bytes()
        },
        oracle: |bytes, teeth| {
            let [left, right] = protocol(bytes, teeth, 1)?;
            Some(vec![column(&right, 0), column(&left, 0)])
        },
        ..PITCH
    },
];
