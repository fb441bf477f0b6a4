//! A pair file beside which a table stands.

/// A pair whose wheel has `teeth` and `keys`.
pub fn pair(teeth: u32, keys: &str) -> String {
    let gear = format!("teeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n");
    let distance = 3.0 * f64::from(teeth) + 0.2;
    format!(
        "[wheel]\n{gear}{keys}\n[pinion]\n{gear}[assembly]\ncenter_distance_mm = {distance:?}\n[sweep]\nmating = [[1, 1]]\n"
    )
}
