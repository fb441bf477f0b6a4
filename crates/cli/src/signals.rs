//! Ctrl-C and other signals that end the process.
//!
//! A thread of its own waits for the signal. It removes unfinished files and ends the process, whatever the other threads do.
//! Files that are just being renamed are finished first, which takes milliseconds. A second signal does not wait for that either.

use super::console::print_error_line;
use super::progress;
use crate::error::Error;
use crate::output;
use std::sync::{Mutex, PoisonError};

/// The files left by an interrupted command, and how to go on.
static HINT: Mutex<Option<String>> = Mutex::new(None);

/// Writes a piece of a file that an interrupted command leaves. A signal waits for its end. `write` returns how to go on from
/// there.
///
/// # Errors
/// The errors of `write`.
pub(super) fn keep<E>(write: impl FnOnce() -> Result<Option<String>, E>) -> Result<(), E> {
    let mut hint = HINT.lock().unwrap_or_else(PoisonError::into_inner);
    *hint = write()?;
    Ok(())
}

/// Lets a signal end the process cleanly from now on, with the exit code 128 + its number as shells count.
pub(super) fn handle() {
    // Without a handler the system ends the process and leaves files. That is no reason not to start.
    let _ = install();
}

fn end(code: i32) -> ! {
    progress::clear();
    // Held to the end, so that no other thread writes.
    let hint = HINT.lock().unwrap_or_else(PoisonError::into_inner);
    let ended = output::remove_unfinished();
    print_error_line(&match &*hint {
        Some(hint) => format!("error: interrupted; {hint}"),
        None if ended.written => {
            "error: interrupted; what had been written before is complete".to_owned()
        }
        None => format!("error: {}", Error::INTERRUPTED),
    });
    // `ended` is held here, so that no other thread writes.
    std::process::exit(code)
}

#[cfg(unix)]
fn install() -> std::io::Result<()> {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::flag;
    use signal_hook::iterator::Signals;
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;

    let mut heard = vec![SIGINT, SIGTERM];
    // A SIGHUP that is ignored from the start, as under nohup, stays ignored. SIGINT does not: a script that starts a job in the
    // background has it ignored there, and can still send one.
    if !ignored(SIGHUP) {
        heard.push(SIGHUP);
    }
    let mut signals = Signals::new(&heard)?;
    let second = Arc::new(AtomicBool::new(false));
    for &signal in &heard {
        // The order matters: the first signal finds the flag unset and sets it.
        flag::register_conditional_shutdown(signal, 128 + signal, Arc::clone(&second))?;
        flag::register(signal, Arc::clone(&second))?;
    }
    let wait = move || {
        if let Some(signal) = signals.forever().next() {
            end(128 + signal);
        }
    };
    std::thread::Builder::new()
        .name("signals".to_owned())
        .spawn(wait)?;
    Ok(())
}

/// Whether this process was started with `signal` ignored; false where the system does not tell.
#[cfg(unix)]
fn ignored(signal: i32) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mut lines = status.lines();
    let mask = lines.find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask & 1 << (signal - 1) != 0)
}

#[cfg(not(unix))]
fn install() -> Result<(), ctrlc::Error> {
    ctrlc::set_handler(|| end(130))
}
