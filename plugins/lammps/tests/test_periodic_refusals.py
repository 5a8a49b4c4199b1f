"""Which walls of triangles and which periodic boxes do not go together."""

import pytest
from conftest import Failed, lmp
from meshes import box, write
from test_shapes import RADIUS, one_ball

P = "change_box all boundary p f f"


@pytest.mark.parametrize(
    "wall, more, words",
    [
        ("stl cube.stl", P, []),
        ("stl cube.stl scale 4", P, []),
        ("stl cube.stl scale 4.001", P, ["length of the surface along x = 8.002 is out of range: must be at most 8, the period with which it repeats itself"]),
        ("stl cube.stl omega 0 2 0", P, ["omega = 0 2 0 is out of range: must be along x, in which the box is periodic"]),
        ("stl cube.stl omega -2 0 0", P, []),
        ("stl cube.stl omega 2 0 0", "change_box all boundary p f p", ["omega = 2 0 0 is out of range: must be 0 0 0", "more than one axis"]),
        ("stl cube.stl", "change_box all triclinic boundary p p f xy final 0.1", ["tilt xy of the box = 0.1 is out of range: must be 0, since the box is periodic along y"]),
        ("stl cube.stl", P + "\nfix bend all deform 1 x scale 1.1", ["fix bend deform changes the box along x", "must leave it as it is"]),
        ("stl cube.stl", P + "\nfix bend all deform 1 y scale 1.1", []),
        ("stl cube.stl", P + "\nfix press all press/berendsen x 1 1 1", ["fix press press/berendsen changes the box along x"]),
    ],
)
def test_what_does_not_fit_is_named(tmp_path, wall, more, words):
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    script = one_ball(RADIUS, 1e7, (0, 0, 0.51), (0, 0, 0), (0, 0, 0), [wall], 1e-4, more) + "run 1\n"
    if not words:
        lmp(script, tmp_path)
        return
    with pytest.raises(Failed) as failed:
        lmp(script, tmp_path)
    for word in ("fix wall1 wall/carom", *words):
        assert word in str(failed.value), str(failed.value)[-500:]


@pytest.mark.parametrize(
    "change, words",
    [
        ("change_box all x final -4 4.5", ["length of the box along x = 8.5 is out of range: must be 8 as in the run before"]),
        ("change_box all x final -4 4.5\nrun 1 pre no", ["the box has changed where it is periodic: must stay as it was when the run began"]),
        ("change_box all triclinic boundary p p f\nrun 1\nchange_box all xy final 0.1\nrun 1 pre no", ["the box has changed where it is periodic"]),
        ("change_box all y final -4 4.5", []),
        ("change_box all boundary f f f", []),
        ("change_box all x delta 1 1 boundary p p f", []),
    ],
)
def test_a_box_that_has_changed_between_runs(tmp_path, change, words):
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    script = one_ball(RADIUS, 1e7, (0, 0, 0.51), (0, 0, 0), (0, 0, 0), ["stl cube.stl"], 1e-4, P) + f"run 1\n{change}\nrun 1\n"
    if not words:
        lmp(script, tmp_path)
        return
    with pytest.raises(Failed) as failed:
        lmp(script, tmp_path)
    for word in words:
        assert word in str(failed.value), str(failed.value)[-500:]


def test_a_surface_that_has_turned_before(tmp_path):
    """In a restart file, about another axis than the box is then periodic along."""
    write(tmp_path / "cube.stl", box((-1, -1, -2), (1, 1, 0)))
    turning = one_ball(RADIUS, 1e7, (0, 0, 3), (0, 0, 0), (0, 0, 0), ["stl cube.stl omega 0 2 0"], 1e-4)
    lmp(turning + "run 10\nwrite_restart turned.restart\n", tmp_path)
    wall = turning[turning.index("fix wall1") : turning.index("compute where")].replace("omega 0 2 0", "")
    again = "plugin load ${plugin}\nread_restart turned.restart\ncomm_modify vel yes\n"
    lmp(again + wall + "run 0\nchange_box all boundary f p f\nrun 1\n", tmp_path)
    with pytest.raises(Failed) as failed:
        lmp(again + wall + "run 0\n" + P + "\nrun 1\n", tmp_path)
    assert "sine of the angle by which axis x of the surface has turned = 0.0019999" in str(failed.value), str(failed.value)[-500:]
    assert "must be 0, since the box is periodic along x" in str(failed.value)
