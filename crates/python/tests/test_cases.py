"""Cases from TOML files."""

import os
import pathlib
import pickle
import tempfile

import carom
import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).parents[3] / "examples"


def test_an_impact_is_that_of_its_bodies():
    case = """
[body_1]
shape = "sphere"
radius = 0.01
material = { young_modulus = 2e11, poisson = 0.3 }
mass = 0.03
velocity = [0.5, 0, -1]
spin = [0, 0, 0]

[body_2]
shape = "plane"
material = { young_modulus = 2e11, poisson = 0.3 }
fixed = true

[contact]
friction = 0.2
"""
    steel = carom.Material(2e11, 0.3)
    ball = carom.sphere(0.01, steel, 0.03, velocity=(0.5, 0, -1))
    expected = carom.collide(ball, carom.plane(steel), 0.2)
    found = carom.cases.impact(written(case))
    assert found.to_dict().keys() == expected.to_dict().keys()
    assert found.R_x == expected.R_x and type(found) is carom.Rebound
    assert (found.body_1_velocity == expected.body_1_velocity).all()
    sweep = carom.cases.impact(written(case.replace("friction = 0.2", "friction = [0, 0.1, 0.2]")))
    assert sweep.R_x.shape == (3,) and sweep.body_1_velocity.shape == (3, 3)
    assert sweep.R_x[2] == expected.R_x and sweep.R_x[0] == -1.0
    name, unit, values = sweep.swept
    assert (name, unit) == ("contact.friction", "") and (values == [0, 0.1, 0.2]).all()
    assert pickle.loads(pickle.dumps(sweep)).swept[0] == name


def written(text):
    path = pathlib.Path(tempfile.mkdtemp()) / "case.toml"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_sweep_goes_on_with_its_number():
    pandas = pytest.importorskip("pandas")
    xarray = pytest.importorskip("xarray")
    sweep = carom.cases.impact(EXAMPLES / "alumina_on_plane.toml")
    angles = np.linspace(5, 85, 17)
    frame = sweep.to_pandas()
    assert isinstance(frame, pandas.DataFrame) and frame.index.name == "angle"
    assert np.allclose(frame.index, angles) and (frame["R_x"] == sweep.R_x).all()
    data = sweep.to_xarray()
    assert isinstance(data, xarray.Dataset) and data["angle"].attrs["units"] == "deg"
    assert data["body_1_velocity"].dims == ("angle", "axis")
    assert float(data["R_x"].sel(angle=45.0)) == sweep.R_x[8]


def test_a_history_is_that_of_a_contact():
    steps = carom.cases.history(EXAMPLES / "history_loop.toml")
    steel = carom.MaterialPair(carom.Material(shear_modulus=80e9, poisson=0.3))
    hertz = carom.Hertz.of_radii(steel, [0.01, 0.01], [np.inf, np.inf], 0.0)
    contact = carom.Contact(hertz, 0.3)
    loads = np.array([contact.advance(*step) for step in zip(steps.zeta, steps.xi, steps.eta, strict=True)])
    assert np.allclose(np.stack([steps.F_x, steps.F_y, steps.F_z], axis=1), loads, rtol=1e-12, atol=1e-12)
    assert steps.step.tolist() == list(range(1, 10)) and steps.regime[-1] == "separated"
    assert np.isnan(steps.M_z).all() or (steps.M_z == 0).all()
    assert (np.diff(steps.dissipated) >= 0).all()


def test_files_of_a_case_lie_beside_it():
    steps = carom.cases.history(EXAMPLES / "history_twist.toml")
    assert np.abs(steps.M_z).max() > 0 and "slip" in steps.twist_regime
    assert steps.units["M_z"] == "N m"


def test_a_grid_is_that_of_a_solver():
    solved = carom.cases.solve(EXAMPLES / "solve_cattaneo_loop.toml")
    assert solved.steps.step.shape == (26,) and solved.pressure.shape == (48, 48)
    steel = carom.MaterialPair(carom.Material(shear_modulus=80e9, poisson=0.3))
    x, y = np.meshgrid(solved.x, solved.y)
    height = (x**2 + y**2) / (0.01 + np.sqrt(0.01**2 - x**2 - y**2))  # of a ball, no paraboloid
    solver = carom.Solver(height, (2.4e-4, 2.4e-4), steel, 0.3)
    for zeta, xi in zip(solved.steps.zeta, solved.steps.xi, strict=True):
        step = solver.step(zeta=zeta, xi=xi)
    last = solved.steps.F_z[-1]
    assert step.F_z == pytest.approx(last, rel=1e-6)
    assert step.F_x == pytest.approx(solved.steps.F_x[-1], abs=1e-6 * last)
    assert np.allclose(solver.pressure, solved.pressure, atol=1e-5 * solved.pressure.max())
    cell = (solved.x[1] - solved.x[0]) * (solved.y[1] - solved.y[0])
    assert solved.traction_x.sum() * cell == pytest.approx(solved.steps.F_x[-1], rel=1e-9)
    assert set(np.unique(solved.cells)) == {0, 1, 2}


def test_a_plate_is_that_of_a_solver_and_warned_about(tmp_path):
    text = (EXAMPLES / "solve_plate_kirchhoff.toml").read_text()
    (tmp_path / "bent.toml").write_text(text.replace('"1.2 mm"', '"2.2 mm"').replace('"10 m"', '"5 m"'))
    solved = carom.cases.solve(tmp_path / "bent.toml")
    x, y = np.meshgrid(solved.x, solved.y)
    pair = carom.MaterialPair(carom.RIGID, carom.Material(208e9, 0.3))
    plate = carom.Plate(0.4, 0.4, 4e-3, "kirchhoff")
    solver = carom.Solver((x**2 + y**2) / 10, (0.4, 0.4), pair, 0.0, plate=plate)
    assert solver.step(zeta=2.2e-3).F_z == pytest.approx(solved.steps.F_z[-1], rel=1e-8)
    assert any(text.startswith("step 1: the displacement 0.00") for text in solved.warnings)
    assert not any("displacement" in text for text in carom.cases.solve(EXAMPLES / "solve_plate.toml").warnings)


def test_an_accuracy_chooses_the_grid():
    rough = carom.cases.solve(EXAMPLES / "solve_hertz.toml", accuracy=0.01)
    fine = carom.cases.solve(EXAMPLES / "solve_hertz.toml", accuracy=2e-5)
    assert fine.pressure.size > rough.pressure.size
    assert (fine.steps.zeta_error <= 2e-5 * fine.steps.zeta.max()).all()


def test_what_is_wrong_is_named():
    ball = carom.cases.new("impact")
    with pytest.raises(ValueError, match=r"case\.toml.*`contact\.friction` = -1 is out of range"):
        carom.cases.impact(written(ball.replace("friction = 0.2", "friction = -1")))
    with pytest.raises(ValueError, match="did you mean"):
        carom.cases.impact(written(ball.replace("friction = 0.2", "fricton = 0.2")))
    with pytest.raises(FileNotFoundError) as error:
        carom.cases.solve("no/such/case.toml")
    assert os.fspath(error.value.filename) == "no/such/case.toml"
    with pytest.raises(carom.RangeError) as error:
        carom.cases.solve(EXAMPLES / "solve_hertz.toml", accuracy=2.0)
    assert error.value.field == "accuracy"
    with pytest.raises(ValueError, match='must be "impact" or "hertz"'):
        carom.cases.new("crash")
    with pytest.raises(ValueError, match="uncertainty"):
        carom.cases.impact(EXAMPLES / "glass_scatter.toml")
