"""Draws how a rolling ball leaves a cushion by carom and by the models of pooltool: python compare.py [PICTURE.png]."""

import pathlib
import sys

import numpy as np
import pooltool as pt
from carom_pooltool import CaromLinear, stiffness_ratio
from pooltool.objects.ball.datatypes import BallParams, BallState
from pooltool.objects.table.components import LinearCushionSegment
from pooltool.physics.resolve.ball_cushion.han_2005 import Han2005Linear
from pooltool.physics.resolve.ball_cushion.mathavan_2010 import Mathavan2010Linear
from pooltool.physics.resolve.ball_cushion.stronge_compliant import StrongeCompliantLinear
from pooltool.physics.resolve.resolver import default_resolver

PICTURE = str(pathlib.Path(__file__).resolve().parents[2] / "docs/book/src/start/pooltool.png")
SPEED = 1.5
"""m/s."""
SIDES = (-1.0, 0.0, 1.0)
"""Side spin, R omega/v; positive is running side, which drives the ball on along the cushion."""
ANGLES = np.linspace(1, 85, 85)
"""Degrees from the normal of the cushion."""
HEIGHT = 0.64
"""Height of the cushion's edge over the diameter of the ball, that of pooltool's tables."""
RUBBER = 0.5

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


def rebound(model: Model, degrees: float, side: float) -> tuple[float, float]:
    """The angle in degrees from the normal and the side spin R omega/v after the collision."""
    own = BallParams()
    angle = np.radians(degrees)
    velocity = SPEED * np.array([np.cos(angle), np.sin(angle), 0.0])
    # Rolling, and side spin: positive moves the surface at the cushion, x = R, against the ball.
    spin = np.array([-velocity[1], velocity[0], 0.0]) / own.R + [0.0, 0.0, -side * SPEED / own.R]
    height = HEIGHT * 2 * own.R
    ends = [np.array([0.0, y, height]) for y in (-1.0, 1.0)]
    ball = pt.Ball(id="ball", params=own)
    distance = np.sqrt(own.R**2 - (height - own.R) ** 2)
    ball.state = BallState(np.array([[-distance, 0.0, own.R], velocity, spin]), pt.constants.sliding)
    after, _ = model.solve(ball, LinearCushionSegment(id="cushion", p1=ends[0], p2=ends[1]))
    _, v, w = after.state.rvw
    return float(np.degrees(np.arctan2(v[1], -v[0]))), float(-w[2] * own.R / SPEED)


def curves(model: Model, side: float) -> np.ndarray:
    """Angle and side spin after, for all angles before."""
    return np.array([rebound(model, degrees, side) for degrees in ANGLES]).T


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
        rows[0, column].set_title(f"side spin before: {side:+.0f} v/R".replace("+0", "0").replace("-", "−"))
        rows[1, column].set_xlabel("angle before, degrees from the normal")
    for axes in rows.flat:
        axes.grid(alpha=0.25)
    rows[0, 0].set_ylabel("angle after, degrees")
    rows[1, 0].set_ylabel("side spin after, R ω/v before")
    handles, names = rows[0, 0].get_legend_handles_labels()
    figure.legend(handles, names, loc="outside lower center", ncols=3, frameon=False)
    figure.savefig(path, dpi=100, metadata={"Software": None})


def largest(side: float) -> tuple[float, float]:
    """The largest difference of angle and side spin between carom and pooltool's default."""
    ours, theirs = (curves(model, side) for model in (CaromLinear(RUBBER), default_resolver().ball_linear_cushion))
    angle, spin = np.abs(ours - theirs).max(axis=1)
    return float(angle), float(spin)


if __name__ == "__main__":
    draw(sys.argv[1] if len(sys.argv) > 1 else PICTURE)
    for side in SIDES:
        angle, spin = largest(side)
        print(f"side spin {side:+.0f}: carom and the default differ by at most {angle:.1f} degrees, side spin {spin:.2f} v/R")
