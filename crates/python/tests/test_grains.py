"""Whole contacts of grains: rolling and spin against closed forms."""

import copy
import math
import pickle

import carom
import numpy as np
import pytest

RADIUS, MASS, GRAVITY = 0.01, 0.033, 9.81
INERTIA = 0.4 * MASS * RADIUS**2
RUBBER = carom.Material(1e8, 0.45)
ON_PLANE = (RADIUS, math.inf)


def resting():
    """The height of a ball that rests on a plane."""
    weight = MASS * GRAVITY
    return RADIUS - carom.hertz(carom.hertz_of_spheres(RADIUS, math.inf, RUBBER), force=weight).approach


def test_a_ball_rolls_to_rest():
    """Rolling without slip it is slowed down by 5/7 f g, over the way v^2/(10/7 f g)."""
    limit, start, dt = 0.1, 0.05, 2e-5
    contacts = carom.GrainContacts(1, ON_PLANE, RUBBER, 0.5, relaxation=1e-4, rolling=(1e5, 1.0, limit))
    place, velocity, spin = np.array([0.0, 0.0, resting()]), np.array([start, 0.0, 0.0]), np.array([0.0, start / RADIUS, 0.0])
    stops = start / (5 / 7 * limit * GRAVITY)
    for step in range(int(1.5 * stops / dt)):
        place = place + dt * velocity
        force, torque, on_plane = (load[0] for load in contacts.step(dt, place, velocity, spin, [*place[:2], 0.0]))
        velocity = velocity + dt * (force / MASS - [0.0, 0.0, GRAVITY])
        spin = spin + dt * torque / INERTIA
        if step == int(0.5 * stops / dt):
            assert velocity[0] == pytest.approx(0.5 * start, rel=0.01)
            rolling = torque[1] - RADIUS * -force[0]
            assert rolling == pytest.approx(-limit * RADIUS * force[2], rel=1e-3)
    assert not on_plane.any()
    assert abs(velocity[0]) < 0.01 * start
    assert place[0] == pytest.approx(start**2 / (10 / 7 * limit * GRAVITY), rel=0.01)


def test_a_pinned_ball_swings_on_spring_and_dashpot():
    """Without friction I w' = -R^2 (k angle + c w)."""
    stiffness, damping, dt, start = 2e3, 0.02, 1e-5, 0.1
    contacts = carom.GrainContacts(1, ON_PLANE, RUBBER, 0.0, rolling=(stiffness, damping, 1e6))
    decay = RADIUS**2 * damping / (2 * INERTIA)
    rate = math.sqrt(RADIUS**2 * stiffness / INERTIA - decay**2)
    spin = start
    for step in range(1, 2001):
        torque = contacts.step(dt, [0.0, 0.0, resting()], spin_1=[0.0, spin, 0.0], heat=True).torque_1[0]
        spin += dt * torque[1] / INERTIA
        at = (step + 0.5) * dt
        exact = start * math.exp(-decay * at) * (math.cos(rate * at) - decay / rate * math.sin(rate * at))
        assert abs(spin - exact) < 0.02 * start, step
    lost = 0.5 * INERTIA * (start**2 - spin**2) - (contacts.stored_energy[0] - carom.GrainContacts(1, ON_PLANE, RUBBER, 0.0).stored_energy[0])
    compression = 0.4 * MASS * GRAVITY * (RADIUS - resting())
    assert contacts.heats["rolling"] == pytest.approx(lost + compression, rel=0.02)


def test_spin_slides_at_the_torque_of_its_law():
    """3 pi/16 f F_z a, where all of the contact slides."""
    hertz = carom.hertz_of_spheres(RADIUS, RADIUS, RUBBER)
    state = carom.hertz(hertz, approach=1e-6)
    contacts = carom.GrainContacts(3, (RADIUS, RADIUS), RUBBER, 0.3, torsion=True)
    for _ in range(50):
        loads = contacts.step(1e-4, [0.0, 0.0, 2 * RADIUS - 1e-6], spin_1=[[0.0, 0.0, z] for z in (50.0, 0.0, -50.0)])
    torque = 3 * math.pi / 16 * 0.3 * state.force * state.semi_axis_a
    assert loads.torque_1[:, 2] == pytest.approx([-torque, 0.0, torque], rel=1e-6)
    assert loads.torque_2 == pytest.approx(-loads.torque_1)


def test_friction_has_the_radius_of_each_grain_as_its_arm():
    contacts = carom.GrainContacts(1, (1e-3, 2e-3), RUBBER, 0.3)
    load = contacts.step(1e-6, [0.0, 0.0, 3e-3 - 1e-8], [1.0, 0.0, 0.0])
    for torque, radius in ((load.torque_1, 1e-3), (load.torque_2, 2e-3)):
        assert torque[0] == pytest.approx([0.0, -radius * load.force[0, 0], 0.0], rel=1e-4, abs=1e-20)


def thrown(contacts, radius, mass, velocity, dt):
    """R_x of a ball that meets a plane, by leapfrog."""
    moment, at = 0.4 * mass * radius**2, np.array([0, 0, radius])
    v, w, force, torque = np.array(velocity), np.zeros(3), np.zeros(3), np.zeros(3)
    while at[2] <= radius:
        v, w = v + dt / 2 * force / mass, w + dt / 2 * torque / moment
        at = at + dt * v
        load = contacts.step(dt, at, v, w)
        force, torque = np.array(load.force[0]), np.array(load.torque_1[0])
        v, w = v + dt / 2 * force / mass, w + dt / 2 * torque / moment
    return -(v[0] - radius * w[1]) / velocity[0]


def test_unlike_bodies_that_lose_energy_slide_as_in_one_impact():
    # Coupled tractions of unlike bodies that slide are less than f F_z in sum: the contact does not stick for that.
    soft, hard = carom.Material(70e9, 0.3), carom.Material(200e9, 0.3)
    ball = carom.sphere(0.01, soft, 0.01, velocity=(0.7705, 0, -1))
    for below in (soft, hard):
        impact = carom.collide(ball, carom.plane(below), 0.23, normal_restitution=0.3, law="rings")
        contacts = carom.GrainContacts(1, (0.01, np.inf), carom.MaterialPair(soft, below), 0.23, law="rings", restitution=0.3, masses=(0.01, np.inf))
        assert thrown(contacts, 0.01, 0.01, (0.7705, 0, -1), impact.duration / 200) == pytest.approx(impact.R_x, abs=0.02)


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction", "rings"])
def test_contacts_are_copied_and_kept(law):
    contacts = carom.GrainContacts(2, (RADIUS, RADIUS), RUBBER, 0.3, law=law, restitution=0.8, masses=(MASS, MASS), torsion=True, rolling=(1e3, 0.1, 0.1))
    spins = [[1.0, 2.0, 30.0], [0.0, 0.0, 0.0]]
    for _ in range(5):
        contacts.step(1e-5, [0.0, 0.0, 2 * RADIUS - 1e-6], [0.01, 0.0, 0.0], spins, heat=True)
    others = [copy.copy(contacts), copy.deepcopy(contacts), pickle.loads(pickle.dumps(contacts))]
    heats = contacts.heats
    loads = [one.step(1e-5, [0.0, 0.0, 2 * RADIUS - 1.1e-6], [0.01, 0.0, 0.0], spins) for one in (contacts, *others)]
    for load in loads[1:]:
        assert np.allclose(load, loads[0], rtol=1e-12, atol=0)
    assert others[2].heats == contacts.heats == heats and any(heats.values())
    assert len(contacts) == 2 and "GrainContacts" in repr(contacts)


def test_what_cannot_be_is_named():
    def make(radii=ON_PLANE, **options):
        return carom.GrainContacts(1, radii, RUBBER, 0.3, **options)

    wrong = [
        ({"rolling": (1e3, 0.1, -1.0)}, "rolling: friction = -1"),
        ({"rolling": (math.inf, 0.1, 0.1)}, "rolling: stiffness = inf"),
        ({"rolling": (1e3, 0.1)}, r"rolling: must be three numbers, \(stiffness, damping, friction\)"),
        ({"rolling": 5}, "rolling: must be three numbers"),
        ({"radii": (-RADIUS, RADIUS)}, "radius_1 = -0.01 is out of range: must be > 0"),
        ({"radii": (math.inf, RADIUS)}, "radius_1 = inf is out of range: must be finite"),
        ({"radii": (RADIUS, -RADIUS)}, "radius_2 = -0.01"),
        ({"masses": (1.0, 0.0)}, "mass_2 = 0.0 is out of range: must be > 0"),
        ({"masses": (math.nan, 1.0)}, "mass_1 = nan"),
    ]
    for options, message in wrong:
        with pytest.raises(ValueError, match=message):
            make(**options)
    with pytest.raises(TypeError, match="law: must be a name, not None"):
        make(law=None)
    for name in ("velocity_1", "spin_2", "place_2"):
        with pytest.raises(carom.RangeError, match=f"{name} = nan is out of range: must be finite"):
            make(rolling=(1e3, 0.1, 0.1)).step(1e-6, [0.0, 0.0, RADIUS], **{name: [0.0, math.nan, 0.0]})
    with pytest.raises(ValueError, match='"viscous"'):
        carom.GrainContacts(1, ON_PLANE, RUBBER, 0.3, law="viscous")
    weightless = carom.GrainContacts(1, ON_PLANE, RUBBER, 0.3, restitution=0.5)
    with pytest.raises(carom.RangeError, match="mass"):
        weightless.step(1e-6, [0.0, 0.0, RADIUS])
    contacts = carom.GrainContacts(2, ON_PLANE, RUBBER, 0.3)
    with pytest.raises(carom.RangeError, match="distance") as told:
        contacts.step(1e-6, [[0.0, 0.0, RADIUS], [0.0, 0.0, 0.0]])
    assert told.value.index == 1
