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
