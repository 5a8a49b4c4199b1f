"""Results as objects: equality, selection, texts, names of axes."""

import copy
import inspect
import json
import pickle

import carom
import numpy as np
import pytest

STEEL = carom.Material(208e9, 0.3)
BALL = carom.sphere(0.01, STEEL, 0.033, velocity=(1.0, 0, -0.2))
PLATE = carom.plane(STEEL)
HERTZ = carom.hertz_of_spheres(0.01, 0.02, STEEL)


def many(count=400):
    velocities = np.zeros((count, 3)) - (0, 0, 0.2)
    velocities[:, 0] = np.linspace(0.0, 1.0, count)
    return carom.collide_many(BALL, PLATE, 0.15, body_1_velocity=velocities)


def solver():
    x, y = carom.cells((24, 24), (2.6e-4, 2.6e-4))
    return carom.Solver((x**2 + y**2) / 0.02, (2.6e-4, 2.6e-4), carom.MaterialPair(STEEL), 0.3)


def results():
    away = carom.collide(BALL.moving((0, 0, 1)), PLATE, 0.15)
    return [
        away,
        carom.collide(BALL, PLATE, 0.15),
        many(7),
        carom.history(BALL, PLATE, 0.15, 11),
        carom.hertz(HERTZ, force=1.0),
        carom.hertz(HERTZ, force=[[1.0, 2.0], [3.0, 4.0]]),
        solver().step(F_z=2.0),
        carom.restitution_of_dissimilar(1.2, [1.0, 2.0], 0.1, 0.2),
    ]


@pytest.mark.parametrize("result", results(), ids=lambda result: type(result).__name__)
def test_a_copy_is_equal_even_where_it_is_nan_and_another_is_not(result):
    for other in (pickle.loads(pickle.dumps(result)), copy.copy(result), copy.deepcopy(result)):
        assert other == result and not other != result
    name, values = next((n, v) for n, v in result._values().items() if not isinstance(v, (str, list)))
    changed = type(result)({**result.to_dict(), name: np.nan_to_num(values) + np.ones_like(values)})
    assert changed != result and result != "a text" and result != result.to_dict()
    with pytest.raises(AttributeError, match="cannot be changed"):
        setattr(result, name, 0.0)


def test_one_of_many_is_the_one_computed_alone():
    rebounds = many(7)
    assert len(rebounds) == 7 and rebounds.shape == (7,)
    alone = carom.collide(BALL.moving((0.5, 0, -0.2)), PLATE, 0.15)
    assert rebounds[3] == alone and rebounds[-4] == alone and list(rebounds)[3] == alone
    assert isinstance(rebounds[3], carom.Rebound) and type(rebounds[3].R_x) is float
    some = rebounds[rebounds.maximal_force > 0][1:3]
    assert isinstance(some, carom.Rebounds) and some.regimes == rebounds.regimes[1:3]
    assert np.array_equal(some.body_1_velocity, rebounds.body_1_velocity[1:3])
    with pytest.raises(IndexError):
        rebounds[7]
    states = carom.hertz(HERTZ, force=[[1.0, 2.0], [3.0, 4.0]])
    assert states[1, 0].force == 3.0 and states[1].shape == (2,)
    found = carom.restitution_of_dissimilar([[1.2], [1.3]], [1.0, 12.0], 0.1, 0.2)
    assert found[1, 0].method == "table" and found[0, 1].method == "rings"


def test_whole_numbers_are_integers():
    step = solver().step(F_z=2.0)
    assert type(step.step) is int and step.step == 1
    assert many(3).compressions.dtype == np.int64
    assert type(carom.collide(BALL, PLATE, 0.15).compressions) is int


def test_an_impact_that_does_not_happen_says_so_and_nothing_else():
    away = carom.collide(BALL.moving((0, 0, 1)), PLATE, 0.15)
    assert away.outcome == "no_impact" and "no_impact" in repr(away) and "nan" not in repr(away)


def test_the_text_of_no_impact_says_how_the_bodies_move_and_what_to_do():
    up = BALL.moving((0.3, 0, 0.5))
    for away in (carom.collide(up, PLATE, 0.15), carom.history(up, PLATE, 0.15)):
        for text in (repr(away), repr(pickle.loads(pickle.dumps(away)))):
            assert "move apart at 0.5 m/s along the normal (0, 0, 1), which points from body 2 into body 1" in text
            assert "exchange the bodies, or change the sign of a velocity" in text
    assert "move apart at 0.5 m/s" in carom.collide(up, PLATE, 0.15)._repr_html_()
    beside = carom.collide(BALL.moving((0.3, 0, 0)), PLATE, 0.15)
    assert "no impact: the bodies have no speed along the normal (0, 0, 1)" in repr(beside)
    assert "no impact" not in repr(carom.collide(BALL.moving((0, 0, -1)), PLATE, 0.15))


@pytest.mark.parametrize("result", results(), ids=lambda result: type(result).__name__)
def test_a_text_is_short_and_tells_units(result):
    lines = repr(result).splitlines()
    assert lines[0].split()[0] == type(result).__name__
    # A step of the solver has twelve errors beside its values.
    assert len(lines) <= 36 and max(map(len, lines)) < 150
    assert "nan" not in repr(result)
    html = result._repr_html_()
    assert html.startswith("<table>") and "nan" not in html


def test_texts_of_many_show_the_first_and_the_last():
    text = repr(many())
    line = next(line for line in text.splitlines() if line.strip().startswith("contact_velocity_before"))
    assert line.split(None, 1)[1] == "[[0 0 0.2] ... [-1 0 0.2]] m/s"
    html = many()._repr_html_()
    assert html.count("<tr>") == 1 + 5 + 1 + 5 and "<th>399</th>" in html and "<th>200</th>" not in html


def test_objects_show_what_makes_them_anew():
    turned = carom.Body("box", [0.1, 0.2, 0.3], STEEL, 2.0, attitude=(0.6, 0.8, 0, 0), centre=(0, 0, 1), spin=(1, 2, 3))
    shell = carom.sphere(0.03, carom.Material(shear_modulus=1 / 3, poisson=0.5), 0.1, hollow=True)
    plate = carom.Plate(0.4, 0.3, 0.004, "sum")
    long = carom.Material(shear_modulus=80e9 / 3, poisson=0.3)
    for thing in (STEEL, long, carom.RIGID, carom.MaterialPair(STEEL, carom.RIGID), HERTZ, BALL, PLATE, turned, shell, plate):
        assert eval(repr(thing), {**vars(carom), "inf": float("inf")}) == thing, repr(thing)
        assert "<table>" in thing._repr_html_()
    assert repr(STEEL) == "Material(young_modulus=208000000000.0, poisson=0.3)"
    contact = carom.Contact(HERTZ, 0.3)
    assert repr(contact) == "Contact(separated, F = (0.0, 0.0, 0.0) N)"
    assert "regime" in contact._repr_html_()


def test_a_solver_and_contacts_show_their_state():
    solving = solver()
    assert "24 x 24" in repr(solving) and "<table>" in solving._repr_html_()
    solving.step(F_z=2.0)
    assert "F_z" in repr(solving) and " 2 N" in repr(solving)
    contacts = carom.Contacts(5, HERTZ, 0.3, directions=1)
    for text in (repr(contacts), contacts._repr_html_()):
        assert "coulomb" in text and "0.3" in text and "count" in text


def test_signatures_are_those_of_python():
    for kind in (carom.Body, carom.Contact, carom.Material, carom.MaterialPair, carom.Plate, carom.Twist):
        for thing in (kind, *(member for name, member in vars(kind).items() if callable(member) and name[0] != "_")):
            defaults = (p.default for p in inspect.signature(thing).parameters.values())
            assert all(default is not Ellipsis for default in defaults), thing
    assert inspect.signature(carom.Body).parameters["mass"].default is None
    assert carom.Body("sphere", [0.1], STEEL).mass == float("inf")


def test_axes_have_names():
    pytest.importorskip("xarray")
    assert many(7).to_xarray()["R_x"].dims == ("impact",)
    course = carom.history(BALL, PLATE, 0.15, 11).to_xarray()
    assert course["F"].dims == ("time", "axis") and "time" in course.indexes
    assert carom.hertz(HERTZ, force=[[1.0, 2.0], [3.0, 4.0]]).to_xarray()["force"].dims == ("load_0", "load_1")
    found = carom.restitution_of_dissimilar([[1.2], [1.3]], [1.0, 12.0], 0.1, 0.2).to_xarray()
    assert found["method"].dims == ("impact_0", "impact_1") and found["method"].values[0, 1] == "rings"
    assert many(7).to_pandas().index.name == "impact"


@pytest.mark.parametrize("result", results(), ids=lambda result: type(result).__name__)
def test_a_result_cannot_be_changed_in_place_and_is_taken_by_json(result):
    for name, values in result._values().items():
        if isinstance(values, np.ndarray):
            with pytest.raises(ValueError, match="read-only"):
                values[...] = 0
        assert json.loads(json.dumps(result.to_dict()))[name] is not Ellipsis
    with pytest.raises(AttributeError, match="has no R_y"):
        _ = result.R_y


def test_an_old_name_tells_the_new_one():
    steel = carom.Material(208e9, 0.3)
    ball = carom.sphere(0.01, steel, mass=0.03, velocity=(0.1, 0, -0.2))
    rebound = carom.collide(ball, carom.plane(steel), 0.2)
    with pytest.raises(AttributeError, match="Rebound.maximal_pressure is now called peak_pressure"):
        _ = rebound.maximal_pressure
    with pytest.raises(AttributeError, match="did you mean `peak_pressure`"):
        _ = rebound.peak_presure
    assert not hasattr(rebound, "anything")
