//! Helical poses: both methods over the whole face, as the program runs them.

use super::draw::Drawn;
use super::outcome::{Agreement, Outcome, Verdict};
use gearlash::contact::{CutPair, ExactKernel, Method, PolygonDifference, PoseResult, sweep};
use gearlash::pair::Pose;
use std::ops::ControlFlow;
use std::time::{Duration, Instant};

/// The results of both methods, and of exact method and certificate, for a helical pose. The times of the polygon
/// method and of the certificate include that of the exact method and of their kernels.
pub fn outcome(drawn: &Drawn, cut: &CutPair) -> Outcome {
    let assembly = &drawn.assembly;
    let pose = Pose::new(assembly, drawn.mating);
    let kernel = ExactKernel::new(assembly);
    let start = Instant::now();
    let exact = kernel.lost_motion(&pose);
    let took = start.elapsed();
    let by = |method| -> (PoseResult, Duration) {
        let start = Instant::now();
        let matings = [drawn.mating];
        let going_on = || ControlFlow::Continue(());
        let mut found = sweep(assembly, cut, method, &matings, 0.0, &going_on)
            .expect("what is of one pose is in its result");
        (found.remove(0), start.elapsed())
    };
    let (both, both_took) = by(Method::Both);
    let (certified, certified_took) = by(Method::Checked);
    Outcome {
        verdict: match &exact {
            Err(error) => Verdict::Unproven(format!("exact: {error}")),
            Ok(_) => judge(drawn, &both, &certified),
        },
        exact: exact.ok(),
        times: [took, both_took, certified_took, Duration::ZERO],
        left_to_polygons: None,
        effort: kernel.effort(&pose),
    }
}

/// Faults are a failed certificate, and methods that differ by more than both bounds or in status. If effort ends a
/// method, the pose is unproven.
fn judge(drawn: &Drawn, both: &PoseResult, certified: &PoseResult) -> Verdict {
    let um = drawn.assembly.operating_pitch_radius(drawn.assembly.free()) * 1e3;
    if let Err(unproven) = &certified.found {
        let reason = format!("certificate: {}", unproven.reason);
        return if reason.contains("effort") {
            Verdict::Unproven(reason)
        } else {
            Verdict::Fault(reason)
        };
    }
    let mut agreement = Agreement {
        difference_um: 0.0,
        bound_um: 0.0,
        border: None,
    };
    match &both.found {
        Ok(found) => {
            if let Some(PolygonDifference::Value(mm)) = both.polygon_difference {
                agreement.difference_um = mm.abs() * 1e3;
            }
            agreement.bound_um = found.error().unwrap_or(0.0) * um;
            Verdict::Confirmed(agreement)
        }
        Err(unproven) if unproven.reason.starts_with("the exact") => {
            Verdict::Fault(unproven.reason.clone())
        }
        Err(unproven) => Verdict::Unproven(unproven.reason.clone()),
    }
}
