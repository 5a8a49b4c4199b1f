"""Walls that move along their normal."""

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
