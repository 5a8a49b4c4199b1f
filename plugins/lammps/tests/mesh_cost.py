"""What a grain on a wall of triangles costs, by their size: grains that roll in a trough of two
hundred to two hundred thousand triangles.

CAROM_PLUGIN=... python mesh_cost.py [rounds]
"""

import pathlib
import re
import sys
import tempfile
import time

import numpy as np
from conftest import lmp
from meshes import sheet, write

RADIUS, DRUM, GRAINS, STEPS = 0.005, 0.2, 400, 2000
SCRIPT = f"""
plugin load ${{plugin}}
units si
atom_style sphere
atom_modify map array
comm_modify vel yes
boundary f f f
region box block -0.25 0.25 0 {4 * RADIUS * GRAINS} -0.25 0.25 units box
create_box 1 box
lattice sc {4 * RADIUS}
region row block -0.001 0.001 {RADIUS} {4 * RADIUS * GRAINS - RADIUS} {RADIUS - DRUM - 0.01} {RADIUS - DRUM + 0.0099} units box
create_atoms 1 region row
set group all diameter {2 * RADIUS}
set group all density 2500
variable high equal {RADIUS - DRUM}-1e-6
set group all z ${{high}}
set group all x 0
velocity all set 0.3 0 0 units box
pair_style carom
pair_coeff * * young 1e7 poisson 0.3 friction 0.5
neighbor 0.002 bin
fix gravity all gravity 9.81 vector 0 0 -1
fix move all nve/sphere
fix wall all wall/carom ${{wall}} young 1e7 poisson 0.3 friction 0.5
timestep 2e-5
thermo_style custom step ke
run 0
run {STEPS}
"""


def seconds(folder, wall):
    """Time of all fixes in the run, and of the whole process."""
    start = time.perf_counter()
    printed = lmp(SCRIPT, folder, wall=wall)
    whole = time.perf_counter() - start
    fixes = re.findall(r"^Modify +\| +\S+ +\| +(\S+)", printed, re.M)[-1]
    return float(fixes), whole


def main(rounds=3):
    with tempfile.TemporaryDirectory() as folder:
        along = 4 * RADIUS * GRAINS
        walls = {"cylinder": f"cylinder 0 0 0 0 1 0 {DRUM} inside"}
        for width in (0.02, 0.01, 0.005, 0.0025):
            xs, ys = np.arange(-0.08, 0.0801, width), np.arange(-width, along + 1.5 * width, width)
            xs -= 0.3 * width
            made = sheet(xs, ys, lambda x, y: (x**2 - width**2 / 4) / (2 * DRUM) - DRUM)
            write(pathlib.Path(folder) / "trough.stl", made)
            (pathlib.Path(folder) / "trough.stl").rename(pathlib.Path(folder) / f"{len(made)}.stl")
            walls[f"{len(made)} triangles, {width / RADIUS:g} radii wide"] = f"stl {len(made)}.stl"
        for name, wall in walls.items():
            fixes, whole = map(min, zip(*(seconds(folder, wall) for _ in range(rounds))))
            print(f"{name}: {1e9 * fixes / (GRAINS * STEPS):.0f} ns a grain and step, {whole:.2f} s in all", flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
