"""Hertz contacts and contacts with memory."""

import copy
import math
import pickle

import numpy as np
import pytest

import carom

STEEL = carom.Material(208e9, 0.3)
HERTZ = carom.hertz_of_spheres(0.01, 0.02, STEEL)
F = 0.3


def walk(n, seed=3):
    rng = np.random.default_rng(seed)
    zeta = 1e-6 * (1 + 0.8 * np.sin(np.linspace(0, 9, n) + 0.3 * rng.standard_normal(n).cumsum() / n))
    return zeta, 2e-8 * rng.standard_normal(n).cumsum(), 2e-8 * rng.standard_normal(n).cumsum()


def test_materials():
    pair = carom.MaterialPair(STEEL)
    assert pair.shear_modulus == pytest.approx(40e9)
    assert pair.kappa == pytest.approx(1.7 / 1.4)
    assert carom.MaterialPair(STEEL, carom.RIGID).gamma == pytest.approx(0.5 * 0.4 / 0.7)
    assert carom.Material(shear_modulus=80e9, poisson=0.3) == STEEL
    turned = carom.Hertz.of_radii(pair, (0.01, 0.03), (0.02, -0.5), 0.4)
    for thing in (STEEL, pair, carom.RIGID, HERTZ, turned):
        assert pickle.loads(pickle.dumps(thing)) == thing
        assert copy.deepcopy(thing) == thing
    with pytest.raises(ValueError, match="poisson"):
        carom.Material(1e9, 0.6)
    with pytest.raises(TypeError, match="young_modulus"):
        carom.Material()
    with pytest.raises(ValueError, match="rigid"):
        carom.MaterialPair(carom.RIGID)


def test_hertz_of_spheres_is_hertz():
    force = np.geomspace(1e-3, 1e3, 13)
    state = carom.hertz(HERTZ, force=force)
    e_star = 208e9 / (2 * (1 - 0.09))
    radius = 1 / (1 / 0.01 + 1 / 0.02)
    a = np.cbrt(0.75 * force * radius / e_star)
    np.testing.assert_allclose(state.semi_axis_a, a, rtol=1e-13)
    np.testing.assert_allclose(state.approach, a**2 / radius, rtol=1e-13)
    np.testing.assert_allclose(state.peak_pressure, 1.5 * force / (math.pi * a**2), rtol=1e-13)
    one = carom.hertz(HERTZ, approach=float(state.approach[3]))
    assert one.force == pytest.approx(force[3])
    assert isinstance(one.force, float)
    with pytest.raises(ValueError, match="force = -1") as caught:
        carom.hertz(HERTZ, force=[1.0, -1.0])
    assert caught.value.index == 1
    with pytest.raises(TypeError):
        carom.hertz(HERTZ)
    with pytest.raises(carom.CaromError, match="line"):
        carom.Hertz.of_radii(carom.MaterialPair(STEEL), (1.0, math.inf), (1.0, math.inf), 0.0)


def test_results_go_to_pandas_and_xarray():
    pandas = pytest.importorskip("pandas")
    state = carom.hertz(HERTZ, force=[1.0, 2.0])
    frame = state.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert len(frame) == 2
    assert frame.attrs["units"]["force"] == "N"
    pytest.importorskip("xarray")
    assert state.to_xarray()["force"].attrs["units"] == "N"
    ball = carom.sphere(0.01, STEEL, 0.033, velocity=(1, 0, -2))
    rebound = carom.collide(ball, carom.plane(STEEL), F)
    frame = rebound.to_pandas()
    assert set(frame.attrs["units"]) == set(frame.columns)
    assert frame.attrs["units"]["body_1_velocity_x"] == "m/s"
    assert float(rebound.to_xarray()["body_1_velocity"].sel(axis="z")) == frame["body_1_velocity_z"][0]


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction"])
def test_virgin_loading_is_cattaneos_and_mindlins(law):
    c_x, _, c_z = HERTZ.stiffness
    zeta = 1e-6
    for xi in np.linspace(0, 1.2, 13) * F * c_z * zeta / c_x:
        contact = carom.Contact(HERTZ, F, law)
        contact.advance(zeta)
        f_x, f_y, f_z = contact.advance(zeta, xi)
        part = max(0.0, 1 - c_x * xi / (F * c_z * zeta))
        assert f_z == pytest.approx(2 / 3 * c_z * zeta**1.5)
        assert f_x == pytest.approx(F * f_z * (1 - part**1.5), abs=1e-12 * f_z)
        assert f_y == 0.0


def test_path_is_followed_as_step_by_step():
    zeta, xi, eta = walk(200)
    one, two = carom.Contact(HERTZ, F), carom.Contact(HERTZ, F)
    steps = [one.advance(*shift) for shift in zip(zeta, xi, eta)]
    np.testing.assert_array_equal(two.follow(zeta, xi, eta), steps)
    assert one.dissipated == two.dissipated
    assert one.load == two.load
    strided = carom.Contact(HERTZ, F).follow(np.repeat(zeta, 2)[::2], list(xi), eta)
    np.testing.assert_array_equal(strided, steps)


@pytest.mark.parametrize(
    ("law", "friction"),
    [("coulomb", F), ("fixed-direction", F), ("coulomb", 0.0), ("coulomb", math.inf)],
)
def test_contacts_pickle_and_copy(law, friction):
    zeta, xi, eta = walk(100)
    contact = carom.Contact(HERTZ, friction, law)
    contacts = carom.Contacts(2, HERTZ, friction, law=law)
    contacts.follow(zeta[:60], xi[:60], eta[:60])
    np.testing.assert_allclose(pickle.loads(pickle.dumps(contacts)).loads, contacts.loads, rtol=1e-9)
    contact.follow(zeta[:60], xi[:60], eta[:60])
    others = [copy.copy(contact), copy.deepcopy(contact), pickle.loads(pickle.dumps(contact))]
    rest = contact.follow(zeta[60:], xi[60:], eta[60:])
    for other in others:
        again = other.follow(zeta[60:], xi[60:], eta[60:])
        np.testing.assert_allclose(again, rest, rtol=0, atol=1e-10 * rest[:, 2].max())
        assert other.dissipated == pytest.approx(contact.dissipated)


def test_a_state_of_contacts_is_taken_as_a_whole_or_not_at_all():
    zeta, xi, eta = walk(60)
    contacts = carom.Contacts(3, HERTZ, F)
    contacts.follow(zeta, xi, eta)
    before = contacts.loads.copy()
    other = carom.Contacts(3, HERTZ, F)
    other.follow(zeta[:30], xi[:30], eta[:30])
    state = other._native.__getstate__()
    state[1, 0] = 77.0
    with pytest.raises(carom.RangeError) as error:
        contacts._native.__setstate__(state)
    assert (error.value.field, error.value.index) == ("mark", 1)
    np.testing.assert_array_equal(contacts.loads, before)


def test_work_is_stored_or_heat():
    t = np.linspace(0, 1, 3001)
    zeta, xi = 1e-6 * np.minimum(1, 5 * t), 4e-7 * np.sin(9 * t)
    contact = carom.Contact(HERTZ, F, "fixed-direction")
    loads = contact.follow(zeta, xi)
    means = 0.5 * (loads[1:] + loads[:-1])
    work = (means[:, 2] * np.diff(zeta) + means[:, 0] * np.diff(xi)).sum()
    assert contact.dissipated > 0
    assert contact.stored_energy + contact.dissipated == pytest.approx(work, rel=1e-3)


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction"])
def test_without_heat_a_contact_goes_the_same_way(law):
    zeta, xi, eta = walk(40)
    told, bare = carom.Contact(HERTZ, F, law), carom.Contact(HERTZ, F, law, heat=False)
    np.testing.assert_array_equal(told.follow(zeta, xi, eta), bare.follow(zeta, xi, eta))
    again = pickle.loads(pickle.dumps(bare))
    # Its forces are summed anew.
    np.testing.assert_allclose(bare.follow(zeta, eta), again.follow(zeta, eta), rtol=1e-12)
    assert told.dissipated > 0
    assert bare.dissipated is None and again.dissipated is None
    assert bare.slip_turn is None and again.slip_turn is None
    told.follow(zeta, eta)
    for contact in (told, bare):
        contact.turn_frame(0.3)
    assert told.advance(2e-6) == bare.advance(2e-6)


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction"])
def test_slip_turns_by_the_corner_of_its_path(law):
    contact = carom.Contact((1e9, 1e9, 1.2e9), F, law)
    assert contact.slip_turn == 0
    contact.follow([1e-6, 1e-6], [0, 2e-6])
    assert contact.regime == "sliding" and contact.slip_turn == 0
    contact.advance(1e-6, 2e-6, 9e-6)
    assert contact.slip_turn == pytest.approx(math.pi / 2, abs=1e-6)
    # A small way back sticks.
    contact.advance(1e-6, 2e-6, 8.9e-6)
    assert contact.slip_turn == 0


def test_the_turn_of_slip_goes_on_in_copies_and_turned_axes():
    t = np.linspace(0, 3, 61)
    zeta, xi, eta = 1e-6 * (1 + t), 8e-6 * np.sin(2 * t), 5e-6 * np.cos(2 * t)
    contact = carom.Contact(HERTZ, F)
    contact.follow(zeta[:30], xi[:30], eta[:30])
    others = [copy.copy(contact), pickle.loads(pickle.dumps(contact))]
    turned = copy.deepcopy(contact)
    turned.turn_frame(0.5)
    for other in others:
        other.follow(zeta[30:], xi[30:], eta[30:])
    contact.follow(zeta[30:], xi[30:], eta[30:])
    assert contact.slip_turn > 1
    assert [other.slip_turn for other in others] == [contact.slip_turn] * 2
    s, c = math.sin(0.5), math.cos(0.5)
    turned.follow(zeta[30:], c * xi[30:] + s * eta[30:], c * eta[30:] - s * xi[30:])
    assert turned.slip_turn == pytest.approx(contact.slip_turn)
    # A path that fails turns nothing.
    with pytest.raises(ValueError):
        contact.follow([1e-6, math.nan])
    assert contact.slip_turn == others[0].slip_turn


def test_the_turn_of_slip_is_that_of_the_command(tmp_path):
    t = np.linspace(0, 4, 41)
    steps = np.stack([1e-6 * (2 - np.cos(t)), 6e-6 * np.sin(t), 9e-6 * np.cos(t) - 9e-6], axis=1)
    body = "material = { young_modulus = 208e9, poisson = 0.3 }\n"
    text = (
        f"[body_1]\nradii = 0.01\n{body}[body_2]\nradii = 0.02\n{body}"
        f"[contact]\nfriction = {F}\n[history]\nsteps = {steps.tolist()}\n"
    )
    path = tmp_path / "turning.toml"
    path.write_text(text)
    told = carom.cases.history(path).slip_turn
    contact, own = carom.Contact(HERTZ, F), []
    for step in steps:
        contact.advance(*step)
        own.append(contact.slip_turn)
    assert max(own) > 2
    # Other annuli are followed, since the command knows the deepest approach.
    np.testing.assert_allclose(own, told, atol=0.1)


def test_turned_axes():
    contact = carom.Contact(HERTZ, F)
    contact.advance(1e-6)
    f_x, f_y, _ = contact.advance(1e-6, 1e-7, 3e-8)
    contact.turn_frame(0.5)
    g_x, g_y, _ = contact.load
    assert g_x == pytest.approx(math.cos(0.5) * f_x + math.sin(0.5) * f_y)
    assert g_y == pytest.approx(math.cos(0.5) * f_y - math.sin(0.5) * f_x)
    with pytest.raises(ValueError, match="angle"):
        contact.turn_frame(math.nan)


def test_a_failed_step_changes_nothing():
    contact = carom.Contact(HERTZ, F)
    contact.advance(1e-6, 1e-7)
    before = contact.load, contact.shift
    with pytest.raises(ValueError, match="eta"):
        contact.advance(1e-6, 0.0, math.inf)
    with pytest.raises(carom.RangeError) as caught:
        contact.follow([1e-6, 2e-6, math.nan])
    assert (caught.value.field, caught.value.index) == ("zeta", 2)
    with pytest.raises(ValueError, match="xi has 1 entries"):
        contact.follow([1e-6, 2e-6], [0.0])
    assert (contact.load, contact.shift) == before
    for bad in [dict(law="mindlin"), dict(tolerance=1.0), dict(friction=-1.0), dict(stiffness=(1.0, 2.0))]:
        given = dict(stiffness=HERTZ, friction=F) | bad
        with pytest.raises(ValueError, match=next(iter(bad))):
            carom.Contact(**given)


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction"])
@pytest.mark.parametrize("directions", [1, 2])
def test_many_contacts_are_single_ones(law, directions):
    paths = [walk(60, seed) for seed in range(7)]
    zeta, xi, eta = (np.array(v) for v in zip(*paths))
    eta = None if directions == 1 else eta
    make = dict(law=law, directions=directions)
    steps, whole = carom.Contacts(7, HERTZ, F, **make), carom.Contacts(7, HERTZ, F, **make)
    loads = whole.follow(zeta, xi, eta)
    for i in range(60):
        one = steps.advance(zeta[:, i], xi[:, i], None if eta is None else eta[:, i])
        np.testing.assert_array_equal(one, loads[:, i])
    np.testing.assert_array_equal(steps.loads, loads[:, -1])
    np.testing.assert_array_equal(steps.stored_energy, whole.stored_energy)
    # Sixteen vertices and a coarser tolerance are within it of a fine contact.
    tolerance = 2e-2 if law == "coulomb" else 1e-2
    for k in range(7):
        fine = carom.Contact(HERTZ, F, law).follow(zeta[k], xi[k], None if eta is None else eta[k])
        assert np.abs(fine - loads[k]).max() <= tolerance * F * loads[k, :, 2].max()


def test_many_contacts_on_threads_copy_and_pickle():
    rng = np.random.default_rng(5)
    zeta, xi, eta = 1e-6 * rng.random((3, 2000, 20))
    one = carom.Contacts(2000, HERTZ, F)
    two = carom.Contacts(2000, HERTZ, F, threads=True)
    one.follow(zeta[:, :10], xi[:, :10], eta[:, :10])
    two.follow(zeta[:, :10], xi[:, :10], eta[:, :10])
    copies = [copy.copy(one), copy.deepcopy(one), two]
    kept = pickle.loads(pickle.dumps(one))
    out = np.empty((2000, 10, 3))
    rest = one.follow(zeta[:, 10:], xi[:, 10:], eta[:, 10:], out=out)
    assert rest is out
    for other in copies:
        np.testing.assert_array_equal(other.follow(zeta[:, 10:], xi[:, 10:], eta[:, 10:]), rest)
    again = kept.follow(zeta[:, 10:], xi[:, 10:], eta[:, 10:])
    # Where round-off decides whether pieces are joined, within the tolerance.
    assert np.abs(again - rest).max() <= 1e-2 * F * rest[..., 2].max()
    assert np.median(np.abs(again - rest)) <= 1e-12 * F * rest[..., 2].max()


def test_many_contacts_all_or_none():
    contacts = carom.Contacts(3, HERTZ, F)
    contacts.advance([1e-6, 1e-6, 1e-6], 1e-7, 0.0)
    before = contacts.loads
    with pytest.raises(carom.RangeError) as caught:
        contacts.advance([1e-6, math.nan, 1e-6])
    assert caught.value.index == 1
    with pytest.raises(carom.RangeError, match=r"xi = NaN.*\(contact 2, step 1\)") as caught:
        contacts.follow(np.full((3, 2), 1e-6), [[0.0, 0.0], [0.0, 0.0], [0.0, math.nan]])
    assert caught.value.index == (2, 1)
    np.testing.assert_array_equal(contacts.loads, before)
    with pytest.raises(ValueError, match="directions"):
        carom.Contacts(1, HERTZ, F, directions=3)
    with pytest.raises(ValueError, match="out"):
        contacts.follow(np.ones((3, 2)), out=np.empty((3, 3)))
    with pytest.raises(ValueError, match="eta"):
        carom.Contacts(1, HERTZ, F, directions=1).advance(1e-6, 0.0, 1e-7)


def test_twist():
    twist = carom.Twist(HERTZ, F)
    twist.advance(1e-6)
    m_z, f_z = twist.advance(1e-6, 9.0)
    a = carom.hertz(HERTZ, approach=1e-6).semi_axis_a
    assert m_z == pytest.approx(3 * math.pi / 16 * F * f_z * a)
    other = copy.copy(twist)
    other.advance(1e-6, -9.0)
    assert twist.advance(1e-6, 9.0)[0] == m_z
    both = carom.ShiftTwist(HERTZ, F)
    both.advance(1e-6)
    f_x, f_y, f_z, m_z = both.advance(1e-6, 1e-8, 0.0, 1e-5)
    assert 0 < f_x < F * f_z
    assert m_z > 0
    assert both.stored_energy > 0
    assert both.load == (f_x, f_y, f_z, m_z) and both.shift == (1e-6, 1e-8, 0.0, 1e-5)
    assert twist.load[1] == both.load[2] and twist.shift == (1e-6, 9.0)
    with pytest.raises(ValueError, match="omega"):
        both.advance(1e-6, omega=math.nan)
    third = carom.Twist(HERTZ, F)
    third.advance(1e-6)
    m_z, f_z = third.advance(1e-6, 1e-3)
    for one in (both, third):
        again = pickle.loads(pickle.dumps(one))
        assert again.dissipated == one.dissipated > 0
        assert (again.stored_energy, again.load, again.shift) == (one.stored_energy, one.load, one.shift)
    twist = carom.MaterialPair(STEEL).shear_modulus * a**2 * 1e-3 / (F * f_z)
    assert m_z / (F * f_z * a) == pytest.approx(carom.lubkin_torque(twist), rel=1e-12)
    np.testing.assert_allclose(carom.lubkin_stick_radius([0.0, 100.0]), [1.0, 0.0], atol=1e-6)


def test_stress_beneath_spheres():
    z = np.linspace(0, 3, 301)
    s = carom.stress((1.0, 1.0), STEEL, 1.0, 0.0, 0.0, z)
    # Johnson's closed forms on the axis.
    with np.errstate(divide="ignore", invalid="ignore"):
        arc = np.where(z > 0, z * np.arctan(1 / z), 0.0)
    szz = -1 / (1 + z**2)
    srr = -1.3 * (1 - arc) + 0.5 / (1 + z**2)
    np.testing.assert_allclose(s[:, 2], szz, atol=1e-12)
    np.testing.assert_allclose(s[:, 0], srr, atol=1e-12)
    np.testing.assert_allclose(carom.von_mises(s), np.abs(szz - srr), atol=1e-12)
    shape = carom.stress((1.0, 2.0), STEEL, 1.0, np.zeros((3, 1)), np.zeros(4), 0.5, traction=(0.3, 0.0)).shape
    assert shape == (3, 4, 6)
    with pytest.raises(ValueError, match="z = -1"):
        carom.stress((1.0, 1.0), STEEL, 1.0, 0.0, 0.0, -1.0)


ALUMINA, SODA = carom.Material(380e9, 0.23), carom.Material(70e9, 0.22)


def unlike():
    return carom.hertz_of_spheres(2e-3, float("inf"), ALUMINA, SODA)


def test_rings_couple_twist_and_approach_to_the_shift():
    """A path with twist: force and torque under Coulomb's limits, another force without twist, and nothing gained."""
    hertz, steps = unlike(), 200
    t = np.linspace(0.0, 1.0, steps)
    zeta = 1e-7 * (0.3 + 0.7 * t)
    xi, eta = 2e-9 * t, 1e-9 * np.sin(9 * t)
    omega = 1e-3 * t
    contact = carom.Contact(hertz, 0.092, law="rings")
    loads = contact.follow(zeta, xi, eta, omega)
    assert loads.shape == (steps, 4)
    assert (np.hypot(loads[:, 0], loads[:, 1]) <= 0.092 * loads[:, 2] * 1.05).all()
    assert contact.torque == loads[-1, 3] > 0 and contact.load == tuple(loads[-1, :3])
    assert contact.dissipated > 0 and 0.0 <= contact.sticking < 1.0 and contact.regime == "slip"
    with pytest.raises(ValueError, match="rings"):
        _ = contact.slip_turn
    alone = carom.Contact(hertz, 0.092, law="rings", heat=False).follow(zeta, xi, eta)
    assert alone.shape == (steps, 3)
    assert np.abs(alone[-1, :2] - loads[-1, :2]).max() > 0.02 * 0.092 * loads[-1, 2]
    again = pickle.loads(pickle.dumps(contact))
    assert again.load == contact.load and again.dissipated == contact.dissipated
    assert again.advance(1.1e-7, 3e-9, 0.0, 1.1e-3) == contact.advance(1.1e-7, 3e-9, 0.0, 1.1e-3)


def test_many_contacts_of_rings_are_each_the_one():
    hertz = unlike()
    zeta = np.tile(np.linspace(1e-8, 1e-7, 20), (3, 1))
    xi = np.linspace(0, 2e-9, 20) * np.array([[0.5], [1.0], [2.0]])
    omega = np.linspace(0, 1e-5, 20) * np.array([[1.0], [0.0], [-1.0]])
    many = carom.Contacts(3, hertz, 0.092, law="rings", threads=True)
    loads = many.follow(zeta, xi, omega=omega)
    for i in range(3):
        one = carom.Contact(hertz, 0.092, law="rings", tolerance=1e-2, heat=False)
        assert np.array_equal(one.follow(zeta[i], xi[i], omega=omega[i]), loads[i])
    assert np.array_equal(many.torques, loads[:, -1, 3]) and np.array_equal(many.loads, loads[:, -1, :3])
    again = pickle.loads(pickle.dumps(many._native))
    assert np.array_equal(again.loads, many.loads)


def test_laws_tell_what_they_neglect():
    hertz = unlike()
    gamma = hertz.materials.gamma
    bound = (gamma / 0.092) ** 2 / (4 + (gamma / 0.092) ** 2) + gamma**2
    assert carom.Contact(hertz, 0.092).coupling_bound == pytest.approx(bound)
    assert carom.Contacts(2, hertz, 0.092).coupling_bound == pytest.approx(bound)
    # Once it slides, kinetic friction counts.
    assert carom.Contact(hertz, 0.092, static_friction=0.3).coupling_bound == pytest.approx(bound)
    assert carom.Contact(hertz, 0.092, law="rings").coupling_bound == 0
    assert carom.Contact(carom.hertz_of_spheres(1.0, 1.0, SODA), 0.1).coupling_bound == 0
    assert carom.Contact((1.0, 1.0, 1.2), 0.1).coupling_bound is None


def test_what_rings_do_not_do_is_named():
    hertz = unlike()
    with pytest.raises(ValueError, match="Hertz"):
        carom.Contact((1.0, 1.0, 1.2), 0.3, law="rings")
    with pytest.raises(ValueError, match="curvature ratio"):
        carom.Contact(carom.Hertz(carom.MaterialPair(SODA), 2.0, 1.0), 0.3, law="rings")
    with pytest.raises(ValueError, match="rings"):
        carom.Contact(hertz, 0.3, law="mindlin")
    contact = carom.Contact(hertz, 0.3, law="rings")
    for ask in (lambda: contact.tangent, lambda: contact.traction(0.5), lambda: contact.turn_frame(0.1)):
        with pytest.raises(ValueError, match="rings"):
            ask()
    with pytest.raises(ValueError, match="omega"):
        carom.Contact(hertz, 0.3).advance(1e-7, 0.0, 0.0, 1e-5)
    with pytest.raises(ValueError, match="omega"):
        carom.Contacts(2, hertz, 0.3).advance(1e-7, omega=1e-5)


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction"])
def test_static_friction_holds_up_to_its_limit(law):
    """Up to f_s F_z as with f_s; beyond, sliding with f_k; in a pickle, and in many contacts too."""
    c_x, _, c_z = HERTZ.stiffness
    held, zeta = 1.5 * F, 1e-6
    reach = c_z * zeta / c_x
    contact = carom.Contact(HERTZ, F, law, static_friction=held)
    high = carom.Contact(HERTZ, held, law)
    for one in (contact, high):
        one.advance(zeta)
    xi = 0.99 * held * reach
    assert contact.advance(zeta, xi) == pytest.approx(high.advance(zeta, xi), rel=1e-12)
    assert contact.load[0] > 1.4 * F * contact.load[2]
    again = pickle.loads(pickle.dumps(contact))
    for one in (contact, again):
        f_x, _, f_z = one.advance(zeta, 1.01 * held * reach)
        assert f_x == pytest.approx(F * f_z, rel=1e-9)
    many = carom.Contacts(3, HERTZ, F, law=law, static_friction=held, directions=1)
    many.advance(zeta)
    loads = pickle.loads(pickle.dumps(many)).advance(zeta, xi=np.array([xi, xi, 1.01 * held * reach]))
    assert loads[:, 0] / (F * loads[:, 2]) == pytest.approx([loads[0, 0] / (F * f_z)] * 2 + [1.0], rel=1e-9)
    assert loads[0, 0] > 1.4 * F * f_z


def test_static_friction_that_is_not_allowed_is_named():
    with pytest.raises(carom.RangeError, match=r"static_friction = 0\.1"):
        carom.Contact(HERTZ, 0.2, static_friction=0.1)
    with pytest.raises(ValueError, match="static_friction: not for law = 'rings'"):
        carom.Contacts(2, HERTZ, 0.2, law="rings", static_friction=0.3)
