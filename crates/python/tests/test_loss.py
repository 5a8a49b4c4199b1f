"""Impacts that lose energy: one material, one answer."""

import numpy as np
import pytest

import carom

LAMBDAS = [0.2, 1.0, 2.0, 3.0, 4.0, 6.0]
# Solid spheres, kappa = 1.2, from rows of springs by other programs.
KNOWN = {
    0.9: [-0.07618, 0.03910, 0.27456, 0.39210, 0.37984, 0.10833],
    0.5: [0.13629, 0.14617, 0.15564, 0.18643, 0.18654, -0.12500],
}


@pytest.mark.parametrize("e", KNOWN)
def test_restitution_of_a_viscous_material(e):
    exact = carom.restitution(1.2, LAMBDAS, normal_restitution=e, exact=True)
    np.testing.assert_allclose(exact, KNOWN[e], atol=2e-5)
    table = carom.restitution(1.2, LAMBDAS, normal_restitution=e)
    np.testing.assert_allclose(table, KNOWN[e], atol=3e-3)
    groups = carom.restitution_of_groups(3.5 / 1.2, np.array(LAMBDAS) / 1.2, normal_restitution=e)
    np.testing.assert_allclose(groups, table, atol=1e-12)


def test_restitutions_are_an_array_beside_the_others():
    both = carom.restitution(1.2, 2.0, normal_restitution=[1.0, 0.5])
    assert both[0] == carom.restitution(1.2, 2.0)
    assert both[1] == pytest.approx(0.15564, abs=3e-3)
    with pytest.raises(carom.RangeError, match="normal_restitution"):
        carom.restitution(1.2, 2.0, normal_restitution=1.1)
    with pytest.raises(ValueError, match="normal_restitution: is that of like materials"):
        carom.restitution(1.2, 2.0, gamma=0.2, friction=0.3, normal_restitution=0.5)


def ball_and_floor():
    material = carom.Material(1e10, 0.3)
    mass = 2600 * 4 / 3 * np.pi * 1e-9
    return carom.sphere(1e-3, material, mass, velocity=(0.4, 0, -0.6105571226)), carom.plane(material)


def test_a_ball_leaves_as_its_material_has_it():
    known = {0.9: 0.2557, 0.7: 0.1956, 0.5: 0.1564, 0.3: 0.1102}
    for e, r_x in known.items():
        rebound = carom.collide(*ball_and_floor(), 0.35, normal_restitution=e)
        assert rebound.R_x == pytest.approx(r_x, abs=1.5e-4)
        assert rebound.error_estimate > 0


def test_a_loss_by_yield_has_its_own_name():
    elastic = carom.collide(*ball_and_floor(), 0.35)
    yields = carom.collide(*ball_and_floor(), 0.35, normal_restitution=0.5, loss="yield")
    assert yields.R_x == pytest.approx(0.75 * (1 + elastic.R_x) - 1, rel=1e-12)
    viscous = carom.collide(*ball_and_floor(), 0.35, normal_restitution=0.5, loss="viscous")
    assert viscous.R_x == carom.collide(*ball_and_floor(), 0.35, normal_restitution=0.5).R_x
    with pytest.raises(ValueError, match="loss"):
        carom.collide(*ball_and_floor(), 0.35, normal_restitution=0.5, loss="plastic")
    for other in ({}, {"relaxation": 1e-6}, {"wave_loss": True}):
        with pytest.raises(ValueError, match="loss: is the cause of a normal_restitution"):
            carom.collide(*ball_and_floor(), 0.35, loss="yield", **other)


def test_each_of_many_impacts_has_its_own_loss():
    body_1, body_2 = ball_and_floor()
    e = np.array([1.0, 0.9, 0.5, 0.3])
    many = carom.collide_many(body_1, body_2, 0.35, normal_restitution=e)
    alone = [carom.collide(body_1, body_2, 0.35, normal_restitution=float(one)).R_x for one in e]
    assert many.R_x.tolist() == alone
    times = np.array([0.0, 1e-7, 1e-6])
    slower = carom.collide_many(body_1, body_2, 0.35, relaxation=times)
    alone = [carom.collide(body_1, body_2, 0.35, relaxation=float(one)).R_x for one in times]
    assert slower.R_x.tolist() == alone
    with pytest.raises(ValueError, match="motions, frictions and loss: must have the same length"):
        carom.collide_many(body_1, body_2, [0.3, 0.4], normal_restitution=e)
    with pytest.raises(ValueError, match="normal_restitution = 1.5 is out of range"):
        carom.collide_many(body_1, body_2, 0.35, normal_restitution=[0.5, 1.5])


def test_other_materials_have_their_own_names():
    """Solid spheres, kappa 1.2, e .8, R_x at lambda 1 by springs of another program."""
    material = carom.Material(1e10, 2 / 7)
    speeds = (0.35, 0, -1)
    for loss, known in [("viscous", 0.08546), ("maxwell", -0.0138), ("constant-loss-tangent", 0.0125)]:
        ball = carom.sphere(0.01, material, 0.01, velocity=speeds)
        rebound = carom.collide(ball, carom.plane(material), 0.35, normal_restitution=0.8, loss=loss)
        assert rebound.R_x == pytest.approx(known, abs=2e-4), loss
    solid = carom.collide(*ball_and_floor(), 0.35, normal_restitution=0.8, loss="standard-solid").R_x
    assert solid == pytest.approx(carom.collide(*ball_and_floor(), 0.35, normal_restitution=0.8).R_x, abs=8e-3)
    unlike = carom.sphere(0.01, carom.Material(1e9, 0.1), 0.01, velocity=speeds)
    with pytest.raises(carom.CaromError, match="something couples normal and tangential motion"):
        carom.collide(unlike, carom.plane(material), 0.35, normal_restitution=0.8, loss="maxwell")


def test_a_restitution_by_speed_is_that_of_its_speed():
    body_1, body_2 = ball_and_floor()
    by_speed = carom.RestitutionBySpeed([0.2, 1.0], [0.9, 0.5])
    e = by_speed.at(0.6105571226)
    assert e == pytest.approx(np.interp(0.6105571226, [0.2, 1.0], [0.9, 0.5]))
    one = carom.collide(body_1, body_2, 0.35, normal_restitution=by_speed)
    assert one.R_x == pytest.approx(carom.collide(body_1, body_2, 0.35, normal_restitution=e).R_x, abs=1e-12)
    speeds = np.array([0.1, 0.4, 3.0])
    many = carom.collide_many(
        body_1, body_2, 0.35, body_1_velocity=[(0.4, 0, -v) for v in speeds], normal_restitution=by_speed, loss="yield"
    )
    np.testing.assert_allclose(many.body_1_velocity[:, 2] / speeds, [0.9, 0.8, 0.5], rtol=1e-12)
    with pytest.raises(ValueError, match="mutually exclusive"):
        carom.collide(body_1, body_2, 0.35, normal_restitution=by_speed, relaxation=1e-6)
    for speed, restitution, named in [([1.0], [0.5], "speed"), ([1, 2], [0.5, 1.5], "restitution"), ([2, 1], [0.5, 0.5], "speed")]:
        with pytest.raises(carom.RangeError, match=named):
            carom.RestitutionBySpeed(speed, restitution)


def test_a_history_has_the_loss():
    body_1, body_2 = ball_and_floor()
    course = carom.history(body_1, body_2, 0.35, normal_restitution=0.5)
    rebound = carom.collide(body_1, body_2, 0.35, normal_restitution=0.5)
    np.testing.assert_allclose(course.v[-1], rebound.contact_velocity_after, atol=1e-9)
    assert course.F[:, 2].max() == pytest.approx(rebound.maximal_force, rel=1e-2)
    np.testing.assert_array_equal(course.normal, np.tile([0.0, 0.0, 1.0], (101, 1)))


def test_a_history_of_glancing_balls_turns():
    soft = carom.Material(1e7, 0.3)
    comes = carom.sphere(4.5e-3, soft, 9.5e-4, velocity=(0.48, 0, -0.13))
    course = carom.history(comes, carom.sphere(4.5e-3, soft, 9.5e-4), 0.0, 51)
    turn = np.arctan2(course.normal[:, 0], course.normal[:, 2])
    assert turn[0] == 0 and np.all(np.diff(turn) > 0)
    assert turn[-1] == pytest.approx(0.48 * course.time[-1] / 9e-3, rel=0.05)


def test_glancing_balls_turn_their_line_of_centres():
    resin = carom.Material(5.84e9, 0.34)
    for degrees, known in [(80, 0.4540), (85, 0.1849), (88, 0.0213)]:
        angle = np.radians(degrees)
        comes = carom.sphere(28.575e-3, resin, 0.17, velocity=(3 * np.sin(angle), 0, -3 * np.cos(angle)))
        rebound = carom.collide(comes, carom.sphere(28.575e-3, resin, 0.17), 0.0)
        assert abs(rebound.contact_velocity_after[2]) == pytest.approx(known, abs=1.5e-3)
