//! Parts of long runs: which one is asked for, and where what is done of it is kept.

use super::console::tell;
use super::signals;
use crate::error::Error;
use crate::output::OutputFile;
use gearlash_files::matching::MatchPart;
use gearlash_files::tolerance::Part;
use gearlash_files::{MOST_SHARDS, PartError, Sources};
use std::io::ErrorKind;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What an interrupted run has kept.
pub(super) const WHOLE: &str = "part.json";

/// How often what is done is kept (tuned: a part takes some milliseconds to write).
const KEPT_EVERY: Duration = Duration::from_secs(1);

/// `K/N`.
pub(super) fn shard(text: &str) -> Result<[u64; 2], String> {
    let parts = text.split_once('/');
    let parts = parts.and_then(|(k, n)| Some([k.parse().ok()?, n.parse().ok()?]));
    match parts {
        Some([k, n]) if 1 <= k && k <= n && n <= MOST_SHARDS => Ok([k, n]),
        _ => Err(format!(
            "expected K/N, such as 3/64, with K from 1 to N and N up to {MOST_SHARDS}"
        )),
    }
}

/// A part of a run that can be kept, and gone on from.
pub(super) trait KeptPart: Sized {
    /// What is counted.
    const UNITS: &str;

    /// As `from_json` of its kind.
    fn read(file: &str, text: &str) -> Result<Self, PartError>;

    /// Its file.
    fn text(&self) -> String;

    /// Whether both are the same part of the same run, however far.
    fn is_as(&self, other: &Self) -> bool;

    /// How many there are to do, and how many are done.
    fn progress(&self) -> [u64; 2];
}

impl KeptPart for Part {
    const UNITS: &str = "assemblies";

    fn read(file: &str, text: &str) -> Result<Part, PartError> {
        Part::from_json(file, text)
    }

    fn text(&self) -> String {
        self.to_json()
    }

    fn is_as(&self, other: &Part) -> bool {
        self.head == other.head && self.about == other.about
    }

    fn progress(&self) -> [u64; 2] {
        let numbers = self.head.numbers();
        [numbers.end - numbers.start, self.done.assemblies]
    }
}

impl KeptPart for MatchPart {
    const UNITS: &str = "pairs";

    fn read(file: &str, text: &str) -> Result<MatchPart, PartError> {
        MatchPart::from_json(file, text)
    }

    fn text(&self) -> String {
        self.to_json()
    }

    fn is_as(&self, other: &MatchPart) -> bool {
        self.is_part_of_the_run_of(other)
    }

    fn progress(&self) -> [u64; 2] {
        MatchPart::progress(self)
    }
}

/// Where what is done of a run is kept.
pub(super) struct Kept<'a> {
    path: PathBuf,
    sources: &'a Sources,
    last: Instant,
}

impl<'a> Kept<'a> {
    /// That of the part `shard` in `folder`, or of the whole run. Many parts go to one folder, from many processes; a whole run has its folder for
    /// itself.
    pub fn new(folder: &Path, shard: Option<[u64; 2]>, sources: &'a Sources) -> Kept<'a> {
        let name = match shard {
            Some([k, n]) => format!("part_{k}_of_{n}.json"),
            None => WHOLE.to_owned(),
        };
        Kept {
            path: folder.join(name),
            sources,
            last: Instant::now(),
        }
    }

    /// What is kept of the run of `begun`; `begun` itself where nothing is.
    pub fn found<P: KeptPart>(&self, begun: P) -> P {
        let name = self.path.display().to_string();
        let found = match std::fs::read_to_string(&self.path) {
            Err(error) if error.kind() == ErrorKind::NotFound => return begun,
            Err(error) => Err(error.to_string()),
            Ok(text) => P::read(&name, &text).map_err(|error| error.to_string()),
        };
        let found = match found {
            Ok(found) => found,
            Err(reason) => {
                // Which names the file, but for what the system says.
                let reason = reason.strip_prefix(&format!("{name}: ")).unwrap_or(&reason);
                tell(&format!(
                    "note: {name}: what was kept there cannot be gone on from, and is done again: {reason}"
                ));
                return begun;
            }
        };
        if !found.is_as(&begun) {
            tell(&format!("note: {name} is of another run, and is replaced"));
            return begun;
        }
        let [_, done] = found.progress();
        if done > 0 {
            tell(&format!("note: {name}: goes on after {done} {}", P::UNITS));
        }
        found
    }

    /// Keeps `part`, if that was long ago.
    pub fn keep<P: KeptPart>(&mut self, part: &P) -> Result<(), Error> {
        if self.last.elapsed() <= KEPT_EVERY {
            return Ok(());
        }
        self.write(part)?;
        let [all, done] = part.progress();
        signals::has_kept(format!(
            "{done} of {all} {} are kept in {}: the same command goes on from there",
            P::UNITS,
            self.path.display()
        ));
        self.last = Instant::now();
        Ok(())
    }

    /// Writes `part`, and says so.
    pub fn finish<P: KeptPart>(&self, part: &P, [k, n]: [u64; 2]) -> Result<String, Error> {
        self.write(part)?;
        Ok(format!("{}: part {k} of {n}\n", self.path.display()))
    }

    fn write<P: KeptPart>(&self, part: &P) -> Result<(), Error> {
        OutputFile::prepare(&self.path, self.sources)?.write(&part.text())
    }
}
