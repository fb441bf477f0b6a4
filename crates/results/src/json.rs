//! JSON written piece by piece: byte for byte the output of `serde_json::to_string_pretty` for the whole.

use gearlash_files::characters;
use serde::Serialize;
use serde_json::Serializer;
use serde_json::ser::{Formatter, PrettyFormatter};
use std::io::{Error, Result, Write};

/// JSON as it grows. The caller closes every object and list that it opens.
pub(super) struct Json<W: Write> {
    out: W,
    format: PrettyFormatter<'static>,
    /// For every open object and list: whether it is still empty.
    empty: Vec<bool>,
}

impl<W: Write> Json<W> {
    pub fn new(out: W) -> Json<W> {
        Json {
            out,
            format: PrettyFormatter::new(),
            empty: Vec::new(),
        }
    }

    pub fn open_object(&mut self) -> Result<()> {
        self.empty.push(true);
        self.format.begin_object(&mut self.out)
    }

    /// Ends an object that is the value of a key or an element; only the outermost is neither.
    pub fn close_object(&mut self) -> Result<()> {
        self.empty.pop();
        self.format.end_object(&mut self.out)?;
        self.format.end_array_value(&mut self.out)
    }

    pub fn open_list(&mut self) -> Result<()> {
        self.empty.push(true);
        self.format.begin_array(&mut self.out)
    }

    /// Ends a list that is the value of a key.
    pub fn close_list(&mut self) -> Result<()> {
        self.empty.pop();
        self.format.end_array(&mut self.out)?;
        self.format.end_object_value(&mut self.out)
    }

    /// Begins the value of `key`.
    pub fn key(&mut self, key: &str) -> Result<()> {
        let first = self.first();
        self.format.begin_object_key(&mut self.out, first)?;
        write!(self.out, "\"{key}\"")?;
        self.format.end_object_key(&mut self.out)?;
        self.format.begin_object_value(&mut self.out)
    }

    /// Begins an element of a list.
    pub fn element(&mut self) -> Result<()> {
        let first = self.first();
        self.format.begin_array_value(&mut self.out, first)
    }

    /// Writes `key` and its complete value.
    pub fn entry(&mut self, key: &str, value: &impl Serialize) -> Result<()> {
        self.key(key)?;
        let text = self.layout().text(value)?;
        self.out.write_all(text.as_bytes())?;
        self.format.end_object_value(&mut self.out)
    }

    /// Writes an element whose text [`Json::layout`] produced.
    pub fn text_element(&mut self, text: &str) -> Result<()> {
        self.element()?;
        self.out.write_all(text.as_bytes())?;
        self.format.end_array_value(&mut self.out)
    }

    /// The layout of the next elements, for threads that produce their texts.
    pub fn layout(&self) -> Layout {
        Layout(self.format.clone())
    }

    /// Ends the text and returns the writer.
    pub fn finish(mut self) -> Result<W> {
        self.out.write_all(b"\n")?;
        Ok(self.out)
    }

    fn first(&mut self) -> bool {
        self.empty
            .last_mut()
            .is_some_and(|empty| std::mem::replace(empty, false))
    }
}

/// The indentation of values.
#[derive(Clone)]
pub(super) struct Layout(PrettyFormatter<'static>);

impl Layout {
    /// `value` as JSON. A character that acts occurs only inside strings, so no piece ends within one.
    pub fn text(&self, value: &impl Serialize) -> Result<String> {
        let mut bytes = Vec::new();
        let format = self.0.clone();
        value.serialize(&mut Serializer::with_formatter(&mut bytes, format))?;
        let text = String::from_utf8(bytes).map_err(Error::other)?;
        Ok(characters::json(text))
    }
}
