//! The answers of the page, against files on disk and against its program under node.

mod answers;
mod under_node;

use gearlash_web::answers::Page;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

/// A path from the root of the repository.
fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(name)
}

/// A page with these files, by their own names.
fn page(paths: impl IntoIterator<Item = PathBuf>) -> Page {
    let mut page = Page::default();
    for path in paths {
        let bytes = std::fs::read(&path).expect("an example is in the repository");
        page.files.add(&last(&path), bytes);
    }
    page
}

fn last(path: &Path) -> String {
    let name = path.file_name().expect("a file has a name");
    name.to_string_lossy().into_owned()
}

fn silent(_: u64, _: u64, _: &str) -> ControlFlow<()> {
    ControlFlow::Continue(())
}
