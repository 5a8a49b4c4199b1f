"""Walls of triangles in boxes that are periodic: the surface repeats itself."""

import math
import re

import numpy as np
import pytest
from conftest import dump, lmp, thermo
from meshes import binary, box, sheet, text, tube, write
from test_meshes import GRAINS, WRITE, walled
from test_shapes import DOWN, FORCE, GRAVITY, MASS, MODULUS, PLACE, RADIUS, SPIN, VELOCITY, YOUNG, hertz, of, one_ball

ALL = (*PLACE, *VELOCITY, *SPIN, *FORCE, "c_where[1]", "c_where[2]")


def boxed(script, boundary, low, high):
    """The same script in a box with these boundaries and ends."""
    ends = " ".join(f"{number:.17g}" for pair in zip(low, high) for number in pair)
    script = script.replace("boundary f f f\n", f"boundary {boundary}\n")
    return re.sub(r"region box block .*", f"region box block {ends}", script)


def run(tmp_path, script, boundary, low, high, steps):
    table = thermo(lmp(boxed(script, boundary, low, high) + f"run {steps}\n", tmp_path))
    # The centre stays near the box.
    pressed = np.linalg.norm(of(table, FORCE), axis=1)
    torque = np.linalg.norm(of(table, ("f_wall1[9]", "f_wall1[10]", "f_wall1[11]")), axis=1)
    assert (torque <= np.linalg.norm(np.subtract(high, low)) * pressed).all()
    return of(table, ALL)


def knots(places, period, first, count):
    """Places along an axis, which repeat themselves, from one of them on."""
    n = len(places)
    return [places[k % n] + period * (k // n) for k in range(first, first + count)]


def same(rows, exact, moved=(0, 0, 0)):
    off = np.abs(rows - exact - np.concatenate([moved, np.zeros(rows.shape[1] - 3)]))
    off /= np.abs(exact).max(0) + 1e-300
    print("off", off.max())
    return off.max() < 1e-7


DEEP = hertz(MODULUS, MASS * GRAVITY, 0.5 / RADIUS, 0.5 / RADIUS)[0]


@pytest.mark.parametrize("boundary, way", [("p f f", (20, 0, 0)), ("f p f", (0, -20, 0)), ("p p f", (15, 15, 0)), ("p p f", (15, -7, 0)), ("p p p", (-9, 16, 0))])
def test_a_ball_rolls_over_the_boundary_as_on_a_plane(tmp_path, boundary, way):
    """The same bits as on a plane in the same box, through all corners of a box or elsewhere; along a seam at first."""
    ways = np.random.default_rng(4711).uniform(0.05, 0.3, 12)
    xs = np.concatenate([[0], np.cumsum(ways)])
    ys = np.linspace(-1, 1, 8)
    write(tmp_path / "sheet.stl", sheet(2 * xs / xs[-1] - 1, ys))
    start = [0.0 if side == "f" or abs(way[0]) != abs(way[1]) else 0.3 for side in boundary.split()[:2]]
    rows = []
    for wall in ("plane 0 0 0 0 0 1", "stl sheet.stl"):
        script = one_ball(RADIUS, YOUNG, (*start, RADIUS - DEEP), way, (5, 1, 30), [wall], 5e-5, DOWN, energy="energy yes torsion yes")
        its = boundary if "stl" in wall else boundary[:4] + "f"
        rows.append(run(tmp_path, script, its, (-1, -1, -3), (1, 1, 3), 16000))
    assert np.linalg.norm(rows[0][-1, :2] - rows[0][0, :2]) > 8, "several periods"
    assert np.array_equal(*rows)


def test_a_ball_rolls_over_slabs_side_by_side(tmp_path):
    """Closed boxes as long as the period stand face to face: their upper sides are one plane."""
    write(tmp_path / "slab.stl", box((-1, -1, -0.7), (1, 1, 0)))
    rows = []
    for wall in ("plane 0 0 0 0 0 1", "stl slab.stl"):
        script = one_ball(RADIUS, YOUNG, (0.3, 0.3, RADIUS - DEEP), (15, 15, 0), (5, 1, 30), [wall], 5e-5, DOWN)
        rows.append(run(tmp_path, script, "p p f", (-1, -1, -3), (1, 1, 3), 12000))
    assert np.array_equal(*rows)


@pytest.mark.parametrize("start, way, spin", [((0, 0), (15, 17, 0), (5, 1, 30)), ((0, -0.7), (15, 0, 0), (0, 1, 0))])
def test_seams_close_within_single_precision(tmp_path, start, way, spin):
    """The sides of a surface in a binary file differ from the box by round-off; it is longer along x, shorter
    along y. A ball crosses the seams, or rolls along one."""
    low, high = (-1.1, -0.7, -3), (0.6, 0.9, 3)
    made = sheet(np.linspace(low[0], high[0], 7), np.linspace(low[1], high[1], 5))
    (tmp_path / "sheet.stl").write_bytes(binary(made))
    rows = []
    for wall in ("plane 0 0 0 0 0 1", "stl sheet.stl"):
        script = one_ball(RADIUS, YOUNG, (*start, RADIUS - DEEP), way, spin, [wall], 5e-5, DOWN)
        rows.append(run(tmp_path, script, "p p f", low, high, 16000))
    assert np.array_equal(*rows)


def test_ends_that_do_not_match_are_as_long_as_the_box(tmp_path):
    """A corner at one end has none at the other, and is beyond the box by round-off. The ball still rolls over."""
    low, high = (-1.1, -0.7, -3), (0.6, 0.9, 3)
    a, b, c, d = ((x, y, 0) for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])))
    alone = (high[0], 0.1, 0)
    (tmp_path / "sheet.stl").write_bytes(binary([(a, b, alone), (a, alone, d), (alone, c, d)]))
    rows = []
    for wall in ("plane 0 0 0 0 0 1", "stl sheet.stl"):
        script = one_ball(RADIUS, YOUNG, (0, 0, RADIUS - DEEP), (15, 17, 0), (5, 1, 30), [wall], 5e-5, DOWN)
        rows.append(run(tmp_path, script, "p p f", low, high, 16000))
    assert np.array_equal(*rows)


def test_a_ball_rolls_along_a_trough(tmp_path):
    """Two faces that meet in a hollow edge along the period bear it as two planes do."""
    slope = [(-1, 1), (0, 0), (1, 1)]
    faces = [[(*a, 0), (*b, 0), (*b, 1)] for a, b in zip(slope, slope[1:])]
    faces += [[(*a, 0), (*b, 1), (*a, 1)] for a, b in zip(slope, slope[1:])]
    write(tmp_path / "trough.stl", np.array([[(x, 2 * y - 1, z) for x, z, y in face] for face in faces]))
    pull = f"fix gravity all gravity {GRAVITY} vector 0 0.3 -1"
    root, rows = math.sqrt(0.5), []
    for walls in (["plane 0 0 0 1 0 1", "plane 0 0 0 -1 0 1"], ["stl trough.stl"]):
        script = one_ball(RADIUS, 1e9, (0, 0, RADIUS / root - 1e-6), (0, 5, 0), (0, 0, 2), walls, 1e-4, pull)
        rows.append(run(tmp_path, script, "f p f", (-4, -1, -4), (4, 1, 4), 10000))
    assert rows[0][-1, 1] > 3, "over several periods"
    # The forces on the wall are those of both planes together.
    kept = [k for k, name in enumerate(ALL) if name not in FORCE]
    assert rows[1][:, kept] == pytest.approx(rows[0][:, kept], abs=1e-11 * np.abs(rows[0]).max())


def test_a_floor_is_the_ceiling_below(tmp_path):
    """A sheet in a box that is periodic in height, and hardly higher than the ball, as two planes."""
    write(tmp_path / "sheet.stl", sheet([-1, 0.1, 1], [-1, -0.3, 1], lambda x, y: 1.996))
    rows = []
    for walls, boundary in ((["plane 0 0 -0.01 0 0 1", "plane 0 0 0.993 0 0 -1"], "p p f"), (["stl sheet.stl"], "p p p")):
        script = one_ball(RADIUS, 1e8, (0, 0, 0.4915), (3, 1, 2), (0, 9, 0), walls, 1e-4)
        rows.append(run(tmp_path, script, boundary, (-1, -1, -0.01), (1, 1, 0.993), 12000))
    assert (rows[0][:, 2] < 0.489).any() and (rows[0][:, 2] > 0.494).any(), "to and fro"
    kept = [k for k, name in enumerate(ALL) if name not in FORCE]
    assert same(rows[1][:, kept], rows[0][:, kept])


# Humps with hollow and sharp edges, in cells of uneven width; their period is 2 along both axes.
XS, YS = [-1.0, -0.6, 0.1, 0.5], [-1.0, -0.2, 0.3]
HEIGHTS = np.array([[0.0, 0.02, -0.03], [0.12, -0.02, 0.1], [-0.03, 0.15, 0.01], [0.05, 0.0, 0.14]]) / 2


def humps(first, counts):
    """The humps from one corner of their cells on, so many cells."""
    xs, ys = (knots(places, 2.0, at, count + 1) for places, at, count in zip((XS, YS), first, counts))
    lookup = {(x, y): HEIGHTS[(first[0] + i) % 4, (first[1] + j) % 3] for i, x in enumerate(xs) for j, y in enumerate(ys)}
    return sheet(xs, ys, lambda x, y: lookup[x, y])


def over_humps(wall, start, moved=(0, 0, 0)):
    way = np.array(start) + moved
    return one_ball(RADIUS, 1e8, way, (3, 2, 0), (0, 0, 1), [wall + " edges 0.1 damping 2e-2"], 1e-4, PULL, friction=0.3)


START, STEPS = (0.05, -0.3, RADIUS + 0.1), 16000
PULL = f"fix gravity all gravity {GRAVITY} vector 0.3 0.25 -1"


@pytest.fixture(scope="module")
def long_way(tmp_path_factory):
    """The ball on humps without end, in a large box that is not periodic."""
    folder = tmp_path_factory.mktemp("long")
    write(folder / "long.stl", humps((-8, -6), (40, 30)))
    rows = run(folder, over_humps("stl long.stl", START), "f f f", (-6, -6, -3), (16, 14, 3), STEPS)
    print("way", rows[-1, :2], "touched", (np.linalg.norm(rows[:, 9:12], axis=1) > 0).mean())
    assert rows[-1, 0] > 4 and rows[-1, 1] > 2, "over several periods"
    touched = np.linalg.norm(rows[:, 9:12], axis=1) > 0
    assert 0.2 < touched.mean() < 0.999, "it rolls and jumps"
    return rows


@pytest.mark.parametrize("first", [(0, 0), (1, 0), (2, 2), (3, 1), (-5, 4)])
def test_it_does_not_matter_where_a_surface_is_cut(tmp_path, long_way, first):
    """At sharp edges, hollow ones and corners; partly or wholly outside the box."""
    write(tmp_path / "humps.stl", humps(first, (4, 3)))
    rows = run(tmp_path, over_humps("stl humps.stl", START), "p p f", (-1, -1, -3), (1, 1, 3), STEPS)
    assert same(rows, long_way)


@pytest.mark.parametrize("boundary", ["p f f", "f p f"])
def test_a_surface_repeats_itself_along_one_axis(tmp_path, long_way, boundary):
    first, counts = ((1, -6), (4, 30)) if boundary == "p f f" else ((-8, 2), (40, 3))
    low, high = ((-1, -6, -3), (1, 14, 3)) if boundary == "p f f" else ((-6, -1, -3), (16, 1, 3))
    write(tmp_path / "humps.stl", humps(first, counts))
    rows = run(tmp_path, over_humps("stl humps.stl", START), boundary, low, high, STEPS)
    assert same(rows, long_way)


def test_surface_and_grains_may_be_moved_together(tmp_path, long_way):
    for moved in ((0.37, -0.55, 0.1), (-0.1, 0.6, 0)):
        write(tmp_path / "humps.stl", humps((0, 0), (4, 3)) + moved)
        rows = run(tmp_path, over_humps("stl humps.stl", START, moved), "p p f", (-1, -1, -3), (1, 1, 3), STEPS)
        assert same(rows, long_way, moved)


def test_a_ball_almost_as_wide_as_the_period(tmp_path):
    """It touches two periods of the surface at once."""
    write(tmp_path / "long.stl", humps((-8, -6), (60, 45)))
    write(tmp_path / "humps.stl", humps((2, 1), (4, 3)))
    rows = []
    for file, boundary, low, high in (("long", "f f f", (-2, -2, -3), (14, 12, 3)), ("humps", "p p f", (-0.52, -0.52, -3), (0.52, 0.52, 3))):
        script = over_humps(f"stl {file}.stl scale 0.52", START)
        rows.append(run(tmp_path, script, boundary, low, high, STEPS))
    assert rows[0][-1, 0] > 3, "over several periods"
    assert same(*rows[::-1])


@pytest.mark.parametrize("tip", [(0, 0), (0, None), (None, 0)])
def test_a_tip_or_ridge_may_stand_at_the_boundary(tmp_path, tip):
    """At the corner of the box or along its sides, as in the middle."""
    rows = []
    for first in (-1, 0):
        places = [first, first + 1, first + 2]
        height = lambda x, y: 0.4 * all(at is None or (at - its) % 2 == 0 for at, its in zip(tip, (x, y)))
        write(tmp_path / "tip.stl", sheet(places, places, height))
        script = one_ball(RADIUS, 1e7, (0.012, 0.017, 0.4 + RADIUS), (0, 0, -0.2), (0, 0, 3), ["stl tip.stl edges 0.1"], 1e-4, DOWN)
        rows.append(run(tmp_path, script, "p p f", (first, first, -2), (first + 2, first + 2, 2), 16000))
    assert np.linalg.norm(rows[0][-1, :2] - rows[0][0, :2]) > 0.3, "down the tip"
    assert same(*rows)


def test_a_surface_may_be_cut_within_its_faces(tmp_path):
    """A roof that repeats itself, cut at its foot or on its slope, in a text or a binary file."""
    height = lambda x, y: 0.2 * (1 - abs((x + 1) % 2 - 1))
    rows = []
    for name, xs, write_as in (("foot", [-1, 0, 1], text), ("slope", [0.375, 1, 2, 2.375], text), ("binary", [-0.7, 0, 1, 1.3], binary)):
        made = write_as(sheet(xs, [-1, 0.5, 1], height))
        (tmp_path / "roof.stl").write_bytes(made if isinstance(made, bytes) else made.encode())
        script = one_ball(RADIUS, 1e8, (0.3, 0.2, 0.2 + RADIUS), (5, 4, 0), (0, 0, 1), ["stl roof.stl edges 0.1 damping 1e-2"], 1e-4, DOWN, friction=0.3)
        rows.append(run(tmp_path, script, "p p f", (-1, -1, -3), (1, 1, 3), 10000))
    assert abs(rows[0][-1, 0] - rows[0][0, 0]) > 2, "over a period"
    assert same(rows[1], rows[0])
    print("binary", np.abs(rows[2] - rows[0])[:, :3].max())
    assert rows[2][:, :3] == pytest.approx(rows[0][:, :3], abs=1e-4)


def cone(spokes):
    """A part of a flat cone about the origin, between spokes at these angles in degrees."""
    ends = [(0.6 * math.cos(a), 0.6 * math.sin(a), -0.15) for a in np.radians(spokes)]
    return np.array([[(0, 0, 0), one, two] for one, two in zip(ends, ends[1:])])


@pytest.mark.parametrize("side", [-1, 1])
def test_a_tip_is_sharp_on_both_sides_of_a_seam(tmp_path, side):
    """The only sharp edge of the tip is on one side of the boundary."""
    left, right = cone([90, 105, 120, 180, 240, 255, 270]), cone(range(-90, 91, 15))
    if side > 0:
        left, right = right * (-1, 1, 1), left * (-1, 1, 1)
    rows = []
    for made, low, high in ((np.concatenate([left, right]), -1, 1), (np.concatenate([right, left + (2, 0, 0)]), 0, 2)):
        write(tmp_path / "tip.stl", made)
        for start in (-1e-4, 1e-4):
            place = (start % 2 if low == 0 else start, 1e-5, RADIUS - 1e-3)
            script = one_ball(RADIUS, 1e8, place, (0, 0, 0), (0, 0, 0), ["stl tip.stl edges 0.1"], 1e-4, DOWN)
            rows.append(run(tmp_path, script, "p f f", (low, -2, -3), (high, 2, 3), 300))
    for at in (0, 1):
        assert rows[2 + at][:, 11] == pytest.approx(rows[at][:, 11], rel=1e-9)
        flat = hertz(MODULUS * 1e8 / YOUNG, -rows[at][0, 11], 0.5 / RADIUS, 0.5 / RADIUS)[0]
        sharp = hertz(MODULUS * 1e8 / YOUNG, -rows[at][0, 11], 0.5 / RADIUS + 5, 0.5 / RADIUS + 5)[0]
        assert sharp == pytest.approx(1e-3, rel=1e-3) and flat < 0.9e-3


def ripples(xs, ys):
    return sheet(xs, ys, lambda x, y: 0.02 * (math.sin(math.pi * x) + math.cos(math.pi * y)))


def over_ripples(file):
    return one_ball(RADIUS, 1e8, (0.05, -0.3, RADIUS + 0.02), (3, 2, 0), (0, 0, 1), [f"stl {file}.stl damping 2e-2"], 1e-4, PULL, friction=0.3)


@pytest.mark.parametrize("first", [(0, 0), (4, 12), (11, 7), (5, 3)])
def test_fine_ripples_close_without_a_radius_of_edges(tmp_path, first):
    """Edges of a few degrees at the seams are no ends of the surface: crests, valleys and slopes."""
    place = [k / 8 for k in range(16)]
    rows = []
    for start, counts, boundary, low, high in (((-16, -16), (96, 64), "f f f", (-2, -2, -3), (10, 6, 3)), (first, (16, 16), "p p f", (-1, -1, -3), (1, 1, 3))):
        xs, ys = (knots(place, 2.0, at, count + 1) for at, count in zip(start, counts))
        write(tmp_path / "ripples.stl", ripples(xs, ys))
        rows.append(run(tmp_path, over_ripples("ripples"), boundary, low, high, STEPS))
    assert rows[0][-1, 0] > 4 and rows[0][-1, 1] > 2, "over several periods"
    assert same(*rows[::-1])


def test_seams_close_where_each_corner_is_a_little_off(tmp_path):
    """By less than the tolerance, of 4e-7 here, so that corners along a side are in any order. The sides are crests."""
    made = ripples(np.linspace(0.5, 2.5, 17), np.linspace(0, 2, 17))
    off = np.random.default_rng(7).uniform(-8e-8, 8e-8, (17, 17, 3))
    at = np.round((made[..., :2] - (0.5, 0)) * 8).astype(int)
    rows = []
    for shape in (made, made + off[at[..., 0], at[..., 1]]):
        write(tmp_path / "ripples.stl", shape)
        rows.append(run(tmp_path, over_ripples("ripples"), "p p f", (-1, -1, -3), (1, 1, 3), STEPS))
    print("off", np.abs(rows[1] - rows[0])[:, :3].max())
    assert rows[1][:, :3] == pytest.approx(rows[0][:, :3], abs=1e-4)


@pytest.mark.parametrize("velocity", [(3, 0, 0), (-40, 70, 0)])
def test_humps_that_move_come_back_after_a_period(tmp_path, long_way, velocity):
    """Ball and surface with the same velocity more move as without, apart from it."""
    velocity = np.array(velocity, dtype=float)
    write(tmp_path / "humps.stl", humps((1, 1), (4, 3)))
    wall = "stl humps.stl velocity " + " ".join(map(str, velocity))
    script = over_humps(wall, START).replace("velocity all set 3 2 0", "velocity all set {} {} {}".format(*velocity + (3, 2, 0)))
    rows = run(tmp_path, script, "p p f", (-1, -1, -3), (1, 1, 3), STEPS)
    time = 1e-3 * np.arange(len(rows))
    assert abs(velocity @ velocity) ** 0.5 * time[-1] > 4
    rows[:, :3] -= time[:, None] * velocity
    rows[:, 3:6] -= velocity
    assert same(rows, long_way)


def test_a_drum_turns_about_the_axis_along_which_it_repeats_itself(tmp_path):
    """Beside a long one, with a wave of its wall along the axis."""
    made = tube(1.5, -1, 1, 24)
    count, period = 24, 2.0
    rim = made[:, :, 1]
    pieces = []
    for start, end, one, two in ((-1, -0.2, 1.0, 1.05), (-0.2, 1, 1.05, 1.0)):
        piece = made.copy()
        for low, to, factor in ((-1, start, one), (1, end, two)):
            at = rim == low
            piece[at] *= (factor, 0, factor)
            piece[at, 1] = to
        pieces.append(piece)
    short = np.concatenate(pieces)
    write(tmp_path / "short.stl", short)
    write(tmp_path / "long.stl", np.concatenate([short + (0, k * period, 0) for k in range(-2, 5)]))
    rows = []
    pull = f"fix gravity all gravity {GRAVITY} vector 0 0.2 -1"
    for file, boundary, low, high in (("short", "f p f", -1, 1), ("long", "f f f", -4, 8)):
        wall = f"stl {file}.stl edges 0.1 omega 0 3 0 velocity 0 0.5 0"
        script = one_ball(RADIUS, 1e8, (0, 0, -1.0), (0, 3, 0), (0, 0, 0), [wall], 1e-4, pull)
        rows.append(run(tmp_path, script, boundary, (-4, low, -4), (4, high, 4), 12000))
    assert rows[1][-1, 1] > 3, "over several periods"
    assert same(*rows)


# Grains that fall on a bed of humps in a box that is periodic along both horizontal axes; the bed moves across it.
BED = "stl bed.stl scale 0.02 edges 1e-3 velocity 0.3 -0.2 0"


def bed(tmp_path):
    write(tmp_path / "bed.stl", humps((1, 2), (4, 3)))
    lid = "plane 0 0 0.041 0 0 -1"
    return GRAINS.replace("boundary f f f", "boundary p p f") + walled([BED, lid]), walled([BED, lid])


def test_two_ranks_are_as_one(tmp_path):
    ends = []
    for ranks in (1, 2):
        lmp(bed(tmp_path)[0] + "thermo 1000\nrun 2500\n" + WRITE.format("end"), tmp_path, ranks=ranks, dt=1e-5)
        ends.append(dump(tmp_path / "dump.end"))
    period = np.array([0.04, 0.04, np.inf])
    off = ends[1][:, 1:4] - ends[0][:, 1:4]
    off[:, :2] -= np.round(off[:, :2] / 0.04) * 0.04
    print("off", np.abs(off).max())
    assert np.abs(off).max() < 1e-12
    assert np.abs(ends[0][:, 4:7]).max() > 0.05, "in motion"


@pytest.mark.parametrize("ranks", [1, 2])
def test_restart_in_the_middle_goes_on_bit_for_bit(tmp_path, ranks):
    variables = {"newton": "on", "dt": 1e-5}
    script, walls = bed(tmp_path)
    lmp(script + "thermo 1000\nrestart 4000 restart.*\nrun 5000\n" + WRITE.format("long"), tmp_path, ranks=ranks, **variables)
    again = "newton ${newton}\nplugin load ${plugin}\natom_modify sort 0 0\nread_restart restart.4000\ncomm_modify vel yes\n"
    again += "variable shake index 0\n" + walls + "thermo 1000\nrun 1000\n" + WRITE.format("again")
    lmp(again, tmp_path, ranks=ranks, **variables)
    assert np.array_equal(dump(tmp_path / "dump.long"), dump(tmp_path / "dump.again"))


def test_energy_goes_where_it_is_booked(tmp_path):
    missed = []
    for dt in (1e-5, 5e-6):
        steps = round(0.05 / dt)
        table = thermo(lmp(bed(tmp_path)[0] + f"thermo {steps // 30}\nrun {steps}\n", tmp_path, dt=dt))
        total, gone = table["v_total"], sum(table[f"c_where[{k}]"][-1] for k in (2, 3, 5))
        assert abs(table["c_where[4]"][-1]) > 0.01 * gone, "the bed does work"
        missed.append(np.abs(total - total[0]).max() / gone)
    print("balance over what became heat, by step:", missed)
    assert missed[0] < 3e-4 and missed[1] < 0.6 * missed[0]
