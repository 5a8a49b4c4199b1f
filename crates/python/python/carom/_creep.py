"""Kalker's creep coefficients, and the forces of FASTSIM with them."""

from __future__ import annotations

from typing import overload

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import alike, counts, line, numbers
from ._carom import Hertz
from ._records import CreepForce, CreepForces, FastsimForce, FastsimForces, LinearCreep, LinearCreeps
from ._types import Number, Several
from ._validity import warn


@overload
def creep_coefficients(axis_ratio: Number, poisson: Number) -> LinearCreep: ...
@overload
def creep_coefficients(axis_ratio: Several, poisson: ArrayLike) -> LinearCreeps: ...
@overload
def creep_coefficients(axis_ratio: ArrayLike, poisson: Several) -> LinearCreeps: ...
@overload
def creep_coefficients(axis_ratio: ArrayLike, poisson: ArrayLike) -> LinearCreep | LinearCreeps: ...
def creep_coefficients(axis_ratio: ArrayLike, poisson: ArrayLike) -> LinearCreep | LinearCreeps:
    """Kalker's creep coefficients: forces at small creepage of two equal bodies that roll on each other.

    `axis_ratio` is a/b of the contact ellipse, from 0.05 to 20, with a along the direction of rolling x; `poisson` that of
    both bodies, from 0 to 0.5. With the shear modulus G of each body, and creepages and loads as in `roll`,

        F_x = G a b C11 creepage
        F_y = G a b C22 creepage_across - G (a b)^1.5 C23 spin
        M_z = G (a b)^1.5 C32 creepage_across + G (a b)^2 C33 spin

    All are positive and C32 = C23; Kalker, who counts spin the other way round, writes C32 = -C23. The coefficients of b/a
    do not follow from those of a/b. They come from a table, in a microsecond, with errors of some 0.05 %, for
    a/b above 5 0.1 %; C33 0.2 %, for a/b above 3 0.4 %, above 10 up to 1 %.

    >>> import carom
    >>> circle = carom.creep_coefficients(1.0, 0.25)
    >>> round(circle.C11, 2), round(circle.C22, 2), round(circle.C23, 2)  # Kalker's table: 4.12, 3.67, 1.47
    (4.11, 3.67, 1.47)
    >>> carom.creep_coefficients([[0.5], [1.0], [2.0]], [0.25, 0.3]).C11.round(2)
    array([[3.63, 3.82],
           [4.11, 4.29],
           [5.1 , 5.27]])
    """
    given = {"axis_ratio": numbers("axis_ratio", axis_ratio), "poisson": numbers("poisson", poisson)}
    ratios, poissons = alike(given)
    columns = _carom.creep_coefficients(line(ratios), line(poissons))
    return LinearCreeps._either(columns, ratios.shape)  # type: ignore[no-any-return]


@overload
def fastsim(
    contact: Hertz,
    friction: Number,
    *,
    F_z: Number,
    creepage: Number = 0.0,
    creepage_across: Number = 0.0,
    spin: Number = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForce: ...
@overload
def fastsim(
    contact: Hertz,
    friction: Several,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForces: ...
@overload
def fastsim(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: Several,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForces: ...
@overload
def fastsim(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: Several,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForces: ...
@overload
def fastsim(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: Several,
    spin: ArrayLike = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForces: ...
@overload
def fastsim(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: Several,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForces: ...
@overload
def fastsim(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForce | FastsimForces: ...
def fastsim(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
    mesh: tuple[int, int] = (100, 100),
) -> FastsimForce | FastsimForces:
    """Creep forces by FASTSIM, Kalker's simplified theory: a tenth of a millisecond for what `roll` solves in seconds.

    Each particle has springs of its own, as stiff as Kalker's creep coefficients ask, and the friction limit is a parabola.
    So forces are right for small creepage. In full sliding their sum is f F_z, yet its direction is that of
    (creepage C11, creepage_across C22), up to 7 degrees from the slip. Measured against the exact theory, which `roll` computes,
    for nu = 0.25, a/b from 0.29 to 3.5 and creepage in any direction, over f F_z: up to 0.09 without spin (0.05 along x or y);
    with spin F_y is off by up to 0.18, and in contacts with a < b by up to 0.2.

    The Hertz contact rolls along x, under the normal force `F_z`. Make it by its gap, `Hertz(materials, A, B)` with A along x:
    `Hertz.of_radii` takes the direction of the greatest curvature for x. `creepage`, `creepage_across` and `spin` (rad/m) are those
    of `roll`, of body 2 against body 1; forces are on body 1. Numbers or arrays, which are broadcast. `mesh` is the number of
    strips along x and of elements in each. a/b must be from 0.05 to 20. Materials enter by their combined G and Poisson's
    ratio; the coupling of dissimilar ones is left out.

    Adhesion curves, force over creepage by both, of a steel ball on a plate:

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> contact = carom.hertz_of_spheres(0.01, float("inf"), steel)
    >>> creepage = np.linspace(0, 4e-3, 9)
    >>> springs = carom.fastsim(contact, 0.3, F_z=10.0, creepage=creepage)
    >>> x, y = carom.cells((40, 40), size=(3e-4, 3e-4))
    >>> exact = carom.roll((x**2 + y**2) / 0.02, (3e-4, 3e-4), contact.materials, 0.3, F_z=10.0, creepage=creepage)
    >>> bool(np.abs(springs.F_x - exact.rows.F_x).max() < 0.05 * 0.3 * 10.0)
    True
    >>> from matplotlib import pyplot  # doctest: +SKIP
    >>> for name, forces in {"FASTSIM": springs.F_x, "solver": exact.rows.F_x}.items():  # doctest: +SKIP
    ...     pyplot.plot(creepage, forces, label=name)
    """
    names = ("friction", "F_z", "creepage", "creepage_across", "spin")
    values = (friction, F_z, creepage, creepage_across, spin)
    units = ("", "N", "", "", "rad/m")
    arrays = alike({one[0]: numbers(*one) for one in zip(names, values, units, strict=True)})
    pair = counts("mesh", mesh, "two numbers")
    columns, exceeded = _carom.fastsim(contact, [line(array) for array in arrays], pair)
    warn(exceeded)
    return FastsimForces._either(columns, arrays[0].shape)  # type: ignore[no-any-return]


@overload
def creep_force(
    contact: Hertz,
    friction: Number,
    *,
    F_z: Number,
    creepage: Number = 0.0,
    creepage_across: Number = 0.0,
    spin: Number = 0.0,
) -> CreepForce: ...
@overload
def creep_force(
    contact: Hertz,
    friction: Several,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
) -> CreepForces: ...
@overload
def creep_force(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: Several,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
) -> CreepForces: ...
@overload
def creep_force(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: Several,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
) -> CreepForces: ...
@overload
def creep_force(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: Several,
    spin: ArrayLike = 0.0,
) -> CreepForces: ...
@overload
def creep_force(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: Several,
) -> CreepForces: ...
@overload
def creep_force(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
) -> CreepForce | CreepForces: ...
def creep_force(
    contact: Hertz,
    friction: ArrayLike,
    *,
    F_z: ArrayLike,
    creepage: ArrayLike = 0.0,
    creepage_across: ArrayLike = 0.0,
    spin: ArrayLike = 0.0,
) -> CreepForce | CreepForces:
    """Forces of steady rolling by a table of solutions, in microseconds, for two bodies of like materials.

    `contact` rolls along x, its semi-axis a; a/b from 0.1 to 10. Arguments and loads are those of `fastsim`; arrays are
    broadcast. `error` says how far F_x and F_y may be off the continuum (M_z by sqrt(ab) times as much). `roll` solves the
    contact itself.

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> wheel = carom.Hertz.of_radii(carom.MaterialPair(steel), (0.46, float("inf")), (float("inf"), 0.3), 0.0)
    >>> forces = carom.creep_force(wheel, 0.3, F_z=80e3, creepage=[1e-4, 1e-3, 1e-2])
    >>> bool((abs(forces.F_x) <= 0.3 * 80e3).all()), len(forces)
    (True, 3)
    """
    names = ("friction", "F_z", "creepage", "creepage_across", "spin")
    units = ("", "N", "", "", "rad/m")
    given = zip(names, (friction, F_z, creepage, creepage_across, spin), units, strict=True)
    arrays = alike({name: numbers(name, values, unit) for name, values, unit in given})
    columns, exceeded = _carom.creep_force(contact, [line(values) for values in arrays])
    warn(exceeded)
    return CreepForces._either(columns, arrays[0].shape)  # type: ignore[no-any-return]
