"""Results. Made by `carom._make_records`; not to be edited."""

from __future__ import annotations

from dataclasses import dataclass

from ._arrays import Array, Numbers
from ._record import Record


@dataclass(frozen=True, eq=False)
class DissimilarRestitution(Record):
    """R_x of spheres of dissimilar materials.

    R_x             tangential restitution
    method          how it was found
    error_estimate  how far R_x may be off
    """

    R_x: Numbers
    method: str | list[str]
    error_estimate: Numbers


DissimilarRestitution.units = {'R_x': '', 'method': '', 'error_estimate': ''}
DissimilarRestitution.meanings = {'R_x': 'tangential restitution', 'method': 'how it was found', 'error_estimate': 'how far R_x may be off'}
DissimilarRestitution._vectors = frozenset([])


@dataclass(frozen=True, eq=False)
class HertzState(Record):
    """A Hertz contact under load.

    force             normal force F_z, N
    approach          of distant points, zeta, m
    semi_axis_a       of the contact ellipse along x, m
    semi_axis_b       of the contact ellipse along y, m
    peak_pressure     in the middle of the contact, Pa
    normal_stiffness  tangent dF_z/dzeta, N/m
    """

    force: Numbers
    approach: Numbers
    semi_axis_a: Numbers
    semi_axis_b: Numbers
    peak_pressure: Numbers
    normal_stiffness: Numbers


HertzState.units = {'force': 'N', 'approach': 'm', 'semi_axis_a': 'm', 'semi_axis_b': 'm', 'peak_pressure': 'Pa', 'normal_stiffness': 'N/m'}
HertzState.meanings = {'force': 'normal force F_z', 'approach': 'of distant points, zeta', 'semi_axis_a': 'of the contact ellipse along x', 'semi_axis_b': 'of the contact ellipse along y', 'peak_pressure': 'in the middle of the contact', 'normal_stiffness': 'tangent dF_z/dzeta'}
HertzState._vectors = frozenset([])


@dataclass(frozen=True, eq=False)
class HistoryPoint(Record):
    """Instants of an impact, in contact axes.

    time          since touch, s
    xi            shift of body 2 against body 1 along x, m
    eta           the same along y, m
    zeta          approach, m
    v             rate of xi, eta, zeta, m/s
    F             force on body 1, N
    semi_axis_a   of the contact along x, m
    semi_axis_b   of the contact along y, m
    stick_radius  of the stick area of spheres, m
    regime        sign: traction on body 1 along the first slip
    """

    time: Numbers
    xi: Numbers
    eta: Numbers
    zeta: Numbers
    v: Array
    F: Array
    semi_axis_a: Numbers
    semi_axis_b: Numbers
    stick_radius: Numbers
    regime: str | list[str]


HistoryPoint.units = {'time': 's', 'xi': 'm', 'eta': 'm', 'zeta': 'm', 'v': 'm/s', 'F': 'N', 'semi_axis_a': 'm', 'semi_axis_b': 'm', 'stick_radius': 'm', 'regime': ''}
HistoryPoint.meanings = {'time': 'since touch', 'xi': 'shift of body 2 against body 1 along x', 'eta': 'the same along y', 'zeta': 'approach', 'v': 'rate of xi, eta, zeta', 'F': 'force on body 1', 'semi_axis_a': 'of the contact along x', 'semi_axis_b': 'of the contact along y', 'stick_radius': 'of the stick area of spheres', 'regime': 'sign: traction on body 1 along the first slip'}
HistoryPoint._vectors = frozenset(['v', 'F'])


@dataclass(frozen=True, eq=False)
class HistoryStep(Record):
    """A contact after the steps of a history case. SI units; loads act on body 1.

    step                     number of the step, from 1
    zeta                     approach, m
    xi                       shift of body 2 against body 1 along x, m
    eta                      the same along y, m
    F_x                      force on body 1 along x, N
    F_y                      the same along y, N
    F_z                      normal force, N
    regime                   what the step did
    semi_axis_a              of the contact ellipse along x, m
    semi_axis_b              the same along y, m
    stick_semi_axis_a        of the stick area along x, m
    stick_semi_axis_b        the same along y, m
    stored_energy            elastic energy of the contact, J
    dissipated               friction heat since the start, J
    omega                    twist about the normal, rad
    M_z                      torque on body 1, N m
    twist_regime             what the twist does
    twist_stick_semi_axis_a  of the twist's stick area along x, m
    twist_stick_semi_axis_b  the same along y, m
    """

    step: Numbers
    zeta: Numbers
    xi: Numbers
    eta: Numbers
    F_x: Numbers
    F_y: Numbers
    F_z: Numbers
    regime: str | list[str]
    semi_axis_a: Numbers
    semi_axis_b: Numbers
    stick_semi_axis_a: Numbers
    stick_semi_axis_b: Numbers
    stored_energy: Numbers
    dissipated: Numbers
    omega: Numbers
    M_z: Numbers
    twist_regime: str | list[str]
    twist_stick_semi_axis_a: Numbers
    twist_stick_semi_axis_b: Numbers


HistoryStep.units = {'step': '', 'zeta': 'm', 'xi': 'm', 'eta': 'm', 'F_x': 'N', 'F_y': 'N', 'F_z': 'N', 'regime': '', 'semi_axis_a': 'm', 'semi_axis_b': 'm', 'stick_semi_axis_a': 'm', 'stick_semi_axis_b': 'm', 'stored_energy': 'J', 'dissipated': 'J', 'omega': 'rad', 'M_z': 'N m', 'twist_regime': '', 'twist_stick_semi_axis_a': 'm', 'twist_stick_semi_axis_b': 'm'}
HistoryStep.meanings = {'step': 'number of the step, from 1', 'zeta': 'approach', 'xi': 'shift of body 2 against body 1 along x', 'eta': 'the same along y', 'F_x': 'force on body 1 along x', 'F_y': 'the same along y', 'F_z': 'normal force', 'regime': 'what the step did', 'semi_axis_a': 'of the contact ellipse along x', 'semi_axis_b': 'the same along y', 'stick_semi_axis_a': 'of the stick area along x', 'stick_semi_axis_b': 'the same along y', 'stored_energy': 'elastic energy of the contact', 'dissipated': 'friction heat since the start', 'omega': 'twist about the normal', 'M_z': 'torque on body 1', 'twist_regime': 'what the twist does', 'twist_stick_semi_axis_a': "of the twist's stick area along x", 'twist_stick_semi_axis_b': 'the same along y'}
HistoryStep._vectors = frozenset([])


@dataclass(frozen=True, eq=False)
class SolverStep(Record):
    """A step of the numerical solver.

    step                 number of the step, from 1
    zeta                 approach, m
    xi                   shift of body 2 against body 1 along x, m
    eta                  the same along y, m
    omega                twist about the normal, rad
    F_x                  force on body 1 along x, N
    F_y                  the same along y, N
    F_z                  normal force, N
    M_z                  torque on body 1, N m
    p_max                greatest pressure, Pa
    contact_area         of all cells in contact, m2
    stick_area           of those that stick, m2
    stored_energy        elastic energy of both bodies, J
    dissipated           friction heat since the start, J
    residual_normal      what is left of the normal conditions
    residual_tangential  what is left of the friction law
    products_normal      products with the normal influence
    products_tangential  the same with the tangential one
    zeta_error           estimated error of zeta by the mesh, m
    xi_error             the same of xi, m
    eta_error            of eta, m
    omega_error          of omega, rad
    F_x_error            of F_x, N
    F_y_error            of F_y, N
    F_z_error            of F_z, N
    M_z_error            of M_z, N m
    p_max_error          of p_max, Pa
    contact_area_error   of contact_area, at most, m2
    stick_area_error     of stick_area, at most, m2
    """

    step: Numbers
    zeta: Numbers
    xi: Numbers
    eta: Numbers
    omega: Numbers
    F_x: Numbers
    F_y: Numbers
    F_z: Numbers
    M_z: Numbers
    p_max: Numbers
    contact_area: Numbers
    stick_area: Numbers
    stored_energy: Numbers
    dissipated: Numbers
    residual_normal: Numbers
    residual_tangential: Numbers
    products_normal: Numbers
    products_tangential: Numbers
    zeta_error: Numbers
    xi_error: Numbers
    eta_error: Numbers
    omega_error: Numbers
    F_x_error: Numbers
    F_y_error: Numbers
    F_z_error: Numbers
    M_z_error: Numbers
    p_max_error: Numbers
    contact_area_error: Numbers
    stick_area_error: Numbers


SolverStep.units = {'step': '', 'zeta': 'm', 'xi': 'm', 'eta': 'm', 'omega': 'rad', 'F_x': 'N', 'F_y': 'N', 'F_z': 'N', 'M_z': 'N m', 'p_max': 'Pa', 'contact_area': 'm2', 'stick_area': 'm2', 'stored_energy': 'J', 'dissipated': 'J', 'residual_normal': '', 'residual_tangential': '', 'products_normal': '', 'products_tangential': '', 'zeta_error': 'm', 'xi_error': 'm', 'eta_error': 'm', 'omega_error': 'rad', 'F_x_error': 'N', 'F_y_error': 'N', 'F_z_error': 'N', 'M_z_error': 'N m', 'p_max_error': 'Pa', 'contact_area_error': 'm2', 'stick_area_error': 'm2'}
SolverStep.meanings = {'step': 'number of the step, from 1', 'zeta': 'approach', 'xi': 'shift of body 2 against body 1 along x', 'eta': 'the same along y', 'omega': 'twist about the normal', 'F_x': 'force on body 1 along x', 'F_y': 'the same along y', 'F_z': 'normal force', 'M_z': 'torque on body 1', 'p_max': 'greatest pressure', 'contact_area': 'of all cells in contact', 'stick_area': 'of those that stick', 'stored_energy': 'elastic energy of both bodies', 'dissipated': 'friction heat since the start', 'residual_normal': 'what is left of the normal conditions', 'residual_tangential': 'what is left of the friction law', 'products_normal': 'products with the normal influence', 'products_tangential': 'the same with the tangential one', 'zeta_error': 'estimated error of zeta by the mesh', 'xi_error': 'the same of xi', 'eta_error': 'of eta', 'omega_error': 'of omega', 'F_x_error': 'of F_x', 'F_y_error': 'of F_y', 'F_z_error': 'of F_z', 'M_z_error': 'of M_z', 'p_max_error': 'of p_max', 'contact_area_error': 'of contact_area, at most', 'stick_area_error': 'of stick_area, at most'}
SolverStep._vectors = frozenset([])


@dataclass(frozen=True, eq=False)
class Rebound(Record):
    """How two bodies part. What only an impact has is not a number where they do not meet.

    outcome                  rebound, or no_impact
    R_x                      tangential restitution
    body_1_velocity          of the centre of mass, afterwards, m/s
    body_1_spin              angular velocity, afterwards, rad/s
    body_2_velocity          of the centre of mass, afterwards, m/s
    body_2_spin              angular velocity, afterwards, rad/s
    impulse                  on body 1, N s
    contact_velocity_before  of body 2 against body 1, m/s
    contact_velocity_after   of body 2 against body 1, m/s
    duration                 from touch to separation, s
    maximal_force            normal, N
    maximal_approach         of distant points, m
    maximal_semi_axis_a      of the contact along x, m
    maximal_semi_axis_b      of the contact along y, m
    energy_before            kinetic, without bodies held fast, J
    energy_after             kinetic, without bodies held fast, J
    energy_dissipated        by friction, J
    energy_lost              in the bodies' material, J
    regimes                  in order; sign: traction on body 1 along the first slip
    method                   how it was solved
    compressions             how often the approach grew
    error_estimate           of the contact velocity, over that before
    warnings                 what limits the validity
    """

    outcome: str | list[str]
    R_x: Numbers
    body_1_velocity: Array
    body_1_spin: Array
    body_2_velocity: Array
    body_2_spin: Array
    impulse: Array
    contact_velocity_before: Array
    contact_velocity_after: Array
    duration: Numbers
    maximal_force: Numbers
    maximal_approach: Numbers
    maximal_semi_axis_a: Numbers
    maximal_semi_axis_b: Numbers
    energy_before: Numbers
    energy_after: Numbers
    energy_dissipated: Numbers
    energy_lost: Numbers
    regimes: str | list[str]
    method: str | list[str]
    compressions: Numbers
    error_estimate: Numbers
    warnings: str | list[str]


Rebound.units = {'outcome': '', 'R_x': '', 'body_1_velocity': 'm/s', 'body_1_spin': 'rad/s', 'body_2_velocity': 'm/s', 'body_2_spin': 'rad/s', 'impulse': 'N s', 'contact_velocity_before': 'm/s', 'contact_velocity_after': 'm/s', 'duration': 's', 'maximal_force': 'N', 'maximal_approach': 'm', 'maximal_semi_axis_a': 'm', 'maximal_semi_axis_b': 'm', 'energy_before': 'J', 'energy_after': 'J', 'energy_dissipated': 'J', 'energy_lost': 'J', 'regimes': '', 'method': '', 'compressions': '', 'error_estimate': '', 'warnings': ''}
Rebound.meanings = {'outcome': 'rebound, or no_impact', 'R_x': 'tangential restitution', 'body_1_velocity': 'of the centre of mass, afterwards', 'body_1_spin': 'angular velocity, afterwards', 'body_2_velocity': 'of the centre of mass, afterwards', 'body_2_spin': 'angular velocity, afterwards', 'impulse': 'on body 1', 'contact_velocity_before': 'of body 2 against body 1', 'contact_velocity_after': 'of body 2 against body 1', 'duration': 'from touch to separation', 'maximal_force': 'normal', 'maximal_approach': 'of distant points', 'maximal_semi_axis_a': 'of the contact along x', 'maximal_semi_axis_b': 'of the contact along y', 'energy_before': 'kinetic, without bodies held fast', 'energy_after': 'kinetic, without bodies held fast', 'energy_dissipated': 'by friction', 'energy_lost': "in the bodies' material", 'regimes': 'in order; sign: traction on body 1 along the first slip', 'method': 'how it was solved', 'compressions': 'how often the approach grew', 'error_estimate': 'of the contact velocity, over that before', 'warnings': 'what limits the validity'}
Rebound._vectors = frozenset(['body_1_velocity', 'body_1_spin', 'body_2_velocity', 'body_2_spin', 'impulse', 'contact_velocity_before', 'contact_velocity_after'])
