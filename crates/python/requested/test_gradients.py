"""Derivatives by `carom.jax` and `carom.torch`. On request: needs jax and torch beside carom.

    pip install jax torch pytest
    python -m pytest crates/python/requested crates/python/tests/test_array_code.py
"""

import pathlib
import sys

import carom
import carom.jax
import carom.torch
import jax
import jax.numpy as jnp
import numpy as np
import pytest
import torch

sys.path.append(str(pathlib.Path(__file__).parents[1] / "tests"))
from test_array_code import FRICTION, KAPPA, LAMBDA, RNG, STIFFNESS, as_numpy, drawn_paths, tensors, unlike  # noqa: E402

jax.config.update("jax_enable_x64", True)


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
