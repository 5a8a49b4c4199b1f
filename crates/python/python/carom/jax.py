"""R_x and rebounds of balls in JAX, an optional dependency: `pip install carom[jax]`.

Array code in double precision that `jit`, `vmap` and `grad` take, from the table that the library itself uses: values are those of
`carom.restitution` within round-off. Derivatives are those of the table's polynomials, within 2e-6 of the exact impact; at
psi = 1, where the contact begins to slide at first, and at the onset of sliding throughout they are one-sided. Where an
argument is out of range the result is NaN, since compiled code cannot raise an error.
"""

from __future__ import annotations

from typing import Any

import jax  # type: ignore[import-not-found,unused-ignore]
import jax.numpy as jnp  # type: ignore[import-not-found,unused-ignore]

from . import _table

__all__ = ["rebound", "restitution"]


class _Jax:
    where = staticmethod(jnp.where)

    def take(self, table: Any, index: Any) -> Any:
        return jnp.asarray(table)[index]

    def integer(self, values: Any) -> Any:
        return jnp.asarray(values).astype(jnp.int32)

    def stack(self, parts: list[Any]) -> Any:
        return jnp.stack(jnp.broadcast_arrays(*parts), axis=-1)


_OPS = _Jax()


def __dir__() -> list[str]:
    return __all__


def _double(*values: Any) -> list[Any]:
    """Arrays in double precision."""
    if not jax.config.jax_enable_x64:
        raise RuntimeError("carom.jax needs double precision: call jax.config.update('jax_enable_x64', True) first")
    return [jnp.asarray(value, dtype=jnp.float64) for value in values]


def restitution(kappa: Any, lam: Any) -> Any:
    """R_x of solid spheres of like materials, as `carom.restitution`: kappa above 0.75 and at most 1.5, lambda >= 0."""
    kappa, lam = _double(kappa, lam)
    return _table.of_spheres(_OPS, kappa, lam)


def rebound(
    velocity: Any,
    spin: Any,
    *,
    radius: Any,
    friction: Any,
    kappa: Any,
    inertia: Any = 0.4,
    normal_restitution: Any = 1.0,
) -> tuple[Any, Any]:
    """Velocity and spin of a ball, or many, after an impact on a fixed plane of like material, whose normal is z.

    `velocity` and `spin` are (..., 3), in m/s and rad/s, before the impact; the ball comes from above, and one that does not
    approach keeps its motion. `radius` in m, `friction` above 0, `kappa` is the ratio of the stiffnesses of the contact, (1 - nu/2)/(1 - nu) of a
    half-space; `inertia` I/(m R^2) is 2/5 of a solid ball, 2/3 of a thin shell. A `normal_restitution` below 1 is that of a
    body that yields, `loss="yield"` of `carom.collide`. The spin about the normal is kept, as by `torsion=False`.
    """
    velocity, spin, *numbers = _double(velocity, spin, radius, friction, kappa, inertia, normal_restitution)
    radius, friction, kappa, inertia, restitution_z = numbers
    return _table.bounce(
        _OPS, velocity, spin, radius=radius, friction=friction, kappa=kappa, inertia=inertia, restitution_z=restitution_z
    )
