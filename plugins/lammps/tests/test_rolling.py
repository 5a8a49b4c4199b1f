"""Rolling resistance."""

import pathlib

import numpy as np
import pytest
from conftest import Failed, dump, lmp, thermo

HERE = pathlib.Path(__file__).parent
BOX = (HERE / "box.in").read_text()
WALLS = (HERE / "box_walls.in").read_text().replace("c_where[3]-c_where[4]", "c_where[3]+c_where[5]-c_where[4]").replace("c_where[4] v_total", "c_where[4] c_where[5] v_total")
# Stiffness, damping and friction of rolling, of grains and walls; one pair of types and one wall have none.
ROLLING = "rolling 2000 0.3 0.1"
ROLLS = BOX.replace("friction 0.3 damping ${damping}", "friction 0.3 damping ${damping} " + ROLLING)
ROLLS = ROLLS.replace("friction 0.4 damping ${damping}", "friction 0.4 damping ${damping} rolling 1000 0 0.2")
WALLS = WALLS.replace("friction 0.5 damping 1e-4", "friction 0.5 damping 1e-4 " + ROLLING)
assert (ROLLS + WALLS).count("rolling") == 3

# A ball of 1 m rolls along x on a plane.
RADIUS, MASS, YOUNG, GRAVITY = 0.5, 1000 * np.pi / 6, 1e10, 9.81
MODULUS = YOUNG / (2 * (1 - 0.3**2))
DEEP = (MASS * GRAVITY / (4 / 3 * MODULUS * RADIUS**0.5)) ** (2 / 3)
ARM = RADIUS - 0.5 * DEEP
FRICTION = 0.02
BALL = f"""newton off
plugin load ${{plugin}}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -2 20 -2 2 -2 2
create_box 1 box
create_atoms 1 single 0 0 {RADIUS - DEEP:.17g}
set group all diameter 1 density 1000
velocity all set 1 0 0
set group all omega 0 {1 / ARM:.17g} 0
pair_style carom energy yes
pair_coeff 1 1 young {YOUNG} poisson 0.3 friction 0.5
neighbor 0.01 bin
fix move all nve/sphere
fix gravity all gravity {GRAVITY} vector 0 0 -1
fix floor all wall/carom plane 0 0 0 0 0 1 young {YOUNG} poisson 0.3 friction 0.5 rolling 1e6 1e4 {FRICTION}
compute where all carom/energy
compute motion all ke
compute rotation all erotate/sphere
compute made all carom/heat/atom
compute sum all reduce sum c_made
variable v equal vcm(all,x)
variable x equal xcm(all,x)
variable total equal c_motion+c_rotation+f_gravity+c_where[1]+c_where[2]+c_where[3]+c_where[5]
timestep 1e-4
thermo_style custom step c_motion c_rotation v_v v_x c_where[1] c_where[2] c_where[5] f_floor[8] c_sum v_total
thermo_modify norm no format float %.17g
thermo 10
"""


def test_a_rolling_ball_loses_the_work_of_the_torque(tmp_path):
    """The torque is friction R m g; the velocity falls at M r/(I + m r^2), with the contact r below the centre."""
    table = thermo(lmp(BALL + "run 20000\n", tmp_path))
    late = table["Step"] >= 5000
    time, v, x = table["Step"][late] * 1e-4, table["v_v"][late], table["v_x"][late]
    torque = FRICTION * RADIUS * MASS * GRAVITY
    slows = torque * ARM / (0.4 * MASS * RADIUS**2 + MASS * ARM**2)
    assert np.polyfit(time, v, 1)[0] == pytest.approx(-slows, rel=1e-5)
    moving = (table["c_motion"] + table["c_rotation"])[late]
    work = torque * (x[-1] - x[0]) / ARM
    lost = moving[0] - moving[-1]
    heat = table["c_where[5]"][late]
    print("slows over M r/(I + m r^2) - 1:", -np.polyfit(time, v, 1)[0] / slows - 1, " lost over work - 1:", lost / work - 1, " heat over work - 1:", (heat[-1] - heat[0]) / work - 1)
    assert lost == pytest.approx(work, rel=1e-5)
    assert heat[-1] - heat[0] == pytest.approx(work, rel=1e-5)
    assert np.array_equal(table["c_where[5]"], table["f_floor[8]"])
    assert np.abs(table["v_total"] - table["v_total"][0]).max() < 1e-4 * lost


def test_a_ball_comes_to_rest_and_all_became_heat(tmp_path):
    """On the spring of its rolling resistance it rocks until the dashpot has taken all."""
    table = thermo(lmp(BALL + "thermo 1000\nrun 120000\n", tmp_path))
    energy = 0.5 * MASS + 0.5 * 0.4 * MASS * (RADIUS / ARM) ** 2
    assert table["c_motion"][-1] + table["c_rotation"][-1] < 1e-9 * energy
    assert table["c_where[5]"][-1] + table["c_where[2]"][-1] == pytest.approx(energy, rel=2e-4)
    assert table["c_where[2]"][-1] < 1e-3 * energy, "it rolls, and slips little"
    assert table["v_x"][-1] == pytest.approx(table["v_x"][-10], abs=1e-9)


def test_without_rolling_a_ball_rolls_on(tmp_path):
    for none in ("", "rolling 1e6 1e4 0"):
        table = thermo(lmp(BALL.replace(f"rolling 1e6 1e4 {FRICTION}", none) + "run 5000\n", tmp_path))
        assert np.all(table["c_where[5]"] == 0)
        assert table["v_v"][-1] == pytest.approx(1, abs=1e-6)


def test_two_balls_that_roll_on_each_other_lose_the_same_spin(tmp_path):
    """By the relative radius, here of radii 1/2 and 1/4: 1/6. Two balls pressed by springs spin up about y."""
    pair = BALL.replace(f"create_atoms 1 single 0 0 {RADIUS - DEEP:.17g}\n", "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 0 0 0.74999\n")
    pair = pair.replace("diameter 1 density 1000\nvelocity all set 1 0 0\n", "diameter 1 density 1000\ngroup second id 2\nset group second diameter 0.5\n")
    pair = pair.replace("fix gravity all gravity 9.81 vector 0 0 -1\n", "")
    pair = pair.replace("fix move all nve/sphere\n", "")
    pair = pair.replace(f"set group all omega 0 {1 / ARM:.17g} 0\n", "set group second omega 0 3 0\n")
    pair = pair.replace("friction 0.5\nneighbor", "friction 0 rolling 1e8 0 0.01\nneighbor")
    pair = "\n".join(line for line in pair.split("\n") if not line.startswith("fix floor"))
    pair = pair.replace("f_floor[8] ", "").replace("+f_gravity", "")
    pair += "dump torque all custom 1 torque id tqx tqy tqz fz\ndump_modify torque format float %.17g first no\nrun 99\n"
    pair += "run 1\n"
    table = thermo(lmp(pair, tmp_path))
    rows = [line.split() for line in (tmp_path / "torque").read_text().splitlines()[-2:]]
    torque = {int(row[0]): [float(word) for word in row[1:]] for row in rows}
    limit = 0.01 / 6 * abs(torque[1][3])
    assert torque[2][1] == pytest.approx(-limit, rel=1e-9)
    assert torque[1][1] == pytest.approx(limit, rel=1e-9)
    # With a spin that is held, heat grows by torque times rate.
    assert table["c_sum"][-1] == pytest.approx(limit * 3 * 1e-4, rel=1e-6)


@pytest.mark.parametrize("law", ["law fixed-direction", "law coulomb torsion yes", "law rings"])
def test_energy_goes_where_it_is_booked(tmp_path, law):
    missed = []
    for dt in (1e-5, 5e-6):
        steps = round(0.02 / dt)
        table = thermo(lmp(ROLLS + WALLS + f"thermo {steps // 30}\nrun {steps}\n", tmp_path, dt=dt, law=law, shake=0.3))
        total, gone = table["v_total"], sum(table[f"c_where[{k}]"][-1] for k in (2, 3, 5))
        assert table["c_where[5]"][-1] > 0.01 * gone, "rolling counts"
        assert np.diff(table["c_where[5]"]).min() > -1e-15 * gone
        missed.append(np.abs(total - total[0]).max() / gone)
    print(law, "balance over what became heat, by step:", missed)
    if "rings" in law:
        assert missed[0] < 1e-3 and missed[1] < 0.7 * missed[0]
    else:
        # What joined pieces of a contact's memory give up is in no account, at any step.
        assert missed[0] < 3e-4 and missed[1] < max(0.5 * missed[0], 1e-4)


@pytest.mark.parametrize(
    "law, ranks, newton", [("law fixed-direction", 1, "off"), ("law fixed-direction torsion yes", 2, "on"), ("law rings", 2, "on")]
)
def test_restart_in_the_middle_goes_on_bit_for_bit(tmp_path, law, ranks, newton):
    variables = {"law": law, "newton": newton, "shake": 0.2, "dt": 1e-5}
    wrote = "write_dump all custom dump.{} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n"
    wrote += 'print "sums: $(c_where[1]:%.12g) $(c_where[2]:%.12g) $(c_where[3]:%.12g) $(c_where[5]:%.12g)"\n'
    long = ROLLS + WALLS + "thermo 1000\nrestart 1500 restart.*\nrun 2500\n" + wrote.format("long")
    printed = [lmp(long, tmp_path, ranks=ranks, **variables)]
    again = "newton ${newton}\nplugin load ${plugin}\natom_modify sort 0 0\nread_restart restart.1500\ncomm_modify vel yes\n"
    again += WALLS + "thermo 1000\nrun 1000\n" + wrote.format("again")
    printed.append(lmp(again, tmp_path, ranks=ranks, **variables))
    assert np.array_equal(dump(tmp_path / "dump.long"), dump(tmp_path / "dump.again"))
    sums = [next(line for line in text.split("\n") if line.startswith("sums:")) for text in printed]
    numbers = [np.array([float(word) for word in line.split()[1:]]) for line in sums]
    assert np.allclose(*numbers, rtol=1e-9) and numbers[0][3] > 0


def test_ranks_have_the_same_heat(tmp_path):
    """Grains of one set on one rank and on two, to the round-off that their motion lets grow."""
    made, pairs = ROLLS[: ROLLS.index("pair_style")], ROLLS[ROLLS.index("pair_style") :]
    lmp(made + "write_data grains.data\n", tmp_path)
    read = made[: made.index("region box")].replace("units si\n", "units si\nprocessors * 1 1\n") + "read_data grains.data\n"
    for newton in ("off", "on"):
        heats = []
        for ranks in (1, 2):
            table = thermo(lmp(read + pairs + WALLS + "run 1500\n", tmp_path, ranks=ranks, newton=newton, dt=1e-5, shake=0.3))
            heats.append(table["c_where[5]"][-1])
        assert heats[0] > 0 and heats[1] == pytest.approx(heats[0], rel=1e-9)


def test_rolling_cannot_come_after_the_first_run(tmp_path):
    late = "pair_coeff 2 2 shear 5e6 poisson 0.4 friction 0.6 rolling 1 0 0.1\nrun 1\n"
    with pytest.raises(Failed, match="rolling must be given before the first run"):
        lmp(BOX + WALLS + "run 1\n" + late, tmp_path)
    lmp(BOX + WALLS + "run 700\nwrite_restart some.bin\n", tmp_path, dt=1e-5)
    again = "newton off\nplugin load ${plugin}\nread_restart some.bin\ncomm_modify vel yes\n"
    with pytest.raises(Failed, match="84 numbers, those of this run 93"):
        lmp(again + late, tmp_path)
    lmp(ROLLS + WALLS + "run 1\n" + late, tmp_path)
