"""The books of a bed with a given restitution: kinetic, potential and stored energy and heats are constant."""

import pathlib

import numpy as np
import pytest
from conftest import lmp, thermo

BOOKS = (pathlib.Path(__file__).parent / "books.in").read_text()


def missed(tmp_path, **variables):
    """What the books miss over the heat, at each output."""
    table = thermo(lmp(BOOKS, tmp_path, **variables))
    heat = table["c_where[2]"] + table["c_where[3]"]
    assert heat[-1] > 0.01, "J: they met"
    return (table["v_total"] - table["v_total"][0]) / heat[-1], table


def test_without_friction_the_books_keep_to_the_step(tmp_path):
    """225 grains, a hundred steps in an impact. Where the heat of damping takes the mean of two forces and the speed of
    their step, they miss 1e-4."""
    off, _ = missed(tmp_path, mu=0, n=4000)
    print("off", np.abs(off).max())
    assert np.abs(off).max() < 1e-5


def test_with_friction_the_books_close_to_the_second_order(tmp_path):
    """They missed 3e-5 at any step while neither the merges of a full memory nor the change of the arms within a step were
    in the books."""
    off = {dt: np.abs(missed(tmp_path, mu=0.3, n=n, dt=dt)[0]).max() for dt, n in ((1e-5, 4000), (5e-6, 8000))}
    print("off", off)
    assert off[5e-6] < 3e-6
    assert off[5e-6] < 0.4 * off[1e-5]


@pytest.mark.slow
def test_a_hundred_thousand_steps_keep_the_books_to_a_millionth(tmp_path):
    """The fall, with four hundred steps in an impact."""
    off, _ = missed(tmp_path, mu=0.3, n=100000, dt=2.5e-6)
    print("off", np.abs(off).max())
    assert np.abs(off).max() < 1e-6


@pytest.mark.slow
def test_a_bed_comes_to_rest(tmp_path):
    """It falls, meets and comes to rest, with a hundred steps in an impact. At rest nothing is missed any more."""
    off, table = missed(tmp_path, mu=0.3, n=100000)
    print("off", np.abs(off).max(), "at rest", np.ptp(off[50:]), "motion", table["KinEng"][-1] / table["KinEng"].max())
    assert table["KinEng"][-1] < 1e-6 * table["KinEng"].max()
    assert np.abs(off).max() < 1.5e-5
    assert np.ptp(off[50:]) < 1e-6
