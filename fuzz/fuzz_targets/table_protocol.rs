//! A measuring machine's protocol: the first byte says which readings, the rest is the file, behind a header line and the head of
//! a block without which the file is no protocol.
#![no_main]

use gearlash_fuzz::table;
use libfuzzer_sys::{Corpus, fuzz_target};

const BEGIN: &[u8] = "  21 :Normalmodul........[mm].............: 3.000\n".as_bytes();
const HEAD: &[u8] = b"        linke Zahnflanke\n";

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Some((&choice, rest)) = bytes.split_first() else {
        return Corpus::Reject;
    };
    let whole = rest.windows(HEAD.len()).any(|window| window == HEAD);
    let file = [BEGIN, if whole { b"" } else { HEAD }, rest].concat();
    table::read(choice, &file).map_or(Corpus::Reject, |()| Corpus::Keep)
});
