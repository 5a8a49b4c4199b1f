"""Special functions against closed forms, series and quadrature."""

import math

import numpy as np
import pytest

import carom
from carom import special

RATIOS = np.geomspace(1e-3, 1e3, 25)


def quadrature(f, n=4000):
    """The trapezoid rule over a quarter of a period of a smooth periodic function: exponentially exact."""
    t = (np.arange(n) + 0.5) * (math.pi / 2 / n)
    return f(t).mean() * math.pi / 2


@pytest.mark.parametrize("ratio", [0.05, 0.5, 1.0, 3.0])
def test_complete_integrals_are_integrals(ratio):
    def delta(t):
        return np.sqrt(np.cos(t) ** 2 + ratio**2 * np.sin(t) ** 2)

    assert special.k(ratio) == pytest.approx(quadrature(lambda t: 1 / delta(t)), rel=1e-13)
    assert special.e(ratio) == pytest.approx(quadrature(delta), rel=1e-13)
    assert special.d(ratio) == pytest.approx(quadrature(lambda t: np.sin(t) ** 2 / delta(t)), rel=1e-13)
    assert special.b(ratio) == pytest.approx(quadrature(lambda t: np.cos(t) ** 2 / delta(t)), rel=1e-13)


def test_legendres_relation():
    kc = np.linspace(0.05, 0.95, 19)
    k, e = special.k(kc), special.e(kc)
    other = np.sqrt(1 - kc**2)
    kk, ee = special.k(other), special.e(other)
    np.testing.assert_allclose(e * kk + ee * k - k * kk, math.pi / 2, rtol=1e-14)


def test_incomplete_meets_complete():
    for one, all_ in [(special.inc_f, special.k), (special.inc_e, special.e), (special.inc_d, special.d)]:
        np.testing.assert_allclose(one(RATIOS, math.pi / 2), all_(RATIOS), rtol=1e-13)


def test_hypergeometric_closed_forms():
    x = np.linspace(0.01, 0.99, 50)
    np.testing.assert_allclose(special.hyp2f1(1, 1, 2, x), -np.log1p(-x) / x, rtol=1e-13)
    np.testing.assert_allclose(special.hyp2f1(0.5, 1, 1.5, x**2), np.arctanh(x) / x, rtol=1e-13)
    # 3F2(s, a, b; s + 1, c) with c = b is 2F1(s, a; s + 1).
    np.testing.assert_allclose(
        special.hyp3f2(0.6, 0.5, 1.2, 1.2, x), special.hyp2f1(0.6, 0.5, 1.6, x), rtol=1e-12
    )


def test_gamma():
    x = np.linspace(0.1, 20, 100)
    np.testing.assert_allclose(special.gamma(x), [math.gamma(v) for v in x], rtol=1e-14)
    np.testing.assert_allclose(special.ln_gamma(x), [math.lgamma(v) for v in x], rtol=1e-13, atol=1e-15)


def test_shapes_and_kinds():
    assert isinstance(special.k(1), float)
    assert special.k([[1, 2, 3], [4, 5, 6]]).shape == (2, 3)
    assert special.inc_f([[1.0], [2.0]], [0.1, 0.2, 0.3]).shape == (2, 3)
    assert special.k(np.array([], dtype=float)).shape == (0,)
    every_other = np.arange(1.0, 9.0)[::2]
    np.testing.assert_array_equal(special.k(every_other), special.k(every_other.copy()))
    misaligned = np.frombuffer(b"x" + every_other.tobytes(), dtype=np.uint8)[1:].view(np.float64)
    assert not misaligned.flags.aligned
    np.testing.assert_array_equal(special.k(misaligned), special.k(every_other))
    assert special.k(np.float32(2.0)) == special.k(2.0)


def test_many_are_the_same_as_one():
    ratios = np.geomspace(0.1, 10, 20000)
    many = special.k(ratios)
    np.testing.assert_array_equal(many[::997], [special.k(r) for r in ratios[::997]])


def test_errors_name_field_value_and_place():
    ratios = np.ones(20000)
    ratios[[777, 15000]] = [-2.0, -3.0]
    with pytest.raises(ValueError, match="axis_ratio = -2") as caught:
        special.k(ratios)
    error = caught.value
    assert isinstance(error, carom.RangeError)
    assert (error.field, error.value, error.index) == ("axis_ratio", -2.0, 777)
    with pytest.raises(ValueError, match="phi"):
        special.inc_f(1.0, 2.0)
    with pytest.raises(carom.CaromError, match="infinite at 1"):
        special.hyp2f1(1, 1, 2, 1.0)
    with pytest.raises(ValueError, match="axis_ratio: must be real numbers"):
        special.k("round")
