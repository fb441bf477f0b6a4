"""The interpreter's lock is released, results do not depend on threads, Ctrl-C ends a call."""

import os
import signal
import subprocess
import sys
import threading
import time

import pytest

import gearlash


def pair() -> gearlash.Pair:
    gear = {"module_mm": 3.0, "pressure_angle_deg": 20.0}
    wheel = gearlash.Gear(teeth=44, runout={"total_um": 20.0, "high_tooth": 5.5}, **gear)
    return gearlash.Pair(wheel, gearlash.Gear(teeth=43, **gear), 130.6)


def test_python_goes_on_while_rust_works() -> None:
    counted, done = 0, threading.Event()

    def count() -> None:
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    one = pair()
    thread = threading.Thread(target=count)
    thread.start()
    before = counted
    one.revolution(steps_per_pitch=300, hunting=True, certify=False, threads=1)
    during = counted - before
    done.set()
    thread.join()
    # A call of half a million poses that held the lock would leave it at most at the two ends of the call.
    assert during > 20


def test_results_do_not_depend_on_threads() -> None:
    one = pair()
    found = [one.revolution(threads=threads) for threads in (None, 1, 2, 7)]
    assert all((other.j_wt_um == found[0].j_wt_um).all() for other in found[1:])
    calls: list[gearlash.Poses] = []
    threads = [
        threading.Thread(target=lambda: calls.append(one.revolution(threads=1))) for _ in range(4)
    ]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(calls) == 4
    assert all((other.j_wt_um == found[0].j_wt_um).all() for other in calls)


@pytest.mark.skipif(os.name == "nt", reason="signals of Unix")
def test_ctrl_c_ends_a_long_call() -> None:
    # A shell's background job, as this may be one of, has the signal ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, lambda: os.kill(os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        # Minutes of work.
        pair().revolution(steps_per_pitch=5000, hunting=True)
    timer.join()
    signal.signal(signal.SIGINT, before)


@pytest.mark.skipif(os.name == "nt", reason="signals of Unix")
def test_ctrl_c_ends_the_command_as_it_ends_the_binary(fixtures, tmp_path) -> None:
    text = (fixtures / "hunting_51x23.toml").read_text()
    long = tmp_path / "long.toml"
    long.write_text(text + '[sweep]\nrevolutions = "hunting"\nsteps_per_pitch = 800\n')
    folder = tmp_path / "out"
    words = ["-m", "gearlash", "simulate", str(long), "-o", str(folder)]
    ran = subprocess.Popen([sys.executable, *words], stderr=subprocess.PIPE, stdout=subprocess.PIPE)
    time.sleep(1.0)
    assert ran.poll() is None
    ran.send_signal(signal.SIGINT)
    _, stderr = ran.communicate(timeout=30)
    assert ran.returncode == 130
    assert b"interrupted; nothing was written" in stderr
    assert not any(folder.iterdir()) if folder.exists() else True
