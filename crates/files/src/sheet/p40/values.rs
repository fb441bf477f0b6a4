//! The lines of a value file, `10111 : fHb links 1 : -2.9`. No number of theirs is known for certain to be of use.

use super::super::number;
use super::super::number::without_zero;
use super::content::P40;
use crate::data_file::DataFile;
use std::collections::HashSet;

/// The numbers of the values so far.
#[derive(Debug, Default)]
pub struct Values(HashSet<u32>);

impl Values {
    /// Takes over a line: five digits, what it is, and a number.
    pub fn take(&mut self, file: &DataFile, p40: &mut P40, text: &str) -> Result<(), String> {
        let not_understood = || format!("{} is not understood here", file.quote(text));
        let parts: Vec<&str> = text.split(':').map(str::trim).collect();
        let [code, label, value] = parts[..] else {
            return Err(not_understood());
        };
        let number = number::tooth(code).filter(|_| code.len() == 5 && !label.is_empty());
        let number = number.ok_or_else(not_understood)?;
        let Some(value) = without_zero(value) else {
            let value = file.quote(value);
            return Err(format!("{value}, allowed is a number with a decimal point"));
        };
        if !self.0.insert(number) {
            return Err(format!("the number {} stands twice", file.bare(code)));
        }
        // Not measured, not available; and the tip diameters that repeat those of the roots.
        let name = match (value.value, number) {
            (8999.0, _) => "values not measured or not available",
            _ if p40.unmeasured.is(&value) => "values not measured or not available",
            (_, 26711..=26715) => {
                "tip diameters 26711–26715 (such files repeat the root diameters there)"
            }
            _ => "values",
        };
        p40.count_unused(name, 1);
        Ok(())
    }
}
