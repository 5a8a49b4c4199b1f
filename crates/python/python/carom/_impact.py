"""Bodies and their collisions."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import counted, line, number, numbers, rows, spread, switch
from ._carom import Body, Material
from ._friction import SlipSpeedFriction, by_speed
from ._loss import RestitutionBySpeed, loss_of, losses_of
from ._records import HistoryPoints, Rebound, Rebounds
from ._types import Array, Vector
from ._validity import warn

UP = (0.0, 0.0, 1.0)


def sphere(
    radius: float,
    material: Material,
    mass: float | None = None,
    *,
    density: float | None = None,
    hollow: bool = False,
    velocity: Vector = (0.0, 0.0, 0.0),
    spin: Vector = (0.0, 0.0, 0.0),
    centre: Vector = (0.0, 0.0, 0.0),
) -> Body:
    """A solid sphere or, if `hollow`, a thin spherical shell; with its `mass`, or solid with a `density`. m, kg, kg/m3, m/s, rad/s."""
    if mass is None and density is None:
        raise TypeError("sphere() needs `mass` or `density`")
    sizes = [number("radius", radius, "m")]
    motion = {"velocity": velocity, "spin": spin, "centre": centre}
    return Body("sphere", sizes, material, mass, density=density, hollow=hollow, **motion)


def plane(material: Material) -> Body:
    """A fixed plane that bounds a half-space."""
    return Body("plane", [], material)


def _bodies(*bodies: object) -> None:
    """Checks that these are bodies."""
    for number, body in enumerate(bodies, 1):
        if not isinstance(body, Body):
            raise TypeError(f"body_{number}: must be a Body, such as carom.sphere(...), not {type(body).__name__}")


def _along(body_1: Body, body_2: Body, normal: Vector | None) -> Vector | None:
    """The common normal. Bodies with a given position are moved only if `normal` is passed explicitly."""
    _bodies(body_1, body_2)
    if normal is UP and (any(body_1.centre) or any(body_2.centre)):
        raise ValueError("normal: must be given if a body has a centre; None if the bodies touch at their given positions")
    return normal


def _beside(
    friction: object, static_friction: float | None
) -> tuple[tuple[float, float, float] | None, float | None]:
    """The numbers of friction by the slip speed, which replaces the coefficient, and static friction beside it."""
    speed = by_speed(friction)
    if speed is not None and static_friction is not None:
        raise ValueError("static_friction: friction by the slip speed has one coefficient at rest, a + b")
    return speed, None if static_friction is None else number("static_friction", static_friction)


def _coefficient(friction: float | SlipSpeedFriction) -> float:
    """The coefficient of friction; zero if friction by the slip speed replaces it."""
    return 0.0 if isinstance(friction, SlipSpeedFriction) else number("friction", friction)


def collide(
    body_1: Body,
    body_2: Body,
    friction: float | SlipSpeedFriction,
    *,
    static_friction: float | None = None,
    normal: Vector | None = UP,
    torsion: bool | None = None,
    law: str = "auto",
    tolerance: float | None = None,
    normal_restitution: float | RestitutionBySpeed = 1.0,
    loss: str | None = None,
    wave_loss: bool = False,
    relaxation: float = 0.0,
) -> Rebound:
    """Computes the impact of two bodies. Body 1 is first placed on body 2 with the given common normal.

    `normal` points from body 2 into body 1. Of bodies that move apart along it the `outcome` is no_impact, and the text of
    the result says how fast. With `normal=None` the bodies touch at their given positions;
    if a body has a centre, pass `normal` explicitly. The result says in `method` how it was computed, and
    in `error_estimate` how accurate it is.

    `law` is 'auto', 'coulomb', 'fixed-direction', 'rings' or 'numerical'. With 'auto' the coupling of
    dissimilar materials counts where it matters, by rings for spheres and planes and on a grid for other
    shapes; 'coulomb' and 'fixed-direction' neglect it. An impact by rings takes some milliseconds, one of
    like materials some microseconds.

    `friction` is a coefficient, or a `SlipSpeedFriction` that depends on the slip speed at the first touch; the result
    says in `friction` which coefficient was used.

    With a `static_friction` above `friction` the contact sticks or slips in part up to f_s F_z, and slides as a whole with
    `friction`. Torsion and the laws 'rings' and 'numerical' are refused.

    `torsion=None` applies friction to the spin about the normal where it matters, for spheres and planes by
    the laws 'auto' and 'rings'; True always does so, False never.

    A `normal_restitution` below 1 dissipates energy in the material, beyond the elastic theory: the material is viscous
    (Kelvin and Voigt), along the normal and across. `loss="maxwell"`, "standard-solid" (which relaxes to a tenth) and
    "constant-loss-tangent" are other materials, for like spheres and planes without spin and e from 0.1.
    `loss="yield"` takes bodies that yield: the elastic impulse times (1 + e)/2. A `RestitutionBySpeed` in place of the number
    depends on the speed of approach along the normal. A `relaxation` time (s) of both bodies together gives the viscous
    material, whose restitution falls as the speed grows; `wave_loss=True` dissipates what elastic waves carry away.

    A fixed body that moves, like a racket, does work on the other: then the energies do not balance.

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> ball = carom.sphere(0.01, steel, 0.033, velocity=(0.25, 0, -0.5))
    >>> rebound = carom.collide(ball, carom.plane(steel), friction=0.2)
    >>> bool(rebound.R_x > 0.1)  # it bounces back
    True
    >>> lost = rebound.energy_before - rebound.energy_after
    >>> bool(abs(lost - rebound.energy_dissipated) < 1e-9 * rebound.energy_before)
    True
    """
    along, lost = _along(body_1, body_2, normal), loss_of(normal_restitution, loss, wave_loss, relaxation)
    beside = _beside(friction, static_friction)
    coefficient = _coefficient(friction)
    twist = switch("torsion", torsion)
    columns, exceeded, missed = _carom.collide(body_1, body_2, coefficient, beside, along, twist, law, tolerance, lost)
    warn(exceeded)
    return Rebound._of(columns)._noting(missed)


def collide_many(
    body_1: Body,
    body_2: Body,
    friction: ArrayLike | SlipSpeedFriction,
    *,
    static_friction: ArrayLike | None = None,
    body_1_velocity: ArrayLike | None = None,
    body_1_spin: ArrayLike | None = None,
    body_2_velocity: ArrayLike | None = None,
    body_2_spin: ArrayLike | None = None,
    normal: Vector | None = UP,
    torsion: bool | None = None,
    law: str = "auto",
    tolerance: float | None = None,
    normal_restitution: ArrayLike | RestitutionBySpeed = 1.0,
    loss: str | None = None,
    wave_loss: bool = False,
    relaxation: ArrayLike = 0.0,
) -> Rebounds:
    """Computes the impacts of the same two bodies for many motions, arrays (n, 3), and frictions, static frictions, restitutions
    along the normal or relaxation times, (n,).

    A single vector or number holds for all. Uses all cores, and gives the same bits on any number.

    >>> import carom, numpy as np
    >>> steel = carom.Material(208e9, 0.3)
    >>> ball = carom.sphere(0.01, steel, 0.033)
    >>> velocities = np.stack([np.linspace(0, 1.5, 7), np.zeros(7), np.full(7, -1.0)], axis=1)
    >>> rebound = carom.collide_many(ball, carom.plane(steel), 0.15, body_1_velocity=velocities)
    >>> rebound.body_1_velocity.shape, rebound.R_x.shape
    ((7, 3), (7,))
    """
    _bodies(body_1, body_2)
    default = (body_1.velocity, body_1.spin, body_2.velocity, body_2.spin)
    names = ("body_1_velocity", "body_1_spin", "body_2_velocity", "body_2_spin")
    told = zip(names, (body_1_velocity, body_1_spin, body_2_velocity, body_2_spin), default, strict=True)
    units = dict(zip(names, ("m/s", "rad/s") * 2, strict=True))
    given = {name: numbers(name, d if v is None else v, units[name]) for name, v, d in told}
    resting = None if static_friction is None else numbers("static_friction", static_friction)
    speed, _ = _beside(friction, None if resting is None else 0.0)
    coefficients = numbers("friction", 0.0 if isinstance(friction, SlipSpeedFriction) else friction)
    counts = {name: len(v) for name, v in given.items() if v.ndim == 2 and v.shape[1] == 3}
    cause, lost, table = losses_of(normal_restitution, loss, wave_loss, relaxation)
    what = "relaxation" if cause == "relaxation" else "normal_restitution"
    beside_them = {"friction": coefficients, what: lost, "static_friction": resting}
    counts |= {name: len(v) for name, v in beside_them.items() if v is not None and v.ndim == 1}
    if len(set(counts.values())) > 1:
        told_lengths = ", ".join(f"{name} {length}" for name, length in counts.items())
        raise ValueError(f"motions, frictions and loss: must have the same length, not {told_lengths}")
    count = next(iter(counts.values()), 1)
    motions = [rows(name, v, count) for name, v in given.items()]
    frictions = line(spread("friction", coefficients, (count,)))
    beside = (speed, None if resting is None else line(spread("static_friction", resting, (count,))))
    losses = (cause, line(spread(what, lost, (count,))), table)
    columns, exceeded = _carom.collide_many(
        body_1, body_2, frictions, beside, motions, _along(body_1, body_2, normal), switch("torsion", torsion), law, tolerance, losses
    )
    warn(exceeded)
    return Rebounds._shaped(columns, (count,))


def history(
    body_1: Body,
    body_2: Body,
    friction: float | SlipSpeedFriction,
    points: int = 101,
    *,
    static_friction: float | None = None,
    normal: Vector | None = UP,
    law: str = "auto",
    tolerance: float | None = None,
    normal_restitution: float | RestitutionBySpeed = 1.0,
    loss: str | None = None,
    wave_loss: bool = False,
    relaxation: float = 0.0,
) -> HistoryPoints:
    """The history of a collision at equally spaced times from first contact to separation, in contact axes. The arguments are
    those of `collide`.

    The axes of two balls turn with their line of centres, which is in `normal`. With `loss="yield"` the history is that of the
    elastic impact.

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> ball = carom.sphere(0.01, steel, 0.033, velocity=(0.5, 0, -1))
    >>> course = carom.history(ball, carom.plane(steel), 0.15, 51)
    >>> course.F.shape, course.regime[0] != course.regime[25]
    ((51, 3), True)
    """
    points = counted("points", points)
    along = _along(body_1, body_2, normal)
    beside = _beside(friction, static_friction)
    coefficient = _coefficient(friction)
    lost = loss_of(normal_restitution, loss, wave_loss, relaxation)
    columns, exceeded, missed = _carom.history(
        body_1, body_2, coefficient, beside, points, along, law, tolerance, lost
    )
    warn(exceeded)
    return HistoryPoints._shaped(columns, (len(columns["time"]),))._noting(missed)
