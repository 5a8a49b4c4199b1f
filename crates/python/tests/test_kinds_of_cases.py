"""Cases of hertz, stress, scene and roll, against closed forms and against the functions of the module."""

import pathlib
import pickle

import carom
import numpy as np
import pytest

EXAMPLES = pathlib.Path(__file__).parents[3] / "examples"
STEEL = 'material = { young_modulus = "208 GPa", poisson = 0.3 }'


def written(tmp_path, text):
    path = tmp_path / "case.toml"
    path.write_text(text, encoding="utf-8")
    return path


HERTZ = f"""
[body_1]
{STEEL}
radii = "10 mm"
[body_2]
{STEEL}
radii = "20 mm"
[load]
force = [1, 10, 100]
"""


def test_a_contact_under_loads_is_that_of_hertz(tmp_path):
    states = carom.cases.hertz(written(tmp_path, HERTZ))
    steel = carom.Material(208e9, 0.3)
    assert states == carom.hertz(carom.hertz_of_spheres(0.01, 0.02, steel), force=[1.0, 10.0, 100.0])
    e_star, radius = 208e9 / (2 * (1 - 0.3**2)), 1 / (1 / 0.01 + 1 / 0.02)
    a = np.cbrt(0.75 * np.array([1, 10, 100]) * radius / e_star)
    np.testing.assert_allclose(states.semi_axis_a, a, rtol=1e-12)
    with pytest.warns(carom.OutsideTheoryWarning, match=r"a/R exceeds .*\(1 of 3 loads concerned"):
        carom.cases.hertz(written(tmp_path, HERTZ.replace("[1, 10, 100]", "[1, 10, 1e5]")))


STRESS = f"""
[body_1]
{STEEL}
radii = "10 mm"
[body_2]
{STEEL}
radii = inf
[contact]
friction = 0.3
[load]
force = 10
force_x = 1.5
force_y = -1.0
[points]
inside = "BODY"
x = [-2e-5, 0, 1e-5, 6e-5]
y = [0, 3e-5, 5e-5]
depth = [1e-5, 5e-5]
"""


@pytest.mark.parametrize("body", [1, 2])
def test_stresses_are_those_of_the_function_for_points(tmp_path, body):
    text = STRESS.replace("BODY", f"body {body}")
    below = carom.cases.stress(written(tmp_path, text))
    assert below.stress.shape == (2, 3, 4, 6) and below.von_mises.shape == (2, 3, 4)
    state, steel = below.contact, carom.Material(208e9, 0.3)
    pushed = np.hypot(1.5, 1.0)
    assert below.stick_radius == pytest.approx((1 - pushed / 3) ** (1 / 3))
    depth, y, x = np.meshgrid(below.depth, below.y, below.x, indexing="ij")
    side = 1 if body == 1 else -1
    limit = side * 0.3 * state.peak_pressure / pushed
    expected = carom.stress(
        (state.semi_axis_a, state.semi_axis_b),
        steel,
        state.peak_pressure,
        x,
        y,
        depth,
        traction=(1.5 * limit, -1.0 * limit),
        stick_radius=below.stick_radius,
    ) * np.array([1, 1, 1, 1, side, side])
    np.testing.assert_allclose(below.stress, expected, rtol=1e-12, atol=1e-6)
    np.testing.assert_allclose(below.von_mises, carom.von_mises(expected), rtol=1e-12)
    s = below.stress[1, 2, 3]
    tensor = np.array([[s[0], s[3], s[5]], [s[3], s[1], s[4]], [s[5], s[4], s[2]]])
    assert below.maximum_shear[1, 2, 3] == pytest.approx(0.5 * np.ptp(np.linalg.eigvalsh(tensor)))
    assert pickle.loads(pickle.dumps(below)) == below and "von_mises" in repr(below)


def test_stresses_have_named_axes(tmp_path):
    pytest.importorskip("xarray")
    text = STRESS.replace("BODY", "body 1")
    below = carom.cases.stress(written(tmp_path, text))
    data = below.to_xarray()
    one = data["stress"].sel(depth=5e-5, y=3e-5, x=-2e-5, component="zx")
    assert float(one) == below.stress[1, 1, 0, 5]
    assert data["von_mises"].attrs["units"] == "Pa" and data["von_mises"].dims == ("depth", "y", "x")


SCENE = """
[ball]
shape = "sphere"
radius = "10 mm"
material = { young_modulus = "10 MPa", poisson = 0.5 }
mass = 0.005
velocity = [0.3, 0, 0]
spin = [0, 0, 0]
[scene]
gravity = [0, 0, -9.81]
start = [0, 0, 0.05]
bounces = 3
time = 10
[[wall]]
name = "floor"
point = [0, 0, 0]
normal = [0, 0, 1]
friction = 0.4
material = { rigid = true }
"""


def test_a_ball_bounces_where_it_falls_and_as_collide_says(tmp_path):
    scene = carom.cases.scene(written(tmp_path, SCENE), points=11)
    bounces = scene.bounces
    assert len(bounces) == 3 and bounces.wall == ["floor"] * 3 and scene.ending == "the last bounce is done"
    fall = np.sqrt(2 * 0.04 / 9.81)  # by the height less the radius
    np.testing.assert_allclose(bounces.time, fall * np.array([1, 3, 5]), rtol=1e-5)
    np.testing.assert_allclose(bounces.position[:, 2], 0.01, rtol=1e-9)
    np.testing.assert_allclose(bounces.position[0], [0.3 * fall, 0, 0.01], rtol=1e-9)
    rubber = carom.Material(1e7, 0.5)
    ball = carom.sphere(0.01, rubber, 0.005, velocity=bounces.velocity_before[1], spin=bounces.spin_before[1])
    rebound = carom.collide(ball, carom.plane(carom.RIGID), 0.4)
    np.testing.assert_allclose(bounces.velocity[1], rebound.body_1_velocity, rtol=1e-9, atol=1e-12)
    np.testing.assert_allclose(bounces.spin[1], rebound.body_1_spin, rtol=1e-9, atol=1e-9)
    assert bounces.R_x[1] == pytest.approx(rebound.R_x, rel=1e-9)
    path = scene.path
    assert len(path) % 11 == 0 and path.time[-1] <= scene.end.time
    flying = path.time < bounces.time[0]
    np.testing.assert_allclose(path.position[flying, 2], 0.05 - 0.5 * 9.81 * path.time[flying] ** 2, rtol=1e-9)
    assert len(carom.cases.scene(written(tmp_path, SCENE)).path) == 0
    for wrong in (1, 100_001, -1):
        with pytest.raises(carom.RangeError) as error:
            carom.cases.scene(written(tmp_path, SCENE), points=wrong)
        assert error.value.field == "points"


ROLL = """
[body_1]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[body_2]
material = { shear_modulus = "80 GPa", poisson = 0.25 }
[contact]
semi_axes = ["1 mm", "1 mm"]
F_z = "1 kN"
friction = 0.3
[rolling]
speed = 2
creepage = [1e-6, 0, 0.1]
creepage_across = [0, 1e-6, 0]
[grid]
elements = 16
"""


def test_creep_forces_are_kalkers_for_small_creepage_and_the_limit_for_large(tmp_path):
    rolled = carom.cases.roll(written(tmp_path, ROLL), coefficients=True, fastsim=True)
    rows, c = rolled.rows, rolled.coefficients
    assert c.C11 == pytest.approx(4.12, rel=5e-3) and c.C22 == pytest.approx(3.67, rel=5e-3)  # Kalker 1990
    unit = 80e9 * 1e-3**2 * 1e-6
    assert rows.F_x[0] == pytest.approx(unit * c.C11, rel=0.07) and abs(rows.F_y[0]) < 1e-6 * rows.F_x[0]
    assert rows.F_y[1] == pytest.approx(unit * c.C22, rel=0.07) and abs(rows.F_x[1]) < 1e-6 * rows.F_y[1]
    assert rows.F_x_springs[0] == pytest.approx(unit * c.C11, rel=0.07)
    assert rows.slides.tolist() == [False, False, True] and rows.F_x[2] == pytest.approx(0.3 * rows.F_z[2], rel=1e-6)
    np.testing.assert_allclose(rows.F_z, 1000.0, rtol=1e-6)
    cell = (rolled.x[1] - rolled.x[0]) * (rolled.y[1] - rolled.y[0])
    assert rolled.traction_x.sum() * cell == pytest.approx(rows.F_x[2], rel=1e-9)
    assert rows.iterations.dtype == np.int64 and np.isnan(rows.distance).all()
    assert pickle.loads(pickle.dumps(rolled)) == rolled
    assert rolled.warnings == ["full sliding in 1 of 3 rows: the creep force is saturated, and more creepage does not increase it"]


def test_a_contact_that_rolls_from_rest_is_drawn(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    path = written(tmp_path, ROLL.replace("[1e-6, 0, 0.1]", "0.002\ndistance = 1e-3").replace("creepage_across = [0, 1e-6, 0]", ""))
    rolled = carom.cases.roll(path)
    assert (np.diff(rolled.rows.distance) > 0).all() and rolled.rows.distance[0] == 0
    assert rolled.coefficients is None and (np.diff(rolled.rows.F_x) > 0).all()
    assert carom.plot.tractions(rolled).get_title()
    with pytest.raises(ValueError, match="fastsim"):
        carom.cases.roll(path, fastsim=True)


@pytest.mark.parametrize("kind", ["hertz", "stress", "scene", "roll", "impact", "history", "solve"])
def test_a_new_case_of_each_kind_runs_and_every_example_of_some(kind, tmp_path):
    run = getattr(carom.cases, kind)
    run(written(tmp_path, carom.cases.new(kind)))
    with pytest.raises(ValueError, match="case.toml"):
        run(written(tmp_path, "[nothing]\n"))
    if kind in ("hertz", "stress", "scene"):
        examples = sorted(EXAMPLES.glob(f"{kind}_*.toml"))
        assert examples
        for example in examples:
            assert repr(run(example))


def test_a_bellows_is_followed_and_energy_is_kept(tmp_path):
    bellows = carom.cases.shell(EXAMPLES / "shell_bellows.toml")
    assert isinstance(bellows, carom.cases.Bellows)
    loads = bellows.loads
    np.testing.assert_allclose(loads.dilatation, np.linspace(-0.012, 0.012, 9), atol=1e-15)
    # The work of the force is stored: Simpson's rule over the even steps on either side of rest.
    step = loads.dilatation[1] - loads.dilatation[0]
    weights = np.array([1, 4, 2, 4, 1]) * step / 3
    np.testing.assert_allclose(weights @ loads.force[4:], loads.stored_energy[-1], rtol=1e-3)
    np.testing.assert_allclose(-(weights @ loads.force[:5]), loads.stored_energy[0], rtol=1e-3)
    assert set(loads.end) == {"reached"} and loads.iterations.dtype.kind == "i"
    assert bellows.response.spring_rate == pytest.approx(loads.spring_rate[4], rel=1e-9)
    assert bellows.places.radius[0] > bellows.places.radius[-1]
    limited = """
[bellows]
shape = "sine"
mean_radius = 10
amplitude = 1e-4
pitch = 3.44
thickness = 0.1
harmonics = 16
material = { young_modulus = 1e5, poisson = 0.3 }
[bellows.load]
force = [-1000, -8000]
"""
    with pytest.warns(carom.OutsideTheoryWarning, match="a limit point comes before the load"):
        bellows = carom.cases.shell(written(tmp_path, limited))
    classical = 2 * np.pi * 0.01 * 1e5 / np.sqrt(3 * 0.91)
    assert bellows.loads.end == ["reached", "limit of the force"]
    assert bellows.loads.force[1] == pytest.approx(-classical, rel=0.015)


def test_a_bare_ring_is_that_of_timoshenko(tmp_path):
    ring = """
[flange]
radius = 2
stiffness = { stretching = 1e7, in_plane = 1, out_of_plane = 1, torsion = 1 }
places = 8
[[flange.force]]
radial = 3
[[flange.force]]
angle = 180
radial = 3
"""
    flange = carom.cases.shell(written(tmp_path, ring))
    assert isinstance(flange, carom.cases.Flange)
    np.testing.assert_allclose(flange.places.angle, np.arange(0, 360, 45), atol=1e-12)
    across = 6 * (1 / np.pi - 0.5)
    np.testing.assert_allclose(flange.places.in_plane[[0, 2]], [6 / np.pi, across], rtol=1e-8)
    assert flange.summary.maximal_in_plane == pytest.approx(6 / np.pi)
