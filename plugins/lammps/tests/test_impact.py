"""Impacts of two spheres through pair carom, against the exact solution."""

import json
import math
import pathlib

import numpy as np
import pytest

FRICTION, YOUNG, DENSITY = 0.1, 1e9, 2500.0
EXACT = json.loads(pathlib.Path(__file__).with_name("exact_restitution.json").read_text())
# A direction of shear that is no axis.
ALONG = np.array([math.cos(0.37), math.sin(0.37), 0.0])


def restitution(host, style, poisson, lambdas, steps, radii=(0.5, 0.5), bodies=None, friction=FRICTION, types=(1, 2), lasts=1.1):
    """R_x and R_z of one impact per lambda, all in one run that `lasts` so many elastic impacts; grains of two `types` if
    `bodies` has their moduli."""
    reduced = 1 / sum(1 / r for r in radii)
    masses = [DENSITY * 4 / 3 * math.pi * r**3 for r in radii]
    mass = 1 / sum(1 / m for m in masses)
    modulus = 1 / sum((1 - nu**2) / young for young, nu in bodies or [(YOUNG, poisson)] * 2)
    deepest = 1.2e-5 * reduced
    speed = math.sqrt(16 * math.sqrt(reduced) * modulus * deepest**2.5 / (15 * mass))
    dt = 2.943275 * deepest / speed / steps
    gap = 0.03 * dt * speed
    count = len(lambdas)
    places, velocities = [], []
    for k, ratio in enumerate(lambdas):
        middle = np.array([4.0 * k + 2, 2.0, 2.0])
        for sign, radius, own in ((1, radii[0], masses[1]), (-1, radii[1], masses[0])):
            places.append(middle + [0, 0, sign * (radius + gap / 2)])
            share = sign * own / sum(masses)
            velocities.append(share * (ratio * friction * speed * ALONG - [0, 0, speed]))
    host.commands_list(
        [
            "units si",
            "atom_style sphere",
            "boundary f f f",
            "newton off",
            "comm_modify vel yes",
            f"region box block 0 {4 * count} 0 4 0 4",
            f"create_box {2 if bodies else 1} box",
        ]
    )
    ids = list(range(1, 2 * count + 1))
    host.create_atoms(2 * count, ids, list(types if bodies else (1, 1)) * count, np.ravel(places).tolist(), np.ravel(velocities).tolist())
    for k, radius in enumerate(radii):
        host.command(f"group side{k} id {k + 1}:{2 * count}:2")
        host.command(f"set group side{k} diameter {2 * radius}")
    host.commands_list(
        [f"set group all density {DENSITY}"]
        + style
        + ["neighbor 0.1 bin", "fix move all nve/sphere", f"timestep {dt}", f"run {int(lasts * steps)}"]
    )
    tags = host.numpy.extract_atom("id")[: 2 * count]
    order = np.argsort(tags)
    v, w = (host.numpy.extract_atom(name)[: 2 * count][order] for name in ("v", "omega"))
    rolling = radii[0] * w[0::2] + radii[1] * w[1::2]
    relative = v[0::2] - v[1::2] - np.cross(rolling, [0, 0, 1])
    return -(relative @ ALONG) / (friction * speed * np.array(lambdas)), relative[:, 2] / speed


def carom(law, poisson):
    return [
        f"pair_style carom law {law}",
        f"pair_coeff * * young {YOUNG} poisson {poisson} friction {FRICTION}",
    ]


@pytest.mark.parametrize("share", [0.005, 0.02, 0.05])
def test_damping_gives_the_restitution_of_viscoelastic_spheres(host, share):
    """e = 1 - x + 0.8 x^2 - 0.45 x^3, fitted to the exact values, with x = 5.57 damping/T for the duration T of the
    elastic contact."""
    poisson = 0.3
    mass, modulus, radius = DENSITY * math.pi / 12, YOUNG / (2 * (1 - poisson**2)), 0.25
    deepest = 1.2e-5 * radius
    speed = math.sqrt(16 * math.sqrt(radius) * modulus * deepest**2.5 / (15 * mass))
    style = carom("fixed-direction", poisson)
    style[1] += f" damping {share * 2.943275 * deepest / speed}"
    normal = restitution(host, style, poisson, [0.5], 2000)[1][0]
    x = 5.568 * share
    assert abs(normal - (1 - x + 0.8 * x**2 - 0.45 * x**3)) < 0.005 * (1 - normal)


@pytest.mark.parametrize("law", ["coulomb tolerance 3e-3", "fixed-direction"])
@pytest.mark.parametrize("poisson", ["0", "0.3", "0.5"])
@pytest.mark.parametrize("steps, bound", [(50, 1.2e-3), (100, 4e-4), (2000, 1e-4)])
def test_impact_of_spheres_meets_the_exact_one(host, law, poisson, steps, bound):
    """From few steps in a contact to many."""
    exact = EXACT[poisson]
    measured, normal = restitution(host, carom(law, poisson), float(poisson), exact["lambda"], steps)
    off = np.abs(measured - exact["R_x"]).max()
    print(f"{law}, nu = {poisson}, {steps} steps: R_x off by {off:.1e}, R_z by {np.abs(normal - 1).max():.1e}")
    assert off < bound
    assert np.abs(normal - 1).max() < {50: 5e-5, 100: 1e-5, 2000: 5e-6}[steps]
