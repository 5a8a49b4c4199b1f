"""One case by CONTACT, whose executable the environment variable CAROM_CONTACT names.

`contact.py CASE CELLS` prints a line of JSON as solvers.py does. CONTACT reads an input file and writes a
table of all elements; a first run without the table is timed, a second one with it gives the error. The time
is that of the whole process: it has no imports.
"""

import json
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

from problem import FRICTION, RADIUS, SHEAR, SIDE, Problem


def case_text(problem, cells, with_table):
    """The input: half-spaces of constant elements (module 3), approach or force given, shift or none."""
    width = SIDE / cells
    given = problem.force if problem.by_force else problem.approach
    shift = problem.shift if problem.is_shifted else 0.0
    digits = f"20{int(problem.is_shifted)}{int(problem.by_force)}00"
    curvature = 1 / (2 * RADIUS)
    return "\n".join(
        [
            " 3  MODULE",
            f"  {digits}     P-B-T-N-F-S",
            "  022020     L-D-C-M-Z-E",
            f" 0000{int(with_table)}131   H-G-I-A-O-W-R",
            "   2000   100    30     1   1e-6      MAXGS , MAXIN , MAXNR , MAXOUT, EPS",
            f"  {given:.15g}  {shift:.15g}  0.0  0.0",
            f"  {FRICTION} {FRICTION}",
            f"  {problem.poisson} {problem.poisson} {SHEAR} {SHEAR}",
            "    1",
            f"  {cells} {cells} {-SIDE / 2:.15g} {-SIDE / 2:.15g} {width:.15g} {width:.15g}",
            "    1    1",
            f"  {curvature:.15g} 0 {curvature:.15g} 0 0 0",
            " 0  MODULE",
            "",
        ]
    )


def run(program, folder, text):
    (folder / "case.inp").write_text(text)
    begin = time.perf_counter()
    subprocess.run([program, "2", "case"], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, check=True)
    return time.perf_counter() - begin


def table(folder):
    """Columns of the table of all elements: its comments and its six lines of heading are left out."""
    import numpy as np

    lines = next(folder.glob("*.mat")).read_text().splitlines()
    rows = [line.split() for line in lines if not line.startswith("%")]
    return np.array([[float(word) for word in row] for row in rows[6:]])


def main(case, cells):
    program = os.environ["CAROM_CONTACT"]
    problem = Problem(case)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        seconds = run(program, folder, case_text(problem, cells, False))
        used = resource.getrusage(resource.RUSAGE_CHILDREN)
        run(program, folder, case_text(problem, cells, True))
        rows = table(folder)
    area = (SIDE / cells) ** 2
    normal, tangential = rows[:, 4].sum() * area, rows[:, 5].sum() * area
    # Gap and normal displacement add up to the approach.
    error = problem.error(normal, (rows[:, 7] + rows[:, 2]).mean(), tangential)
    told = {"set_up": 0.0, "solve": seconds, "processor": used.ru_utime + used.ru_stime, "error": error}
    print(json.dumps({**told, "megabytes": used.ru_maxrss / 1024}))


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]))
