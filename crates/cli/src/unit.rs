//! `--unit` and `--at`: what tables and charts show backlash in.

use super::drawing::Gear;
use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::study::Study;
use gearlash::pair::BacklashUnit;

#[derive(clap::Args)]
pub(super) struct UnitArgs {
    /// What backlash is shown in [default: um]
    #[arg(long, value_enum)]
    unit: Option<Name>,
    /// The gear whose lost motion is shown, its mate locked, for --unit arcmin [default: the gear that turns]
    #[arg(long, value_enum)]
    at: Option<Gear>,
}

#[derive(Clone, Copy, PartialEq, ValueEnum)]
enum Name {
    /// j_wt in µm
    Um,
    /// Lost motion at one gear in arcmin
    Arcmin,
}

impl UnitArgs {
    /// Whether a unit or its gear was asked for.
    pub(super) fn given(&self) -> bool {
        self.unit.is_some() || self.at.is_some()
    }

    /// The unit for the gears of `study`.
    ///
    /// # Errors
    /// `--at` beside µm.
    pub(super) fn unit(&self, study: &Study) -> Result<BacklashUnit, Error> {
        let gears = study.materials.first();
        match (self.unit, self.at, gears) {
            (Some(Name::Arcmin), at, Some((_, wheel, pinion))) => {
                let at = at.map_or(study.locked.mate(), Gear::member);
                Ok(BacklashUnit::arcmin(at, wheel.gear(), pinion.gear()))
            }
            (Some(Name::Um) | None, Some(_), _) => Err(Error::Usage(
                "--at belongs to --unit arcmin: j_wt is the same at both gears; leave it out"
                    .to_owned(),
            )),
            _ => Ok(BacklashUnit::Um),
        }
    }
}
