//! Recognises gearbox models (REXS).

use crate::error::Problem;
use std::path::Path;

/// Whether the file at `path` is to be read as REXS, by its name.
pub fn is_rexs(path: &Path) -> bool {
    let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
    ending.is_some_and(|ending| ["rexs", "rexsj", "rexsz"].iter().any(|one| ending == *one))
}

/// The `bytes` of the file at `path`, which should be a pair file or gear file.
/// Errors: the file is a gearbox model, by its name or as XML.
pub fn no_model(path: &Path, bytes: Vec<u8>) -> Result<Vec<u8>, Problem> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes);
    let is_xml = text.trim_ascii_start().starts_with(b"<");
    let is_model = is_xml && text.windows(6).any(|six| six == b"<model");
    if is_rexs(path) || is_model {
        Err(Problem::of_file(
            "is a gearbox model",
            format!(
                "gearlash import {} --stage ID -o pair.toml writes the pair file of a stage",
                path.display()
            ),
        ))
    } else {
        Ok(bytes)
    }
}
