"""Grains of very different sizes."""

import json
import pathlib

import numpy as np
import pytest
from conftest import dump, lmp, thermo
from test_impact import carom, restitution

EXACT = json.loads(pathlib.Path(__file__).with_name("exact_restitution.json").read_text())


@pytest.mark.parametrize("radii", [(0.5, 0.01), (0.01, 0.5)])
def test_one_to_fifty_rebounds_exactly(host, radii):
    """R_x depends on the ratio of inertia to mass alone, which solid spheres of any sizes have."""
    exact = EXACT["0.3"]
    found, normal = restitution(host, carom("fixed-direction", 0.3), 0.3, exact["lambda"], 100, radii=radii)
    assert np.abs(found - exact["R_x"]).max() < 4e-4
    assert np.abs(normal - 1).max() < 1e-5


# Fine grains of 0.4 mm fall on three balls of 20 mm, fifty times as large.
MIXED = """
newton off
plugin load ${{plugin}}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -0.03 0.03 -0.012 0.012 -0.002 0.03 units box
create_box 2 box
create_atoms 1 single -0.0201 0 0.0100
create_atoms 1 single 0 0 0.0100
create_atoms 1 single 0.0201 0 0.0100
lattice sc 0.001
region fine block -0.02 0.02 -0.002 0.002 0.0205 0.0225 units box
create_atoms 2 region fine
set type 1 diameter 0.02
set type 2 diameter 0.0004
set group all density 2500
group fine type 2
velocity fine set 0.05 0 -0.3
variable w atom 60*sin(id)
set group fine omega v_w v_w 10
pair_style carom energy yes
pair_coeff * * young 1e7 poisson 0.3 friction 0.4 {loss}
{neighbors}
fix move all nve/sphere
fix gravity all gravity 9.81 vector 0 0 -1
fix floor all wall/carom plane 0 0 0 0 0 1 young 1e7 poisson 0.3 friction 0.4 {loss}
variable dt index 2e-6
timestep ${{dt}}
compute rotation all erotate/sphere
compute where all carom/energy
variable total equal ke+c_rotation+f_gravity+c_where[1]+c_where[2]+c_where[3]
thermo_style custom step ke c_rotation f_gravity c_where[1] c_where[2] c_where[3] v_total
thermo_modify norm no format float %.15g
thermo {every}
run {steps}
write_dump all custom dump.{tag} id x y z modify format float %.15g
"""
ONE_SIZE = "neighbor 0.0004 bin"
BY_SIZE = "neighbor 0.0004 multi\ncomm_modify mode multi"


def mixed(folder, tag, neighbors, dt=2e-6, loss="restitution 0.7"):
    steps = round(0.02 / dt)
    script = MIXED.format(loss=loss, neighbors=neighbors, steps=steps, every=steps // 20, tag=tag)
    return thermo(lmp(script, folder, dt=dt))


def test_lists_by_size_find_the_same_contacts(tmp_path):
    mixed(tmp_path, "one", ONE_SIZE)
    mixed(tmp_path, "multi", BY_SIZE)
    one, multi = (dump(tmp_path / f"dump.{tag}") for tag in ("one", "multi"))
    assert np.abs(one[:, 1:4] - multi[:, 1:4]).max() < 1e-9 * 0.0004


def test_energy_of_fine_grains_on_balls_goes_where_it_is_booked(tmp_path):
    """Over the energy of the fine grains: the balls are a thousand times as heavy as all of them."""
    table = mixed(tmp_path, "one", BY_SIZE)
    total = table["v_total"]
    gone = table["c_where[2]"][-1] + table["c_where[3]"][-1]
    off = np.abs(total - total[0]).max()
    print("balance over what became heat:", off / gone)
    assert gone > 0 and off < 2e-3 * gone
