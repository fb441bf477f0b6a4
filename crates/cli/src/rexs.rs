//! Gearbox models (REXS): the content of one, and the pair file of a stage.

use super::console::{check_not_input, print};
use super::target::Target;
use crate::error::Error;
use gearlash_files::rexs::{RexsFile, RexsPair};
use gearlash_results::text::{Screen, rexs};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

/// Options for a gearbox model.
#[derive(clap::Args)]
pub(super) struct RexsArgs {
    /// Stage of a gearbox model, by its id
    #[arg(long, value_name = "ID", allow_negative_numbers = true)]
    stage: Option<i32>,
    /// Also write the pair file, - for standard output alone
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

impl RexsArgs {
    /// Whether an option is given.
    pub fn is_given(&self) -> bool {
        self.stage.is_some() || self.output.is_some()
    }
}

/// Prints the content of the model at `path`, and the pair file of a stage.
pub(super) fn import(path: &Path, args: &RexsArgs, screen: &Screen) -> Result<ExitCode, Error> {
    let file = gearlash_files::rexs::read(path)?;
    check_not_input(&file.sources)?;
    let name = gearlash_files::named(path).display().to_string();
    let chosen = match args.stage {
        Some(id) => Ok(pair_of(&name, &file, id)?),
        None => only_readable_stage(&file),
    };
    if let (Err(why), Some(_)) = (&chosen, &args.output) {
        return Err(Error::Usage(format!("{name}: {why}")));
    }
    let is_stdout = |output: &PathBuf| output.as_path() == Path::new("-");
    if !args.output.as_ref().is_some_and(is_stdout) {
        let mut text = rexs::text(&name, &file, screen);
        match &chosen {
            Ok(pair) => text += &format!("\n{}", rexs::pair(pair, screen)),
            Err(why) => text += &format!("\n{why}\n"),
        }
        if let (Ok(pair), None) = (&chosen, &args.output) {
            text += &format!("\n{}", pair.pair_file);
        }
        print(&text)?;
    }
    if let (Some(output), Ok(pair)) = (&args.output, chosen) {
        Target::prepare_new(output, &file.sources, "import")?.write(&pair.pair_file)?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The only readable stage, or the remedy.
fn only_readable_stage(file: &RexsFile) -> Result<&RexsPair, String> {
    let stages = file.stages.iter();
    let mut pairs = stages.filter_map(|stage| stage.pair.as_ref().ok());
    match (pairs.next(), pairs.next()) {
        (Some(pair), None) => Ok(pair),
        (None, _) => Err("No stage can be read; each reason stands above.".to_owned()),
        _ => Err("Several stages can be read: choose one with --stage ID.".to_owned()),
    }
}

/// The pair of the stage with an id in the model called `name`.
fn pair_of<'a>(name: &str, file: &'a RexsFile, id: i32) -> Result<&'a RexsPair, Error> {
    let Some(stage) = file.stage(id) else {
        let ids = file.stages.iter().map(|stage| stage.id.to_string());
        let ids = ids.collect::<Vec<_>>().join(", ");
        return Err(Error::Usage(format!(
            "{name}: has no stage {id}, its stages are {ids}"
        )));
    };
    let left_out = |why| Error::Usage(format!("{name}: stage {id} is left out: {why}"));
    stage.pair.as_ref().map_err(left_out)
}
