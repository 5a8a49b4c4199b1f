"""Beside other styles and fixes of the host."""

import pathlib

import numpy as np
from conftest import dump, lmp, thermo

HERE = pathlib.Path(__file__).parent
BOX = (HERE / "box.in").read_text()
WALLS = (HERE / "box_walls.in").read_text()
WROTE = "write_dump all custom dump.{} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n"


def test_hybrid_is_the_same_law(tmp_path):
    """All pairs by carom under pair_style hybrid: the same trajectory; then another style for one type."""
    lmp(BOX + WALLS + "run 1500\n" + WROTE.format("own"), tmp_path)
    hybrid = BOX.replace("pair_style carom ${law}", "pair_style hybrid carom ${law}")
    carom = [line for line in hybrid.split("\n") if line.startswith("pair_coeff")]
    for line in carom:
        words = line.split()
        hybrid = hybrid.replace(line, " ".join(words[:3] + ["carom"] + words[3:]))
    lmp(hybrid + WALLS + "run 1500\n" + WROTE.format("hybrid"), tmp_path)
    one, other = dump(tmp_path / "dump.own"), dump(tmp_path / "dump.hybrid")
    assert np.abs(one[:, 1:4] - other[:, 1:4]).max() < 1e-14
    hybrid = hybrid.replace("hybrid carom", "hybrid granular carom")
    granular = "pair_coeff 2 2 granular hertz/material 1.4e7 100 0.4 tangential mindlin NULL 1.0 0.6 damping viscoelastic"
    line = next(line for line in hybrid.split("\n") if line.startswith("pair_coeff 2 2"))
    hybrid = hybrid.replace("pair_coeff 1 2 carom", "pair_coeff 1 2 carom young 1.6e7 poisson 0.3")
    walls = WALLS.replace("fix floor all", "group first type 1\nfix floor first")
    for side in ("west", "east", "south", "north"):
        walls = walls.replace(f"fix {side} all", f"fix {side} first")
    zero = "fix below all wall/gran granular hertz/material 1e7 100 0.3 tangential mindlin NULL 1.0 0.5 damping viscoelastic zplane 0.0 NULL\n"
    said = lmp(hybrid.replace(line, granular) + walls + zero + "run 1500\n" + WROTE.format("mixed"), tmp_path)
    mixed = dump(tmp_path / "dump.mixed")
    assert "Loop time" in said and np.isfinite(mixed).all() and mixed[:, 3].min() > 0


def test_poured_grains_come_to_rest(tmp_path):
    """fix pour brings grains larger than any there is; they come to rest on the floor."""
    pour = BOX.replace("create_atoms 1 region grains", "create_atoms 1 single 0 0 0.006 units box")
    pour += "set group all diameter 0.003\n" + WALLS + """
region above block -0.012 0.012 -0.012 0.012 0.05 0.078 units box
fix pour all pour 40 1 4711 region above diam range 0.009 0.011 dens 2500 2500 vol 0.3 20 vel 0 0 0 0 -0.5
fix slow all viscous 1e-3
thermo 2000
run 30000
"""
    said = lmp(pour + WROTE.format("poured"), tmp_path, dt=1e-5, damping=5e-4)
    rows = dump(tmp_path / "dump.poured")[1:]
    assert len(rows) == 40
    between = np.linalg.norm(rows[:, None, 1:4] - rows[:, 1:4], axis=2) + np.eye(40)
    assert between.min() > 0.0085, "none lies within another"
    assert np.abs(rows[:, 1:3]).max() < 0.0151 and rows[:, 3].min() > 0.0035
    assert thermo(said)["KinEng"][-1] < 1e-6
