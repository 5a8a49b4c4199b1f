"""The strategies against carom's own impacts, laws of mechanics, and pooltool's models where all agree."""

import attrs
import carom
import carom_pooltool as door
import numpy as np
import pooltool as pt
import pytest
from pooltool.objects.ball.datatypes import BallParams, BallState
from pooltool.objects.table.components import CircularCushionSegment, LinearCushionSegment
from pooltool.physics.resolve.ball_ball.friction import AverageBallBallFriction
from pooltool.physics.resolve.ball_ball.frictional_inelastic import FrictionalInelastic
from pooltool.physics.resolve.ball_cushion.han_2005 import Han2005Linear
from pooltool.physics.resolve.ball_cushion.stronge_compliant import StrongeCompliantLinear
from pooltool.physics.resolve.resolver import default_resolver

SLIDING = 2
TABLE = 1e-7  # carom.restitution reads a table that is within 1e-8 where nothing is lost,
LOSSY = 3e-3  # and one that is within 3e-3 where the material takes something,
MEAN = 1e-4  # 4e-5 in the mean; of speeds it is less
ROUND_OFF = 1e-13
# The cushion at x = 0; the ball comes from the left.
TO_BALL = np.array([-1.0, 0.0, 0.0])


def cushion(height):
    return LinearCushionSegment(id="c", p1=np.array([0.0, -1.0, height]), p2=np.array([0.0, 1.0, height]))


def ball(params, position, velocity, spin, name="b"):
    made = pt.Ball(id=name, params=params)
    rvw = np.array([position, velocity, spin], dtype=float)
    made.state = BallState(rvw, SLIDING)
    return made


def params(random, least=0.3):
    """A ball with restitutions from `least` to 1."""
    return BallParams(
        m=random.uniform(0.1, 0.3), R=random.uniform(0.02, 0.04), f_c=10 ** random.uniform(-2, 0),
        e_c=random.uniform(least, 1), u_b=10 ** random.uniform(-2, 0), e_b=random.uniform(least, 1),
    )


def thrown(random, own, height=None):
    """A ball that touches the cushion."""
    height = own.R if height is None else height
    distance = np.sqrt(own.R**2 - (height - own.R) ** 2)
    velocity = [random.uniform(0.1, 5), random.uniform(-5, 5), 0]
    return ball(own, [-distance, 0, own.R], velocity, random.uniform(-100, 100, 3))


def energy(one):
    _, v, w = one.state.rvw
    return 0.5 * one.params.m * (v @ v + 0.4 * one.params.R**2 * (w @ w))


# carom tells where friction would change the spin about the normal, which pooltool leaves out.
pytestmark = pytest.mark.filterwarnings("ignore::carom.CaromWarning")


def of_carom(balls, plane_normal, friction, restitution, poisson):
    """The same impact by carom.collide."""
    # So stiff that the line of centres of two balls does not turn while they touch, as in pooltool.
    material = carom.Material(1e13, poisson)
    bodies = [
        carom.sphere(b.params.R, material, b.params.m, velocity=b.state.rvw[1], spin=b.state.rvw[2]) for b in balls
    ]
    bodies += [carom.plane(material)] if len(bodies) == 1 else []
    return carom.collide(
        *bodies, friction, normal=plane_normal, torsion=False, law="coulomb", normal_restitution=restitution
    )


def agrees(misses, least):
    """Checks differences over the speed: where nothing is lost, or where the material takes something."""
    assert np.max(misses) < (TABLE if least == 1 else LOSSY)
    assert np.mean(misses) < (TABLE if least == 1 else MEAN)


elastic_and_lossy = pytest.mark.parametrize("least", [1.0, 0.3])


@elastic_and_lossy
@pytest.mark.parametrize("poisson", [0.0, 0.34, 0.5])
def test_a_ball_leaves_the_cushion_as_by_carom(poisson, least):
    random, misses = np.random.default_rng(1), []
    for _ in range(100):
        before = thrown(random, params(random, least))
        after, _ = door.CaromLinear(poisson).solve(before.copy(), cushion(before.params.R))
        own = before.params
        expected = of_carom([before], TO_BALL, own.f_c, own.e_c, poisson)
        speed = np.linalg.norm(before.vel) + own.R * np.linalg.norm(before.state.rvw[2])
        flat = expected.body_1_velocity * [1, 1, 0]
        turned = own.R * (after.state.rvw[2] - expected.body_1_spin)
        misses.append(np.abs([after.vel - flat, turned]).max() / speed)
        assert after.state.s == SLIDING
    agrees(misses, least)


@elastic_and_lossy
def test_balls_leave_each_other_as_by_carom(least):
    random, misses = np.random.default_rng(2), []
    for _ in range(100):
        one, other = pair(random, least)
        friction = (one.params.u_b + other.params.u_b) / 2
        restitution = (one.params.e_b + other.params.e_b) / 2
        after = door.CaromBallBall(0.34, AverageBallBallFriction()).solve(one.copy(), other.copy())
        expected = of_carom([one, other], one.xyz - other.xyz, friction, restitution, 0.34)
        velocities = [expected.body_1_velocity, expected.body_2_velocity]
        spins = [expected.body_1_spin, expected.body_2_spin]
        speed = sum(np.linalg.norm(b.vel) + b.params.R * np.linalg.norm(b.state.rvw[2]) for b in (one, other))
        for b, v, w in zip(after, velocities, spins, strict=True):
            turned = b.params.R * (b.state.rvw[2] - w)
            misses.append(max(np.abs(b.vel - v)[:2].max(), np.abs(turned).max()) / speed)
        # What pooltool keeps on the table: momentum along it.
        momentum = [sum(b.params.m * b.vel for b in balls)[:2] for balls in ((one, other), after)]
        assert np.allclose(*momentum, atol=ROUND_OFF * speed, rtol=0)
    agrees(misses, least)


def pair(random, least=0.3):
    """Two balls that touch and approach each other, of unlike mass and the same radius."""
    own, others = params(random, least), params(random, least)
    others = attrs.evolve(others, R=own.R)
    angle = random.uniform(0, 2 * np.pi)
    along = np.array([np.cos(angle), np.sin(angle), 0])
    flat = lambda: random.uniform(-3, 3, 3) * [1, 1, 0]
    velocities = [flat(), flat()]
    closing = (velocities[1] - velocities[0]) @ along
    velocities[0] = velocities[0] + (closing + random.uniform(0.1, 3)) * along
    spins = random.uniform(-100, 100, (2, 3))
    places = [[0, 0, own.R], 2 * own.R * along + [0, 0, own.R]]
    return [
        ball(p, place, v, w, name)
        for p, place, v, w, name in zip((own, others), places, velocities, spins, "ab", strict=True)
    ]


def test_energy_is_never_gained():
    random = np.random.default_rng(3)
    for _ in range(500):
        own = params(random)
        before = thrown(random, own, height=own.R * random.uniform(1, 1.6))
        after, _ = door.CaromLinear(0.5).solve(before.copy(), cushion(own.R * 1.2))
        assert energy(after) <= energy(before) * (1 + ROUND_OFF)
        balls = pair(random)
        both = door.CaromBallBall().solve(*[b.copy() for b in balls])
        assert sum(map(energy, both)) <= sum(map(energy, balls)) * (1 + ROUND_OFF)


def test_a_mirrored_shot_has_the_mirrored_rebound():
    random = np.random.default_rng(4)
    mirror = np.array([[1, -1, 1], [1, -1, 1], [-1, 1, -1]])  # in y; spins are axial
    for _ in range(200):
        one = thrown(random, params(random))
        other = one.copy()
        other.state = BallState(one.state.rvw * mirror, SLIDING)
        segment = cushion(one.params.R * 1.27)
        after = [door.CaromLinear().solve(b, segment)[0].state.rvw for b in (one, other)]
        assert np.allclose(after[0] * mirror, after[1], rtol=1e-10, atol=1e-12)


def test_a_round_cushion_is_a_straight_one_with_its_normal():
    random = np.random.default_rng(5)
    for _ in range(100):
        one = thrown(random, params(random))
        straight, _ = door.CaromLinear().solve(one.copy(), cushion(one.params.R))
        jaw = CircularCushionSegment(id="j", center=np.array([0.01, 0.0, one.params.R]), radius=0.01)
        round_, _ = door.CaromCircular().solve(one.copy(), jaw)
        assert np.allclose(straight.state.rvw, round_.state.rvw, rtol=1e-12, atol=1e-12)


@pytest.mark.parametrize("model", [Han2005Linear(), StrongeCompliantLinear(1.7)])
def test_all_models_agree_where_the_contact_slides_throughout(model):
    random = np.random.default_rng(6)
    for _ in range(50):
        own = attrs.evolve(params(random), f_c=0.05)
        before = ball(own, [-own.R, 0, own.R], [random.uniform(0.1, 1), 3, 0], [0, 0, random.uniform(-9, 9)])
        ours, _ = door.CaromLinear().solve(before.copy(), cushion(own.R))
        theirs, _ = model.solve(before.copy(), cushion(own.R))
        assert np.allclose(ours.state.rvw, theirs.state.rvw, rtol=1e-9, atol=1e-9)


def test_balls_that_slide_throughout_are_those_of_pooltool():
    random = np.random.default_rng(7)
    # With e < 1 pooltool's limit of friction counts the speed of separation e v in the place of (1 + e) v/2.
    same, friction, count = BallParams(u_b=0.01, e_b=1.0), AverageBallBallFriction(), 0
    for _ in range(100):
        one, other = pair(random)
        balls = [ball(same, b.xyz * same.R / b.params.R, b.vel, b.state.rvw[2], b.id) for b in (one, other)]
        if slip_ratio(*balls, same.u_b) < 7:
            continue
        count += 1
        ours = door.CaromBallBall(friction=friction).solve(*[b.copy() for b in balls])
        theirs = FrictionalInelastic(friction).solve(*[b.copy() for b in balls])
        for mine, his in zip(ours, theirs, strict=True):
            assert np.allclose(mine.state.rvw, his.state.rvw, rtol=1e-9, atol=1e-9)
    assert count > 50


def slip_ratio(one, other, friction):
    """lambda, slip speed over friction times approach speed."""
    normal = (one.xyz - other.xyz) / np.linalg.norm(one.xyz - other.xyz)
    at_contact = [b.vel + np.cross(b.state.rvw[2], side * b.params.R * normal) for b, side in ((one, -1), (other, 1))]
    relative = at_contact[0] - at_contact[1]
    approach = -normal @ relative
    return np.linalg.norm(relative + approach * normal) / (friction * approach)


def test_the_contact_is_thrown_back_where_rigid_balls_stick():
    own = BallParams(e_c=1.0)
    spin = 1 / own.R
    before = ball(own, [-own.R, 0, own.R], [1, 0, 0], [0, 0, 0.6 * spin])
    slip = lambda b: b.vel[1] + b.state.rvw[2][2] * own.R  # of the contact, at x = R of the ball
    after, _ = door.CaromLinear(0.5).solve(before.copy(), cushion(own.R))
    r_x = carom.restitution(1.5, 0.6 / own.f_c)
    assert r_x > 0.5
    assert slip(after) == pytest.approx(-r_x * slip(before), rel=1e-9)
    rigid, _ = Han2005Linear().solve(before.copy(), cushion(own.R))
    assert abs(slip(rigid)) < 1e-12


def test_a_ball_that_leaves_is_left_alone():
    own = BallParams()
    before = ball(own, [-own.R, 0, own.R], [-1, 0.5, 0], [1, 2, 3])
    after, _ = door.CaromLinear().solve(before.copy(), cushion(own.R))
    assert np.array_equal(after.state.rvw, before.state.rvw)


@pytest.mark.parametrize("strategy", [door.CaromLinear, door.CaromCircular, door.CaromBallBall])
@pytest.mark.parametrize("poisson", [-1.0, 0.51, float("nan")])
def test_poisson_out_of_range_is_refused(strategy, poisson):
    with pytest.raises(ValueError, match=rf"poisson = {poisson} must be in \(-1, 0.5\]"):
        strategy(poisson)


def test_parameters_out_of_range_are_refused():
    own = BallParams(e_c=1.2)
    with pytest.raises(ValueError, match="restitution = 1.2 must be from 0 to 1"):
        door.CaromLinear().solve(ball(own, [-own.R, 0, own.R], [1, 0, 0], [0, 0, 0]), cushion(own.R))
    with pytest.raises(ValueError, match="friction = -0.1 must be finite and >= 0"):
        door.impulse(np.array([0, 0, -1.0]), np.array([0, 0, 1.0]), 1.0, 0.3, -0.1, 1.0)


def shot(engine):
    table = pt.Table.default()
    balls = pt.get_rack(pt.GameType.NINEBALL, table, ball_params=None, ballset=None, spacing_factor=1e-3)
    system = pt.System(cue=pt.Cue(cue_ball_id="cue"), table=table, balls=balls)
    system.strike(V0=6, phi=pt.aim.at_ball(system, "1"), a=0.3, b=0.1)
    return pt.simulate(system, engine=engine)


def test_a_break_runs_to_rest():
    engine = pt.physics.PhysicsEngine(resolver=door.resolver())
    system = shot(engine)
    kinds = {event.event_type for event in system.events}
    assert {pt.EventType.BALL_BALL, pt.EventType.BALL_LINEAR_CUSHION} <= kinds
    assert all(b.state.s in (0, 4) for b in system.balls.values())  # at rest or in a pocket
    assert all(np.isfinite(b.state.rvw).all() for b in system.balls.values())
    other = shot(pt.physics.PhysicsEngine(resolver=default_resolver()))
    assert system.events[-1].time != other.events[-1].time


def test_the_resolver_has_all_strategies():
    made = door.resolver(cushion_poisson=0.45, ball_poisson=0.3)
    assert made.ball_linear_cushion == door.CaromLinear(0.45)
    assert made.ball_circular_cushion == door.CaromCircular(0.45)
    assert made.ball_ball == door.CaromBallBall(0.3)
    assert made.stick_ball == default_resolver().stick_ball


@pytest.mark.parametrize("end", ["yaml", "json"])
def test_a_resolver_is_kept_in_a_file(tmp_path, end):
    kept = door.resolver(cushion_poisson=0.45)
    path = tmp_path / f"resolver.{end}"
    kept.save(path)
    assert type(kept).load(path) == kept
    default_resolver().save(path)
    assert type(kept).load(path) == default_resolver()
