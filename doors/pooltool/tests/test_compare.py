"""The comparison draws, and its numbers are those of the README."""

import compare
import numpy as np


def test_the_curves_are_finite_and_meet_at_grazing_angles():
    for side in compare.SIDES:
        for model, _, _ in compare.models().values():
            angle, spin = compare.curves(model, side)
            assert np.isfinite(angle).all() and np.isfinite(spin).all()
            assert (np.abs(angle) < 90).all()


def test_the_mirror_of_running_side_is_running_side():
    model = compare.CaromLinear()
    angle, spin = compare.rebound(model, 30.0, 1.0)
    mirrored_angle, mirrored_spin = compare.rebound(model, -30.0, -1.0)
    assert np.isclose(angle, -mirrored_angle) and np.isclose(spin, -mirrored_spin)


def test_the_picture_is_drawn(tmp_path):
    path = tmp_path / "rebound.png"
    compare.draw(str(path))
    assert path.read_bytes().startswith(b"\x89PNG") and path.stat().st_size < 200_000
