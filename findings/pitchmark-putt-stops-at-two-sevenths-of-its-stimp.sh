#!/usr/bin/env bash
# Finding: In pitchmark a putt at the speed of a Stimpmeter runs two sevenths of the reading of its own green, and a slope acts by its square: a ball stops on a grade 2.5 times as steep as its resistance.
# Package: pitchmark 0.5.0 (PyPI)
# Expected: A ball that leaves at 6 ft/s on a green of Stimp 10 stops after 10 ft, as the package defines it, and one that is let go on a grade of 0.2, where the resistance is 0.08, rolls away with 0.85 m/s2.
# Seen: It stops after 2.857 ft, at 8 and 12 ft after 2.286 and 3.429 ft. Forces are divided by the moment of inertia 0.4 of the ball alone in place of 1.4, so that a ball slows down 3.5 times too fast. On the grade of 0.2 it stops within 6 mm, and twice the grade pulls four times as much.
# Touches carom: Rolling in carom has the inertia of mass and spin together; do not take decelerations from this package for `roll`.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
# Only what its module of rolling needs; the packages for maps and scans are large.
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numpy==2.4.6 scipy==1.17.1 geopandas==1.2.0 shapely==2.2.0 pandas==2.3.3 pyogrio==0.13.0 pyproj==3.7.2 packaging==26.4
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps pitchmark==0.5.0
cd "$folder"
cat > putt.py <<'PYTHON'
import importlib.metadata
import importlib.util
import sys

import numpy as np

files = {str(file): file.locate() for file in importlib.metadata.files("pitchmark")}
module = importlib.util.spec_from_file_location("rolling", files["pitchmark/physics/rolling.py"])
rolling = importlib.util.module_from_spec(module)
module.loader.exec_module(rolling)
print("pitchmark", importlib.metadata.version("pitchmark"))
FOOT, G = rolling.ONE_FOOT, rolling.GRAVITY


class Plane(rolling.Surface):
    """A green that falls to +x by one grade everywhere."""

    def __init__(self, stimp: float, grade: float) -> None:
        super().__init__(stimp)
        self.grade = grade

    def normal(self, x: float, y: float) -> tuple[float, float, float]:
        return self.grade, 0.0, np.sqrt(1 - self.grade**2)


fault = False
for feet in (8, 10, 12):
    end = Plane(feet * FOOT, 0.0).roll_ball(0, 0, 6 * FOOT, 0, rtol=1e-8, atol=1e-10)
    print(f"Stimp {feet} ft, level, 6 ft/s: expected to stop after {feet} ft, seen {end[0] / FOOT:.4f} ft, {end[0] / FOOT / feet:.4f} of it")
    fault |= abs(end[0] / FOOT / feet - 2 / 7) > 1e-3
GRADE = 0.2
green = Plane(10 * FOOT, GRADE)
expected = G / 1.4 * (GRADE * np.sqrt(1 - GRADE**2) - green.softness)
end = green.roll_ball(0, 0, 0.1, 0, tmax=1.0, rtol=1e-8, atol=1e-10)
print(f"grade {GRADE:g}, resistance {green.softness:.4f}, 0.1 m/s downhill: expected {0.1 + expected:.3f} m/s after 1 s, seen {abs(end[2]):.4f} m/s after {1000 * end[0]:.2f} mm")
fault |= expected < 0.8 or abs(end[2]) > 1e-4 or not 0 < end[0] < 0.006
slope = [rolling.Surface.simple_roll_du(Plane(10 * FOOT, grade), (0, 0, 1e-9, 0))[2] + G / 0.4 * green.softness for grade in (0.1, 0.2)]
print(f"pull of a grade of 0.2 over that of 0.1: expected 1.97, seen {slope[1] / slope[0]:.4f}")
fault |= abs(slope[1] / slope[0] - 4) > 1e-6
sys.exit(int(fault))
PYTHON
env/bin/python putt.py
