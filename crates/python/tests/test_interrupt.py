"""Ctrl-C is heard within a second, and leaves everything as it was."""

import os
import signal
import subprocess
import sys
import threading
import time
import warnings

import carom
import numpy as np
import pytest
from every_call import case

STEEL, GLASS = carom.Material(208e9, 0.3), carom.Material(70e9, 0.2)
PAIR = carom.MaterialPair(STEEL, GLASS)
HERTZ = carom.hertz_of_spheres(0.01, 0.01, GLASS, STEEL)
BALL = carom.sphere(0.01, STEEL, 0.033, velocity=(1, 0, -2))
FLOOR = carom.plane(GLASS)
LONG = carom.Body("ellipsoid", [0.01, 0.012, 0.015], STEEL, 0.03, velocity=(1, 0.3, -2), spin=(10, 20, 30))
SIZE = (2.6e-4, 2.6e-4)
#: From the signal to the exception, with room for a machine that has other work.
SOON = 1.0


class Stop(BaseException):
    """What the handler of the signal raises; pytest would take KeyboardInterrupt for its own."""


@pytest.fixture(autouse=True)
def handler():
    def stop(*_):
        raise Stop

    before = signal.signal(signal.SIGINT, stop)
    yield
    signal.signal(signal.SIGINT, before)


def interrupted(call, after=0.3):
    """Sends the signal during a call; the time until it is heard."""
    sent = []

    def send():
        sent.append(time.perf_counter())
        os.kill(os.getpid(), signal.SIGINT)

    timer = threading.Timer(after, send)
    timer.start()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        with pytest.raises(Stop):
            call()
            timer.cancel()
            pytest.fail("the call ended before the signal was sent")
    return time.perf_counter() - sent[0]


def gap(n):
    x, y = carom.cells((n, n), SIZE)
    return (x**2 + y**2) / 0.02


def solver(n):
    made = carom.Solver(gap(n), SIZE, PAIR, 0.3)
    made.step(F_z=5.0)
    return made


def changed(path, old, new):
    text = path.read_text()
    assert old in text
    path.write_text(text.replace(old, new))
    return path


CALLS = {
    "roll": lambda: carom.roll(gap(128), SIZE, PAIR, 0.3, F_z=5.0, creepage=np.linspace(1e-4, 2e-3, 400)),
    "roll from rest": lambda: carom.roll(gap(128), SIZE, PAIR, 0.3, F_z=5.0, creepage=1e-3, distance=1e-2),
    "collide to a tolerance": lambda: carom.collide(LONG, carom.plane(STEEL), 0.2, tolerance=1e-10),
    "collide_many on grids": lambda: carom.collide_many(BALL, FLOOR, np.linspace(0.1, 0.2, 2000), law="numerical"),
    "collide_many by rings": lambda: carom.collide_many(BALL, FLOOR, np.linspace(0.1, 0.2, 400_000)),
    "restitution": lambda: carom.restitution_of_dissimilar(1.2, np.linspace(0.1, 9, 100_000), 0.1, 0.2, exact=True),
    "fastsim": lambda: carom.fastsim(HERTZ, 0.3, F_z=10.0, creepage=np.linspace(0, 0.01, 1_000_000)),
    "hertz": lambda: [carom.hertz(HERTZ, force=np.linspace(1, 2, 1_000_000)) for _ in range(1000)],
    "stress": lambda: carom.stress((1e-3, 1e-3), STEEL, 1e9, np.linspace(0, 1e-3, 30_000_000), 0.0, 1e-3, traction=(1e8, 0.0)),
    "special": lambda: carom.special.hyp3f2(1.0, 0.5, 0.6, 1.5, np.linspace(0, 1, 30_000_000)),
    "cases.solve": lambda: carom.cases.solve(changed(case("solve"), "cells = [40, 40]", "cells = [512, 512]")),
    "cases.solve to an accuracy": lambda: carom.cases.solve(case("solve"), accuracy=1e-5),
    "cases.roll": lambda: carom.cases.roll(
        changed(changed(case("roll"), "#[grid]", "[grid]"), "#elements = 40", "elements = 200"), coefficients=True
    ),
    "cases.stress": lambda: carom.cases.stress(changed(case("stress"), "count = 41", "count = 47000")),
    "TriangleMesh.places": lambda: carom.TriangleMesh(np.random.default_rng(1).random((2000, 3, 3))).places(np.full((100_000, 3), 0.5), 1.0),
    "Solver.stress": lambda: solver(128).stress(np.linspace(0, 1e-4, 1_000_000), 0.0, 1e-5),
}


@pytest.mark.parametrize("name", CALLS)
def test_a_signal_is_heard_within_a_second(name):
    assert interrupted(CALLS[name]) < SOON


@pytest.mark.parametrize("cells", [96, 256])
def test_a_step_that_is_interrupted_has_not_been(cells):
    """On one thread, and on several; the loop stands for a step that lasts."""
    made, other = solver(cells), solver(cells)
    before = made.summary()

    def steps():
        while True:
            made.step(F_z=8.0, F_x=1.0, omega=1e-4)
            made.step(F_z=5.0, F_x=0.0, omega=0.0)

    assert interrupted(steps, 0.6) < SOON
    # Where it stopped it goes on: loads that were given last are those of the state.
    last = made.summary()
    assert (last.F_z == pytest.approx(8.0)) == (last.F_x == pytest.approx(1.0)) == (last.omega == 1e-4)
    assert last.step >= before.step
    kept = made.__getstate__()["_state"]
    again = made.step()
    assert again.F_z == pytest.approx(last.F_z) and again.omega == last.omega
    restored = other
    restored._native.restore(*kept)
    assert restored.step() == again


def test_one_long_step_that_is_interrupted_leaves_all_as_it_was():
    made = carom.Solver(gap(384), SIZE, carom.MaterialPair(carom.RIGID, carom.Material(70e9, 0.0)), 0.8)
    made.step(F_z=5.0)
    before, kept = made.summary(), str(made.__getstate__())
    assert interrupted(lambda: made.step(F_z=9.0, F_x=2.0, omega=1e-4), 0.2) < SOON
    assert made.summary() == before and str(made.__getstate__()) == kept
    assert made.step().F_z == pytest.approx(5.0, rel=1e-7)


@pytest.mark.parametrize("threads", [False, True])
def test_contacts_that_are_interrupted_have_not_moved(threads):
    path = np.sin(np.linspace(0.0, 1e4, 4000)) * 1e-7
    made = carom.Contacts(1000, HERTZ, 0.3, law="rings", threads=threads)
    made.advance(1e-6, 1e-8)
    before = made.loads
    assert interrupted(lambda: made.follow(np.full((1000, 4000), 1e-6), path), 0.6) < 2 * SOON
    assert (made.loads == before).all()


def test_a_contact_that_is_interrupted_has_not_moved():
    made = carom.Contact(HERTZ, 0.3, law="rings")
    made.advance(1e-6, 1e-8)
    before = made.load
    shifts = np.sin(np.linspace(0.0, 1e4, 3_000_000)) * 1e-7
    assert interrupted(lambda: made.follow(np.full(3_000_000, 1e-6), shifts)) < SOON
    assert made.load == before


def test_in_a_shell_it_is_a_keyboard_interrupt():
    program = """if True:
        import carom, numpy as np
        print("begin", flush=True)
        steel, glass = carom.Material(208e9, 0.3), carom.Material(70e9, 0.2)
        ball = carom.sphere(0.01, steel, 0.033, velocity=(1, 0, -2))
        carom.collide_many(ball, carom.plane(glass), np.linspace(0.1, 0.2, 400_000))
        """
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as shell:
        assert shell.stdout.readline() == "begin\n"
        time.sleep(0.5)
        sent = time.perf_counter()
        shell.send_signal(signal.SIGINT)
        told = shell.stderr.read()
        assert time.perf_counter() - sent < 2 * SOON and "KeyboardInterrupt" in told


def test_another_thread_goes_on():
    done = []
    friction = np.linspace(0.1, 0.2, 400)
    beside = threading.Thread(target=lambda: done.append(carom.collide_many(BALL, FLOOR, friction)))
    beside.start()
    interrupted(CALLS["collide_many by rings"], 0.2)
    beside.join()
    assert len(done) == 1 and np.isfinite(done[0].R_x).all()
