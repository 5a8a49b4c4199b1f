"""carom: elastic impact with friction.

Contact laws with memory, Hertz contacts, impact of bodies and rebound, after J. Jaeger, *Elastic Impact
with Friction* (TU Delft, 1992). SI units, or any consistent set. A quantity that carries a unit, of unyt, astropy or
pint, is converted to the unit of the argument, or refused; results are plain numbers.

A ball of alumina meets a plate of the same material at 45 degrees:

>>> import carom
>>> alumina = carom.Material(380e9, 0.23)
>>> ball = carom.sphere(2.5e-3, alumina, mass=2.618e-4, velocity=(2.758, 0, -2.758))
>>> rebound = carom.collide(ball, carom.plane(alumina), friction=0.092)
>>> round(rebound.R_x, 4)
-0.356
>>> float(rebound.body_1_velocity[2])
2.758

R_x of spheres for a thousand angles:

>>> import numpy as np
>>> kappa = carom.MaterialPair(alumina).kappa
>>> r_x = carom.restitution(kappa, np.linspace(0.01, 10, 1000))
>>> r_x.shape, bool(r_x.max() < 0.5)
((1000,), True)

A contact with memory, pressed and then shifted to and fro:

>>> hertz = carom.hertz_of_spheres(0.01, 0.01, alumina)
>>> contact = carom.Contact(hertz, friction=0.3)
>>> _ = contact.advance(1e-6)
>>> f_x, f_y, f_z = contact.advance(1e-6, xi=1e-7)
>>> contact.regime
'slip'
>>> back = contact.follow(np.full(50, 1e-6), np.linspace(1e-7, -1e-7, 50))
>>> bool(np.isclose(back[-1, 0], -f_x))
True

A contact on a grid, with any gap and load history:

>>> x, y = carom.cells((32, 32), size=(1e-3, 1e-3))
>>> wavy = 1e-6 * np.cos(2 * np.pi * x / 5e-4) ** 2 + (x**2 + y**2) / 0.02
>>> solver = carom.Solver(wavy, (1e-3, 1e-3), carom.MaterialPair(alumina), friction=0.3)
>>> step = solver.step(F_z=200.0)
>>> round(float(solver.pressure.sum() * (1e-3 / 32) ** 2), 6)
200.0

A value out of range raises `carom.RangeError`, a ValueError that names the field:

>>> carom.Material(208e9, 0.7)
Traceback (most recent call last):
    ...
carom.RangeError: poisson = 0.7 is out of range: must be in (-1, 0.5]
"""

from __future__ import annotations

import sys

from . import cases, plot, special
from ._carom import (
    Body,
    CaromError,
    Contact,
    Hertz,
    Material,
    MaterialPair,
    Plate,
    RangeError,
    ShiftTwist,
    Twist,
)
from ._carom import __VERSION as __version__
from ._contacts import Contacts
from ._contact_theory import (
    hertz,
    hertz_of_spheres,
    line_contact,
    lubkin_stick_radius,
    lubkin_torque,
    restitution,
    restitution_of_dissimilar,
    restitution_of_groups,
    stress,
    von_mises,
)
from ._creep import creep_coefficients, creep_force, fastsim
from ._derivatives import ReboundDerivatives, rebound_derivatives
from ._fit import Fit, fit
from ._friction import SlipSpeedFriction
from ._grains import GrainContacts
from ._impact import collide, collide_many, history, plane, sphere
from ._loss import RestitutionBySpeed
from ._mesh import TriangleMesh
from ._mistakes import help_calls
from ._records import (
    Bounce,
    Bounces,
    CreepCoefficients,
    DissimilarRestitution,
    DissimilarRestitutions,
    FastsimForce,
    FastsimForces,
    FitCorrelation,
    FitCorrelations,
    FitParameter,
    FitParameters,
    FitPoint,
    FitPoints,
    FitPrediction,
    FitPredictions,
    FitQuality,
    HertzState,
    HertzStates,
    HistoryPoint,
    HistoryPoints,
    HistoryStep,
    HistorySteps,
    LinearCreep,
    LinearCreeps,
    PathEvent,
    PathEvents,
    PathPoint,
    PathPoints,
    Rebound,
    Rebounds,
    RollState,
    RollStates,
    SolverStep,
    SolverSteps,
    SurfaceMeasures,
    LineState,
    LineStates,
    CreepForce,
    CreepForces,
)
from ._roll import roll
from ._solver import Solver, cells
from ._surface import Surface, surface
from ._validity import CaromWarning, OutsideTheoryWarning

#: The material of a rigid body.
RIGID = Material(float("inf"))

__all__ = [
    "RIGID",
    "Body",
    "Bounce",
    "Bounces",
    "CaromError",
    "CaromWarning",
    "Contact",
    "Contacts",
    "CreepCoefficients",
    "CreepForce",
    "CreepForces",
    "DissimilarRestitution",
    "DissimilarRestitutions",
    "FastsimForce",
    "FastsimForces",
    "Fit",
    "FitCorrelation",
    "FitCorrelations",
    "FitParameter",
    "FitParameters",
    "FitPoint",
    "FitPoints",
    "FitPrediction",
    "FitPredictions",
    "FitQuality",
    "GrainContacts",
    "Hertz",
    "HertzState",
    "HertzStates",
    "HistoryPoint",
    "HistoryPoints",
    "HistoryStep",
    "HistorySteps",
    "LinearCreep",
    "LineState",
    "LineStates",
    "LinearCreeps",
    "Material",
    "MaterialPair",
    "OutsideTheoryWarning",
    "PathEvent",
    "PathEvents",
    "PathPoint",
    "PathPoints",
    "Plate",
    "RangeError",
    "Rebound",
    "ReboundDerivatives",
    "Rebounds",
    "RestitutionBySpeed",
    "RollState",
    "RollStates",
    "ShiftTwist",
    "SlipSpeedFriction",
    "Solver",
    "SolverStep",
    "SolverSteps",
    "Surface",
    "SurfaceMeasures",
    "TriangleMesh",
    "Twist",
    "__version__",
    "cases",
    "cells",
    "collide",
    "collide_many",
    "creep_coefficients",
    "creep_force",
    "fastsim",
    "fit",
    "hertz",
    "hertz_of_spheres",
    "history",
    "line_contact",
    "lubkin_stick_radius",
    "lubkin_torque",
    "plane",
    "roll",
    "plot",
    "rebound_derivatives",
    "restitution",
    "restitution_of_dissimilar",
    "restitution_of_groups",
    "special",
    "sphere",
    "stress",
    "surface",
    "von_mises",
]

for _module in (sys.modules[__name__], cases, special):
    help_calls(_module)
