"""The array code of `carom.jax` and `carom.torch` gives the library's values: with numpy, and with those two where they are installed."""

import importlib
import importlib.util

import carom
import numpy as np
import pytest
from carom._gradients import Functions

# Both branches of `where` are computed, also where one is undefined.
pytestmark = pytest.mark.filterwarnings("ignore::RuntimeWarning")
RNG = np.random.default_rng(20261129)
KAPPA = RNG.uniform(0.76, 1.5, 20_000)
LAMBDA = 10 ** RNG.uniform(-3, 1.2, 20_000)


class Numpy:
    where, log, zeros = staticmethod(np.where), staticmethod(np.log), staticmethod(np.zeros)
    take = staticmethod(lambda table, index: np.asarray(table)[index])
    index = staticmethod(lambda values: np.arange(values.shape[-1]))
    integer = staticmethod(lambda values: np.asarray(values).astype(int))
    shifted = staticmethod(lambda values: np.roll(values, -1, axis=-1))
    broadcast = staticmethod(lambda values: np.broadcast_arrays(*values))
    stack = staticmethod(lambda parts: np.stack(np.broadcast_arrays(*parts), axis=-1))


def imported(name):
    if name == "jax":
        importlib.import_module("jax").config.update("jax_enable_x64", True)
    return importlib.import_module(f"carom.{name}")


def tensors(library, *values):
    if library.__name__ != "carom.torch":
        return values
    return [importlib.import_module("torch").tensor(value) for value in values]


NUMPY = Functions(Numpy(), lambda *values: [np.asarray(value, dtype=float) for value in values])
NUMPY.__name__ = "numpy"
LIBRARIES = [NUMPY, *(imported(name) for name in ("jax", "torch") if importlib.util.find_spec(name))]
libraries = pytest.mark.parametrize("library", LIBRARIES, ids=lambda library: library.__name__)
as_numpy = np.asarray


def unlike(count):
    """kappa, lambda, gamma, friction and D_xx/D_zz all over the table of unlike spheres."""
    kappa = RNG.uniform(1.0, 1.5, count)
    gamma = (1.5 - kappa) * RNG.uniform(-1, 1, count)
    friction = np.maximum(np.abs(gamma) / 11.9, RNG.uniform(0.02, 1.0, count))
    return kappa, RNG.uniform(0, 8, count), gamma, friction, RNG.uniform(1, 6, count)


STIFFNESS, FRICTION = (0.8, 1.3), 0.35


def drawn_paths(count, steps):
    zeta = RNG.uniform(-0.1, 1.0, (steps, count))
    return zeta, RNG.uniform(-0.8, 0.8, (steps, count)) * FRICTION


@libraries
def test_values_are_those_of_the_library(library):
    own = lambda *values: as_numpy(library.restitution(*tensors(library, *values)))  # noqa: E731
    assert np.abs(own(KAPPA, LAMBDA) - carom.restitution(KAPPA, LAMBDA)).max() < 1e-12
    edges = 1.2 * np.array([1.0, 1.0 - 1e-12, 1.0 + 1e-12, 1e-300, 0.0, 7.0 - 1.0, 1e6])
    assert np.abs(own(np.full(7, 1.2), edges) - carom.restitution(np.full(7, 1.2), edges)).max() < 1e-12
    assert np.isnan(own(np.array([0.7, 1.6, 1.2, np.nan]), np.array([1.0, 1.0, -1.0, 1.0]))).all()


@libraries
def test_rebounds_are_those_of_collide(library):
    steel = carom.Material(208e9, 0.3)
    ball = carom.sphere(0.01, steel, density=7850)
    count = 500
    velocity = np.column_stack([RNG.uniform(-2, 2, (count, 2)), -RNG.uniform(0.1, 2, count)])
    spin = RNG.uniform(-100, 100, (count, 3))
    wanted = carom.collide_many(
        ball, carom.plane(steel), 0.2, body_1_velocity=velocity, body_1_spin=spin, normal_restitution=0.7, loss="yield", torsion=False
    )
    kappa = (1 - 0.15) / (1 - 0.3)
    options = {"radius": 0.01, "friction": 0.2, "kappa": kappa, "normal_restitution": 0.7}
    v, w = (as_numpy(one) for one in library.rebound(velocity, spin, **options))
    assert np.abs(v - wanted.body_1_velocity).max() < 1e-7
    assert np.abs(w - wanted.body_1_spin).max() < 1e-5
    # One that leaves the plane keeps its motion.
    v, w = library.rebound([1.0, 0.0, 0.1], [1.0, 2.0, 3.0], **options)
    assert v.tolist() == [1.0, 0.0, 0.1] and w.tolist() == [1.0, 2.0, 3.0]


@libraries
def test_values_with_a_viscous_loss_are_those_of_the_library(library):
    e = np.where(np.arange(len(KAPPA)) % 7 == 0, 1.0, RNG.uniform(0.1, 1.0, len(KAPPA)))
    e[:16] = [1.0, 0.99, 0.98, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1]
    own = as_numpy(library.restitution(*tensors(library, KAPPA, LAMBDA), normal_restitution=tensors(library, e)[0]))
    assert np.abs(own - carom.restitution(KAPPA, LAMBDA, normal_restitution=e)).max() < 1e-12
    wrong = library.restitution(*tensors(library, np.full(4, 1.2), np.ones(4)), normal_restitution=tensors(library, np.array([0.09, -0.1, np.nan, 0.5]))[0])
    assert np.isnan(as_numpy(wrong)).tolist() == [True, True, True, False]


@libraries
def test_values_of_unlike_spheres_are_those_of_the_library(library):
    kappa, lam, gamma, friction, ratio = unlike(3000)
    gamma[:20], friction[20:40] = 0.0, 0.0
    kappa[20:40], gamma[20:40] = 1.2, 0.1
    kappa[40:50], gamma[40:50] = 1.5, 0.0
    options = dict(zip(("gamma", "friction", "mobility_ratio"), tensors(library, gamma, friction, ratio)))
    own = as_numpy(library.restitution(*tensors(library, kappa, lam), **options))
    wanted = carom.restitution(kappa, lam, gamma=gamma, friction=friction, mobility_ratio=ratio)
    # Some cells of like bodies have no table.
    known = ~np.isnan(own)
    assert known.mean() > 0.99 and (ratio / kappa)[~known].min(initial=6.0) > 5.2
    assert np.abs(own - wanted)[known].max() < 1e-12
    options = {"gamma": 0.1, "friction": 0.5}
    outside = [(0.9, 1.0, {}), (1.2, 9.0, {}), (1.2, 1.0, {"friction": 1.1}), (1.2, 1.0, {"gamma": 0.31}), (1.2, 1.0, {"friction": 0.008})]
    for k, l, change in outside:
        assert np.isnan(as_numpy(library.restitution(k, l, **(options | change))))


@libraries
def test_rebounds_of_two_balls_are_those_of_collide(library):
    glass = carom.Material(70e9, 0.22)
    one, two = carom.sphere(0.01, glass, density=2500), carom.sphere(0.015, glass, density=2500)
    count = 300
    velocities = [RNG.uniform(-0.2, 0.2, (count, 3)) for _ in range(2)]
    velocities[0][:, 2] -= 1.5
    spins = [RNG.uniform(-30, 30, (count, 3)) for _ in range(2)]
    kappa, mass = (1 - 0.11) / (1 - 0.22), tuple(2500 * 4 / 3 * np.pi * r**3 for r in (0.01, 0.015))
    for loss, e, near in (("yield", 1.0, 1e-7), ("yield", 0.6, 1e-7), ("viscous", 0.7, 5e-3)):
        wanted = carom.collide_many(
            one, two, 0.3, body_1_velocity=velocities[0], body_1_spin=spins[0], body_2_velocity=velocities[1],
            body_2_spin=spins[1], normal_restitution=e, loss=None if e == 1.0 else loss, torsion=False,
        )  # fmt: skip
        found = library.rebound_of_two(
            velocities[0], spins[0], velocities[1], spins[1], radius=(0.01, 0.015), mass=mass, friction=0.3,
            kappa=kappa, normal_restitution=e, loss=loss,
        )  # fmt: skip
        names = ("body_1_velocity", "body_1_spin", "body_2_velocity", "body_2_spin")
        for own, name in zip(found, names):
            scale = 1.0 if "velocity" in name else 100.0
            assert np.abs(as_numpy(own) - getattr(wanted, name)).max() < near * scale, (loss, name)
    with pytest.raises(ValueError, match="must be 'yield' or 'viscous'"):
        library.rebound([0.0, 0, -1], [0.0, 0, 0], radius=0.01, friction=0.3, kappa=1.2, loss="waves")


@libraries
def test_a_rebound_from_an_unlike_plane_is_that_of_its_r_x(library):
    gamma, friction, kappa = 0.2, 0.3, 1.25
    v, w = library.rebound(
        [1.0, 0.0, -1.0], [0.0, 0.0, 0.0], radius=0.01, friction=friction, kappa=kappa, gamma=gamma
    )
    r_x = carom.restitution(kappa, 1.0 / friction, gamma=gamma, friction=friction)
    assert abs(float(v[0] - 0.01 * w[1]) + r_x) < 1e-6


@libraries
def test_contacts_are_those_of_the_library(library):
    zeta, xi = drawn_paths(500, 30)
    contacts = carom.Contacts(500, (*STIFFNESS[:1], *STIFFNESS), FRICTION, directions=1)
    state = library.contact_state((500,))
    for a, b in zip(zeta, xi):
        state, (f_x, f_z) = library.advance(state, *tensors(library, a, b), stiffness=STIFFNESS, friction=FRICTION)
        wanted = contacts.advance(a, b)
        assert np.abs(as_numpy(f_x) - wanted[:, 0]).max() < 1e-12
        assert np.abs(as_numpy(f_z) - wanted[:, 2]).max() < 1e-12
    full = library.contact_state(capacity=2)
    for a in (0.1, 0.2, 0.3, 0.4):
        full, (f_x, _) = library.advance(full, a, 0.2 * a * a, stiffness=STIFFNESS, friction=FRICTION)
    assert np.isnan(as_numpy(f_x))
