#!/usr/bin/env bash
# Finding: In lubepy the Reynolds number of a rectangular channel is that of a round pipe of its hydraulic diameter for the same flow: a gap of 100 by 1 mm has 32 times its Reynolds number, and laminar oil is called turbulent.
# Package: lubepy 1.0a0 (PyPI)
# Expected: Mean velocity times hydraulic diameter over viscosity, the velocity being flow over width and height: 2 Q / ((a + b) v).
# Seen: 3600 L/h of 46 cSt through 100 by 1 mm: 13989 in place of 430; through 20 by 2 mm 7618 in place of 1976; a square duct 27 % too much. A round pipe is right. The flatter the channel, the higher the number, where it should fall.
# Touches carom: A film or groove beside a contact of carom is such a channel; take its flow for laminar by 2 Q / ((a + b) v).
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check lubepy==1.0a0
cd "$folder"
cat > gap.py <<'PYTHON'
import importlib.metadata
import math
import sys

from lubepy.fluid import reynolds

print("lubepy", importlib.metadata.version("lubepy"))
FLOW = 3600.0  # L/h, 1 L/s
OIL = (FLOW, 46.0, 6.8, 40.0)  # 46 cSt at 40 and 6.8 cSt at 100 degrees, at 40 degrees

fault = False
seen = reynolds.reynolds_circular_session(*OIL, 10.0)
right = 4e-3 / (math.pi * 0.010 * 46e-6)
print(f"pipe of 10 mm: expected {right:.0f}, seen {seen:.0f}")
fault |= abs(seen / right - 1) > 0.002
seen = reynolds.reynolds_square_session(*OIL, 10.0)
right = 1e-3 / (0.010 * 46e-6)
print(f"square duct of 10 mm: expected {right:.0f}, seen {seen:.0f}")
fault |= abs(seen / right - 4 / math.pi) > 0.002
for a, b in ((10.0, 5.0), (20.0, 2.0), (100.0, 1.0)):
    right = 2e-3 / ((a + b) * 1e-3 * 46e-6)
    seen = reynolds.reynolds_rectangular_session(*OIL, a, b)
    flow = reynolds.flow_type_rectangular_session(*OIL, a, b)
    kind = "laminar" if right <= 2100 else "mixed" if right <= 4000 else "turbulent"
    print(f"{a:g} by {b:g} mm: expected {right:.0f}, {kind}; seen {seen:.0f}, {flow.value}, {seen / right:.1f} times")
    fault |= abs(seen / right / ((a + b) ** 2 / (math.pi * a * b)) - 1) > 0.002
    fault |= flow.value != "turbulent"
sys.exit(int(fault))
PYTHON
env/bin/python gap.py
