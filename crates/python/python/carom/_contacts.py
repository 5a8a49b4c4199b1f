"""Many contacts with memory."""

from __future__ import annotations

from copy import copy
from typing import Self

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import Array, counted, line, numbers, spread
from ._carom import Hertz


class Contacts:
    """Many contacts of the same constants, advanced together: arrays of shifts in, arrays of loads out.

    `stiffness` is a Hertz contact or (c_x, c_y, c_z); `law` is 'coulomb', to a `tolerance` of the friction
    limit, or 'fixed-direction', one direction of traction in a slip ring: faster, exact on straight
    paths. With `directions=1` only xi moves, and the law is exact and fastest. With `threads` all cores
    help, to the same bits.

    >>> import carom, numpy as np
    >>> glass = carom.Material(70e9, 0.22)
    >>> hertz = carom.hertz_of_spheres(1e-3, 1e-3, glass)
    >>> contacts = carom.Contacts(1000, hertz, friction=0.4)
    >>> loads = contacts.advance(np.full(1000, 1e-7), xi=np.linspace(0, 1e-7, 1000))
    >>> loads.shape, bool((loads[:, 0] <= 0.4 * loads[:, 2] * (1 + 1e-12)).all())
    ((1000, 3), True)
    """

    def __init__(
        self,
        count: int,
        stiffness: Hertz | tuple[float, float, float],
        friction: float,
        *,
        law: str = "coulomb",
        tolerance: float = 1e-2,
        directions: int = 2,
        threads: bool = False,
    ) -> None:
        self._native = _carom.Contacts(
            counted("count", count), stiffness, friction, law, tolerance, directions, threads
        )
        self._directions = directions

    def __len__(self) -> int:
        return len(self._native)

    def advance(self, zeta: ArrayLike, xi: ArrayLike = 0.0, eta: ArrayLike | None = None) -> Array:
        """Goes straight to new shifts (m), one for each contact or one for all; returns the loads (n, 3), N.

        All go, or none.
        """

        def column(name: str, shift: ArrayLike) -> Array:
            return spread(name, shift, (len(self),)).reshape(-1, 1)

        across = None if eta is None else column("eta", eta)
        return self.follow(column("zeta", zeta), column("xi", xi), across)[:, 0]

    def follow(
        self,
        zeta: ArrayLike,
        xi: ArrayLike = 0.0,
        eta: ArrayLike | None = None,
        *,
        out: Array | None = None,
    ) -> Array:
        """Goes along paths, arrays (n, steps) of shifts (m); returns the loads (n, steps, 3), N.

        All go, or none. `out` is where to write the loads, if given.
        """
        told = {"zeta": zeta, "xi": xi} | ({} if eta is None else {"eta": eta})
        given = {name: numbers(name, v) for name, v in told.items()}
        lengths = (v.shape[-1] for v in given.values() if v.ndim)
        steps = next((length for length in lengths if length != 1), 1)
        shape = (len(self), steps)
        paths = [line(spread(name, v, shape)) for name, v in given.items()]
        loads = np.empty(shape + (3,)) if out is None else out
        fits = isinstance(loads, np.ndarray) and loads.shape == shape + (3,) and loads.dtype == np.float64
        if not fits or not loads.flags.carray:
            raise ValueError(f"out: must be a contiguous array of float64 of shape {shape + (3,)}")
        if any(np.may_share_memory(loads, way) for way in paths):
            raise ValueError("out: must not be the memory of the paths")
        self._native.follow(steps, paths[0], paths[1], paths[2] if eta is not None else None, loads.reshape(-1))
        return loads

    @property
    def loads(self) -> Array:
        """The present loads (F_x, F_y, F_z), N, an array (n, 3)."""
        return self._native.loads

    @property
    def stored_energy(self) -> Array:
        """The elastic energy of each contact, compression included, J."""
        return self._native.stored_energy

    def __copy__(self) -> Self:
        other = object.__new__(type(self))
        other._native, other._directions = copy(self._native), self._directions
        return other

    def __repr__(self) -> str:
        return f"Contacts({len(self)}, directions={self._directions})"
