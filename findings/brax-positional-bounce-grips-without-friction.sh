#!/usr/bin/env bash
# Finding: In the positional pipeline of brax a bounce grips whatever the coefficient of friction, also if it is 0.
# Package: brax 0.14.2 (PyPI)
# Expected: A smooth ball keeps its slip of 6 m/s and its spin of 50 rad/s when it bounces; with friction 0.01 it loses at most 0.06 m/s.
# Seen: With friction 0 the ball leaves at 4.24 m/s and 35 rad/s, all but rolling; without slip 50 rad/s become 16 and 1.4 m/s; with 0.3 the same. On the floor, without a fall, friction 0 does nothing, as it should.
# Touches carom: Compare bounces with friction with the pipeline spring of brax, in which the smooth ball keeps its spin, not with positional.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check brax==0.14.2 jax==0.10.2 jaxlib==0.10.2 mujoco==4.0.0 mujoco-mjx==3.17.0
cd "$folder"
cat > grip.py <<'PYTHON'
import importlib.metadata
import sys

import jax
import numpy as np
from brax.io import mjcf
from brax.positional import pipeline

print("brax", importlib.metadata.version("brax"))
TIME, STEP, RADIUS = 0.4, 0.002, 0.1
SCENE = """
<mujoco>
  <option timestep="{step}" gravity="0 0 {gravity}"/>
  <custom><numeric name="elasticity" data="1"/></custom>
  <worldbody>
    <geom type="plane" size="40 40 40" friction="{friction} 0 0"/>
    <body pos="0 0 {height}"><freejoint/><geom type="sphere" size="{radius}" mass="1" friction="{friction} 0 0"/></body>
  </worldbody>
</mujoco>
"""
advance = jax.jit(lambda system, state: pipeline.step(system, state, jax.numpy.zeros(system.act_size())))


def run(friction: float, slip: float, spin: float, fall: float, gravity: float) -> tuple[float, float]:
    """Velocity along the floor and spin of a ball after TIME; it starts on the floor if it does not fall."""
    height = 0.3 if fall else RADIUS
    system = mjcf.loads(SCENE.format(step=STEP, gravity=-gravity, friction=friction, height=height, radius=RADIUS))
    state = pipeline.init(system, system.init_q, jax.numpy.array([slip, 0.0, -fall, 0.0, spin, 0.0]))
    for _ in range(round(TIME / STEP)):
        state = advance(system, state)
    return float(state.xd.vel[0, 0]), float(state.xd.ang[0, 1])


fault = False
for what, friction, slip, spin, fall, gravity, expected, along, left in (
    ("slides on the floor", 0.0, 3.0, 0.0, 0.0, 10.0, "3 m/s, 0 rad/s", 3.0, 0.0),
    ("falls at 3 m/s", 0.0, 6.0, 0.0, 3.0, 0.0, "6 m/s, 0 rad/s", 4.236, 35.23),
    ("falls at 3 m/s", 0.01, 6.0, 0.0, 3.0, 0.0, "5.94 m/s, 1.5 rad/s", 4.241, 35.13),
    ("falls at 3 m/s", 0.3, 6.0, 0.0, 3.0, 0.0, "4.286 m/s, 42.9 rad/s", 4.283, 34.37),
    ("falls at 3 m/s", 0.0, 0.0, 50.0, 3.0, 0.0, "0 m/s, 50 rad/s", 1.382, 16.44),
):
    seen = run(friction, slip, spin, fall, gravity)
    print(f"friction {friction}, {slip:g} m/s, {spin:g} rad/s, {what}: expected {expected}; seen {seen[0]:.3f} m/s, {seen[1]:.2f} rad/s")
    fault |= abs(seen[0] - along) > 0.05 or abs(seen[1] - left) > 1.0
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore grip.py 2>&1 | grep -v "warp"
