"""Impacts and restitution."""

import _thread
import copy
import math
import os
import pickle
import signal
import threading
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

import carom

STEEL = carom.Material(208e9, 0.3)
BALL = carom.sphere(0.01, STEEL, 0.033, velocity=(1.0, 0.5, -2.0), spin=(3.0, -20.0, 0.0))
PLATE = carom.plane(STEEL)
KAPPA = carom.MaterialPair(STEEL).kappa


def test_friction_by_the_slip_speed_is_that_at_the_first_touch():
    friction = carom.SlipSpeedFriction(0.05, 0.1, 0.25)
    speeds = np.array([0.0, 0.7, 3.0])
    expected = 0.05 + 0.1 * np.exp(-0.25 * speeds)
    np.testing.assert_allclose(friction.at(speeds), expected, rtol=1e-15)
    assert type(friction.at(0.7)) is float and pickle.loads(pickle.dumps(friction)) == friction
    velocities = np.stack([speeds, 0 * speeds, np.full(3, -0.1)], axis=1)
    ball = carom.sphere(0.01, STEEL, 0.033)
    many = carom.collide_many(ball, PLATE, friction, body_1_velocity=velocities)
    np.testing.assert_allclose(many.friction, expected, rtol=1e-15)
    # It slides throughout at the two higher speeds: v_x' = v_x - 2 f v_z.
    after = speeds - 2 * expected * 0.1
    np.testing.assert_allclose(many.body_1_velocity[1:, 0], after[1:], rtol=1e-13)
    for speed, r_x in zip(speeds, many.R_x, strict=True):
        one = carom.sphere(0.01, STEEL, 0.033, velocity=(speed, 0, -0.1))
        assert carom.collide(one, PLATE, friction).R_x == r_x
        force = carom.history(one, PLATE, friction, 11).F
        limit = friction.at(speed) * force[:, 2]
        assert (np.abs(force[:, 0]) <= limit * (1 + 1e-12)).all()
    for wrong in [(-0.1, 0.3, 1), (0.1, -0.2, 1), (0.1, 0.2, -1), (0.1, math.nan, 1)]:
        with pytest.raises(carom.RangeError):
            carom.SlipSpeedFriction(*wrong)


def test_static_friction_is_a_threshold_of_sliding():
    ball = carom.sphere(0.01, STEEL, 0.033, velocity=(0.4, 0, -1))
    one = carom.collide(ball, PLATE, 0.2, static_friction=0.4)
    assert one.friction == 0.2 and one.method == "planar"
    many = carom.collide_many(ball, PLATE, np.array([0.2, 0.3]), static_friction=0.4)
    assert many.R_x[0] == one.R_x
    lost = one.energy_before - one.energy_after
    assert abs(lost - one.energy_dissipated) < 1e-9 * one.energy_before
    assert carom.collide(ball, PLATE, 0.2, static_friction=0.2).R_x == carom.collide(ball, PLATE, 0.2).R_x
    force = carom.history(ball, PLATE, 0.2, 400, static_friction=0.4).F
    assert (np.abs(force[:, 0]) <= 0.4 * force[:, 2] * (1 + 1e-9)).all()
    with pytest.raises(carom.RangeError, match="static_friction = 0.1"):
        carom.collide(ball, PLATE, 0.2, static_friction=0.1)
    with pytest.raises(carom.RangeError, match="static_friction"):
        carom.collide(ball, PLATE, 0.2, static_friction=0.4, torsion=True)
    with pytest.raises(ValueError, match="static_friction"):
        carom.collide(ball, PLATE, carom.SlipSpeedFriction(0.1, 0.2, 1), static_friction=0.4)


def test_restitution_of_the_table_is_exact_to_1e_8():
    lam = np.linspace(0.01, 9, 200)
    kappa = np.array([[1.0], [1.2], [1.5]])
    table = carom.restitution(kappa, lam)
    exact = carom.restitution(kappa, lam, exact=True)
    assert table.shape == (3, 200)
    assert np.abs(table - exact).max() < 1e-8
    sliding = lam > 7 - 1.2
    np.testing.assert_allclose(exact[1, sliding], 7 / lam[sliding] - 1, atol=1e-12)
    assert carom.restitution_of_groups(3.5, math.inf) == -1.0
    with pytest.raises(ValueError, match="kappa = 2") as caught:
        carom.restitution([1.0, 2.0], 1.0)
    assert caught.value.index == 1


def test_dissimilar_restitution_is_that_of_collisions():
    rng = np.random.default_rng(4)
    methods = set()
    for _ in range(20):
        one, two = (carom.Material(e, nu) for e, nu in zip(rng.uniform(1e9, 1e11, 2), rng.uniform(0, 0.5, 2), strict=True))
        pair, friction, lam = carom.MaterialPair(one, two), rng.uniform(0.05, 0.5), rng.uniform(0.2, 9)
        ball = carom.sphere(0.01, one, 0.033, velocity=(2 * friction * lam, 0, -2.0))
        rings = carom.collide(ball, carom.plane(two), friction, law="rings", tolerance=1e-3).R_x
        found = carom.restitution_of_dissimilar(pair.kappa, lam, pair.gamma, friction)
        assert abs(found.R_x - rings) <= 1e-2
        assert found.R_x == carom.restitution(pair.kappa, lam, gamma=pair.gamma, friction=friction)
        followed = carom.restitution_of_dissimilar(pair.kappa, lam, pair.gamma, friction, exact=True)
        assert followed.method == "rings" and abs(followed.R_x - rings) <= 1e-2
        methods.add(found.method)
    assert methods == {"table", "rings"}


def test_gamma_0_is_alike_materials_bit_for_bit():
    kappa, lam = np.array([[1.0], [1.2], [1.5]]), np.linspace(0, 9, 50)
    for exact in (False, True):
        alike = carom.restitution(kappa, lam, exact=exact)
        zero = carom.restitution(kappa, lam, gamma=0.0, friction=0.2, exact=exact)
        np.testing.assert_array_equal(zero, alike)
    found = carom.restitution_of_dissimilar([1.2, 1.2, 1.2], 2.0, [0.0, 0.1, 0.1], [0.2, 0.0, 0.2], exact=True)
    assert found.method == ["uncoupled", "frictionless", "rings"]
    assert list(found.error_estimate[:2]) == [0.0, 0.0] and found.R_x[1] == -1.0


def test_bad_numbers_of_dissimilar_spheres_are_named():
    good = {"kappa": 1.2, "lam": 1.0, "gamma": 0.1, "friction": 0.1, "mobility_ratio": 3.5}
    bad = [("kappa", 1.6), ("gamma", 0.31), ("gamma", math.nan), ("friction", -0.1), ("mobility_ratio", 0.0)]
    for name, value in [*bad, ("lam", -1.0)]:
        with pytest.raises(carom.RangeError) as told:
            carom.restitution(**good | {name: [good[name], value]})
        assert (told.value.field, told.value.index) == ("lambda" if name == "lam" else name, 1)
    with pytest.raises(carom.RangeError, match="lambda = 1 .* 0 where friction is infinite"):
        carom.restitution(**good | {"friction": math.inf})
    for some in ({"gamma": 0.1}, {"friction": 0.1}, {"mobility_ratio": 2.5}):
        with pytest.raises(TypeError, match="gamma and friction together"):
            carom.restitution(1.2, 1.0, **some)


def test_balances():
    rebound = carom.collide(BALL, PLATE, 0.15)
    lost = rebound.energy_before - rebound.energy_after
    assert rebound.energy_dissipated == pytest.approx(lost, rel=1e-9)
    change = 0.033 * (rebound.body_1_velocity - BALL.velocity)
    np.testing.assert_allclose(change, rebound.impulse, rtol=1e-12)
    # About the contact point the ball's angular momentum stays.
    arm = np.array([0, 0, -0.01])
    turned = 0.4 * 0.033 * 0.01**2 * (rebound.body_1_spin - BALL.spin)
    np.testing.assert_allclose(turned, np.cross(arm, rebound.impulse), atol=1e-15)
    assert (rebound.method, rebound.error_estimate) == ("uncoupled", 0.0)


def test_an_outcome_is_told_in_the_words_of_the_command():
    egg = carom.Body("ellipsoid", [0.03, 0.02, 0.015], STEEL, 0.296, velocity=(-0.6, -0.4, -2.0))
    tilted = carom.Body(
        "ellipsoid", [0.03, 0.02, 0.015], STEEL, 0.296, velocity=(-0.6, 0, -2.0), attitude=(0.8, 0, 0.6, 0)
    )
    methods = [
        (BALL, 0.0, "frictionless"), (BALL, 0.3, "uncoupled"), (egg, 0.5, "spatial"), (tilted, 0.5, "planar"),
    ]
    for body, friction, method in methods:
        rebound = carom.collide(body, PLATE, friction)
        assert (rebound.outcome, rebound.method, rebound.compressions) == ("rebound", method, 1)
    assert carom.collide(BALL, PLATE, 0.0).regimes == "slide+"


def test_restitution_of_a_collision_is_that_of_the_groups():
    for speed in [0.1, 0.8, 3.0]:
        ball = carom.sphere(0.01, STEEL, 0.033, velocity=(speed, 0, -2.0))
        r_x = carom.collide(ball, PLATE, 0.15).R_x
        assert r_x == pytest.approx(carom.restitution(KAPPA, speed / (0.15 * 2.0), exact=True), abs=1e-9)


def test_many_are_single_ones():
    rng = np.random.default_rng(1)
    velocities = rng.normal(size=(50, 3)) - [0, 0, 3]
    spins = 30 * rng.normal(size=(50, 3))
    friction = rng.uniform(0, 1, 50)
    many = carom.collide_many(BALL, PLATE, friction, body_1_velocity=velocities, body_1_spin=spins)
    for i in [0, 17, 49]:
        one = carom.collide(BALL.moving(velocities[i], spins[i]), PLATE, friction[i])
        np.testing.assert_array_equal(many.body_1_velocity[i], one.body_1_velocity)
        np.testing.assert_array_equal(many.body_1_spin[i], one.body_1_spin)
        assert many.warnings[i] == one.warnings
    given = carom.collide_many(BALL, PLATE, [0.1, 0.2])
    np.testing.assert_array_equal(given.body_1_velocity[1], carom.collide(BALL, PLATE, 0.2).body_1_velocity)
    with pytest.raises(ValueError, match="same length"):
        carom.collide_many(BALL, PLATE, [0.1, 0.2], body_1_velocity=velocities)
    velocities[7, 1] = math.nan
    with pytest.raises(carom.RangeError) as caught:
        carom.collide_many(BALL, PLATE, 0.1, body_1_velocity=velocities)
    assert (caught.value.field, caught.value.index) == ("velocity", 7)


def test_bodies_are_not_moved_unasked():
    one = carom.sphere(0.01, STEEL, 0.033, centre=(0.02, 0, 0), velocity=(-1, 0, 0))
    two = carom.sphere(0.01, STEEL, 0.033)
    assert carom.collide(one, two, 0.3, normal=None).body_1_velocity[0] == pytest.approx(0.0, abs=1e-15)
    assert carom.collide(one, two, 0.3, normal=(1, 0, 0)).body_2_velocity[0] == pytest.approx(-1.0)
    assert math.isnan(carom.collide(one, two, 0.3, normal=(0, 0, 1)).duration)
    for call in (carom.collide, carom.collide_many, carom.history):
        with pytest.raises(ValueError, match="normal: must be given"):
            call(one, two, 0.3)


def test_bodies_that_part_are_left_alone():
    rebound = carom.collide(BALL.moving((0, 0, 1)), PLATE, 0.3)
    np.testing.assert_array_equal(rebound.body_1_velocity, [0, 0, 1])
    assert (rebound.outcome, rebound.method, rebound.warnings) == ("no_impact", "", "")
    assert math.isnan(rebound.duration)


def example(name):
    """An example as a module, so that other processes find its functions."""
    import importlib
    import pathlib
    import sys

    folder = str(pathlib.Path(__file__).parents[1] / "examples")
    if folder not in sys.path:
        sys.path.insert(0, folder)
    return importlib.import_module(name)


def test_a_sweep_over_processes_has_the_same_bits():
    sweep = example("sweep")
    velocities = sweep.motions(20_000)
    whole = sweep.rebounds(velocities)
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        parts = list(pool.map(sweep.rebounds, np.array_split(velocities, 4)))
    np.testing.assert_array_equal(np.concatenate(parts), whole)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="there is no fork")
def test_a_forked_process_has_threads_of_its_own():
    sweep = example("sweep")
    velocities = sweep.motions(20_000)
    whole = sweep.rebounds(velocities)  # the threads of this process are there now
    pool = get_context("fork").Pool(2)
    try:
        parts = pool.map_async(sweep.rebounds, np.array_split(velocities, 2)).get(timeout=60)
    finally:
        pool.terminate()
    np.testing.assert_array_equal(np.concatenate(parts), whole)


def test_an_interrupt_does_not_wait_for_the_end():
    # By rings they take a minute or more.
    velocities = np.tile([1.0, 0.0, -2.0], (200_000, 1))
    # A shell starts its background jobs with interrupts ignored.
    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        timer = threading.Timer(0.3, _thread.interrupt_main)
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            carom.collide_many(BALL, PLATE, 0.15, body_1_velocity=velocities, law="rings")
    finally:
        signal.signal(signal.SIGINT, handler)


def test_a_sweep_on_dask_has_the_same_bits():
    pytest.importorskip("distributed")
    sweep = example("sweep")
    np.testing.assert_array_equal(sweep.main(20_000), sweep.rebounds(sweep.motions(20_000)))


def test_a_sweep_survives_a_killed_worker():
    distributed = pytest.importorskip("distributed")
    sweep = example("sweep")
    motions = sweep.motions(60_000)
    with (
        distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster,
        distributed.Client(cluster) as client,
    ):
        pids = client.run(os.getpid)
        futures = client.map(sweep.rebounds, np.array_split(motions, 16))
        distributed.wait(futures, return_when="FIRST_COMPLETED")
        os.kill(min(pids.values()), signal.SIGKILL)
        after = np.concatenate(client.gather(futures))
    np.testing.assert_array_equal(after, sweep.rebounds(motions))


def test_other_shapes():
    egg = carom.Body(
        "ellipsoid", [0.03, 0.02, 0.015], STEEL, 0.296, centre=(0, 0, 0.015), velocity=(-0.6, -0.4, -2.0)
    )
    rebound = carom.collide(egg, PLATE, 0.5, normal=None)
    assert rebound.body_1_velocity[2] == pytest.approx(2.0)
    assert rebound.maximal_semi_axis_a < rebound.maximal_semi_axis_b
    with pytest.raises(carom.CaromError):
        carom.collide(egg, carom.sphere(0.01, STEEL, 1.0, centre=(0, 0, -1)), 0.5, normal=None)
    with pytest.raises(carom.CaromError, match="infinitely heavy"):
        carom.collide(PLATE, carom.sphere(0.01, STEEL, math.inf), 0.5)


def test_bodies_pickle_and_are_checked():
    for body in (BALL, PLATE):
        assert pickle.loads(pickle.dumps(body)) == body
        assert copy.deepcopy(body) == body
    with pytest.raises(ValueError, match="mass"):
        carom.sphere(0.01, STEEL, -1.0)
    with pytest.raises(ValueError, match="radius"):
        carom.sphere(-0.01, STEEL, 1.0)
    with pytest.raises(ValueError, match="shape = 'cube'"):
        carom.Body("cube", [1.0], STEEL, 1.0)
    with pytest.raises(ValueError, match="quaternion"):
        carom.Body("sphere", [1.0], STEEL, 1.0, attitude=(2, 0, 0, 0))
    with pytest.raises(ValueError, match='law = "newton" .*must be "auto" or "coulomb" or "fixed-direction" or "rings" or "numerical"$'):
        carom.collide(BALL, PLATE, 0.1, law="newton")
    with pytest.raises(ValueError, match='did you mean "fixed-direction"'):
        carom.collide(BALL, PLATE, 0.1, law="fixed_direction")


def test_history_begins_and_ends_without_load():
    course = carom.history(BALL, PLATE, 0.15, 41)
    assert course.time.shape == (41,)
    np.testing.assert_allclose(course.F[[0, -1]], 0, atol=1e-6 * course.F.max())
    rebound = carom.collide(BALL, PLATE, 0.15)
    assert course.time[-1] == pytest.approx(rebound.duration)
    assert course.F[:, 2].max() == pytest.approx(rebound.maximal_force, rel=1e-2)
    assert {"sliding"} & {name.split()[0].strip("+-") for name in course.regime} or course.regime


def test_results_pickle():
    rebound = carom.collide(BALL, PLATE, 0.15)
    again = pickle.loads(pickle.dumps(rebound))
    assert again.R_x == rebound.R_x
    np.testing.assert_array_equal(again.impulse, rebound.impulse)


def test_the_material_takes_a_part():
    rubber = carom.Material(5e6, 0.5)
    ball = carom.sphere(0.02, rubber, 0.037, velocity=(1, 0, -3))
    floor = carom.plane(carom.RIGID)
    rebound = carom.collide(ball, floor, 0.5, normal_restitution=0.8)
    assert rebound.body_1_velocity[2] == pytest.approx(2.4, rel=1e-14)
    booked = rebound.energy_after + rebound.energy_dissipated + rebound.energy_lost
    assert booked == pytest.approx(rebound.energy_before, rel=1e-12)
    assert rebound.energy_lost >= 0.5 * 0.037 * (9 - 2.4**2) * (1 - 1e-12)
    with pytest.raises(carom.RangeError, match="normal_restitution = 1.5"):
        carom.collide(ball, floor, 0.5, normal_restitution=1.5)


def test_waves_take_their_share():
    steel = carom.Material(208e9, 0.3)
    ball = carom.sphere(0.01, steel, 0.033, velocity=(0, 0, -2))
    plate = carom.plane(steel)
    rebound = carom.collide(ball, plate, 0.2, wave_loss=True)
    loss = rebound.energy_lost / rebound.energy_before
    assert 0 < loss < 0.1
    assert rebound.body_1_velocity[2] == pytest.approx(2 * np.sqrt(1 - loss), rel=1e-12)
    many = carom.collide_many(ball, plate, 0.2, body_1_velocity=[(0, 0, -2), (0, 0, -4)], wave_loss=True)
    assert many.energy_lost[0] == rebound.energy_lost and many.energy_lost[1] > 4 * rebound.energy_lost
    with pytest.raises(ValueError, match="normal_restitution"):
        carom.collide(ball, plate, 0.2, normal_restitution=0.9, wave_loss=True)


def test_derivatives_of_a_rebound_are_differences_of_it():
    steel = carom.Material(208e9, 0.3)

    def bodies(radius=0.01, speed=0.5, spin=0.0):
        one = carom.sphere(radius, steel, 0.033, velocity=(speed, 0.1, -1.0), spin=(0.0, spin, 0.0))
        return one, carom.sphere(0.012, steel, 0.05, spin=(0.0, 0.0, 3.0))

    found = carom.rebound_derivatives(*bodies(), 0.2)
    rebound = carom.collide(*bodies(), 0.2, torsion=False)
    motions = [rebound.body_1_velocity, rebound.body_1_spin, rebound.body_2_velocity, rebound.body_2_spin]
    assert found.values == pytest.approx(np.concatenate(motions), abs=1e-9)
    assert found.matrix.shape == (len(found.outputs), len(found.inputs)) and not found.is_at_change
    assert found.to_dict()["matrix"] == found.matrix.tolist()

    def difference(step, friction=0.0, **changes):
        ends = [
            carom.rebound_derivatives(*bodies(**{name: value + sign * step for name, value in changes.items()}), 0.2 + sign * friction)
            for sign in (1, -1)
        ]
        return (ends[0].values - ends[1].values) / (2 * (step if changes else friction))

    names = found.inputs
    for name, by in (
        ("friction", difference(0.0, friction=1e-5)),
        ("body_1_radius", difference(1e-7, radius=0.01)),
        ("body_1_velocity_x", difference(1e-5, speed=0.5)),
        ("body_1_spin_y", difference(1e-3, spin=0.0)),
    ):
        assert found.matrix[:, names.index(name)] == pytest.approx(by, abs=1e-5 * np.abs(by).max()), name
    assert found["body_1_velocity_x", "friction"] == found.matrix[0, names.index("friction")]
    for kappa in (0.034, 1e-4):
        with pytest.raises(carom.RangeError, match=f"^kappa = {kappa}"):
            carom.rebound_derivatives(*bodies(), 0.2, kappa=kappa)
    with pytest.raises(TypeError, match="torsion: must be None, True or False, not 'yes'"):
        carom.collide(*bodies(), 0.2, torsion="yes")
    with pytest.raises(TypeError, match="torsion: must be None, True or False, not 1"):
        carom.collide_many(*bodies(), 0.2, torsion=1)
    with pytest.raises(KeyError, match="mass: must be one of body_1_velocity_x"):
        found["body_1_velocity_x", "mass"]
    with pytest.raises(ValueError, match="must be spheres or planes that approach"):
        carom.rebound_derivatives(*reversed(bodies()), 0.2)
    soft = carom.Material(5e6, 0.3)
    glancing = carom.sphere(0.14, soft, 0.5, velocity=(1, 1.5, -0.3)), carom.sphere(0.14, soft, 0.5)
    with pytest.raises(ValueError, match="line of centres turns"):
        carom.rebound_derivatives(*glancing, 0.3)
