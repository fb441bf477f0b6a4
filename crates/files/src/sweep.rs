//! `[sweep]`: which poses are run.

use super::entry::{Entry, whole_in};
use super::limits::{FRACTION, STEPS_PER_PITCH};
use super::node::Node;
use super::problems::Problems;
use super::spec::{DEFAULT_STEPS, Phases, Revolutions, SweepSpec};
use super::table::Table;
use crate::error::Problem;
use gearlash::pair::SweepPlan;

pub const KEYS: &[&str] = &[
    "mating",
    "fraction",
    "revolutions",
    "steps_per_pitch",
    "start",
    "phases",
];

const REVOLUTIONS: [(&str, Revolutions); 2] = [
    ("wheel", Revolutions::Wheel),
    ("hunting", Revolutions::Hunting),
];

const PHASES: [(&str, Phases); 1] = [("all", Phases::All)];

/// The poses of every run, and how the pair file says it.
#[derive(Debug)]
pub struct Sweep {
    pub plan: SweepPlan,
    pub spec: SweepSpec,
}

impl Sweep {
    /// Reads `[sweep]`; when it is not there, one wheel revolution.
    pub fn read(
        file: &Table,
        teeth: (Option<u32>, Option<u32>),
        problems: &mut Problems,
    ) -> Option<Sweep> {
        let table = file.table("sweep", KEYS, problems)?;
        let there = |name| table.has(name) || table.is_mistyped(name);
        let kinds = ["mating", "revolutions", "phases"];
        let given: Vec<&str> = kinds.into_iter().filter(|name| there(name)).collect();
        if let [first, others @ ..] = &given[..]
            && let Some(second) = others.first()
        {
            problems.add(table.problem(
                second,
                format!(
                    "given together with {first}, allowed is one of mating, revolutions and phases"
                ),
                "remove one or the other",
            ));
            return None;
        }
        let [with_mating, with_revolutions, with_phases] = kinds.map(there);
        let mut alone = Some(());
        let revolutions = ("revolutions", with_revolutions, "revolutions = \"wheel\"");
        for (name, (mate, there, example)) in [
            ("fraction", ("mating", with_mating, "mating = [[1, 1]]")),
            (
                "steps_per_pitch",
                (
                    "revolutions or phases",
                    with_revolutions || with_phases,
                    revolutions.2,
                ),
            ),
            ("start", revolutions),
        ] {
            if table.has(name) && !there {
                problems.add(table.problem(
                    name,
                    format!("given without {mate}, {name} is allowed only with {mate}"),
                    format!("add `{example}`, or remove {name}"),
                ));
                alone = None;
            }
        }
        if with_mating {
            let matings = matings(&table, teeth, problems);
            let fractions = fractions(&table, problems);
            alone?;
            Some(Sweep::of_matings(matings?, fractions?))
        } else if with_revolutions || !file.has("sweep") {
            let revolution = table.choice_or_first("revolutions", &REVOLUTIONS, problems);
            let steps = steps_per_pitch(&table, problems);
            let start = match table.optional("start") {
                Some(Some(entry)) => problems.keep(pair_of_teeth(&entry, teeth)),
                absent => absent.map(|_| (1, 1)),
            };
            alone?;
            let teeth = (teeth.0?, teeth.1?);
            Some(Sweep::of_revolution(revolution?, steps?, start?, teeth))
        } else if with_phases {
            let all = table.choice_or_first("phases", &PHASES, problems);
            let steps = steps_per_pitch(&table, problems);
            alone?;
            let (all, steps_per_pitch) = (all?, steps?);
            Some(Sweep {
                spec: SweepSpec {
                    phases: Some(all),
                    steps_per_pitch: Some(steps_per_pitch),
                    ..SweepSpec::default()
                },
                plan: SweepPlan::Phases {
                    steps_per_pitch,
                    teeth: (teeth.0?, teeth.1?),
                },
            })
        } else {
            alone?;
            table.need(
                "mating",
                "one of `mating`, `revolutions` and `phases`",
                problems,
            );
            None
        }
    }

    fn of_matings(matings: Vec<(u32, u32)>, fractions: Vec<f64>) -> Sweep {
        Sweep {
            spec: SweepSpec {
                mating: Some(matings.iter().map(|&(w, p)| [w, p]).collect()),
                fraction: Some(fractions.clone()),
                ..SweepSpec::default()
            },
            plan: SweepPlan::Matings { matings, fractions },
        }
    }

    fn of_revolution(
        revolution: Revolutions,
        steps_per_pitch: u32,
        start: (u32, u32),
        (wheel, pinion): (u32, u32),
    ) -> Sweep {
        let pitches = match revolution {
            Revolutions::Wheel => u64::from(wheel),
            Revolutions::Hunting => SweepPlan::hunting_pitches(wheel, pinion),
        };
        Sweep {
            spec: SweepSpec {
                revolutions: Some(revolution),
                steps_per_pitch: Some(steps_per_pitch),
                start: Some([start.0, start.1]),
                ..SweepSpec::default()
            },
            plan: SweepPlan::Revolution {
                pitches,
                steps_per_pitch,
                start,
            },
        }
    }
}

fn steps_per_pitch(table: &Table, problems: &mut Problems) -> Option<u32> {
    match table.optional("steps_per_pitch") {
        Some(Some(entry)) => {
            let help = "give how many poses a pitch gets, 16 by default";
            problems.keep(entry.whole(STEPS_PER_PITCH, help))
        }
        absent => absent.map(|_| DEFAULT_STEPS),
    }
}

fn matings(
    table: &Table,
    teeth: (Option<u32>, Option<u32>),
    problems: &mut Problems,
) -> Option<Vec<(u32, u32)>> {
    const WAY_OUT: &str = "write [[1, 1]]: wheel tooth, pinion tooth";
    let entry = table.get("mating")?;
    let list = problems.keep(entry.list("a list of matings", WAY_OUT))?;
    if list.is_empty() {
        problems.add(entry.problem("an empty list, expected at least one mating", WAY_OUT));
        return None;
    }
    entry.each(&list, problems, |mating, _| pair_of_teeth(mating, teeth))
}

fn fractions(table: &Table, problems: &mut Problems) -> Option<Vec<f64>> {
    let Some(entry) = table.optional("fraction")? else {
        return Some(vec![0.0]);
    };
    let fractions = entry.numbers(&FRACTION, problems)?;
    if fractions.is_empty() {
        problems.add(entry.problem(
            "an empty list, expected at least one fraction",
            "write [0.0], or remove it",
        ));
        return None;
    }
    Some(fractions)
}

/// A mating `[wheel tooth, pinion tooth]`.
fn pair_of_teeth(entry: &Entry, teeth: (Option<u32>, Option<u32>)) -> Result<(u32, u32), Problem> {
    let wheel = 1..=teeth.0.unwrap_or(10_000);
    let pinion = 1..=teeth.1.unwrap_or(10_000);
    let help = "give wheel tooth and pinion tooth, numbered from 1";
    let Node::List(list) = entry.node() else {
        return Err(entry.wrong_type("[wheel tooth, pinion tooth]", help));
    };
    let [w, p] = list.as_slice() else {
        let reason = format!("length {}, expected 2: wheel and pinion tooth", list.len());
        return Err(entry.problem(reason, help));
    };
    let mut wrong = Vec::new();
    let mut tooth = |name, node, range: std::ops::RangeInclusive<u32>| {
        let allowed = whole_in(&range);
        let tooth = Entry::new(String::new(), node).whole(range, help).ok();
        if tooth.is_none() {
            wrong.push(format!(
                "{name} tooth is {}, allowed is {allowed}",
                node.shown()
            ));
        }
        tooth
    };
    match (tooth("wheel", w, wheel), tooth("pinion", p, pinion)) {
        (Some(w), Some(p)) => Ok((w, p)),
        _ => Err(entry.problem(wrong.join("; "), help)),
    }
}
