//! gearlash in the browser: the functions that the page calls, each of texts and bytes.
//!
//! Results are JSON, SVG or HTML; so are errors. The page lays out and moves what it gets. [`answers`] has the work; only a build
//! for browsers has the boundary to JavaScript.

pub mod answers;
mod archive;
#[cfg(target_arch = "wasm32")]
mod boundary;
