//! Runout readings from a file: which eccentricity they hold, once the flanks are known.

use crate::eccentricity::{apart_um, shown};
use crate::error::Problem;
use crate::limits::BALL;
use crate::problems::Problems;
use crate::sheet::{Column, Coverage, Header, Sheet, Wanted};
use crate::table::Table;
use gearlash::error::GearError;
use gearlash::gear::{Deviations, Gear, Probe, RunoutFit, RunoutReadings, thickness};
use gearlash::metrology::Eccentricity;

/// Where a reading was taken.
#[derive(Debug, Clone, Copy, PartialEq)]
enum At {
    /// By a fork astride the tooth of its number.
    Tooth,
    /// By a ball in the space after it.
    Space,
}

const PLACES: [(&str, At); 2] = [("tooth", At::Tooth), ("space", At::Space)];
/// Standard deviations by which the readings must refuse what the flanks say of them.
const CERTAIN: f64 = 3.0;
/// What may be left of the readings, µm r.m.s., whatever the flanks explain. Tuned: readings and flanks of 1 µm each leave
/// some 2 µm in a ball's place; 5 µm r.m.s. are those of another gear.
const MOST_LEFT_UM: f64 = 3.0;

/// The readings, one a tooth.
#[derive(Debug, Clone, PartialEq)]
pub struct RunoutSheet {
    mm: Vec<f64>,
    at: At,
    ball_mm: Option<f64>,
    header: Header,
}

/// What is known of the flanks that were read on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Knowledge {
    /// No pitch.
    NoPitch,
    /// Pitch free of eccentricity.
    Pitch,
    /// Pitch about the datum axis that holds the eccentricity, the one of the readings being taken out of it.
    DatumPitch,
}

/// What was made of the readings.
#[derive(Debug, Clone, PartialEq)]
pub struct ReadingsFit {
    pub fit: RunoutFit,
    probe: Probe,
    /// As if the flanks stood where they belong.
    plain: RunoutFit,
    /// How far another ball moves the eccentricity at most, µm; `None` where the ball is given or there is none.
    by_ball_um: Option<f64>,
}

impl RunoutSheet {
    /// Reads the file that `[runout]` names.
    pub fn read(table: &Table, teeth: Option<u32>, problems: &mut Problems) -> Option<RunoutSheet> {
        let stated = ["total_um", "high_tooth"]
            .into_iter()
            .find(|name| table.has(name));
        if let Some(stated) = stated {
            problems.add(table.problem(
                "file",
                format!("stands beside {stated}, allowed is one of file and the values"),
                "remove one or the other",
            ));
            return None;
        }
        let needed = "\"tooth\" (at its centre line) or \"space\" (between it and the next number)";
        let at = table
            .need("at", needed, problems)
            .and_then(|entry| problems.keep(entry.choice(&PLACES)));
        let ball_mm = match table.optional("ball_mm")? {
            Some(entry) => problems.keep(entry.number(&BALL)).map(Some),
            None => Some(None),
        };
        let wanted = Wanted {
            columns: [Column::Runout],
            teeth,
            coverage: Coverage::EveryTooth,
        };
        let sheet = Sheet::read(table, &wanted, problems)?;
        let (at, ball_mm) = (at?, ball_mm?);
        if at == At::Tooth && ball_mm.is_some() {
            problems.add(table.problem(
                "ball_mm",
                "goes with at = \"space\": no ball stands at a tooth's centre line",
                "remove it, or write at = \"space\"",
            ));
            return None;
        }
        Some(RunoutSheet {
            mm: sheet.values(0).iter().map(|um| um / 1000.0).collect(),
            at,
            ball_mm,
            header: sheet.header,
        })
    }

    /// What the file says of the gear.
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// Greatest reading less least, µm.
    pub fn range_um(&self) -> f64 {
        let greatest = self.mm.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let least = self.mm.iter().copied().fold(f64::INFINITY, f64::min);
        1000.0 * (greatest - least).max(0.0)
    }

    /// Fits the eccentricity of `gear`, `known` being its flanks.
    pub fn fit(
        &self,
        table: &Table,
        gear: &Gear,
        known: &Deviations,
        problems: &mut Problems,
    ) -> Option<ReadingsFit> {
        let probe = match (self.at, self.ball_mm) {
            (At::Tooth, _) => Probe::Fork,
            (At::Space, Some(diameter)) => {
                problems.keep(check_ball(gear, diameter).map_err(|error| {
                    let help = "check it: about 1.7 modules is usual";
                    table.problem("runout.ball_mm", error.to_string(), help)
                }))?;
                Probe::Ball(diameter)
            }
            (At::Space, None) => match usual_ball(gear) {
                Some(diameter) => Probe::Ball(diameter),
                None => {
                    problems.add(table.problem(
                        "runout.file",
                        "no ball rests on the involutes of this gear",
                        "give total_um and high_tooth in place of the file",
                    ));
                    return None;
                }
            },
        };
        let fit = problems.keep(self.with(probe, gear, known, table))?;
        let plain = problems.keep(self.with(probe, gear, &Deviations::default(), table))?;
        let by_ball_um = (self.at == At::Space && self.ball_mm.is_none()).then(|| {
            let others = extreme_balls(gear).into_iter().filter_map(|ball| {
                let other = self.with(Probe::Ball(ball), gear, known, table).ok()?;
                let (this, other) = (eccentricity(&fit), eccentricity(&other));
                Some(apart_um(this, other, gear.basic_data()))
            });
            others.fold(0.0, f64::max)
        });
        Some(ReadingsFit {
            fit,
            probe,
            plain,
            by_ball_um,
        })
    }

    fn with(
        &self,
        probe: Probe,
        gear: &Gear,
        known: &Deviations,
        table: &Table,
    ) -> Result<RunoutFit, Problem> {
        let readings = RunoutReadings {
            probe,
            mm: self.mm.clone(),
        };
        let fit = readings.fit(gear, known);
        fit.map_err(|error| {
            let help = "check the readings and their unit, µm";
            table.problem("runout.file", error.to_string(), help)
        })
    }
}

/// Whether a ball of `diameter` rests on the involutes of `gear`, clear of the root. It need not stand out over the tips.
fn check_ball(gear: &Gear, diameter: f64) -> Result<(), GearError> {
    match thickness::check_pins(gear, diameter) {
        Err(GearError::PinBelowTip { .. }) => Ok(()),
        checked => checked,
    }
}

/// The ball that touches `gear` at the reference circle: its centre has `α_K = α + (p_b − s_b)/d_b − inv α`. Where there is
/// none, the least one that rests on the involutes.
fn usual_ball(gear: &Gear) -> Option<f64> {
    let roll = gear.basic_data().pressure_angle().tan();
    let ball = thickness::pin_touching(gear.basic_data(), roll, gear.base_thickness());
    let there = ball > 0.0 && ball.is_finite();
    if there {
        Some(ball)
    } else {
        extreme_balls(gear).first().copied()
    }
}

/// The least and the greatest ball that rest on the involutes of `gear`, within a twentieth of their height.
fn extreme_balls(gear: &Gear) -> Vec<f64> {
    let (form, tip) = (gear.form_roll(), gear.tip_roll());
    let fitting: Vec<f64> = (0..=20)
        .map(|part| form + f64::from(part) / 20.0 * (tip - form))
        .map(|roll| thickness::pin_touching(gear.basic_data(), roll, gear.base_thickness()))
        .filter(|&ball| ball > 0.0 && ball.is_finite() && check_ball(gear, ball).is_ok())
        .collect();
    [fitting.first(), fitting.last()]
        .into_iter()
        .flatten()
        .copied()
        .collect()
}

fn eccentricity(fit: &RunoutFit) -> Eccentricity {
    Eccentricity {
        um: 1000.0 * fit.eccentricity,
        high_tooth: fit.high_tooth,
    }
}

impl ReadingsFit {
    /// The readings' own first harmonic, whatever the flanks make of it.
    pub fn first_harmonic(&self) -> Option<Eccentricity> {
        (self.plain.eccentricity > 0.0).then(|| eccentricity(&self.plain))
    }

    /// What the user should know of them, the gear's eccentricity being `taken` from them; `all` is the fit with all that is known.
    pub fn told(&self, table: &Table, knowledge: Knowledge, all: &RunoutFit) -> Vec<String> {
        let key = table.path_of("runout.file");
        let shown = |fit: &RunoutFit| shown(eccentricity(fit));
        let (range, left) = (
            1000.0 * all.range,
            1000.0 * greatest(&all.beyond, |r, s| r - s),
        );
        let probe = match (self.probe, self.by_ball_um) {
            (Probe::Fork, _) => " as a fork at the pressure angle reads".to_owned(),
            (Probe::Ball(mm), None) => format!(" under a ball of {mm} mm"),
            (Probe::Ball(mm), Some(um)) => format!(
                " under a ball of {mm:.3} mm, which touches at the reference circle (another that fits moves it by up to {um:.3} µm; ball_mm states it)"
            ),
        };
        let taken = match knowledge {
            Knowledge::NoPitch => format!(
                "the readings' first harmonic{} is an eccentricity of {}, which is taken as the gear's: without [pitch] a first harmonic of its own tooth \
                 thickness cannot be told from it; F_r, their range, is {range:.3} µm; it and up to {left:.3} µm of a reading beyond that harmonic are not used",
                match self.plain == self.fit {
                    true => "",
                    false => ", once what the stated tooth thickness does to it is taken out,",
                },
                shown(&self.fit)
            ),
            Knowledge::Pitch => format!(
                "the readings hold an eccentricity of {}, once what the stated flanks do{probe} is taken out (their first harmonic itself is {}); \
                 F_r, their range, is {range:.3} µm; up to {left:.3} µm of a reading is neither and is not used",
                shown(&self.fit),
                shown(&self.plain)
            ),
            Knowledge::DatumPitch => format!(
                "the readings' first harmonic is an eccentricity of {}; datum-axis pitch cannot part it from a first harmonic of the gear's own tooth \
                 thickness, which shows the same in both; F_r, their range, is {range:.3} µm; up to {left:.3} µm of a reading is neither that harmonic nor said by the pitch",
                shown(&self.fit)
            ),
        };
        let mut told = vec![format!("{key}: {taken}")];
        if knowledge != Knowledge::NoPitch {
            told.extend(self.contradiction(&key, all));
        }
        told
    }

    /// Whether what is beyond eccentricity refuses what the flanks say of it.
    ///
    /// Regression of the readings on what the flanks say: the slope is 1 where they agree. Below 1/2 the
    /// readings are the more even without the flanks; besides, most of their energy may be left over.
    fn contradiction(&self, key: &str, all: &RunoutFit) -> Option<String> {
        let sum = |of: fn(f64, f64) -> f64| -> f64 {
            all.beyond.iter().map(|&(read, said)| of(read, said)).sum()
        };
        let (said, shared) = (sum(|_, s| s * s), sum(|r, s| r * s));
        let left = sum(|r, s| (r - s).powi(2));
        let count = all.beyond.len() as f64;
        let refused = said > 0.0 && count > 5.0 && {
            let slope = shared / said;
            let about = all.beyond.iter().map(|(r, s)| (r - slope * s).powi(2));
            // Mean, both parts of the first harmonic and the slope are fitted.
            let deviation = (about.sum::<f64>() / (count - 4.0) / said).sqrt();
            slope + CERTAIN * deviation < 0.5
        };
        let foreign = left > sum(|r, _| r * r).max(said) / 2.0
            && 1000.0 * (left / count).sqrt() > MOST_LEFT_UM;
        if !(refused || foreign) {
            return None;
        }
        let apart = |&(read, said): &(f64, f64)| (read - said).abs();
        let numbered = (1..).zip(&all.beyond);
        let (tooth, worst) = numbered.max_by(|a, b| apart(a.1).total_cmp(&apart(b.1)))?;
        let place = match self.probe {
            Probe::Ball(_) => "after tooth",
            Probe::Fork => "at tooth",
        };
        Some(format!(
            "{key}: the readings contradict the flanks: beyond their first harmonic they vary by up to {:.3} µm, the stated flanks would make it {:.3} µm, and {place} {tooth} they \
             lie {:.3} µm apart; their F_r is {:.3} µm, that of the gear as stated {:.3} µm: check whether they are of the same gear, tooth numbers, sense and at; \
             the flanks count",
            1000.0 * greatest(&all.beyond, |r, _| r),
            1000.0 * greatest(&all.beyond, |_, s| s),
            1000.0 * apart(worst),
            1000.0 * all.range,
            1000.0 * all.known_range,
        ))
    }
}

fn greatest(pairs: &[(f64, f64)], of: impl Fn(f64, f64) -> f64) -> f64 {
    let amounts = pairs.iter().map(|&(read, said)| of(read, said).abs());
    amounts.fold(0.0, f64::max)
}
