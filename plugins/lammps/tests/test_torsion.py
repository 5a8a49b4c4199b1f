"""Two spheres that spin against each other about their normal."""

import math

import numpy as np
import pytest

YOUNG, POISSON, FRICTION = 1e9, 0.3, 0.4
RADII, OVERLAP = (0.5, 0.3), 1e-5
NORMAL = np.array([0.36, 0.48, 0.8])


def spin(host, rates, dt, steps, torsion="yes", tags=(1, 2)):
    """The torques on both, and what compute carom/energy tells, after each run of so many steps at a rate."""
    apart = (sum(RADII) - OVERLAP) * NORMAL
    host.commands_list(
        [
            "units si",
            "atom_style sphere",
            "boundary f f f",
            "newton off",
            "comm_modify vel yes",
            "region box block 0 4 0 4 0 4",
            "create_box 1 box",
        ]
    )
    places = np.array([np.full(3, 2.0) + apart, np.full(3, 2.0)])
    host.create_atoms(2, list(tags), [1, 1], places.ravel().tolist(), [0.0] * 6)
    host.commands_list(
        [f"group g{k} id {k}" for k in (1, 2)]
        + [f"set group g{k} diameter {2 * radius}" for k, radius in zip((1, 2), RADII)]
        + [
            "set group all density 1000",
            f"pair_style carom torsion {torsion} energy yes",
            f"pair_coeff * * young {YOUNG} poisson {POISSON} friction {FRICTION}",
            "neighbor 0.1 bin",
            "compute where all carom/energy",
            f"timestep {dt}",
        ]
    )
    told = []
    for rate in rates:
        host.command("set group g2 omega " + " ".join(str(rate * n) for n in NORMAL))
        host.command(f"run {steps}")
        order = np.argsort(host.numpy.extract_atom("id")[:2])
        torque = host.numpy.extract_atom("torque")[:2][order] @ NORMAL
        energy = np.array(host.numpy.extract_compute("where", 0, 1))
        told.append((torque.copy(), energy.copy(), host.numpy.extract_atom("torque")[:2].copy()))
    return told


RELATIVE = 1 / sum(1 / r for r in RADII)
RADIUS = math.sqrt(RELATIVE * OVERLAP)
FORCE = 4 / 3 * YOUNG / (2 * (1 - POISSON**2)) * math.sqrt(RELATIVE) * OVERLAP**1.5
SLIDING = 3 * math.pi / 16 * FRICTION * FORCE * RADIUS


def test_torque_of_a_small_twist_and_of_sliding(host):
    """Without slip 8/3 G a^3 times the twist (two halves in a row), 3 pi/16 f F a in the end."""
    stiffness = 8 / 3 * YOUNG / (2 * (1 + POISSON)) * RADIUS**3
    small, large = 1e-3 * SLIDING / stiffness, 30 * SLIDING / stiffness
    told = spin(host, [small, large], 0.01, 100)
    for torque, _, whole in told:
        assert torque[0] == pytest.approx(-torque[1], rel=1e-12)
        assert np.allclose(whole, np.outer(whole @ NORMAL, NORMAL), atol=1e-8 * SLIDING)
    assert told[0][0][0] == pytest.approx(stiffness * small, rel=1e-3)
    assert told[1][0][0] == pytest.approx(SLIDING, rel=1e-6)


def test_work_of_a_twist_to_and_fro_is_stored_or_heat(host):
    """The torque is in the mean between its values, step by step."""
    turn = 2 * SLIDING / (8 / 3 * YOUNG / (2 * (1 + POISSON)) * RADIUS**3)
    rates = [turn * math.cos(0.1 * k) for k in range(200)]
    told = spin(host, rates, 0.02, 2)
    before, work = told[0], 0.0
    for rate, now in zip(rates[1:], told[1:]):
        work += 0.5 * (before[0][0] + now[0][0]) * rate * 0.04
        assert now[1][1] >= before[1][1]
        before = now
    gained = told[-1][1][0] + told[-1][1][1] - told[0][1][0] - told[0][1][1]
    assert told[-1][1][1] > 0.1 * work > 0
    assert gained == pytest.approx(work, rel=5e-3)


def test_no_torque_without_torsion(host):
    told = spin(host, [1.0], 0.01, 10, torsion="no")
    assert np.abs(told[0][2]).max() < 1e-8 * SLIDING


@pytest.mark.parametrize("tags", [(1, 2), (2, 1)])
def test_the_values_of_a_contact_are_those_of_its_grains(host, tags):
    """In either order of their tags, as compute pair/local names the first one."""
    spin(host, [], 0.01, 0, tags=tags)
    host.commands_list(
        [
            "velocity g2 set 1e-6 -2e-6 3e-6",
            "compute each all pair/local p1 p2 p3 p4 p5 p6 p7 p10 cutoff radius",
            "compute tags all property/local patom1 patom2 cutoff radius",
            "run 10",
        ]
    )
    (values,), ((first, second),) = (host.numpy.extract_compute(name, 2, 2) for name in ("each", "tags"))
    of = dict(zip(host.numpy.extract_atom("id")[:2], zip(*(host.numpy.extract_atom(name) for name in ("x", "f")))))
    force, normal = of[first][1], (of[first][0] - of[second][0]) / (sum(RADII) - OVERLAP)
    across = force - FORCE * normal
    size, energy = np.linalg.norm(across), host.numpy.extract_compute("where", 0, 1)[0]
    assert 0.01 * FORCE < size < FRICTION * FORCE
    assert values == pytest.approx([*across, FORCE, size, OVERLAP, RADIUS, energy], rel=1e-8)
