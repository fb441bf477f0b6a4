//! Other ways to state the same gear: each is compared with the one in mm, in the normal section, by an allowance.

use super::*;
use gearlash::gauge::{Settings, gauge};
use gearlash::gear::AsBuilt;
use gearlash::gear::involute::inv;
use std::f64::consts::FRAC_PI_2;

/// The wheel of the study at most material, and at least.
fn wheels(file: &PairFile) -> [&AsBuilt; 2] {
    let materials = &file.study.materials;
    [&materials[0].1, &materials[materials.len() - 1].1]
}

fn base_thicknesses(file: &PairFile) -> [f64; 2] {
    wheels(file).map(|wheel| wheel.gear().base_thickness())
}

fn assert_near(found: [f64; 2], expected: [f64; 2]) {
    let near = |(found, expected): (f64, f64)| (found - expected).abs() < 1e-11;
    let mut both = found.into_iter().zip(expected);
    assert!(both.all(near), "{found:?} {expected:?}");
}

/// Closed forms: `s = π m/2 + A_s`; its chord is `2 r sin ψ`, `r_a − r cos ψ` below the tip, with `ψ = s/(2 r)`.
#[test]
fn arc_and_chord_are_an_allowance() {
    let (radius, tip) = (30.0, 33.0);
    let arc = |um: f64| FRAC_PI_2 * 3.0 + um / 1000.0;
    let by = |stated: &str| base_thicknesses(&wheel(&format!("thickness.{stated}")));
    let one = by("allowance_um = -50");
    assert_near(by(&format!("arc_thickness_mm = {:?}", arc(-50.0))), one);
    let both = format!("{{ min = {:?}, max = {:?} }}", arc(-80.0), arc(-50.0));
    let band = by("allowance_um = { min = -80, max = -50 }");
    assert_near(by(&format!("arc_thickness_mm = {both}")), band);

    let half = arc(-50.0) / (2.0 * radius);
    let (chord, height) = (2.0 * radius * half.sin(), tip - radius * half.cos());
    let stated = format!("chordal_thickness = {{ mm = {chord:?}, height_mm = {height:?} }}");
    assert_near(by(&stated), one);
    // At the chordal addendum of the nominal tooth.
    let half = arc(0.0) / (2.0 * radius);
    let chord = 2.0 * radius * half.sin();
    let (least, most) = (chord - 0.08, chord);
    let stated = format!("chordal_thickness = {{ min_mm = {least:?}, max_mm = {most:?} }}");
    let [most, least] = by(&stated);
    let nominal = by("allowance_um = 0")[0];
    assert!((most - nominal).abs() < 1e-11 && least < nominal - 0.05);
}

#[test]
fn inches_are_millimetres() {
    let in_mm = include_str!("inches.toml");
    let in_inches = in_mm
        .replace("module_mm = 3.175", "diametral_pitch = 8")
        .replace("tip_diameter_mm = 69.85", "tip_diameter_in = 2.75")
        .replace(
            "min_mm = 24.13, max_mm = 24.257",
            "min_in = 0.95, max_in = 0.955",
        )
        .replace("nominal_mm = 79.502", "nominal_in = 3.13")
        .replace("center_distance_mm", "center_distance_in")
        .replace(
            "bearing_clearance_mm = { wheel = 0.00254, pinion = 0.00508 }",
            "bearing_clearance_in = { wheel = 0.0001, pinion = 0.0002 }",
        );
    let (inches, mm) = (study(&in_inches), study(in_mm));
    assert_eq!(inches.spec, mm.spec);
    assert_eq!(inches.study, mm.study);
}

/// Closed forms of the transverse section: `r_b = m_t z cos α_t/2`, `s_bt = r_b (s_t/r + 2 inv α_t)` with
/// `s_t = m_t (π/2 + 2 x_t tan α_t) + A_st`; the root circle stands `m_t (h_fP* − x_E)` below the reference circle.
#[test]
fn a_transverse_system_is_that_of_the_transverse_section() {
    let gear = |hand: &str| {
        format!(
            "teeth = 20\nsystem = \"transverse\"\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nhelix_angle_deg = 30.0\nhand = \"{hand}\"\n\
             face_width_mm = 20.0\nprofile_shift = 0.1\nthickness.allowance_um = -60\nrack = {{ root_radius = 0.2 }}\n"
        )
    };
    let (wheel, pinion) = (gear("left"), gear("right"));
    let file = study(&format!(
        "[wheel]\n{wheel}[pinion]\n{pinion}[assembly]\ncenter_distance_mm = 60.8\n[sweep]\nmating = [[1, 1]]\n"
    ));
    let [gear, _] = wheels(&file).map(AsBuilt::gear);
    let alpha = 20f64.to_radians();
    assert!((gear.base_radius() - 30.0 * alpha.cos()).abs() < 1e-12);
    let thickness = 3.0 * (FRAC_PI_2 + 0.2 * alpha.tan()) - 0.06;
    let base = gear.base_radius() * (thickness / 30.0 + 2.0 * inv(alpha));
    assert!((gear.base_thickness() - base).abs() < 1e-12);
    let shift = 0.1 - 0.06 / (2.0 * 3.0 * alpha.tan());
    let root = 30.0 - 3.0 * (1.25 - shift);
    assert!((gear.root_radius() - root).abs() < 1e-12);
    assert!((gear.tip_radius() - 33.3).abs() < 1e-12);
    // The echo states the normal section.
    let echo = study(&toml::to_string(&echo(&file)).unwrap());
    assert_eq!(echo.spec, file.spec);
}

/// A temperature multiplies the lengths of a gear by `1 + α (T − 20 °C)`: the same factor stated as `scale` gives the same pair.
#[test]
fn a_scale_is_a_temperature_of_the_gears_alone() {
    let factors = [1.0 + 2e-4 * 10.0, 1.0 + 3e-4 * 10.0];
    let deviations = "tip_diameter_mm = 66.2\nrunout = { total_um = 20, high_tooth = 3 }\nthickness.allowance_um = -40\nprofile.crowning_um = 5\n";
    let text = |keys: [String; 2], assembly: &str| {
        let [wheel, pinion] = keys;
        let text = PAIR.replace(
            "[pinion]\n",
            &format!("{wheel}{deviations}[pinion]\n{pinion}"),
        );
        format!("{text}{assembly}\n[sweep]\nmating = [[1, 1]]\n")
    };
    let warm = [2e-4, 3e-4].map(|expansion| format!("expansion_per_k = {expansion}\n"));
    let warm = study(&text(
        warm,
        "temperature_c = 30\nhousing_expansion_per_k = 0",
    ));
    let scales = factors.map(|factor| format!("scale = {factor:?}\n"));
    let scaled = study(&text(scales, ""));
    assert_eq!(scaled.study, warm.study);
    assert_eq!(scaled.spec.wheel.data().unwrap().scale, Some(factors[0]));
    let nominal = study(&text([String::new(), String::new()], ""));
    let [large, small] = [&scaled, &nominal].map(|file| wheels(file)[0].gear().base_radius());
    assert!((large / small - factors[0]).abs() < 1e-15);
}

/// A drawing is scaled as a gear by its data is: the radii of its tips and roots, and its runout.
#[test]
fn a_drawn_gear_is_scaled() {
    let gear = |keys: &str| {
        let path = "../../fixtures/outlines/drawn_20x20.toml";
        let text = fs::read_to_string(path).unwrap();
        let folder = Path::new(path).parent().unwrap().canonicalize().unwrap();
        let text = text.replace("file = \"", &format!("file = \"{}/", folder.display()));
        text.replace(
            "[wheel.outline]",
            &format!("[wheel]\n{keys}\n[wheel.outline]"),
        )
    };
    let read = |keys: &str| {
        let pair = study(&gear(keys));
        let (_, wheel, _) = &pair.study.drawn[0];
        [
            wheel.tip_radius(),
            wheel.root_radius(),
            wheel.eccentricity(),
        ]
    };
    const RUNOUT: &str = "runout = { total_um = 20, high_tooth = 3 }\n";
    let (stated, scaled) = (read(RUNOUT), read(&format!("{RUNOUT}scale = 1.01")));
    for (stated, scaled) in stated.into_iter().zip(scaled) {
        assert!((scaled - 1.01 * stated).abs() < 1e-9, "{stated} {scaled}");
    }
}

/// Heights of the evaluation range, and the slope over it, are those of the gear as scaled.
#[test]
fn a_gauge_evaluates_leads_over_the_scaled_range() {
    let keys = "scale = 0.99\nface_width_mm = 20\nlead = { range_mm = [2, 17], slope_um = 12 }\n";
    let file = study(&PAIR.replace(
        "[pinion]\n",
        &format!("{keys}[pinion]\nface_width_mm = 20\n"),
    ));
    let spec = file.spec.wheel.data().unwrap();
    let settings = spec.gauge_settings(Settings::default());
    let go = || ControlFlow::Continue(());
    let gauged = gauge(wheels(&file)[0], &settings, &|_| (), &go).unwrap();
    let read = gauged.along_face.unwrap();
    for (section, height) in read.sections.iter().zip([2.0, 9.5, 17.0]) {
        assert!(
            (section.height - 0.99 * height).abs() < 1e-12,
            "{section:?}"
        );
    }
    // 12 µm over the range of 15 mm, both scaled; plus = growth from the reference face.
    let leads = read.own.unwrap();
    for trace in leads.flanks.iter().flat_map(|flank| &flank.shapes) {
        assert!((trace.slope - 0.99 * 12e-3).abs() < 1e-6, "{trace:?}");
    }
}
