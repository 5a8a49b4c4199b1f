#!/usr/bin/env bash
# Finding: The contact stress of gear teeth in gearpy is 0.629 of Hertz's pressure for the same force, radii, moduli and width, and differs between the two flanks of one contact if one gear is wider.
# Package: gearpy 1.3.1 (PyPI)
# Expected: Elastic bodies without friction and a small contact are named as the assumptions, so Hertz's pressure between two cylinders, with Poisson's ratio 0.3 as in steel; both flanks bear the same pressure, over the narrower width.
# Seen: 0.629 times that, at any size, modulus and load: less than the mean pressure of the contact, which is 0.785 of the greatest. The constant of its formula is 0.263, that of Hertz 0.418; no Poisson ratio makes up for it. Of a gear of 20 mm on one of 10 mm each has the stress of its own width, 291 and 412 MPa.
# Touches carom: Compare pressures of line contacts with a closed form, not with this package, or divide its stress by 0.629.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check gearpy==1.3.1 numpy==2.4.6
cd "$folder"
cat > teeth.py <<'PYTHON'
import importlib.metadata
import math
import sys

from gearpy.mechanical_objects import SpurGear
from gearpy.units import InertiaMoment, Length, Stress, Torque
from gearpy.utils import add_gear_mating

print("gearpy", importlib.metadata.version("gearpy"))
ANGLE = math.radians(20.0)  # the pressure angle of all gears of the package
MODULE, POISSON = 2.0, 0.3  # mm


def stresses(teeth: tuple[int, int], modulus: tuple[float, float], width: tuple[float, float], torque: float) -> list[float]:
    """Contact stress (MPa) of the two gears, for moduli in GPa, widths in mm and the torque on the first in Nm."""
    gears = [
        SpurGear(name="gear", n_teeth=teeth[side], inertia_moment=InertiaMoment(1e-4, "kgm^2"), module=Length(MODULE, "mm"),
                 face_width=Length(width[side], "mm"), elastic_modulus=Stress(modulus[side], "GPa"))
        for side in (0, 1)
    ]
    add_gear_mating(*gears, efficiency=1.0)
    for gear, load in zip(gears, (torque, torque * teeth[1] / teeth[0])):
        gear.driving_torque = gear.load_torque = Torque(load, "Nm")
        gear.compute_tangential_force()
        gear.compute_contact_stress()
    return [gear.contact_stress.to("MPa").value for gear in gears]


def hertz(teeth: tuple[int, int], modulus: tuple[float, float], width: float, torque: float, poisson: float) -> float:
    """Greatest pressure (MPa) of two cylinders with the radii of curvature of the flanks at the pitch point."""
    pitch = [1e-3 * MODULE * number / 2.0 for number in teeth]
    force = torque / pitch[0] / math.cos(ANGLE)
    curvature = sum(1.0 / (radius * math.sin(ANGLE)) for radius in pitch)
    stiffness = 1.0 / sum((1.0 - poisson**2) / (1e9 * one) for one in modulus)
    return 1e-6 * math.sqrt(force / (1e-3 * width) * stiffness * curvature / math.pi)


fault = False
for teeth, modulus, width, torque in (
    ((20, 20), (210.0, 210.0), (20.0, 20.0), 10.0),
    ((20, 80), (210.0, 210.0), (20.0, 20.0), 40.0),
    ((20, 40), (210.0, 3.0), (20.0, 20.0), 10.0),
    ((20, 40), (210.0, 210.0), (20.0, 10.0), 10.0),
):
    seen = stresses(teeth, modulus, width, torque)
    law = hertz(teeth, modulus, min(width), torque, POISSON)
    print(f"{teeth} teeth, {modulus} GPa, {width} mm, {torque:g} Nm: expected {law:.1f} MPa on both flanks "
          f"({hertz(teeth, modulus, min(width), torque, 0.0):.1f} with Poisson's ratio 0); "
          f"seen {seen[0]:.1f} and {seen[1]:.1f} MPa, {seen[0] / law:.3f} and {seen[1] / law:.3f} times")
    for side in (0, 1):
        fault |= abs(seen[side] / law - 0.6287 * math.sqrt(min(width) / width[side])) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore teeth.py
