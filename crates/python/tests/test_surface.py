"""Height maps from files, arrays and objects of other packages, and contacts on them."""

import copy
import io
import pickle

import numpy as np
import pytest

import carom

STEEL = carom.MaterialPair(carom.Material(208e9, 0.3))


def waves(ny=32, nx=32, side=1e-4):
    x, y = carom.cells((ny, nx), size=(side, side))
    return 1e-7 * np.cos(2 * np.pi * x / side) * np.cos(4 * np.pi * y / side)


class Topography:
    """As SurfaceTopography has it: arrays (nx, ny), a unit, masked points."""

    unit = "µm"
    physical_sizes = (100.0, 50.0)

    def __init__(self, rows):
        self.rows = rows

    def heights(self):
        return np.ma.masked_invalid(1e6 * self.rows.T)


class Measured:
    """As surfalize has it: rows in micrometres."""

    def __init__(self, rows):
        self.data, self.step_x, self.step_y = 1e6 * rows, 2.0, 3.0


def test_objects_of_other_packages_keep_their_order_and_units():
    rows = waves(4, 5)
    rows[1, 2] = np.nan
    found = carom.surface(Topography(rows))
    np.testing.assert_allclose(found.heights, rows, rtol=1e-14)
    assert found.size == pytest.approx((1e-4, 5e-5)) and found.missing == 1
    # A unit that is given holds before that of the object.
    np.testing.assert_allclose(carom.surface(Topography(rows), unit="nm").heights, 1e-3 * rows, rtol=1e-14)
    found = carom.surface(Measured(rows))
    np.testing.assert_allclose(found.heights, rows, rtol=1e-14)
    assert found.size == pytest.approx((1e-5, 1.2e-5))


def test_masked_points_are_missing_whatever_lies_under_the_mask():
    rows = np.ma.array(waves(4, 5), mask=np.eye(4, 5) > 0)
    found = carom.surface(rows, size=(1e-4, 1e-4))
    assert found.missing == 4 and np.isnan(np.diag(found.heights)).all()
    assert np.isinf(np.diag(found.gap)).all() and found.gap.min() == 0
    filled = found.prepared(missing="fill")
    assert filled.missing == 0
    np.testing.assert_array_equal(filled.heights[~rows.mask], rows.data[~rows.mask])


def test_the_gap_is_below_the_highest_point_and_a_scale_multiplies_heights():
    found = carom.surface(np.array([[0.0, 1.0, 3.0], [2.0, 0.0, 0.0]]), size=1.0)
    assert found.gap.tolist() == [[3.0, 2.0, 0.0], [1.0, 3.0, 3.0]]
    scaled = carom.surface(np.array([[0.0, 2.0], [1.0, 0.0]]), size=1.0, scale=3)
    assert scaled.heights.tolist() == [[0.0, 6.0], [3.0, 0.0]]


def test_files_are_known_by_their_content(tmp_path):
    rows = waves(6, 7)
    content = io.BytesIO()
    np.save(content, 1e6 * rows)
    path = tmp_path / "map.npy"
    path.write_bytes(content.getvalue())
    for source in (path, str(path), content.getvalue()):
        found = carom.surface(source, unit="um", size=1e-4)
        np.testing.assert_allclose(found.heights, rows, rtol=1e-14)
    with pytest.warns(carom.CaromWarning, match="does not state the unit"):
        carom.surface(path)
    text = "\n".join(";".join(f"{1e9 * height:.6f}".replace(".", ",") for height in row) for row in rows)
    np.testing.assert_allclose(carom.surface(text.encode(), unit="nm").heights, rows, atol=1e-15)


@pytest.mark.parametrize(
    ("given", "part"),
    [
        ({"unit": "inch"}, "unit = 'inch'"),
        ({"level": "flat"}, "level = \"flat\": must be mean, plane or quadratic"),
        ({"missing": "zero"}, "missing = 'zero'"),
        ({"crop": (0, 0, 9, 1)}, "from 0 to 5 and 4"),
        ({"crop": (0, 0, 1)}, "four numbers"),
        ({"size": (1, -1)}, "size = "),
        ({"scale": 0}, "scale = "),
    ],
)
def test_wrong_arguments_are_named(given, part):
    with pytest.raises((ValueError, carom.CaromError), match=part.replace("(", "\\(")):
        carom.surface(waves(4, 5), **given)


def test_wrong_maps_are_refused():
    for source, part in (
        (np.zeros(3), "must be an array"),
        (np.full((2, 2), np.inf), "infinite"),
        (b"1,2\n3\n", "line 2 has 1 values"),
        (b"II*\0", "TIFF"),
    ):
        with pytest.raises((ValueError, carom.CaromError), match=part):
            carom.surface(source)


def test_measures_tell_what_a_map_is():
    rows = waves(64, 64) + np.linspace(0, 1e-5, 64)
    found = carom.surface(rows, size=(1e-4, 1e-4))
    measures = found.measures()
    assert measures.tilt_over_rms > 5 and measures.columns == 64
    assert any("tilted" in warning for warning in found.warnings())
    level = found.prepared(level="plane")
    assert level.warnings() == []
    # A cosine times a cosine of amplitude A has the mean square A^2/4.
    assert level.measures().rms_height == pytest.approx(0.5e-7, rel=0.02)


def test_a_solver_takes_a_surface_and_its_size():
    rows = waves()
    surface = carom.surface(rows, size=(1e-4, 1e-4))
    gap = rows.max() - rows
    one = carom.Solver(gap, (1e-4, 1e-4), STEEL, 0, periodic=True)
    other = carom.Solver(surface, None, STEEL, 0, periodic=True)
    steps = [solver.step(F_z=0.1) for solver in (one, other, carom.Solver(Measured(rows), (1e-4, 1e-4), STEEL, 0, periodic=True))]
    assert steps[0].contact_share == steps[1].contact_share == steps[2].contact_share
    assert steps[1].zeta == pytest.approx(steps[0].zeta, rel=1e-9)
    again = pickle.loads(pickle.dumps(copy.copy(other)))
    np.testing.assert_array_equal(again.pressure, other.pressure)
    assert again.step(F_z=0.2) == other.step(F_z=0.2)


def test_a_wave_at_full_contact_is_westergaards():
    """p = E* pi A/lambda cos at full contact: one wave along x of amplitude A (Johnson, Contact mechanics, 13.2)."""
    side, amplitude = 1e-4, 1e-8
    x, _ = carom.cells((8, 64), size=(side, side / 8))
    modulus = 208e9 / (2 * (1 - 0.3**2))
    greatest = np.pi * modulus * amplitude / side
    solver = carom.Solver(amplitude * (1 - np.cos(2 * np.pi * x / side)), (side, side / 8), STEEL, 0, periodic=True, tolerance=1e-13)
    step = solver.step(F_z=1.5 * greatest * side * side / 8)
    exact = greatest * (1.5 + np.cos(2 * np.pi * x / side))
    np.testing.assert_allclose(solver.pressure, exact, rtol=1e-12 * 2.5 / 0.5)
    assert step.contact_share == 1 and abs(step.mean_gap) < 1e-12 * amplitude and step.patches == 1
    assert np.abs(solver.gap_left).max() < 1e-11 * amplitude


def test_missing_points_of_a_gap_need_a_word():
    rows = waves()
    gap = rows.max() - rows
    gap[3, 4] = np.nan
    with pytest.raises(ValueError, match="1 points, the first in row 4, column 5"):
        carom.Solver(gap, (1e-4, 1e-4), STEEL, 0, cut=True)
    hole = carom.Solver(gap, (1e-4, 1e-4), STEEL, 0, cut=True, missing="no contact")
    hole.step(zeta=1e-6)
    assert hole.pressure[3, 4] == 0 and np.isinf(hole.gap_left[3, 4]) and hole.pressure[3, 5] > 0
    filled = carom.Solver(gap, (1e-4, 1e-4), STEEL, 0, cut=True, missing="fill")
    filled.step(zeta=1e-6)
    assert filled.pressure[3, 4] > 0
    gap[0, 0] = np.inf
    cornered = carom.Solver(gap, (1e-4, 1e-4), STEEL, 0, cut=True, missing="fill")
    cornered.step(zeta=1e-6)
    assert cornered.pressure[3, 4] == pytest.approx(filled.pressure[3, 4], rel=0.01)
    assert np.isinf(cornered.gap_left[0, 0])
    with pytest.raises(ValueError, match="1 points, the first in row 2, column 2"):
        carom.Solver(np.ma.masked_equal(np.eye(4)[::-1] - np.eye(4) * [0, 9, 0, 0], -9), (1, 1), STEEL, 0)
    with pytest.raises(ValueError, match="cut and periodic"):
        carom.Solver(waves(), (1e-4, 1e-4), STEEL, 0, cut=True, periodic=True)
    with pytest.raises(ValueError, match="size is None"):
        carom.Solver(carom.surface(rows), None, STEEL, 0)


def test_the_energy_gap_bounds_the_energy():
    """The energy of a pressure is above the least one by at most `energy_gap`: of a coarse solve against a fine one."""
    rows = waves() + 3e-8 * np.cos(2 * np.pi * 3 * np.arange(32) / 32)
    gap = rows.max() - rows
    cell = (1e-4 / 32) ** 2

    def energy(tolerance):
        solver = carom.Solver(gap, (1e-4, 1e-4), STEEL, 0, periodic=True, tolerance=tolerance, estimates=False)
        step = solver.step(F_z=0.05)
        return step.stored_energy + cell * (solver.pressure * gap).sum(), step.energy_gap

    least, small = energy(1e-12)
    for tolerance in (1e-2, 1e-3, 1e-4, 1e-6):
        found, bound = energy(tolerance)
        assert found - least <= bound + small + 1e-15 * abs(found)
    assert small < 1e-9 * least
