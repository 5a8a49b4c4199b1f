#!/usr/bin/env bash
# Finding: The two force laws of afmmech for one standard linear solid differ by the time constant: a ramp with 0.01 s gives 6.6 times the force of the convolution, one with 10 s 0.29 of it.
# Package: afmmech 4.2 (PyPI)
# Expected: A ball pressed in at constant speed is a convolution with a known integral, so both functions agree; the force lies between the Hertz forces of the two moduli.
# Seen: They agree at 1 s alone. At 0.1 s `force_ramp` gives 4.26 times as much as `force_conv` and 1.34 times the Hertz force of the glassy modulus, which nothing can exceed.
# Touches carom: Moduli that were fitted to ramps with this function must be fitted anew before they enter a case as stiffness.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check afmmech==4.2 numpy==1.23.5 scipy==1.10.1 pandas==1.5.3 matplotlib==3.7.5 igor==0.3 tqdm==4.67.1 joblib==1.4.2
cd "$folder"
cat > ramp.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from afmmech import force_conv, force_hertz, force_ramp

print("afmmech", importlib.metadata.version("afmmech"))
GLASSY, RUBBERY, RADIUS, SPEED = 1e6, 2e5, 1e-6, 1e-6  # Pa, Pa, m, m/s
time = np.arange(0.0, 1.0, 2e-5)
depth = SPEED * time
lowest, highest = (force_hertz(modulus, depth, RADIUS)[-1] for modulus in (RUBBERY, GLASSY))
fault = False
for constant, times in ((0.01, 6.58), (0.1, 4.261), (1.0, 1.0), (10.0, 0.2858)):
    law = (GLASSY, RUBBERY, constant)
    convolution = force_conv(law, depth, time, RADIUS)[-1]
    ramp = force_ramp(law, depth, SPEED, time, RADIUS)[-1]
    # The integral of G(t - s) d(s**1.5), by parts in small steps.
    steps = np.diff(time**1.5)
    middle = (time[1:] + time[:-1]) / 2
    relaxation = RUBBERY + (GLASSY - RUBBERY) * np.exp(-(time[-1] - middle) / constant)
    right = 4 * np.sqrt(RADIUS) / (3 * (1 - 0.5**2)) * SPEED**1.5 * (relaxation * steps).sum()
    print(f"time constant {constant:g} s, after 1 s: expected {right * 1e9:.1f} nN, between {lowest * 1e9:.1f} and {highest * 1e9:.1f} nN; "
          f"seen by convolution {convolution * 1e9:.1f}, by ramp {ramp * 1e9:.1f} nN, {ramp / right:.4f} times as much")
    fault |= abs(convolution / right - 1) > 0.01 or abs(ramp / (right * times) - 1) > 0.01 or not lowest < right < highest
    fault |= (ramp > highest) != (constant < 1)
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore ramp.py
