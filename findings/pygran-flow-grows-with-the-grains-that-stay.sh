#!/usr/bin/env bash
# Finding: PyGran multiplies the mass flow out of a silo by the number of grains that are still in it: the same leak is a hundred times larger in a large silo.
# Package: pygran_analysis 1.1.0 (PyPI)
# Expected: With a density the flow is documented as mass by time: ten grains of 10.5 mg in every 10 ms are 0.0105 kg/s, however many stay.
# Seen: 0.94 kg/s when 90 grains stay, 0.52 kg/s when 50 do, 10.4 kg/s with 990; a constant flow seems to slow down in proportion to the filling.
# Touches carom: Compare the discharge of `carom scene` or of the LAMMPS plugin by the number of grains in the dump, not by this function.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pygran_analysis==1.1.0 numpy==2.4.6 scipy==1.17.1
cd "$folder"
cat > silo.py <<'PYTHON'
import contextlib
import importlib.metadata
import io
import sys

import numpy as np
import pygran_analysis
from pygran_analysis.dynamics import Temporal

print("pygran_analysis", importlib.metadata.version("pygran_analysis"))
RADIUS, DENSITY, LEAVE, EVERY, STEP = 1e-3, 2500.0, 10, 1000, 1e-5
MASS = DENSITY * 4 / 3 * np.pi * RADIUS**3


def dump(name: str, grains: int, frames: int) -> None:
    """A dump of LAMMPS in which as many grains leave from each frame to the next."""
    random = np.random.default_rng(1)
    with open(name, "w") as file:
        for frame in range(frames):
            stay = grains - LEAVE * frame
            file.write(f"ITEM: TIMESTEP\n{frame * EVERY}\nITEM: NUMBER OF ATOMS\n{stay}\nITEM: BOX BOUNDS ff ff ff\n")
            file.write("0 0.1\n" * 3 + "ITEM: ATOMS id type x y z vx vy vz radius\n")
            for grain, place in enumerate(random.uniform(0, 0.1, (stay, 3))):
                file.write(f"{grain + 1} 1 {place[0]:.6f} {place[1]:.6f} {place[2]:.6f} 0 0 0 {RADIUS}\n")


fault = False
right = LEAVE * MASS / (EVERY * STEP)
for grains in (100, 1000):
    dump(f"silo{grains}.dump", grains, 6)
    with contextlib.redirect_stdout(io.StringIO()), np.errstate(all="ignore"):
        system = pygran_analysis.System(Particles=f"silo{grains}.dump")
        assert system.Particles.natoms == grains
        seen = Temporal(system).flow(density=DENSITY, dt=STEP)
    stay = grains - LEAVE * np.arange(1, 6)
    print(f"{grains} grains, {LEAVE} leave in each {EVERY * STEP * 1e3:g} ms: expected {right:.5f} kg/s at all times; "
          f"seen {np.round(seen, 4)} kg/s, divided by the {stay} that stay {np.round(seen / stay, 5)}")
    fault |= len(seen) != 5 or not np.allclose(seen, right * stay, rtol=1e-9)
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore silo.py
