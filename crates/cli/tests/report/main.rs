//! `gearlash report`: a page that parsers accept, that says what it should, of bounded size, the same bytes twice.

mod assemblies;
mod bytes;
mod command;
#[path = "../../../../tests/common/eccentric_17_100.rs"]
mod eccentric_17_100;
mod page;
mod size;
#[path = "../../../../tests/common/two_thick_teeth.rs"]
mod two_thick_teeth;
mod verdict;
mod words;
