"""Many contacts with memory."""

from __future__ import annotations

from copy import copy
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from . import _carom, _show
from ._arrays import counted, line, number, numbers, spread
from ._quantities import bare
from ._carom import Hertz
from ._types import Array

if TYPE_CHECKING:
    from typing_extensions import Self

UNITS = {"zeta": "m", "xi": "m", "eta": "m", "omega": "rad"}


class Contacts:
    """Many contacts with the same constants, advanced together: arrays of shifts in, arrays of loads out.

    `stiffness` is a Hertz contact or (c_x, c_y, c_z), N/m^1.5. `law` is 'coulomb', to a `tolerance` of the
    friction limit, by default 1e-2, or 'fixed-direction', with one direction of traction in a slip annulus: faster, and
    exact on straight paths. `directions=1` allows only xi; the law is then exact and fastest. `threads`
    uses all cores and gives the same bits. With a `static_friction` above `friction` a contact sticks or slips in
    part up to f_s F_z, and slides as a whole with f_k = `friction`; not for law 'rings'.

    These laws neglect the coupling of dissimilar materials, which may change R_x of an impact by
    `coupling_bound`, and do not take a twist. `law='rings'` includes both, for circular Hertz contacts; a
    step takes some microseconds.

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
        tolerance: float | None = None,
        static_friction: float | None = None,
        directions: int = 2,
        threads: bool = False,
    ) -> None:
        ways = counted("directions", directions)
        self._native = _carom.Contacts(
            counted("count", count), stiffness, friction, law, tolerance, static_friction, ways, threads
        )
        self._about = (stiffness, number("friction", friction), law, ways)

    def __len__(self) -> int:
        return len(self._native)

    def advance(
        self,
        zeta: ArrayLike,
        xi: ArrayLike = 0.0,
        eta: ArrayLike | None = None,
        omega: ArrayLike | None = None,
    ) -> Array:
        """Moves to new shifts (m), one for each contact or one for all; returns the loads (n, 3), N.

        If one shift is out of range, no contact is advanced. `omega` is the twist about the normal
        (radians), for law 'rings' only; the loads are then (F_x, F_y, F_z, M_z), an array (n, 4).
        """

        def column(name: str, shift: ArrayLike) -> Array:
            return spread(name, shift, (len(self),), UNITS[name]).reshape(-1, 1)

        across = None if eta is None else column("eta", eta)
        twist = None if omega is None else column("omega", omega)
        return self._follow(column("zeta", zeta), column("xi", xi), across, twist, None)[:, 0]

    def follow(
        self,
        zeta: ArrayLike,
        xi: ArrayLike = 0.0,
        eta: ArrayLike | None = None,
        omega: ArrayLike | None = None,
        *,
        out: Array | None = None,
    ) -> Array:
        """Moves along paths, arrays (n, steps) of shifts (m); returns the loads (n, steps, 3), N.

        If one shift is out of range, no contact is advanced. The loads are written into `out`, if given.
        With `omega`, for law 'rings' only, they include M_z after the forces: (n, steps, 4).
        """
        return self._follow(zeta, xi, eta, omega, out)

    def _follow(
        self, zeta: ArrayLike, xi: ArrayLike, eta: ArrayLike | None, omega: ArrayLike | None, out: Array | None
    ) -> Array:
        """Moves along paths, one function below the call of the user, to which warnings point."""
        told = {"zeta": zeta, "xi": xi} | {
            name: shift for name, shift in (("eta", eta), ("omega", omega)) if shift is not None
        }
        given = {name: numbers(name, v, UNITS[name]) for name, v in told.items()}
        lengths = (v.shape[-1] for v in given.values() if v.ndim)
        steps = next((length for length in lengths if length != 1), 1)
        shape = (len(self), steps)
        for name, v in given.items():
            if v.ndim == 2 and v.shape[0] not in (1, len(self)):
                turned = "; transpose it" if v.shape[1] == len(self) else ""
                raise ValueError(f"{name} has the shape {v.shape}: must be ({len(self)}, steps){turned}")
        paths = {name: line(spread(name, v, shape)) for name, v in given.items()}
        whole = shape + (3 if omega is None else 4,)
        loads = np.empty(whole) if out is None else out
        fits = isinstance(loads, np.ndarray) and bare("out", loads, "N") is loads and loads.shape == whole and loads.dtype == np.float64
        if not fits or not loads.flags.carray:
            raise ValueError(f"out: must be a contiguous array of float64 of shape {whole}")
        if any(np.may_share_memory(loads, way) for way in paths.values()):
            raise ValueError("out: must not share memory with the paths")
        across, twist = paths.get("eta"), paths.get("omega")
        self._native.follow(steps, paths["zeta"], paths["xi"], across, twist, loads.reshape(-1))
        return loads

    @property
    def loads(self) -> Array:
        """The present loads (F_x, F_y, F_z), N, an array (n, 3)."""
        return self._native.loads

    @property
    def torques(self) -> Array:
        """The present torques about the normal M_z, N m, an array (n,); nonzero for law 'rings' only."""
        return self._native.torques

    @property
    def coupling_bound(self) -> float | None:
        """Upper bound of the change of R_x by the coupling of dissimilar materials, which the law neglects.

        0 for like materials and for law 'rings'; None for unknown materials.
        """
        return self._native.coupling_bound

    @property
    def stored_energy(self) -> Array:
        """The elastic energy of each contact, compression included, J."""
        return self._native.stored_energy

    def __copy__(self) -> Self:
        other = object.__new__(type(self))
        other._native, other._about = copy(self._native), self._about
        return other

    def _rows(self) -> list[_show.Row]:
        stiffness, friction, law, directions = self._about
        return [
            ("count", str(len(self)), "", "number of contacts"),
            ("stiffness", _show.short(repr(stiffness)), "" if isinstance(stiffness, Hertz) else "N/m^1.5", ""),
            ("friction", _show.number(friction), "", ""),
            ("law", law, "", ""),
            ("directions", str(directions), "", "of the shift"),
            ("loads", _show.short(self.loads), "N", "F_x, F_y, F_z of each"),
        ]

    def __repr__(self) -> str:
        return _show.text("Contacts", self._rows())

    def _repr_html_(self) -> str:
        return _show.html("Contacts", self._rows())
