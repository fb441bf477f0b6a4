//! A part of a matrix: what one machine found of wheels with pinions, in a file that others are put together with.

use super::read::MatchFile;
use crate::part_error::PartError;
use crate::shards::{MOST_SHARDS, RunPart, in_order, is_share, sha256, share};
use crate::tolerance::{Limit, is_length, limits};
use gearlash::error::Error;
use gearlash::gear::AsBuilt;
use gearlash::matching::{Fit, Matrix, PairFit, phase_count};
use gearlash::population::{Outcome, OutcomeKind};
use serde::{Deserialize, Serialize};
use serde_json::json;
use std::ops::{ControlFlow, Range};

/// What a part's file begins with.
pub(crate) const FORMAT: &str = "gearlash match part 1";

/// Wheels with pinions of a block, after which a part can be kept (tuned: some seconds, and enough for many threads).
const BLOCK: u64 = 256;

/// What all parts of a matching have in common.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MatchAbout {
    /// Title of the pair file.
    pub title: String,
    /// Names of the wheels and of the pinions, in the matrix' order.
    pub names: [Vec<String>; 2],
    /// Their mean base tooth thicknesses, mm.
    pub thicknesses_mm: [Vec<f64>; 2],
    /// Assembly phases of each pair.
    pub phases: u32,
    /// Least and greatest backlash allowed, mm.
    pub limits_mm: [Option<f64>; 2],
    /// What else is required.
    pub others: Vec<Limit>,
    /// The wanted backlash, mm.
    pub wanted_mm: f64,
}

/// A part of the matrix of a matching.
#[derive(Debug, Clone, PartialEq)]
pub struct MatchPart {
    gearlash: String,
    input_sha256: String,
    /// `k` of `n`.
    shard: [u64; 2],
    /// Of what.
    pub(super) about: MatchAbout,
    /// What is done of it.
    cells: Vec<PairFit>,
}

#[derive(Serialize, Deserialize)]
struct Record {
    format: String,
    gearlash: String,
    input_sha256: String,
    shard: [u64; 2],
    about: MatchAbout,
    cells: Vec<Cell>,
}

/// A wheel with a pinion: pinion tooth of the best phase, how it ends, least and greatest backlash, mm, whether both are proven, whether it is within what
/// is required, and how many phases are.
#[derive(Serialize, Deserialize)]
struct Cell(u32, String, Option<f64>, Option<f64>, bool, bool, u32);

impl MatchFile {
    /// Part `shard` (`k` of `n`) of the matrix, nothing of it done.
    ///
    /// # Errors
    /// Gears of other numbers of teeth than the first of their kind.
    pub fn part(&self, shard: [u64; 2]) -> Result<MatchPart, Error> {
        let (wheels, pinions) = self.gears();
        let names = [&self.wheels, &self.pinions];
        let requirement = self.requirement();
        Ok(MatchPart {
            gearlash: env!("CARGO_PKG_VERSION").to_owned(),
            input_sha256: self.sha256(),
            shard,
            about: MatchAbout {
                title: self.pair.study.title.clone(),
                names: names.map(|gears| gears.iter().map(|gear| gear.name.clone()).collect()),
                thicknesses_mm: Matrix::thicknesses(&wheels, &pinions),
                phases: phase_count(&wheels, &pinions)?,
                limits_mm: [requirement.min(), requirement.max()],
                others: limits(requirement),
                wanted_mm: self.terms.wanted(),
            },
            cells: Vec::new(),
        })
    }

    /// Does the next block of `part`, and says whether there was one; `tick` is called for each wheel with each pinion.
    ///
    /// # Errors
    /// As [`Matrix::new`]; `part` is then as it was.
    pub fn go_on(
        &self,
        part: &mut MatchPart,
        tick: &(dyn Fn() -> ControlFlow<()> + Sync),
    ) -> Result<bool, Error> {
        let all = part.places();
        let start = all.start + part.cells.len() as u64;
        let places = start as usize..(start + BLOCK).min(all.end) as usize;
        if places.is_empty() {
            return Ok(false);
        }
        let (wheels, pinions) = self.gears();
        let cells = Matrix::cells(&wheels, &pinions, &self.terms, places, tick)?;
        part.cells.extend(cells);
        Ok(true)
    }

    fn gears(&self) -> (Vec<AsBuilt>, Vec<AsBuilt>) {
        let gears = |named: &[super::NamedGear]| named.iter().map(|one| one.gear.clone()).collect();
        (gears(&self.wheels), gears(&self.pinions))
    }

    /// The hash of what is matched: the pair as understood, each gear with its name, and the wanted backlash.
    fn sha256(&self) -> String {
        let mut spec = self.pair.spec.clone();
        spec.tolerance = None;
        let gears = [&self.wheels, &self.pinions];
        let gears = gears.map(|gears| {
            let each = gears.iter().map(|one| (&one.name, &one.spec));
            each.collect::<Vec<_>>()
        });
        let wanted = self.terms.wanted();
        sha256(&json!({ "pair": spec, "gears": gears, "wanted": wanted }).to_string())
    }
}

impl MatchPart {
    /// How many wheels with pinions it has in all, and how many of them are done.
    pub fn progress(&self) -> [u64; 2] {
        let places = self.places();
        [places.end - places.start, self.cells.len() as u64]
    }

    /// Whether it is the same part of the same matching as `other`, however far each is.
    pub fn is_part_of_the_run_of(&self, other: &MatchPart) -> bool {
        self.shard == other.shard && self.differs(other).is_none()
    }

    /// Its file, which ends in a line end.
    pub fn to_json(&self) -> String {
        let record = Record {
            format: FORMAT.to_owned(),
            gearlash: self.gearlash.clone(),
            input_sha256: self.input_sha256.clone(),
            shard: self.shard,
            about: self.about.clone(),
            cells: self.cells.iter().map(Cell::of).collect(),
        };
        // Plain structs with text keys: nothing of it can fail.
        serde_json::to_string(&record).unwrap_or_default() + "\n"
    }

    /// The part in the `text` of `file`.
    ///
    /// # Errors
    /// [`PartError::Invalid`].
    pub fn from_json(file: &str, text: &str) -> Result<MatchPart, PartError> {
        let invalid = |reason: String| PartError::Invalid {
            file: file.to_owned(),
            reason,
        };
        let record: Record =
            serde_json::from_str(text).map_err(|error| invalid(error.to_string()))?;
        if let Some(wrong) = record.fault() {
            return Err(invalid(wrong.to_owned()));
        }
        let about = record.about;
        let cells = record.cells.iter().map(|cell| cell.pair_fit(&about));
        let cells: Option<Vec<PairFit>> = cells.collect();
        Ok(MatchPart {
            cells: cells.ok_or_else(|| invalid("it has a pair that no gears make".to_owned()))?,
            gearlash: record.gearlash,
            input_sha256: record.input_sha256,
            shard: record.shard,
            about,
        })
    }

    /// All parts of a matching, each with the name of its file, as one.
    ///
    /// # Errors
    /// [`PartError`].
    pub fn merged(parts: Vec<(String, MatchPart)>) -> Result<MatchPart, PartError> {
        let mut parts = in_order(parts)?.into_iter();
        let mut whole = parts.next().ok_or(PartError::None)?;
        whole.cells.extend(parts.flat_map(|part| part.cells));
        whole.shard = [1, 1];
        Ok(whole)
    }

    /// The matrix, of a whole run that is done; and what it is about.
    pub(super) fn matrix(self) -> Option<(MatchAbout, Matrix)> {
        let thicknesses = self.about.thicknesses_mm.clone();
        let matrix = Matrix::of_cells(thicknesses, self.about.phases, self.cells)?;
        Some((self.about, matrix))
    }

    /// Its places in the matrix.
    fn places(&self) -> Range<u64> {
        share(self.about.count(), self.shard)
    }
}

impl RunPart for MatchPart {
    fn shard(&self) -> [u64; 2] {
        self.shard
    }

    fn is_done(&self) -> bool {
        let [all, done] = self.progress();
        all == done
    }

    fn differs(&self, other: &MatchPart) -> Option<(&'static str, String, String)> {
        let texts = |part: &MatchPart| {
            [
                ("version of gearlash", part.gearlash.clone()),
                ("input", part.input_sha256.clone()),
                ("number of parts", part.shard[1].to_string()),
            ]
        };
        let mut each = texts(self).into_iter().zip(texts(other));
        let differs = each.find(|((_, found), (_, wanted))| found != wanted);
        // One program works it out from one input; on machines that reckon alike to its last bit.
        let of_gears = || {
            let same = "the same to the last bit".to_owned();
            (self.about != other.about).then(|| ("gears or requirement", "others".to_owned(), same))
        };
        let found = differs.map(|((what, found), (_, wanted))| (what, found, wanted));
        found.or_else(of_gears)
    }
}

impl MatchAbout {
    /// How many wheels with pinions there are.
    fn count(&self) -> u64 {
        let [wheels, pinions] = [0, 1].map(|kind: usize| self.names[kind].len() as u64);
        wheels.saturating_mul(pinions)
    }
}

impl Record {
    /// What no part of a matching has.
    fn fault(&self) -> Option<&'static str> {
        let about = &self.about;
        let lengths = about.thicknesses_mm.iter().flatten();
        let limits = about.limits_mm.iter().flatten().chain([&about.wanted_mm]);
        let named = |kind: usize| about.names[kind].len() == about.thicknesses_mm[kind].len();
        let places = share(about.count(), self.shard);
        if self.format != FORMAT {
            Some("it is of another format")
        } else if !is_share(MOST_SHARDS, self.shard) {
            Some("its number is none of its run's parts")
        } else if !(named(0) && named(1) && lengths.chain(limits).all(|mm| is_length(*mm))) {
            Some("its gears or its requirement are none")
        } else if self.cells.len() as u64 > places.end - places.start {
            Some("it says that more is done than it is to do")
        } else {
            None
        }
    }
}

impl Cell {
    fn of(meeting: &PairFit) -> Cell {
        let Fit {
            pinion_tooth,
            outcome,
            meets,
            ..
        } = meeting.best;
        Cell(
            pinion_tooth,
            status(outcome.kind).to_owned(),
            outcome.least,
            outcome.greatest,
            outcome.is_proven,
            meets,
            meeting.meeting,
        )
    }

    /// `None` of what no pair comes to.
    fn pair_fit(&self, about: &MatchAbout) -> Option<PairFit> {
        let Cell(tooth, kind, least, greatest, is_proven, meets, meeting) = self;
        let outcome = Outcome {
            kind: kind_of(kind)?,
            least: *least,
            greatest: *greatest,
            is_proven: *is_proven,
        };
        let mut lengths = least.iter().chain(greatest);
        let is_one = (1..=about.phases).contains(tooth)
            && *meeting <= about.phases
            && *meets == (*meeting > 0)
            && (!meets || (*is_proven && least.is_some() && greatest.is_some()))
            && lengths.all(|mm| is_length(*mm));
        is_one.then(|| PairFit {
            best: Fit::of(*tooth, outcome, *meets, about.wanted_mm),
            meeting: *meeting,
        })
    }
}

/// How a pair may end, in words.
const KINDS: [(OutcomeKind, &str); 6] = [
    (OutcomeKind::Clear, "clear"),
    (OutcomeKind::Interference, "interference"),
    (OutcomeKind::Jammed, "jammed"),
    (OutcomeKind::OutOfMesh, "no_contact"),
    (OutcomeKind::Unproven, "unproven"),
    (OutcomeKind::Impossible, "impossible"),
];

/// How a pair ends, in words.
pub(super) fn status(kind: OutcomeKind) -> &'static str {
    let mut each = KINDS.into_iter();
    each.find(|(of, _)| *of == kind)
        .map_or("", |(_, text)| text)
}

/// What `status` puts so.
fn kind_of(text: &str) -> Option<OutcomeKind> {
    let mut each = KINDS.into_iter();
    each.find(|(_, of)| *of == text).map(|(kind, _)| kind)
}
