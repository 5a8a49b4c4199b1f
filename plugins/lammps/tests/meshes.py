"""Surfaces of triangles, and their STL files."""

import pathlib

import numpy as np


def box(low, high):
    """Twelve triangles, in the order of the sides -z, -x, +x, -y, +y, +z."""
    low, high = np.array(low, dtype=float), np.array(high, dtype=float)
    found = []
    for axis, side in ((2, 0), (0, 0), (0, 1), (1, 0), (1, 1), (2, 1)):
        one, two = [k for k in range(3) if k != axis]
        corners = []
        for a, b in ((0, 0), (1, 0), (1, 1), (0, 1)):
            corner = np.empty(3)
            corner[axis] = (low, high)[side][axis]
            corner[one], corner[two] = (low, high)[a][one], (low, high)[b][two]
            corners.append(corner)
        found += [[corners[0], corners[1], corners[2]], [corners[0], corners[2], corners[3]]]
    return np.array(found)


def sheet(xs, ys, height=lambda x, y: 0.0):
    """A sheet over a grid, two triangles for each of its cells."""
    found = []
    at = lambda x, y: (x, y, height(x, y))
    for x, x_next in zip(xs, xs[1:]):
        for y, y_next in zip(ys, ys[1:]):
            found.append([at(x, y), at(x_next, y), at(x_next, y_next)])
            found.append([at(x, y), at(x_next, y_next), at(x, y_next)])
    return np.array(found, dtype=float)


def tube(radius, low, high, count):
    """A prism about the axis y, whose faces touch the cylinder of this radius in their middle."""
    turn = (np.arange(count + 1) % count + 0.5) * (2 * np.pi / count)
    away = radius / np.cos(np.pi / count)
    rim = [np.stack([away * np.sin(turn), np.full(count + 1, y), -away * np.cos(turn)], 1) for y in (low, high)]
    found = []
    for k in range(count):
        a, b, c, d = rim[0][k], rim[0][k + 1], rim[1][k + 1], rim[1][k]
        found += [[a, b, c], [a, c, d]]
    return np.array(found)


def text(triangles, name="made"):
    """A text with all digits."""
    lines = [f"solid {name}"]
    for corners in triangles:
        lines += ["  facet normal 0 0 0", "    outer loop"]
        lines += ["      vertex " + " ".join(f"{number:.17g}" for number in corner) for corner in corners]
        lines += ["    endloop", "  endfacet"]
    return "\n".join([*lines, f"endsolid {name}", ""])


def binary(triangles, count=None):
    """Bytes in single precision; `count` is what the head states, if not the truth."""
    records = np.zeros(len(triangles), dtype=[("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("more", "<u2")])
    records["corners"] = triangles
    return bytes(80) + np.uint32(len(triangles) if count is None else count).tobytes() + records.tobytes()


def write(path, triangles):
    pathlib.Path(path).write_text(text(triangles))
