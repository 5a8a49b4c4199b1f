#!/usr/bin/env bash
# Finding: In lavendersim the restitution of bodies and of the ground has no effect at all: 0, 0.5 and 1 give the same motion to the last bit.
# Package: lavendersim 0.2.0 (PyPI)
# Expected: A ball with restitution 1 leaves a ground with restitution 1 as fast as it came, and two equal balls exchange their velocities; with 0 neither rebounds.
# Seen: The ball stops, whatever the restitution, or comes back with a tenth of its speed at a step of 1/60 s; the struck ball leaves a head-on collision at 0.55 of 3 m/s and the other follows at 0.41. The values are checked (0 to 1) and kept in the scene.
# Touches carom: No comparison of rebounds with lavendersim: it is plastic. Compare friction of lasting contact alone.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check lavendersim==0.2.0 numpy==2.4.6
cd "$folder"
cat > plastic.py <<'PYTHON'
import importlib.metadata
import sys

import numpy as np
from lavendersim import Scene
from lavendersim.runtime import CodeSceneEnv

print("lavendersim", importlib.metadata.version("lavendersim"))
RADIUS, TIME = 0.5, 0.4
SMOOTH = dict(static_friction=0.0, dynamic_friction=0.0, torsional_friction=0.0, rolling_friction=0.0)


def run(scene: Scene, step: float) -> np.ndarray:
    """Velocities of all bodies after TIME without gravity."""
    with CodeSceneEnv(scene, control_dt=step, horizon=None) as world:
        world.reset(seed=1)
        world.set_gravity(0.0)
        for _ in range(round(TIME / step)):
            world.step({})
        return world.body_state()[:, 7:10].copy()


def fall(restitution: float, speed: float, step: float) -> np.ndarray:
    scene = Scene("fall", ground_restitution=restitution, **{f"ground_{name}": value for name, value in SMOOTH.items()})
    start = (0, RADIUS + 0.2 * speed, 0)
    scene.sphere("ball", radius=RADIUS, position=start, restitution=restitution, linear_velocity=(0, -speed, 0), **SMOOTH)
    return run(scene, step)


def hit(restitution: float, speed: float, step: float) -> np.ndarray:
    scene = Scene("hit")
    for name, x, velocity in (("cue", -1.3, speed), ("object", 0.0, 0.0)):
        start = dict(position=(x, 20, 0), linear_velocity=(velocity, 0, 0))
        scene.sphere(name, radius=RADIUS, restitution=restitution, **start, **SMOOTH)
    return run(scene, step)


fault = False
for speed, step in ((3.0, 1 / 1000), (3.0, 1 / 60), (10.0, 1 / 60)):
    falls = {e: fall(e, speed, step) for e in (0.0, 0.5, 1.0)}
    hits = {e: hit(e, speed, step) for e in (0.0, 0.5, 1.0)}
    print(f"{speed:g} m/s, step {step:.4f} s")
    for e in falls:
        cue, ball = hits[e][:, 0] / speed
        print(f"  restitution {e}, of the speed: expected rebound {e:.2f}, of the balls {(1 - e) / 2:.2f} and {(1 + e) / 2:.2f};", end=" ")
        print(f"seen {falls[e][0, 1] / speed:.2f}, {cue:.2f} and {ball:.2f}")
        fault |= not np.array_equal(falls[e], falls[0.0]) or not np.array_equal(hits[e], hits[0.0])
        fault |= not -0.01 < falls[e][0, 1] / speed < 0.12 or not 0.3 < cue < ball < 0.7
sys.exit(int(fault))
PYTHON
env/bin/python plastic.py
