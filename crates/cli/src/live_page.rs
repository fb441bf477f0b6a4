//! The page that runs the program in the browser, with a pair in it.

use crate::error::Error;
use data_encoding::BASE64;
use gearlash_files::{PairFile, import};
use serde_json::{Map, Value, json};
use std::path::Path;

/// The place of the pair in the page.
const EMPTY: &str = "<script type=\"application/json\" id=\"own\">null</script>";

/// The name of the page, beside the program.
const NAME: &str = "gearlash.html";

/// The page at `page`, or beside the program, with the files of `pair`, the pair file at `path`, in it.
///
/// # Errors
/// [`Error::Usage`] where there is no page; [`Error::Input`] where a file cannot be read again.
pub(super) fn with_pair(
    page: Option<&Path>,
    path: &Path,
    pair: &PairFile,
) -> Result<String, Error> {
    if path == Path::new("-") {
        return Err(Error::usage(
            "--live holds the files of the pair: name the pair file",
        ));
    }
    let program = std::env::current_exe().unwrap_or_default();
    let page = page.map_or_else(|| program.with_file_name(NAME), Path::to_path_buf);
    let missing = || {
        let shown = page.display();
        Error::Usage(format!(
            "{shown}: the page of gearlash is not there; build it with crates/web/build, or name it with --page"
        ))
    };
    let text = std::fs::read_to_string(&page).map_err(|_| missing())?;
    if !text.contains(EMPTY) {
        return Err(missing());
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let named = |path: &Path| {
        let inside = path.strip_prefix(folder).unwrap_or(path);
        inside.to_string_lossy().replace('\\', "/")
    };
    let mut files = Map::new();
    for source in pair.sources.names() {
        let bytes = import::bytes(source)?;
        files.insert(named(source), BASE64.encode(&bytes).into());
    }
    let held: Value = json!({ "main": named(path), "files": files });
    // No text of a file ends the element.
    let held = held.to_string().replace('<', "\\u003c");
    Ok(text.replacen(EMPTY, &EMPTY.replace("null", &held), 1))
}
