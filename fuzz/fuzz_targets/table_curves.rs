//! A curve file of a P40: the first byte says which readings, the rest is the file, behind a first line without which it is none.
#![no_main]

use gearlash_fuzz::table;
use libfuzzer_sys::{Corpus, fuzz_target};

const BEGIN: &[u8] = b"HEADER KS.MK.FILE\n";

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Some((&choice, rest)) = bytes.split_first() else {
        return Corpus::Reject;
    };
    // With or without a byte order mark, of curves or of values.
    let whole = rest
        .strip_prefix(b"\xef\xbb\xbf")
        .unwrap_or(rest)
        .starts_with(b"HEADER KS.M");
    let file = [if whole { b"" } else { BEGIN }, rest].concat();
    table::read(choice, &file).map_or(Corpus::Reject, |()| Corpus::Keep)
});
