"""Static friction above kinetic friction, and friction by the slip speed of the first touch."""

import math
import pathlib
import re

import numpy as np
import pytest
from conftest import Failed, dump, lmp, thermo
from test_impact import DENSITY, FRICTION, YOUNG as YOUNG_OF_GRAINS, restitution

HERE = pathlib.Path(__file__).parent
BOX = (HERE / "box.in").read_text()
WALLS = (HERE / "box_walls.in").read_text()
LAWS = ["law fixed-direction", "law coulomb"]
F_S, F_K = 0.5, 0.3
BOTH = f"friction {F_K} static_friction {F_S}"
BY_SPEED = [0.1, 0.4, 2.0]
SLIP = "slip_friction 0.1 0.4 2"


def coefficient(speed, by=BY_SPEED):
    a, b, c = by
    return a + b * math.exp(-c * speed)


def with_all(text, more):
    """A script whose coefficients of friction are replaced."""
    return re.sub(r"friction (0\.\d)", more, text)


GRIPS = with_all(BOX, lambda found: f"friction {found[1]} static_friction {1.5 * float(found[1]):g}")
WALLS_GRIP = with_all(WALLS, lambda found: f"friction {found[1]} static_friction {1.5 * float(found[1]):g}")
SLIPS = with_all(BOX, lambda found: f"slip_friction {found[1]} 0.3 5")
WALLS_SLIP = with_all(WALLS, lambda found: f"slip_friction {found[1]} 0.3 5")
# Without heats, the coefficient of a contact is its last number.
SLIPS_UNBOOKED = SLIPS.replace(" energy yes", "")
WALLS_UNBOOKED = "".join(line for line in WALLS_SLIP.splitlines(True) if "c_where" not in line and "carom/energy" not in line)
assert (GRIPS + WALLS_GRIP).count("static_friction") == 5 and (SLIPS + WALLS_SLIP).count("slip_friction") == 5

RADIUS, MASS, YOUNG, GRAVITY = 0.5, 1000 * math.pi / 6, 1e10, 9.81
MODULUS = YOUNG / (2 * (1 - 0.3**2))
DEEP = (MASS * GRAVITY / (4 / 3 * MODULUS * RADIUS**0.5)) ** (2 / 3)
SPACE = """newton off
plugin load ${plugin}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -2 2 -2 2 -2 2
create_box 1 box
"""


def on_a_floor(friction, law, speed=1e-3, shape="plane 0 0 0 0 0 1"):
    """A ball is held at rest in a floor that moves along x."""
    script = SPACE + f"create_atoms 1 single 0 0 {RADIUS - DEEP:.17g}\nset group all diameter 1 density 1000\n"
    script += f"pair_style carom {law} energy yes\npair_coeff 1 1 young {YOUNG} poisson 0.3 friction 0.2\n"
    wall = f"fix floor all wall/carom {shape} young {YOUNG} poisson 0.3 {friction} velocity "
    script += wall + f"{speed} 0 0\n"
    script += "thermo_style custom step f_floor[1] f_floor[2] f_floor[3] f_floor[4] f_floor[5] f_floor[7]\n"
    script += f"thermo_modify norm no format float %.17g\nthermo 1\ntimestep {0.02 * DEEP / speed:.17g}\nrun 150\n"
    return script


@pytest.mark.parametrize("law", LAWS)
def test_a_ball_on_a_moving_floor(tmp_path, law):
    table = thermo(lmp(on_a_floor(BOTH, law), tmp_path))
    share = np.hypot(table["f_floor[1]"], table["f_floor[2]"]) / -table["f_floor[3]"]
    most = int(share.argmax())
    print(law, "at most", share[most], "at last", share[-1])
    assert 0.97 * F_S < share[most] < F_S * (1 + 1e-9)
    assert np.all(np.abs(share[most + 1 :] / F_K - 1) < 1e-6) and len(share) - most > 30
    assert np.all(np.diff(share[: most + 1]) > 0)
    # What the floor did is stored or heat; the drop is heat at once.
    stored, heat, work = (table[f"f_floor[{k}]"] for k in (4, 5, 7))
    missed = np.abs(stored - stored[0] + heat - work)
    print("balance over heat:", missed.max() / heat[-1])
    assert missed[most] < 1e-3 * heat[-1] and missed[-1] < 0.03 * heat[-1]
    normal = -table["f_floor[3]"][0]
    kappa = (2 - 0.3) / (2 * (1 - 0.3))
    drop = 0.4 * (F_S**2 - F_K**2) * kappa * normal * DEEP
    slid = F_K * normal * 0.02 * DEEP
    assert heat[most + 1] - heat[most] == pytest.approx(drop, abs=2 * slid)


@pytest.mark.parametrize("law", LAWS)
def test_a_curved_floor_has_both(tmp_path, law):
    """In a trough that moves along its axis, where constants are those of the curvature."""
    trough = "cylinder 0 0 8 1 0 0 8 inside"
    table = thermo(lmp(on_a_floor(BOTH, law, shape=trough), tmp_path))
    share = np.hypot(table["f_floor[1]"], table["f_floor[2]"]) / -table["f_floor[3]"]
    assert 0.96 * F_S < share.max() < F_S * (1 + 1e-9) and share[-1] == pytest.approx(F_K, rel=1e-6)
    table = thermo(lmp(on_a_floor(SLIP, law, 0.5, trough), tmp_path))
    share = np.hypot(table["f_floor[1]"], table["f_floor[2]"]) / -table["f_floor[3]"]
    assert share.max() == pytest.approx(coefficient(0.5), rel=1e-6)


@pytest.mark.parametrize("law", LAWS)
def test_equal_coefficients_are_one(tmp_path, law):
    columns = []
    for friction in (f"friction {F_K}", f"friction {F_K} static_friction {F_K}", f"slip_friction {F_K} 0 3"):
        columns.append(thermo(lmp(on_a_floor(friction, law), tmp_path)))
    for other in columns[1:]:
        assert all(np.array_equal(columns[0][name], other[name]) for name in other)


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("speed", [1e-3, 0.5, 4.0])
def test_friction_is_that_of_the_first_slip_speed(tmp_path, law, speed):
    """The floor goes on with another speed: the contact keeps its coefficient, also in a restart."""
    script = on_a_floor(SLIP, law, speed)
    table = thermo(lmp(script + "write_restart slid.bin\n", tmp_path))
    share = np.hypot(table["f_floor[1]"], table["f_floor[2]"]) / -table["f_floor[3]"]
    assert share[-1] == pytest.approx(coefficient(speed), rel=1e-6)
    again = "newton off\nplugin load ${plugin}\nread_restart slid.bin\ncomm_modify vel yes\n"
    again += script[script.index("fix floor") :].replace(f"velocity {speed}", f"velocity {3 * speed}")
    table = thermo(lmp(again, tmp_path))
    share = np.hypot(table["f_floor[1]"], table["f_floor[2]"]) / -table["f_floor[3]"]
    assert np.all(np.abs(share / coefficient(speed) - 1) < 1e-6)
    with pytest.raises(Failed, match="slip_friction must be as in the run that wrote the restart file"):
        lmp(again.replace(SLIP, "friction 0.3"), tmp_path)


@pytest.mark.parametrize("law", LAWS)
def test_impacts_of_grains_have_the_friction_of_their_slip_speed(host, law):
    """R_x of two grains is that of the constant coefficient of their slip speed, and the normal motion is the same."""
    lambdas, steps, nu, radius = [1.0, 4.0, 9.0], 100, 0.3, 0.5
    mass, modulus, deepest = DENSITY * 2 / 3 * math.pi * radius**3, YOUNG_OF_GRAINS / (2 * (1 - nu**2)), 0.6e-5 * radius
    approach = math.sqrt(16 * math.sqrt(radius / 2) * modulus * deepest**2.5 / (15 * mass))
    by = [0.05, 0.2, 3 / approach]
    body = f"pair_style carom {law}\npair_coeff * * young {YOUNG_OF_GRAINS} poisson {nu} "
    found = restitution(host, [*(body + "slip_friction {:.17g} {:.17g} {:.17g}".format(*by)).split("\n")], nu, lambdas, steps)
    for k, ratio in enumerate(lambdas):
        f = coefficient(ratio * FRICTION * approach, by)
        host.command("clear")
        same = restitution(host, (body + f"friction {f:.17g}").split("\n"), nu, lambdas, steps)
        print(law, "slip over approach", ratio * FRICTION, "f", f, "R_x", found[0][k], same[0][k])
        # The slip speed is that at the end of the step of the first touch, until which the normal turns a little.
        assert found[0][k] == pytest.approx(same[0][k], abs=1e-7)
        assert found[1][k] == pytest.approx(same[1][k], abs=1e-12)
        assert all(abs(found[0][other] - same[0][other]) > 1e-3 for other in range(3) if other != k)


@pytest.mark.parametrize("law", LAWS)
def test_stick_and_slip_of_a_ball_on_a_spring(tmp_path, law):
    """A floor carries a ball against a spring: it holds until the spring has f_s m g, and slides back with f_k m g."""
    script = SPACE + f"create_atoms 1 single 0 0 {RADIUS - DEEP:.17g}\nset group all diameter 1 density 1000\n"
    script += "velocity all set 0.05 0 0\n"
    script += f"pair_style carom {law} energy yes\npair_coeff 1 1 young {YOUNG} poisson 0.3 friction 0.2\n"
    script += f"""neighbor 0.01 bin
fix move all nve
fix gravity all gravity {GRAVITY} vector 0 0 -1
fix hold all spring tether 2e5 0 NULL NULL 0
fix floor all wall/carom plane 0 0 0 0 0 1 young {YOUNG} poisson 0.3 {BOTH} velocity 0.05 0 0
compute where all carom/energy
compute motion all ke
variable x equal xcm(all,x)
variable total equal c_motion+f_gravity+f_hold+c_where[1]+c_where[2]+c_where[3]-f_floor[7]
timestep 2e-5
thermo_style custom step v_x c_motion c_where[1] c_where[2] f_floor[1] f_floor[3] v_total
thermo_modify norm no format float %.17g
thermo 10
run 40000
"""
    table = thermo(lmp(script, tmp_path))
    spring, weight = 2e5 * table["v_x"], MASS * GRAVITY
    share = table["f_floor[1]"] / table["f_floor[3]"]
    share = np.abs(share)
    slides = np.abs(share / F_K - 1) < 1e-6
    drops = np.count_nonzero(np.diff(slides.astype(int)) == 1)
    print(law, "spring at most over f_s m g:", spring.max() / (F_S * weight), "drops:", drops)
    assert share.max() < F_S * (1 + 1e-9) and share.max() > 0.95 * F_S
    # The ball leaves the floor with its speed, and swings about the place where the spring has f_k m g.
    swing = math.hypot((F_S - F_K) * weight, 0.05 * math.sqrt(2e5 * MASS))
    print("spring at most over that of the swing:", spring.max() / (F_K * weight + swing))
    assert spring.max() == pytest.approx(F_K * weight + swing, rel=0.02)
    assert spring[spring.argmax() :].min() == pytest.approx(F_K * weight - swing, abs=0.05 * F_S * weight)
    assert drops >= 2 and slides.sum() > 50
    heat = table["c_where[2]"]
    missed = np.abs(table["v_total"] - table["v_total"][0]).max()
    print("balance over heat:", missed / heat[-1])
    assert np.all(np.diff(heat) >= 0) and missed < 2e-3 * heat[-1]


@pytest.mark.parametrize("law", LAWS)
@pytest.mark.parametrize("grains, walls", [(GRIPS, WALLS_GRIP), (SLIPS, WALLS_SLIP)])
def test_energy_goes_where_it_is_booked(tmp_path, law, grains, walls):
    missed = []
    for dt in (1e-5, 5e-6):
        steps = round(0.02 / dt)
        table = thermo(lmp(grains + walls + f"thermo {steps // 30}\nrun {steps}\n", tmp_path, dt=dt, law=law, shake=0.3))
        total, gone = table["v_total"], table["c_where[2]"][-1] + table["c_where[3]"][-1]
        missed.append(np.abs(total - total[0]).max() / gone)
    print(law, "balance over what became heat, by step:", missed)
    assert missed[0] < 5e-3 and missed[1] < missed[0]


@pytest.mark.parametrize(
    "grains, walls", [(GRIPS, WALLS_GRIP), (SLIPS, WALLS_SLIP), (SLIPS_UNBOOKED, WALLS_UNBOOKED)]
)
@pytest.mark.parametrize("law, ranks, newton", [("law fixed-direction", 1, "off"), ("law coulomb", 2, "on")])
def test_restart_in_the_middle_goes_on_bit_for_bit(tmp_path, grains, walls, law, ranks, newton):
    variables = {"law": law, "newton": newton, "shake": 0.2}
    wrote = "write_dump all custom dump.{} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n"
    lmp(grains + walls + "thermo 1000\nrestart 1500 restart.*\nrun 2500\n" + wrote.format("long"), tmp_path, ranks=ranks, **variables)
    again = "newton ${newton}\nplugin load ${plugin}\natom_modify sort 0 0\nread_restart restart.1500\ncomm_modify vel yes\n"
    again += walls + "thermo 1000\nrun 1000\n" + wrote.format("again")
    lmp(again, tmp_path, ranks=ranks, dt=5e-6, **variables)
    assert np.array_equal(dump(tmp_path / "dump.long"), dump(tmp_path / "dump.again"))
    if ranks > 1:
        return
    # It is another motion than that of one coefficient.
    lmp(BOX + WALLS + "thermo 1000\nrun 2500\n" + wrote.format("plain"), tmp_path, ranks=ranks, **variables)
    assert not np.allclose(dump(tmp_path / "dump.plain"), dump(tmp_path / "dump.long"), rtol=1e-3)


@pytest.mark.parametrize("grains, walls", [(GRIPS, WALLS_GRIP), (SLIPS, WALLS_SLIP)])
def test_ranks_have_the_same_heat(tmp_path, grains, walls):
    """Grains of one set on one rank and on two, to the round-off that their motion lets grow."""
    made, pairs = grains[: grains.index("pair_style")], grains[grains.index("pair_style") :]
    lmp(made + "write_data grains.data\n", tmp_path)
    read = made[: made.index("region box")].replace("units si\n", "units si\nprocessors * 1 1\n") + "read_data grains.data\n"
    heats = []
    for ranks, newton in ((1, "off"), (2, "off"), (2, "on")):
        table = thermo(lmp(read + pairs + walls + "run 1500\n", tmp_path, ranks=ranks, newton=newton, dt=1e-5, shake=0.3))
        heats.append(table["c_where[2]"][-1])
    assert heats[0] > 0 and heats[1:] == pytest.approx([heats[0]] * 2, rel=1e-8)


def test_slip_friction_cannot_come_after_the_first_run(tmp_path):
    late = f"pair_coeff 2 2 shear 5e6 poisson 0.4 {SLIP}\nrun 1\n"
    with pytest.raises(Failed, match="slip_friction must be given before the first run"):
        lmp(BOX + WALLS + "run 1\n" + late, tmp_path)
    lmp(BOX + WALLS + "run 700\nwrite_restart some.bin\n", tmp_path, dt=1e-5)
    again = "newton off\nplugin load ${plugin}\nread_restart some.bin\ncomm_modify vel yes\n"
    with pytest.raises(Failed, match="84 numbers, those of this run 85"):
        lmp(again + late, tmp_path)
    lmp(SLIPS + WALLS + "run 1\n" + late, tmp_path)


WALL = "fix floor all wall/carom plane 0 0 0 0 0 1 rigid"
GLASS = "young 7e10 poisson 0.22"


@pytest.mark.parametrize(
    "commands, told",
    [
        (f"pair_coeff 1 1 {GLASS} friction 0.3 static_friction 0.2", ["static_friction = 0.2", "at least friction"]),
        (f"pair_coeff 1 1 {GLASS} static_friction -1 friction 0.3", ["static_friction = -1", "at least friction"]),
        (f"pair_coeff 1 1 {GLASS} static_friction inf friction 0.3", ["static_friction"]),
        (f"pair_coeff 1 1 {GLASS} static_friction 0.3", ["friction is missing"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3 static_friction", ["static_friction requires a value"]),
        (f"pair_coeff 1 1 {GLASS} slip_friction 0.1 0.2", ["slip_friction requires three values"]),
        (f"pair_coeff 1 1 {GLASS} slip_friction -0.1 0.2 1", ["slip_friction: a = -0.1", "finite and >= 0"]),
        (f"pair_coeff 1 1 {GLASS} slip_friction 0.1 -0.2 1", ["slip_friction: b = -0.2", "a + b >= 0"]),
        (f"pair_coeff 1 1 {GLASS} slip_friction 0.1 0.2 -1", ["slip_friction: c = -1", "finite and >= 0"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.1 slip_friction 0.1 0.2 1", ["friction and slip_friction are both given"]),
        (f"pair_coeff 1 1 {GLASS} static_friction 0.4 slip_friction 0.1 0.2 1", ["static_friction and slip_friction are both given"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3\n{WALL} friction 0.3 static_friction 0.2", ["fix floor wall/carom", "static_friction = 0.2"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3\n{WALL} slip_friction 0.3 0 -2", ["fix floor wall/carom", "slip_friction: c = -2"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3\n{WALL} {BOTH} law rings\nrun 0", ["static_friction needs law fixed-direction or coulomb"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3\n{WALL} {SLIP} law rings\nrun 0", ["slip_friction needs law fixed-direction or coulomb"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3\n{WALL} {BOTH} torsion yes\nrun 0", ["static_friction needs torsion no"]),
        (f"pair_coeff 1 1 {GLASS} friction 0.3\n{WALL} {SLIP} torsion yes\nrun 0", ["slip_friction needs torsion no"]),
    ],
)
def test_wrong_frictions_are_named(host, commands, told):
    host.commands_string(SPACE.replace("plugin load ${plugin}\n", ""))
    host.commands_string("create_atoms 1 single 0 0 0.6\nset group all diameter 1 density 1000\npair_style carom\n")
    with pytest.raises(Exception) as failed:
        host.commands_string(commands)
    for words in told:
        assert words in str(failed.value)
