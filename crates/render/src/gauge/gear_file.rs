//! A gear file that states what the gauges read.
//!
//! The pitch of both flanks carries how the thickness varies from tooth to tooth: beside it stands the mean thickness
//! alone, or it would count twice. What every tooth is thicker than the mean thickness that cut the root
//! stands by tooth, the same for all (see [`StatedThickness`]). Flanks that go against each other (thickness alone makes
//! them) look like a left flank turned round; the spans bear out the sign, so they stand as a cross-check where they do not count.

use gearlash::gauge::{StatedThickness, Unmeasured};
use gearlash_files::characters::plain;
use gearlash_files::results::gauge::{GaugedGear, Reading, gear_file_name};
use serde_json::Value;
use std::fmt::Write;

/// The gear file of `gauged`: name and content.
///
/// # Errors
/// Where the readings do not say enough: a file that left something out would be of another gear.
pub fn gear_file(gauged: &GaugedGear) -> Result<(String, String), Unmeasured> {
    Ok((gear_file_name(&gauged.stem()), content(gauged)?))
}

fn content(gauged: &GaugedGear) -> Result<String, Unmeasured> {
    let readings = &gauged.gauged;
    let stated = readings.stated.clone()?;
    let mut text = format!(
        "# What gearlash's gauges read on this gear ({}).\ntitle = {}\n\n[gear]\n",
        gauged.words(),
        quoted(&format!("{}, as gauged", plain(gauged.title))),
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
    text += &thickness(gauged, &stated);
    let eccentricity = &readings.eccentricity;
    let _ = write!(
        text,
        "\n[gear.runout]                   # twice the eccentricity, which the tip circle shows\ntotal_um = {:?}\nhigh_tooth = {:?}\n",
        2e3 * eccentricity.amount,
        eccentricity.high_tooth,
    );
    let _ = write!(
        text,
        "\n[gear.pitch]                    # carries the variation of thickness, too\nkind = \"cumulative\"\naxis = \"own\"\nfile = \"{}\"\n",
        Reading::PitchOwn.csv(&gauged.stem()),
    );
    Ok(text)
}

fn thickness(gauged: &GaugedGear, stated: &StatedThickness) -> String {
    const HEADING: &str =
        "\n[gear.thickness]                # the mean: the pitch carries how it varies\n";
    let readings = &gauged.gauged;
    let mut text = HEADING.to_owned();
    if let Err(reason) = &readings.root {
        let _ = writeln!(
            text,
            "# {reason}: that this mean thickness cut the root is taken for granted."
        );
    }
    match (stated, &readings.spans) {
        (StatedThickness::Spans, Ok(spans)) => {
            let _ = writeln!(
                text,
                "span = {{ teeth = {}, file = \"{}\", per_tooth = false }}",
                spans.teeth,
                Reading::Spans.csv(&gauged.stem()),
            );
        }
        (
            StatedThickness::Allowance {
                allowance,
                per_tooth,
                cross_check,
            },
            spans,
        ) => {
            let teeth = gauged.gear.gear().basic_data().teeth();
            if *per_tooth != 0.0 {
                text += "# The root circle was cut for this allowance; every flank pair stands off it by per_tooth_um.\n";
            }
            let _ = writeln!(text, "allowance_um = {:?}", 1e3 * allowance);
            if *per_tooth != 0.0 {
                let list = vec![1e3 * per_tooth; teeth as usize];
                let _ = writeln!(text, "per_tooth_um = {list:?}");
            }
            if let (true, Ok(spans)) = (cross_check, spans) {
                let _ = writeln!(
                    text,
                    "\n[gear.thickness.cross_check]    # bears out the sign of the flanks\nspan = {{ teeth = {}, file = \"{}\" }}",
                    spans.teeth,
                    Reading::Spans.csv(&gauged.stem()),
                );
            }
        }
        // Spans are stated only where there are some.
        (StatedThickness::Spans, Err(_)) => {}
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
