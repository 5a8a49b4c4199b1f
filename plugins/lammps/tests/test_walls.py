"""Walls that move along their normal."""

import re

import numpy as np
import pytest
from conftest import lmp, thermo

# A ball of 1 m at rest, 1 cm above a floor that rises. By Hertz they meet after .1 s and part after .129 s more.
SPEED, MASS = 0.1, 1000 * np.pi / 6
BALL = """newton off
plugin load ${plugin}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -2 2 -2 2 -2 2
create_box 1 box
create_atoms 1 single 0 0 0.51
set group all diameter 1 density 1000
pair_style carom energy yes
pair_coeff 1 1 young 1e7 poisson 0.3 friction 0.1
"""
FLOOR = f"""neighbor 0.01 bin
fix move all nve/sphere
fix floor all wall/carom plane 0 0 0 0 0 1 young 1e7 poisson 0.3 friction 0.1 velocity 0 0 {SPEED}
compute where all carom/energy
variable v equal vcm(all,z)
timestep 1e-4
thermo_style custom step v_v c_where[1] c_where[4] f_floor[3]
thermo_modify norm no format float %.15g
"""


def test_a_rising_floor_throws_a_ball_at_twice_its_speed(tmp_path):
    table = thermo(lmp(BALL + FLOOR + "thermo 10\nrun 3000\n", tmp_path))
    assert table["v_v"][-1] == pytest.approx(2 * SPEED, rel=1e-4)
    assert table["c_where[4]"][-1] == pytest.approx(0.5 * MASS * (2 * SPEED) ** 2, rel=1e-4)
    touched = table["Step"][np.abs(table["f_floor[3]"]) > 0] * 1e-4
    assert touched[0] == pytest.approx(0.1, abs=2e-3)
    assert touched[-1] - touched[0] == pytest.approx(0.129, abs=4e-3)


def test_a_restart_within_a_contact_keeps_the_work_of_the_wall(tmp_path):
    """The work of a step takes the mean of the force before and after it."""
    whole = thermo(lmp(BALL + FLOOR + "thermo 100\nrestart 1600 restart.*\nrun 3000\n", tmp_path))
    again = "newton off\nplugin load ${plugin}\nread_restart restart.1600\ncomm_modify vel yes\n"
    rest = thermo(lmp(again + FLOOR + "thermo 100\nrun 1400\n", tmp_path))
    assert np.abs(rest["f_floor[3]"]).max() > 1000
    assert rest["c_where[4]"][-1] == pytest.approx(whole["c_where[4]"][-1], rel=1e-12)
    assert rest["v_v"][-1] == whole["v_v"][-1]


def test_a_new_grain_does_not_take_over_the_contact_of_one_that_left(tmp_path):
    lies = BALL.replace("0.51", "0.499") + FLOOR.replace("fix move all nve/sphere", "velocity all set 0.1 0 0")
    lies += "thermo_style custom step f_floor[1] f_floor[3]\nrun 10\n"
    assert abs(thermo(lmp(lies, tmp_path))["f_floor[1]"][-1]) > 1
    anew = "delete_atoms group all\ncreate_atoms 1 single 0 0 0.499\nset group all diameter 1 density 1000\nrun 1\n"
    table = thermo(lmp(lies + anew, tmp_path))
    assert not table["f_floor[1]"].any() and table["f_floor[3]"].all()


def test_grains_that_change_their_ranks_take_their_own_contacts_along(tmp_path):
    """Two balls slide over the border of the ranks in opposite directions."""
    pair = "create_atoms 1 single -0.01 -1 0.499\ncreate_atoms 1 single 0.01 1 0.499\ngroup second id 2\n"
    pair += "velocity all set 1 0.2 0\nvelocity second set -1.5 0.1 0\n"
    slide = BALL.replace("units si\n", "units si\nprocessors * 1 1\n").replace("create_atoms 1 single 0 0 0.51\n", pair)
    slide += FLOOR.replace("nve/sphere", "nve/noforce").replace(f" velocity 0 0 {SPEED}", "")
    slide += "thermo_style custom step f_floor[1] f_floor[2] f_floor[5]\nthermo_modify format float %.15g\nthermo 1\nrun 300\n"
    one, two = (thermo(lmp(slide, tmp_path, ranks=ranks)) for ranks in (1, 2))
    for column in one:
        assert two[column] == pytest.approx(one[column], rel=1e-9), column


def spinning(tmp_path, keywords):
    """Velocity and spin of a ball that falls with spin on a floor with these keywords, as text."""
    law = "pair_style carom law coulomb tolerance 1e-3 torsion yes"
    floor = f"fix floor all wall/carom plane 0 0 0 0 0 1 young 1e7 poisson 0.3 friction 0.1 {keywords}\n"
    move = "set group all omega 2 1 20\nvelocity all set 0.3 0.1 -1\nneighbor 0.01 bin\nfix move all nve/sphere\n"
    shown = "dump end all custom 1 end vx vy vz omegax omegay omegaz\ndump_modify end format float %.17g first no\n"
    ball = BALL.replace("pair_style carom energy yes", law)
    lmp(ball + floor + move + "timestep 1e-3\nrun 120\n" + shown + "run 0\n", tmp_path)
    return (tmp_path / "end").read_text().splitlines()[-1]


def test_a_wall_inherits_what_it_does_not_name(tmp_path):
    plain = spinning(tmp_path, "")
    for keywords in ("law coulomb", "tolerance 1e-3", "torsion yes", "torsion yes law coulomb"):
        assert spinning(tmp_path, keywords) == plain, keywords
    # Each of the three counts.
    others = {spinning(tmp_path, keywords) for keywords in ("law fixed-direction", "tolerance 0.1", "torsion no")}
    assert len(others | {plain}) == 4


TOO_LONG = "the time step is too long"


def test_a_time_step_that_is_too_long_is_told_once(tmp_path):
    # An impact of .129 s on the wall, after .1 s.
    def log(steps, ranks=1, more=""):
        step = FLOOR.replace("timestep 1e-4", f"timestep {0.1292 / steps}")
        lmp(BALL + step + f"thermo 100\nrun {3 * steps}\n{more}", tmp_path, ranks=ranks)
        return (tmp_path / "log.lammps").read_text()

    assert TOO_LONG not in log(21)
    assert log(19).count(TOO_LONG) == 1
    shortest = re.search(r"the shortest lasts (\S+)", log(19, ranks=2))
    assert float(shortest[1]) == pytest.approx(19, rel=6e-3)
    # In a second run nothing begins.
    assert log(10, more="run 100\n").count(TOO_LONG) == 1


def test_two_grains_tell_of_the_time_step_too(tmp_path):
    # Half the mass and half the radius: by T ~ (m^2/R)^(1/5), and the modulus of two equal bodies as at the wall.
    duration = 0.1292 * (0.25 / 0.5) ** 0.2
    pair = "create_atoms 1 single 0 0 0.51\ncreate_atoms 1 single 0 0 -0.51\n"
    meet = "group low id 2\nvelocity low set 0 0 0.1\nneighbor 0.01 bin\nfix move all nve/sphere\n"
    for steps, count in ((21, 0), (19, 1)):
        two = BALL.replace("create_atoms 1 single 0 0 0.51\n", pair) + meet
        lmp(two + f"timestep {duration / steps}\nrun {5 * steps}\n", tmp_path)
        assert (tmp_path / "log.lammps").read_text().count(TOO_LONG) == count
