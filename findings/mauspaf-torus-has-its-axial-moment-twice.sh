#!/usr/bin/env bash
# Finding: In mauspaf a torus has its moment about the axis of symmetry twice and that about a diameter once, so that no axis of it is an axis of symmetry.
# Package: mauspaf 0.0.4 (PyPI)
# Expected: A ring that lies in a plane has two equal moments about its diameters and one about its axis, all but twice as large: for a thin one 1/2, 1/2 and 1 of m R2.
# Seen: With R 1 m, r 0.1 m ix is 0.506 m R2, iy and iz are both 1.0075 m R2; sphere, cylinder and hollow cylinder of the same library are right.
# Touches carom: Take the moments of a ring or tyre for an impact from iy (axis) and ix (both diameters) of this function.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check mauspaf==0.0.4 sympy==1.14.0 PyQt5==5.15.11 unitc==0.0.6 uncertain==0.0.13 numpy==2.4.6 scipy==1.17.1 pandas==2.3.3 plotly==6.3.0 matplotlib==3.10.7
cd "$folder"
cat > ring.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from mauspaf.masslibrary.solids import cylinder_full, hollow_cylinder, sphere, torus

print("mauspaf", importlib.metadata.version("mauspaf"))
DENSITY = 1000.0


def moments(body: dict) -> np.ndarray:
    return np.array([float(body[name]) for name in ("ix", "iy", "iz")])


def by_points(R: float, r: float) -> np.ndarray:
    """Moments about two diameters and the axis, over the mass, by a sum over the ring."""
    u, v = np.meshgrid((np.arange(600) + 0.5) / 600 * r, (np.arange(720) + 0.5) / 720 * 2 * np.pi, indexing="ij")
    out, up = R + u * np.cos(v), u * np.sin(v)
    weight = u * out / (u * out).sum()
    across = (weight * (out**2 / 2 + up**2)).sum()
    return np.array([across, across, (weight * out**2).sum()])


fault = False
for name, body, right in (
    ("sphere", sphere(r=1.0, rho=DENSITY), [0.4, 0.4, 0.4]),
    ("cylinder", cylinder_full(r=1.0, le=0.2, rho=DENSITY), [0.25 + 0.04 / 12, 0.25 + 0.04 / 12, 0.5]),
    ("hollow cylinder", hollow_cylinder(ro=1.1, ri=0.9, le=0.2, rho=DENSITY), [(3 * 2.02 + 0.04) / 12] * 2 + [2.02 / 2]),
):
    seen = moments(body) / float(body["m"])
    print(f"{name}, moments over the mass: expected {np.round(right, 4)}, seen {np.round(seen, 4)}")
    fault |= not np.allclose(seen, right, rtol=1e-9)
for R, r in ((1.0, 0.1), (1.0, 0.4), (0.3, 0.1)):
    body = torus(R=R, r=r, rho=DENSITY)
    seen, right = moments(body) / float(body["m"]), by_points(R, r)
    print(f"torus R {R:g}, r {r:g} m, mass {float(body['m']):.4g} kg: expected {np.round(right, 5)}, seen {np.round(seen, 5)}")
    fault |= abs(float(body["m"]) / (DENSITY * 2 * np.pi**2 * R * r**2) - 1) > 1e-9
    fault |= not np.allclose(seen, right[[0, 2, 2]], rtol=1e-3)
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore ring.py
