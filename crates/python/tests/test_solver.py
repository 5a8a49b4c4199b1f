"""The numerical solver."""

import copy
import pickle
import warnings

import carom
import numpy as np
import pytest

STEEL = carom.Material(208e9, 0.3)
PAIR = carom.MaterialPair(STEEL)
SIZE = (2.6e-4, 2.6e-4)


def ball(n=48, **given):
    x, y = carom.cells((n, n), SIZE)
    return carom.Solver((x**2 + y**2) / 0.02, SIZE, given.pop("pair", PAIR), 0.3, **given)


def test_hertz():
    solver = ball(64)
    step = solver.step(F_z=10.0)
    exact = carom.hertz(carom.hertz_of_spheres(0.01, np.inf, STEEL), force=10.0)
    assert step.F_z == pytest.approx(10.0, rel=1e-8)
    assert step.zeta == pytest.approx(exact.approach, rel=1e-3)
    assert step.peak_pressure == pytest.approx(exact.peak_pressure, rel=1e-2)
    assert step.stored_energy == pytest.approx(0.4 * 10.0 * exact.approach, rel=2e-3)
    assert solver.pressure.shape == (64, 64)
    assert solver.pressure.sum() * SIZE[0] * SIZE[1] / 64**2 == pytest.approx(10.0, rel=1e-8)


def test_cattaneo():
    pair = carom.MaterialPair(carom.Material(100e9, 0.0))
    solver = ball(64, pair=pair)
    pressed = solver.step(F_z=10.0)
    pushed = solver.step(F_x=1.5)
    # (c/a)^3 = 1 - F_x/(f F_z).
    stick = (1 - 1.5 / 3.0) ** (2 / 3)
    assert pushed.stick_area / pushed.contact_area == pytest.approx(stick, abs=0.04)
    assert pushed.zeta == pytest.approx(pressed.zeta, rel=1e-9)
    limit = 0.3 * solver.pressure
    size = np.hypot(solver.traction_x, solver.traction_y)
    assert (size <= limit * (1 + 1e-7) + 1e-6 * limit.max()).all()
    slips = solver.cells == 2
    assert np.allclose(size[slips], limit[slips], rtol=1e-6, atol=1e-6 * limit.max())
    # Back by where it came: heat, and not the way it went.
    back = solver.step(F_x=0.0)
    assert back.dissipated > 0 and back.xi > 0


def test_a_step_holds_what_it_does_not_name_and_fails_without_a_trace():
    solver = ball()
    solver.step(F_z=10.0)
    before = solver.summary()
    with pytest.raises(carom.CaromError, match="slide"):
        solver.step(F_x=5.0)
    with pytest.raises(ValueError, match="xi and F_x"):
        solver.step(xi=1e-7, F_x=1.0)
    with pytest.raises(carom.RangeError) as error:
        solver.step(eta=np.nan)
    assert error.value.field == "eta"
    with pytest.raises(carom.CaromError, match="border"):
        solver.step(F_z=1e4)
    assert solver.summary() is not before and solver.summary().zeta == before.zeta
    assert solver.step(xi=2e-8).F_z == pytest.approx(10.0, rel=1e-8)


def test_bad_input_is_named():
    x, y = carom.cells((8, 8), SIZE)
    gap = x**2 + y**2
    with pytest.raises(ValueError, match="dimensions"):
        carom.Solver(gap[0], SIZE, PAIR, 0.3)
    with pytest.raises(ValueError, match="shape"):
        carom.Solver(gap, SIZE, PAIR, np.ones((3, 3)))
    with pytest.raises(ValueError, match="64 points, the first in row 1, column 1"):
        carom.Solver(gap * np.nan, SIZE, PAIR, 0.3)
    with pytest.raises(carom.RangeError) as error:
        carom.Solver(gap, SIZE, PAIR, -1.0)
    assert error.value.field == "friction"
    friction = np.full((8, 8), 0.3)
    friction[2, 5] = -1.0
    with pytest.raises(carom.RangeError) as error:
        carom.Solver(gap, SIZE, PAIR, friction)
    assert (error.value.field, error.value.index) == ("friction", 21)
    with pytest.raises(carom.RangeError) as error:
        carom.Solver(gap, SIZE, PAIR, 0.3, tolerance=1.0)
    assert error.value.field == "tolerance"
    with pytest.raises(ValueError, match="rows and columns"):
        carom.Solver(np.zeros((0, 4)), SIZE, PAIR, 0.3)


def test_friction_by_cell():
    x, y = carom.cells((40, 40), SIZE)
    friction = np.where(x > 0, 0.5, 0.0)
    solver = carom.Solver((x**2 + y**2) / 0.02, SIZE, PAIR, friction)
    solver.step(F_z=10.0)
    solver.step(xi=1e-7)
    assert (solver.traction_x[x < 0] == 0.0).all() and (solver.traction_x[x > 0] != 0.0).any()


@pytest.mark.parametrize("options", [{}, {"tolerance": 1e-3, "estimates": False}])
def test_pickled_or_copied_it_goes_on_bit_for_bit(options):
    solver = ball(pair=carom.MaterialPair(STEEL, carom.Material(70e9, 0.2)), **options)
    solver.step(F_z=10.0)
    solver.step(F_x=1.0, omega=1e-5)
    others = [pickle.loads(pickle.dumps(solver)), copy.copy(solver), copy.deepcopy(solver)]
    expected = solver.step(F_x=0.5)
    for other in others:
        step = other.step(F_x=0.5)
        np.testing.assert_equal(step.to_dict(), expected.to_dict())
        assert (other.pressure == solver.pressure).all()
        assert (other.traction_y == solver.traction_y).all()


def test_stress_below():
    solver = ball(64)
    step = solver.step(F_z=10.0)
    exact = carom.hertz(carom.hertz_of_spheres(0.01, np.inf, STEEL), force=10.0)
    a = exact.semi_axis_a
    depths = np.array([0.3, 0.5, 1.0, 2.0]) * a
    found = solver.stress(0.0, 0.0, depths)
    # On the axis: s_zz = -p/(1 + (z/a)^2).
    assert found[:, 2] == pytest.approx(-exact.peak_pressure / (1 + (depths / a) ** 2), rel=5e-3)
    other = solver.stress(0.0, 0.0, -depths, body=2)
    assert other[:, 2] == pytest.approx(found[:, 2], rel=1e-12)
    assert step.contact_area == pytest.approx(np.pi * a**2, rel=0.05)


def test_a_point_outside_body_2_is_named_as_it_was_given():
    solver = ball()
    solver.step(F_z=10.0)
    for body, z, allowed in ((2, 1e-5, "<= 0 in body 2"), (1, -1e-5, ">= 0 in body 1")):
        with pytest.raises(carom.RangeError) as error:
            solver.stress(0.0, 0.0, z, body=body)
        assert (error.value.field, error.value.value) == ("z", z)
        assert allowed in str(error.value)


def sphere_on_plate(plate=None, n=24, friction=0.0, size=(1.0, 1.0), **given):
    x, y = carom.cells((n, n), size)
    pair = carom.MaterialPair(carom.RIGID, carom.Material(0.91, 0.3))
    plate = plate or carom.Plate(1.0, 1.0, 0.1)
    return carom.Solver((x**2 + y**2) / 2, size, pair, friction, plate=plate, **given)


@pytest.mark.parametrize(("theory", "force"), [("layer", 1.995014292e-4), ("kirchhoff", 2.1739903853e-4)])
def test_force_on_a_plate_is_that_of_an_independent_solution(theory, force):
    plate = carom.Plate(1.0, 1.0, 0.1, theory)
    solver = sphere_on_plate(plate)
    assert solver.plate == plate and plate.theory == theory
    assert solver.step(zeta=0.03).F_z == pytest.approx(force, rel=1e-9)
    step = sphere_on_plate(plate).step(F_z=force)
    assert step.zeta == pytest.approx(0.03, rel=1e-8)


def test_a_plate_bent_too_far_is_warned_about():
    solver = sphere_on_plate()
    solver.step(zeta=0.03)
    assert not any("displacement" in text for text in solver.warnings)
    solver.step(zeta=0.08)
    assert any("exceeds 0.05" in text for text in solver.warnings)
    before = solver.summary()
    with pytest.raises(carom.CaromError, match="left border, where the body is held"):
        solver.step(zeta=0.4)
    assert solver.summary().zeta == before.zeta
    again = pickle.loads(pickle.dumps(solver))
    assert again.plate == solver.plate
    assert again.step(zeta=0.05).F_z == solver.step(zeta=0.05).F_z


def test_a_plate_that_cannot_be_is_refused_by_name():
    for make, field, value in [
        (lambda: carom.Plate(1.0, 1.0, 1e-7), "thickness", 1e-7),
        (lambda: carom.Plate(-1.0, 1.0, 0.1), "a", -1.0),
        (lambda: sphere_on_plate(friction=0.3), "friction", 0.3),
        (lambda: sphere_on_plate(cut=True), "cut", 1.0),
        (lambda: sphere_on_plate(size=(1.0, 0.9)), "size", 0.9),
    ]:
        with pytest.raises(carom.RangeError) as error:
            make()
        assert error.value.field == field and error.value.value == pytest.approx(value)
    with pytest.raises(ValueError, match="reissner"):
        carom.Plate(1.0, 1.0, 0.1, "reissner")
    with pytest.raises(ValueError, match="body = 2"):
        sphere_on_plate().stress(0.0, 0.0, -0.1, body=2)


def case_of_a_ball(tmp_path, cells):
    """The ball of `ball` as a case of the command with the same heights, pressed and then pushed."""
    path = tmp_path / "ball.toml"
    x, y = carom.cells((cells, cells), SIZE)
    np.save(tmp_path / "gap.npy", -(x**2 + y**2) / 0.02)
    path.write_text(f"""
[body_1.material]
young_modulus = 208e9
poisson = 0.3
[body_2.material]
young_modulus = 208e9
poisson = 0.3
[gap]
shape = "heights"
file = "gap.npy"
[contact]
friction = 0.3
[grid]
size = [{SIZE[0]}, {SIZE[1]}]
cells = [{cells}, {cells}]
[[step]]
F_z = 10
[[step]]
F_x = 1
""")
    return path


@pytest.mark.parametrize("cells", [12, 48])
def test_errors_and_warnings_are_those_of_the_command(tmp_path, cells):
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        solved = carom.cases.solve(case_of_a_ball(tmp_path, cells))
        of_case = len(told)
        x, y = carom.cells((cells, cells), SIZE)
        # Heights of a file count from the first point of contact.
        gap = (x**2 + y**2 - (x**2 + y**2).min()) / 0.02
        solver = carom.Solver(gap, SIZE, PAIR, 0.3)
        steps = [solver.step(F_z=10.0), solver.step(F_x=1.0)]
    for i, step in enumerate(steps):
        for name in ("zeta", "xi", "F_z", "F_x", "peak_pressure", "contact_area"):
            own, other = getattr(step, f"{name}_error"), getattr(solved.steps, f"{name}_error")[i]
            assert own == pytest.approx(other, rel=1e-6, abs=1e-12 if name[0] == "F" else 1e-20) and np.isfinite(own)
    # The error is that of the grid: Hertz's approach is within it.
    exact = carom.hertz(carom.hertz_of_spheres(0.01, np.inf, STEEL), force=10.0)
    assert abs(steps[0].zeta + (x**2 + y**2).min() / 0.02 - exact.approach) < 4 * steps[0].zeta_error
    assert solver.warnings == solved.warnings
    assert len(told) - of_case == of_case == (1 if cells == 12 else 0)
    if told:
        assert "cells wide: the estimated error of loads and shifts is" in str(told[0].message)
        assert told[-1].filename == __file__ and told[-1].category is carom.CaromWarning


def test_a_doubt_is_told_once_in_a_loop_and_again_of_another_kind():
    steel = carom.Material(208e9, 0.3, yield_stress=2e8)
    x, y = carom.cells((12, 12), SIZE)
    solver = carom.Solver((x**2 + y**2) / 0.02, SIZE, carom.MaterialPair(steel), 0.3)
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        for force in (1e-3, 2e-3, 10.0, 11.0):
            solver.step(F_z=force)
    assert [("cells wide" in str(one.message), "yields" in str(one.message)) for one in told] == [(True, False), (False, True)]
    assert [one.category for one in told] == [carom.CaromWarning, carom.OutsideTheoryWarning]
    assert len(solver.warnings) == 2


def test_without_estimates_the_numbers_are_the_same_and_the_errors_unknown():
    steps = [ball(24, estimates=estimates).step(F_z=10.0).to_dict() for estimates in (True, False)]
    for name, value in steps[0].items():
        if name.endswith("_error"):
            assert np.isfinite(value) and steps[1][name] is None
        else:
            assert value == steps[1][name]


def test_the_first_step_needs_an_approach_or_a_force():
    solver = ball(12)
    for given in ({}, {"F_x": 0.0}, {"xi": 1e-7}):
        with pytest.raises(ValueError, match="^zeta or F_z: the first step needs one of them"):
            solver.step(**given)
    assert solver.summary().step == 0


def test_a_stored_solver_of_another_form_is_refused_by_name():
    state = ball().__getstate__()
    for form in ({"_form": 0}, {}):
        other = object.__new__(carom.Solver)
        with pytest.raises(ValueError, match=r"form of the stored Solver = (0|None): this version reads 3"):
            other.__setstate__({**{key: value for key, value in state.items() if key != "_form"}, **form})
