"""Oblique impacts that lose energy, by `restitution` and by `damping`, against the exact ones of viscous spheres."""

import math

import numpy as np
import pytest
from conftest import dump, lmp, thermo
from test_impact import DENSITY, YOUNG, carom, restitution
from test_restitution import SETTINGS

LAMBDAS = [0.5, 1.5, 3, 6]
# R_x of Kelvin-Voigt spheres at these lambda and kappa = 17/14, by carom.restitution(17/14, LAMBDAS,
# normal_restitution=e, exact=True) of the Python module, which meets rows of springs to 2e-5.
EXACT = {
    0.9: [-0.024276, 0.157202, 0.398686, 0.108333],
    0.7: [0.101670, 0.157513, 0.284704, -0.008333],
    0.5: [0.142448, 0.152346, 0.189748, -0.125],
}
# The relaxation time that gives e, where m = K = v = 1 and Hertz's force is K zeta^(3/2).
RELAXATION = {0.9: 0.062982, 0.7: 0.231300, 0.5: 0.502513}
# How far the law may be from the exact theory, converged, and what 50 steps in an impact may add.
BOUNDS = {"restitution": {0.9: 0.018, 0.7: 0.025, 0.5: 0.029}, "damping": {0.9: 0.004, 0.7: 0.020, 0.5: 0.035}}
COARSE = 0.007


def style(how, e):
    """The spheres of test_impact, which all meet at one normal speed v: (m/K)^(2/5) v^(-1/5) = (4/5)^(2/5) deepest/v."""
    mass, modulus, radius = DENSITY * math.pi / 12, YOUNG / (2 * 0.91), 0.25
    deepest = 1.2e-5 * radius
    speed = math.sqrt(16 * math.sqrt(radius) * modulus * deepest**2.5 / (15 * mass))
    number = e if how == "restitution" else RELAXATION[e] * 0.8**0.4 * deepest / speed
    given = carom("fixed-direction", 0.3)
    given[1] += f" {how} {number:.17g}"
    return given


@pytest.mark.parametrize("how", BOUNDS)
@pytest.mark.parametrize("e", EXACT)
@pytest.mark.parametrize("steps, more", [(400, 0.0), (50, COARSE)])
def test_spheres_rebound_as_viscous_ones(host, how, e, steps, more):
    """Four directions at each e, from converged steps to few."""
    found, normal = restitution(host, style(how, e), 0.3, LAMBDAS, steps, lasts=2)
    off = found - EXACT[e]
    print(f"{how}, e = {e}, {steps} steps: R_x {np.round(found, 4)}, off {np.round(off, 4)}, e {np.round(normal, 5)}")
    assert np.abs(off).max() <= BOUNDS[how][e] + more
    assert np.abs(normal - e).max() <= 2e-3


RADIUS, VELOCITY, POLYMER = 1e-3, (0.4, 0.0, -0.6105571226), "young 1e10 poisson 0.3 friction 0.35"


def ball_on_plane(host, loss, steps, part):
    """R_x and e of a ball that touches the plane after this part of its first step."""
    mass, stiffness = 2600 * 4 / 3 * math.pi * RADIUS**3, 4 / 3 * 1e10 / (2 * 0.91) * math.sqrt(RADIUS)
    dt = 2.943275 * 1.25**0.4 * ((mass / stiffness) ** 2 / -VELOCITY[2]) ** 0.2 / steps
    host.commands_string(SETTINGS.replace("block -2 2 -2 2 -2 2", "block -0.01 0.01 -0.01 0.01 -0.01 0.01"))
    host.create_atoms(1, [1], [1], [0.0, 0.0, RADIUS - part * dt * VELOCITY[2]], list(VELOCITY))
    host.commands_list(
        [
            f"set atom 1 diameter {2 * RADIUS}",
            "set group all density 2600",
            "pair_style carom",
            f"pair_coeff * * {POLYMER} {loss}",
            f"fix floor all wall/carom plane 0 0 0 0 0 1 {POLYMER} {loss}",
            "neighbor 0.001 bin",
            "fix move all nve/sphere",
            f"timestep {dt:.17g}",
            f"run {2 * steps}",
        ]
    )
    v, w = (host.numpy.extract_atom(name)[0] for name in ("v", "omega"))
    return (RADIUS * w[1] - v[0]) / VELOCITY[0], -v[2] / VELOCITY[2]


@pytest.mark.parametrize("steps, part", [(1600, 0.3), (50, 0.05), (50, 0.3), (50, 0.55), (50, 0.8)])
def test_a_millimetre_ball_at_half_restitution(host, steps, part):
    """The exact R_x is .1564, from rows of springs. Converged the law gives .1702, and .1686 of a ball so stiff that the
    approach, here .0034 R, does not shorten the arms. Were friction not to end with the normal force, it would be .395."""
    r_x, e = ball_on_plane(host, "restitution 0.5", steps, part)
    print(f"{steps} steps, touch at {part}: R_x {r_x:.5f}, e {e:.5f}")
    assert abs(r_x - 0.169) <= 4e-3
    assert abs(e - 0.5) <= 2e-3


# A ball strikes the plane as two others strike each other; an impact takes about a hundred steps.
THREE = """newton off
plugin load ${plugin}
units si
atom_style sphere
atom_modify sort 0 0
boundary f f f
comm_modify vel yes
region box block -0.02 0.02 -0.02 0.02 -0.001 0.04 units box
create_box 1 box
create_atoms 1 single -0.01 0 0.005001 units box
create_atoms 1 single 0.01 0 0.031001 units box
create_atoms 1 single 0.011 0.001 0.0211 units box
set group all diameter 0.01 density 2500
velocity all set 0.2 0.1 -0.6 units box
group below id 3
velocity below set 0 0 0.1 units box
set group all omega 20 -30 10
pair_style carom energy yes
pair_coeff 1 1 young 1e7 poisson 0.25 friction 0.3 LOSS
"""
FLOOR = """neighbor 0.001 bin
fix move all nve/sphere
fix floor all wall/carom plane 0 0 0 0 0 1 young 1e7 poisson 0.25 friction 0.3 LOSS
compute where all carom/energy
compute touch all pair/local force cutoff radius
compute force all reduce max c_touch inputs local
thermo_style custom step c_force f_floor[3] c_where[1] c_where[2] c_where[3]
thermo_modify norm no format float %.17g
timestep 1e-5
thermo 10
"""
WROTE = "write_dump all custom dump.{} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n"


@pytest.mark.parametrize("loss", ["restitution 0.5", "damping 3e-4"])
@pytest.mark.parametrize("at", [20, 80])
def test_a_restart_in_a_lossy_contact_goes_on_bit_for_bit(tmp_path, loss, at):
    """Written as the approach grows and as it falls. Both runs write files at the same steps: a contact that is written
    sums its forces up anew, which is another round-off."""
    make, floor = (text.replace("LOSS", loss) for text in (THREE, FLOOR))
    floor += f"restart {at} restart.*\n"
    whole = thermo(lmp(make + floor + "run 200\n" + WROTE.format("whole"), tmp_path))
    again = f"newton off\nplugin load ${{plugin}}\natom_modify sort 0 0\nread_restart restart.{at}\ncomm_modify vel yes\n"
    rest = thermo(lmp(again + floor + f"run {200 - at}\n" + WROTE.format("rest"), tmp_path))
    assert np.array_equal(dump(tmp_path / "dump.whole"), dump(tmp_path / "dump.rest"))
    for column in ("Step", "c_force", "f_floor[3]", "c_where[1]", "c_where[2]", "c_where[3]"):
        assert np.array_equal(whole[column][at // 10 :], rest[column]), column
    assert rest["c_force"][0] > 0 and rest["f_floor[3]"][0] < 0 and rest["c_where[1]"][-1] == 0, "in contact, and apart"
    assert (whole["c_where[1]"][at // 10 + 1] > rest["c_where[1]"][0]) == (at == 20), "pressed together, or released"
    for heat in ("c_where[2]", "c_where[3]"):
        assert 0 < rest[heat][0] < 0.99 * rest[heat][-1], heat
