"""Every argument reaches its place, and every number comes back from its own: by mechanics and closed forms."""

import copy
import pickle

import carom
import numpy as np
import pytest
from carom import plot

GLASS, STEEL = carom.Material(70e9, 0.22), carom.Material(208e9, 0.3)


def test_unlike_spheres_touch_as_hertz_says():
    contact = carom.hertz_of_spheres(0.01, 0.03, GLASS, STEEL)
    modulus, radius = 1 / ((1 - 0.22**2) / 70e9 + (1 - 0.09) / 208e9), 0.0075
    state = carom.hertz(contact, approach=1e-6)
    force = 4 / 3 * modulus * np.sqrt(radius * 1e-6**3)
    a = np.sqrt(radius * 1e-6)
    expected = {"force": force, "approach": 1e-6, "semi_axis_a": a, "semi_axis_b": a,
                "peak_pressure": 1.5 * force / (np.pi * a**2), "normal_stiffness": 1.5 * force / 1e-6}
    assert state.to_dict() == pytest.approx(expected, rel=1e-12)
    # Each of the four may be given.
    for name in ("force", "semi_axis_a", "semi_axis_b"):
        assert carom.hertz(contact, **{name: expected[name]}).to_dict() == pytest.approx(expected, rel=1e-9)


def test_axes_of_an_ellipse_and_crossed_cylinders():
    pair = carom.MaterialPair(GLASS)
    along_x = carom.Hertz(pair, 50.0, 5.0)
    state = carom.hertz(along_x, force=10.0)
    assert along_x.curvature == (50.0, 5.0) and state.semi_axis_a < state.semi_axis_b
    assert along_x.axis_ratio == pytest.approx(state.semi_axis_a / state.semi_axis_b)
    # A cylinder along y on a plane that is curved along y: curvatures 1/(2 r) of each.
    inf = float("inf")
    crossed = carom.Hertz.of_radii(pair, (0.01, inf), (inf, 0.04), 0.0)
    assert sorted(crossed.curvature, reverse=True) == pytest.approx([50.0, 12.5])
    turned = carom.Hertz.of_radii(pair, (0.01, inf), (0.04, inf), np.pi / 2)
    assert turned.curvature == pytest.approx(crossed.curvature)


def test_stress_of_a_pushed_contact():
    a, p = 1e-3, 2e6
    at = np.array([0.0])
    for tx, ty in ((3e5, 0.0), (0.0, -2e5), (1e5, 2e5)):
        for stick in (0.0, 0.5):
            s = carom.stress((a, a), STEEL, p, at, at, at, traction=(tx, ty), stick_radius=stick)[0]
            # Cattaneo and Mindlin: in the middle 1 - c/a of the greatest friction is left.
            assert np.allclose(np.abs(s[[5, 4]]), (1 - stick) * np.abs([tx, ty]), rtol=1e-6, atol=1.0)
            assert s[5] * ty == pytest.approx(s[4] * tx, abs=1e3 * p) and s[2] == pytest.approx(-p)
    # Slender along x: halfway to its end, where across it nothing touches any more.
    inside = carom.stress((2 * a, a), STEEL, p, 1.5 * a, 0.0, 0.0)
    assert inside[2] == pytest.approx(-p * np.sqrt(1 - 0.75**2), rel=1e-6)
    assert carom.stress((2 * a, a), STEEL, p, 0.0, 1.5 * a, 0.0)[2] == pytest.approx(0.0, abs=1e-6 * p)


def test_von_mises_counts_every_part():
    for part in range(3):
        assert carom.von_mises(np.eye(6)[part]) == pytest.approx(1.0)
    for part in range(3, 6):
        assert carom.von_mises(np.eye(6)[part]) == pytest.approx(np.sqrt(3))
    assert carom.von_mises([1, 1, 1, 0, 0, 0]) == 0.0


def test_restitution_of_groups_is_exact_where_asked():
    chi, psi = 2.9, 1.3
    table, exact = (carom.restitution_of_groups(chi, psi, exact=e) for e in (False, True))
    assert 1e-13 < abs(table - exact) < 1e-8
    kappa = carom.MaterialPair(GLASS).kappa
    ball = carom.sphere(0.01, GLASS, 0.01, velocity=(1.0, 0.0, -2.0))
    rebound = carom.collide(ball, carom.plane(GLASS), 0.2)
    lam = 0.5 / 0.2
    assert rebound.R_x == pytest.approx(carom.restitution(kappa, lam, exact=True), abs=1e-13)
    assert abs(rebound.R_x - carom.restitution(kappa, lam)) > 1e-13
    assert rebound.R_x == pytest.approx(
        carom.restitution_of_groups(3.5 / kappa, lam / kappa, exact=True), abs=1e-13
    )


def turn(attitude):
    w, i, j, k = attitude
    return np.array([
        [w * w + i * i - j * j - k * k, 2 * (i * j - w * k), 2 * (i * k + w * j)],
        [2 * (i * j + w * k), w * w - i * i + j * j - k * k, 2 * (j * k - w * i)],
        [2 * (i * k - w * j), 2 * (j * k + w * i), w * w - i * i - j * j + k * k],
    ])


ATTITUDE = (np.cos(0.35), np.sin(0.35) / 3, 2 * np.sin(0.35) / 3, 2 * np.sin(0.35) / 3)


@pytest.mark.parametrize("hollow, moments", [(False, None), (True, None), (False, (3e-5, 2e-5, 4e-5))])
def test_an_impact_obeys_mechanics(hollow, moments):
    axes = (0.03, 0.02, 0.015)
    one = carom.Body("ellipsoid", axes, GLASS, 0.1, moments=moments, attitude=ATTITUDE,
                     velocity=(0.6, 0.4, -2.0), spin=(6.0, -11.0, 20.0))
    two = carom.sphere(0.05, STEEL, 0.4, hollow=hollow, velocity=(-0.2, 0.1, 0.3), spin=(3.0, 1.0, -4.0))
    normal = np.array([0.0, 0.6, 0.8])
    r = carom.collide(one, two, 0.25, normal=normal)
    a, b, c = axes
    own = moments or tuple(0.02 * s for s in (b * b + c * c, a * a + c * c, a * a + b * b))
    matrix = turn(ATTITUDE)
    tensor = [matrix @ np.diag(own) @ matrix.T, np.eye(3) * (2 / 3 if hollow else 2 / 5) * 0.4 * 0.0025]
    assert np.allclose(0.1 * (r.body_1_velocity - one.velocity), r.impulse, atol=1e-12)
    assert np.allclose(0.4 * (r.body_2_velocity - two.velocity), -r.impulse, atol=1e-12)
    # The ellipsoid's place of touch from its centre: its support against the normal.
    across = matrix @ (np.square(axes) * (matrix.T @ -normal))
    arms = [across / np.sqrt(-normal @ across), 0.05 * normal]
    changes = [r.body_1_spin - one.spin, r.body_2_spin - two.spin]
    for inertia, change, arm, sign in zip(tensor, changes, arms, (1, -1)):
        assert np.allclose(inertia @ change, np.cross(arm, sign * r.impulse), atol=1e-10)
    energy = [0.0, 0.0]
    slip = [np.zeros(3), np.zeros(3)]
    states = [[(one.velocity, one.spin), (two.velocity, two.spin)],
              [(r.body_1_velocity, r.body_1_spin), (r.body_2_velocity, r.body_2_spin)]]
    for when, motions in enumerate(states):
        for mass, inertia, (v, w), arm, sign in zip((0.1, 0.4), tensor, motions, arms, (-1, 1)):
            energy[when] += 0.5 * mass * np.dot(v, v) + 0.5 * np.asarray(w) @ inertia @ w
            slip[when] = slip[when] + sign * (np.asarray(v) + np.cross(w, arm))
    assert r.energy_before == pytest.approx(energy[0], rel=1e-12)
    assert r.energy_after == pytest.approx(energy[1], rel=1e-9)
    assert r.energy_dissipated == pytest.approx(energy[0] - energy[1], rel=1e-9) and r.energy_lost == 0.0
    assert np.allclose(r.contact_velocity_before, slip[0]) and np.allclose(r.contact_velocity_after, slip[1])
    along = [v - (v @ normal) * normal for v in slip]
    assert r.R_x == pytest.approx(-(along[1] @ along[0]) / (along[0] @ along[0]), rel=1e-9)
    assert r.maximal_semi_axis_a < r.maximal_semi_axis_b and r.error_estimate > 0
    assert carom.Body.__name__ in repr(one) and pickle.loads(pickle.dumps(one)).attitude == tuple(ATTITUDE)


def test_friction_acts_on_the_spin_about_the_normal_where_it_matters_or_as_told():
    ball = carom.sphere(0.01, GLASS, 0.01, velocity=(0.0, 0.0, -2.0), spin=(0.0, 0.0, 60.0))
    plate = carom.plane(GLASS)
    alone = carom.collide(ball, plate, 0.2, torsion=False)
    taken = carom.collide(ball, plate, 0.2, torsion=True)
    assert alone.body_1_spin[2] == 60.0 and abs(taken.body_1_spin[2]) < 59.99
    assert taken.energy_dissipated > 0 and taken.energy_after < alone.energy_after
    for torsion, once in ((False, alone), (True, taken)):
        many = carom.collide_many(ball, plate, [0.2, 0.2], torsion=torsion)
        assert np.array_equal(many.body_1_spin, [once.body_1_spin] * 2)
    # By default with the shift, by rings; without one as the torsional impact alone.
    fast = carom.sphere(0.01, GLASS, 0.01, velocity=(0.0, 0.0, -2.0), spin=(0.0, 0.0, 600.0))
    default, told = (carom.collide(fast, plate, 0.2, **given) for given in ({}, {"torsion": True}))
    assert default.method == "uncoupled" and np.array_equal(default.body_1_spin, told.body_1_spin)
    oblique = fast.moving((0.2, 0.0, -2.0), (0.0, 0.0, 300.0))
    counted, left_out = carom.collide(oblique, plate, 0.2), carom.collide(oblique, plate, 0.2, torsion=False)
    assert (counted.method, left_out.method) == ("rings", "uncoupled")
    assert counted.R_x > left_out.R_x + 0.1 and counted.body_1_spin[2] < 300.0 == left_out.body_1_spin[2]
    assert "torsion is not computed" in left_out.warnings and counted.warnings == "" and counted.error_estimate > 0.0


def test_the_law_and_the_tolerance_of_an_impact_are_those_asked_for():
    one = carom.Body("ellipsoid", (0.03, 0.02, 0.015), GLASS, 0.1, attitude=ATTITUDE,
                     velocity=(1.0, 0.7, -2.0), spin=(6.0, -11.0, 20.0))
    two = carom.plane(GLASS)
    ends = {}
    for law in ("coulomb", "fixed-direction"):
        rebound = carom.collide(one, two, 0.3, law=law)
        many = carom.collide_many(one, two, [0.3], law=law)
        course = carom.history(one, two, 0.3, 11, law=law)
        assert np.array_equal(many.body_1_velocity[0], rebound.body_1_velocity)
        # In contact axes: the size of the velocity after, and no force any more.
        assert np.linalg.norm(course.v[-1]) == pytest.approx(np.linalg.norm(rebound.contact_velocity_after), rel=1e-4)
        assert course.time[-1] == pytest.approx(rebound.duration, rel=1e-3)
        assert 0 < course.semi_axis_a[5] < course.semi_axis_b[5]
        ends[law] = np.linalg.norm(course.v[-1]), course.v[-1]
    assert np.abs(ends["coulomb"][1] - ends["fixed-direction"][1]).max() > 1e-4
    still = carom.Body("ellipsoid", (0.03, 0.02, 0.015), GLASS, 0.1, attitude=ATTITUDE, velocity=(1.0, 0.7, -2.0))
    coarse, fine = (carom.collide(still, two, 0.3, tolerance=t) for t in (1e-2, 1e-6))
    # What the law errs where the slip turns is left at any tolerance.
    assert 1e-5 < fine.error_estimate < 1e-2 and not np.array_equal(coarse.body_1_velocity, fine.body_1_velocity)
    assert np.abs(coarse.body_1_velocity - fine.body_1_velocity).max() < 0.03
    # That no law counts the spin of an ellipsoid about the normal is an error of any tolerance.
    assert carom.collide(one, two, 0.3, tolerance=1e-6).error_estimate > 1e-3


def turning(n):
    angle = np.linspace(0, 5, n)
    return np.full(n, 1e-6) * (1 + 0.2 * np.sin(angle)), 2e-7 * np.cos(angle), 3e-7 * np.sin(1.3 * angle)


def test_many_contacts_have_the_law_and_the_tolerance_asked_for():
    stiffness = (1e9, 0.9e9, 1.2e9)
    zeta, xi, eta = turning(60)
    rows = [np.stack([x, 0.8 * x]) for x in (zeta, xi, eta)]

    def many(**how):
        return carom.Contacts(2, stiffness, 0.3, **how).follow(*rows)

    exact = many(tolerance=1e-6)
    single = carom.Contact(stiffness, 0.3, tolerance=1e-6)
    assert np.allclose(single.follow(zeta, xi, eta), exact[0], atol=1e-4 * np.abs(exact).max())
    limit = 0.3 * exact[..., 2:]
    assert np.abs((many(tolerance=1e-5) - exact) / limit).max() < 1e-5
    assert np.abs((many() - exact) / limit).max() > 1e-5
    chapter = many(law="fixed-direction")
    one = carom.Contact(stiffness, 0.3, "fixed-direction")
    assert np.allclose(one.follow(zeta, xi, eta), chapter[0], rtol=1e-9, atol=1e-12)
    assert np.abs((chapter - exact) / limit).max() > 1e-3


def test_a_contact_tells_its_shift_load_and_tangent_in_order():
    contact = carom.Contact((1e9, 0.7e9, 1.2e9), 0.4)
    contact.advance(1e-6)
    at = np.array([1.1e-6, 1.2e-7, -0.8e-7])
    load = contact.advance(*at)
    assert contact.shift == tuple(at) and contact.load == load
    assert load[0] > 0 > load[1] and load[2] == pytest.approx(2 / 3 * 1.2e9 * 1.1e-6**1.5)
    # Rows F_x, F_y, F_z; columns xi, eta, zeta: the way on, along the last step.
    step = at - (1e-6, 0.0, 0.0)
    on = copy.copy(contact)
    h = 1e-4
    ahead = np.subtract(on.advance(*(at + h * step)), load)
    expected = np.array(contact.tangent) @ (h * step[[1, 2, 0]])
    assert np.allclose(ahead, expected, rtol=2e-3)
    # Through the axes of x and y alone, by the friction of the other.
    r = contact.traction(0.0)
    assert r[0] > 0 > r[1]
    contact.turn_frame(np.pi / 2)
    assert contact.load[:2] == pytest.approx((load[1], -load[0]))


def test_a_twist_beside_a_shift_tells_each_in_its_place():
    hertz = carom.hertz_of_spheres(0.01, float("inf"), GLASS)
    both, twist, shift = carom.ShiftTwist(hertz, 0.3), carom.Twist(hertz, 0.3), carom.Contact(hertz, 0.3)
    for zeta, xi, eta, omega in ((1e-6, 0, 0, 0), (1.1e-6, 5e-8, -3e-8, 1e-4), (1e-6, 9e-8, 2e-8, -2e-4)):
        f_x, f_y, f_z, m_z = both.advance(zeta, xi, eta, omega)
        of_twist, of_shift = twist.advance(zeta, omega), shift.advance(zeta, xi, eta)
        assert (m_z, f_z) == pytest.approx(of_twist) and (f_x, f_y, f_z) == pytest.approx(of_shift)
        assert both.shift == (zeta, xi, eta, omega) and twist.shift == (zeta, omega)
        assert both.load == (f_x, f_y, f_z, m_z) and twist.load == of_twist
    assert m_z < 0 < f_x and 0 < twist.stick_radius < 1
    pressed = 0.4 * f_z * 1e-6
    assert both.stored_energy - pressed == pytest.approx(
        twist.stored_energy - pressed + shift.stored_energy - pressed, rel=1e-9
    )
    assert both.dissipated == pytest.approx(twist.dissipated + shift.dissipated, rel=1e-6)


def test_what_sticks_on_a_grid_is_displaced_with_the_shift():
    x, y = carom.cells((24, 30), size=(6e-4, 5e-4))
    gap = x**2 / 0.02 + y**2 / 0.02
    solver = carom.Solver(gap, (6e-4, 5e-4), carom.MaterialPair(STEEL), friction=0.8)
    assert solver.size == (6e-4, 5e-4) and solver.shape == (24, 30)
    assert np.array_equal(solver.gap, gap) and np.array_equal(copy.copy(solver).gap, gap)
    solver.step(zeta=2e-6)
    solver.step(xi=3e-7, eta=-2e-7, omega=1e-4)
    stuck = solver.cells == 1
    assert stuck.sum() > 50
    # (12.2): u = xi + y Omega, v = eta - x Omega.
    assert np.allclose(solver.displacement_x[stuck], 3e-7 + 1e-4 * y[stuck], atol=1e-12)
    assert np.allclose(solver.displacement_y[stuck], -2e-7 - 1e-4 * x[stuck], atol=1e-12)
    for name, load in (("traction_x", "F_x"), ("traction_y", "F_y"), ("pressure", "F_z")):
        area = 6e-4 / 30 * 5e-4 / 24
        assert getattr(solver, name).sum() * area == pytest.approx(getattr(solver.summary(), load), rel=1e-9)


def test_a_cut_solver_that_is_copied_ends_where_it_did():
    flat = np.zeros((8, 10))
    solver = carom.Solver(flat, (1e-3, 0.8e-3), carom.MaterialPair(STEEL), 0.3, cut=True)
    solver.step(zeta=1e-7)
    for other in (copy.copy(solver), copy.deepcopy(solver), pickle.loads(pickle.dumps(solver))):
        assert other.step(zeta=2e-7).F_z == pytest.approx(2 * solver.summary().F_z)


def test_pictures_show_what_they_name():
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    lam = np.linspace(0.5, 9, 8)
    lines = plot.restitution([1.0, 1.4], lam).get_lines()
    for line, kappa in zip(lines, (1.0, 1.4), strict=True):
        assert np.array_equal(line.get_xdata(), lam)
        assert np.array_equal(line.get_ydata(), carom.restitution(kappa, lam))
        assert line.get_label() == f"κ = {kappa:.4g}"
    ball = carom.sphere(0.01, GLASS, 0.01, velocity=(1.0, 0.6, -2.0))
    course = carom.history(ball, carom.plane(GLASS), 0.15, 21)
    for i, line in enumerate(plot.history(course).get_lines()):
        assert np.allclose(line.get_xdata(), 1e6 * course.time)
        assert np.allclose(line.get_ydata(), 1e-3 * course.F[:, i]) and line.get_label() == f"$F_{'xyz'[i]}$"
    contact = carom.Contact((1e9, 1e9, 1e9), 0.3)
    shift = np.array([0.0, 1e-7, 2e-7])
    loads = contact.follow(np.full(3, 1e-6), shift, np.array([0.0, 5e-8, 5e-8]))
    (line,) = plot.loop(shift, loads).get_lines()
    assert np.allclose(line.get_xdata(), 1e9 * shift) and np.allclose(line.get_ydata(), 1e3 * loads[:, 0])
