//! Gears from measurements in memory: the deviations of a model are found again, what no gear has is refused, and drawings are read as printed.

mod drawing;
#[path = "../check/kit.rs"]
mod kit;
mod refused;

use gearlash::analytic::InvolutePair;
use gearlash::error::GearError;
use gearlash::gear::{
    Face, Gear, GearDesign, MeasuringBody, PitchAxis, Side, ThicknessField, thickness,
};
use gearlash::metrology::{
    CrossCheck, DeviationCause, EccentricitySource, Finding, Fits, FlankKnowledge, MeasuredGear,
    MeasurementError, Measurements, Outlier, PitchKind, PitchSense, PitchStatement, ProbeReadings,
    ReadWith, Runout, RunoutStatement, StatementRole, ThicknessStatement, Toleranced,
};
use gearlash::pair::DesignatedDistance;
use kit::{inv, near, spur};
use std::f64::consts::TAU;

const TEETH: u32 = 21;
/// `k` of the spans.
const SPANNED: u32 = 3;
/// Eccentricity of the gear, mm, and the tooth it points to.
const ECCENTRICITY: f64 = 0.02;
const HIGH_TOOTH: f64 = 6.25;

fn design() -> GearDesign {
    GearDesign {
        tip_diameter: Some(69.0),
        ..spur(TEETH, 3.0).design
    }
}

fn total(total_um: f64, high_tooth: f64) -> RunoutStatement {
    RunoutStatement::Total(Runout {
        total_um,
        high_tooth: Some(high_tooth),
    })
}

/// The deviations of a model: thickness and pitch deviation of each tooth about their means, mm.
struct Truth {
    base_thickness: f64,
    per_tooth: Vec<f64>,
    right: Vec<f64>,
    left: Vec<f64>,
}

impl Truth {
    fn new() -> Truth {
        let wave = |amount: f64, order: f64, from: f64| -> Vec<f64> {
            let angles = (0..TEETH).map(|i| order * TAU * f64::from(i) / f64::from(TEETH));
            angles.map(|angle| amount * (angle + from).sin()).collect()
        };
        Truth {
            base_thickness: design().nominal_base_thickness() - 0.04,
            per_tooth: wave(0.004, 4.0, 0.3),
            right: wave(0.006, 2.0, 0.0),
            left: wave(0.005, 2.0, 0.2),
        }
    }

    /// Where the own flanks of the tooth `steps` on from tooth `index` + 1 stand, right and left: `F ± δ/2`.
    fn flanks(&self, index: u32, steps: u32) -> (f64, f64) {
        let at = ((index + steps) % TEETH) as usize;
        let half = self.per_tooth[at] / 2.0;
        (self.right[at] + half, self.left[at] - half)
    }

    /// `W_k = (k − 1) p_b + s_b + cos α (x_R,i+k−1 − x_L,i)` (own derivation in `gear::Spans`).
    fn spans(&self) -> ThicknessStatement {
        let basic_data = design().basic_data;
        let span = |index| {
            let (right, _) = self.flanks(index, SPANNED - 1);
            let (_, left) = self.flanks(index, 0);
            f64::from(SPANNED - 1) * basic_data.base_pitch()
                + self.base_thickness
                + basic_data.pressure_angle().cos() * (right - left)
        };
        ThicknessStatement::SpanReadings {
            teeth: SPANNED,
            readings: (0..TEETH).map(|index| (index + 1, span(index))).collect(),
            per_tooth: true,
        }
    }

    fn pitch(&self) -> PitchStatement {
        let um = |mm: &[f64]| mm.iter().map(|mm| 1000.0 * mm).collect();
        PitchStatement {
            kind: PitchKind::Cumulative,
            axis: PitchAxis::Own,
            sense: PitchSense::Numbers,
            eccentricity: None,
            right_um: um(&self.right),
            left_um: um(&self.left),
        }
    }

    /// The reading of a fork to first order in `e`, µm: `e cos θ + (x_R − x_L)/(2 tan α)` (`gear::RunoutReadings`).
    fn fork(&self) -> ProbeReadings {
        let basic_data = design().basic_data;
        let reading = |index: u32| {
            let (right, left) = self.flanks(index, 0);
            let angle = (f64::from(index + 1) - HIGH_TOOTH) * basic_data.angular_pitch();
            let alpha = basic_data.pressure_angle();
            1000.0 * (ECCENTRICITY * angle.cos() + (right - left) / (2.0 * alpha.tan()))
        };
        ProbeReadings {
            um: (0..TEETH).map(reading).collect(),
            with: ReadWith::Fork,
        }
    }

    /// Spans all round, pitch about the gear's own axis, runout by a fork.
    fn measurements(&self) -> Measurements {
        Measurements {
            thickness: self.spans(),
            pitch: Some(self.pitch()),
            runout: RunoutStatement::Readings(self.fork()),
            ..Measurements::nominal(design(), Face::Front)
        }
    }

    /// Measurements with pitch about the datum axis, which contains the eccentricity to first order (design section 6:
    /// `F_R = −e sin(ψ − α)/cos α`, `F_L = −e sin(ψ + α)/cos α`), and a separate runout.
    fn about_datum(&self, counts: EccentricitySource) -> Measurements {
        let basic_data = design().basic_data;
        let alpha = basic_data.pressure_angle();
        // Half the angle of a tooth at the reference circle: s/d, s_b = cos α (s + d inv α).
        let half = self.base_thickness / (2.0 * basic_data.base_radius()) - inv(alpha);
        let with = |own: &[f64], ahead: f64| -> Vec<f64> {
            let reading = |(index, own): (usize, &f64)| {
                let tooth = (index as f64 + 1.0 - HIGH_TOOTH) * basic_data.angular_pitch();
                let sine = (tooth + ahead * half - ahead * alpha).sin();
                1000.0 * (own - ECCENTRICITY * sine / alpha.cos())
            };
            own.iter().enumerate().map(reading).collect()
        };
        Measurements {
            pitch: Some(PitchStatement {
                axis: PitchAxis::Datum,
                eccentricity: Some(counts),
                right_um: with(&self.right, 1.0),
                left_um: with(&self.left, -1.0),
                ..self.pitch()
            }),
            runout: total(2000.0 * ECCENTRICITY, HIGH_TOOTH),
            ..self.measurements()
        }
    }
}

fn measured(measurements: &Measurements) -> MeasuredGear {
    let gear = measurements.measure();
    gear.unwrap_or_else(|errors| panic!("{errors:?}"))
}

/// The value of `of` for the only finding to which it applies.
fn only<T>(gear: &MeasuredGear, of: impl Fn(&Finding) -> Option<T>) -> T {
    let mut found: Vec<T> = gear.findings.iter().filter_map(of).collect();
    assert_eq!(found.len(), 1, "{:#?}", gear.findings);
    found.remove(0)
}

/// Closed form: a flank turns by `x/r`, against the numbers' sense on the front face.
fn check_flanks(gear: &MeasuredGear, truth: &Truth, within: f64) {
    let built = gear.as_built.most();
    let base = built.gear().base_thickness();
    near("base", base, truth.base_thickness, within);
    let r = built.gear().basic_data().reference_radius();
    for tooth in 1..=TEETH {
        let (right, left) = truth.flanks(tooth - 1, 0);
        for (side, stands) in [(Side::Right, right), (Side::Left, left)] {
            let found = -r * built.flank_offset(side, tooth);
            near((tooth, side), found, stands, within);
        }
    }
}

/// Spans and pitch are exact; a fork's closed form lacks terms of `e²/r`, 0.013 µm.
#[test]
fn spans_pitch_and_fork_give_the_gear_that_was_put_in() {
    let truth = Truth::new();
    let gear = measured(&truth.measurements());
    check_flanks(&gear, &truth, 1e-12);
    let deviations = &gear.deviations;
    near("e", deviations.eccentricity, ECCENTRICITY, 2e-5);
    near("high tooth", deviations.high_tooth, HIGH_TOOTH, 0.01);
    let e = gear.as_built.most().eccentricity();
    assert_eq!(gear.runout.total_um, 2000.0 * e);
    let readings = only(&gear, |finding| match finding {
        Finding::RunoutReadings(readings) => Some(*readings),
        _ => None,
    });
    assert_eq!(readings.knowledge, FlankKnowledge::Pitch);
    assert!(readings.flanks_taken_out && readings.left_um < 0.05);
    assert_eq!(readings.eccentricity.um, 1000.0 * deviations.eccentricity);
    // Spans over 3 of 21 teeth close to one cycle of 21.
    let growth = only(&gear, |finding| match finding {
        Finding::SpansGiveEachTooth {
            spanned: SPANNED,
            teeth: TEETH,
            amplification,
            with_pitch: true,
        } => Some(*amplification),
        _ => None,
    });
    assert_eq!(growth, 21);
    assert_eq!(gear.findings.len(), 2, "{:#?}", gear.findings);
}

/// The closed form of the datum pitch lacks terms of `e²/r`, 0.013 µm; spans carry them into the teeth 21-fold at worst.
#[test]
fn mean_thickness_and_eccentricity_of_datum_pitch_settle_together() {
    let truth = Truth::new();
    for counts in [EccentricitySource::Pitch, EccentricitySource::Runout] {
        let gear = measured(&truth.about_datum(counts));
        check_flanks(&gear, &truth, 1e-4);
        let note = gear.notes.eccentricity.unwrap();
        near("e", note.in_pitch.um, 1000.0 * ECCENTRICITY, 0.02);
        near("high tooth", note.in_pitch.high_tooth, HIGH_TOOTH, 0.01);
        assert!(note.difference_um.unwrap() < 0.05);
        let said = only(&gear, |finding| match finding {
            Finding::EccentricityInPitch(note) => Some(*note),
            _ => None,
        });
        assert_eq!(said, note);
        let counted = gear.deviations.eccentricity;
        match counts {
            EccentricitySource::Pitch => assert_eq!(counted, note.in_pitch.um / 1000.0),
            EccentricitySource::Runout => assert_eq!(counted, ECCENTRICITY),
        }
    }
}
