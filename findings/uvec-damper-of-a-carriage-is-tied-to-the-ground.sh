#!/usr/bin/env bash
# Finding: In UVEC the damper of the two-mass vehicle acts between each mass and the ground, not between the masses, so that a train on a steady grade weighs more downhill and less uphill, the more the faster it goes.
# Package: UVEC 1.1.4 (PyPI)
# Expected: On a track that rises or falls at constant speed nothing moves against anything else, so the wheel presses with the weight alone, 10791 N for 1000 and 100 kg.
# Seen: With a damper of 1e4 N s/m, 12791 N when the track falls at 0.1 m/s, 8791 N when it rises, 16791 N at 0.3 m/s: the weight and 2 c v. On a level track the weight.
# Touches carom: Wheel loads from this model are no input for a rail contact of carom on a grade or a long wave unless the damper is zero.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile numpy==2.4.6
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps UVEC==1.1.4
cd "$folder"
cat > grade.py <<'PYTHON'
import importlib.metadata
import json
import sys

from UVEC.uvec_two_dof_vehicle_2D.uvec import uvec

print("UVEC", importlib.metadata.version("UVEC"))
STEP, BODY, WHEEL, STIFFNESS = 1e-3, 1000.0, 100.0, 1e6
WEIGHT = (BODY + WHEEL) * 9.81


def load(speed: float, damper: float) -> float:
    """Load of the wheel on a track that moves at a vertical speed, after 5 s, N."""
    state: dict = {}
    force = 0.0
    for index in range(5000):
        case = {"u": {"1": [0.0, speed * STEP * index, 0.0]}, "theta": {"1": [0.0, 0.0, 0.0]}, "time_index": index, "dt": STEP, "state": state,
                "parameters": {"m1": BODY, "m2": WHEEL, "k": STIFFNESS, "c": damper}}
        answer = json.loads(uvec(json.dumps(case)))
        state, force = answer["state"], answer["loads"]["1"][1]
    return force


fault = False
for speed, damper in ((0.0, 1e4), (-0.1, 1e4), (0.1, 1e4), (-0.3, 1e4), (-0.1, 2e4), (-0.1, 5e3)):
    seen = load(speed, damper)
    print(f"track at {speed:+g} m/s, damper {damper:g} N s/m: expected {WEIGHT:.0f} N, seen {seen:.1f} N, {seen - WEIGHT:+.1f} N for 2 c v = {2 * damper * -speed:+.0f} N")
    fault |= abs(seen - WEIGHT + 2 * damper * speed) > 1
sys.exit(int(fault))
PYTHON
env/bin/python grade.py
