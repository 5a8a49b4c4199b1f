"""Arguments of wrong kind, shape or size: an error that names them, and never the end of the process."""

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import carom

RUBBER = carom.Material(5e6, 0.5)
BALL = carom.sphere(0.02, RUBBER, 0.037, velocity=(1, 0, -3))
FLOOR = carom.plane(carom.RIGID)
HERTZ = carom.hertz_of_spheres(0.01, 0.01, RUBBER)
PAIR = carom.MaterialPair(RUBBER)


def contacts():
    return carom.Contacts(3, HERTZ, 0.3)


NO_NUMBERS = [
    "x",
    True,
    np.array([True, False, True]),
    [True, 0.3],
    b"1",
    np.array([1 + 2j]),
    np.array(["1"]),
    object(),
    {},
    10**400,
    [[1.0], [1.0, 2.0]],
    np.array([3], "m8[s]"),
    np.ma.masked_array([1.0, 2.0, 3.0], mask=[0, 1, 0]),
]
CALLS = {
    "zeta": lambda x: contacts().advance(x),
    "xi": lambda x: contacts().advance(1e-6, x),
    "eta": lambda x: contacts().follow(1e-6, 0.0, x),
    "friction": lambda x: carom.collide_many(BALL, FLOOR, x),
    "body_1_velocity": lambda x: carom.collide_many(BALL, FLOOR, 0.5, body_1_velocity=x),
    "body_2_spin": lambda x: carom.collide_many(BALL, FLOOR, 0.5, body_2_spin=x),
    "gap": lambda x: carom.Solver(x, (1.0, 1.0), PAIR, 0.3),
    "size": lambda x: carom.Solver(np.zeros((4, 4)), x, PAIR, 0.3),
    "force": lambda x: carom.hertz(HERTZ, force=x),
    "stress": carom.von_mises,
    "y": lambda x: carom.stress((1.0, 1.0), RUBBER, 1.0, 0.0, x, 1.0),
    "lam": lambda x: carom.restitution(1.2, x),
    "axis_ratio": carom.special.k,
    "path": lambda x: carom.Contact(HERTZ, 0.3).follow([1e-6], x),
}


@pytest.mark.parametrize("name", CALLS)
@pytest.mark.parametrize("wrong", NO_NUMBERS, ids=lambda wrong: str(wrong)[:12])
def test_what_is_no_number_is_named(name, wrong):
    with pytest.raises(ValueError, match=f"^{'xi' if name == 'path' else name}: must be"):
        CALLS[name](wrong)


@pytest.mark.parametrize("name", ["zeta", "xi", "body_1_velocity", "body_2_spin", "size", "gap"])
@pytest.mark.parametrize("shape", [(0,), (2,), (5,), (3, 0), (3, 1), (2, 2, 2)])
def test_a_wrong_shape_is_named(name, shape):
    if (name, shape) in (("size", (2,)), ("gap", (3, 1))):
        return
    with pytest.raises(ValueError, match=rf"^({name}|nx)\b"):
        CALLS[name](np.ones(shape))


@pytest.mark.parametrize("many", [-1, 10**15, 2**63, 10**30])
def test_more_than_the_memory_holds_is_refused(many):
    for name, call in {
        "count": lambda: carom.Contacts(many, HERTZ, 0.3),
        "points": lambda: carom.history(BALL, FLOOR, 0.5, many),
        "shape": lambda: carom.cells((many, 1), (1.0, 1.0)),
    }.items():
        with pytest.raises(carom.RangeError) as told:
            call()
        assert (told.value.field, told.value.value) == (name, float(many))


def in_its_own_process(program):
    """Runs a program in an interpreter of its own; what it prints at its end."""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert done.returncode == 0, (done.returncode, done.stderr)
    return done.stdout.strip()


@pytest.mark.skipif(not Path("/proc/meminfo").exists(), reason="there is no system that tells of memory")
def test_contacts_for_twice_the_free_memory_are_refused_and_the_interpreter_lives():
    # A contact of two directions takes more than 1000 bytes.
    program = """if True:
        import carom
        free = next(line for line in open("/proc/meminfo") if line.startswith("MemAvailable:"))
        many = 2 * 1024 * int(free.split()[1]) // 1000
        try:
            carom.Contacts(many, (1e9, 1e9, 1.2e9), 0.3)
        except carom.RangeError as error:
            print(error.field, error.value == many)
        """
    assert in_its_own_process(program) == "count True"


@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="there is no limit to set")
def test_contacts_beyond_the_limit_of_the_process_are_refused_and_the_interpreter_lives():
    program = """if True:
        import copy, resource
        import carom
        size = next(line for line in open("/proc/self/status") if line.startswith("VmSize:"))
        limit = 1024 * int(size.split()[1]) + (1 << 30)
        resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
        stiffness = (1e9, 1e9, 1.2e9)
        held = carom.Contacts(400_000, stiffness, 0.3)
        refused = []
        for take in (
            lambda: carom.Contacts(1_000_000, stiffness, 0.3),
            lambda: carom.Contacts(4_000_000, stiffness, 0.3, directions=1),
            lambda: copy.copy(held),
            lambda: copy.deepcopy(held),
            lambda: carom.cells((10_000, 10_000), (1.0, 1.0)),
            lambda: carom.history(
                carom.sphere(0.02, carom.RIGID, 0.037, velocity=(1, 0, -3)),
                carom.plane(carom.Material(5e6, 0.5)), 0.5, 10_000_000
            ),
        ):
            try:
                take()
            except carom.RangeError as error:
                refused.append(error.field)
        print(*refused, held.advance(1e-6).shape)
        """
    assert in_its_own_process(program) == "count count count count shape points (400000, 3)"


def test_any_layout_of_an_array_is_the_same():
    zeta = np.linspace(1e-7, 1e-6, 6)
    expected = carom.Contacts(3, HERTZ, 0.3).advance(zeta[::2], 1e-8)
    for same in (zeta[::2].copy(), list(zeta[::2]), zeta[::2].astype(">f8"), np.asfortranarray(zeta.reshape(3, 2))[:, 0]):
        assert np.array_equal(carom.Contacts(3, HERTZ, 0.3).advance(same, 1e-8), expected)
    assert carom.Contacts(0, HERTZ, 0.3).advance([]).shape == (0, 3)
    assert contacts().follow(np.zeros((3, 0))).shape == (3, 0, 3)
    assert carom.restitution(1.2, []).shape == (0,)


def test_a_motion_is_no_number():
    with pytest.raises(ValueError, match=r"body_1_velocity has the shape \(\)"):
        carom.collide_many(BALL, FLOOR, 0.5, body_1_velocity=-1.0)


@pytest.mark.parametrize("field", ["velocity", "spin"])
def test_a_motion_out_of_range_is_refused_where_it_is_given(field):
    for make in (BALL.moving, lambda **given: carom.Body("sphere", [0.02], RUBBER, 0.037, **given)):
        with pytest.raises(carom.RangeError) as told:
            make(**{field: (0.0, 1e300, 0.0)})
        assert (told.value.field, told.value.value) == (field, 1e300)


def test_a_path_is_as_long_as_it_is():
    with pytest.raises(ValueError, match="xi has 0 entries"):
        carom.Contact(HERTZ, 0.3).follow([1e-6], [])
    with pytest.raises(ValueError, match=r"zeta has the shape \(\)"):
        carom.Contact(HERTZ, 0.3).follow(1e-6)


def test_a_body_held_fast_has_neither_mass_nor_moments():
    for mass in (3.0, -3.0, np.nan):
        with pytest.raises(carom.RangeError, match="^mass = .* inf for a plane"):
            carom.Body("plane", [], RUBBER, mass)
    with pytest.raises(ValueError, match="moments"):
        carom.Body("sphere", [0.1], RUBBER, moments=(1.0, 1.0, 1.0))


def test_loads_are_not_written_into_the_path():
    out = np.full((3, 1, 3), 1e-6)
    for wrong in ([0.0], np.empty((3, 1, 2))):
        with pytest.raises(ValueError, match="^out: must be"):
            contacts().follow(1e-6, out=wrong)
    with pytest.raises(ValueError, match="^out: must not share memory"):
        contacts().follow(out.reshape(-1)[:3].reshape(3, 1), out=out)


@pytest.mark.parametrize("size", [(np.nan, 1.0), (-1.0, 1.0), (1.0, np.inf), (0.0, 1.0)])
def test_cells_have_a_size(size):
    with pytest.raises(ValueError, match="^size: must be"):
        carom.cells((2, 2), size)


def test_other_words():
    with pytest.raises(ValueError, match="directions = -1"):
        carom.Contacts(3, HERTZ, 0.3, directions=-1)
    with pytest.raises(TypeError, match="wave_loss"):
        carom.collide(BALL, FLOOR, 0.3, normal_restitution=None)
    for parts in ([1.0] * 5, 1.0):
        with pytest.raises(ValueError, match="^stress has the shape"):
            carom.von_mises(parts)


@pytest.mark.parametrize("wrong", [None, 3, "ball"])
def test_what_is_no_body_is_named(wrong):
    for call in (carom.collide, carom.collide_many, carom.history):
        with pytest.raises(TypeError, match="^body_2: must be a Body"):
            call(BALL, wrong, 0.5)
        with pytest.raises(TypeError, match="^body_1: must be a Body"):
            call(wrong, FLOOR, 0.5)


@pytest.mark.parametrize(
    ("call", "told"),
    [
        (lambda: carom.collide(BALL, FLOOR, mu=0.2), "collide() has no argument `mu`, did you mean `friction`?"),
        (lambda: carom.collide(BALL, FLOOR, 0.2, restitution=0.8), "did you mean `normal_restitution`?"),
        (lambda: carom.restitution(1.2, lambda_=3.0), "did you mean `lam`? It takes kappa, lam, gamma"),
        (lambda: carom.sphere(diameter=0.02, material=RUBBER, mass=1.0), "did you mean `radius`, half of it?"),
        (lambda: carom.sphere(0.01, RUBBER, colour=7850), "sphere() has no argument `colour`. It takes radius"),
        (lambda: carom.sphere(0.01, RUBBER), "sphere() needs `mass` or `density`"),
        (lambda: carom.Material(E=208e9, nu=0.3), "Material() has no argument `E`, did you mean `young_modulus`?"),
        (lambda: carom.Body("sphere", [0.01], RUBBER, omega=1), "Body() has no argument `omega`, did you mean `spin`?"),
        (lambda: carom.Contact(HERTZ, 0.3, mu=0.2), "Contact() has no argument `mu`, did you mean `friction`?"),
        (lambda: carom.Contacts(9, HERTZ, 0.3, mu=0.2), "Contacts() has no argument `mu`, did you mean `friction`?"),
        (lambda: carom.Contact(HERTZ, mu=0.2), "Contact() has no argument `mu`, did you mean `friction`?"),
        (lambda: carom.Contact(), "Contact() needs `stiffness` and `friction`. It takes stiffness, friction, law, "),
        (lambda: carom.Contact(HERTZ, 0.3).advance(z=1e-6), "Contact.advance() has no argument `z`, did you mean `zeta`?"),
        (lambda: carom.Contact(HERTZ, 0.3).advance(xi=1e-6), "Contact.advance() needs `zeta`. It takes zeta, xi, eta, omega"),
        (lambda: carom.Contact(HERTZ, 0.3).follow(z=[1e-6]), "Contact.follow() has no argument `z`, did you mean `zeta`?"),
        (lambda: carom.Contact(HERTZ, 0.3).traction(), "Contact.traction() needs `r`. It takes r"),
        (lambda: carom.Contact(HERTZ, 0.3).turn_frame(phi=1.0), "Contact.turn_frame() has no argument `phi`. It takes angle"),
        (lambda: carom.Plate(1.0, 1.0, h=0.01), "Plate() has no argument `h`, did you mean `thickness`? It takes a, b, thickness, theory"),
        (lambda: carom.Plate(1.0), "Plate() needs `b` and `thickness`. It takes a, b, thickness, theory"),
        (lambda: carom.Twist(HERTZ, mu=0.3), "Twist() has no argument `mu`, did you mean `friction`? It takes hertz, friction"),
        (lambda: carom.Twist(HERTZ, 0.3).advance(1e-6, w=0.1), "Twist.advance() has no argument `w`. It takes zeta, omega"),
        (lambda: carom.ShiftTwist(HERTZ), "ShiftTwist() needs `friction`. It takes hertz, friction"),
        (lambda: carom.ShiftTwist(HERTZ, 0.3).advance(), "ShiftTwist.advance() needs `zeta`. It takes zeta, xi, eta, omega"),
        (lambda: carom.Hertz(PAIR, 50.0), "Hertz() needs `curvature_b`. It takes materials, curvature_a, curvature_b, "),
        (lambda: carom.Hertz.of_radii(PAIR), "Hertz.of_radii() needs `radii_1`, `radii_2` and `angle`. It takes materials, "),
        (lambda: carom.Hertz.of_radii(PAIR, phi=0), "Hertz.of_radii() has no argument `phi`. It takes materials, radii_1, "),
        (lambda: carom.MaterialPair(), "MaterialPair() needs `material_1`. It takes material_1, material_2"),
        (lambda: carom.Body("sphere", [0.01]), "Body() needs `material`. It takes shape, sizes, material, mass, density, hollow, "),
        (lambda: carom.collide(BALL, FLOOR), "collide() needs `friction`. It takes body_1, body_2, friction, static_friction, "),
        (lambda: carom.sphere(0.01), "sphere() needs `material`. It takes radius, material, mass, "),
        (lambda: carom.Solver(np.zeros((4, 4))), "Solver() needs `size`, `materials` and `friction`. It takes "),
        (lambda: contacts().advance(), "Contacts.advance() needs `zeta`. It takes zeta, "),
        (lambda: contacts().advance(z=1e-6), "Contacts.advance() has no argument `z`, did you mean `zeta`?"),
        (lambda: carom.cases.roll("x", fast=True), "roll() has no argument `fast`, did you mean `fastsim`?"),
        (lambda: carom.hertz(HERTZ, 10.0), "hertz() takes contact by place, further arguments by name: force=.., "),
        (lambda: carom.Solver(np.zeros((4, 4)), (1, 1), "steel", 0.3), "materials: must be a MaterialPair or a Material, not str"),
        (lambda: carom.sphere(0.01, 208e9, 0.03), "material: must be a Material, not float"),
        (lambda: carom.Contacts(10.5, HERTZ, 0.3), "count: must be a whole number, not 10.5"),
        (lambda: carom.Material(208e9), "Material() needs `poisson`, Poisson's ratio, in (-1, 0.5]"),
        (lambda: carom.cases.impact(7), "case: must be the path of a case file, its text, or a dict, not int"),
        (lambda: carom.cases.impact(path="x"), "impact() has no argument `path`. It takes case"),
    ],
)
def test_a_call_that_does_not_fit_tells_what_is_meant(call, told):
    with pytest.raises(TypeError) as raised:
        call()
    assert told in str(raised.value)


def test_an_error_within_a_call_stays_as_it_is():
    with pytest.raises(TypeError, match=r"^points: must be a whole number, not 1.5$"):
        carom.history(BALL, FLOOR, 0.5, 1.5)


def test_one_material_stands_for_two_alike():
    made = [carom.Solver(np.zeros((4, 4)), (1.0, 1.0), given, 0.3) for given in (RUBBER, PAIR)]
    assert repr(made[0]) == repr(made[1])
    assert carom.Hertz(RUBBER, 50.0, 50.0) == carom.Hertz(PAIR, 50.0, 50.0)


UNUSUAL = {"shape": "sphere", "radius": 10, "density": 7.85, "material": {"young_modulus": 208, "poisson": 0.3}}


@pytest.mark.parametrize(
    "call, kind, words",
    [
        (lambda: carom.collide_many(BALL, FLOOR, 0.5, body_1_velocity=np.zeros((3, 7))), ValueError, ["(3, 7)", "(3,) or (n, 3)", "transpose it"]),
        (lambda: carom.collide_many(BALL, FLOOR, [0.1, 0.2], body_1_velocity=np.zeros((7, 3))), ValueError, ["body_1_velocity 7, friction 2"]),
        (lambda: carom.creep_force(HERTZ, 0.3, F_z=1.0, creepage=[1e-3, 2e-3], spin=[0.0, 1.0, 2.0]), ValueError, ["creepage (2,), spin (3,)"]),
        (lambda: carom.Contacts(100, HERTZ, 0.3).follow(np.zeros((5, 100))), ValueError, ["(5, 100)", "(100, steps)", "transpose it"]),
        (lambda: carom.hertz(BALL, force=10), TypeError, ["contact: must be a Hertz, not Body", "hertz_of_spheres"]),
        (lambda: carom.plot.pressure(carom.collide(BALL, FLOOR, 0.5)), TypeError, ["of: must be a Solver", "not Rebound"]),
        (lambda: carom.plot.history(carom.collide(BALL, FLOOR, 0.5)), TypeError, ["course: must be what carom.history", "not Rebound"]),
        (lambda: carom.cases.impact({"body_1": {"material": RUBBER}}), TypeError, ["`body_1.material` is a Material"]),
        (lambda: setattr(BALL, "velocity", (1, 0, 0)), AttributeError, ["velocity"]),
        (lambda: carom.collide(BALL, FLOOR, 0.5, wave_loss="no"), TypeError, ["wave_loss: must be True or False, not 'no'"]),
    ],
)
def test_what_is_meant_is_named(call, kind, words):
    with pytest.raises(kind) as told:
        call()
    for word in words:
        assert word in str(told.value), told.value


def test_vectors_of_a_body_cannot_be_changed():
    for name in ("velocity", "spin", "centre", "attitude"):
        assert isinstance(getattr(BALL, name), tuple)


def test_a_body_at_rest_is_told_to_move():
    said = str(carom.collide(carom.sphere(0.02, RUBBER, 0.037), FLOOR, 0.5))
    assert "have no speed along the normal" in said and "give a body a `velocity` along it" in said


def test_unusual_numbers_of_a_case_are_warned_of():
    case = {
        "body_1": UNUSUAL | {"velocity": [0, 0, -1]},
        "body_2": {"shape": "plane", "fixed": True, "material": UNUSUAL["material"]},
        "contact": {"friction": 17},
    }
    with pytest.warns(carom.CaromWarning) as told:
        carom.cases.impact(case)
    text = "\n".join(str(one.message) for one in told)
    for words in ("`body_1.radius` = 10 is unusual", "`body_1.density` = 7.85 is unusual", "`contact.friction` = 17 is unusual"):
        assert words in text


def test_a_window_that_has_no_size_is_named():
    with pytest.raises(carom.RangeError, match="size = -1 is out of range"):
        carom.Solver(np.zeros((3, 4)), (1, -1), PAIR, 0.3)
    with pytest.raises(ValueError, match=r"gap has the shape \(0, 4\)"):
        carom.Solver(np.zeros((0, 4)), (1, 1), PAIR, 0.3)
