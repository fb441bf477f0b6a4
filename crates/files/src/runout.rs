//! `[runout]`: the distance of the teeth from the rotation axis.

use super::sheet::{Column, Header, Sheet};
use super::spec::{ReadingPlace, RunoutSpec};
use super::table::Table;
use gearlash::metrology::{self, ProbeReadings, ReadWith, RunoutStatement};

/// Runout `F_r` and the tooth towards which the teeth are displaced.
#[derive(Debug, Clone, Default)]
pub struct Runout {
    /// As in the pair file; 0 for readings until they are fitted.
    pub spec: RunoutSpec,
    /// The readings that it comes from.
    readings: Option<ProbeReadings>,
    /// Statements about the gear in the file of the readings.
    pub header: Option<Header>,
}

impl Runout {
    /// Reads the runout `spec` of the gear's table `gear`.
    pub fn read(gear: &Table, spec: RunoutSpec, teeth: Option<u32>) -> Option<Runout> {
        let table = gear.below("runout");
        let beyond = |tooth: &f64| teeth.is_some_and(|teeth| *tooth >= f64::from(teeth) + 1.0);
        if let (Some(_), Some(teeth)) = (spec.high_tooth.filter(beyond), teeth) {
            return table.refuse(
                "high_tooth",
                format!(
                    "out of range, allowed is 1 up to, but not including, {}",
                    teeth + 1
                ),
                "give the number of the tooth at the highest reading",
            );
        }
        let Some(at) = spec.at else {
            return Some(Runout {
                spec,
                ..Runout::default()
            });
        };
        if at == ReadingPlace::Tooth && spec.ball_mm.is_some() {
            return table.refuse(
                "ball_mm",
                "goes with at = \"space\": no ball stands at a tooth's centre line",
                "remove it, or write at = \"space\"",
            );
        }
        let sheet = Sheet::of_every_tooth(&table, &[Column::Runout], teeth)?;
        if at == ReadingPlace::Tooth && sheet.origin.as_ref().is_some_and(|origin| origin.by_space)
        {
            return table.refuse(
                "at",
                "the readings of the file are numbered by spaces",
                "write at = \"space\"",
            );
        }
        Some(Runout {
            readings: Some(ProbeReadings {
                um: sheet.values(0),
                with: match (at, spec.ball_mm) {
                    (ReadingPlace::Tooth, _) => ReadWith::Fork,
                    (ReadingPlace::Space, Some(diameter)) => ReadWith::Ball(diameter),
                    (ReadingPlace::Space, None) => ReadWith::AnyBall,
                },
            }),
            header: Some(sheet.header),
            spec: RunoutSpec::default(),
        })
    }

    /// The measurement as the metrology takes it.
    pub fn measured(&self) -> RunoutStatement {
        let RunoutSpec {
            total_um,
            high_tooth,
            ..
        } = self.spec;
        match &self.readings {
            Some(readings) => RunoutStatement::Readings(readings.clone()),
            None if total_um == 0.0 && high_tooth.is_none() => RunoutStatement::None,
            None => RunoutStatement::Total {
                total_um,
                high_tooth,
            },
        }
    }

    /// The runout of the gear as measured, as in the pair file.
    pub fn settled(&self, runout: metrology::Runout) -> RunoutSpec {
        RunoutSpec {
            total_um: runout.total_um,
            high_tooth: runout.high_tooth,
            ..RunoutSpec::default()
        }
    }

    /// The key, below the gear's table, that gives it.
    pub fn key(&self) -> &'static str {
        if self.readings.is_some() {
            "runout.file"
        } else {
            "runout.total_um"
        }
    }
}
