"""Closed-form results: Hertz contacts, stresses below a contact, Lubkin's twist, R_x of an impact."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import Any, Literal, overload

import numpy as np
from numpy.typing import ArrayLike

from . import _carom
from ._arrays import line, number, numbers, over
from ._carom import Hertz, Material, MaterialPair
from ._records import DissimilarRestitution, DissimilarRestitutions, HertzState, HertzStates, LineState, LineStates
from ._types import Array, Number, Numbers, Several, of_one
from ._validity import warn

Given = Literal["force", "approach", "semi_axis_a", "semi_axis_b", "peak_pressure"]
LineGiven = Literal["force", "approach", "half_width", "peak_pressure"]


def hertz_of_spheres(
    radius_1: float, radius_2: float, material_1: Material, material_2: Material | None = None
) -> Hertz:
    """The Hertz contact of two spheres, radii in m; infinite for a plane, negative for a spherical cavity.

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> contact = carom.hertz_of_spheres(0.01, float("inf"), steel)
    >>> contact.axis_ratio
    1.0
    """
    pair = MaterialPair(material_1, material_2)
    radius_1, radius_2 = number("radius_1", radius_1, "m"), number("radius_2", radius_2, "m")
    return Hertz.of_radii(pair, (radius_1, radius_1), (radius_2, radius_2), 0.0)


@overload
def hertz(
    contact: Hertz,
    *,
    force: Number | None = None,
    approach: Number | None = None,
    semi_axis_a: Number | None = None,
    semi_axis_b: Number | None = None,
    peak_pressure: Number | None = None,
) -> HertzState: ...
@overload
def hertz(
    contact: Hertz,
    *,
    force: Several | None = None,
    approach: Several | None = None,
    semi_axis_a: Several | None = None,
    semi_axis_b: Several | None = None,
    peak_pressure: Several | None = None,
) -> HertzStates: ...
def hertz(
    contact: Hertz,
    *,
    force: ArrayLike | None = None,
    approach: ArrayLike | None = None,
    semi_axis_a: ArrayLike | None = None,
    semi_axis_b: ArrayLike | None = None,
    peak_pressure: ArrayLike | None = None,
) -> HertzState | HertzStates:
    """A Hertz contact under load. Exactly one of force (N), approach and the semi-axes (m), peak pressure (Pa) is given.

    >>> import carom
    >>> steel = carom.Material(208e9, 0.3)
    >>> contact = carom.hertz_of_spheres(0.01, float("inf"), steel)
    >>> state = carom.hertz(contact, force=[10.0, 80.0])
    >>> float(state.semi_axis_a[1] / state.semi_axis_a[0])  # a is proportional to the cube root of the force
    2.0
    """
    if not isinstance(contact, Hertz):
        way_out = "hertz_of_spheres, Hertz.of_radii or hertz_of_bodies makes one"
        raise TypeError(f"contact: must be a Hertz, not {type(contact).__name__}: {way_out}")
    names: tuple[Given, ...] = ("force", "approach", "semi_axis_a", "semi_axis_b", "peak_pressure")
    all_ = zip(names, (force, approach, semi_axis_a, semi_axis_b, peak_pressure), strict=True)
    given = [(name, values) for name, values in all_ if values is not None]
    if len(given) != 1:
        raise TypeError("hertz() takes one of force, approach, semi_axis_a, semi_axis_b, peak_pressure")
    ((name, values),) = given
    plain = numbers(name, values, HertzState.units[name])
    columns, exceeded = contact._state(name, line(plain))
    warn(exceeded)
    return HertzStates._either(columns, plain.shape)  # type: ignore[no-any-return]


@overload
def line_contact(
    materials: MaterialPair | Material,
    radius: Number,
    length: Number,
    *,
    force: Number | None = None,
    approach: Number | None = None,
    half_width: Number | None = None,
    peak_pressure: Number | None = None,
) -> LineState: ...
@overload
def line_contact(
    materials: MaterialPair | Material,
    radius: Number,
    length: Number,
    *,
    force: Several | None = None,
    approach: Several | None = None,
    half_width: Several | None = None,
    peak_pressure: Several | None = None,
) -> LineStates: ...
def line_contact(
    materials: MaterialPair | Material,
    radius: Number,
    length: Number,
    *,
    force: ArrayLike | None = None,
    approach: ArrayLike | None = None,
    half_width: ArrayLike | None = None,
    peak_pressure: ArrayLike | None = None,
) -> LineState | LineStates:
    """Two cylinders with parallel axes (or a cylinder and a plane) that touch along `length`, m. `radius` is the relative
    one, 1/R = 1/R_1 + 1/R_2, m. Exactly one of force (N), approach and half_width (m), peak_pressure (Pa) is given.

    The approach is that of half-spaces loaded along the length, in its middle: it grows with ln(length).

    >>> import carom, math
    >>> roller = carom.line_contact(carom.Material(208e9, 0.3), 5e-3, 20e-3, force=1e3)
    >>> math.isclose(roller.force, math.pi / 2 * roller.half_width * roller.peak_pressure * 20e-3)
    True
    """
    names: tuple[LineGiven, ...] = ("force", "approach", "half_width", "peak_pressure")
    all_ = zip(names, (force, approach, half_width, peak_pressure), strict=True)
    given = [(name, values) for name, values in all_ if values is not None]
    if len(given) != 1:
        raise TypeError("line_contact() takes one of force, approach, half_width, peak_pressure")
    ((name, values),) = given
    plain = numbers(name, values, LineState.units[name])
    pair = MaterialPair(materials) if isinstance(materials, Material) else materials
    radius, length = number("radius", radius, "m"), number("length", length, "m")
    columns, exceeded = _carom.line_state(pair, radius, length, name, line(plain))
    warn(exceeded)
    return LineStates._either(columns, plain.shape)  # type: ignore[no-any-return]


@overload
def restitution(
    kappa: Number,
    lam: Number,
    *,
    gamma: Number | None = None,
    friction: Number | None = None,
    mobility_ratio: Number | None = None,
    normal_restitution: Number = 1.0,
    exact: bool = False,
) -> float: ...
@overload
def restitution(
    kappa: Several,
    lam: ArrayLike,
    *,
    gamma: ArrayLike | None = None,
    friction: ArrayLike | None = None,
    mobility_ratio: ArrayLike | None = None,
    normal_restitution: ArrayLike = 1.0,
    exact: bool = False,
) -> Array: ...
@overload
def restitution(
    kappa: ArrayLike,
    lam: Several,
    *,
    gamma: ArrayLike | None = None,
    friction: ArrayLike | None = None,
    mobility_ratio: ArrayLike | None = None,
    normal_restitution: ArrayLike = 1.0,
    exact: bool = False,
) -> Array: ...
@overload
def restitution(
    kappa: ArrayLike,
    lam: ArrayLike,
    *,
    gamma: ArrayLike | None = None,
    friction: ArrayLike | None = None,
    mobility_ratio: ArrayLike | None = None,
    normal_restitution: ArrayLike = 1.0,
    exact: bool = False,
) -> Numbers: ...
def restitution(
    kappa: ArrayLike,
    lam: ArrayLike,
    *,
    gamma: ArrayLike | None = None,
    friction: ArrayLike | None = None,
    mobility_ratio: ArrayLike | None = None,
    normal_restitution: ArrayLike = 1.0,
    exact: bool = False,
) -> Numbers:
    """R_x of solid spheres, the tangential velocity after the impact over that before, reversed.

    `kappa` = (2 - nu)/(2 (1 - nu)), in (0.75, 1.5], is `MaterialPair.kappa`; `lam` >= 0 is the tangential
    velocity of the contact over f times the normal one. From a table within 1e-8, or exact.

    Of dissimilar materials give `gamma`, which is `MaterialPair.gamma`, and `friction`: R_x is then that of
    `restitution_of_dissimilar`, where gamma = 0 the same bits as without them.

    A `normal_restitution` e below 1 is that of a viscous material: R_x from a table within 3e-3, 4e-5 in the mean, or
    exact within 1e-5.

    >>> restitution(1.0, 7.0)
    0.0
    >>> round(restitution(1.2, 2.0, normal_restitution=0.5, exact=True), 4)
    0.1556
    >>> restitution([[1.0], [1.2]], [1.0, 4.0, 9.0]).shape
    (2, 3)
    >>> thrown_back = restitution(1.2, 1.0, gamma=0.3, friction=0.1)
    >>> restitution(1.2, 1.0) < 0 < thrown_back
    True
    """
    if gamma is not None and np.any(np.not_equal(normal_restitution, 1.0)):
        raise ValueError("normal_restitution: is that of like materials, without gamma")
    if gamma is not None and friction is not None:
        ratio = 3.5 if mobility_ratio is None else mobility_ratio
        return restitution_of_dissimilar(kappa, lam, gamma, friction, mobility_ratio=ratio, exact=exact).R_x
    if not (gamma is None and friction is None and mobility_ratio is None):
        raise TypeError("restitution() takes gamma and friction together, and mobility_ratio with them")
    own = partial(_carom.restitution, exact=exact)
    return over(own, kappa=kappa, lam=lam, normal_restitution=normal_restitution)


@overload
def restitution_of_dissimilar(
    kappa: Number,
    lam: Number,
    gamma: Number,
    friction: Number,
    *,
    mobility_ratio: Number = 3.5,
    exact: bool = False,
) -> DissimilarRestitution: ...
@overload
def restitution_of_dissimilar(
    kappa: ArrayLike,
    lam: Several,
    gamma: ArrayLike,
    friction: ArrayLike,
    *,
    mobility_ratio: ArrayLike = 3.5,
    exact: bool = False,
) -> DissimilarRestitutions: ...
@overload
def restitution_of_dissimilar(
    kappa: ArrayLike,
    lam: ArrayLike,
    gamma: ArrayLike,
    friction: ArrayLike,
    *,
    mobility_ratio: ArrayLike = 3.5,
    exact: bool = False,
) -> DissimilarRestitution | DissimilarRestitutions: ...
def restitution_of_dissimilar(
    kappa: ArrayLike,
    lam: ArrayLike,
    gamma: ArrayLike,
    friction: ArrayLike,
    *,
    mobility_ratio: ArrayLike = 3.5,
    exact: bool = False,
) -> DissimilarRestitution | DissimilarRestitutions:
    """R_x of spheres of dissimilar materials without spin about the normal, how it was found, and its estimated error.

    `gamma`, of either sign, at most 3/2 - kappa, is `MaterialPair.gamma`; `friction` is f, from 0 to infinity.
    `mobility_ratio`, in (0, 75], is D_xx/D_zz: 3.5 of solid spheres, 2.5 of hollow ones; `kappa` and `lam` are those
    of `restitution`, `lam` 0 where friction is infinite. `method` is 'table', in half a microsecond for kappa from 1,
    lam to 8, f to 1, |gamma|/f to 12 and mobility_ratio from 1 to 6; elsewhere, and if `exact`, 'rings', some milliseconds
    each; 'uncoupled' is the exact impact of alike materials, 'frictionless' R_x = -1.

    >>> import carom
    >>> pair = carom.MaterialPair(carom.RIGID, carom.Material(70e9, 0.22))
    >>> found = restitution_of_dissimilar(pair.kappa, [1.0, 10.0], pair.gamma, 0.1)
    >>> found.method
    ['table', 'rings']
    >>> bool(found.error_estimate.max() < 0.02)
    True
    """
    names = ("kappa", "lam", "gamma", "friction", "mobility_ratio")
    given = zip(names, (kappa, lam, gamma, friction, mobility_ratio), strict=True)
    arrays = np.broadcast_arrays(*(numbers(name, values) for name, values in given))
    columns = _carom.restitution_of_dissimilar([line(values) for values in arrays], exact)
    return DissimilarRestitutions._either(columns, arrays[0].shape)  # type: ignore[no-any-return]


@overload
def restitution_of_groups(
    chi: Number, psi: Number, *, normal_restitution: ArrayLike = 1.0, exact: bool = False
) -> float: ...
@overload
def restitution_of_groups(
    chi: Several, psi: ArrayLike, *, normal_restitution: ArrayLike = 1.0, exact: bool = False
) -> Array: ...
@overload
def restitution_of_groups(
    chi: ArrayLike, psi: Several, *, normal_restitution: ArrayLike = 1.0, exact: bool = False
) -> Array: ...
@overload
def restitution_of_groups(
    chi: ArrayLike, psi: ArrayLike, *, normal_restitution: ArrayLike = 1.0, exact: bool = False
) -> Numbers: ...
def restitution_of_groups(
    chi: ArrayLike, psi: ArrayLike, *, normal_restitution: ArrayLike = 1.0, exact: bool = False
) -> Numbers:
    """R_x of any bodies whose normal and tangential motions are uncoupled, by chi and psi.

    `chi` = D_xx c_x/(D_zz c_z), in (0, 100], with the mobilities D (velocity per impulse at the contact point)
    and `Hertz.stiffness`; `psi` = c_x/(f c_z) times the tangential over the normal velocity, >= 0. Solid
    spheres have chi = 3.5/kappa and psi = lambda/kappa. `normal_restitution` as in `restitution`.

    >>> round(restitution_of_groups(3.5 / 1.2, 2.0 / 1.2) - restitution(1.2, 2.0), 7)
    0.0
    """
    own = partial(_carom.restitution_of_groups, exact=exact)
    return over(own, chi=chi, psi=psi, normal_restitution=normal_restitution)


@of_one
def lubkin_torque(twist: ArrayLike) -> Numbers:
    """The torque of a circular contact that is twisted for the first time, as M_z/(f F_z a).

    `twist` is G a^2 Omega/(f F_z), from 0 to below 160, with `MaterialPair.shear_modulus`. The torque is 16/3 of
    a small twist, and 3 pi/16 for complete sliding.
    """
    return over(partial(_carom.lubkin, "torque"), twist=twist)


@of_one
def lubkin_stick_radius(twist: ArrayLike) -> Numbers:
    """The stick radius over the contact radius of a circular contact twisted as in `lubkin_torque`."""
    return over(partial(_carom.lubkin, "stick_radius"), twist=twist)


def stress(
    semi_axes: tuple[float, float],
    material: Material,
    pressure: float,
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    *,
    traction: tuple[float, float] = (0.0, 0.0),
    stick_radius: float = 0.0,
) -> Array:
    """The stress in a body under a Hertz contact, (xx, yy, zz, xy, yz, zx) along the last axis, Pa.

    `pressure` is the normal pressure at the centre of the ellipse, `traction` the friction limit there, in
    the direction of slip. `stick_radius`, from 0 to 1, is the relative size of the stick area. z >= 0
    points into the body.

    >>> import carom, numpy as np
    >>> steel = carom.Material(208e9, 0.3)
    >>> s = carom.stress((1e-3, 1e-3), steel, 1.0, 0.0, 0.0, np.linspace(0, 2e-3, 201))
    >>> shear = 0.5 * np.abs(s[:, 2] - s[:, 0])
    >>> round(float(shear.max()), 2), int(shear.argmax())  # 0.31 of the pressure, 0.48 a deep
    (0.31, 48)
    """
    arrays = np.broadcast_arrays(*(numbers(n, v, "m") for n, v in zip("xyz", (x, y, z), strict=True)))
    points = [line(v) for v in arrays]
    values, exceeded = _carom.stress(semi_axes, material, pressure, traction, stick_radius, *points)
    warn(exceeded)
    return values.reshape(arrays[0].shape + (6,))


@overload
def von_mises(stress: Sequence[float]) -> float: ...
@overload
def von_mises(stress: ArrayLike) -> Any: ...
def von_mises(stress: ArrayLike) -> Numbers:
    """Von Mises' equivalent stress of stresses (xx, yy, zz, xy, yz, zx) along the last axis.

    >>> von_mises([3.0, 0, 0, 0, 0, 0])
    3.0
    """
    parts = numbers("stress", stress, "Pa")
    if parts.shape[-1:] != (6,):
        raise ValueError(f"stress has the shape {parts.shape}: must be six numbers along the last axis")
    xx, yy, zz, xy, yz, zx = np.moveaxis(parts, -1, 0)
    normal = (xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2
    value = np.sqrt(0.5 * normal + 3.0 * (xy**2 + yz**2 + zx**2))
    return value if value.ndim else float(value)
