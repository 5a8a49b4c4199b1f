"""Clumps: grains that a fix of rigid bodies holds together."""

import math

import numpy as np
import pytest
from conftest import dump, lmp, thermo

HEAD = """
variable newton index off
newton ${{newton}}
plugin load ${{plugin}}
units si
atom_style hybrid sphere molecular
boundary f f f
comm_modify vel yes
"""

# A dumbbell that stands upright falls on a floor, or on another one below it.
UPRIGHT = (
    HEAD
    + """
region box block -2 2 -2 2 -2 4 units box
create_box 1 box
create_atoms 1 single 0 0 0.500000001
create_atoms 1 single 0 0 1.1
{other}
set group all diameter 1
set group all density 2500
set atom 1 mol 1
set atom 2 mol 1
neighbor 0.1 bin
neigh_modify exclude molecule/intra all
pair_style carom
pair_coeff * * young 1e9 poisson 0.3 friction 0.1 restitution {e}
{floor}
velocity all set 0 0 0
group falls molecule 1
velocity falls set 0 0 -{speed}
fix hold all {fix} molecule
timestep {dt}
thermo_style custom step atoms
compute_modify thermo_temp extra/dof 0
run 400
variable up equal vcm(falls,z)
print "UP ${{up}}"
"""
)


@pytest.mark.parametrize("fix", ["rigid", "rigid/small"])
@pytest.mark.parametrize("below", ["a wall", "another"])
def test_a_clump_rebounds_with_the_given_restitution(tmp_path, fix, below):
    """The mass that a contact moves is that of the whole body."""
    e, speed = 0.45, 1e-2
    mass = 2 * 2500 * math.pi / 6
    if below == "a wall":
        reduced, radius = mass, 0.5
        other, floor = "", "fix wall all wall/carom plane 0 0 0 0 0 1 young 1e9 poisson 0.3 friction 0.3 restitution 0.45"
    else:
        reduced, radius = mass / 2, 0.25
        other = "create_atoms 1 single 0 0 -0.5\ncreate_atoms 1 single 0 0 -1.1\nset atom 3 mol 2\nset atom 4 mol 2"
        floor = ""
    stiffness = 4 / 3 * 1e9 / (2 * 0.91) * math.sqrt(radius)
    dt = 2.943275 * (reduced**2 / (stiffness**2 * speed)) ** 0.2 / 60
    script = UPRIGHT.format(other=other, floor=floor, e=e, speed=speed, fix=fix, dt=dt)
    printed = lmp(script, tmp_path)
    up = float(printed.split("\nUP ")[1].split()[0])
    wanted = e * speed if below == "a wall" else -speed * (1 - e) / 2
    assert up == pytest.approx(wanted, abs=1e-3 * speed)


# Clumps of two overlapping grains, to fall into a box.
MADE = (
    HEAD
    + """
region box block -0.03 0.03 -0.03 0.03 -0.005 0.12 units box
create_box 1 box
molecule pair pair.mol
region above block -0.02 0.02 -0.02 0.02 0.012 0.08 units box
lattice sc 0.018
create_atoms 0 region above mol pair 4711
variable heavy atom "2500*(1 + mol%3)"
set group all density v_heavy
mass 1 1 # of no use beside those of the grains, and required
write_data made.data
"""
)
HEAP = (
    HEAD
    + """
processors ${{across}} 1 1
read_data made.data
neighbor 0.002 bin
neigh_modify every 1 delay 0 check yes exclude molecule/intra all
pair_style carom energy yes
pair_coeff * * young 2e7 poisson 0.25 friction 0.4 {loss}
fix hold all rigid/small molecule
fix gravity all gravity 9.81 vector 0 0 -1
variable wall index "young 1e8 poisson 0.2 friction 0.5 {loss}"
fix floor all wall/carom plane 0 0 0 0 0 1 ${{wall}}
fix west all wall/carom plane -0.028 0 0 1 0 0 ${{wall}}
fix east all wall/carom plane 0.028 0 0 -1 0 0 ${{wall}}
fix south all wall/carom plane 0 -0.028 0 0 1 0 ${{wall}}
fix north all wall/carom plane 0 0.028 0 0 -1 0 ${{wall}}
variable dt index 5e-6
timestep ${{dt}}
compute turning all erotate/rigid hold
compute moving all ke/rigid hold
compute where all carom/energy
variable total equal c_moving+c_turning+f_gravity+c_where[1]+c_where[2]+c_where[3]
compute_modify thermo_temp extra/dof 0 dynamic/dof yes
thermo_style custom step c_moving c_turning f_gravity c_where[1] c_where[2] c_where[3] v_total
thermo_modify norm no format float %.15g
thermo {every}
run {steps}
write_dump all custom dump.{tag} id x y z modify format float %.15g
"""
)

# A clump of two grains of 8 mm, 5 mm apart.
PAIR_MOL = """two grains

2 atoms

Coords

1 -0.0025 0 0
2 0.0025 0 0

Types

1 1
2 1

Diameters

1 0.008
2 0.008

Masses

1 6.7e-4
2 6.7e-4
"""


def heap(folder, tag, steps, ranks=1, dt=5e-6, loss="damping 2e-4"):
    (folder / "pair.mol").write_text(PAIR_MOL)
    lmp(MADE.format(), folder)
    script = HEAP.format(steps=steps, every=max(steps // 20, 1), tag=tag, loss=loss)
    return thermo(lmp(script, folder, ranks=ranks, dt=dt, across=ranks))


@pytest.mark.parametrize("loss", ["damping 2e-4", "restitution 0.6"])
def test_energy_of_clumps_goes_where_it_is_booked(tmp_path, loss):
    missed = []
    for dt in (1e-5, 5e-6):
        table = heap(tmp_path, "one", round(0.12 / dt), dt=dt, loss=loss)
        total = table["v_total"]
        gone = table["c_where[2]"][-1] + table["c_where[3]"][-1]
        assert gone > 0.1 * table["c_moving"].max(), "they met"
        missed.append(np.abs(total - total[0]).max() / gone)
    print(loss, missed)
    assert missed[0] < 2e-3 and missed[1] < 0.6 * missed[0]


def test_clumps_on_two_ranks(tmp_path):
    """Bodies lie across the border of the ranks, and their masses count there."""
    heap(tmp_path, "one", 16000, loss="restitution 0.6")
    heap(tmp_path, "two", 16000, ranks=2, loss="restitution 0.6")
    one, two = (dump(tmp_path / f"dump.{tag}") for tag in ("one", "two"))
    off = np.abs(one[:, 1:4] - two[:, 1:4]).max() / 0.008
    print("apart by diameters:", off)
    assert off < 1e-8
