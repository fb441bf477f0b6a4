//! Disks that are full, broken or forbidden in the middle of writing.

use super::kills::{Sets, injected, traces};
use super::*;
use crate::skip::skip;

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
            let output = injected(&sets, &what);
            let stderr_of = stderr_of(&output);
            match output.status.code() {
                Some(0) => assert!(sets.in_place() == sets.new, "{what}"),
                Some(2) => {
                    refused += 1;
                    assert!(
                        stderr_of.contains("cannot be written"),
                        "{what}: {stderr_of}"
                    );
                    sets.check(&what);
                    let left = temporary(sets.folder.path());
                    assert!(left.is_empty() || call == "unlink", "{what}: {left:?}");
                }
                other => panic!("{what}: {other:?}, {stderr_of}"),
            }
            sets.write("old");
            assert!(sets.in_place() == sets.old, "{what}");
        }
    }
    assert!(refused >= 10, "{refused}");
}

/// A small file system: the disk is really full.
#[test]
fn a_full_disk_leaves_the_old_files() {
    let sets = Sets::new();
    let disk = sets.folder.path().join("disk");
    std::fs::create_dir(&disk).unwrap();
    let mount = |options: &[&str]| {
        let mut command = Command::new("mount");
        let status = command
            .args(options)
            .arg(&disk)
            .stderr(Stdio::null())
            .status();
        status.is_ok_and(|status| status.success())
    };
    if !mount(&["-t", "tmpfs", "-o", "size=4m", "none"]) {
        skip("needs the right to mount a small file system");
        return;
    }
    let simulate = |name: &str| {
        let words = format!("simulate {name} --snapshots -o disk/results --format=csv");
        run(sets.folder.path(), &words)
    };
    let first = simulate("old.toml");
    let before = contents(&disk);
    // Full but for 100 kB, which a temporary set does not fit in.
    std::fs::write(disk.join("filler"), vec![0; 4 << 20]).ok();
    let length = std::fs::metadata(disk.join("filler")).unwrap().len();
    let filler = std::fs::File::options()
        .write(true)
        .open(disk.join("filler"));
    filler.unwrap().set_len(length - (100 << 10)).unwrap();
    let second = simulate("new.toml");
    std::fs::remove_file(disk.join("filler")).unwrap();
    let after = contents(&disk);
    let unmounted = Command::new("umount").arg(&disk).status();
    assert!(unmounted.is_ok_and(|status| status.success()));
    assert!(first.status.success(), "{}", stderr_of(&first));
    assert_eq!(second.status.code(), Some(2));
    assert!(
        stderr_of(&second).contains("No space left on device"),
        "{}",
        stderr_of(&second)
    );
    assert!(after == before);
}
