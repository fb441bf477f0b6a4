//! A gearbox model: the first byte says XML, JSON or zip, the rest is the file. Problems that say so; or stages, of which each is a pair
//! file that reads again, or a reason.
#![no_main]

use gearlash_rexs::read;
use gearlash_fuzz::folder::Folder;
use libfuzzer_sys::{Corpus, fuzz_target};
use std::fs;
use tempfile::TempDir;

fuzz_target!(|bytes: &[u8]| -> Corpus {
    let Some((&choice, file)) = bytes.split_first() else {
        return Corpus::Reject;
    };
    let name = match choice {
        b'x' => "model.rexs",
        b'j' => "model.rexsj",
        b'z' => "model.rexsz",
        _ => return Corpus::Reject,
    };
    let folder = TempDir::new_in("/dev/shm").or_else(|_| TempDir::new()).unwrap();
    let path = folder.path().join(name);
    fs::write(&path, file).unwrap();
    let model = match read(&path) {
        Ok(model) => model,
        Err(error) => {
            for problem in &error.problems {
                assert!(!problem.reason.is_empty() && !problem.help.is_empty(), "{problem}");
            }
            assert!(!error.problems.is_empty());
            return Corpus::Keep;
        }
    };
    for stage in &model.stages {
        match &stage.pair {
            // `check` reads the file of `import`, or reports errors of the gears.
            Ok(pair) => drop(Folder::new(&pair.pair_file, &[]).read_twice()),
            Err(why) => assert!(!why.is_empty()),
        }
    }
    Corpus::Keep
});
