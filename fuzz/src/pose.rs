//! One pose by the exact method, the polygon method and the certificate.

use gearlash::contact::{Certifier, Contact, CutPair, ExactKernel, LostMotion};
use gearlash::error::Error;
use gearlash::gear::ProfilePart;
use gearlash::pair::{GearPair, Mating, Member, Pose};
use std::f64::consts::TAU;

/// Chordal error, in modules, of the polygons the polygon method starts from.
const CHORD: f64 = 1e-4;

/// A contact this near to the root circle, mm, is where a fillet ends.
const JOINT: f64 = 1e-6;

/// Tip circles that meet within this, mm, meet to rounding: a thousand times that of radii of a metre.
const JUST_MET: f64 = 1e-10;

/// Checks that both methods agree at `mating` within their error bounds, and that the certificate confirms the exact result.
///
/// A pose with a lost contact passes, because the program reports it.
///
/// # Errors
/// The difference, in words.
pub fn agree(assembly: &GearPair, mating: Mating) -> Result<(), String> {
    let pose = Pose::new(assembly, mating);
    let [wheel, pinion] = [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member));
    let cut = CutPair::new(wheel, pinion, CHORD * wheel.gear().basic_data().module());
    let coarse = CutPair::for_certificates(wheel, pinion);
    let exact = settled("exact", ExactKernel::new(assembly).lost_motion(&pose))?;
    let polygon = settled("polygon", cut.refined_kernel(assembly).lost_motion(&pose))?;
    let certifier = Certifier::new(coarse.kernel(assembly));
    if let (Some(exact), Some(polygon)) = (&exact, &polygon) {
        same(assembly, exact, polygon)
            .map_err(|what| format!("{what}\nexact   {exact:?}\npolygon {polygon:?}"))?;
    }
    if let Some(exact) = &exact {
        match certifier.check(&pose, exact) {
            Ok(()) | Err(Error::ContactLost { .. }) => {}
            Err(error) => return Err(format!("{error}\nexact   {exact:?}\npolygon {polygon:?}")),
        }
    }
    Ok(())
}

/// The result; `None` if the contact was lost.
fn settled(name: &str, found: Result<LostMotion, Error>) -> Result<Option<LostMotion>, String> {
    match found {
        Ok(found) => Ok(Some(found)),
        Err(Error::ContactLost { .. }) => Ok(None),
        Err(error) => Err(format!("{name}: {error}")),
    }
}

/// Whether two results are the same within both bounds: contact by contact, their lost motion, and so
/// their status.
fn same(assembly: &GearPair, exact: &LostMotion, polygon: &LostMotion) -> Result<(), String> {
    // Tip circles that meet to rounding: whether a tip is in reach is undecidable.
    let tips =
        [Member::Wheel, Member::Pinion].map(|member| assembly.gear(member).gear().tip_radius());
    if (assembly.center_distance() - tips.iter().sum::<f64>()).abs() <= JUST_MET {
        return Ok(());
    }
    // Teeth inside the mate's body: the contacts of overlapping bodies are meaningless.
    if exact.solid && polygon.solid {
        return Ok(());
    }
    let within = |what: &str, difference: f64, bound: f64| {
        if difference.abs() <= bound {
            Ok(())
        } else {
            Err(format!(
                "{what}: {difference:.3e} rad apart, allowed {bound:.3e}"
            ))
        }
    };
    let side = |what: &str, one: Option<Contact>, other: Option<Contact>| match (one, other) {
        (Some(one), Some(other)) => {
            let turn = one.rotation - other.rotation;
            within(
                what,
                turn - TAU * (turn / TAU).round(),
                one.error + other.error,
            )
        }
        (None, None) => Ok(()),
        _ => Err(format!("{what}: found by one method alone")),
    };
    side("right", exact.right, polygon.right)?;
    side("left", exact.left, polygon.left)?;
    let bound = [exact, polygon]
        .map(|found| found.error().unwrap_or(0.0))
        .iter()
        .sum();
    let between = |found: &LostMotion| {
        found
            .left
            .zip(found.right)
            .map(|(l, r)| l.rotation - r.rotation)
    };
    if let (Some(one), Some(other)) = (between(exact), between(polygon)) {
        within("lost motion", one - other, bound)?;
        // Statuses part at no lost motion.
        if one.abs() <= bound {
            return Ok(());
        }
    }
    let [one, other] = [exact.status(), polygon.status()];
    if one == other
        || [exact, polygon]
            .into_iter()
            .any(|found| begins_a_land(assembly, found))
    {
        Ok(())
    } else {
        Err(format!("exact {}, polygon {}", one.name(), other.name()))
    }
}

/// Whether a contact lies where a fillet ends and a root land begins: either name is right, and with it either status.
fn begins_a_land(assembly: &GearPair, found: &LostMotion) -> bool {
    let contacts = [found.right, found.left].into_iter().flatten();
    let mut touches = contacts.flat_map(|contact| {
        [
            (Member::Wheel, contact.wheel),
            (Member::Pinion, contact.pinion),
        ]
    });
    touches.any(|(member, touch)| {
        touch.curve == ProfilePart::Fillet
            && (touch.radius - assembly.gear(member).gear().root_radius()).abs() <= JOINT
    })
}
