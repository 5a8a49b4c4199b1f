"""Impacts of elastic bodies with friction for pooltool: ball and cushion, ball and ball.

A strategy of pooltool gives the state of a ball after a collision. Those here take the tangential restitution R_x from
carom: that of the impact after Hertz and Mindlin, in which rings of the contact stick and slip and the surface gives back
the energy that it stored. R_x depends on kappa = (2 - nu)/(2 (1 - nu)) with Poisson's ratio nu, on lambda = slip
speed/(friction times approach speed), and on the normal restitution e: a material with e < 1 is viscous, along the normal
and across. Friction and normal restitution are those of pooltool.

>>> import pooltool as pt
>>> engine = pt.physics.PhysicsEngine(resolver=resolver())
>>> engine.resolver.ball_linear_cushion
CaromLinear(poisson=0.5)
"""

import attrs
import carom
import numpy as np
import pooltool.constants as const
from numpy.typing import NDArray
from pooltool.objects.ball.datatypes import Ball, BallState
from pooltool.objects.table.components import CircularCushionSegment, LinearCushionSegment
from pooltool.physics.resolve import Resolver
from pooltool.physics.resolve.ball_ball import ball_ball_models
from pooltool.physics.resolve.ball_ball.core import CoreBallBallCollision
from pooltool.physics.resolve.ball_ball.friction import AlciatoreBallBallFriction, BallBallFrictionStrategy
from pooltool.physics.resolve.ball_cushion import ball_ccushion_models, ball_lcushion_models
from pooltool.physics.resolve.ball_cushion.core import CoreBallCCushionCollision, CoreBallLCushionCollision
from pooltool.physics.resolve.resolver import default_resolver
from pooltool.physics.resolve.serialize import register_serialize_hooks

__all__ = ["CaromBallBall", "CaromCircular", "CaromLinear", "resolver"]

Vector = NDArray[np.float64]

MODEL = "carom"
"""The word for these strategies in the file of a resolver."""

RUBBER = 0.5
"""Poisson's ratio of rubber, which keeps its volume. The impact of a stiff ball on it is then exact."""

RESIN = 0.34
"""Poisson's ratio assumed for the resin of balls; R_x hardly depends on it."""

INERTIA = 0.4
"""Moment of inertia of a solid ball over its mass and radius squared."""

TURNING = 1 + 1 / INERTIA
"""Tangential over normal mobility of solid balls, 7/2."""


def _check(field: str, value: float, holds: bool, allowed: str) -> None:
    if not holds:
        raise ValueError(f"{field} = {value} must be {allowed}")


def _poisson(_: object, attribute: "attrs.Attribute[float]", value: float) -> None:
    _check(attribute.name, value, -1 < value <= 0.5, "in (-1, 0.5]")


def stiffness_ratio(poisson: float) -> float:
    """kappa, the normal over the tangential stiffness of a contact of like materials."""
    return (2 - poisson) / (2 * (1 - poisson))


def impulse(
    velocity: Vector, normal: Vector, mobility: float, poisson: float, friction: float, restitution: float
) -> Vector:
    """The impulse on a solid ball that hits another or a cushion.

    `velocity` is that of its contact point against the other body, `normal` points from the other body into the ball,
    `mobility` is the sum of the inverse masses. Zero if the bodies do not approach each other.
    """
    _check("friction", friction, 0 <= friction < np.inf, "finite and >= 0")
    _check("restitution", restitution, 0 <= restitution <= 1, "from 0 to 1")
    approach = -float(normal @ velocity)
    if not approach > 0:
        return np.zeros(3)
    slip = velocity + approach * normal
    speed = float(np.linalg.norm(slip))
    press = (1 + restitution) * approach / mobility
    drag = 0.0
    if friction > 0 and speed > 0:
        lam = speed / (friction * approach)
        r_x = carom.restitution(stiffness_ratio(poisson), lam, normal_restitution=restitution)
        drag = min((1 + r_x) * speed / (TURNING * mobility), friction * press)
    return press * normal - (drag / speed if speed > 0 else 0.0) * slip


def _at_contact(ball: Ball, normal: Vector) -> Vector:
    """The velocity of the point of a ball that touches, on the side away from the normal."""
    _, velocity, spin = ball.state.rvw
    return velocity + np.cross(spin, -ball.params.R * normal)


def _push(ball: Ball, normal: Vector, push: Vector) -> None:
    """The state after an impulse at the contact point. pooltool keeps balls on the table."""
    rvw = ball.state.rvw.copy()
    mass, radius = ball.params.m, ball.params.R
    rvw[1] += push / mass
    rvw[2] += np.cross(-normal, push) / (INERTIA * mass * radius)
    rvw[1][2] = 0.0
    ball.state = BallState(rvw, const.sliding)


def _cushion(ball: Ball, normal: Vector, poisson: float) -> None:
    params = ball.params
    push = impulse(_at_contact(ball, normal), normal, 1 / params.m, poisson, params.f_c, params.e_c)
    _push(ball, normal, push)


@attrs.define
class CaromLinear(CoreBallLCushionCollision):
    """A ball and a straight cushion. `poisson` is that of the cushion, in (-1, 0.5]."""

    poisson: float = attrs.field(default=RUBBER, validator=_poisson)
    model: str = attrs.field(default=MODEL, init=False, repr=False)

    def solve(self, ball: Ball, cushion: LinearCushionSegment) -> tuple[Ball, LinearCushionSegment]:
        """The ball after the collision; changes `ball`."""
        _cushion(ball, cushion.get_normal_3d(ball.xyz), self.poisson)
        return ball, cushion


@attrs.define
class CaromCircular(CoreBallCCushionCollision):
    """A ball and the round end of a cushion. `poisson` is that of the cushion, in (-1, 0.5]."""

    poisson: float = attrs.field(default=RUBBER, validator=_poisson)
    model: str = attrs.field(default=MODEL, init=False, repr=False)

    def solve(self, ball: Ball, cushion: CircularCushionSegment) -> tuple[Ball, CircularCushionSegment]:
        """The ball after the collision; changes `ball`."""
        _cushion(ball, cushion.get_normal_3d(ball.xyz), self.poisson)
        return ball, cushion


@attrs.define
class CaromBallBall(CoreBallBallCollision):
    """Two balls of one material, of any masses and radii. `poisson` is theirs, in (-1, 0.5]."""

    poisson: float = attrs.field(default=RESIN, validator=_poisson)
    friction: BallBallFrictionStrategy = attrs.field(factory=AlciatoreBallBallFriction)
    model: str = attrs.field(default=MODEL, init=False, repr=False)

    def solve(self, ball1: Ball, ball2: Ball) -> tuple[Ball, Ball]:
        """The balls after the collision; changes both."""
        apart = ball1.xyz - ball2.xyz
        normal = apart / np.linalg.norm(apart)
        velocity = _at_contact(ball1, normal) - _at_contact(ball2, -normal)
        mobility = 1 / ball1.params.m + 1 / ball2.params.m
        restitution = (ball1.params.e_b + ball2.params.e_b) / 2
        friction = self.friction.calculate_friction(ball1, ball2)
        push = impulse(velocity, normal, mobility, self.poisson, friction, restitution)
        _push(ball1, normal, push)
        _push(ball2, -normal, -push)
        return ball1, ball2


def resolver(cushion_poisson: float = RUBBER, ball_poisson: float = RESIN) -> Resolver:
    """pooltool's default resolver with these strategies for balls and cushions."""
    return attrs.evolve(
        default_resolver(),
        ball_ball=CaromBallBall(ball_poisson),
        ball_linear_cushion=CaromLinear(cushion_poisson),
        ball_circular_cushion=CaromCircular(cushion_poisson),
    )


def _register() -> None:
    """Lets pooltool read and write resolvers with these strategies."""
    ball_ball_models[MODEL] = CaromBallBall  # type: ignore[index]
    ball_lcushion_models[MODEL] = CaromLinear  # type: ignore[index]
    ball_ccushion_models[MODEL] = CaromCircular  # type: ignore[index]
    register_serialize_hooks()


_register()
