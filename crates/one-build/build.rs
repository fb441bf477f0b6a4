//! Nothing to do: see `Cargo.toml`.

fn main() {}
