//! A gear file that states what the gauges read.
//!
//! The pitch of both flanks carries how the thickness varies from tooth to tooth: beside it stands the mean thickness
//! alone, or it would count twice.

use super::GaugedGear;
use serde_json::Value;
use std::fmt::Write;

/// The gear file of `gauged`.
pub fn gear_file(gauged: &GaugedGear) -> String {
    let readings = &gauged.gauged;
    let mut text = format!(
        "# What gearlash's gauges read on this gear ({}).\ntitle = {}\n\n[gear]\n",
        gauged.words(),
        quoted(&format!("{}, as gauged", gauged.title)),
    );
    for key in [
        "teeth",
        "module_mm",
        "pressure_angle_deg",
        "profile_shift",
        "reference_face",
        "tip_diameter_mm",
    ] {
        line(&mut text, key, &gauged.echo[key]);
    }
    text += "\n[gear.rack]\n";
    for key in ["addendum", "dedendum", "root_radius"] {
        line(&mut text, key, &gauged.echo["rack"][key]);
    }
    if let Ok(spans) = &readings.spans {
        let _ = write!(
            text,
            "\n[gear.thickness]                # the mean: the pitch carries how it varies\nspan = {{ teeth = {}, file = \"{}_spans.csv\", per_tooth = false }}\n",
            spans.teeth,
            gauged.stem(),
        );
    } else if let Ok(thickness) = &readings.thickness {
        let _ = write!(
            text,
            "\n[gear.thickness]                # mean arc thickness at the reference circle, less the nominal one\nallowance_um = {:?}\n",
            1e3 * (thickness.mean() - thickness.nominal),
        );
    }
    let eccentricity = &readings.eccentricity;
    let _ = write!(
        text,
        "\n[gear.runout]                   # twice the eccentricity, which the tip circle shows\ntotal_um = {:?}\nhigh_tooth = {:?}\n",
        2e3 * eccentricity.amount,
        eccentricity.high_tooth,
    );
    if readings.pitch_own.is_ok() {
        let _ = write!(
            text,
            "\n[gear.pitch]                    # carries the variation of thickness, too\nkind = \"cumulative\"\naxis = \"own\"\nfile = \"{}_pitch_own.csv\"\n",
            gauged.stem(),
        );
    }
    text
}

fn line(text: &mut String, key: &str, value: &Value) {
    let value = match value {
        Value::String(words) => quoted(words),
        number => number.to_string(),
    };
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{key} = {value}");
}

fn quoted(words: &str) -> String {
    toml::Value::String(words.to_owned()).to_string()
}
