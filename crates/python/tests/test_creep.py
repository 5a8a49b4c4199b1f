"""Creep coefficients of arrays, and forces by FASTSIM."""

import numpy as np
import pytest

import carom

G = 80e9
STEEL = carom.MaterialPair(carom.Material(shear_modulus=G, poisson=0.25))
# a/b = 2.0
LONG = carom.Hertz(STEEL, 35.0, 100.0)


def test_coefficients_are_those_printed():
    """Kalker 1990, table E.3."""
    found = carom.creep_coefficients([0.2, 1.0, 2.0, 5.0], [0.25, 0.5, 0.25, 0.0])
    np.testing.assert_allclose(found.C11, [3.37, 5.20, 5.10, 6.96], rtol=0.01)
    np.testing.assert_allclose(found.C22, [2.63, 3.98, 4.90, 6.96], rtol=0.01)
    np.testing.assert_allclose(found.C23, [0.603, 1.63, 2.62, 5.72], rtol=0.01)
    np.testing.assert_allclose(found.C33, [4.27, 1.16, 0.819, 0.828], rtol=0.01)
    assert (found.C32 == found.C23).all()


def test_coefficients_are_those_of_a_case(tmp_path):
    """The case computes them on meshes."""
    case = tmp_path / "case.toml"
    case.write_text(
        """
        body_1.material = { shear_modulus = 80e9, poisson = 0.25 }
        body_2.material = { shear_modulus = 80e9, poisson = 0.25 }
        contact = { semi_axes = [2e-3, 1e-3], F_z = 1000, friction = 0.3 }
        grid.elements = 10
        rolling = { speed = 1, creepage = 1e-4 }
        """
    )
    of_case = carom.cases.roll(case, coefficients=True).coefficients
    found = carom.creep_coefficients(2.0, 0.25)
    for name in ("C11", "C22", "C23", "C32"):
        assert getattr(found, name) == pytest.approx(getattr(of_case, name), rel=1e-3)
    assert found.C33 == pytest.approx(of_case.C33, rel=2e-3)


def test_numbers_give_a_number_and_arrays_are_broadcast():
    one = carom.creep_coefficients(2, 0.25)
    assert isinstance(one, carom.LinearCreep) and isinstance(one.C11, float)
    many = carom.creep_coefficients([[1.0], [2.0], [3.0]], [0.0, 0.25])
    assert isinstance(many, carom.LinearCreeps) and many.shape == (3, 2)
    assert many[1, 1] == one
    assert carom.creep_coefficients([], 0.3).C11.shape == (0,)
    assert carom.LinearCreep.meanings["C23"] == "F_y = -G (ab)^1.5 C23 spin"


@pytest.mark.parametrize(
    ("ratio", "poisson", "field", "value", "index"),
    [
        ([1.0, 21.0], 0.3, "axis_ratio", 21.0, 1),
        (0.04, 0.3, "axis_ratio", 0.04, 0),
        ([1.0, 2.0, 3.0], [0.3, 0.3, -0.1], "poisson", -0.1, 2),
        (1.0, 0.6, "poisson", 0.6, 0),
    ],
)
def test_what_the_table_does_not_have_is_named(ratio, poisson, field, value, index):
    with pytest.raises(carom.RangeError, match=field) as told:
        carom.creep_coefficients(ratio, poisson)
    assert (told.value.field, told.value.value, told.value.index) == (field, value, index)


def test_what_is_no_number_is_named():
    with pytest.raises(ValueError, match="^poisson: must be"):
        carom.creep_coefficients(1.0, "x")
    with pytest.raises(ValueError):
        carom.creep_coefficients([1.0, 2.0], [0.1, 0.2, 0.3])


def test_springs_are_linear_at_small_creepage():
    state, of = carom.hertz(LONG, force=1000.0), carom.creep_coefficients(LONG.axis_ratio, 0.25)
    ab = state.semi_axis_a * state.semi_axis_b
    small = {"F_z": 1000.0, "mesh": (200, 200)}
    assert carom.fastsim(LONG, 0.3, creepage=1e-6, **small).F_x == pytest.approx(G * ab * of.C11 * 1e-6, rel=2e-3)
    across = carom.fastsim(LONG, 0.3, creepage_across=1e-6, **small)
    assert across.F_y == pytest.approx(G * ab * of.C22 * 1e-6, rel=2e-3) and across.F_x == 0.0
    spun = carom.fastsim(LONG, 0.3, spin=1e-3, **small)
    assert spun.F_y == pytest.approx(-G * ab**1.5 * of.C23 * 1e-3, rel=5e-3)
    assert spun.F_x == pytest.approx(0.0, abs=1e-12)


def test_springs_slide_at_the_friction_limit():
    forces = carom.fastsim(LONG, [0.1, 0.3], F_z=[[500.0], [1000.0]], creepage=0.1, creepage_across=-0.1)
    assert isinstance(forces, carom.FastsimForces) and forces.shape == (2, 2)
    limit = np.array([[50.0, 150.0], [100.0, 300.0]])
    np.testing.assert_allclose(np.hypot(forces.F_x, forces.F_y), limit, rtol=2e-3)
    assert (forces.F_x > 0).all() and (forces.F_y < 0).all()


def test_springs_have_the_error_that_their_documentation_says():
    size = (5e-3, 2.6e-3)
    x, y = carom.cells((32, 32), size)
    gap = 35.0 * x**2 + 100.0 * y**2
    for drive, allowed in [
        ({"creepage": [5e-4, 1e-3, 2e-3, 8e-3]}, 0.06),
        ({"creepage_across": [5e-4, 1e-3, 2e-3, 8e-3]}, 0.06),
        ({"spin": [0.5, 1.0, 2.0, 4.0]}, 0.12),
    ]:
        exact = carom.roll(gap, size, STEEL, 0.3, F_z=1000.0, **drive).rows
        springs = carom.fastsim(LONG, 0.3, F_z=1000.0, **drive)
        off = np.hypot(springs.F_x - exact.F_x, springs.F_y - exact.F_y) / 300.0
        assert off.max() < allowed, (drive, off)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"F_z": -1.0}, "F_z = -1"),
        ({"friction": 0.0}, "friction = 0"),
        ({"creepage": np.nan}, "creepage = NaN"),
        ({"creepage_across": np.inf}, "creepage_across"),
        ({"spin": [0.0, np.nan]}, "spin = NaN.*entry 1"),
        ({"creepage": "x"}, "creepage: must be real numbers"),
        ({"mesh": (0, 10)}, "mesh = 0"),
        ({"mesh": (10, 1001)}, "mesh = 1001"),
        ({"mesh": (10, -1)}, "mesh = -1"),
        ({"mesh": (10,)}, "mesh: must be two numbers"),
        ({"contact": carom.Hertz(STEEL, 1.0, 1e4)}, "axis_ratio"),
    ],
)
def test_what_springs_cannot_take_is_refused_by_name(change, told):
    given = {"contact": LONG, "friction": 0.3, "F_z": 1000.0} | change
    with pytest.raises(ValueError, match=told):
        carom.fastsim(given.pop("contact"), given.pop("friction"), **given)


def test_the_table_is_near_to_the_solver_and_keeps_shapes():
    size = (5e-3, 2.6e-3)
    x, y = carom.cells((48, 48), size)
    drive = {"creepage": [5e-4, 1e-3, 2e-3, 8e-3], "creepage_across": 5e-4, "spin": 0.5}
    table = carom.creep_force(LONG, 0.3, F_z=1000.0, **drive)
    spread = {name: np.broadcast_to(value, 4) for name, value in drive.items()}
    solved = carom.roll(35.0 * x**2 + 100.0 * y**2, size, STEEL, 0.3, F_z=1000.0, **spread).rows
    for force in ("F_x", "F_y"):
        off = abs(getattr(table, force) - getattr(solved, force))
        assert (off < table.error + 2 * getattr(solved, f"{force}_error")).all(), off
    assert (table.error < 0.01 * 300.0).all()
    assert carom.creep_force(LONG, [[0.1], [0.3]], F_z=[500.0, 1000.0, 2000.0]).F_x.shape == (2, 3)


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"F_z": 0.0}, "F_z = 0"),
        ({"friction": -0.1}, "friction = -0.1"),
        ({"spin": [0.0, np.inf]}, "spin"),
        ({"contact": carom.Hertz(STEEL, 1.0, 1e4)}, "axis_ratio"),
        ({"contact": carom.Hertz(carom.MaterialPair(carom.Material(G, 0.2), carom.Material(2 * G, 0.3)), 35.0, 100.0)}, "like"),
    ],
)
def test_what_the_table_does_not_hold_is_refused_by_name(change, told):
    given = {"contact": LONG, "friction": 0.3, "F_z": 1000.0} | change
    with pytest.raises(ValueError, match=told):
        carom.creep_force(given.pop("contact"), given.pop("friction"), **given)


def test_friction_may_fall_with_the_slip_speed():
    size = (5e-3, 2.6e-3)
    x, y = carom.cells((32, 32), size)
    gap = 35.0 * x**2 + 100.0 * y**2
    falls = carom.SlipSpeedFriction(0.1, 0.2, 50.0)
    drive = {"F_z": 1000.0, "creepage": [1e-6, 1e-3, 0.2], "speed": 2.0}
    own, constant = (carom.roll(gap, size, STEEL, f, **drive).rows.F_x for f in (falls, 0.3))
    assert own[0] == pytest.approx(constant[0], rel=1e-3)
    assert 0.3 * constant[1] < own[1] < constant[1]
    assert own[2] == pytest.approx(100.0, rel=2e-3)
    with pytest.raises(ValueError, match="steady state"):
        carom.roll(gap, size, STEEL, falls, F_z=1000.0, creepage=1e-3, distance=1e-3)
