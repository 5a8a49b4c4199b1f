"""The functions of `carom.jax` and `carom.torch`, written once for a library of arrays."""

from __future__ import annotations

from typing import Any, Callable

from . import _line_contact, _table, _table_losses, _table_unlike
from ._line_contact import ContactState
from ._table import Ops


def _is(value: Any, number: float) -> bool:
    """Whether a value is this number, known before compilation."""
    return isinstance(value, (int, float)) and value == number


class Functions:
    """What a library of arrays offers; `double` makes arrays in double precision of all arguments."""

    def __init__(self, ops: Ops, double: Callable[..., list[Any]]) -> None:
        self._ops, self._double = ops, double

    def restitution(
        self,
        kappa: Any,
        lam: Any,
        *,
        gamma: Any = None,
        friction: Any = None,
        mobility_ratio: Any = 3.5,
        normal_restitution: Any = 1.0,
    ) -> Any:
        """R_x of spheres, as `carom.restitution`: kappa above 0.75 and at most 1.5, lambda >= 0.

        `normal_restitution` from .1 is that of a viscous material. Of unlike materials give `gamma` and `friction` (at most 1), as of
        `MaterialPair.gamma`: kappa from 1, |gamma|/f to 12, lambda to 8, `mobility_ratio` D_xx/D_zz from 1 to 6 (3.5 of solid
        spheres).
        """
        ops, where = self._ops, self._ops.where
        if (gamma is None) != (friction is None):
            raise TypeError("restitution() takes gamma and friction together")
        kappa, lam, ratio, e = ops.broadcast(self._double(kappa, lam, mobility_ratio, normal_restitution))
        holds = (kappa > 0.75) & (kappa <= 1.5 + 1e-12) & (lam >= 0.0)
        chi, psi = ratio / where(holds, kappa, 1.0), where(holds, lam, 1.0) / where(holds, kappa, 1.0)
        if _is(normal_restitution, 1.0):
            found = _table.restitution(ops, _table.stored(), chi, psi)
        else:
            found = _table_losses.restitution(ops, chi, psi, e)
        if gamma is not None:
            kappa, lam, ratio, e, gamma, friction = ops.broadcast([kappa, lam, ratio, e, *self._double(gamma, friction)])
            unlike = _table_unlike.restitution(ops, kappa, lam, gamma, friction, ratio)
            found = where(e >= 1.0, unlike, float("nan"))
        return where(holds, found, float("nan"))

    def rebound(
        self,
        velocity: Any,
        spin: Any,
        *,
        radius: Any,
        friction: Any,
        kappa: Any,
        gamma: Any = 0.0,
        inertia: Any = 0.4,
        normal_restitution: Any = 1.0,
        loss: str = "yield",
    ) -> tuple[Any, Any]:
        """Velocity and spin of a ball, or many, after an impact on a fixed plane whose normal is z.

        `velocity` and `spin` are (..., 3), in m/s and rad/s, before the impact; the ball comes from above, and one that does
        not approach keeps its motion. `radius` in m, `friction` above 0, `kappa` is the ratio of the stiffnesses of the
        contact, (1 - nu/2)/(1 - nu) of like half-spaces; `gamma` is not 0 for unlike materials (`MaterialPair`), without a loss.
        `inertia` I/(m R^2) is 2/5 of a solid ball, 2/3 of a thin shell. A `normal_restitution` below 1 is that of a body that
        yields, or with `loss="viscous"` that of a viscous one, as in `carom.collide`. The spin about the normal is kept, as by `torsion=False`.
        """
        velocity, spin = self._double(velocity, spin)
        still = 0.0 * velocity
        one, turned, _, _ = self.rebound_of_two(
            velocity, spin, still, still, radius=(radius, 1.0), mass=(1.0, float("inf")), friction=friction, kappa=kappa,
            gamma=gamma, inertia=inertia, normal_restitution=normal_restitution, loss=loss,
        )  # fmt: skip
        return one, turned

    def rebound_of_two(
        self,
        velocity_1: Any,
        spin_1: Any,
        velocity_2: Any,
        spin_2: Any,
        *,
        radius: tuple[Any, Any],
        mass: tuple[Any, Any],
        friction: Any,
        kappa: Any,
        gamma: Any = 0.0,
        inertia: Any = 0.4,
        normal_restitution: Any = 1.0,
        loss: str = "yield",
    ) -> tuple[Any, Any, Any, Any]:
        """Velocities and spins of two balls, or many pairs, after an impact; z points from ball 2 to ball 1.

        `radius` and `mass` are those of ball 1 and ball 2; an infinite mass is fixed. The rest is as in `rebound`. The line of centres keeps its direction.
        """
        if loss not in ("yield", "viscous"):
            raise ValueError(f"loss = {loss!r} is out of range: must be 'yield' or 'viscous'")
        ops, where = self._ops, self._ops.where
        is_like = _is(gamma, 0.0)
        motions = self._double(velocity_1, spin_1, velocity_2, spin_2)
        numbers = self._double(*radius, *mass, friction, kappa, gamma, inertia, normal_restitution)
        *numbers, moving = ops.broadcast([*numbers, sum(motion[..., 0] for motion in motions)])
        radii, inverse = numbers[:2], [1.0 / one for one in numbers[2:4]]
        friction, kappa, gamma, inertia, e = numbers[4:]
        v_1, w_1, v_2, w_2 = ([motion[..., axis] + 0.0 * moving for axis in range(3)] for motion in motions)
        down = v_2[2] - v_1[2]
        meets = down > 0.0
        down = where(meets, down, 1.0)
        slip = [
            v_1[0] - v_2[0] - radii[0] * w_1[1] - radii[1] * w_2[1],
            v_1[1] - v_2[1] + radii[0] * w_1[0] + radii[1] * w_2[0],
        ]
        square = slip[0] ** 2 + slip[1] ** 2
        moves = square > 0.0
        speed = where(moves, where(moves, square, 1.0) ** 0.5, 0.0)
        along = inverse[0] + inverse[1]
        across = along * (1.0 + 1.0 / inertia)
        r_x = self._restitution(across / along, speed / (friction * down), kappa, None if is_like else gamma, friction, e, loss)
        part = where(meets, -(1.0 + r_x) / across, 0.0)
        force = [part * slip[0], part * slip[1], where(meets, (1.0 + e) * down / along, 0.0)]
        after = []
        for v, w, own, sign, radius_of in ((v_1, w_1, inverse[0], 1.0, radii[0]), (v_2, w_2, inverse[1], -1.0, radii[1])):
            turn = own / (inertia * radius_of)
            after.append(ops.stack([v[axis] + sign * own * force[axis] for axis in range(3)]))
            after.append(ops.stack([w[0] + turn * force[1], w[1] - turn * force[0], w[2]]))
        return after[0], after[1], after[2], after[3]

    def _restitution(self, ratio: Any, lam: Any, kappa: Any, gamma: Any, friction: Any, e: Any, loss: str) -> Any:
        """R_x of bodies whose D_xx/D_zz is `ratio`."""
        ops, where = self._ops, self._ops.where
        like = gamma == 0.0
        if loss == "viscous":
            viscous = _table_losses.restitution(ops, ratio / kappa, lam / kappa, e)
            return viscous if gamma is None else where(like, viscous, float("nan"))
        alike = (1.0 + _table.restitution(ops, _table.stored(), ratio / kappa, lam / kappa)) * 0.5 * (1.0 + e) - 1.0
        if gamma is None:
            return alike
        unlike = where(e >= 1.0, _table_unlike.restitution(ops, kappa, lam, gamma, friction, ratio), float("nan"))
        return where(like, alike, unlike)

    def contact_state(self, shape: tuple[int, ...] = (), *, capacity: int = 64) -> ContactState:
        """Contacts before the first touch, without shift, for `advance`.

        There is room for `capacity` annuli: each change of direction, and each step in which the contact grows without slip, takes
        one, until slip or separation sets them free. A contact that needs more has the load NaN.
        """
        ops = self._ops
        zero, curve = ops.zeros(shape), ops.zeros((*shape, capacity))
        return ContactState(zero, zero, curve, curve, ops.integer(zero))

    def advance(
        self, state: ContactState, zeta: Any, xi: Any, *, stiffness: tuple[Any, Any], friction: Any
    ) -> tuple[ContactState, tuple[Any, Any]]:
        """A straight step to the approach `zeta` and the shift `xi` (m): the new memory, and F_x and F_z (N).

        The exact law in one direction, as `carom.Contacts(directions=1)`, for like materials; `stiffness` is (c_x, c_z),
        N/m^1.5, as of `carom.hertz`, `friction` above 0. Derivatives are those of the whole path, by friction and stiffness, too.
        """
        ops = self._ops
        zeta, xi, c_x, c_z, friction, _ = ops.broadcast(self._double(zeta, xi, *stiffness, friction, state.zeta))
        slope = friction * c_z / c_x
        new = _line_contact.moved(ops, state, zeta, xi, slope)
        return new, _line_contact.load(ops, new, (c_x, c_z))
