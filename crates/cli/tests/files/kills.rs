//! Runs that are killed or told twice to end: every file is the old one or the new one.
//!
//! By default a part of the kills; all of them: `GEARLASH_KILLS=200 cargo test --release --test files kills`

use super::*;
use std::time::{Duration, Instant};

fn kills() -> u64 {
    let number = std::env::var("GEARLASH_KILLS");
    number.map_or(30, |number| number.parse().unwrap())
}

/// Kills anywhere from the start of a run to its end.
#[test]
fn random_kills_leave_whole_files() {
    let sets = Sets::new();
    let begun = Instant::now();
    sets.write("old.toml");
    let usual = begun.elapsed();
    // Knuth's multiplicative generator (MMIX): any sequence will do.
    let mut state = 1_u64;
    let mut killed = 0;
    for i in 0..kills() {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        let part = (state >> 40) as f64 / f64::from(1 << 24);
        let mut command = sets.command(&[], "new.toml");
        let mut child = command.stdout(Stdio::null()).spawn().unwrap();
        // Rather late than early: that is where files are written.
        std::thread::sleep(usual.mul_f64(1.1 * part.sqrt()));
        child.kill().unwrap();
        killed += u64::from(!child.wait().unwrap().success());
        sets.check(&format!("kill {i}, after {part} of a run"));
        sets.restore();
    }
    assert!(killed > 0);
}

/// Every rename there is, and the one after the last.
#[test]
fn kills_at_each_rename_leave_whole_files() {
    if !traces() {
        return;
    }
    let sets = Sets::new();
    let mut killed = 0;
    for when in 1..=16 {
        let output = sets.injected(&format!("rename:signal=SIGKILL:when={when}"));
        killed += u32::from(!output.status.success());
        sets.check(&format!("rename {when}"));
        sets.restore();
    }
    assert_eq!(killed, 15);
}

/// Taking away what is unfinished may itself hang, as on a network folder: the second signal does not wait for it.
#[test]
fn a_second_signal_ends_at_once() {
    if !traces() {
        return;
    }
    let sets = Sets::new();
    // 94 000 poses.
    let pair = std::fs::read_to_string(sets.folder.path().join("old.toml")).unwrap();
    let (pair, _) = pair.split_once("[assembly]").unwrap();
    let pair = pair
        .replace("= 20\n", "= 211\n")
        .replace("= 17\n", "= 223\n");
    let rest = "[assembly]\ncenter_distance_mm = 434.4\n[sweep]\nrevolutions = \"hunting\"\nsteps_per_pitch = 2\n";
    std::fs::write(sets.folder.path().join("big.toml"), pair + rest).unwrap();
    let delayed = "inject=rmdir,unlink:delay_enter=5000000:when=2+";
    let strace = ["strace", "-f", "-qq", "-o", "/dev/null", "-e", delayed];
    let mut command = sets.command(&strace, "big.toml");
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    std::thread::sleep(Duration::from_millis(1500));
    // The program itself, strace's only child.
    let children = format!("/proc/{0}/task/{0}/children", child.id());
    let pid = std::fs::read_to_string(children).unwrap();
    let pid = pid.trim();
    let kill = || Command::new("kill").args(["-INT", pid]).status().unwrap();
    assert!(kill().success());
    std::thread::sleep(Duration::from_millis(500));
    let path = format!("/proc/{pid}");
    assert!(Path::new(&path).exists(), "the first one hangs");
    assert!(kill().success());
    let begun = Instant::now();
    // Whether the process has not ended, waited for or not.
    let is_alive = || {
        let status = std::fs::read_to_string(format!("{path}/status")).unwrap_or_default();
        let mut ended = ["State:\tZ", "State:\tX"].into_iter();
        status.contains("State:") && !ended.any(|state| status.contains(state))
    };
    while is_alive() && begun.elapsed() < Duration::from_secs(3) {
        std::thread::sleep(Duration::from_millis(5));
    }
    let took = begun.elapsed().as_secs_f64();
    child.wait().unwrap();
    assert!(took <= 1.0, "{took} s");
}
