//! Pair files, tables, curve files and gearbox models as they are read. They are one binary, since each binary builds the generic code of
//! the readers again.

#[path = "all_round/main.rs"]
mod all_round;
mod bad_files;
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
