"""Pictures show the numbers that they are made of."""

import subprocess
import sys

import carom
import numpy as np
import pytest

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")

STEEL = carom.Material(208e9, 0.3)


@pytest.fixture
def solver():
    x, y = carom.cells((40, 32), (2.6e-4, 3e-4))
    solving = carom.Solver((x**2 + 3 * y**2) / 0.02, (2.6e-4, 3e-4), carom.MaterialPair(STEEL), 0.3)
    solving.step(F_z=10.0)
    solving.step(F_x=1.0, F_y=1.5)
    return solving


def mesh(axes):
    return next(child for child in axes.get_children() if isinstance(child, matplotlib.collections.QuadMesh))


def colours(axes):
    """The coloured cells: values where they are drawn, NaN elsewhere."""
    return np.ma.filled(mesh(axes).get_array().astype(float), np.nan).reshape(40, 32)


def test_a_pressure_is_drawn_where_there_is_contact_and_in_its_unit(solver):
    axes = carom.plot.pressure(solver)
    shown = colours(axes)
    assert np.array_equal(np.isnan(shown), solver.cells == 0)
    assert np.allclose(shown[solver.cells > 0] * 1e6, solver.pressure[solver.cells > 0])
    assert axes.figure.axes[1].get_ylabel() == "p / MPa" and axes.get_xlabel() == "x / µm"
    x, y = carom.cells(solver.shape, solver.size)
    for (low, high), places in ((axes.get_xlim(), x), (axes.get_ylim(), y)):
        reach = 1e6 * places[solver.cells > 0].max()
        assert reach < high < 1.4 * reach and low == pytest.approx(-high)
    assert axes.get_xlim()[1] > 1.5 * axes.get_ylim()[1]


def test_a_contact_on_the_whole_grid_fills_the_picture():
    flat = carom.Solver(np.zeros((6, 4)), (2e-4, 6e-4), carom.MaterialPair(STEEL), 0.3, cut=True)
    flat.step(zeta=1e-7)
    axes = carom.plot.pressure(flat)
    assert (flat.cells > 0).all()
    assert axes.get_xlim() == pytest.approx((-100, 100)) and axes.get_ylim() == pytest.approx((-300, 300))


def test_stick_and_slip_are_the_states_of_the_cells(solver):
    axes = carom.plot.stick_slip(solver)
    assert np.array_equal(np.nan_to_num(colours(axes)), solver.cells)
    assert set(np.unique(solver.cells)) == {0, 1, 2}
    named = [patch.get_facecolor() for patch in axes.get_legend().get_patches()]
    assert np.array_equal(mesh(axes).to_rgba(np.array([1, 2])), named) and named[0] != named[1]
    fresh = carom.Solver(solver.gap, solver.size, carom.MaterialPair(STEEL), 0.3)
    fresh.step(F_z=1.0)
    told = [text.get_text() for text in carom.plot.stick_slip(fresh).get_legend().get_texts()]
    assert told == ["sticks"]


def test_arrows_point_along_the_tractions(solver):
    axes = carom.plot.tractions(solver)
    arrows = next(child for child in axes.get_children() if isinstance(child, matplotlib.quiver.Quiver))
    assert arrows.U.sum() > 0 and arrows.V.sum() / arrows.U.sum() == pytest.approx(1.5, rel=0.1)
    size = np.hypot(solver.traction_x, solver.traction_y)
    assert np.nanmax(colours(axes)) * 1e6 == pytest.approx(size.max())


def test_a_solved_case_is_drawn_like_a_solver(tmp_path):
    path = tmp_path / "ball.toml"
    path.write_text(carom.cases.new("solve"))
    solved = carom.cases.solve(path)
    for draw in (carom.plot.pressure, carom.plot.stick_slip, carom.plot.tractions):
        assert draw(solved).get_title()


def test_before_the_first_step_a_picture_is_empty(solver):
    fresh = carom.Solver(solver.gap, solver.size, carom.MaterialPair(STEEL), 0.3)
    assert np.isnan(colours(carom.plot.pressure(fresh))).all()
    assert np.isnan(colours(carom.plot.tractions(fresh))).all()


def test_curves_are_the_results_and_differ_in_colour_and_dashes():
    axes = carom.plot.restitution([1.0, 1.2], np.linspace(0.1, 9, 20))
    one, two = axes.lines
    assert np.array_equal(two.get_ydata(), carom.restitution(1.2, np.linspace(0.1, 9, 20)))
    assert one.get_color() != two.get_color() and one.get_linestyle() != two.get_linestyle()
    ball = carom.sphere(0.01, STEEL, 0.033, velocity=(1.0, 0, -0.2))
    course = carom.history(ball, carom.plane(STEEL), 0.15, 21)
    axes = carom.plot.history(course)
    assert [line.get_label() for line in axes.lines] == ["$F_x$", "$F_z$"]  # F_y is zero
    assert axes.get_xlabel() == "time / µs"
    assert np.allclose(axes.lines[0].get_xdata() * 1e-6, course.time)
    xi = np.linspace(0, 1e-7, 9)
    loads = carom.Contact(carom.hertz_of_spheres(0.01, 0.01, STEEL), 0.3).follow(np.full(9, 1e-6), xi)
    line = carom.plot.loop(xi, loads).lines[0]
    assert np.allclose(line.get_xdata(), 100 * np.linspace(0, 1, 9)) and np.allclose(line.get_ydata(), loads[:, 0])


def test_the_module_is_there_without_an_import_of_its_own_and_without_matplotlib():
    code = "import sys, carom; carom.plot.pressure; sys.exit('matplotlib' in sys.modules)"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
