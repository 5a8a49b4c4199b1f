"""Walls that are curved, bounded or turn."""

import math
import pathlib

import numpy as np
import pytest
from conftest import Failed, dump, lmp, thermo

HERE = pathlib.Path(__file__).parent


def complete(square):
    """The complete elliptic integrals K and E of a squared modulus, by the arithmetic and geometric mean."""
    a, b, c, power, sum = 1.0, math.sqrt(1 - square), math.sqrt(square), 0.5, 0.5 * square
    for _ in range(12):
        a, b, c, power = 0.5 * (a + b), math.sqrt(a * b), 0.5 * (a - b), 2 * power
        sum += power * c * c
    first = math.pi / (2 * a)
    return first, first * (1 - sum)


def hertz(modulus, force, small, large):
    """The approach of two bodies with the gap small x^2 + large y^2, and the semi-axes a > b of the contact (Johnson,
    Contact mechanics, 4.26): small/p = b (K - E)/(e a)^2 and large/p = b (a^2/b^2 E - K)/(e a)^2 with p = p_0/E*, and
    the approach is p b K."""
    if small == large:
        deep = (0.75 * force / modulus) ** (2 / 3) * (2 * small) ** (1 / 3)
        return deep, *[math.sqrt(deep / (2 * small))] * 2
    low, high = 1e-12, 1 - 1e-12
    for _ in range(200):
        square = 0.5 * (low + high)
        k, e = complete(square)
        low, high = (square, high) if (e / (1 - square) - k) / (k - e) < large / small else (low, square)
    pressure_b = small * square / (k - e)    # p b / a^2
    # force = 2/3 pi a b p_0
    a = (force / (2 / 3 * math.pi * modulus * pressure_b)) ** (1 / 3)
    return pressure_b * a * a * k, a, a * math.sqrt(1 - square)


DENSITY, POISSON, GRAVITY = 1000.0, 0.3, 9.81


def one_ball(radius, young, place, velocity, spin, walls, dt, more="", energy="energy yes", friction=0.5, size=4):
    """One grain; the wall has the material of the grain. Output in each 10 steps."""
    material = f"young {young} poisson {POISSON} friction {friction}"
    walls = "\n".join(f"fix wall{k} all wall/carom {wall} {material}" for k, wall in enumerate(walls, 1))
    vector = lambda values: " ".join(f"{value:.17g}" for value in values)
    return f"""newton off
plugin load ${{plugin}}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -{size} {size} -{size} {size} -{size} {size}
create_box 1 box
create_atoms 1 single {vector(place)}
set group all diameter {2 * radius} density {DENSITY}
velocity all set {vector(velocity)}
set group all omega {vector(spin)}
pair_style carom {energy}
pair_coeff 1 1 {material}
neighbor 0.01 bin
fix move all nve/sphere
{more}
{walls}
compute where all carom/energy
compute motion all ke
compute rotation all erotate/sphere
variable x equal xcm(all,x)
variable y equal xcm(all,y)
variable z equal xcm(all,z)
variable vx equal vcm(all,x)
variable vy equal vcm(all,y)
variable vz equal vcm(all,z)
compute spin all property/atom omegax omegay omegaz
compute w all reduce sum c_spin[*]
timestep {dt:.17g}
thermo_style custom step v_x v_y v_z v_vx v_vy v_vz c_w[1] c_w[2] c_w[3] c_motion c_rotation c_where[1] c_where[2] c_where[4] f_wall1[1] f_wall1[2] f_wall1[3] f_wall1[9] f_wall1[10] f_wall1[11]
thermo_modify norm no format float %.17g
thermo 10
"""


def of(table, names):
    return np.stack([table[name] for name in names], 1)


PLACE, VELOCITY, SPIN = ("v_x", "v_y", "v_z"), ("v_vx", "v_vy", "v_vz"), ("c_w[1]", "c_w[2]", "c_w[3]")
FORCE = ("f_wall1[1]", "f_wall1[2]", "f_wall1[3]")
YOUNG, RADIUS = 1e11, 0.5
MASS = DENSITY * 4 / 3 * math.pi * RADIUS**3
MODULUS = YOUNG / (2 * (1 - POISSON**2))
DOWN = f"fix gravity all gravity {GRAVITY} vector 0 0 -1"


@pytest.mark.parametrize(
    "wall, along",
    [
        ("cylinder 0 7 0 0 1 0 1.5 inside", (1, 0, 0)),
        ("cylinder 3 4 0 3 4 0 1.5 inside", (-0.8, 0.6, 0)),
        ("cylinder 0 0 0 0 -2 0 1.5 both between -1 1", (1, 0, 0)),
        ("sphere 0 0 0 1.5 inside", (0.6, 0.8, 0)),
    ],
)
def test_a_ball_rolls_to_and_fro_at_the_bottom(tmp_path, wall, along):
    """Without slip its period is that of a pendulum of the length 7/5 (R - r), which at an amplitude of 0.3 is longer
    by the elliptic integral."""
    start, path = 0.3, 1.5 - RADIUS
    inverse = 1 / RADIUS - 1 / 1.5
    gaps = (0.5 * inverse, 0.5 * inverse if "sphere" in wall else 0.5 / RADIUS)
    deep = hertz(MODULUS, MASS * GRAVITY * math.cos(start), *gaps)[0]
    along, far = np.array(along), path + deep
    place = far * (math.sin(start) * along - np.array([0, 0, math.cos(start)]))
    script = one_ball(RADIUS, YOUNG, place, (0, 0, 0), (0, 0, 0), [wall], 5e-5, DOWN, friction=100)
    table = thermo(lmp(script + "run 120000\n", tmp_path))
    time, across = table["Step"] * 5e-5, of(table, PLACE) @ along
    at = np.flatnonzero(across[:-1] * across[1:] < 0)
    crossings = time[at] + (time[at + 1] - time[at]) * across[at] / (across[at] - across[at + 1])
    period = 2 * (crossings[-1] - crossings[0]) / (len(crossings) - 1)
    expected = 4 * math.sqrt(7 * path / (5 * GRAVITY)) * complete(math.sin(start / 2) ** 2)[0]
    swing = MASS * GRAVITY * path * (1 - math.cos(start))
    total = table["c_motion"] + table["c_rotation"] + table["c_where[1]"] + MASS * GRAVITY * table["v_z"]
    drift = np.abs(total - total[0]).max() / swing
    print(f"{wall}: period over expected - 1: {period / expected - 1:.1e}, energy off by {drift:.1e}")
    assert period == pytest.approx(expected, rel=1e-4)
    assert drift < 1e-4
    assert table["c_where[2]"][-1] < 1e-4 * swing, "hardly any slip"
    # It stays in its plane, and the pressure is that of a pendulum at the bottom.
    assert np.abs(of(table, PLACE) @ np.cross(along, [0, 0, 1])).max() < 1e-9
    pressed = MASS * GRAVITY * (1 + 10 / 7 * (1 - math.cos(start)))
    assert -table["f_wall1[3]"][np.abs(across) < 2e-3].mean() == pytest.approx(pressed, rel=2e-3)


def test_a_ball_circles_in_a_cylinder_at_its_centrifugal_force(tmp_path):
    """Without friction: the approach to an ellipse of contact is Hertz's at the force m v^2/(R - r + zeta)."""
    radius, drum, speed, young = 0.2, 1.0, 3.0, 1e9
    mass, modulus = DENSITY * 4 / 3 * math.pi * radius**3, young / (2 * (1 - POISSON**2))
    deep = 0.0
    for _ in range(50):
        deep = hertz(modulus, mass * speed**2 / (drum - radius + deep), 0.5 / radius - 0.5 / drum, 0.5 / radius)[0]
    far = drum - radius + deep
    dt = 1e-5
    # The leapfrog begins with a velocity at time 0.
    script = one_ball(radius, young, (far, 0, 0.3), (0, speed, 0), (0, 0, 0), [f"cylinder 0 0 0 0 0 1 {drum} inside"], dt, friction=0)
    table = thermo(lmp(script + f"run {round(2 * math.pi * far / speed / dt)}\n", tmp_path))
    away = np.hypot(table["v_x"], table["v_y"])
    force = np.linalg.norm(of(table, FORCE), axis=1)
    print("approach off by", np.abs(away - far).max() / deep, "force by", np.abs(force * far / (mass * speed**2) - 1).max())
    assert np.abs(away - far).max() < 1e-5 * deep
    assert force == pytest.approx(mass * speed**2 / far, rel=1e-5)
    assert np.abs(table["v_z"] - 0.3).max() < 1e-12
    # Once around, as far as whole steps allow.
    assert table["v_x"][-1] == pytest.approx(far, rel=1e-4)


def test_a_ball_circles_in_a_cone(tmp_path):
    """Without friction, at the height where N sin a = m g and N cos a = m v^2/distance."""
    radius, young, angle, foot = 0.1, 1e9, math.radians(35), 1.5
    mass, modulus = DENSITY * 4 / 3 * math.pi * radius**3, young / (2 * (1 - POISSON**2))
    normal = mass * GRAVITY / math.sin(angle)
    deep = hertz(modulus, normal, 0.5 / radius - 0.5 * math.cos(angle) / foot, 0.5 / radius)[0]
    far = foot - (radius - deep) * math.cos(angle)
    height = foot / math.tan(angle) + (radius - deep) * math.sin(angle) - 2
    speed = math.sqrt(far * GRAVITY / math.tan(angle))
    script = one_ball(radius, young, (far, 0, height), (0, speed, 0), (0, 0, 0), ["cone 0 0 -2 0 0 3 35 inside"], 1e-5, DOWN, friction=0)
    table = thermo(lmp(script + "run 100000\n", tmp_path))
    away = np.hypot(table["v_x"], table["v_y"])
    print("distance off by", np.abs(away / far - 1).max(), "height by", np.abs(table["v_z"] - height).max() / deep, deep)
    assert away == pytest.approx(far, rel=1e-6)
    assert np.abs(table["v_z"] - height).max() < 1e-6
    assert -table["f_wall1[3]"] == pytest.approx(mass * GRAVITY, rel=2e-3)
    assert -table["f_wall1[3]"].mean() == pytest.approx(mass * GRAVITY, rel=1e-5)


@pytest.mark.parametrize("side", ["inside", "outside"])
@pytest.mark.parametrize("along", ["axis", "circumference"])
def test_the_stiffness_of_an_ellipse_is_that_of_its_axes(tmp_path, side, along):
    """In full adhesion the traction is that of a rigid shift, q/sqrt(1 - (x/a)^2 - (y/b)^2), and that of a point load
    gives 4 pi a b G/k = int (1 - nu + nu cos^2) / sqrt(cos^2/a^2 + sin^2/b^2) over all directions, cos along the shift,
    for two bodies of one material (quadrature). Within a drum the ellipse is longer along the circumference."""
    radius, drum, poisson = 0.5, 0.8, POISSON
    sign = -1 if side == "inside" else 1
    across, force = 0.5 / radius + sign * 0.5 / drum, 5000.0
    deep, long, short = hertz(MODULUS, force, *sorted((across, 0.5 / radius)))
    of_axis, of_way = (short, long) if side == "inside" else (long, short)
    a, b = (of_axis, of_way) if along == "axis" else (of_way, of_axis)
    turn = (np.arange(400) + 0.5) * (2 * math.pi / 400)
    kernel = (1 - poisson + poisson * np.cos(turn) ** 2) / np.sqrt((np.cos(turn) / a) ** 2 + (np.sin(turn) / b) ** 2)
    stiffness = 4 * math.pi * a * b * YOUNG / (2 * (1 + poisson)) / (kernel.mean() * 2 * math.pi)
    height = -(drum - radius + deep) if side == "inside" else drum + radius - deep
    shift, dt = 1e-3 * deep, 1e-6
    velocity = np.array([0, 1, 0] if along == "axis" else [1, 0, 0]) * shift / (10 * dt)
    wall = f"cylinder 0 0 0 0 1 0 {drum} {side}"
    script = one_ball(radius, YOUNG, (0, 0, height), velocity, (0, 0, 0), [wall], dt, friction=100)
    table = thermo(lmp(script.replace("fix move all nve/sphere\n", "") + "run 10\n", tmp_path))
    assert abs(table["f_wall1[3]"][-1]) == pytest.approx(force, rel=1e-6)
    pulled = table["f_wall1[2]" if along == "axis" else "f_wall1[1]"][-1]
    assert pulled == pytest.approx(stiffness * shift, rel=1e-4)


FAR = 1e5
FLAT = {
    "cylinder inside": f"cylinder 0 0 {FAR} 1 2 0 {FAR} inside",
    "cylinder outside": f"cylinder 0 0 -{FAR} 1 2 0 {FAR} outside",
    "sphere inside": f"sphere 0 0 {FAR} {FAR} inside",
    "sphere outside": f"sphere 0 0 -{FAR} {FAR} outside",
}


def impact(tmp_path, wall, turn=np.eye(3), spin=(0.3, 0.5, 0), drift=(0, 0, 0)):
    """Velocity and spin after an oblique impact, by the axes of the wall and in a frame that drifts."""
    vector = lambda values: turn @ np.array(values, dtype=float)
    script = one_ball(0.5, 1e7, vector((0, 0, 0.5001)), vector((0.3, 0.1, -1)) + drift, vector(spin), [wall], 1e-4, friction=0.3)
    table = thermo(lmp(script + "run 2000\n", tmp_path))
    assert table["c_where[1]"].max() > 0 and table["c_where[1]"][-1] == 0
    return np.concatenate([(of(table, VELOCITY)[-1] - drift) @ turn, of(table, SPIN)[-1] @ turn])


@pytest.mark.parametrize("shape", FLAT)
def test_a_wall_of_large_radius_is_a_plane(tmp_path, shape):
    plane = impact(tmp_path, "plane 0 0 0 0 0 1")
    curved = impact(tmp_path, FLAT[shape])
    print(shape, np.abs(curved - plane).max())
    assert np.abs(curved - plane).max() < 1e-4 * np.abs(plane).max()
    assert np.abs(impact(tmp_path, FLAT[shape].replace(str(FAR), "3")) - plane).max() > 1e-3


@pytest.mark.parametrize("shape", ["plane 0 0 0 0 0 1", "cylinder 0 0 3 1 2 0 3 inside", "sphere 0 0 -3 3 outside"])
def test_a_wall_that_moves_and_turns_is_that_of_galileo(tmp_path, shape):
    turning = shape + " omega 0.3 -0.2 1 center 0.3 -0.2 0"
    still = impact(tmp_path, turning)
    moved = impact(tmp_path, turning + " velocity 2 -1 0.5", drift=np.array([2, -1, 0.5]))
    assert np.abs(still - impact(tmp_path, shape)).max() > 0.01
    assert np.abs(moved - still).max() < 1e-9


@pytest.mark.parametrize("side", ["inside", "outside"])
def test_a_cone_far_from_its_apex_is_a_plane(tmp_path, side):
    """Its generator lies in the plane, whose normal is the axis x + z of the script."""
    turn = np.array([[1, 0, 1], [0, math.sqrt(2), 0], [-1, 0, 1]]) / math.sqrt(2)
    far = FAR / math.sqrt(2)
    apex = (far, -far) if side == "inside" else (-far, far)
    along = "0 0 1" if side == "inside" else "0 0 -1"
    cone = impact(tmp_path, f"cone {apex[0]} 0 {apex[1]} {along} 45 {side}", turn)
    plane = impact(tmp_path, "plane 0 0 0 1 0 1", turn)
    print(side, np.abs(cone - plane).max())
    assert np.abs(cone - plane).max() < 1e-4 * np.abs(plane).max()


def test_a_ball_rolls_in_place_in_a_turning_drum(tmp_path):
    """With the spin of the drum's speed nothing slips, and the drum does no work."""
    rate, drum = 2.0, 1.5
    deep = hertz(MODULUS, MASS * GRAVITY, 0.5 / RADIUS - 0.5 / drum, 0.5 / RADIUS)[0]
    spin = rate * (drum + 0.5 * deep) / (RADIUS - 0.5 * deep)
    wall = f"cylinder 0 0 0 0 1 0 {drum} inside omega 0 {rate} 0"
    script = one_ball(RADIUS, YOUNG, (0, 0, -(drum - RADIUS + deep)), (0, 0, 0), (0, spin, 0), [wall], 5e-5, DOWN)
    table = thermo(lmp(script + "run 20000\n", tmp_path))
    print("off", np.abs(table["v_x"]).max(), np.abs(table["c_w[2]"] / spin - 1).max(), table["c_where[4]"][-1])
    assert np.abs(table["v_x"]).max() < 1e-7
    assert table["c_w[2]"] == pytest.approx(spin, rel=1e-7)
    assert abs(table["c_where[4]"][-1]) < 1e-6 * MASS * GRAVITY
    # With no spin it is taken along, up the side that goes up: at the bottom the drum moves towards -x.
    script = one_ball(RADIUS, YOUNG, (0, 0, -(drum - RADIUS + deep)), (0, 0, 0), (0, 0, 0), [wall], 5e-5, DOWN)
    table = thermo(lmp(script + "run 4000\n", tmp_path))
    assert table["v_x"][-1] < -1e-3 and table["c_where[4]"][-1] > 0 and table["f_wall1[10]"][10] < 0


def test_a_ball_that_is_held_turns_with_its_walls(tmp_path):
    """Between two planes that turn about an axis: after a whole turn it is where it was, with its load on both walls
    turned along; they do no work."""
    rate = np.array([1.2, -0.5, 0.9])
    period = 2 * math.pi / np.linalg.norm(rate)
    center, place = np.array([0.1, 0.2, 0.0]), np.array([0.05, -0.1, 0.0])
    moving = f"omega {rate[0]} {rate[1]} {rate[2]} center {center[0]} {center[1]} {center[2]}"
    walls = [f"plane 0 0 {sign * 0.4999} 0 0 {-sign} {moving}" for sign in (-1, 1)]
    steps = 20000
    velocity = np.cross(rate, place - center)
    script = one_ball(0.5, 1e10, place, velocity, rate, walls, period / steps, energy="energy yes torsion yes")
    table = thermo(lmp(script + f"run {steps}\n", tmp_path))
    places, spins = of(table, PLACE), of(table, SPIN)
    print("off", np.abs(places[-1] - place).max(), np.abs(spins[-1] - rate).max())
    assert np.abs(places[:, 0] - place[0]).max() > 0.05, "it moved"
    # The walls give way by some m w^2 r/k, where k is 1.5 times load over approach: 400 N over 8e7 N/m.
    assert np.abs(places[-1] - place).max() < 1e-5
    assert np.abs(spins[-1] - rate).max() < 1e-3
    assert np.abs(table["c_where[4]"]).max() < 1e-2 * table["c_motion"][0]


BOX = (HERE / "box.in").read_text()
WALLS = (HERE / "box_walls.in").read_text()
WALL = "young 1e8 poisson 0.2 friction 0.5 damping 1e-4 rolling 2000 0.3 0.05"
SHAPES = {
    "drum": ["cylinder 0 0 0.022 0 1 0 0.03 inside omega 0 30 0", "plane 0 -0.02 0.022 0 1 0 omega 0 30 0", "plane 0 0.02 0 0 -1 0"],
    "hopper": ["cone 0 0 -0.02 0 0 1 40 both between 0.02 0.06 omega 1 2 10 center 0 0 0", "cylinder 0 0 0 0 0 1 0.035 inside", "plane 0 0 -0.004 0 0 1"],
    "bowl": ["sphere 0 0 0.03 0.034 inside velocity 0.1 0 0.2 omega 5 -10 7", "sphere 0 0 0.003 0.006 outside omega 0 100 0"],
    "tilting": ["cylinder 0 0 0.022 1 0 0 0.03 inside omega 0 3 8 center 0 0 0.022", "plane -0.02 0 0.02 1 0 0", "plane 0.02 0 0.02 -1 0 0 omega 0 10 0"],
}


def walled(shape):
    lines = [line for line in WALLS.split("\n") if "wall/carom" not in line]
    at = next(k for k, line in enumerate(lines) if line.startswith("timestep"))
    lines[at:at] = [f"fix wall{k} all wall/carom {wall} {WALL}" for k, wall in enumerate(SHAPES[shape], 1)]
    text = "\n".join(lines).replace("c_where[3]-c_where[4]", "c_where[3]+c_where[5]-c_where[4]")
    return text.replace("v_total f_floor[1] f_floor[3]", "v_total c_where[5] f_wall1[1] f_wall1[9]")


def smaller():
    """The grains of the box, as they fit."""
    return BOX.replace("-0.018 0.018 -0.018 0.018 0.006 0.04", "-0.012 0.012 -0.012 0.012 0.014 0.034").replace("-0.02 0.02 -0.02 0.02 -0.005 0.08", "-0.06 0.06 -0.06 0.06 -0.06 0.1")


@pytest.mark.parametrize("shape", SHAPES)
def test_energy_goes_where_it_is_booked(tmp_path, shape):
    """Grains of two materials between walls that turn and move."""
    missed = []
    for dt in (1e-5, 5e-6):
        steps = round(0.03 / dt)
        table = thermo(lmp(smaller() + walled(shape) + f"thermo {steps // 30}\nrun {steps}\n", tmp_path, dt=dt))
        total, gone = table["v_total"], sum(table[f"c_where[{k}]"][-1] for k in (2, 3, 5))
        assert abs(table["c_where[4]"][-1]) > 0.01 * gone, "the walls do work"
        assert np.abs(table["f_wall1[9]"]).max() > 0
        missed.append(np.abs(total - total[0]).max() / gone)
    print(shape, "balance over what became heat, by step:", missed, "work", table["c_where[4]"][-1], "heat", gone)
    assert missed[0] < 3e-4
    # What joined pieces of a contact's memory give up is in no account, at any step.
    assert missed[1] < max(0.6 * missed[0], 3e-5)


@pytest.mark.parametrize("shape, ranks", [("drum", 1), ("drum", 2), ("hopper", 2), ("bowl", 2), ("tilting", 1)])
def test_restart_in_the_middle_goes_on_bit_for_bit(tmp_path, shape, ranks):
    wrote = "write_dump all custom dump.{} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n"
    wrote += 'print "sums: $(c_where[1]:%.12g) $(c_where[2]:%.12g) $(c_where[3]:%.12g) $(c_where[4]:%.12g) $(c_where[5]:%.12g)"\n'
    variables = {"newton": "on", "dt": 1e-5}
    long = smaller() + walled(shape) + "thermo 1000\nrestart 1500 restart.*\nrun 2500\n" + wrote.format("long")
    printed = [lmp(long, tmp_path, ranks=ranks, **variables)]
    again = "newton ${newton}\nplugin load ${plugin}\natom_modify sort 0 0\nread_restart restart.1500\ncomm_modify vel yes\n"
    again += "variable shake index 0\n" + walled(shape) + "thermo 1000\nrun 1000\n" + wrote.format("again")
    printed.append(lmp(again, tmp_path, ranks=ranks, **variables))
    assert np.array_equal(dump(tmp_path / "dump.long"), dump(tmp_path / "dump.again"))
    sums = [next(line for line in text.split("\n") if line.startswith("sums:")) for text in printed]
    numbers = [np.array([float(word) for word in line.split()[1:]]) for line in sums]
    assert np.allclose(*numbers, rtol=1e-9) and numbers[0][1:].all(), numbers


def test_a_ball_on_a_rim_keeps_its_energy(tmp_path):
    """It falls beside the upper rim of a tube and leaves it to the other side."""
    wall = "cylinder 0 0 0 0 0 1 1 both between -1 0"
    script = one_ball(0.3, 1e8, (1.05, 0, 0.31), (-0.1, 0, -0.5), (0, 0, 0), [wall], 2e-5, DOWN, friction=0)
    table = thermo(lmp(script + "run 8000\n", tmp_path))
    mass = DENSITY * 4 / 3 * math.pi * 0.3**3
    total = table["c_motion"] + table["c_rotation"] + table["c_where[1]"] + mass * GRAVITY * table["v_z"]
    assert table["c_where[1]"].max() > 0.01 * table["c_motion"][0], "it touched"
    assert np.abs(total - total[0]).max() < 1e-4 * table["c_motion"][0]
    assert table["v_vx"][-1] > 0.05, "pushed outwards, since it came from outside of the rim"


@pytest.mark.parametrize(
    "wall, away",
    [("cylinder 0 0 0 0 0 1 1 inside", 1.4), ("cylinder 0 0 0 0 0 1 1 outside", 0.6), ("cone 0 0 0 0 0 1 45 inside", 1)],
)
def test_a_ball_behind_a_wall_that_ends_does_not_feel_it(tmp_path, wall, away):
    script = one_ball(0.3, 1e7, (away, 0, 0.5), (0, 0, 0), (0, 0, 0), [wall + " between 0 1"], 1e-4)
    assert not of(thermo(lmp(script + "run 10\n", tmp_path)), FORCE).any()


def test_what_a_contact_stored_becomes_heat_where_its_ball_is_taken_through_the_wall(tmp_path):
    wall = "cylinder 0 0 0 0 0 1 1 inside between 0 1"
    script = one_ball(0.3, 1e7, (0.95, 0, 0.5), (1, 0, 0), (0, 0, 0), [wall], 1e-4, friction=0)
    table = thermo(lmp(script.replace("nve/sphere", "nve/noforce") + "thermo 1\nrun 600\n", tmp_path))
    stored, heat = table["c_where[1]"], table["c_where[2]"]
    last = np.flatnonzero(stored)[-1]
    assert table["v_x"][last] < 1 < table["v_x"][last + 2] and not heat[: last + 1].any()
    assert heat[last + 1 :] == pytest.approx(stored[last], rel=1e-9)


@pytest.mark.parametrize(
    "wall, words",
    [
        ("cylinder 0 0 0 0 0 1 -1 inside", ["radius of the cylinder = -1", "finite and > 0"]),
        ("cylinder 0 0 0 0 0 0 1 inside", ["the direction of the axis is zero"]),
        ("cylinder 0 0 0 0 0 1 1 within", ["inside, outside or both, not 'within'"]),
        ("sphere 0 0 0 0 inside", ["radius of the sphere = 0", "finite and > 0"]),
        ("cone 0 0 0 0 0 1 90 inside", ["angle of the cone = 90", "(0, 90) degrees"]),
        ("cone 0 0 0 0 0 1 30 inside between -1 1", ["first value of between = -1", "0 or more"]),
        ("cylinder 0 0 0 0 0 1 1 inside between 1 1", ["second value of between = 1", "above the first"]),
        ("sphere 0 0 0 1 inside between 0 1", ["between is for cylinder and cone only"]),
        ("plane 0 0 0 0 0 1 sphere 0 0 0 1 inside", ["more than one of plane"]),
        ("omega 0 0 1", ["plane, cylinder, cone, sphere or stl is missing"]),
        ("cylinder 0 0 0 0 0 1 1", ["after the radius or the angle comes the side of the grains"]),
        ("cylinder 0 0 0 0 0 1", ["cylinder requires seven numbers and a side", "is no number"]),
    ],
)
def test_what_is_wrong_is_named(tmp_path, wall, words):
    with pytest.raises(Failed) as failed:
        lmp(one_ball(0.5, 1e7, (0, 0, 0), (0, 0, 0), (0, 0, 0), [wall], 1e-4), tmp_path)
    for word in words:
        assert word in str(failed.value), str(failed.value)[-500:]


@pytest.mark.parametrize(
    "wall, more, words",
    [
        ("cylinder 0 0 -0.4 1 0 0 0.4 inside", "", ["a grain of radius 0.5 does not fit", "above -1 over the radius"]),
        ("cylinder 0 0 0 0 0 1 0.6 inside law rings", "", ["law rings needs a plane, a sphere or an STL file without edges"]),
        ("cylinder 0 0 0 1 0 0 0.6 inside", "change_box all boundary f p f", ["periodic along y", "the wall ends or is curved"]),
        ("plane 0 0 0 0 0 1 omega 0 0 1", "change_box all boundary p f f", ["periodic along x", "omega turns the wall away"]),
        ("cylinder 0 0 0 1 0 0 0.6 inside omega 1 0 0", "change_box all boundary p f f", []),
        ("cylinder 0 0 0 1 0 0 0.6 inside between -1 1", "change_box all boundary p f f", ["periodic along x", "bounded there"]),
    ],
)
def test_what_does_not_fit_is_named(tmp_path, wall, more, words):
    script = one_ball(0.5, 1e7, (0, 0, 0), (0, 0, 0), (0, 0, 0), [wall], 1e-4, more) + "run 1\n"
    if not words:
        lmp(script, tmp_path)
        return
    with pytest.raises(Failed) as failed:
        lmp(script, tmp_path)
    for word in words:
        assert word in str(failed.value), str(failed.value)[-500:]
