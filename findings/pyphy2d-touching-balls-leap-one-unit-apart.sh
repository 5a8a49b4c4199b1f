#!/usr/bin/env bash
# Finding: In pyphy2D two balls that touch are set one unit of length apart, whatever their size: billiard balls of 57.2 mm leap 17 diameters apart.
# Package: pyphy2D 1 (PyPI)
# Expected: An overlap of a hundredth of a millimetre is undone by moving the balls by as much.
# Seen: Each ball is moved by half of the sum of the radii over the distance, thus by at least 0.5: in metres by 0.5 m, 8.75 diameters of a billiard ball, in pixels by half a pixel. Velocities after the impact are right; a ball on a box is moved by its overlap.
# Touches carom: Give lengths of some thousands of units to a ball before the path after an impact is compared with carom's.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check pyphy2D==1 pygame==2.6.1
cd "$folder"
cat > leap.py <<'PYTHON'
import importlib.metadata
import sys

import pygame
from pyphy.body import Body
from pyphy.vector2 import Vector2
from pyphy.world import World

print("pyphy2D", importlib.metadata.version("pyphy2D"))
WINDOW = pygame.Surface((100, 100))  # never drawn on


def world() -> World:
    """One without gravity."""
    space = World(WINDOW, (0.0, 0.0))
    space.ToggleGroundIsLava()
    return space


def meet(diameter: float) -> tuple[float, float, float]:
    """Head-on impact at one diameter per second: gap after the step of the impact, and both velocities, in diameters."""
    space = world()
    one = Body.CreateCircleBody(diameter / 2, Vector2(-1.0995 * diameter, 0.0), 1.0, 1.0, False)
    two = Body.CreateCircleBody(diameter / 2, Vector2(0.0, 0.0), 1.0, 1.0, False)
    one.linearVelocity = Vector2(diameter, 0.0)
    for body in (one, two):
        space.AddBody(body)
    while two.linearVelocity.x == 0.0 and one.position.x < 0:
        space.step(1e-3)
    return (two.position.x - one.position.x) / diameter - 1, one.linearVelocity.x / diameter, two.linearVelocity.x / diameter


def fall(diameter: float) -> float:
    """Height over a box after the step of the impact, in diameters."""
    space = world()
    floor = Body.CreateBoxBody(20 * diameter, diameter, Vector2(0.0, 0.5 * diameter), 1.0, 1.0, True)
    ball = Body.CreateCircleBody(diameter / 2, Vector2(0.0, -0.5995 * diameter), 1.0, 1.0, False)  # y points down
    ball.linearVelocity = Vector2(0.0, diameter)
    for body in (floor, ball):
        space.AddBody(body)
    while ball.linearVelocity.y > 0 and ball.position.y < 0:
        space.step(1e-3)
    return -ball.position.y / diameter - 0.5


fault = False
for name, diameter in (("billiard balls in m", 0.0572), ("beach balls in m", 0.5), ("balls of 50 pixels", 50.0), ("billiard balls in um", 57200.0)):
    gap, one, two = meet(diameter)
    print(f"{name}: expected 0.0000 diameters apart, seen {gap:.4f}; velocities {one:.3f} and {two:.3f}; on a box {fall(diameter):.4f}")
    fault |= abs(gap * diameter - 1.0) > 0.002 + 0.001 * diameter or abs(one) > 1e-6 or abs(two - 1) > 1e-6
    fault |= abs(fall(diameter)) > 1e-3
sys.exit(int(fault))
PYTHON
env/bin/python leap.py
