"""A valid call of everything public that takes arguments, with the unit of each number. The tests that concern all of
them walk along this table; `test_every_call.py` sees to it that nothing is missing."""

import inspect
import tempfile
from pathlib import Path
from typing import NamedTuple

import carom
import numpy as np

STEEL = carom.Material(208e9, 0.3)
PAIR = carom.MaterialPair(STEEL)
HERTZ = carom.hertz_of_spheres(0.01, 0.02, STEEL)
BALL = carom.sphere(0.01, STEEL, 0.033, velocity=(0.1, 0.0, -0.2))
FLOOR = carom.plane(STEEL)
X, Y = carom.cells((12, 12), (2.6e-4, 2.6e-4))
GAP = (X**2 + Y**2) / 0.02


class In(NamedTuple):
    """A number, or several, in this unit."""

    value: object
    unit: str


class Call(NamedTuple):
    """What is called, with which arguments. `how` makes the call and gives what can be compared."""

    of: object
    arguments: dict
    how: object = None

    def __call__(self, **changed):
        return (self.how or self.of)(**(plain(self.arguments) | changed))


def plain(given):
    """The values alone."""
    if isinstance(given, dict):
        return {name: plain(one) for name, one in given.items()}
    if type(given) is tuple:
        return tuple(plain(one) for one in given)
    return given.value if isinstance(given, In) else given


def none(value):
    return In(value, "")


def grains():
    return carom.GrainContacts(2, (0.01, 0.02), STEEL, 0.3, torsion=True, rolling=(1e6, 0.1, 0.01))


def state(contact):
    """What a contact or solver remembers."""
    return contact.__getstate__()


def case(kind):
    path = Path(tempfile.mkdtemp()) / f"{kind}.toml"
    path.write_text(carom.cases.new(kind))
    return path


def contact(**given):
    made = carom.Contact(HERTZ, 0.3, **given)
    made.advance(1e-6, 1e-7)
    return made


def solver():
    made = carom.Solver(GAP, (2.6e-4, 2.6e-4), PAIR, 0.3)
    made.step(F_z=10.0)
    return made


def surface():
    return carom.surface(1e-9 * np.add.outer(np.arange(9.0) ** 2, np.arange(8.0)), size=(8e-6, 9e-6))


def turned(angle):
    made = contact()
    made.turn_frame(angle)
    return made.load


COLLIDE = {
    "body_1": BALL,
    "body_2": FLOOR,
    "friction": none(0.2),
    "static_friction": none(0.3),
    "normal": none((0.0, 0.0, 1.0)),
    "torsion": False,
    "law": "coulomb",
    "tolerance": none(1e-2),
}
LOST = {"normal_restitution": none(0.9), "loss": "yield", "wave_loss": False, "relaxation": In(0.0, "s")}
PATH = {"zeta": In([1e-6, 2e-6], "m"), "xi": In([0.0, 1e-7], "m"), "eta": In([0.0, 2e-7], "m"), "omega": In([0.0, 1e-4], "rad")}
SPEEDS = {
    f"body_{i}_{what}": In(np.array([[0.1, 0.2, sign], [0.3, 0.0, sign]]), unit)
    for i, sign in ((1, -0.1), (2, 0.1))
    for what, unit in (("velocity", "m/s"), ("spin", "rad/s"))
}
WINDOW = {
    "gap": In(GAP, "m"),
    "size": In((2.6e-4, 2.6e-4), "m"),
    "materials": PAIR,
    "friction": none(0.3),
    "tolerance": none(1e-8),
    "cut": False,
}
ESTIMATED = WINDOW | {"estimates": True}
BLOCK = In(1e-17 * np.outer(0.5 ** np.arange(12), 0.5 ** np.arange(12)), "m/Pa")
LAMBDA = {"kappa": none(1.2), "lam": none([1.0, 2.0])}
POINTS = {"x": In([0.0, 1e-5], "m"), "y": In(1e-5, "m"), "z": In(2e-5, "m")}
LOADS = {"zeta": ("m", 1e-7), "xi": ("m", 1e-8), "eta": ("m", 1e-8), "omega": ("rad", 1e-5)}
FORCES = {"F_z": ("N", 10.0), "F_x": ("N", 0.5), "F_y": ("N", -0.2), "M_z": ("N*m", 1e-6)}
CREEPS = {"zeta": In(2e-7, "m"), "creepage": none(1e-4), "creepage_across": none(1e-4), "spin": In(0.1, "rad/m")}
ROLLED = {"direction": In(90.0, "deg"), "step": In(2e-5, "m"), "spin_offset": none(0.5), "speed": In(2.0, "m/s")}
PRESSED = {"F_z": In(10.0, "N"), "F_x": In(0.1, "N"), "F_y": In(0.1, "N"), "M_z": In(1e-6, "N*m")}


#: Rebounds of alumina balls from glass: angles in degrees, tangential velocity after over that before.
REBOUNDS = {"angle": [4.2, 9.8, 20.2, 30.4, 49.6], "body_1_tangential_ratio": [0.75, 0.68, 0.60, 0.69, 0.85]}


def unknown():
    """A case with unknown friction and ratio of stiffness."""
    path = Path(tempfile.mkdtemp()) / "unknown.toml"
    path.write_text("""
body_1 = { shape = "sphere", radius = 2.5e-3, material = { young_modulus = 380e9, poisson = 0.23 }, density = 4000 }
body_2 = { shape = "plane", material = { young_modulus = 70e9, poisson = 0.25 }, fixed = true }
approach = { speed = 3.9, angle = 45 }
contact = { friction = { fit = [0.01, 1] }, normal_over_tangential_stiffness = { fit = [0.8, 1.5] } }
""")
    return path


def given(units):
    return {name: In(value, unit) for name, (unit, value) in units.items()}


CALLS = {
    "Body": [
        Call(carom.Body, {"shape": "ellipsoid", "sizes": In([0.1, 0.2, 0.3], "m"), "material": STEEL, "mass": In(2.0, "kg"),
                          "hollow": False, "moments": In((0.02, 0.02, 0.02), "kg*m**2"), "centre": In((1.0, 0.0, 2.0), "m"),
                          "attitude": none((1.0, 0.0, 0.0, 0.0)), "velocity": In((1.0, 0.0, -2.0), "m/s"), "spin": In((1.0, 2.0, 3.0), "rad/s")}),
        Call(carom.Body, {"shape": "sphere", "sizes": In(0.1, "m"), "material": STEEL, "density": In(7850.0, "kg/m**3")}),
    ],
    "Body.moving": [Call(BALL.moving, {"velocity": In([1.0, 2.0, 3.0], "m/s"), "spin": In([3.0, 2.0, 1.0], "rad/s")})],
    "Contact": [
        Call(carom.Contact, {"stiffness": In((1e9, 1e9, 1.2e9), "N/m**(3/2)"), "friction": none(0.3), "law": "coulomb", "tolerance": none(1e-3),
                             "static_friction": none(0.4), "heat": True}, lambda **given: state(carom.Contact(**given))),
    ],
    "Contact.advance": [Call(carom.Contact.advance, {name: In(one.value[1], one.unit) for name, one in PATH.items()},
                             lambda **given: contact(law="rings").advance(**given))],
    "Contact.follow": [Call(carom.Contact.follow, PATH, lambda **given: contact(law="rings").follow(**given))],
    "Contact.traction": [Call(carom.Contact.traction, {"r": none(0.5)}, lambda **given: contact().traction(**given))],
    "Contact.turn_frame": [Call(carom.Contact.turn_frame, {"angle": In(0.5, "rad")}, turned)],
    "Contacts": [
        Call(carom.Contacts, {"count": none(2), "stiffness": HERTZ, "friction": none(0.3), "law": "coulomb", "tolerance": none(1e-2),
                              "static_friction": none(0.4), "directions": none(2), "threads": False},
             lambda **given: repr(carom.Contacts(**given))),
    ],
    "Contacts.advance": [Call(carom.Contacts.advance, PATH, lambda **given: carom.Contacts(2, HERTZ, 0.3, law="rings").advance(**given))],
    "Contacts.follow": [
        Call(carom.Contacts.follow, PATH | {"out": In(np.zeros((2, 2, 4)), "N")},
             lambda **given: carom.Contacts(2, HERTZ, 0.3, law="rings").follow(**given)),
    ],
    "GrainContacts": [
        Call(carom.GrainContacts, {"count": none(2), "radii": In((0.01, 0.02), "m"), "materials": STEEL, "friction": none(0.3), "law": "coulomb",
                                   "relaxation": In(0.0, "s"), "restitution": none(0.8), "masses": In((0.033, 0.27), "kg"), "torsion": True,
                                   "rolling": (In(1e6, "N/m"), In(0.1, "N*s/m"), none(0.01))},
             lambda **given: repr(carom.GrainContacts(**given))),
    ],
    "GrainContacts.step": [
        Call(carom.GrainContacts.step, {"dt": In(1e-6, "s"), "place_1": In([0.0, 0.0, 0.03 - 1e-7], "m"), "velocity_1": In([0.1, 0.0, -0.2], "m/s"),
                                        "spin_1": In([1.0, 2.0, 3.0], "rad/s"), "place_2": In([0.0, 0.0, 0.0], "m"),
                                        "velocity_2": In([0.1, 0.2, 0.0], "m/s"), "spin_2": In([3.0, 0.0, 1.0], "rad/s"), "heat": True},
             lambda **given: np.concatenate(grains().step(**given))),
    ],
    "Hertz": [Call(carom.Hertz, {"materials": PAIR, "curvature_a": In(50.0, "1/m"), "curvature_b": In(40.0, "1/m"),
                                    "smallest_radius": In(0.01, "m")})],
    "Hertz.of_radii": [
        Call(carom.Hertz.of_radii, {"materials": PAIR, "radii_1": In([0.1, 0.2], "m"), "radii_2": In([0.3, 0.4], "m"), "angle": In(0.2, "rad")}),
    ],
    "Material": [
        Call(carom.Material, {"young_modulus": In(208e9, "Pa"), "poisson": none(0.3), "yield_stress": In(1e9, "Pa")}),
        Call(carom.Material, {"shear_modulus": In(80e9, "Pa"), "poisson": 0.3}),
    ],
    "MaterialPair": [Call(carom.MaterialPair, {"material_1": STEEL, "material_2": carom.RIGID})],
    "Plate": [Call(carom.Plate, {"a": In(1.0, "m"), "b": In(2.0, "m"), "thickness": In(0.1, "m"), "theory": "mindlin"})],
    "RestitutionBySpeed": [Call(carom.RestitutionBySpeed, {"speed": In([0.5, 1.0], "m/s"), "restitution": none([0.9, 0.8])})],
    "RestitutionBySpeed.at": [Call(carom.RestitutionBySpeed([0.5, 1.0], [0.9, 0.8]).at, {"speed": In([1.0, 2.0], "m/s")})],
    "ShiftTwist": [Call(carom.ShiftTwist, {"hertz": HERTZ, "friction": none(0.3)}, lambda **given: state(carom.ShiftTwist(**given)))],
    "ShiftTwist.advance": [
        Call(carom.ShiftTwist.advance, {name: In(one.value[1], one.unit) for name, one in PATH.items()},
             lambda **given: carom.ShiftTwist(HERTZ, 0.3).advance(**given)),
    ],
    "SlipSpeedFriction": [Call(carom.SlipSpeedFriction, {"a": none(0.1), "b": none(0.2), "c": In(0.9, "s/m")})],
    "SlipSpeedFriction.at": [Call(carom.SlipSpeedFriction(0.1, 0.2, 0.9).at, {"speed": In([1.0, 2.0], "m/s")})],
    "Solver": [
        Call(carom.Solver, ESTIMATED, lambda **given: carom.Solver(**given).step(F_z=10.0)),
        Call(carom.Solver, WINDOW | {"friction": none(np.full((12, 12), 0.3))}, lambda **given: carom.Solver(**given).step(F_z=10.0)),
        Call(carom.Solver, {"gap": In(GAP, "m"), "size": In((2.6e-4, 2.6e-4), "m"), "materials": PAIR, "friction": none(0.0),
                            "plate": carom.Plate(2.6e-4, 2.6e-4, 1e-4)}, lambda **given: carom.Solver(**given).step(F_z=1.0)),
        Call(carom.Solver, {"gap": In(GAP, "m"), "size": In((2.6e-4, 2.6e-4), "m"), "materials": PAIR, "friction": none(0.0),
                            "influence": {"zz": BLOCK}, "missing": None, "periodic": False}, lambda **given: carom.Solver(**given).step(F_z=1.0)),
    ],
    "Surface": [
        Call(carom.Surface, {"heights": In(np.eye(4), "m"), "size": In((3e-6, 4e-6), "m")},
             lambda **given: (carom.Surface(**given).heights, carom.Surface(**given).size)),
    ],
    "Surface.measures": [Call(carom.Surface.measures, {"periodic": True}, lambda **given: surface().measures(**given))],
    "Surface.prepared": [
        Call(carom.Surface.prepared, {"crop": (0, 0, 3, 3), "level": "plane", "missing": "fill"},
             lambda **given: surface().prepared(**given).heights),
    ],
    "Surface.warnings": [Call(carom.Surface.warnings, {"periodic": True}, lambda **given: surface().warnings(**given))],
    "surface": [
        Call(carom.surface, {"source": np.eye(4), "unit": "um", "scale": none(2.0), "size": In((4e-6, 4e-6), "m"),
                             "range": None, "crop": (0, 0, 3, 3), "level": "plane", "missing": "fill"},
             lambda **given: carom.surface(**given).heights),
    ],
    "fit": [
        Call(carom.fit, {"case": unknown(), "data": REBOUNDS, "sd": 0.014, "robust": True, "predict": {"angle": [15.0]}},
             lambda **given: carom.fit(**given).parameters.value),
    ],
    "line_contact": [
        Call(carom.line_contact, {"materials": PAIR, "radius": In(5e-3, "m"), "length": In(20e-3, "m"), name: In(value, unit)})
        for name, value, unit in (("force", 1e3, "N"), ("approach", 1e-6, "m"), ("half_width", 1e-4, "m"), ("peak_pressure", 1e9, "Pa"))
    ],
    "Solver.step": [
        Call(carom.Solver.step, given(FORCES), lambda **given: solver().step(**given)),
        Call(carom.Solver.step, given(LOADS), lambda **given: solver().step(**given)),
    ],
    "Solver.stress": [Call(carom.Solver.stress, POINTS | {"body": none(1)}, lambda **given: solver().stress(**given))],
    "TriangleMesh": [
        Call(carom.TriangleMesh, {"triangles": In([[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]], "m"), "smooth": In(0.2, "rad"),
                                  "period": In((0.0, 0.0, 2.0), "m")}, lambda **given: repr(carom.TriangleMesh(**given))),
    ],
    "TriangleMesh.places": [
        Call(carom.TriangleMesh.places, {"centers": In([[0.2, 0.3, 0.1], [0.5, 0.6, 0.1]], "m"), "radii": In(0.3, "m")},
             lambda **given: np.column_stack(carom.TriangleMesh([[[0, 0, 0], [1, 0, 0], [0, 1, 0]]]).places(**given)[:4])),
    ],
    "Twist": [Call(carom.Twist, {"hertz": HERTZ, "friction": none(0.3)}, lambda **given: state(carom.Twist(**given)))],
    "Twist.advance": [
        Call(carom.Twist.advance, {"zeta": In(1e-6, "m"), "omega": In(1e-4, "rad")}, lambda **given: carom.Twist(HERTZ, 0.3).advance(**given)),
    ],
    "cells": [Call(carom.cells, {"shape": none((2, 3)), "size": In((1.0, 2.0), "m")})],
    "collide": [
        Call(carom.collide, COLLIDE | LOST),
        Call(carom.collide, {"body_1": BALL, "body_2": FLOOR, "friction": none(0.2), "relaxation": In(1e-7, "s")}),
    ],
    "rebound_derivatives": [
        Call(carom.rebound_derivatives, {"body_1": BALL, "body_2": FLOOR, "friction": none(0.2), "normal": (0.0, 0.0, 1.0), "kappa": none(1.2)},
             lambda **given: carom.rebound_derivatives(**given).matrix),
    ],
    "collide_many": [
        Call(carom.collide_many, COLLIDE | LOST | SPEEDS),
        Call(carom.collide_many, {"body_1": BALL, "body_2": FLOOR, "friction": none([0.2, 0.3]), "relaxation": In(1e-7, "s")}),
    ],
    "creep_coefficients": [Call(carom.creep_coefficients, {"axis_ratio": none([0.5, 1.0]), "poisson": none(0.3)})],
    "creep_force": [
        Call(carom.creep_force, {"contact": HERTZ, "friction": none(0.3), "F_z": In(10.0, "N"), "creepage": none([1e-4, 1e-3]),
                                 "creepage_across": none(1e-4), "spin": In(0.1, "rad/m")}),
    ],
    "fastsim": [
        Call(carom.fastsim, {"contact": HERTZ, "friction": none(0.3), "F_z": In(10.0, "N"), "creepage": none([1e-4, 1e-3]),
                             "creepage_across": none(1e-4), "spin": In(0.1, "rad/m"), "mesh": none((20, 20))}),
    ],
    "hertz": [
        Call(carom.hertz, {"contact": HERTZ, name: In(value, unit)})
        for name, value, unit in (("force", [1.0, 2.0], "N"), ("approach", 1e-6, "m"), ("semi_axis_a", 1e-5, "m"), ("semi_axis_b", 1e-5, "m"), ("peak_pressure", 1e8, "Pa"))
    ],
    "hertz_of_spheres": [
        Call(carom.hertz_of_spheres, {"radius_1": In(0.1, "m"), "radius_2": In(0.2, "m"), "material_1": STEEL, "material_2": STEEL}),
    ],
    "history": [Call(carom.history, COLLIDE_HISTORY := {name: one for name, one in COLLIDE.items() if name != "torsion"} | LOST | {"points": none(5)})],
    "lubkin_stick_radius": [Call(carom.lubkin_stick_radius, {"twist": none([0.1, 1.0])})],
    "lubkin_torque": [Call(carom.lubkin_torque, {"twist": none(0.1)})],
    "plane": [Call(carom.plane, {"material": STEEL})],
    "roll": [
        Call(carom.roll, WINDOW | CREEPS | ROLLED),
        Call(carom.roll, WINDOW | PRESSED),
        Call(carom.roll, WINDOW | {"zeta": In(2e-7, "m"), "creepage": none(1e-4), "distance": In(4e-5, "m")}),
        Call(carom.roll, WINDOW | {"friction": none(0.1), "zeta": In(2e-7, "m"), "influence": {"zz": BLOCK, "xx": BLOCK, "yy": BLOCK}}),
    ],
    "restitution": [
        Call(carom.restitution, LAMBDA | {"normal_restitution": none(0.9), "exact": True}),
        Call(carom.restitution, LAMBDA | {"gamma": none(0.1), "friction": none(0.2), "mobility_ratio": none(3.0)}),
    ],
    "restitution_of_dissimilar": [
        Call(carom.restitution_of_dissimilar, LAMBDA | {"gamma": none(0.1), "friction": none(0.2), "mobility_ratio": none(3.0), "exact": False}),
    ],
    "restitution_of_groups": [Call(carom.restitution_of_groups, {"chi": none(3.0), "psi": none([1.0, 2.0]), "normal_restitution": none(0.9), "exact": False})],
    "sphere": [
        Call(carom.sphere, {"radius": In(0.02, "m"), "material": STEEL, "mass": In(0.3, "kg"), "hollow": False, "velocity": In((1.0, 0.0, -2.0), "m/s"),
                            "spin": In((1.0, 2.0, 3.0), "rad/s"), "centre": In((0.0, 0.0, 1.0), "m")}),
        Call(carom.sphere, {"radius": In(0.02, "m"), "material": STEEL, "density": In(7850.0, "kg/m**3")}),
    ],
    "stress": [
        Call(carom.stress, POINTS | {"semi_axes": In((1e-4, 2e-4), "m"), "material": STEEL, "pressure": In(1e9, "Pa"),
                                     "traction": In((1e8, 0.0), "Pa"), "stick_radius": none(0.5)}),
    ],
    "von_mises": [Call(carom.von_mises, {"stress": In([1e6, 2e6, 0.0, 0.0, 1e6, 0.0], "Pa")})],
    **{
        f"cases.{kind}": [Call(getattr(carom.cases, kind), {"case": case(kind)} | beside)]
        for kind, beside in {
            "hertz": {}, "history": {}, "impact": {}, "roll": {"coefficients": False, "fastsim": True, "table": True}, "scene": {"points": none(2)},
            "shell": {}, "solve": {"accuracy": none(0.05)}, "stress": {},
        }.items()
    },
    "cases.new": [Call(carom.cases.new, {"kind": "hertz"})],
    "plot.restitution": [Call(carom.plot.restitution, {"kappa": none(1.2), "lam": none([1.0, 2.0]), "axes": None, "ax": None}, lambda **given: drawn(carom.plot.restitution, given))],
    "plot.loop": [Call(carom.plot.loop, {"shift": In([0.0, 1e-7], "m"), "loads": In([[0.0, 0.0, 1.0], [0.1, 0.0, 1.0]], "N"), "axes": None, "ax": None},
                       lambda **given: drawn(carom.plot.loop, given))],
    **{
        f"special.{name}": [Call(getattr(carom.special, name), {argument: none(value) for argument, value in arguments.items()})]
        for names, arguments in (
            ("b c d e k", {"axis_ratio": [0.5, 2.0]}),
            ("inc_d inc_e inc_f", {"axis_ratio": 0.5, "phi": [0.1, 0.2]}),
            ("gamma ln_gamma", {"x": 2.5}),
            ("hyp2f1", {"a": 0.5, "b": 0.6, "c": 1.5, "x": [0.1, 0.2]}),
            ("hyp3f2", {"s": 1.0, "a": 0.5, "b": 0.6, "c": 1.5, "x": 0.1}),
        )
        for name in names.split()
    },
}
del COLLIDE_HISTORY

#: What takes no argument but what carom has made itself, and why it is not in the table.
NO_CALLS = {
    "RangeError": "is raised",
    "CaromError": "is raised",
    "CaromWarning": "is told",
    "OutsideTheoryWarning": "is told",
    "Solver.summary": "takes nothing",
    "cases.Stresses.to_xarray": "takes nothing",
    "plot.history": "takes a result",
    "plot.pressure": "takes a result",
    "plot.stick_slip": "takes a result",
    "plot.tractions": "takes a result",
}


def drawn(plot, given):
    """The curves of a picture."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    axes = plot(**given)
    curves = [line.get_xydata() for line in axes.lines]
    pyplot.close(axes.figure)
    return curves


def public():
    """Name and object of everything public that can be called; results, which carom makes itself, apart."""
    from carom._record import Result

    modules = {"": carom, "cases.": carom.cases, "plot.": carom.plot, "special.": carom.special}
    for prefix, module in modules.items():
        for name in module.__all__:
            one = getattr(module, name)
            if inspect.isclass(one):
                methods = {f"{name}.{inner}": getattr(one, inner) for inner in vars(one) if not inner.startswith("_")}
                found = ({} if issubclass(one, Result) else {name: one}) | {n: m for n, m in methods.items() if callable(m)}
            else:
                found = {name: one} if callable(one) else {}
            yield from ((prefix + inner, thing) for inner, thing in found.items())


def numbers():
    """Name, call, argument, its value and unit, of all numbers of all calls."""
    for name, calls in CALLS.items():
        for call in calls:
            for argument, one in call.arguments.items():
                if isinstance(one, In):
                    yield name, call, argument, one


def same(one, other):
    """Whether two results are equal; numbers to round-off of their units."""
    if isinstance(one, (list, tuple)):
        return len(one) == len(other) and all(same(a, b) for a, b in zip(one, other))
    if isinstance(one, (float, np.ndarray)):
        return np.allclose(one, other, rtol=1e-9, atol=0.0, equal_nan=True)
    if hasattr(one, "to_dict"):
        one, other = one.to_dict(), other.to_dict()
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(same(value, other[name]) for name, value in one.items())
    return one == other
