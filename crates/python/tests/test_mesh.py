"""Walls of triangles: a ball on them moves as on the shapes that they stand for."""

import pickle

import carom
import numpy as np
import pytest

PLASTIC = carom.Material(1e9, 0.3)
RADIUS, MASS, DT = 0.01, 0.005, 1e-6
CUBE = np.array([[[0, 0, 0], [1, 0, 0], [1, 1, 0]], [[0, 0, 0], [1, 1, 0], [0, 1, 0]]], dtype=float)
CUBE = np.concatenate([np.roll(CUBE + up, k, 2) for up in ([0, 0, 0], [0, 0, 1]) for k in range(3)])


def sheet(count, height=lambda x, y: 0 * x):
    x, y = np.meshgrid(np.linspace(-1, 1, count), np.linspace(-1, 1, count), indexing="ij")
    at = np.stack([x, y, height(x, y)], -1)
    a, b, c, d = at[:-1, :-1], at[1:, :-1], at[1:, 1:], at[:-1, 1:]
    return np.concatenate([np.stack([a, b, c], 2), np.stack([a, c, d], 2)]).reshape(-1, 3, 3)


def bounce(nearest):
    """Two balls that hit a floor obliquely, with spin; after the step in which the last leaves it."""
    contacts = carom.GrainContacts(2, (RADIUS, np.inf), PLASTIC, 0.4)
    place = np.array([[0.0137, 0.0, RADIUS], [-0.3, 0.21, RADIUS]])
    velocity, spin = np.array([[0.15, 0.03, -0.3], [-0.06, 0.12, -0.2]]), np.array([[0.0, 9.0, 0.0], [3.0, 0.0, 2.0]])
    for _ in range(1000):
        place = place + DT * velocity
        loads = contacts.step(DT, place, velocity, spin, place_2=nearest(place))
        velocity, spin = velocity + loads.force * DT / MASS, spin + loads.torque_1 * DT / (0.4 * MASS * RADIUS**2)
    assert (velocity[:, 2] > 0.19).all() and (place[:, 2] > RADIUS).all()
    return velocity, spin


def test_balls_bounce_on_triangles_as_on_the_plane():
    floor = carom.TriangleMesh(sheet(20))

    def on_triangles(place):
        found = floor.places(place, 0.5)
        assert found.ball.tolist() == [0, 1] and (found.kind == "face").all() and not found.is_sharp.any()
        return found.point

    flat = bounce(lambda place: place * [1, 1, 0])
    for exact, found in zip(flat, bounce(on_triangles), strict=True):
        assert found == pytest.approx(exact, rel=1e-9)


def test_a_cube_has_faces_edges_and_corners():
    found = carom.TriangleMesh(CUBE).places([[0.4, 0.5, 1.25], [1.3, 0.5, 1.4], [1.2, 1.2, 1.1], [9, 9, 9]], [0.3, 0.6, 0.4, 1.0])
    assert (found.ball.tolist(), found.kind.tolist()) == ([0, 1, 2], ["face", "edge", "corner"])
    assert found.is_sharp.tolist() == [False, True, True]
    assert found.distance == pytest.approx([0.25, 0.5, 0.3], rel=1e-14)
    assert found.point == pytest.approx(np.array([[0.4, 0.5, 1], [1, 0.5, 1], [1, 1, 1]]))
    assert found.normal[1] == pytest.approx([0.6, 0, 0.8])


def test_a_surface_repeats_itself():
    waves = carom.TriangleMesh(sheet(33, lambda x, y: 0.1 * np.cos(np.pi * x)), period=(2, 2, 0))
    centers = np.random.default_rng(1).uniform(-1, 1, (50, 3)) * [1, 1, 0.3]
    near, far = waves.places(centers, 0.2), waves.places(centers + [6, -4, 0], 0.2)
    assert len(near.ball) > 20 and near.ball.tolist() == far.ball.tolist()
    assert far.point == pytest.approx(near.point + [6, -4, 0]) and far.normal == pytest.approx(near.normal)


def test_copies_find_the_same():
    mesh = carom.TriangleMesh(CUBE, smooth=0.3, period=(2, 0, 0))
    other = pickle.loads(pickle.dumps(mesh))
    assert len(other) == 12 and repr(other) == repr(mesh)
    one, two = (some.places([-0.5, 0.5, 0.5], 0.6) for some in (mesh, other))
    assert all(np.array_equal(a, b) for a, b in zip(one, two, strict=True)) and len(one.ball) == 2


@pytest.mark.parametrize(
    "options, words",
    [
        ({"triangles": CUBE[0]}, r"triangles has the shape \(3, 3\): must be \(n, 3, 3\)"),
        ({"triangles": np.zeros((0, 3, 3))}, "triangles = 0 is out of range: must be from 1"),
        ({"triangles": np.zeros((2, 3, 3))}, r"area of a triangle = 0 is out of range: must be > 0 \(entry 0\)"),
        ({"triangles": np.full((1, 3, 3), np.nan)}, "triangles = nan is out of range: must be finite"),
        ({"smooth": 10}, "smooth = 10 is out of range: must be from 0.01 to 0.8 rad"),
        ({"period": 2}, "period: must be three numbers"),
        ({"period": (0, 0.9, 0)}, r"period = 0.9 is out of range: must be at least the length of the surface \(entry 1\)"),
    ],
)
def test_what_is_no_mesh_is_named(options, words):
    with pytest.raises(ValueError, match=words):
        carom.TriangleMesh(**{"triangles": CUBE} | options)


def test_balls_out_of_range_are_named():
    mesh = carom.TriangleMesh(CUBE)
    for centers, radii, words in [
        ([0, 0], 1, r"centers has the shape \(2,\)"),
        ([[0, 0, 0], [0, np.inf, 0]], 1, "centers = inf is out of range"),
        ([0, 0, 0], [1, 2], "radii has the shape"),
        ([[0, 0, 0]] * 3, [1, 1, -1], "radii = -1.0 is out of range: must be finite and > 0"),
    ]:
        with pytest.raises(ValueError, match=words):
            mesh.places(centers, radii)
