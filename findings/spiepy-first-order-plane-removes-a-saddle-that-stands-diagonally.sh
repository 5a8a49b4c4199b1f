#!/usr/bin/env bash
# Finding: In SPIEPy the plane of first order is a twisted one: a saddle whose axes run along the diagonals of the image vanishes, the same saddle turned by 45 degrees stays whole.
# Package: SPIEPy 0.2.1 (PyPI)
# Expected: flatten_poly_xy with deg=1 takes off a tilted plane, as flatten_xy does, so that the form of a surface is left as it is, however it lay under the probe.
# Seen: The root mean square of a saddle on a disc is 0.204 after it at 0 degrees, 0.144 at 22.5 and 0 at 45; after flatten_xy it is 0.204 at all of them. The fit of first order has a term x y, that of second order x2 y2, which is of fourth.
# Touches carom: A map levelled this way has lost part of its form, and so of its gap, before a contact of carom; level it with flatten_xy.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check SPIEPy==0.2.1 numpy==2.2.6 scipy==1.15.3
cd "$folder"
cat > saddle.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
import spiepy

print("SPIEPy", importlib.metadata.version("SPIEPy"))
POINTS = 201
y, x = np.mgrid[-1 : 1 : POINTS * 1j, -1 : 1 : POINTS * 1j]
outside = x**2 + y**2 > 1
disc = ~outside


def rms(heights: np.ndarray) -> float:
    return float(heights[disc].std())


fault = False
for turned, left in ((0.0, 1.0), (22.5, 0.5**0.5), (45.0, 0.0)):
    angle = np.radians(turned)
    u, v = x * np.cos(angle) + y * np.sin(angle), y * np.cos(angle) - x * np.sin(angle)
    saddle = (u**2 - v**2) / 2
    heights = saddle + 0.3 * x - 0.2 * y + 1.0
    first, _ = spiepy.flatten_poly_xy(heights, mask=outside, deg=1)
    lines, _ = spiepy.flatten_xy(heights, mask=outside)
    print(f"saddle turned by {turned:g} degrees: expected {rms(saddle):.4f}, by flatten_xy {rms(lines):.4f}; "
          f"seen {rms(first):.4f} by flatten_poly_xy of first order")
    fault |= abs(rms(lines) / rms(saddle) - 1) > 1e-3
    fault |= abs(rms(first) - left * rms(saddle)) > 1e-3
quartic = x**2 * y**2
terms = np.column_stack([x[disc] ** i * y[disc] ** j for i in range(3) for j in range(3 - i)])
right = float((quartic[disc] - terms @ np.linalg.lstsq(terms, quartic[disc], rcond=None)[0]).std())
seen = rms(spiepy.flatten_poly_xy(quartic, mask=outside, deg=2)[0])
print(f"x2 y2 after a fit of second order: expected {right:.4f}, seen {seen:.4f}")
fault |= right < 0.02 or seen > 1e-6
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore saddle.py
