"""R_x and rebounds of balls in PyTorch, an optional dependency: `pip install carom[torch]`.

Array code in double precision that autograd take, from the table that the library itself uses: values are those of
`carom.restitution` within round-off. Derivatives are those of the table's polynomials, within 2e-6 of the exact impact; at
psi = 1, where the contact begins to slide at first, and at the onset of sliding throughout they are one-sided. Where an
argument is out of range the result is NaN, since compiled code cannot raise an error.
"""

from __future__ import annotations

from typing import Any

import torch  # type: ignore[import-not-found,unused-ignore]

from . import _table

__all__ = ["rebound", "restitution"]


class _Torch:
    def where(self, condition: Any, one: Any, other: Any) -> Any:
        return torch.where(condition, one, other)

    def take(self, table: Any, index: Any) -> Any:
        return torch.as_tensor(table, device=index.device)[index]

    def integer(self, values: Any) -> Any:
        return values.to(torch.int64)

    def stack(self, parts: list[Any]) -> Any:
        return torch.stack(torch.broadcast_tensors(*parts), dim=-1)


_OPS = _Torch()


def __dir__() -> list[str]:
    return __all__


def _double(*values: Any) -> list[Any]:
    """Tensors in double precision."""
    return [torch.as_tensor(value, dtype=torch.float64) for value in values]


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
