//! `gearlash chart --kind field`: the field of action of helical gears.

use super::super::drawing::material;
use super::super::method::all_proven;
use super::super::worst;
use super::Args;
use super::drawn::{DrawnChart, asked_distance};
use crate::error::Error;
use gearlash::analysis::curves::Field;
use gearlash::analysis::study::Study;
use gearlash_files::numbers::stated_distance;
use gearlash_render::chart::{self, Heading};

/// That of the pose which binds.
pub(super) fn drawn(args: &Args, study: Study) -> Result<DrawnChart, Error> {
    if !study.is_helical() {
        return Err(Error::Usage(
            "--kind field is for helical gears: along the face of spur gears nothing changes"
                .to_owned(),
        ));
    }
    let distance = asked_distance(args)?;
    let end = args.material.map(|end| material(end, &study)).transpose()?;
    let title = study.title.clone();
    let (run, pose, unproven) = worst::find("--kind field", study, distance, end)?;
    let field = Field::of(&run.assembly, &pose).ok_or_else(|| {
        Error::Usage(
            "--kind field: the worst pose is jammed or unproven; there are no contact lines"
                .to_owned(),
        )
    })?;
    let a = run.assembly.center_distance();
    let subtitle = format!(
        "Field of action at the least backlash · a = {} mm · {}",
        stated_distance(a),
        run.material.words()
    );
    let heading = Heading {
        prefix: "chart",
        title: &title,
        subtitle: &subtitle,
    };
    Ok(DrawnChart {
        svg: chart::field(&heading, &field)?.svg,
        file: format!("chart_field_a{a}_{}.svg", run.material.name()),
        agrees: all_proven(unproven),
    })
}
