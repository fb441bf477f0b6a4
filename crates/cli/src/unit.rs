//! `--unit` and `--at`: the unit of backlash in tables and charts.

use super::gears::GearName;
use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::study::Study;
use gearlash::pair::BacklashUnit;

#[derive(clap::Args)]
pub(super) struct UnitArgs {
    /// Unit of backlash [default: um]
    #[arg(long, value_enum)]
    unit: Option<Name>,
    /// Gear whose lost motion is shown, for --unit arcmin [default: the gear that turns]
    #[arg(long, value_enum)]
    at: Option<GearName>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Name {
    /// j_wt in µm
    Um,
    /// Lost motion at one gear in arcmin
    Arcmin,
}

impl UnitArgs {
    /// Whether a unit or its gear is given.
    pub(super) fn given(&self) -> bool {
        self.unit.is_some() || self.at.is_some()
    }

    /// The unit for the gears of `study`.
    ///
    /// # Errors
    /// `--at` beside µm.
    pub(super) fn unit(&self, study: &Study) -> Result<BacklashUnit, Error> {
        match (self.unit, self.at) {
            (Some(Name::Arcmin), at) => {
                Ok(study.arcmin(at.map_or(study.locked.mate(), GearName::member)))
            }
            (Some(Name::Um) | None, Some(_)) => Err(Error::usage(
                "--at belongs to --unit arcmin: j_wt is the same at both gears; leave it out",
            )),
            _ => Ok(BacklashUnit::Um),
        }
    }

    /// The unit of a table for the gears of `study`.
    ///
    /// # Errors
    /// As [`UnitArgs::unit`]; a unit for an output other than text.
    pub(super) fn of_table(&self, study: &Study, is_text: bool) -> Result<BacklashUnit, Error> {
        let unit = self.unit(study)?;
        if self.given() && !is_text {
            return Err(Error::usage(
                "--unit belongs to --format text: JSON and CSV have every unit; leave it out",
            ));
        }
        Ok(unit)
    }
}
