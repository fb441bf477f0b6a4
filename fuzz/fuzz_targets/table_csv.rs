//! A table of text: the first byte says which readings, the rest is the file.
#![no_main]

use gearlash_fuzz::table;
use libfuzzer_sys::{Corpus, fuzz_target};

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let read = bytes
        .split_first()
        .and_then(|(&choice, rest)| table::read(choice, rest));
    read.map_or(Corpus::Reject, |()| Corpus::Keep)
});
