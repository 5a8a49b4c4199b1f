#!/usr/bin/env bash
# Finding: In me_toolbox a gear of 433 mm width has three times the load factor of one of 432 mm, and at 1 m width 4.6 times what it should have.
# Package: me_toolbox 0.0.18 (PyPI)
# Expected: The factor of load distribution is continuous where its two formulas for widths meet, at 432 mm (17 inches), as the same formula in inches is: 1.594 and 1.595, and 2.06 at 1 m.
# Seen: 1.589 at 432 mm, 4.77 at 433 mm, 9.37 at 1 m. The linear coefficient of the wide range is ten times that in inches; below 432 mm both agree to 0.3 %.
# Touches carom: Contact stress of wide gears by this package is 1.7 to 2.1 times that of a contact in carom for this reason alone.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile setuptools==75.8.0 wheel==0.45.1 numpy==2.4.6
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-build-isolation --no-deps me_toolbox==0.0.18
cd "$folder"
cat > wide.py <<'PYTHON'
import importlib.metadata
import sys

from me_toolbox.gears import SpurGear

print("me_toolbox", importlib.metadata.version("me_toolbox"))
MODULE, TEETH = 25.0, 40


def seen(width: float) -> float:
    return SpurGear(modulus=MODULE, teeth_num=TEETH, rpm=100, Qv=8, width=width, bearing_span=3000, pinion_offset=0, enclosure="commercial enclosed",
                    hardness=250, pressure_angle=20, grade=1, number_of_cycles=1e7).KH


def inches(width: float) -> float:
    """The factor for uncrowned teeth in the middle between bearings in a commercial enclosed unit, by the formulas for inches."""
    wide = width / 25.4
    slender = max(0.05, width / (10 * MODULE * TEETH))
    proportion = slender - 0.0375 + 0.0125 * wide if wide <= 17 else slender - 0.1109 + 0.0207 * wide - 0.000228 * wide**2
    return 1 + proportion + 0.127 + 0.0158 * wide - 0.93e-4 * wide**2


fault = False
for width in (100.0, 300.0, 431.0, 432.0, 433.0, 600.0, 1000.0):
    times = seen(width) / inches(width)
    print(f"width {width:g} mm: expected {inches(width):.3f}, seen {seen(width):.3f}, {times:.2f} times as much, contact stress times {times ** 0.5:.2f}")
    fault |= (abs(times - 1) > 0.005) != (width > 432)
jump = seen(432.01) / seen(432.0)
print(f"432.01 mm over 432 mm: expected {inches(432.01) / inches(432.0):.4f}, seen {jump:.4f}")
fault |= abs(jump - 2.994) > 0.005 or abs(seen(1000.0) / inches(1000.0) - 4.56) > 0.02
sys.exit(int(fault))
PYTHON
env/bin/python wide.py
