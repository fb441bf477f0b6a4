//! Reads a pair file, finds its worst pose and draws it.
//!
//! `cargo run --release -p gearlash-render --example from_a_file -- fixtures/karba_44x44.toml > worst.svg`

use gearlash::analysis::outcome::Outcome;
use gearlash::analysis::{Analysis, Plan};
use gearlash::contact::Method;
use gearlash_render::{Snapshot, snapshot};
use std::error::Error;
use std::path::Path;

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("name a pair file")?;
    let study = gearlash_input::read(Path::new(&file))?.study;
    let plan = Plan::new(&study, Method::Exact { certify: true });
    let analysis = Analysis::silently(&plan)?;
    let runs: Vec<_> = analysis.all().collect();
    let worst = Outcome::of(&runs, &[]).worst.ok_or("no pose is proven")?;
    let run = &worst.run.run;
    print!(
        "{}",
        snapshot(&Snapshot {
            title: &study.title,
            assembly: &run.assembly,
            pose: &worst.pose.simulated.pose,
            material: run.material,
            found: worst.pose.simulated.found.as_ref(),
            section: None,
        })
    );
    Ok(())
}
