"""Draws how a ball leaves a cushion by carom and by the models of pooltool: python compare.py [PICTURE.png]."""

import io
import pathlib
import sys

import numpy as np
import pooltool as pt
from carom_pooltool import CaromBallBall, CaromLinear, stiffness_ratio
from PIL import Image
from pooltool.objects.ball.datatypes import BallState
from pooltool.objects.ball.params import BallParams, PrebuiltBallParams
from pooltool.objects.table.components import LinearCushionSegment
from pooltool.physics.resolve.ball_ball.frictional_inelastic import FrictionalInelastic
from pooltool.physics.resolve.ball_cushion.han_2005 import Han2005Linear
from pooltool.physics.resolve.ball_cushion.mathavan_2010 import Mathavan2010Linear
from pooltool.physics.resolve.ball_cushion.stronge_compliant import StrongeCompliantLinear
from pooltool.physics.resolve.resolver import default_resolver

PICTURE = str(pathlib.Path(__file__).resolve().parents[2] / "docs/book/src/start/pooltool.png")
SPEED = 1.5
"""m/s."""
SIDES = (-0.5, 0.0, 0.5)
"""Side spin, R omega/v; positive is running side, which drives the ball on along the cushion."""
ANGLES = np.linspace(1, 85, 85)
"""Degrees from the normal of the cushion."""
HEIGHT = 0.64
"""Height of the cushion's edge over the diameter of the ball, that of pooltool's tables."""
RUBBER = 0.5
POOL, SNOOKER = (BallParams.prebuilt(name) for name in (PrebuiltBallParams.POOL_GENERIC, PrebuiltBallParams.SNOOKER_GENERIC))
"""Balls of pooltool, with friction 0.2 and 0.5 at the cushion."""

Model = CaromLinear | StrongeCompliantLinear | Han2005Linear | Mathavan2010Linear


def models() -> dict[str, tuple[Model, str, str]]:
    """The models that are drawn, each with its colour and its line."""
    default = default_resolver().ball_linear_cushion
    ratio = (3.5 / stiffness_ratio(RUBBER)) ** 0.5
    return {
        "carom, ν = 0.5": (CaromLinear(RUBBER), "#0072B2", "-"),
        f"Stronge, ω ratio {default.omega_ratio} (default)": (default, "#B34700", "--"),
        f"Stronge, ω ratio {ratio:.2f} (ν = 0.5)": (StrongeCompliantLinear(ratio), "#B34700", ":"),
        "Han 2005": (Han2005Linear(), "#007A59", "-."),
        "Mathavan 2010": (Mathavan2010Linear(), "#A8487A", (0, (5, 1, 1, 1, 1, 1))),
    }


def rebound(model: Model, degrees: float, side: float, own: BallParams = SNOOKER, roll: float = 0) -> tuple[float, float]:
    """The angle in degrees from the normal and the side spin R omega/v after the collision.

    The ball slides without roll, or rolls if `roll` is 1.
    """
    angle = np.radians(degrees)
    velocity = SPEED * np.array([np.cos(angle), np.sin(angle), 0.0])
    # Positive side spin moves the surface at the cushion, x = R, against the ball.
    spin = np.array([-roll * velocity[1], roll * velocity[0], -side * SPEED]) / own.R
    height = HEIGHT * 2 * own.R
    ends = [np.array([0.0, y, height]) for y in (-1.0, 1.0)]
    ball = pt.Ball(id="ball", params=own)
    distance = np.sqrt(own.R**2 - (height - own.R) ** 2)
    ball.state = BallState(np.array([[-distance, 0.0, own.R], velocity, spin]), pt.constants.sliding)
    after, _ = model.solve(ball, LinearCushionSegment(id="cushion", p1=ends[0], p2=ends[1]))
    _, v, w = after.state.rvw
    return float(np.degrees(np.arctan2(v[1], -v[0]))), float(-w[2] * own.R / SPEED)


def curves(model: Model, side: float, own: BallParams = SNOOKER, roll: float = 0) -> np.ndarray:
    """Angle and side spin after, for all angles before."""
    return np.array([rebound(model, degrees, side, own, roll) for degrees in ANGLES]).T


def draw(path: str) -> None:
    """Draws angles in the first row and side spins in the second, for each side spin before."""
    import matplotlib as mpl

    mpl.use("Agg")
    import matplotlib.pyplot as plt

    mpl.rcParams.update({"axes.spines.top": False, "axes.spines.right": False, "font.size": 9})
    figure, rows = plt.subplots(2, len(SIDES), figsize=(9.6, 6.6), sharex=True, sharey="row", layout="constrained")
    for column, side in enumerate(SIDES):
        for name, (model, colour, line) in models().items():
            width = 2.2 if isinstance(model, CaromLinear) else 1.4
            for axes, values in zip(rows[:, column], curves(model, side), strict=True):
                axes.plot(ANGLES, values, color=colour, linestyle=line, linewidth=width, label=name)
        rows[0, column].set_title(f"side spin before: {side:+.1f} v/R".replace("+0.0", "0").replace("-", "−"))
        rows[1, column].set_xlabel("angle before, degrees from the normal")
    for axes in rows.flat:
        axes.grid(alpha=0.25)
    rows[0, 0].set_ylabel("angle after, degrees")
    rows[1, 0].set_ylabel("side spin after, R ω/v before")
    handles, names = rows[0, 0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside lower center", ncols=3, frameon=False)
    drawn = io.BytesIO()
    figure.savefig(drawn, dpi=100)
    plt.close(figure)
    Image.open(drawn).convert("RGB").quantize(48).save(path, format="PNG", optimize=True)


def largest(model: Model, own: BallParams, roll: float) -> tuple[float, float]:
    """The largest difference of angle and side spin between a model and carom, for all angles and side spins."""
    ours, theirs = (np.array([curves(one, side, own, roll) for side in SIDES]) for one in (CaromLinear(RUBBER), model))
    angle, spin = np.abs(ours - theirs).max(axis=(0, 2))
    return float(angle), float(spin)


def throw(model: CaromBallBall | FrictionalInelastic, degrees: float, speed: float) -> float:
    """The angle in degrees between the way of a ball that is hit without spin and the line of centres."""
    aim = np.radians(degrees)
    radius = POOL.R
    states = [
        [[0.0, 0.0, radius], speed * np.array([np.cos(aim), np.sin(aim), 0.0]), [0.0, 0.0, 0.0]],
        [[2 * radius, 0.0, radius], [0.0, 0.0, 0.0], [0.0, 0.0, 0.0]],
    ]
    balls = [pt.Ball(id=name, params=POOL) for name in "ab"]
    for ball, state in zip(balls, states, strict=True):
        ball.state = BallState(np.array(state), pt.constants.sliding)
    _, hit = model.solve(*balls)
    return float(np.degrees(np.arctan2(hit.vel[1], hit.vel[0])))


def throws(speed: float) -> tuple[float, float]:
    """The largest throw by pooltool's default and by carom, over the angles of the cut."""
    default = default_resolver().ball_ball
    return tuple(max(throw(model, degrees, speed) for degrees in ANGLES) for model in (default, CaromBallBall()))


def tell() -> None:
    """Prints by how much the models differ from carom."""
    for name, own in (("pool ball, friction 0.2", POOL), ("snooker ball, friction 0.5", SNOOKER)):
        for way, roll in (("slides", 0), ("rolls", 1)):
            for model, (strategy, _, _) in list(models().items())[1:]:
                angle, spin = largest(strategy, own, roll)
                print(f"{name}, {way}: {model} differs by at most {angle:.1f} degrees, side spin {spin:.2f} v/R")
    for speed in (0.5, 2.0):
        default, ours = throws(speed)
        print(f"largest throw of a pool ball at {speed} m/s: {default:.2f} degrees by the default, {ours:.2f} by carom")


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else PICTURE)
    tell()
