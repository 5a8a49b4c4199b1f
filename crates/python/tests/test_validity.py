"""Results outside the theory are told through `warnings`."""

import pickle
import warnings

import numpy as np
import pytest

import carom

RUBBER = carom.Material(1e6, 0.49)


def ball(speed):
    return carom.sphere(0.03, RUBBER, 0.057, velocity=(0, 0, -speed))


def test_a_large_contact_warns_where_it_is_computed():
    with pytest.warns(carom.OutsideTheoryWarning, match="large contact: a/R exceeds 0.1") as told:
        rebound = carom.collide(ball(5.0), carom.plane(carom.RIGID), friction=0.5)
    assert len(told) == 1 and told[0].filename == __file__
    outside, *others = str(told[0].message).splitlines()
    assert outside.startswith("OUTSIDE THE THEORY: the approach exceeds a tenth") and "it is 0.2" in outside
    assert outside.endswith("are approximate.")
    # The approach is told once, as outside the theory.
    of_rebound = rebound.warnings.split("; ")
    assert others == [text for text in of_rebound if not text.startswith("the approach")] != of_rebound


def test_a_wrong_unit_is_suspected():
    soft = carom.Material(208.0, 0.3)  # GPa, taken for Pa
    with pytest.warns(carom.OutsideTheoryWarning, match="meaningless. Is a unit wrong"):
        carom.collide(carom.sphere(0.03, soft, 0.057, velocity=(0, 0, -5)), carom.plane(carom.RIGID), 0.5)


def test_many_impacts_warn_once_with_their_number():
    slow = np.array([[0, 0, -1e-3], [0, 0, -5.0], [0, 0, -6.0]])
    with pytest.warns(carom.OutsideTheoryWarning, match="2 of 3 impacts concerned, the worst at entry 2") as told:
        carom.collide_many(ball(1.0), carom.plane(carom.RIGID), 0.5, body_1_velocity=slow)
    assert len(told) == 1


def test_within_the_theory_nothing_is_told():
    steel = carom.Material(208e9, 0.3)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ball = carom.sphere(0.01, steel, 0.033, velocity=(0.1, 0, -0.2))
        carom.collide(ball, carom.plane(steel), 0.15)


def test_yield_is_outside_the_theory_and_a_small_loss_is_not():
    steel = carom.Material(208e9, 0.3, yield_stress=1e9)
    # Johnson: a sphere of hard steel yields from 0.14 m/s on.
    for speed, category in ((0.137, None), (0.14, carom.OutsideTheoryWarning)):
        ball = carom.sphere(0.01, steel, 7850 * 4 / 3 * np.pi * 0.01**3, velocity=(0, 0, -speed))
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            carom.collide(ball, carom.plane(steel), 0.15)
        assert [warning.category for warning in told] == ([category] if category else [])
        assert all("yields: the greatest pressure exceeds 1.6 times" in str(warning.message) for warning in told)
    elastic = carom.Material(208e9, 0.3)
    ball = carom.sphere(0.01, elastic, 0.033, velocity=(0, 0, -3))
    with pytest.warns(carom.CaromWarning, match="elastic waves would carry away more than 1 %") as told:
        carom.collide(ball, carom.plane(elastic), 0.15)
    assert told[0].category is carom.CaromWarning


def test_a_history_and_a_contact_on_a_grid_warn(tmp_path):
    for kind, compute in (("history", carom.cases.history), ("solve", carom.cases.solve)):
        path = tmp_path / f"{kind}.toml"
        path.write_text(carom.cases.new(kind).replace("young_modulus = 208e9", "hardness = 1e6\nyoung_modulus = 208e9"))
        with pytest.warns(carom.OutsideTheoryWarning, match="yields: "):
            compute(path)


def test_a_yield_stress_belongs_to_a_material():
    steel = carom.Material(208e9, 0.3, yield_stress=1e9)
    assert steel != carom.Material(208e9, 0.3) and pickle.loads(pickle.dumps(steel)) == steel
    assert repr(steel) == "Material(young_modulus=208000000000.0, poisson=0.3, yield_stress=1000000000.0)"
    with pytest.raises(carom.RangeError, match="yield_stress"):
        carom.Material(208e9, 0.3, yield_stress=0)


def test_a_case_of_many_impacts_warns(tmp_path):
    case = carom.cases.new("impact").replace("velocity = [0.25, 0, -0.5]", "velocity = [0.25, 0, [-100, -200]]", 1)
    path = tmp_path / "fast.toml"
    path.write_text(case)
    with pytest.warns(carom.OutsideTheoryWarning, match="impacts"):
        carom.cases.impact(path)
