"""Rolling contact of arrays."""

import numpy as np
import pytest

import carom

STEEL = carom.MaterialPair(carom.Material(208e9, 0.3))
UNLIKE = carom.MaterialPair(carom.Material(208e9, 0.3), carom.Material(70e9, 0.2))
SIZE = (3.2e-4, 3.2e-4)


def gap(cells=32):
    x, y = carom.cells((cells, cells), SIZE)
    return (x**2 + 0.7 * y**2) / (2 * 0.01)


def test_by_force_is_as_by_creepage():
    given = {"creepage": [1e-3, 2e-3], "creepage_across": [5e-4, -5e-4], "spin": [3.0, 3.0]}
    by = carom.roll(gap(), SIZE, UNLIKE, 0.3, F_z=[10.0, 12.0], **given).rows
    np.testing.assert_allclose(by.creepage, given["creepage"], rtol=1e-12)
    loads = {"F_x": by.F_x, "F_y": by.F_y, "M_z": by.M_z}
    found = carom.roll(gap(), SIZE, UNLIKE, 0.3, zeta=by.zeta, **loads).rows
    for name, values in given.items():
        np.testing.assert_allclose(getattr(found, name), values, rtol=1e-6)
    np.testing.assert_allclose(found.F_z, [10.0, 12.0], rtol=1e-7)
    assert (by.F_x[0] != by.F_x[1]) and (by.wear_number > 0).all()


def test_an_array_rolls_as_the_case_does(tmp_path):
    case = tmp_path / "case.toml"
    case.write_text(
        """
        body_1.material = { young_modulus = 208e9, poisson = 0.3 }
        body_2.material = { young_modulus = 70e9, poisson = 0.2 }
        contact.friction = 0.3
        gap = { shape = "paraboloid", radii = [0.01, 0.0142857142857142857] }
        grid = { cells = [32, 32], size = [3.2e-4, 3.2e-4] }
        rolling = { speed = 3, direction = 30, F_z = 10, F_x = [0, 1], spin = 2, spin_offset = 0.25, step = 8e-6 }
        """
    )
    of_case = carom.cases.roll(case)
    options = {"direction": 30.0, "step": 8e-6, "speed": 3.0, "spin_offset": 0.25}
    own = carom.roll(gap(), SIZE, UNLIKE, 0.3, F_z=10.0, F_x=[0.0, 1.0], spin=2.0, **options)
    for name in ("creepage", "creepage_across", "F_x", "F_y", "M_z", "heating", "stick_area", "F_y_error"):
        np.testing.assert_allclose(
            getattr(own.rows, name), getattr(of_case.rows, name), rtol=1e-6, atol=1e-12, err_msg=name
        )
    for name in ("x", "y"):
        np.testing.assert_allclose(getattr(own, name), getattr(of_case, name), atol=1e-18)
    np.testing.assert_allclose(own.traction_y, of_case.traction_y, atol=1e-6 * own.pressure.max())
    assert own.cells.shape == (32, 32) and (own.cells == of_case.cells).all()


def test_a_spin_taken_ahead_is_a_lateral_creepage():
    """At x + q d a spin moves the surfaces by q d more: to the side, if the contact rolls along x."""
    common = {"F_z": 10.0, "creepage": 1e-3, "spin": 40.0, "step": 1e-5}
    ahead = carom.roll(gap(), SIZE, STEEL, 0.3, spin_offset=0.5, **common).rows
    same = carom.roll(gap(), SIZE, STEEL, 0.3, creepage_across=-0.5 * 1e-5 * 40.0, **common).rows
    other = carom.roll(gap(), SIZE, STEEL, 0.3, **common).rows
    assert ahead.F_y[0] == pytest.approx(same.F_y[0], rel=1e-7)
    assert abs(ahead.F_y[0] - other.F_y[0]) > 1e-3 * abs(other.F_y[0])


def test_rolling_from_rest_ends_in_the_steady_state():
    drive = {"F_z": 10.0, "creepage": 1e-3, "spin": 2.0}
    steady = carom.roll(gap(), SIZE, STEEL, 0.3, **drive)
    rolled = carom.roll(gap(), SIZE, STEEL, 0.3, distance=2e-3, **drive)
    assert rolled.rows.distance[1] == pytest.approx(1e-5) and len(rolled.rows.distance) == 201
    assert rolled.rows.F_x[0] == pytest.approx(0.0, abs=1e-9)
    assert rolled.rows.F_x[-1] == pytest.approx(steady.rows.F_x[0], rel=1e-6)


def test_each_cell_may_have_its_friction():
    """Less friction at y < 0, in the first rows: the torque has the sign of y F_x."""
    friction = np.full((32, 32), 0.3)
    friction[:16] = 0.1
    rows = carom.roll(gap(), SIZE, STEEL, friction, F_z=10.0, creepage=0.05).rows
    assert rows.adhesion[0] == pytest.approx(0.2, rel=1e-3)
    assert rows.M_z[0] > 1e-3 * SIZE[1] * rows.F_x[0]


@pytest.mark.parametrize(
    ("change", "told"),
    [
        ({"F_z": -1.0}, "F_z"),
        ({"F_z": None}, "zeta or F_z must be given"),
        ({"zeta": 1e-6}, "zeta and F_z are both given"),
        ({"F_x": 1.0, "creepage": 1.0}, "creepage and F_x are both given"),
        ({"creepage": [1.0, 2.0], "spin": [1.0, 2.0, 3.0]}, "arrays of one shape"),
        ({"creepage": np.nan}, "creepage"),
        ({"spin_offset": 2.0}, "spin offset"),
        ({"speed": 0.0}, "speed"),
        ({"distance": 1e-3, "creepage": [1.0, 2.0]}, "distance"),
        ({"distance": -1.0}, "distance"),
        ({"tolerance": 1.0}, "tolerance"),
        ({"step": 0.0}, "distance"),
    ],
)
def test_what_cannot_roll_is_refused_by_name(change, told):
    with pytest.raises((ValueError, carom.CaromError), match=told):
        carom.roll(gap(), SIZE, STEEL, 0.3, **({"F_z": 10.0} | change))


def test_a_force_that_friction_cannot_hold_is_an_error():
    with pytest.raises(carom.CaromError, match="row 2"):
        carom.roll(gap(), SIZE, STEEL, 0.3, F_z=10.0, F_x=[1.0, 3.1])


@pytest.mark.parametrize("forces", [[20.0, 1e-3], [1e-3, 20.0], [1e-3, 20.0, 1e-3]])
def test_yield_is_judged_by_the_greatest_pressure_of_all_rows(forces):
    pair = carom.MaterialPair(carom.Material(208e9, 0.3, yield_stress=1e8))
    with pytest.warns(carom.OutsideTheoryWarning, match="yields: ") as told:
        rolled = carom.roll(gap(), SIZE, pair, 0.3, F_z=forces)
    over = rolled.rows.peak_pressure.max() / 1.6e8
    assert over > 1 > rolled.rows.peak_pressure.min() / 1.6e8
    assert f"it is {float(f'{over:.2e}'):g} times that" in str(told[0].message) and len(told) == 1
