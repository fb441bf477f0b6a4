//! A pair with a long hunting cycle.

/// 17 and 100 teeth with runouts whose high teeth, 5.5 and 60, do not meet in the first revolution from 1·1; `rest` follows
/// the gears.
pub fn eccentric_17_100(rest: &str) -> String {
    let gear = |name: &str, teeth: u32, shift: f64, allowance: i32, runout: &str| {
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = 2.0\npressure_angle_deg = 20.0\nprofile_shift = {shift}\n\
             thickness = {{ allowance_um = {allowance} }}\nrunout = {runout}\n"
        )
    };
    let wheel = gear("wheel", 17, 0.5, -30, "{ total_um = 20, high_tooth = 5.5 }");
    let pinion = gear(
        "pinion",
        100,
        -0.3,
        -50,
        "{ total_um = 30, high_tooth = 60 }",
    );
    format!("{wheel}{pinion}{rest}")
}
