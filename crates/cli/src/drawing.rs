//! What the commands that draw share: which gears and teeth.

use crate::error::Error;
use clap::ValueEnum;
use gearlash::analysis::study::{Material, Study};
use gearlash::pair::Member;

/// `--material`.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum End {
    Most,
    Least,
}

impl End {
    pub(super) fn material(self) -> Material {
        match self {
            End::Most => Material::Most,
            End::Least => Material::Least,
        }
    }
}

/// `--gear`, `--at`.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum Gear {
    Wheel,
    Pinion,
}

impl Gear {
    pub(super) fn member(self) -> Member {
        match self {
            Gear::Wheel => Member::Wheel,
            Gear::Pinion => Member::Pinion,
        }
    }
}

/// Wheel and pinion tooth, such as `11,11`.
pub(super) fn teeth(text: &str) -> Result<(u32, u32), String> {
    let parsed = text.split_once(',').and_then(|(wheel, pinion)| {
        Some((wheel.trim().parse().ok()?, pinion.trim().parse().ok()?))
    });
    parsed.ok_or_else(|| "two tooth numbers are needed, wheel,pinion, such as 11,11".to_owned())
}

/// The material of `study` that `--material` names.
pub(super) fn material(end: End, study: &Study) -> Result<Material, Error> {
    match study.material_count() {
        2 => Ok(end.material()),
        _ => Err(Error::Usage(
            "--material: this pair file states one thickness a gear; leave the option out"
                .to_owned(),
        )),
    }
}
