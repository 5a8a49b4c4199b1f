#!/usr/bin/env bash
# Finding: In vehicle-dynamics the slip of a tyre below 54 km/h is that of its sliding speed at 54 km/h: at 18 km/h a slip angle of 5.7 degrees counts as 1.9, with half the side force, and a locked wheel has a slip of a third and brakes better than at speed.
# Package: vehicle_dynamics 1.0.7 (PyPI)
# Expected: Slip is the sliding speed over the rolling speed, so that one slip angle gives one side force and a locked wheel a slip of -1 at every speed; a wheel that turns twice as fast as it rolls has 0.5.
# Seen: Side force of one wheel at 5.7 degrees: 648 N at 2 m/s, 1509 N at 5 m/s, 2946 N from 15 m/s on. A locked wheel brakes with 3276, 2775 and 2255 N. At 15 m/s the slip of the spinning wheel jumps from 1.0 to 0.5.
# Touches carom: Creepage of a rolling contact in carom is by its own speed; compare tyre forces above 15 m/s only.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check vehicle_dynamics==1.0.7 numpy==2.2.6 scipy==1.15.3 pandas==2.3.3 matplotlib==3.10.7 \
  PyYAML==6.0.3 munch==4.0.0 tqdm==4.67.1
cd "$folder"
cat > car.yaml <<'YAML'
body: {mass: 1500.0, lf: 1.3, lr: 1.3, wl: 0.8, wr: 0.8, sz: 0.5, i_x_s: 500.0, i_y_s: 2000.0, i_z: 2500.0}
suspension:
  {unsprung_mass: [40.0, 40.0, 40.0, 40.0], spring_rate: [30000.0, 30000.0, 30000.0, 30000.0],
  damping_rate: [3000.0, 3000.0, 3000.0, 3000.0], roll_bar_stiffness: [0.0, 0.0, 0.0, 0.0], roll_centre_height: 0.1, pitch_centre_height: 0.1}
aerodynamics: {air_drag_coefficient: 0.3, front_area: 2.0, air_density: 1.2}
steering: {maximum_steering_angle: 8.0, ratio: 16.0}
tire:
  dynamic_radius: 0.3
  inertia: 1.0
  rolling_resistance_coefficient: 0.01
  longitudinal: {peak_friction: 1.0, shape_factor: 1.6, slip_stiffness: 20.0}
  lateral: {peak_friction: 1.0, shape_factor: 1.3, cornering_coefficient: 15.0}
powertrain:
  engine: {idle_rpm: 800.0, minimum_rpm: 700.0, maximum_rpm: 6000.0, w_table: [800.0, 6000.0]}
  gearbox: {gear_ratio: [3.0, 2.0], gear_max_rpm: [6000.0, 6000.0], gear_min_rpm: [700.0, 1500.0], inertia: 0.01}
  differential: {ratio: 3.5, driveshaft_inertia: 0.01}
YAML
cat > town.py <<'PYTHON'
import importlib.metadata
import logging
import math
import sys

import numpy as np
from vehicle_dynamics.modules.wheels import Wheels
from vehicle_dynamics.structures.CurrentStates import CurrentStates
from vehicle_dynamics.structures.StateVector import StateVector
from vehicle_dynamics.structures.StaticParameters import StaticParameters

print("vehicle_dynamics", importlib.metadata.version("vehicle_dynamics"))
RADIUS, LOG = 0.3, logging.getLogger("car")


def wheel(speed: float, across: float, turning: float) -> tuple[float, float, float, float, float]:
    """Slip along, slip angle, forces along and across, and load of the first wheel; the car goes straight on."""
    car = StaticParameters("car.yaml", 1000)
    state = CurrentStates(car, 1000, StateVector(vx=speed, vy=across), 0, LOG)
    state.wheel_w_vel = np.full(4, turning / RADIUS)
    state = Wheels(car, LOG).wheels(state, 0.0)
    return tuple(float(value[0]) for value in (state.slip_x, state.slip_y, state.x_rf.fx, state.x_rf.fy, state.f_zr.wheel_load_z))


def magic(load: float, shape: float, stiffness: float, slip: float) -> float:
    return load * math.sin(shape * math.atan(stiffness / shape * slip))


fault = False
for speed in (2.0, 5.0, 10.0, 14.99, 15.01, 30.0):
    _, angle, _, side, load = wheel(speed, -0.1 * speed, speed)
    locked, _, braking, _, _ = wheel(speed, 0.0, 0.0)
    spinning = wheel(speed, 0.0, 2 * speed)[0]
    right = math.atan(0.1)
    print(f"{speed:5.2f} m/s: slip angle expected {right:.4f}, seen {angle:.4f}; side force expected {magic(load, 1.3, 15.0, right):.0f}, "
          f"seen {side:.0f} N; locked: expected -1 and {magic(load, 1.6, 20.0, -1.0):.0f} N, seen {locked:.3f} and {braking:.0f} N; "
          f"spinning: expected 0.5, seen {spinning:.3f}")
    part = min(speed, 15.0) / 15.0
    fault |= abs(angle - math.atan(0.1 * part)) > 1e-9 or abs(side - magic(load, 1.3, 15.0, angle)) > 1e-6
    fault |= abs(locked + part) > 1e-9 or abs(spinning - (part if speed < 15 else 0.5)) > 1e-9
sys.exit(int(fault))
PYTHON
env/bin/python town.py
