"""Every argument acts, or is refused beside those that leave it nothing to do."""

import warnings

import carom
import numpy as np
import pytest

STEEL, GLASS = carom.Material(208e9, 0.3), carom.Material(70e9, 0.2)
HERTZ = carom.hertz_of_spheres(0.01, 0.01, STEEL, GLASS)
SIZE = (2.6e-4, 2.6e-4)
X, Y = carom.cells((24, 24), SIZE)
GAP = (X**2 + 0.7 * Y**2) / 0.02
#: A path that turns and unloads.
RANDOM = np.random.default_rng(1)
ZETA = 1e-6 * (1 + 0.3 * np.sin(np.linspace(0, 9, 60)))
XI, ETA = 3e-7 * np.cumsum(RANDOM.normal(size=(2, 60)), axis=1)
MOTION = {"velocity": (1, 0.3, -0.5), "spin": (10, 20, 60)}
BALL = carom.sphere(0.01, STEEL, 0.033, **MOTION)
EGG = carom.Body("ellipsoid", [0.01, 0.012, 0.015], STEEL, 0.033, **MOTION)


def told(result):
    """A result as numbers that can be compared bit by bit."""
    if hasattr(result, "to_dict"):
        return {name: told(value) for name, value in result.to_dict().items()}
    return result.tolist() if isinstance(result, np.ndarray) else result


def contact(law):
    def follow(friction=0.3, **given):
        made = carom.Contact(HERTZ, friction, law=law, **given)
        return made.follow(ZETA, XI, ETA).tolist(), made.dissipated

    return follow


def contacts(law, directions):
    def follow(friction=0.3, eta=None if directions == 1 else ETA, **given):
        made = carom.Contacts(1, HERTZ, friction, law=law, directions=directions, **given)
        return made.follow(ZETA[None], XI[None], eta if eta is None else eta[None]).tolist()

    return follow


def collide(body, plane, law):
    return lambda friction=0.3, **given: carom.collide(body, carom.plane(plane), friction, law=law, **given)


def roll(**fixed):
    def rolled(**given):
        given = {"F_z": 2.0, "creepage": 1e-3, "spin": 2.0} | fixed | given
        return carom.roll(GAP, SIZE, carom.MaterialPair(STEEL, GLASS), given.pop("friction", 0.3), **given)

    return rolled


def solver(**given):
    made = carom.Solver(GAP, SIZE, carom.MaterialPair(STEEL, GLASS), given.pop("friction", 0.3), **given)
    made.step(F_z=2.0)
    return made.step(F_x=0.2)


def solver_without_border(**given):
    return carom.Solver(0 * X, SIZE, carom.MaterialPair(STEEL), 0.0, **{"cut": True} | given).step(zeta=1e-7)


OF_IMPACT = {
    "friction": 0.31,
    "static_friction": 0.35,
    "torsion": (True, False),
    "normal_restitution": 0.8,
    "loss": "yield",
    "wave_loss": True,
    "relaxation": 1e-6,
    "normal": (0, 0.1, 1),
}
CALLS = {
    **{f"Contact {law}": (contact(law), {"friction": 0.31, "tolerance": 1e-1, "static_friction": 0.4, "heat": False})
       for law in ("coulomb", "fixed-direction", "rings")},
    **{f"Contacts {law} {ways}": (contacts(law, ways), {"friction": 0.31, "tolerance": 1e-1, "static_friction": 0.4, "eta": 2 * ETA})
       for law, ways in (("coulomb", 1), ("coulomb", 2), ("fixed-direction", 1), ("fixed-direction", 2), ("rings", 2))},
    **{f"collide {body.shape} {plane.poisson} {law}": (collide(body, plane, law), OF_IMPACT)
       for body, laws in ((BALL, ("auto", "coulomb", "fixed-direction", "rings", "numerical")), (EGG, ("auto", "coulomb", "numerical")))
       for plane in (STEEL, GLASS) for law in laws},
    "history": (lambda friction=0.3, **given: carom.history(BALL, carom.plane(STEEL), friction, **given),
                {"friction": 0.31, "points": 7, "static_friction": 0.4, "normal": (0, 0.1, 1), "law": "numerical", "normal_restitution": 0.8,
                 "wave_loss": True, "relaxation": 1e-6}),
    **{f"roll {fixed}": (roll(**fixed), {"friction": 0.31, "direction": 30.0, "step": 2e-5, "spin_offset": 0.5, "speed": 2.0, "tolerance": 1e-4,
                                         "creepage_across": 1e-3})
       for fixed in ({}, {"distance": 5e-5})},
    "Solver": (solver, {"friction": 0.31, "tolerance": 1e-3, "estimates": False}),
    "Solver to its border": (solver_without_border, {"cut": False, "estimates": False}),
    "restitution_of_dissimilar": (lambda gamma=0.1, **given: carom.restitution_of_dissimilar(1.2, 1.0, gamma, 0.2, **given),
                                  {"gamma": 0.12, "mobility_ratio": 3.0, "exact": True}),
    "restitution": (lambda **given: carom.restitution(1.2, 1.0, **given), {"gamma": 0.1, "friction": 0.1, "mobility_ratio": 3.0, "normal_restitution": 0.5}),
    "Body": (lambda mass=1.0, **given: repr(carom.Body("sphere", [0.1], STEEL, mass, **given)), {"hollow": True, "moments": (1.0, 1.0, 1.0)}),
    "Body with moments": (lambda **given: repr(carom.Body("sphere", [0.1], STEEL, 1.0, moments=(1.0, 1.0, 1.0), **given)), {"hollow": True}),
    "Body held": (lambda **given: repr(carom.Body("sphere", [0.1], STEEL, **given)), {"hollow": True, "moments": (1.0, 1.0, 1.0)}),
    "Material": (lambda poisson=0.3, **given: carom.Material(1e9, poisson, **given), {"poisson": 0.2, "shear_modulus": 1e9, "yield_stress": 1e6}),
    "Material rigid": (lambda **given: carom.Material(float("inf"), **given), {"poisson": 0.3, "shear_modulus": 1e9, "yield_stress": 1e6}),
}


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("name", CALLS)
def test_each_argument_acts_or_is_refused(name):
    call, arguments = CALLS[name]
    base = told(call())
    for argument, values in arguments.items():
        found = []
        for value in values if argument == "torsion" else (values,):
            try:
                found.append(told(call(**{argument: value})))
            except (ValueError, TypeError, carom.CaromError) as error:
                assert argument.split("_")[0] in str(error) or "border" in str(error), (argument, error)
                found.append(None)
        assert any(str(one) != str(base) for one in found), f"{argument} changes nothing"


def test_what_has_no_tolerance_refuses_one():
    for made in (
        lambda: carom.Contact(HERTZ, 0.3, law="fixed-direction", tolerance=1e-3),
        lambda: carom.Contacts(1, HERTZ, 0.3, law="fixed-direction", tolerance=1e-2),
        lambda: carom.Contacts(1, HERTZ, 0.3, directions=1, tolerance=1e-2),
    ):
        with pytest.raises(ValueError, match="^tolerance = .*: must not be given, since"):
            made()
    # The usual tolerances are those that are documented.
    for usual, given in (
        (carom.Contact(HERTZ, 0.3), carom.Contact(HERTZ, 0.3, tolerance=1e-3)),
        (carom.Contacts(1, HERTZ, 0.3), carom.Contacts(1, HERTZ, 0.3, tolerance=1e-2)),
    ):
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            paths = [np.asarray(one.follow(*(path[None] if isinstance(one, carom.Contacts) else path for path in (ZETA, XI, ETA)))) for one in (usual, given)]
        assert (paths[0] == paths[1]).all()
