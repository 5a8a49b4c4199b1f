"""Measures carom beside its peers, in turn and in several rounds, and writes all answers as JSON.

    rounds.py PROGRAM OUT --peer NAME=PYTHON ... --absent NAME=REASON ... [--rounds 3] [--minutes 12]
              [--sizes 128,256,512,1024] [--lammps PYTHON=PLUGIN]

PROGRAM is the example `one_contact`. Each run is a process of its own, on one thread unless it says otherwise.
A round runs every program once, and carom before each of them, so that other load on the machine strikes all.
The finest grids are solved once, at the end, by the programs that need less than a minute and than what is left of
the minutes.
`cargo xtask bench --page` calls this.
"""

import argparse
import datetime
import json
import os
import pathlib
import platform
import subprocess
import sys
import tempfile
import time

from child import answer_of
from problem import CASES

HERE = pathlib.Path(__file__).parent
# Tolerance of carom's steps, and one at which what is left of the error is that of the grid.
TOLERANCE, TIGHT = "1e-6", "1e-11"
# That of rough surfaces, which is ASPHER's finest in single precision.
ROUGH_TOLERANCE = "1e-5"
MINUTE = 60.0
# A program takes longer by more than the number of cells grows.
GROWTH = 5.0
# A larger error means that the program did not converge.
CONVERGED = 0.1
LOOPS = (128, 256, 512)
# Grids on which carom alone is run, once, for its time and memory by size, without and with friction.
LARGE = {"hertz_force": (512, 1024, 2048, 4096), "cattaneo": (512, 1024, 2048)}
# Rough surfaces, with the number of times that each program presses them.
ROUGH = {512: 3, 1024: 3, 2048: 2}
# Such grids are solved once, at the end, by the programs for which there is time.
FINEST = 1024


class Bench:
    """The programs, and what they have answered."""

    def __init__(self, options):
        self.end = time.monotonic() + options.minutes * MINUTE
        self.program = options.program
        self.peers = dict(pair.split("=", 1) for pair in options.peer)
        self.answers = []

    def round(self, number, sizes):
        """Every case by every program on these grids."""
        for cells in sizes:
            self.keep(answer_of([self.program, "product", str(cells), "1"], 1), program="product", cells=cells, round=number)
            self.transforms(cells, number)
            for case in CASES:
                if cells >= FINEST and self.left() < 0.5 * MINUTE:
                    continue
                if number == 0:
                    self.carom(case, cells, number, tolerance=TIGHT)
                for peer in self.peers:
                    if peer != "FFTW" and self.is_wanted(peer, case, cells):
                        self.carom(case, cells, number)
                        self.peer(peer, case, cells, number)
            if cells in LOOPS:
                for threads in (1, 2):
                    self.carom("loop", cells, number, threads=threads)

    def rough(self):
        """A rough surface by carom and by ASPHER, in turn; both answers are judged by one product."""
        python = self.peers.get("ASPHER")
        if not python:
            return
        with tempfile.TemporaryDirectory() as folder:
            os.environ["CAROM_ROUGH"] = folder
            script = [python, HERE / "rough.py"]
            for cells, times in ROUGH.items():
                subprocess.run([*script, "make", folder, str(cells)], check=True)
                runs = {
                    "carom": [self.program, "rough", str(cells), ROUGH_TOLERANCE],
                    "ASPHER": [*script, "ASPHER", folder, str(cells)],
                }
                for number in range(times):
                    for program, command in runs.items():
                        answer = answer_of(command, 1, 2 * MINUTE)
                        self.keep(answer, program=program, case="rough", cells=cells, round=number, threads=1)
                for program in runs:
                    judged = answer_of([*script, "judge", folder, str(cells), program], 1, 2 * MINUTE)
                    self.keep(judged, program="judge", of=program, case="rough", cells=cells)

    def large(self):
        """Time and memory of carom by size."""
        for case, sizes in LARGE.items():
            for cells in sizes:
                answer = answer_of([self.program, case, str(cells), TOLERANCE], 1, 5 * MINUTE)
                self.keep(answer, program="carom by size", case=case, size=cells)

    def carom(self, case, cells, number, threads=1, tolerance=TOLERANCE):
        answer = answer_of([self.program, case, str(cells), tolerance], threads, 5 * MINUTE)
        self.keep(answer, program="carom", case=case, cells=cells, round=number, threads=threads, tolerance=tolerance)

    def peer(self, peer, case, cells, number):
        script = [HERE / "contact.py"] if peer == "CONTACT" else [HERE / "solvers.py", peer]
        answer = answer_of([self.peers[peer], *script, case, str(cells)], 1, 2 * MINUTE)
        self.keep(answer, program=peer, case=case, cells=cells, round=number, threads=1)

    def transforms(self, cells, number):
        if "FFTW" in self.peers:
            answer = answer_of([self.peers["FFTW"], HERE / "fftw.py", str(cells), "1"], 1)
            self.keep(answer, program="FFTW", cells=cells, round=number)

    def is_wanted(self, peer, case, cells):
        """Whether the peer has the case, has converged on this grid so far, and needs less than a minute."""
        before = [one for one in self.answers if (one["program"], one.get("case")) == (peer, case)]
        if any("lacks" in one for one in before):
            return False
        here = [one for one in before if one["cells"] == cells]
        if here:
            last = here[-1]
            return "solve" in last and last["solve"] < MINUTE and abs(last["error"]) < CONVERGED
        coarser = [one["solve"] for one in before if one["cells"] == cells // 2 and "solve" in one]
        expected = GROWTH * coarser[-1] if coarser else 0.0
        if expected > MINUTE:
            self.keep({"failed": "not run: more than a minute"}, program=peer, case=case, cells=cells)
        elif expected > self.left():
            self.keep({"failed": "not run: no time was left"}, program=peer, case=case, cells=cells)
        else:
            return True
        return False

    def left(self):
        """Seconds for which the run may go on."""
        return self.end - time.monotonic()

    def keep(self, answer, **what):
        self.answers.append({**what, **answer, "load": os.getloadavg()[0]})
        print(json.dumps(self.answers[-1]), file=sys.stderr, flush=True)


def version(peer, python):
    """The version of a peer's package; of CONTACT, which tells none, nothing."""
    package = {"FFTW": "pyfftw", "ASPHER": "aspher"}.get(peer, peer)
    code = f"import importlib.metadata as m; print(m.version({package!r}))"
    done = subprocess.run([python, "-c", code], capture_output=True, text=True)
    return done.stdout.strip() if peer != "CONTACT" and done.returncode == 0 else ""


def machine():
    """Processor, cores and the versions of what carom is built with."""
    lines = pathlib.Path("/proc/cpuinfo").read_text().splitlines() if os.path.exists("/proc/cpuinfo") else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    compiler = subprocess.run(["rustc", "--version"], capture_output=True, text=True).stdout.strip()
    return {"processor": names[0] if names else platform.processor(), "cores": os.cpu_count(), "compiler": compiler}


def lammps(pair):
    """Nanoseconds of a contact step in LAMMPS, by plugins/lammps/tests/cost.py."""
    python, plugin = pair.split("=", 1)
    script = HERE.parents[1] / "plugins/lammps/tests/cost.py"
    environment = {**os.environ, "CAROM_PLUGIN": plugin}
    done = subprocess.run([python, script, "3", "1", "--json"], capture_output=True, text=True, env=environment)
    return json.loads(done.stdout.splitlines()[-1]) if done.returncode == 0 else None


def parsed():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--peer", action="append", default=[])
    parser.add_argument("--absent", action="append", default=[])
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--minutes", type=float, default=12.0)
    parser.add_argument("--sizes", default="128,256,512,1024")
    parser.add_argument("--lammps")
    return parser.parse_args()


def main():
    options = parsed()
    sizes = [int(size) for size in options.sizes.split(",")]
    bench, begin, loads = Bench(options), time.monotonic(), [os.getloadavg()[0]]
    costs = lammps(options.lammps) if options.lammps else None
    for number in range(options.rounds):
        bench.round(number, [cells for cells in sizes if cells < FINEST])
    bench.round(0, [cells for cells in sizes if cells >= FINEST])
    bench.rough()
    bench.large()
    loads.append(os.getloadavg()[0])
    told = {
        "date": datetime.datetime.now(datetime.timezone.utc).strftime("%Y-%m-%d %H:%M UTC"),
        "minutes": (time.monotonic() - begin) / MINUTE,
        "loads": loads,
        "machine": machine(),
        "versions": {peer: version(peer, python) for peer, python in bench.peers.items()},
        "absent": dict(pair.split("=", 1) for pair in options.absent),
        "lammps": costs,
        "answers": bench.answers,
    }
    options.out.write_text(json.dumps(told, indent=1))


if __name__ == "__main__":
    main()
