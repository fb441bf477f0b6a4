//! Where the involute begins, beside the formulas of the basic rack.

use super::*;
use gearlash::analysis::compare::Verdict as Compared;

/// The measured length from the base circle's tangent point to the form point is, without undercut, the one the rack
/// generates: `r sin α − (h_f − ρ (1 − sin α) − x) m/sin α` (with undercut the margin is negative and the trochoid cuts higher).
/// Source: the rack's round leaves its flank at `h_f − ρ (1 − sin α)` below the pitch line (ISO 53).
#[test]
fn the_margin_to_undercut_is_the_racks() {
    let alpha = 20f64.to_radians();
    let sin = alpha.sin();
    for (teeth, x) in [(10, 0.0), (12, -0.2), (21, 0.0), (24, 0.3), (60, 0.5)] {
        let text = format!(
            "[wheel]\nteeth = {teeth}\nmodule_mm = 3.0\npressure_angle_deg = 20.0\nprofile_shift = {x}\n\
             [pinion]\nteeth = 40\nmodule_mm = 3.0\npressure_angle_deg = 20.0\n\
             [assembly]\ncenter_distance_mm = {}\n[sweep]\nmating = [[1, 1]]\n",
            1.5 * f64::from(teeth + 40) + 3.0 * x + 0.5
        );
        let (_folder, file) = written(&text);
        let found = diagnosed(&input::read(&file).unwrap().study);
        let undercut = check(&found, "undercut", Some(Member::Wheel));
        let round = 1.25 - 0.38 * (1.0 - sin);
        let expected = 1.5 * f64::from(teeth) * sin - (round - x) * 3.0 / sin;
        let margin = undercut.margin.unwrap();
        assert!(
            (margin - expected).abs() <= 1e-9,
            "z {teeth}: {margin} {expected}"
        );
        if expected > 0.0 {
            let measured = undercut.outlines.unwrap();
            assert!(
                (measured - expected).abs() <= 1e-9,
                "z {teeth}: {measured} {expected}"
            );
            assert_eq!(undercut.verdict, Verdict::Pass);
        } else {
            assert_eq!(undercut.verdict, Verdict::Warn);
        }
    }
}

/// If the edge of an undercut touches at the form circle, in front of the line of action, a pair has less backlash than
/// model 3. Both the check `off_line_contact` and the comparison report it.
#[test]
fn an_undercut_edge_below_the_formula_is_off_the_line() {
    let gear = |name: &str| {
        format!(
            "[{name}]\nteeth = 10\nmodule_mm = 2\npressure_angle_deg = 20\nthickness.allowance_um = -40\n"
        )
    };
    // Every other tooth of the wheel stands 20 µm on: it touches where its neighbour's involutes would.
    let steps = "[0, 20, 0, 20, 0, 20, 0, 20, 0, 20]";
    let pitch =
        format!("[wheel.pitch]\nkind = \"cumulative\"\nright_um = {steps}\nleft_um = {steps}\n");
    let rest = "[assembly]\ncenter_distance_mm = 20.15\n[sweep]\nrevolutions = \"wheel\"\nsteps_per_pitch = 12\n";
    let (_folder, file) = written(&(gear("wheel") + &pitch + &gear("pinion") + rest));
    let study = input::read(&file).unwrap().study;
    let runs = simulate(&study, Method::Exact { certify: false }, &|| {
        ControlFlow::Continue(())
    });
    let runs = compare(runs.unwrap(), study.tolerance_um);
    let form = study.materials[0].1.gear().form_radius();
    let mut at_edge = 0;
    for pose in runs.iter().flat_map(|run| &run.poses) {
        let lower = pose.simulated.backlash.zip(pose.line_of_action);
        let Some((backlash, formula)) = lower.filter(|(found, formula)| formula - found > 1e-3)
        else {
            continue;
        };
        // By hand, from the radii: one of the contacts is at a form circle.
        let found = pose.simulated.proven().unwrap();
        let touched = [found.right.unwrap(), found.left.unwrap()];
        let at_form = |radius: f64| (radius - form).abs() < 1e-7;
        if touched
            .iter()
            .any(|at| at_form(at.wheel.radius) || at_form(at.pinion.radius))
        {
            at_edge += 1;
            assert_eq!(pose.verdict, Compared::OffLine, "{backlash} {formula}");
        }
    }
    assert!(at_edge > 5, "{at_edge}");
}
