"""`carom.jax` and `carom.torch` against the library. On request: needs jax and torch beside carom.

    pip install jax torch pytest
    python -m pytest crates/python/requested
"""

import carom
import carom.jax
import carom.torch
import jax
import jax.numpy as jnp
import numpy as np
import pytest
import torch

jax.config.update("jax_enable_x64", True)
RNG = np.random.default_rng(20261129)
KAPPA = RNG.uniform(0.76, 1.5, 20_000)
LAMBDA = 10 ** RNG.uniform(-3, 1.2, 20_000)


def by_jax(kappa, lam):
    return np.asarray(jax.jit(carom.jax.restitution)(kappa, lam))


def by_torch(kappa, lam):
    return carom.torch.restitution(kappa, lam).numpy()


@pytest.mark.parametrize("own", [by_jax, by_torch])
def test_values_are_those_of_the_library(own):
    assert np.abs(own(KAPPA, LAMBDA) - carom.restitution(KAPPA, LAMBDA)).max() < 1e-12
    edges = np.array([1.0, 1.0 - 1e-12, 1.0 + 1e-12, 1e-300, 0.0, 7.0 - 1.0, 1e6])
    assert np.abs(own(np.full(7, 1.2), 1.2 * edges) - carom.restitution(np.full(7, 1.2), 1.2 * edges)).max() < 1e-12
    assert np.isnan(own(np.array([0.7, 1.6, 1.2, np.nan]), np.array([1.0, 1.0, -1.0, 1.0]))).all()


def test_derivatives_are_those_of_differences():
    """Of the library's own values, away from the changes of regime; both libraries agree to round-off."""
    h = 1e-4
    inner = (KAPPA > 0.77) & (KAPPA < 1.49)
    kappa, lam = KAPPA[inner][:4000], LAMBDA[inner][:4000]
    grad = jax.jit(jax.vmap(jax.grad(carom.jax.restitution, argnums=(0, 1))))
    found = np.stack(grad(kappa, lam))
    assert np.isfinite(found).all()
    pair = [torch.tensor(values, requires_grad=True) for values in (kappa, lam)]
    carom.torch.restitution(*pair).sum().backward()
    assert np.abs(found - np.stack([one.grad.numpy() for one in pair])).max() < 1e-9 * np.abs(found).max()
    # Fourth order by two steps; a change of regime within them is seen by a second pair of steps.
    def differences(step):
        by = []
        for dk, dl in ((step, 0.0), (0.0, step)):
            scale = dk + dl * lam
            at = lambda n: carom.restitution(kappa + n * dk, lam * (1 + n * dl))  # noqa: B023
            by.append((8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * scale))
        return np.stack(by)

    one, other = differences(h), differences(0.5 * h)
    settled = (np.abs(one - other) < 1e-6 * (1 + np.abs(one))).all(axis=0)
    assert settled.mean() > 0.9
    off = np.abs(found - other)[:, settled] / (1 + np.abs(other[:, settled]))
    assert off.max() < 5e-6, off.max()


def test_rebounds_are_those_of_collide():
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
    for own in (carom.jax.rebound, carom.torch.rebound):
        v, w = (np.asarray(one) for one in own(velocity, spin, **options))
        assert np.abs(v - wanted.body_1_velocity).max() < 1e-7
        assert np.abs(w - wanted.body_1_spin).max() < 1e-5
    # One that leaves the plane keeps its motion.
    v, w = carom.jax.rebound([1.0, 0.0, 0.1], [1.0, 2.0, 3.0], **options)
    assert v.tolist() == [1.0, 0.0, 0.1] and w.tolist() == [1.0, 2.0, 3.0]


def test_the_gradient_of_an_aim_is_that_of_differences():
    """A ball that shall reach a place after one bounce with friction and back spin."""

    def reached(aim):
        speed, angle, spin = aim
        velocity = jnp.array([speed * jnp.sin(angle), 0.0, -speed * jnp.cos(angle)])
        v, _ = carom.jax.rebound(velocity, jnp.array([0.0, spin, 0.0]), radius=0.02, friction=0.25, kappa=1.21)
        return v[0] * 2.0 * v[2] / 9.81

    aim = jnp.array([3.0, 0.5, -20.0])
    gradient = jax.grad(reached)(aim)
    step = 1e-6
    differences = [(reached(aim.at[i].add(step)) - reached(aim.at[i].add(-step))) / (2 * step) for i in range(3)]
    assert np.abs(gradient - np.array(differences)).max() < 1e-7
    # Newton's method on the speed brings the ball to 1 m.
    for _ in range(20):
        aim = aim.at[0].add((1.0 - reached(aim)) / jax.grad(reached)(aim)[0])
    assert abs(reached(aim) - 1.0) < 1e-10


def test_without_double_precision_there_is_an_error():
    jax.config.update("jax_enable_x64", False)
    try:
        with pytest.raises(RuntimeError, match="double precision"):
            carom.jax.restitution(1.2, 1.0)
    finally:
        jax.config.update("jax_enable_x64", True)


as_numpy = np.asarray
LIBRARIES = [carom.jax, carom.torch]


def tensors(library, *values):
    return [torch.tensor(value) for value in values] if library is carom.torch else values


@pytest.mark.parametrize("library", LIBRARIES)
def test_values_with_a_viscous_loss_are_those_of_the_library(library):
    e = np.where(np.arange(len(KAPPA)) % 7 == 0, 1.0, RNG.uniform(0.1, 1.0, len(KAPPA)))
    e[:16] = [1.0, 0.99, 0.98, 0.95, 0.9, 0.85, 0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.25, 0.2, 0.15, 0.1]
    own = as_numpy(library.restitution(*tensors(library, KAPPA, LAMBDA), normal_restitution=tensors(library, e)[0]))
    assert np.abs(own - carom.restitution(KAPPA, LAMBDA, normal_restitution=e)).max() < 1e-12
    wrong = library.restitution(*tensors(library, np.full(4, 1.2), np.ones(4)), normal_restitution=tensors(library, np.array([0.09, -0.1, np.nan, 0.5]))[0])
    assert np.isnan(as_numpy(wrong)).tolist() == [True, True, True, False]


def unlike(count):
    """kappa, lambda, gamma, friction and D_xx/D_zz all over the table of unlike spheres."""
    kappa = RNG.uniform(1.0, 1.5, count)
    gamma = (1.5 - kappa) * RNG.uniform(-1, 1, count)
    friction = np.maximum(np.abs(gamma) / 11.9, RNG.uniform(0.02, 1.0, count))
    return kappa, RNG.uniform(0, 8, count), gamma, friction, RNG.uniform(1, 6, count)


@pytest.mark.parametrize("library", LIBRARIES)
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


def fourth_order(function, values, which, step):
    """The central difference by one of several arrays."""

    def at(part):
        moved = list(values)
        moved[which] = moved[which] + part * step
        return function(*moved)

    return (8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * step)


def test_derivatives_with_a_loss_and_of_unlike_spheres_are_differences():
    """Of the same code in double precision; where two steps agree, since tables are smooth piece by piece."""
    count = 2000
    kappa, lam, gamma, friction, ratio = unlike(count)
    kappa = np.clip(kappa, 1.02, 1.48)
    gamma = np.clip(gamma, -0.9 * (1.5 - kappa), 0.9 * (1.5 - kappa))
    e, lam = RNG.uniform(0.12, 0.98, count), np.clip(lam, 0.1, 7.9)
    ratio = np.clip(ratio, 1.1, 5.0)
    lossy = lambda k, l, e: carom.jax.restitution(k, l, normal_restitution=e)  # noqa: E731
    coupled = lambda k, l, g, f, r: carom.jax.restitution(k, l, gamma=g, friction=f, mobility_ratio=r)  # noqa: E731
    friction = np.clip(friction, 0.1, 0.99)
    for function, values in ((lossy, (kappa, lam, e)), (coupled, (kappa, lam, gamma, friction, ratio))):
        every = tuple(range(len(values)))
        found = jax.jit(jax.vmap(jax.grad(function, argnums=every)))(*values)
        pairs = [torch.tensor(value, requires_grad=True) for value in values]
        if function is lossy:
            carom.torch.restitution(*pairs[:2], normal_restitution=pairs[2]).sum().backward()
        else:
            options = dict(zip(("gamma", "friction", "mobility_ratio"), pairs[2:]))
            carom.torch.restitution(*pairs[:2], **options).sum().backward()
        compiled = jax.jit(function)
        for which in every:
            assert np.abs(as_numpy(found[which]) - pairs[which].grad.numpy()).max() < 1e-9
            wide, narrow = (as_numpy(fourth_order(compiled, values, which, step)) for step in (1e-4, 5e-5))
            settled = np.abs(wide - narrow) < 1e-7 * (1 + np.abs(narrow))
            assert settled.mean() > 0.9
            off = np.abs(as_numpy(found[which]) - narrow) / (1 + np.abs(narrow))
            assert off[settled].max() < 2e-6


def test_rebounds_of_two_balls_are_those_of_collide():
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
        for library in LIBRARIES:
            found = library.rebound_of_two(
                velocities[0], spins[0], velocities[1], spins[1], radius=(0.01, 0.015), mass=mass, friction=0.3,
                kappa=kappa, normal_restitution=e, loss=loss,
            )  # fmt: skip
            names = ("body_1_velocity", "body_1_spin", "body_2_velocity", "body_2_spin")
            for own, name in zip(found, names):
                scale = 1.0 if "velocity" in name else 100.0
                assert np.abs(as_numpy(own) - getattr(wanted, name)).max() < near * scale, (loss, name)
    with pytest.raises(ValueError, match="must be 'yield' or 'viscous'"):
        carom.jax.rebound([0.0, 0, -1], [0.0, 0, 0], radius=0.01, friction=0.3, kappa=1.2, loss="waves")


def test_a_rebound_from_an_unlike_plane_is_that_of_its_r_x():
    gamma, friction, kappa = 0.2, 0.3, 1.25
    for library in LIBRARIES:
        v, w = library.rebound(
            [1.0, 0.0, -1.0], [0.0, 0.0, 0.0], radius=0.01, friction=friction, kappa=kappa, gamma=gamma
        )
        r_x = carom.restitution(kappa, 1.0 / friction, gamma=gamma, friction=friction)
        assert abs(float(v[0] - 0.01 * w[1]) + r_x) < 1e-6


STIFFNESS, FRICTION = (0.8, 1.3), 0.35


def drawn_paths(count, steps):
    zeta = RNG.uniform(-0.1, 1.0, (steps, count))
    return zeta, RNG.uniform(-0.8, 0.8, (steps, count)) * FRICTION


@pytest.mark.parametrize("library", LIBRARIES)
def test_contacts_are_those_of_the_library(library):
    zeta, xi = drawn_paths(500, 30)
    contacts = carom.Contacts(500, (*STIFFNESS[:1], *STIFFNESS), FRICTION, directions=1)
    state = library.contact_state((500,))
    advance = jax.jit(carom.jax.advance) if library is carom.jax else library.advance
    for a, b in zip(zeta, xi):
        state, (f_x, f_z) = advance(state, *tensors(library, a, b), stiffness=STIFFNESS, friction=FRICTION)
        wanted = contacts.advance(a, b)
        assert np.abs(as_numpy(f_x) - wanted[:, 0]).max() < 1e-12
        assert np.abs(as_numpy(f_z) - wanted[:, 2]).max() < 1e-12
    full = library.contact_state(capacity=2)
    for a in (0.1, 0.2, 0.3, 0.4):
        full, (f_x, _) = library.advance(full, a, 0.2 * a * a, stiffness=STIFFNESS, friction=FRICTION)
    assert np.isnan(as_numpy(f_x))


def test_derivatives_of_a_path_are_differences():
    zeta, xi = drawn_paths(200, 8)

    def force(zeta, xi, c_x, c_z, friction):
        state = carom.jax.contact_state()
        for a, b in zip(zeta, xi):
            state, (f_x, _) = carom.jax.advance(state, a, b, stiffness=(c_x, c_z), friction=friction)
        return f_x

    many = jax.jit(jax.vmap(force, in_axes=(1, 1, None, None, None)))
    gradient = jax.jit(jax.vmap(jax.grad(force, argnums=(2, 3, 4)), in_axes=(1, 1, None, None, None)))
    found = gradient(zeta, xi, *STIFFNESS, FRICTION)
    values = [zeta, xi, *STIFFNESS, FRICTION]
    for which in range(3):
        assert np.isfinite(found[which]).all()
        wide, narrow = (as_numpy(fourth_order(many, values, 2 + which, step)) for step in (2e-4, 1e-4))
        settled = np.abs(wide - narrow) < 1e-8
        assert settled.mean() > 0.9
        assert np.abs(as_numpy(found[which]) - narrow)[settled].max() < 1e-7
    # PyTorch differentiates the same path alike.
    numbers = [torch.tensor(value, dtype=torch.float64, requires_grad=True) for value in (*STIFFNESS, FRICTION)]
    state = carom.torch.contact_state((200,))
    for a, b in zip(*tensors(carom.torch, zeta, xi)):
        state, (f_x, _) = carom.torch.advance(state, a, b, stiffness=tuple(numbers[:2]), friction=numbers[2])
    f_x.sum().backward()
    for own, other in zip(numbers, found):
        assert abs(float(own.grad) - float(other.sum())) < 1e-9
