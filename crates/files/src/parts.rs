//! Files of parts of a run, whichever command wrote them.

use crate::matching::MatchPart;
use crate::part_error::PartError;
use crate::tolerance::Part;
use serde::Deserialize;

/// Parts of one run, each with the name of its file.
#[derive(Debug, Clone)]
pub enum Parts {
    /// Of a population.
    Tolerance(Vec<(String, Part)>),
    /// Of a matching.
    Match(Vec<(String, MatchPart)>),
}

/// As much of a part's file as says of what it is.
#[derive(Deserialize)]
struct Head {
    format: String,
}

impl Parts {
    /// The parts in `files`, names and texts.
    ///
    /// # Errors
    /// [`PartError::Invalid`]; [`PartError::Foreign`] where some are of a population and some of a matching.
    pub fn read(files: Vec<(String, String)>) -> Result<Parts, PartError> {
        let is_match = |text: &str| {
            let head = serde_json::from_str::<Head>(text);
            head.is_ok_and(|head| head.format == crate::matching::PART_FORMAT)
        };
        let command = |is_match: bool| if is_match { "match" } else { "tolerance" }.to_owned();
        let Some((first, of_match)) = files
            .first()
            .map(|(name, text)| (name.clone(), is_match(text)))
        else {
            return Err(PartError::None);
        };
        let (mut tolerance, mut matching) = (Vec::new(), Vec::new());
        for (file, text) in files {
            // What is of neither is reported as what the others are of.
            match (of_match, is_match(&text)) {
                (false, false) => {
                    let part = Part::from_json(&file, &text)?;
                    tolerance.push((file, part));
                }
                (true, true) => {
                    let part = MatchPart::from_json(&file, &text)?;
                    matching.push((file, part));
                }
                (wanted, found) => {
                    if !found {
                        Part::from_json(&file, &text)?;
                    }
                    return Err(PartError::Foreign {
                        file,
                        first,
                        what: "command",
                        found: command(found),
                        wanted: command(wanted),
                    });
                }
            }
        }
        Ok(match of_match {
            true => Parts::Match(matching),
            false => Parts::Tolerance(tolerance),
        })
    }
}
