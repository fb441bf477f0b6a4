//! A pair whose assembly phases differ.

/// `teeth` teeth on both gears, one of them 60 µm thick, 9 and 10: put together as 1 and 1, the two are never in contact
/// together. `a` is 50 µm less than play-free for nominal thickness; `rest` follows it.
pub fn two_thick_teeth(teeth: u32, module: f64, rest: &str) -> String {
    let gear = |name: &str, face: &str, allowance: i32, thick: u32| {
        let um = (1..=teeth).map(|tooth| if tooth == thick { "60" } else { "0" });
        let per_tooth = um.collect::<Vec<_>>().join(", ");
        format!(
            "[{name}]\nteeth = {teeth}\nmodule_mm = {module:?}\npressure_angle_deg = 20.0\nreference_face = \"{face}\"\n\
             thickness = {{ allowance_um = {allowance}, per_tooth_um = [{per_tooth}] }}\n"
        )
    };
    let gears = gear("wheel", "front", -60, 9) + &gear("pinion", "back", -40, 10);
    let a = module * f64::from(teeth) - 0.05;
    format!("{gears}[assembly]\ncenter_distance_mm = {a:.2}\n{rest}")
}
