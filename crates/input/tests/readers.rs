//! Pair files, tables, curve files and gearbox models as they are read. They are one binary, since each binary builds the generic code of
//! the readers again.

#[path = "all_round/main.rs"]
mod all_round;
#[path = "curve_files/main.rs"]
mod curve_files;
#[path = "input/main.rs"]
mod input;
#[path = "tables/mutant.rs"]
mod mutant;
#[path = "../../../tests/common/pair_with_table.rs"]
mod pair_with_table;
#[path = "rexs/main.rs"]
mod rexs;
#[path = "tables/main.rs"]
mod tables;
mod text;

use gearlash_input::PairFile;
use serde_json::Value;

/// A pair file as it was understood. Not generic, since each way to write all its keys takes seconds to build: texts are made of this value.
fn echo(file: &PairFile) -> Value {
    serde_json::to_value(&file.spec).unwrap()
}

/// Whether two files have one study, content and messages; built once, as [`echo`].
#[inline(never)]
fn is_same(one: &PairFile, other: &PairFile) -> bool {
    one == other
}
