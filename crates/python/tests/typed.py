"""Code of a user, as type checkers see it: numbers in give numbers, arrays in give arrays. See test_types.py."""

import pathlib

import numpy as np
from numpy.typing import NDArray
from typing_extensions import assert_type

import carom

Array = NDArray[np.float64]

steel = carom.Material(208e9, 0.3)
ball = carom.sphere(0.01, steel, 0.033, velocity=np.array([1.0, 0.0, -2.0]))
plate = carom.plane(steel)
grid = np.linspace(0.1, 1.0, 7)

# One impact has numbers, many have arrays, and one of many has numbers again.
rebound = carom.collide(ball, plate, friction=0.15)
x: float = rebound.R_x
assert_type(rebound.outcome, str)
assert_type(rebound.compressions, int)
assert_type(rebound.body_1_velocity, Array)
many = carom.collide_many(ball, plate, grid)
by_speed = carom.SlipSpeedFriction(0.1, 0.2, 0.9)
assert_type(carom.collide_many(ball, plate, by_speed), carom.Rebounds)
assert_type(by_speed.at(1.0), float)
assert_type(by_speed.at(grid), Array)
assert_type(many, carom.Rebounds)
r_x: Array = many.R_x
assert_type(many.method, list[str])
assert_type(many[0], carom.Rebound)
assert_type(many[1:3], carom.Rebounds)
assert_type(many[many.R_x > 0], carom.Rebounds)
assert_type([one.R_x for one in many], list[float])
assert_type(rebound.maximal_force, float)
assert_type(carom.history(ball, plate, 0.15).F, Array)

# A Hertz contact under one load, or several.
hertz = carom.hertz_of_spheres(0.01, 0.02, steel)
assert_type(carom.hertz(hertz, force=1.0), carom.HertzState)
assert_type(carom.hertz(hertz, force=1).approach, float)
assert_type(carom.hertz(hertz, approach=[1e-6, 2e-6]), carom.HertzStates)
assert_type(carom.hertz(hertz, force=grid).approach, Array)

# Functions of numbers.
assert_type(carom.restitution(1.2, 1.0), float)
assert_type(carom.restitution(1.2, grid), Array)
assert_type(carom.restitution([[1.0], [1.2]], 2.0), Array)
assert_type(carom.restitution(1.2, 1.0, gamma=0.1, friction=0.2), float)
assert_type(carom.restitution_of_groups(2.0, 1.0), float)
assert_type(carom.restitution_of_groups(2.0, grid), Array)
assert_type(carom.restitution_of_dissimilar(1.2, 1.0, 0.1, 0.2).R_x, float)
assert_type(carom.restitution_of_dissimilar(1.2, grid, 0.1, 0.2).R_x, Array)
assert_type(carom.lubkin_torque(0.1), float)
assert_type(carom.lubkin_torque(grid), Array)
assert_type(carom.special.k(0.5), float)
assert_type(carom.special.k(np.float64(0.5)), float)
assert_type(carom.special.k(grid), Array)
assert_type(carom.special.inc_f(0.5, 0.1), float)
assert_type(carom.special.inc_f(0.5, grid), Array)
assert_type(carom.special.hyp2f1(1, 1, 2, 0.5), float)
assert_type(carom.special.hyp2f1(1, 1, 2, 0.9 * grid), Array)
equivalent: Array = carom.von_mises(carom.stress((1e-3, 1e-3), steel, 1.0, 0.0, 0.0, grid))
at_one_point: float = carom.von_mises(carom.stress((1e-3, 1e-3), steel, 1.0, 0.0, 0.0, 1e-3))

# Creep coefficients, and forces with them.
assert_type(carom.creep_coefficients(1.0, 0.3), carom.LinearCreep)
assert_type(carom.creep_coefficients(1.0, 0.3).C11, float)
assert_type(carom.creep_coefficients(grid, 0.3), carom.LinearCreeps)
assert_type(carom.creep_coefficients(1.0, [0.2, 0.3]).C33, Array)
assert_type(carom.fastsim(hertz, 0.3, F_z=10.0, creepage=1e-3), carom.FastsimForce)
assert_type(carom.fastsim(hertz, 0.3, F_z=10.0, creepage=1e-3).F_x, float)
assert_type(carom.fastsim(hertz, 0.3, F_z=10.0, creepage=-1e-3 * grid).F_x, Array)
assert_type(carom.fastsim(hertz, grid, F_z=10.0), carom.FastsimForces)
assert_type(carom.fastsim(hertz, 0.3, F_z=grid, spin=1.0), carom.FastsimForces)
assert_type(carom.fastsim(hertz, 0.3, F_z=1, spin=[0.0, 1.0]), carom.FastsimForces)

# Contacts with memory, and a contact on a grid.
contact = carom.Contact(hertz, friction=0.3)
f_x, f_y, f_z = contact.advance(1e-6, xi=1e-8)
assert_type(f_x, float)
assert_type(contact.follow(grid * 1e-6), Array)
assert_type(carom.Contacts(7, hertz, 0.3).advance(grid * 1e-6), Array)
assert_type(carom.TriangleMesh([[[0, 0, 0], [1, 0, 0], [0, 1, 0]]], smooth=0.2).places([0.2, 0.2, 0.1], 0.2).normal, Array)
assert_type(carom.GrainContacts(7, (1e-3, 1e-3), steel, 0.3).step(1e-6, [0.0, 0.0, 1.9e-3]).force, Array)
across, up = carom.cells((24, 24), (2e-4, 2e-4))
solver = carom.Solver((across**2 + up**2) / 0.02, (2e-4, 2e-4), carom.MaterialPair(steel), 0.3)
step = solver.step(F_z=2.0)
zeta: float = step.zeta
number: int = step.step
assert_type(solver.pressure, Array)

# A case file has one impact or a sweep; only the file tells which.
path = pathlib.Path(__file__).parents[3] / "examples" / "alumina_on_plane.toml"
case = carom.cases.impact(path)
assert_type(case, carom.Rebound | carom.cases.Sweep)
assert isinstance(case, carom.cases.Sweep)
assert_type(case.swept, tuple[str, str, Array])
assert_type(case.R_x, Array)
assert_type(carom.cases.history(path.with_name("history_loop.toml")).F_x, Array)
assert_type(carom.cases.solve(path.with_name("solve_hertz.toml")).steps.F_z, Array)
