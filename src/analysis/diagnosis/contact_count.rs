//! Contacts over a run: how often each class occurs, and its cost in backlash.

use crate::analysis::compare::ComparedPose;
use crate::analysis::study::Material;
use crate::analytic::limits;
use crate::contact::{Contact, ContactClass, ContactKind, PoseClass};
use crate::gear::Side;
use crate::pair::{GearPair, Pose};
use std::collections::BTreeMap;

/// Poses by class, and the lost motion that formulas miss.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ContactCount {
    /// Poses of each class that occurs, in order of severity.
    pub classes: BTreeMap<PoseClass, usize>,
    /// Poses of the classes in which something other than involutes touches, with less backlash than the formula beyond
    /// their error bounds. A tip corner that touches on the line of action costs nothing.
    pub off_line: usize,
    /// The pose off the line with the greatest loss.
    pub worst_off_line: Option<Worst>,
    /// `None` if no pose has both a formula and a lost motion.
    pub loss: Option<Loss>,
}

/// Backlash by formula minus simulated backlash, mm of `j_wt`. The formula is model 3, or model 2 if that has no value.
#[derive(Debug, Clone, PartialEq)]
pub struct Loss {
    /// Least.
    pub least: f64,
    /// Mean over `poses`.
    pub mean: f64,
    /// Poses with a value.
    pub poses: usize,
    /// Greatest.
    pub worst: Worst,
}

/// The pose with the greatest loss, the first of equals.
#[derive(Debug, Clone, PartialEq)]
pub struct Worst {
    /// The pair.
    pub assembly: GearPair,
    /// Its material.
    pub material: Material,
    /// Positions of the gears.
    pub pose: Pose,
    /// Class of the contacts there.
    pub class: PoseClass,
    /// The side of the more severe contact; right if both are equal.
    pub side: Side,
    /// That contact: its teeth, curves and radii.
    pub contact: Contact,
    /// Simulated `j_wt`, mm.
    pub backlash: f64,
    /// The formula's `j_wt` minus the simulated one, mm.
    pub loss: f64,
}

impl ContactCount {
    /// Poses counted.
    pub fn poses(&self) -> usize {
        self.classes.values().sum()
    }

    /// Poses whose class satisfies `which`.
    pub fn of_class(&self, which: impl Fn(PoseClass) -> bool) -> usize {
        let matching = self.classes.iter().filter(|(class, _)| which(**class));
        matching.map(|(_, count)| count).sum()
    }

    /// Adds the counts of `other`.
    pub(super) fn extend(&mut self, other: &ContactCount) {
        for (class, poses) in &other.classes {
            *self.classes.entry(*class).or_default() += poses;
        }
        self.off_line += other.off_line;
        if let Some(worst) = &other.worst_off_line
            && is_worse(worst.loss, self.worst_off_line.as_ref())
        {
            self.worst_off_line = Some(worst.clone());
        }
        let Some(of_other) = &other.loss else {
            return;
        };
        let Some(known) = &mut self.loss else {
            self.loss = Some(of_other.clone());
            return;
        };
        known.least = known.least.min(of_other.least);
        known.poses += of_other.poses;
        known.mean += (of_other.mean - known.mean) * of_other.poses as f64 / known.poses as f64;
        if is_worse(of_other.worst.loss, Some(&known.worst)) {
            known.worst = of_other.worst.clone();
        }
    }

    /// Adds a pose of `assembly`.
    pub(crate) fn add(&mut self, assembly: &GearPair, material: Material, pose: &ComparedPose) {
        let class = pose.simulated.class(assembly);
        *self.classes.entry(class).or_default() += 1;
        let others_touch = !matches!(
            class,
            PoseClass::NoContact | PoseClass::Unproven | PoseClass::Contact(ContactKind::Involute)
        );
        let both = pose.line_of_action.zip(pose.simulated.backlash);
        let difference = both.map(|(formula, backlash)| formula - backlash);
        let bound = pose.simulated.error_bound.unwrap_or(0.0);
        let costs = difference.is_none_or(|loss| loss > bound + limits::MET_WITHIN);
        let is_off_line = others_touch && costs;
        self.off_line += usize::from(is_off_line);
        let formula = pose.line_of_action.or(pose.involute);
        let (Some(backlash), Some(formula)) = (pose.simulated.backlash, formula) else {
            return;
        };
        let loss = formula - backlash;
        let is_worst = is_worse(loss, self.loss.as_ref().map(|known| &known.worst));
        let is_worst_off_line = is_off_line && is_worse(loss, self.worst_off_line.as_ref());
        if is_worst || is_worst_off_line {
            let Some((side, contact)) = graver(assembly, pose) else {
                return;
            };
            let worst = Worst {
                assembly: assembly.clone(),
                material,
                pose: pose.simulated.pose,
                class,
                side,
                contact,
                backlash,
                loss,
            };
            if is_worst_off_line {
                self.worst_off_line = Some(worst.clone());
            }
            if is_worst {
                match &mut self.loss {
                    Some(known) => known.worst = worst,
                    None => {
                        self.loss = Some(Loss {
                            least: loss,
                            mean: 0.0,
                            poses: 0,
                            worst,
                        });
                    }
                }
            }
        }
        if let Some(known) = &mut self.loss {
            known.least = known.least.min(loss);
            known.poses += 1;
            known.mean += (loss - known.mean) / known.poses as f64;
        }
    }
}

/// Whether `loss` exceeds that of the `known` worst pose. Losses that differ by rounding are equal.
fn is_worse(loss: f64, known: Option<&Worst>) -> bool {
    known.is_none_or(|known| loss > known.loss + limits::MET_WITHIN)
}

fn graver(assembly: &GearPair, pose: &ComparedPose) -> Option<(Side, Contact)> {
    let found = pose.simulated.proven()?;
    let (right, left) = (found.right?, found.left?);
    let kind = |side, contact| ContactClass::of(assembly, side, contact).kind;
    if kind(Side::Left, &left) > kind(Side::Right, &right) {
        Some((Side::Left, left))
    } else {
        Some((Side::Right, right))
    }
}
