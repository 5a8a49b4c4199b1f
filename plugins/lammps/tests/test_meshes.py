"""Walls of triangles."""

import math
import os
import pathlib

import numpy as np
import pytest
from conftest import Failed, dump, lmp, thermo
from meshes import binary, box, sheet, text, tube, write
from test_shapes import (
    DENSITY, DOWN, FORCE, GRAVITY, MASS, MODULUS, PLACE, POISSON, RADIUS, SPIN, VELOCITY, YOUNG, hertz, of, one_ball,
    smaller,
)

HERE = pathlib.Path(__file__).parent
GRAINS = (HERE / "box.in").read_text()
WALLS = (HERE / "box_walls.in").read_text()
WALL = "young 1e8 poisson 0.2 friction 0.5 damping 1e-4 rolling 2000 0.3 0.05"
WRITE = "write_dump all custom dump.{} id x y z vx vy vz omegax omegay omegaz modify sort id format float %.17g\n"


def walled(walls):
    """The grains of the box between these walls, with their energies."""
    lines = [line for line in WALLS.split("\n") if "wall/carom" not in line]
    at = next(k for k, line in enumerate(lines) if line.startswith("timestep"))
    lines[at:at] = [f"fix wall{k} all wall/carom {wall} {WALL}" for k, wall in enumerate(walls, 1)]
    script = "\n".join(lines).replace("c_where[3]-c_where[4]", "c_where[3]+c_where[5]-c_where[4]")
    return script.replace("v_total f_floor[1] f_floor[3]", "v_total c_where[5] f_wall1[1] f_wall1[9]")


LOW, HIGH = (-0.019, -0.019, 0.0), (0.019, 0.019, 0.041)
PLANES = ["plane 0 0 0 0 0 1", "plane -0.019 0 0 1 0 0", "plane 0.019 0 0 -1 0 0", "plane 0 -0.019 0 0 1 0", "plane 0 0.019 0 0 -1 0", "plane 0 0 0.041 0 0 -1"]


def test_a_box_of_twelve_triangles_is_six_planes(tmp_path):
    """The same bits, through all impacts in faces, edges and corners."""
    write(tmp_path / "box.stl", box(LOW, HIGH))
    tables, ends = [], []
    for walls in (PLANES, ["stl box.stl"]):
        shown = "thermo 200\nrun 4000\n" + WRITE.format("end")
        tables.append(thermo(lmp(GRAINS + walled(walls) + shown, tmp_path, dt=1e-5, newton="off")))
        ends.append(dump(tmp_path / "dump.end"))
    assert np.array_equal(*ends)
    assert np.abs(ends[0][:, 4:7]).max() > 0.05, "in motion"
    for name in ("c_where[1]", "c_where[2]", "c_where[3]", "c_where[5]"):
        assert tables[1][name] == pytest.approx(tables[0][name], rel=1e-12)
    assert tables[1]["c_where[2]"][-1] > 0


def test_a_ball_rolls_over_seams_as_on_a_plane(tmp_path):
    """Past corners and along seams of a sheet of many triangles, with torsion."""
    ways = np.random.default_rng(4711).uniform(0.05, 0.3, 20)
    write(tmp_path / "sheet.stl", sheet(np.cumsum(ways) - 1.7, np.linspace(-1, 1, 11)))
    deep = hertz(MODULUS, MASS * GRAVITY, 0.5 / RADIUS, 0.5 / RADIUS)[0]
    rows = []
    for wall in ("plane 0 0 0 0 0 1", "stl sheet.stl"):
        # Along a seam at first, since y = 0 is one.
        script = one_ball(RADIUS, YOUNG, (-1, 0, RADIUS - deep), (4, 0, 0), (0.5, 1, 30), [wall], 5e-5, DOWN, energy="energy yes torsion yes")
        table = thermo(lmp(script + "run 10000\n", tmp_path))
        rows.append(np.concatenate([of(table, names) for names in (PLACE, VELOCITY, SPIN, FORCE)], 1))
    assert rows[0][-1, 0] - rows[0][0, 0] > 1.5 and abs(rows[0][-1, 1]) > 1e-3
    assert np.array_equal(*rows)


def test_a_ball_in_a_corner_has_three_contacts(tmp_path):
    """It lies in the corner of a tilted box: each face bears its part, as three planes do."""
    turn = np.array([[2, -2, 1], [1, 2, 2], [2, 1, -2]]) / 3
    write(tmp_path / "corner.stl", box((0, 0, 0), (3, 3, 3)) @ turn.T)
    normals = [turn[:, 2], turn[:, 0], turn[:, 1]]
    pull = 5.0 * turn @ np.array([1.0, 2.0, 3.0])
    more = f"fix pull all addforce {-pull[0] * MASS:.17g} {-pull[1] * MASS:.17g} {-pull[2] * MASS:.17g}"
    place = turn @ np.array([0.4999] * 3)
    rows = []
    for walls in ([f"plane 0 0 0 {n[0]:.17g} {n[1]:.17g} {n[2]:.17g}" for n in normals], ["stl corner.stl"]):
        script = one_ball(RADIUS, 1e7, place, (0, 0, 0), (1, 2, 3), [f"{wall} damping 1e-3" for wall in walls], 1e-4, more, size=5)
        table = thermo(lmp(script + "run 3000\n", tmp_path))
        rows.append(np.concatenate([of(table, names) for names in (PLACE, VELOCITY, SPIN)], 1))
    assert rows[1] == pytest.approx(rows[0], abs=1e-12)
    assert np.abs(of(table, PLACE) @ turn - RADIUS).max() < 0.03 and table["c_where[2]"][-1] > 0, "it stays there, and slips"


@pytest.mark.parametrize("side", ["inside", "outside"])
def test_a_ball_rolls_on_a_fine_prism_as_on_a_cylinder(tmp_path, side):
    """One contact passes from face to face over edges of half a degree, hollow or convex, with its memory. What becomes heat
    are the jolts: at each edge the motion turns by its angle."""
    count, drum = 720, 1.5
    write(tmp_path / "tube.stl", tube(drum, -1, 1, count))
    start, sign = 0.3, -1 if side == "inside" else 1
    away = drum + sign * RADIUS
    # Inside it falls to the bottom, outside from the top.
    up = np.array([math.sin(start), 0, sign * math.cos(start)])
    tables = []
    for wall in (f"cylinder 0 0 0 0 1 0 {drum} {side}", "stl tube.stl"):
        script = one_ball(RADIUS, YOUNG, (away - sign * 1e-7) * up, (0, 0, 0), (0, 0, 0), [wall], 5e-5, DOWN, friction=100, size=5)
        tables.append(thermo(lmp(script + "run 16000\n", tmp_path)))
    exact, table = tables
    moved = np.linalg.norm(of(exact, PLACE)[-1] - of(exact, PLACE)[0])
    off = np.abs(of(table, PLACE) - of(exact, PLACE)).max()
    height = table["v_z"] * MASS * GRAVITY
    total = table["c_motion"] + table["c_rotation"] + height + table["c_where[1]"] + table["c_where[2]"]
    print(side, "moved", moved, "off", off, "energy", np.abs(total - total[0]).max() / table["c_motion"].max(), "heat", table["c_where[2]"][-1] / table["c_motion"].max())
    assert moved > 0.3, "over many edges"
    assert off < 2e-3 * moved
    assert np.abs(total - total[0]).max() < 2e-4 * table["c_motion"].max()
    assert table["c_where[2]"][-1] < 5e-3 * table["c_motion"].max()


EDGES = 0.1


@pytest.mark.parametrize("kind", ["edge", "corner"])
def test_edges_and_corners_have_the_stiffness_of_their_radius(tmp_path, kind):
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    toward = np.array([1, 0, 1]) if kind == "edge" else np.array([1, 1, 1])
    toward = toward / np.linalg.norm(toward)
    deep = 1e-4
    place = np.array([1, 0.3 if kind == "edge" else 1, 0]) + (RADIUS - deep) * toward
    script = one_ball(RADIUS, YOUNG, place, (0, 0, 0), (0, 0, 0), [f"stl cube.stl edges {EDGES}"], 1e-6)
    table = thermo(lmp(script.replace("fix move all nve/sphere\n", "") + "run 10\n", tmp_path))
    force = -of(table, FORCE)[-1]
    gaps = (0.5 / RADIUS + (0.5 / EDGES if kind == "corner" else 0.0), 0.5 / RADIUS + 0.5 / EDGES)
    assert hertz(MODULUS, force @ toward, *gaps)[0] == pytest.approx(deep, rel=1e-6)
    assert force == pytest.approx((force @ toward) * toward, abs=1e-9 * np.linalg.norm(force))


def test_a_ball_tumbles_over_an_edge_with_one_contact(tmp_path):
    """From the upper face about the edge: no energy appears or is lost where the place of contact passes from one to the
    other."""
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    deep = hertz(MODULUS, MASS * GRAVITY, 0.5 / RADIUS, 0.5 / RADIUS)[0]
    script = one_ball(RADIUS, YOUNG, (0.95, 0.3, RADIUS - deep), (0.5, 0, 0), (0, 1, 0), [f"stl cube.stl edges {EDGES}"], 2e-5, DOWN, friction=100)
    table = thermo(lmp(script + "run 20000\n", tmp_path))
    total = table["c_motion"] + table["c_rotation"] + table["v_z"] * MASS * GRAVITY + table["c_where[1]"]
    total += table["c_where[2]"]
    touched = np.abs(table["f_wall1[3]"]) > 0
    on_edge = touched & (table["v_x"] > 1.0)
    print("steps on the edge", on_edge.sum(), "energy", np.abs(total - total[0]).max() / table["c_motion"][0])
    assert on_edge.sum() > 100
    assert np.abs(table["f_wall1[1]"][on_edge]).max() > 0.1 * MASS * GRAVITY, "pushed aside by the edge"
    assert np.abs(total - total[0]).max() < 1e-7 * table["c_motion"][0]


def test_a_ball_that_grips_is_carried_over_a_corner_from_edge_to_edge(tmp_path):
    """The work that carries it is stored or heat."""
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    velocity, dt = np.array([-1, 1, 0]), 1e-5
    script = one_ball(RADIUS, YOUNG, (1.005, 0.998, RADIUS - 1.2e-4), velocity, (0, 0, 0), [f"stl cube.stl edges {EDGES}"], dt, friction=100)
    table = thermo(lmp(script.replace("nve/sphere", "nve/noforce") + "thermo 1\nrun 1000\n", tmp_path))
    power = of(table, FORCE) @ velocity
    work, taken = dt * np.cumsum(power[1:] + power[:-1]) / 2, table["c_where[1]"] + table["c_where[2]"]
    assert table["v_x"][-1] < 1 < table["v_y"][-1], "past the corner"
    assert taken[1:] - taken[0] == pytest.approx(work, abs=1e-6 * work[-1])


def test_a_sharp_edge_without_a_radius_is_an_error_that_says_where(tmp_path):
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    for place, words in (((1.3, 0.3, 0.3), "the edge from (1, -1, 0) to (1, 1, 0)"), ((1.2, 1.2, 0.2), "the corner at (1, 1, 0)")):
        with pytest.raises(Failed) as failed:
            lmp(one_ball(RADIUS, 1e7, place, (0, 0, 0), (0, 0, 0), ["stl cube.stl"], 1e-4) + "run 1\n", tmp_path)
        for word in ("fix wall1 wall/carom: grain 1 at (1.", words, "edges 1e-4"):
            assert word in str(failed.value), str(failed.value)[-500:]


# A box that moves and turns, with a cube within, on whose edges and corners grains fall.
BOX, CUBE = box((-0.03, -0.03, -0.001), (0.03, 0.03, 0.045)), box((-0.006, -0.007, 0.0), (0.007, 0.006, 0.012))
MOVING = ["stl hull.stl velocity 0.1 0 0.05 omega 1 2 6 center 0 0 0.02", "stl cube.stl edges 1e-3 omega 0 0 20 center 0 0 0"]


def moving(tmp_path):
    write(tmp_path / "hull.stl", BOX)
    (tmp_path / "cube.stl").write_bytes(binary(CUBE))
    return smaller() + walled(MOVING)


def test_energy_goes_where_it_is_booked(tmp_path):
    missed = []
    for dt in (1e-5, 5e-6):
        steps = round(0.06 / dt)
        table = thermo(lmp(moving(tmp_path) + f"thermo {steps // 30}\nrun {steps}\n", tmp_path, dt=dt))
        total, gone = table["v_total"], sum(table[f"c_where[{k}]"][-1] for k in (2, 3, 5))
        assert abs(table["c_where[4]"][-1]) > 0.01 * gone, "the walls do work"
        missed.append(np.abs(total - total[0]).max() / gone)
    print("balance over what became heat, by step:", missed, "work", table["c_where[4]"][-1], "heat", gone)
    assert missed[0] < 3e-4 and missed[1] < 0.6 * missed[0]


@pytest.mark.parametrize("ranks", [1, 2])
def test_restart_in_the_middle_goes_on_bit_for_bit(tmp_path, ranks):
    shown = 'print "sums: $(c_where[1]:%.12g) $(c_where[2]:%.12g) $(c_where[3]:%.12g) $(c_where[4]:%.12g) $(c_where[5]:%.12g)"\n'
    variables = {"newton": "on", "dt": 1e-5}
    long = moving(tmp_path) + "thermo 1000\nrestart 4000 restart.*\nrun 5000\n" + WRITE.format("long") + shown
    printed = [lmp(long, tmp_path, ranks=ranks, **variables)]
    again = "newton ${newton}\nplugin load ${plugin}\natom_modify sort 0 0\nread_restart restart.4000\ncomm_modify vel yes\n"
    again += "variable shake index 0\n" + walled(MOVING) + "thermo 1000\nrun 1000\n" + WRITE.format("again") + shown
    printed.append(lmp(again, tmp_path, ranks=ranks, **variables))
    assert np.array_equal(dump(tmp_path / "dump.long"), dump(tmp_path / "dump.again"))
    sums = [next(line for line in said.split("\n") if line.startswith("sums:")) for said in printed]
    numbers = [np.array([float(word) for word in line.split()[1:]]) for line in sums]
    assert np.allclose(*numbers, rtol=1e-9) and numbers[0][1:].all(), numbers


def test_two_ranks_are_as_one(tmp_path):
    ends = []
    for ranks in (1, 2):
        lmp(moving(tmp_path) + "thermo 1000\nrun 2500\n" + WRITE.format("end"), tmp_path, ranks=ranks, dt=1e-5)
        ends.append(dump(tmp_path / "dump.end"))
    print("off", np.abs(ends[1] - ends[0])[:, 1:4].max())
    assert ends[1][:, 1:4] == pytest.approx(ends[0][:, 1:4], abs=1e-12)


GOOD = text(box((-1, -1, -2), (1, 1, 0)))
CUBE_BYTES = binary(box((-1, -1, -2), (1, 1, 0)))
FLAT = text([[(0, 0, 0), (1, 1, 1), (3, 3, 3)]])
VERTEX = "      vertex -1 1 -2"


@pytest.mark.parametrize(
    "contents, words",
    [
        (CUBE_BYTES[:-1], ["states 12 triangles, but has 683 bytes: must have 684"]),
        (binary(box((-1, -1, -2), (1, 1, 0)), 4294967295), ["states 4294967295 triangles, but has 684 bytes"]),
        (binary(np.zeros((0, 3, 3))), ["has no triangles: must have at least one"]),
        (b"\0" * 20, ["has 20 bytes", "must begin with 'solid', or have at least 84"]),
        (b"", ["has 0 bytes"]),
        ("solid nothing\nendsolid nothing\n", ["has no triangles"]),
        (binary([[(0, 0, 0), (1, 0, 0), (0, float("nan"), 0)]]), ["triangle 1 is not valid: a coordinate is not a finite number"]),
        (FLAT, ["triangle 1 is not valid: its corners lie on a line"]),
        (GOOD[: GOOD.index("endsolid")], ["ends after triangle 12: 'endsolid' is missing"]),
        (GOOD[: GOOD.rindex("vertex")], ["triangle 12 is not valid: '' must be 'vertex'"]),
        (GOOD.replace(VERTEX, "      vertex -1 one -2", 1), ["triangle 2 is not valid: 'one' must be a number"]),
        (GOOD.replace(VERTEX, "      vertex -1 inf -2", 1), ["triangle 2 is not valid: a coordinate is not a finite number"]),
        (GOOD.replace(VERTEX, "      vertex -1 -2", 1), ["triangle 2 is not valid: 'endloop' must be a number"]),
        (GOOD.replace("endfacet", "facet", 1), ["triangle 1 is not valid: 'facet' must be 'endfacet'"]),
        (None, ["cannot be opened"]),
    ],
)
def test_a_damaged_file_is_named(tmp_path, contents, words):
    if isinstance(contents, str):
        contents = contents.encode()
    if contents is not None:
        (tmp_path / "bad.stl").write_bytes(contents)
    with pytest.raises(Failed) as failed:
        lmp(one_ball(RADIUS, 1e7, (0, 0, 1), (0, 0, 0), (0, 0, 0), ["stl bad.stl"], 1e-4), tmp_path)
    for word in ("fix wall1 wall/carom: STL file 'bad.stl'", *words):
        assert word in str(failed.value), str(failed.value)[-500:]


def test_a_pipe_is_refused_instead_of_waited_for(tmp_path):
    os.mkfifo(tmp_path / "pipe.stl")
    with pytest.raises(Failed, match="'pipe.stl' cannot be read: it must be a regular file"):
        lmp(one_ball(RADIUS, 1e7, (0, 0, 1), (0, 0, 0), (0, 0, 0), ["stl pipe.stl"], 1e-4), tmp_path)


def test_a_damaged_file_ends_all_ranks(tmp_path):
    (tmp_path / "bad.stl").write_text("solid\n")
    with pytest.raises(Failed, match="endsolid"):
        lmp(one_ball(RADIUS, 1e7, (0, 0, 1), (0, 0, 0), (0, 0, 0), ["stl bad.stl"], 1e-4), tmp_path, ranks=2)


@pytest.mark.parametrize(
    "wall, more, words",
    [
        ("stl cube.stl scale 0", "", ["scale = 0 is out of range: must be finite and > 0"]),
        ("stl cube.stl smooth 50", "", ["smooth = 50 is out of range: must be from 1 to 45 degrees"]),
        ("stl cube.stl edges 0", "", ["edges = 0 is out of range: must be a radius, finite and > 0"]),
        ("stl cube.stl between 0 1", "", ["between is for cylinder and cone only"]),
        ("plane 0 0 0 0 0 1 edges 1", "", ["scale, smooth and edges are for stl only"]),
        ("stl cube.stl sphere 0 0 0 1 inside", "", ["more than one of plane"]),
        ("stl cube.stl edges 0.1 law rings", "", ["law rings needs a plane, a sphere or an STL file without edges"]),
        ("stl cube.stl law rings", "", []),
    ],
)
def test_what_does_not_fit_is_named(tmp_path, wall, more, words):
    (tmp_path / "cube.stl").write_text(GOOD)
    script = one_ball(RADIUS, 1e7, (0, 0, 0.4999), (0, 0, 0), (0, 0, 0), [wall], 1e-4, more) + "run 1\n"
    if not words:
        lmp(script, tmp_path)
        return
    with pytest.raises(Failed) as failed:
        lmp(script, tmp_path)
    for word in words:
        assert word in str(failed.value), str(failed.value)[-500:]


def test_text_bytes_and_a_scale_are_the_same_surface(tmp_path):
    """Coordinates that single precision holds exactly."""
    shape = box((-1, -1, -2), (1, 1, 0))
    (tmp_path / "one.stl").write_text(text(shape))
    (tmp_path / "two.stl").write_bytes(binary(shape))
    (tmp_path / "three.stl").write_text(text(shape * 4).replace("\n", "\r\n"))
    said = []
    for wall in ("stl one.stl", "stl two.stl", "stl three.stl scale 0.25"):
        script = one_ball(RADIUS, 1e7, (0.2, 0.3, 0.51), (0.1, 0, -1), (1, 2, 3), [wall], 1e-4)
        table = thermo(lmp(script + "run 2000\n", tmp_path))
        said.append(np.concatenate([of(table, names) for names in (PLACE, VELOCITY, SPIN)], 1))
    assert np.array_equal(said[0], said[1]) and np.array_equal(said[0], said[2])
    assert table["v_vz"][-1] > 0
