//! Disks that are full, broken or forbidden in the middle of writing.

use super::*;

/// Exit 2 and whole files, or, where the failed call did not matter, exit 0 and the new files.
#[test]
fn an_injected_failure_leaves_whole_files() {
    if !traces() {
        return;
    }
    let sets = Sets::new();
    let mut refused = 0;
    // The first call of each kind, some in the middle and the last.
    for (call, whens) in [
        ("fdatasync", [1, 2, 8, 14, 15]),
        ("rename", [1, 2, 8, 14, 15]),
        ("unlink", [1, 2, 3, 4, 5]),
    ] {
        let errors = ["EIO", "ENOSPC", "EACCES", "EIO", "ENOSPC"];
        for (when, error) in whens.into_iter().zip(errors) {
            let what = format!("{call}:error={error}:when={when}");
            let output = sets.injected(&what);
            let told = stderr_of(&output);
            match output.status.code() {
                Some(0) => assert!(sets.in_place() == sets.new, "{what}"),
                Some(2) => {
                    refused += 1;
                    assert!(told.contains("cannot be written"), "{what}: {told}");
                    sets.check(&what);
                    let mut left = contents(sets.folder.path());
                    left.retain(|path, _| is_temporary(path));
                    let is_clear = left.is_empty() || call == "unlink";
                    assert!(is_clear, "{what}: {:?}", left.keys());
                }
                other => panic!("{what}: {other:?}, {told}"),
            }
            sets.restore();
        }
    }
    assert!(refused >= 10, "{refused}");
}

/// A small file system: the disk is really full.
#[test]
fn a_full_disk_leaves_the_old_files() {
    let sets = Sets::new();
    let disk = sets.folder.path().join("results");
    let mount = |program: &str, options: &[&str]| {
        let mut command = Command::new(program);
        command.args(options).arg(&disk).stderr(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    if !mount("mount", &["-t", "tmpfs", "-o", "size=4m", "none"]) {
        skip("needs the right to mount a small file system");
        return;
    }
    let simulate = |name: &str| sets.command(&[], name).output().unwrap();
    let first = simulate("old.toml");
    let before = contents(&disk);
    // Full but for 100 kB, which a temporary set does not fit in.
    std::fs::write(disk.join("filler"), vec![0; 4 << 20]).ok();
    let mut options = std::fs::File::options();
    let filler = options.write(true).open(disk.join("filler")).unwrap();
    let length = filler.metadata().unwrap().len();
    filler.set_len(length - (100 << 10)).unwrap();
    drop(filler);
    let second = simulate("new.toml");
    std::fs::remove_file(disk.join("filler")).unwrap();
    let after = contents(&disk);
    assert!(mount("umount", &[]));
    assert!(first.status.success(), "{}", stderr_of(&first));
    assert_eq!(second.status.code(), Some(2));
    let told = stderr_of(&second);
    assert!(told.contains("No space left on device"), "{told}");
    assert!(after == before);
}
