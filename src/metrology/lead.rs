//! Stated lead deviations: their checks and findings.

use super::error::{LeadKey, MeasurementError};
use crate::gear::{AsBuilt, Deviations, Face, Flank, Gear, Lead};

/// The keys of a lead that are checked alone, and all together last.
const KEYS: [LeadKey; 4] = [
    LeadKey::Range,
    LeadKey::EndRelief,
    LeadKey::Trace,
    LeadKey::All,
];

/// The deviation of one key of `lead`, over its evaluation range from its zero.
fn with_key_alone(lead: &Lead, key: LeadKey) -> Lead {
    let mut alone = Lead {
        face: lead.face,
        range: lead.range,
        zero: lead.zero,
        ..Lead::default()
    };
    match key {
        LeadKey::EndRelief => alone.end_reliefs = lead.end_reliefs.clone(),
        LeadKey::Trace => alone.traces = lead.traces.clone(),
        LeadKey::All => alone = lead.clone(),
        LeadKey::Range => {}
    }
    alone
}

/// Errors of `leads` on `gear`, the first of each flank.
pub(super) fn check(gear: &Gear, face: Face, leads: &[Lead; 2]) -> Vec<MeasurementError> {
    let teeth = gear.basic_data().teeth();
    let mut errors = Vec::new();
    for (index, (flank, lead)) in Flank::BOTH.into_iter().zip(leads).enumerate() {
        if lead.is_none() {
            continue;
        }
        let fault = |key| {
            let mut alone = Deviations::default();
            alone.leads[index] = with_key_alone(lead, key);
            let built = alone.leads[index]
                .curves(teeth)
                .and_then(|_| AsBuilt::new(gear.clone(), face, &alone));
            built
                .err()
                .map(|error| MeasurementError::Lead { flank, key, error })
        };
        errors.extend(KEYS.into_iter().find_map(fault));
    }
    errors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gear::{EndRelief, GearDesign, Trace};
    use crate::metrology::{Finding, Measurements, SomeTeeth};

    /// A gear of module 3 with these leads of its left flanks.
    fn measured(lead: Lead) -> Result<Vec<Finding>, Vec<MeasurementError>> {
        let measurements = Measurements {
            leads: [Lead::default(), lead],
            ..Measurements::nominal(GearDesign::plain(20, 3.0), Face::Back)
        };
        measurements.measure().map(|gear| gear.findings)
    }

    /// A crown over a face of 40 mm, with this change.
    fn lead(change: impl Fn(&mut Lead)) -> Lead {
        let mut lead = Lead {
            face: [0.0, 40.0],
            range: [2.0, 38.0],
            crowning: 0.008,
            ..Lead::default()
        };
        change(&mut lead);
        lead
    }

    fn trace(tooth: Option<u32>, points: &[(f64, f64)]) -> Trace {
        Trace {
            tooth,
            points: points.to_vec(),
        }
    }

    #[test]
    fn errors_name_flank_and_key() {
        let ranged = |range| lead(|lead| lead.range = range);
        let relieved = |amount, length| {
            let relief = EndRelief {
                amount,
                length,
                at_far_end: true,
                parabolic: false,
            };
            lead(|lead| lead.end_reliefs = vec![relief])
        };
        let traced = |points: &[(f64, f64)]| lead(|lead| lead.traces = vec![trace(None, points)]);
        for (expected, lead) in [
            (LeadKey::Range, ranged([-2.0, 38.0])),
            (LeadKey::Range, ranged([38.0, 2.0])),
            (LeadKey::Range, lead(|lead| lead.zero = 41.0)),
            (
                LeadKey::Range,
                lead(|lead| (lead.face, lead.range) = ([5.0; 2], [5.0; 2])),
            ),
            (LeadKey::EndRelief, relieved(0.01, 50.0)),
            (LeadKey::EndRelief, relieved(-0.001, 5.0)),
            (LeadKey::Trace, traced(&[(1.0, 0.0)])),
            (LeadKey::Trace, traced(&[(1.0, 0.0), (1.0, 0.0)])),
            // Thicker than the space at the far end.
            (LeadKey::All, lead(|lead| lead.slope = 12.0)),
        ] {
            match &measured(lead).unwrap_err()[..] {
                [MeasurementError::Lead { flank, key, .. }] => {
                    assert_eq!((*flank, *key), (Flank::Left, expected));
                }
                other => panic!("{expected:?}: {other:?}"),
            }
        }
    }

    #[test]
    fn teeth_without_a_trace_are_reported() {
        let ends = [(0.0, 0.0), (40.0, 0.005)];
        let traces = [1, 6, 11].map(|tooth| trace(Some(tooth), &ends));
        let found = measured(lead(|lead| lead.traces = traces.to_vec())).unwrap();
        let expected = Finding::LeadOfSomeTeeth(SomeTeeth {
            flank: Flank::Left,
            measured: 3,
            teeth: 20,
        });
        assert_eq!(found, [expected]);
    }
}
