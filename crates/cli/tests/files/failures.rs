//! Disks that are full, broken or forbidden in the middle of writing a set.

use super::kills::{Sets, injected, traces};
use super::*;
use crate::skip::skip;

/// 40 injections: exit 2 and the old set, or, where another way was left, exit 0 and the new one.
#[test]
fn an_injected_failure_leaves_the_old_set_or_the_new() {
    if !traces() {
        return;
    }
    let mut refused = 0;
    let mut count = 0;
    for exchanged in [true, false] {
        let sets = Sets::new(exchanged);
        // Of each kind of call the first, some in the middle and one of the last.
        for (call, whens) in [
            ("fdatasync", [1, 2, 17, 30, 38]),
            ("rename,renameat2", [1, 2, 3, 15, 39]),
            ("linkat,mkdir", [1, 2, 3, 12, 36]),
            ("unlinkat,unlink,rmdir", [1, 2, 3, 9, 40]),
        ] {
            for (when, error) in whens
                .into_iter()
                .zip(["EIO", "ENOSPC", "EACCES", "EIO", "ENOSPC"])
            {
                let what = format!("{call}:error={error}:when={when}");
                let output = injected(&sets, &what);
                let (mut found, said) = (sets.in_place(), told(&output));
                match output.status.code() {
                    Some(0) => {
                        let mut new = sets.new.clone();
                        // Where an exchange could not be had, file by file, which leaves a manifest.
                        for set in [&mut found, &mut new] {
                            set.remove(Path::new("gearlash.sha256"));
                        }
                        assert!(found == new, "{exchanged} {what}");
                    }
                    Some(2) => {
                        refused += 1;
                        let named = said.contains("cannot be written");
                        assert!(named, "{exchanged} {what}: {said}");
                        assert!(found == sets.old, "{exchanged} {what}");
                        // What could not be removed is the next run's.
                        let left = temporary(sets.folder.path());
                        assert!(
                            left.is_empty() || call.contains("unlink"),
                            "{exchanged} {what}"
                        );
                    }
                    other => panic!("{exchanged} {what}: {other:?}, {said}"),
                }
                sets.write("old");
                let left = temporary(sets.folder.path());
                assert!(left.is_empty(), "{exchanged} {what}: {left:?}");
                if exchanged {
                    let manifest = sets.folder.path().join("results/gearlash.sha256");
                    assert!(!manifest.exists(), "{what}");
                }
                assert!(sets.found() == sets.old, "{exchanged} {what}");
                count += 1;
            }
        }
    }
    println!("{count} injections, {refused} refused");
    assert!(count == 40 && refused >= 10, "{count} {refused}");
}

/// A small file system: the disk is really full.
#[test]
fn a_full_disk_leaves_the_old_set() {
    let sets = Sets::new(true);
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
    if !mount(&["-t", "tmpfs", "-o", "size=512k", "none"]) {
        skip("needs the right to mount a small file system");
        return;
    }
    let gauge = |name: &str| {
        let mut command = gearlash(sets.folder.path());
        command.args([
            "gauge",
            name,
            "--steps-per-pitch",
            "1",
            "-o",
            "disk/results",
            "--format=json",
        ]);
        command.output().unwrap()
    };
    let first = gauge("old.toml");
    let before = contents(&disk);
    std::fs::write(disk.join("filler"), vec![0; 200 << 10]).ok();
    let second = gauge("new.toml");
    std::fs::remove_file(disk.join("filler")).unwrap();
    let after = contents(&disk);
    let unmounted = Command::new("umount").arg(&disk).status();
    assert!(unmounted.is_ok_and(|status| status.success()));
    assert!(first.status.success(), "{}", told(&first));
    assert_eq!(second.status.code(), Some(2));
    assert!(
        told(&second).contains("No space left on device"),
        "{}",
        told(&second)
    );
    assert!(after == before);
}
