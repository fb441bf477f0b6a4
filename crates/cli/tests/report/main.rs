//! `gearlash report`: a page that parsers accept, that says what it should, of bounded size, the same bytes twice.

mod bytes;
mod command;
mod page;
mod size;
mod words;
