"""Influence numbers instead of half-spaces, in `Solver` and `roll`."""

import copy

import numpy as np
import pytest

import carom

SIZE, CELLS = (2.4e-4, 2e-4), (20, 24)
STEEL = carom.MaterialPair(carom.Material(208e9, 0.3))
G, NU = 208e9 / 2.6, 0.3


def gap():
    x, y = carom.cells(CELLS, SIZE)
    return x**2 / 0.02 + y**2 / 0.03


def half_space():
    """Two equal half-spaces: integrals of the point loads' displacements over a rectangle (Love), offsets >= 0."""
    ny, nx = CELLS
    dx, dy = SIZE[0] / nx, SIZE[1] / ny
    x, y = np.meshgrid(np.arange(nx) * dx, np.arange(ny) * dy)
    blocks = {name: np.zeros(CELLS) for name in ("xx", "xy", "yx", "yy", "zz")}
    for s, a in ((1, x + dx / 2), (-1, x - dx / 2)):
        for t, b in ((1, y + dy / 2), (-1, y - dy / 2)):
            r = np.hypot(a, b)
            # integrals of y^2/r^3 and x^2/r^3 are a asinh(b/a) and b asinh(a/b), their sum that of 1/r
            of_x, of_y = a * np.arcsinh(b / np.abs(a)), b * np.arcsinh(a / np.abs(b))
            blocks["zz"] += s * t * (1 - NU) * (of_x + of_y)
            blocks["xx"] += s * t * ((1 - NU) * of_x + of_y)
            blocks["yy"] += s * t * (of_x + (1 - NU) * of_y)
            blocks["xy"] += -s * t * NU * r
    blocks["yx"] = blocks["xy"]
    blocks["xy"][0, :] = blocks["xy"][:, 0] = 0.0  # odd, but for round-off
    return {name: block / (np.pi * G) for name, block in blocks.items()}


def whole(blocks):
    """All offsets from those >= 0."""
    ny, nx = CELLS
    rows, columns = np.arange(1 - ny, ny), np.arange(1 - nx, nx)
    signs = np.sign(rows)[:, None] * np.sign(columns)[None, :]
    full = {name: block[np.ix_(abs(rows), abs(columns))] for name, block in blocks.items()}
    for name in ("xy", "yx"):
        full[name] = full[name] * signs
    return full


@pytest.mark.parametrize("blocks", [half_space(), whole(half_space())], ids=["quarter", "whole"])
def test_half_spaces_by_their_numbers(blocks):
    own = carom.Solver(gap(), SIZE, STEEL, 0.3)
    table = carom.Solver(gap(), SIZE, STEEL, 0.3, influence=blocks)
    for solver in (own, table):
        solver.step(F_z=2.0)
        solver.step(F_x=0.3, eta=2e-8, omega=1e-4)
    for name in ("F_x", "F_y", "F_z", "M_z", "zeta", "xi"):
        want = getattr(own.summary(), name)
        assert getattr(table.summary(), name) == pytest.approx(want, rel=1e-6, abs=1e-12)
    assert np.array_equal(own.cells, table.cells)
    drives = dict(F_z=2.0, creepage=[1e-4, 1e-3], spin=2.0)
    rows = [carom.roll(gap(), SIZE, STEEL, 0.3, **drives, influence=of).rows for of in (None, blocks)]
    assert rows[1].F_x == pytest.approx(rows[0].F_x, rel=1e-6)
    assert rows[1].M_z == pytest.approx(rows[0].M_z, rel=1e-6)


def test_copies_keep_the_numbers():
    blocks = {"zz": half_space()["zz"]}
    solver = carom.Solver(gap(), SIZE, STEEL, 0.0, influence=blocks)
    solver.step(F_z=2.0)
    other = copy.deepcopy(solver)
    assert np.array_equal(other.influence["zz"], blocks["zz"]) and "zz" in repr(other)
    assert other.step(F_z=1.9) == solver.step(F_z=1.9)
    with pytest.raises(ValueError, match="unknown beside influence numbers"):
        solver.stress(0.0, 0.0, 1e-5)


def test_a_softer_table_is_softer():
    blocks = {"zz": 2 * half_space()["zz"]}
    forces = [carom.Solver(gap(), SIZE, STEEL, 0.0, influence=of).step(zeta=1e-7).F_z for of in (None, blocks)]
    assert forces[0] == pytest.approx(2 * forces[1], rel=1e-8)


@pytest.mark.parametrize(
    ("blocks", "told"),
    [
        ({}, "influence is empty"),
        ({"zz": 1.0}, r"influence\['zz'\] has 0 dimensions"),
        ({"zz": np.ones((3, 3))}, "3 columns and 3 rows: must have 24 and 20, or 47 and 39"),
        ({"ww": np.ones(CELLS)}, "its name must be one of xx"),
        ({"zz": np.full(CELLS, np.nan)}, "row 1, column 1 is NaN"),
        ({"zz": half_space()["zz"]}, "displacement u of a cell under its own traction is 0"),
        ({**half_space(), "xz": np.full(CELLS, 1e-17)}, "xz is 0.00000000000000001 at 0 columns"),
        ({**half_space(), "yx": -half_space()["yx"]}, "equals the converse"),
        ({**half_space(), "zz": half_space()["zz"] - 0.7 * half_space()["zz"][0, 0] * (np.indices(CELLS).sum(0) == 0)}, "positive definite"),
    ],
)
def test_wrong_numbers_are_refused(blocks, told):
    with pytest.raises((ValueError, carom.CaromError), match=told):
        carom.Solver(gap(), SIZE, STEEL, 0.3, influence=blocks)


def test_a_plate_and_numbers_exclude_each_other():
    plate = carom.Plate(*SIZE, 1e-4)
    with pytest.raises(ValueError, match="plate and influence"):
        carom.Solver(gap(), SIZE, STEEL, 0.0, plate=plate, influence={"zz": half_space()["zz"]})
