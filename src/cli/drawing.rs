//! What the commands that draw share: whom to draw, and where the picture goes.

use super::print;
use crate::error::Error;
use crate::output::OutputFolder;
use crate::study::{Material, Study};
use clap::ValueEnum;
use std::path::Path;
use std::process::ExitCode;

/// `--material`.
#[derive(Clone, Copy, ValueEnum)]
pub(super) enum End {
    Most,
    Least,
}

/// Wheel and pinion tooth, such as `11,11`.
pub(super) fn teeth(text: &str) -> Result<(u32, u32), String> {
    let parsed = text.split_once(',').and_then(|(wheel, pinion)| {
        Some((wheel.trim().parse().ok()?, pinion.trim().parse().ok()?))
    });
    parsed.ok_or_else(|| "two tooth numbers are needed, wheel,pinion, such as 11,11".to_owned())
}

/// Writes the picture to `target` and prints where it is; to standard output when that is `-`.
pub(super) fn write(target: &Path, picture: String) -> Result<ExitCode, Error> {
    if target == Path::new("-") {
        print(&picture);
        return Ok(ExitCode::SUCCESS);
    }
    let missing_name = || Error::Usage(format!("-o {}: this names no file", target.display()));
    let file = target.file_name().ok_or_else(missing_name)?;
    let folder = match target.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    OutputFolder::prepare(folder)?.write(&[(file.to_string_lossy().into_owned(), picture)])?;
    print(&format!("{}\n", target.display()));
    Ok(ExitCode::SUCCESS)
}

/// The material of `study` that `--material` names.
pub(super) fn material(end: End, study: &Study) -> Result<Material, Error> {
    match (end, study.materials.len()) {
        (End::Most, 2) => Ok(Material::Most),
        (End::Least, 2) => Ok(Material::Least),
        _ => Err(Error::Usage(
            "--material: this pair file states one thickness a gear; leave the option out"
                .to_owned(),
        )),
    }
}
