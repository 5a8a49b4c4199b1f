"""Every public function that computes a contact says where it leaves the theory, with the words of the command."""

import copy
import warnings

import carom
import numpy as np
import pytest
from every_call import CALLS, public

#: Yields at a touch.
LEAD = carom.Material(16e9, 0.44, yield_stress=1e6)
PAIR = carom.MaterialPair(LEAD)
RUBBER = carom.Material(1e6, 0.49)
SPHERES = carom.hertz_of_spheres(0.01, float("inf"), RUBBER)
HARD = carom.hertz_of_spheres(0.01, float("inf"), LEAD)
BALL = carom.sphere(0.03, RUBBER, 0.057, velocity=(0.1, 0, -5))
FLOOR = carom.plane(carom.RIGID)
X, Y = carom.cells((24, 24), (2.6e-4, 2.6e-4))
GAP = (X**2 + Y**2) / 0.02
WINDOW = (GAP, (2.6e-4, 2.6e-4), PAIR)


def case(tmp_path, kind):
    """The first case of a kind, of a metal that yields."""
    path = tmp_path / f"{kind}.toml"
    lines = (line for line in carom.cases.new(kind).splitlines() if not line.startswith("yield_stress"))
    path.write_text("\n".join(lines).replace("young_modulus = 208e9", "hardness = 1e5\nyoung_modulus = 208e9"))
    return path


def scene(tmp_path):
    path = tmp_path / "scene.toml"
    text = carom.cases.new("scene")
    path.write_text(text.replace("velocity = [0.25, 0, -0.5]", "velocity = [0.25, 0, -200]"))
    return carom.cases.scene(path)


#: A call of each far outside the theory.
OUTSIDE = {
    "Contact.advance": lambda _: carom.Contact(SPHERES, 0.3).advance(5e-3),
    "Contact.follow": lambda _: carom.Contact(SPHERES, 0.3).follow([1e-3, 5e-3, 1e-9]),
    "Contacts.advance": lambda _: carom.Contacts(3, SPHERES, 0.3).advance([1e-9, 4e-3, 5e-3]),
    "Contacts.follow": lambda _: carom.Contacts(3, SPHERES, 0.3).follow(np.array([1e-3, 5e-3, 1e-9])),
    "GrainContacts.step": lambda _: carom.GrainContacts(2, (0.01, 0.01), RUBBER, 0.3).step(1e-6, [0.0, 0.0, 0.015]),
    "ShiftTwist.advance": lambda _: carom.ShiftTwist(SPHERES, 0.3).advance(5e-3),
    "Twist.advance": lambda _: carom.Twist(SPHERES, 0.3).advance(5e-3),
    "collide": lambda _: carom.collide(BALL, FLOOR, 0.5),
    "collide_many": lambda _: carom.collide_many(BALL, FLOOR, [0.1, 0.5]),
    "history": lambda _: carom.history(BALL, FLOOR, 0.5),
    "hertz": lambda _: carom.hertz(HARD, force=[1.0, 2.0]),
    "creep_force": lambda _: carom.creep_force(HARD, 0.3, F_z=10.0),
    "fastsim": lambda _: carom.fastsim(HARD, 0.3, F_z=10.0),
    "line_contact": lambda _: carom.line_contact(LEAD, 5e-3, 20e-3, force=1e3),
    "stress": lambda _: carom.stress((1e-3, 1e-3), LEAD, 1e9, 0.0, 0.0, 1e-3),
    "roll": lambda _: carom.roll(*WINDOW, 0.3, F_z=1.0),
    "cases.hertz": lambda path: carom.cases.hertz(case(path, "hertz")),
    "cases.history": lambda path: carom.cases.history(case(path, "history")),
    "cases.impact": lambda path: carom.cases.impact(case(path, "impact")),
    "cases.roll": lambda path: carom.cases.roll(case(path, "roll")),
    "cases.scene": scene,
    "cases.solve": lambda path: carom.cases.solve(case(path, "solve")),
    "cases.stress": lambda path: carom.cases.stress(case(path, "stress")),
    "rebound_derivatives": lambda _: carom.rebound_derivatives(BALL, FLOOR, 0.3),
    "Solver.step": lambda _: carom.Solver(*WINDOW, 0.3).step(F_z=1.0),
}
MADE, TOLD, PURE = "loads nothing", "reads what a step has told of", "has no sizes and no loads, only ratios"
#: Why the others need not.
NEED_NOT = {
    **dict.fromkeys("Body Body.moving Contact Contacts GrainContacts Hertz Hertz.of_radii Material MaterialPair Plate RestitutionBySpeed RestitutionBySpeed.at ShiftTwist".split(), MADE),
    **dict.fromkeys("SlipSpeedFriction SlipSpeedFriction.at Solver Surface Surface.measures Surface.prepared Surface.warnings TriangleMesh TriangleMesh.places Twist cells hertz_of_spheres surface plane sphere cases.new".split(), MADE),
    **dict.fromkeys("Contact.traction Contact.turn_frame Solver.summary Solver.stress von_mises cases.Stresses.to_xarray".split(), TOLD),
    **dict.fromkeys("plot.history plot.loop plot.pressure plot.stick_slip plot.tractions".split(), TOLD),
    **dict.fromkeys("creep_coefficients lubkin_torque lubkin_stick_radius plot.restitution".split(), PURE),
    **dict.fromkeys("restitution restitution_of_dissimilar restitution_of_groups".split(), PURE),
    **{name: "mathematics" for name in CALLS if name.startswith("special.")},
    **dict.fromkeys("CaromError CaromWarning OutsideTheoryWarning RangeError".split(), "computes nothing"),
    "fit": "tells of the data, not of each impact",
    "cases.shell": "is no contact; it has warnings of its own",
}


def test_everything_public_is_listed_once():
    names = [name for name, _ in public()]
    assert sorted(names) == sorted([*OUTSIDE, *NEED_NOT])


@pytest.mark.parametrize("name", OUTSIDE)
def test_outside_the_theory_each_warns_once_where_it_is_called(name, tmp_path):
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        OUTSIDE[name](tmp_path)
    outside = [one for one in told if one.category is carom.OutsideTheoryWarning]
    assert len(outside) == 1 and outside[0].filename == __file__
    assert any(word in str(outside[0].message) for word in ("yields: ", "OUTSIDE THE THEORY", "large contact", "E*"))


@pytest.mark.parametrize("scale, large", [(0.9, False), (1.1, True)])
def test_a_contact_on_a_grid_is_told_at_the_pressure_of_a_large_round_one(scale, large):
    # Hertz: a/R = .1 at zeta = R/100, R = 10 mm.
    x, y = carom.cells((32, 32), (2.6e-3, 2.6e-3))
    window = ((x**2 + y**2) / 0.02, (2.6e-3, 2.6e-3), carom.MaterialPair(RUBBER), 0.3)
    zeta = 1e-4 * scale
    force = 4 / 3 * 1e6 / (2 * (1 - 0.49**2)) * 0.01**0.5 * zeta**1.5
    for call in (lambda: carom.Solver(*window).step(zeta=zeta), lambda: carom.roll(*window, F_z=force)):
        assert any("exceeds .064 E*" in text for text in told_by(call)) == large


def told_by(call):
    """The texts of all warnings of a call."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        call()
    return [str(one.message) for one in told]


def contacts(law):
    """A contact, and three of them, with what advances them."""
    many = carom.Contacts(3, SPHERES, 0.3, law=law)
    yield carom.Contact(SPHERES, 0.3, law=law).advance
    yield lambda zeta: many.advance([zeta, 1e-9, 0.0])
    if law == "coulomb":
        yield carom.Twist(SPHERES, 0.3).advance
        yield carom.ShiftTwist(SPHERES, 0.3).advance


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction", "rings"])
def test_in_a_loop_each_limit_is_told_once(law):
    # A rigid plane is dissimilar: what the law neglects is told at the first touch. a = sqrt(R zeta).
    radius = SPHERES.smallest_radius
    for advance in contacts(law):
        told = told_by(lambda: [advance(zeta) for zeta in np.linspace(0.0, 0.2 * radius, 400)])
        kinds = [[word for word in ("large contact", "the approach exceeds") if word in text] for text in told]
        assert sum(kinds, []) == ["large contact", "the approach exceeds"], told


@pytest.mark.parametrize("law", ["coulomb", "rings"])
def test_a_limit_is_told_where_it_is_exceeded_and_not_before(law):
    radius = SPHERES.smallest_radius
    for limit, word in ((0.01 * radius, "large contact: a/R exceeds 0.1"), (0.1 * radius, "the approach exceeds a tenth")):
        for first, second in zip(contacts(law), contacts(law)):
            assert not any(word in text for text in told_by(lambda: first(limit * (1 - 1e-9))))
            assert any(word in text for text in told_by(lambda: second(limit * (1 + 1e-9))))
    # Hertz: p = 2 E* sqrt(zeta R)/(pi R), and lead yields at 1.6 Y.
    modulus = 16e9 / (2 * (1 - 0.44**2))
    yields = (1.6e6 * np.pi / (2 * modulus)) ** 2 * 0.01
    contact = carom.Contact(HARD, 0.3, law=law)
    assert told_by(lambda: contact.advance(yields * (1 - 1e-9))) == []
    assert "yields: " in told_by(lambda: contact.advance(yields * (1 + 1e-9)))[0]
    assert told_by(lambda: contact.advance(yields * 2)) == []


def test_what_is_told_is_what_the_command_tells(tmp_path):
    path = case(tmp_path, "hertz")
    states = None
    with pytest.warns(carom.OutsideTheoryWarning) as of_case:
        states = carom.cases.hertz(path)
    lens = carom.hertz_of_spheres
    assert lens and len(states) > 1
    text = path.read_text()
    assert "hardness = 1e5" in text
    steel = carom.Material(208e9, 0.3, yield_stress=1e5 / 2.8)
    other = carom.hertz_of_spheres(0.01, float("inf"), steel)
    with pytest.warns(carom.OutsideTheoryWarning) as of_call:
        carom.hertz(other, force=states.force)
    endings = [str(told[0].message).split("exceeds")[0] for told in (of_case, of_call)]
    assert endings[0] == endings[1]


def test_arrays_tell_the_number_of_entries():
    with pytest.warns(carom.OutsideTheoryWarning, match=r"2 of 3 loads concerned, the worst at 2 N"):
        carom.hertz(HARD, force=[1e-9, 1.0, 2.0])
    with pytest.warns(carom.OutsideTheoryWarning, match=r"OUTSIDE THE THEORY at 2 of 3 contacts"):
        carom.Contacts(3, SPHERES, 0.3).advance([1e-9, 4e-3, 5e-3])


def test_radii_are_those_of_the_bodies_also_after_pickling():
    import pickle

    cavity = carom.hertz_of_spheres(0.005, -0.005001, carom.Material(210e9, 0.3))
    assert cavity.smallest_radius == 0.005
    for hertz in (cavity, pickle.loads(pickle.dumps(cavity)), eval(repr(cavity), vars(carom))):
        with pytest.warns(carom.OutsideTheoryWarning, match=r"large contact: .* it is 0\.\d+"):
            carom.hertz(hertz, force=500.0)
    # Of a gap alone it is that of a body on a plane.
    assert carom.Hertz(PAIR, 50.0, 25.0).smallest_radius == 0.01
    with pytest.raises(carom.RangeError, match="smallest_radius"):
        carom.Hertz(PAIR, 50.0, 25.0, 0.0)


def test_neglected_coupling_is_told_at_the_first_touch():
    pair = carom.MaterialPair(carom.RIGID, carom.Material(70e9, 0.22))
    hertz = carom.Hertz.of_radii(pair, (0.01, 0.01), (float("inf"), float("inf")), 0.0)
    for law, count in (("coulomb", 1), ("rings", 0)):
        contact = carom.Contact(hertz, 0.3, law=law)
        assert told_by(lambda: contact.advance(-1.0)) == []
        told = told_by(lambda: [contact.advance(1e-9) for _ in range(3)])
        assert len(told) == count and all("dissimilar materials" in text for text in told)


@pytest.mark.filterwarnings("error")
def test_a_warning_raised_as_an_error_leaves_the_contact_as_it_was():
    for made, advance in (
        (carom.Contact(SPHERES, 0.3, law="rings"), lambda one: one.advance(5e-3)),
        (carom.Contact(SPHERES, 0.3, law="rings"), lambda one: one.follow([5e-3])),
        (carom.Contacts(2, SPHERES, 0.3, law="rings"), lambda one: one.advance(5e-3)),
        (carom.ShiftTwist(SPHERES, 0.0), lambda one: one.advance(5e-3)),
        (carom.Solver(*WINDOW, 0.3), lambda one: one.step(F_z=1.0)),
    ):
        before = str(copy.copy(made).__getstate__() if not isinstance(made, carom.Contacts) else made.loads)
        for _ in range(2):
            with pytest.raises(carom.CaromWarning):
                advance(made)
        after = made.loads if isinstance(made, carom.Contacts) else made.__getstate__()
        assert str(after) == before
