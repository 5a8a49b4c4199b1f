#!/usr/bin/env bash
# Finding: In pooltool a cushion of restitution 1 without friction takes 27 % of the energy of a ball that meets it head on; asked for the default 0.85 it gives back 0.72 to 0.81 of the speed.
# Package: pooltool-billiards 0.6.0 (PyPI)
# Expected: e_c is the restitution of ball and cushion: with e_c = 1, no friction at cushion and cloth, a ball that meets it head on comes back with its speed and energy.
# Seen: 0.855 of the speed, 0.730 of the energy; e_c = 0.85: 0.716 without friction, 0.739 sliding, 0.812 rolling. The nose is above the centre: the normal slopes by 15.6 degrees, and the downward velocity is set to 0.
# Touches carom: The door to pooltool takes over its normal and its plane motion, and so this loss; a rebound measured on a table is not the normal_restitution of carom.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export HOME="$folder"
python3 -m venv "$folder/env"
cd "$folder"
# Without dependencies: pooltool asks for a development version of panda3d that is not published.
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-deps pooltool-billiards==0.6.0 numba==0.62.1 llvmlite==0.45.1 \
    numpy==2.3.5 scipy==1.17.1 panda3d==1.10.16 panda3d-gltf==1.3.0 panda3d-simplepbr==0.13.1 attrs==26.1.0 cattrs==26.2.1 \
    click==8.5.1 h5py==3.16.0 msgpack==1.2.4 msgpack-numpy==0.4.8 numpy-quaternion==2024.0.13 pillow==13.0.0 PyYAML==6.0.4 \
    rich==14.3.4 Pygments==2.21.0 markdown-it-py==4.3.0 mdurl==0.1.2 typing_extensions==4.16.0
cat > head_on.py <<'PYTHON'
import importlib.metadata
import sys

import attrs
import numpy as np
import pooltool as pt
from pooltool.objects.ball.params import BallParams


def rebound(e_c: float, f_c: float, rolls: bool) -> tuple[float, float]:
    """Speed and energy after the first cushion over those before, in a simulated shot on a cloth without friction."""
    own = attrs.evolve(BallParams(), e_c=e_c, f_c=f_c, u_s=1e-9, u_r=1e-9)
    ball = pt.Ball.create("cue", xy=(0.8, 1.5))
    ball.params = own
    ball.state.rvw[1] = [2, 0, 0]
    ball.state.s = pt.constants.sliding
    if rolls:
        ball.state.rvw[2], ball.state.s = [0, 2 / own.R, 0], pt.constants.rolling
    system = pt.System(cue=pt.Cue(cue_ball_id="cue"), table=pt.Table.default(), balls={"cue": ball})
    pt.simulate(system, inplace=True, t_final=0.4)
    event = next(event for event in system.events if "cushion" in str(event.event_type))
    before, after = (state.state.rvw for state in (event.agents[0].initial, event.agents[0].final))
    energies = [(v @ v) / 2 + 0.2 * own.R**2 * (w @ w) for v, w in (np.array(rvw[1:]) for rvw in (before, after))]
    return float(-after[1][0] / before[1][0]), energies[1] / energies[0]


print("pooltool-billiards", importlib.metadata.version("pooltool-billiards"), "model", type(pt.physics.PhysicsEngine().resolver.ball_linear_cushion).__name__)
fault = False
for e_c, f_c, rolls, stated in ((1.0, 1e-9, False, 0.855), (0.85, 1e-9, False, 0.716), (0.85, 0.2, False, 0.739), (0.85, 0.2, True, 0.812)):
    speed, energy = rebound(e_c, f_c, rolls)
    print(f"e_c = {e_c}, f_c = {f_c:g}, {'rolling' if rolls else 'sliding'}: speed {speed:.3f}, energy {energy:.3f} of those before")
    fault |= abs(speed - stated) > 0.003 or (e_c == 1 and abs(energy - 0.730) > 0.005)
sys.exit(int(fault))
PYTHON
env/bin/python head_on.py
