//! `[runout]`: eccentricity and wobble of the teeth about the rotation axis.

use super::helix::missing_face;
use super::known_gear::KnownGear;
use super::spec::{FaceRunoutSpec, ReadingPlace, RunoutPlaneSpec, RunoutSpec, TeethEnd};
use gearlash::metrology::{self, ProbeReadings, ReadWith, RunoutAt, RunoutStatement, Wobble};
use gearlash_tables::{Quantity, Sheet};
use gearlash_text::Table;

/// Runout `F_r`, the tooth towards which the teeth are displaced, and their wobble.
#[derive(Debug, Clone, Default)]
pub struct RunoutSheet {
    /// As in the pair file; 0 for readings until they are fitted.
    pub spec: RunoutSpec,
    /// In the measuring plane, where two planes state it.
    of_planes: Option<metrology::Runout>,
    pub wobble: Wobble,
    readings: Option<ProbeReadings>,
}

impl RunoutSheet {
    /// Reads the runout `spec` of the gear's table `gear`. `known` is `None` for a drawn gear.
    pub fn read(
        gear: &Table,
        spec: RunoutSpec,
        teeth: Option<u32>,
        known: Option<&KnownGear>,
    ) -> Option<RunoutSheet> {
        let table = gear.below("runout");
        let beyond = |tooth: f64| teeth.filter(|teeth| tooth >= f64::from(*teeth) + 1.0);
        let planes = spec.planes.iter().flatten();
        let planes = planes.map(|plane| ("planes", Some(plane.high_tooth)));
        let shoulder = spec.face_runout.map(|face| face.high_tooth);
        let others = [
            ("high_tooth", spec.high_tooth),
            ("face_runout.high_tooth", shoulder),
        ];
        for (key, tooth) in planes.chain(others) {
            if let Some(teeth) = tooth.and_then(beyond) {
                return table.refuse(
                    key,
                    format!(
                        "{}out of range, allowed is 1 up to, but not including, {}",
                        if key == "planes" { "a high_tooth " } else { "" },
                        teeth + 1
                    ),
                    "give the number of the tooth at the highest reading",
                );
            }
        }
        let runout = RunoutSheet {
            spec,
            ..RunoutSheet::default()
        };
        let runout = runout.with_wobble(gear, &table, known)?;
        let Some(at) = runout.spec.at else {
            return Some(runout);
        };
        let spec = &runout.spec;
        if at == ReadingPlace::Tooth && spec.ball_mm.is_some() {
            return table.refuse(
                "ball_mm",
                "goes with at = \"space\": no ball stands at a tooth's centre line",
                "remove it, or write at = \"space\"",
            );
        }
        let sheet = Sheet::of_one_quantity(&table, Quantity::Runout, teeth)?;
        if at == ReadingPlace::Tooth && sheet.origin.as_ref().is_some_and(|origin| origin.by_space)
        {
            return table.refuse(
                "at",
                "the headings of the file name spaces",
                "write at = \"space\"",
            );
        }
        if let Some(known) = known {
            known.headers.borrow_mut().push(sheet.header.clone());
        }
        Some(RunoutSheet {
            readings: Some(ProbeReadings {
                um: sheet.values(0),
                with: match (at, spec.ball_mm) {
                    (ReadingPlace::Tooth, _) => ReadWith::Fork,
                    (ReadingPlace::Space, Some(diameter)) => ReadWith::Ball(diameter),
                    (ReadingPlace::Space, None) => ReadWith::AnyBall,
                },
            }),
            spec: RunoutSpec {
                face_runout: spec.face_runout,
                ball_mm: spec.ball_mm,
                ..RunoutSpec::default()
            },
            ..runout
        })
    }

    /// This runout with the wobble that its statements say.
    fn with_wobble(
        mut self,
        gear: &Table,
        table: &Table,
        known: Option<&KnownGear>,
    ) -> Option<RunoutSheet> {
        let (planes, shoulder) = (self.spec.planes, self.spec.face_runout);
        let key = match (planes, shoulder) {
            (Some(_), _) => "planes",
            (None, Some(_)) => "face_runout",
            (None, None) => return Some(self),
        };
        let Some(known) = known else {
            return table.refuse(
                key,
                "stated of an outline, which is solved in one section",
                "state total_um and high_tooth",
            );
        };
        let Some(heights) = known.heights()? else {
            return gear.refuse(
                "face_width_mm",
                missing_face(format!(", beside {}", table.path_of(key))),
                "give the length of the teeth along the axis: the wobble displaces the teeth along all of it",
            );
        };
        let data = &known.basic_data?;
        if let Some(planes) = planes {
            let [one, other] = planes.map(|plane| plane.from_reference_face_mm);
            let width = heights[1] - heights[0];
            if one == other || one.max(other) > width {
                return table.refuse(
                    key,
                    format!("at heights {one} and {other} mm, allowed are two heights from 0 to {width} mm"),
                    "give two heights on the teeth, from the reference face's end",
                );
            }
            let at = |plane: RunoutPlaneSpec| RunoutAt {
                height: heights[0] + plane.from_reference_face_mm,
                total_um: plane.total_um,
                high_tooth: plane.high_tooth,
            };
            let (runout, wobble) = Wobble::of_planes(data, planes.map(at));
            (self.of_planes, self.wobble, self.spec.total_um) = (Some(runout), wobble, None);
        }
        if let Some(FaceRunoutSpec {
            um: total_um,
            diameter_mm,
            high_tooth,
            face,
        }) = shoulder
        {
            if face.is_none() {
                known.warnings.borrow_mut().push(format!(
                    "{}: not stated, the shoulder counts as one that looks the way of the reference face; write face = \"reference\", or \"far\" where it \
                     looks the other way",
                    table.path_of("face_runout.face")
                ));
            }
            let is_far = face == Some(TeethEnd::Far);
            let at = RunoutAt {
                height: heights[usize::from(is_far)],
                total_um,
                high_tooth,
            };
            self.wobble = Wobble::of_shoulder(data, at, diameter_mm, is_far);
            self.spec.face_runout = self.spec.face_runout.map(|stated| FaceRunoutSpec {
                face: Some(face.unwrap_or_default()),
                ..stated
            });
        }
        Some(self)
    }

    /// The measurement as the metrology takes it.
    pub fn for_metrology(&self) -> RunoutStatement {
        let runout = self.of_planes.unwrap_or(metrology::Runout {
            total_um: self.spec.total(),
            high_tooth: self.spec.high_tooth,
        });
        match &self.readings {
            Some(readings) => RunoutStatement::Readings(readings.clone()),
            None if runout.total_um == 0.0 && runout.high_tooth.is_none() => RunoutStatement::None,
            None => RunoutStatement::Total(runout),
        }
    }

    /// The runout of the gear as measured, as in the pair file.
    pub fn spec_as_measured(&self, runout: metrology::Runout) -> RunoutSpec {
        if self.of_planes.is_some() {
            return self.spec.clone();
        }
        RunoutSpec {
            total_um: Some(runout.total_um),
            high_tooth: runout.high_tooth,
            face_runout: self.spec.face_runout,
            ball_mm: self.spec.ball_mm,
            ..RunoutSpec::default()
        }
    }

    /// Range of its readings, µm; `None` without readings.
    pub fn range_um(&self) -> Option<f64> {
        self.readings.as_ref().map(ProbeReadings::range_um)
    }

    /// The key, below the gear's table, that gives it.
    pub fn key(&self) -> &'static str {
        if self.of_planes.is_some() {
            "runout.planes"
        } else if self.readings.is_some() {
            "runout.file"
        } else {
            "runout.total_um"
        }
    }
}
