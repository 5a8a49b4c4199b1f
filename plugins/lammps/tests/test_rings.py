"""Law rings: impacts of unlike spheres, and what the other laws say that they neglect."""

import numpy as np
import pytest
from conftest import lmp
from test_impact import restitution

LAMBDA = [0.5, 1.0, 2.0, 3.0, 5.0]
# Two materials (Young's modulus and Poisson's ratio), friction, and R_x by carom_collide, whose error it states as 0.01
# at most.
PAIRS = {
    "alumina-glass": [(380e9, 0.23), (70e9, 0.22), 0.092, [0.1970, 0.2473, 0.3529, 0.4432, 0.2825]],
    "steel-glass": [(210e9, 0.3), (70e9, 0.22), 0.15, [-0.0203, 0.0969, 0.3081, 0.4339, 0.3148]],
    "silica-steel": [(72e9, 0.17), (210e9, 0.3), 0.08, [0.2140, 0.2558, 0.3550, 0.4419, 0.2780]],
    "steel-aluminium": [(210e9, 0.3), (70e9, 0.33), 0.3, [-0.0797, 0.0536, 0.3551, 0.4742, 0.3419]],
}


def style(law, one, two, friction):
    def coeff(at, material):
        return f"pair_coeff {at} {at} young {material[0]} poisson {material[1]} friction {friction}"

    return [f"pair_style carom law {law}", coeff(1, one), coeff(2, two), f"pair_coeff 1 2 friction {friction}"]


@pytest.mark.parametrize("name", PAIRS)
def test_impact_of_unlike_spheres_in_a_hundred_steps(host, name):
    one, two, friction, expected = PAIRS[name]
    measured, normal = restitution(host, style("rings", one, two, friction), None, LAMBDA, 100, (0.5, 0.35), (one, two), friction)
    off = np.abs(measured - expected)
    print(f"{name}: R_x off by {off.max():.1e}, R_z by {np.abs(normal - 1).max():.1e}")
    assert off.max() < 0.01
    assert np.abs(normal - 1).max() < 0.01


def test_the_order_of_the_grains_does_not_matter(host):
    """Where the first of two tags has the other material nothing changes but round-off of their places."""
    one, two, friction, _ = PAIRS["alumina-glass"]
    told = []
    cases = (((one, two), (0.5, 0.35), (1, 2)), ((two, one), (0.35, 0.5), (1, 2)), ((one, two), (0.35, 0.5), (2, 1)))
    for bodies, radii, types in cases:
        given = style("rings", *bodies, friction)
        told.append(restitution(host, given, None, LAMBDA, 100, radii, bodies, friction, types)[0])
        host.command("clear")
    assert np.abs(told[0] - told[1]).max() < 1e-6, told
    assert np.abs(told[0] - told[2]).max() < 1e-6, told


LOG = """plugin load ${plugin}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block 0 4 0 4 0 4
create_box 3 box
create_atoms 1 single 2 2 2
set group all diameter 1 density 1000
pair_style carom ${law}
pair_coeff 1 1 young 380e9 poisson 0.23 friction 0.092
pair_coeff 2 2 young 70e9 poisson 0.22 friction 0.092
pair_coeff 3 3 young 380e9 poisson 0.23 friction 0.092
pair_coeff 1*2 3 friction 0.092
pair_coeff 1 2 friction 0.092
fix floor all wall/carom plane 0 0 0 0 0 1 young 70e9 poisson 0.22 friction 0.092
fix move all nve/sphere
run 1
run 1
"""


def test_the_log_says_once_for_each_pair_of_types_what_is_neglected(tmp_path):
    """gamma = 0.249, f = 0.092: (gamma/f)^2/(4 + (gamma/f)^2) + gamma^2 = 0.71."""
    for law in ("law fixed-direction", "law coulomb"):
        lines = [line for line in lmp(LOG, tmp_path, law=law).split("\n") if "coupling" in line]
        assert [line.split(" of pair")[0] for line in lines[:2]] == ["pair_coeff 1 2", "pair_coeff 2 3"], lines
        assert [line.split(":")[1].strip() for line in lines[2:]] == ["grains of type 1", "grains of type 3"], lines
        assert all("up to 0.709; law rings" in line for line in lines), lines
    assert "coupling" not in lmp(LOG, tmp_path, law="law rings")
