"""R_x, rebounds of balls and a contact with memory in JAX, an optional dependency: `pip install carom[jax]`.

Array code in double precision that `jit`, `vmap` and `grad` take, from the tables that the library itself uses: values are those of
the library within round-off. Derivatives are those of the tables' polynomials: of like bodies without a loss within 2e-6 of the exact
impact, else as smooth as their tables. At psi = 1, where the contact begins to slide at first, and at the onset of sliding throughout
they are one-sided. Where an argument is out of range the result is NaN, since compiled code cannot raise an error.
"""

from __future__ import annotations

from typing import Any

import jax  # type: ignore[import-not-found,unused-ignore]
import jax.numpy as jnp  # type: ignore[import-not-found,unused-ignore]

from ._gradients import Functions
from ._line_contact import ContactState

__all__ = ["ContactState", "advance", "contact_state", "rebound", "rebound_of_two", "restitution"]


class _Jax:
    def where(self, condition: Any, one: Any, other: Any) -> Any:
        return jnp.where(condition, one, other)

    def log(self, values: Any) -> Any:
        return jnp.log(values)

    def take(self, table: Any, index: Any) -> Any:
        return jnp.asarray(table)[index]

    def index(self, values: Any) -> Any:
        return jnp.arange(values.shape[-1])

    def integer(self, values: Any) -> Any:
        return jnp.asarray(values).astype(jnp.int32)

    def zeros(self, shape: tuple[int, ...]) -> Any:
        return jnp.zeros(shape, dtype=jnp.float64)

    def shifted(self, values: Any) -> Any:
        return jnp.roll(values, -1, axis=-1)

    def broadcast(self, values: list[Any]) -> list[Any]:
        return list(jnp.broadcast_arrays(*values))

    def stack(self, parts: list[Any]) -> Any:
        return jnp.stack(jnp.broadcast_arrays(*parts), axis=-1)


def __dir__() -> list[str]:
    return __all__


def _double(*values: Any) -> list[Any]:
    """Arrays in double precision."""
    if not jax.config.jax_enable_x64:
        raise RuntimeError("carom.jax needs double precision: call jax.config.update('jax_enable_x64', True) first")
    return [jnp.asarray(value, dtype=jnp.float64) for value in values]


_OWN = Functions(_Jax(), _double)
restitution = _OWN.restitution
rebound = _OWN.rebound
rebound_of_two = _OWN.rebound_of_two
contact_state = _OWN.contact_state
advance = _OWN.advance
