"""Options that a body, many impacts, cases and pictures take."""

import math
import pathlib

import carom
import numpy as np
import pytest

STEEL = carom.Material(208e9, 0.3)
EXAMPLES = pathlib.Path(__file__).parents[3] / "examples"


def test_a_density_gives_the_mass_of_a_solid_body():
    assert carom.sphere(0.01, STEEL, density=7850).mass == pytest.approx(7850 * 4 / 3 * math.pi * 1e-6, rel=1e-15)
    assert carom.Body("box", [1, 2, 3], STEEL, density=2).mass == pytest.approx(12, rel=1e-15)
    tube = carom.Body("cylinder", [0.1, 2], STEEL, density=1000)
    assert tube.mass == pytest.approx(1000 * math.pi * 0.01 * 2, rel=1e-15)
    assert eval(repr(tube), {**vars(carom), "carom": carom}) == tube


@pytest.mark.parametrize(
    ("call", "part"),
    [
        (lambda: carom.sphere(0.01, STEEL), "`mass` or `density`"),
        (lambda: carom.sphere(0.01, STEEL, 1.0, density=7850), "mass and density"),
        (lambda: carom.sphere(0.01, STEEL, density=-1), "density = -1"),
        (lambda: carom.sphere(0.01, STEEL, density=math.nan), "density"),
        (lambda: carom.sphere(0.01, STEEL, density="heavy"), "density"),
        (lambda: carom.sphere(0.01, STEEL, density=7850, hollow=True), "solid"),
        (lambda: carom.Body("plane", [], STEEL, density=7850), "no volume"),
    ],
)
def test_a_density_that_does_not_fit_is_refused_by_name(call, part):
    with pytest.raises((ValueError, TypeError), match=part):
        call()


def test_many_impacts_take_many_static_frictions():
    ball, floor = carom.sphere(0.01, STEEL, 0.033), carom.plane(STEEL)
    velocity = (0.4, 0, -0.5)
    resting = [0.2, 0.3, 0.6]
    many = carom.collide_many(ball, floor, 0.2, static_friction=resting, body_1_velocity=velocity)
    alone = [carom.collide(ball.moving(velocity), floor, 0.2, static_friction=one) for one in resting]
    assert list(many.R_x) == [one.R_x for one in alone] and len(set(many.R_x)) == 3
    one = carom.collide_many(ball, floor, [0.2, 0.2], static_friction=0.3, body_1_velocity=velocity)
    assert list(one.R_x) == [alone[1].R_x] * 2
    with pytest.raises(ValueError, match="same length"):
        carom.collide_many(ball, floor, [0.2, 0.1], static_friction=resting, body_1_velocity=velocity)
    with pytest.raises(ValueError, match="static_friction"):
        carom.collide_many(ball, floor, 0.2, static_friction=[0.3, 0.1], body_1_velocity=velocity)
    with pytest.raises(ValueError, match="static_friction"):
        carom.collide_many(ball, floor, carom.SlipSpeedFriction(0.1, 0.1, 1.0), static_friction=resting)


def test_a_case_may_be_a_text_or_a_dict():
    import tomllib

    for name, compute in [
        ("steel_balls", carom.cases.impact),
        ("hertz_roller", carom.cases.hertz),
        ("scene_rolls_to_rest", carom.cases.scene),
        ("roll_roller", carom.cases.roll),
        ("history_loop", carom.cases.history),
        ("shell_bellows", carom.cases.shell),
    ]:
        path = EXAMPLES / f"{name}.toml"
        text = path.read_text()
        assert compute(path) == compute(text) == compute(tomllib.loads(text)), name
    numbers = tomllib.loads((EXAMPLES / "steel_balls.toml").read_text())
    numbers["contact"]["friction"] = np.float64(0.1)
    numbers["body_1"]["velocity"] = np.array([0.7, 0, -2.0])
    assert carom.cases.impact(numbers).friction == 0.1


@pytest.mark.parametrize(
    ("case", "part"),
    [
        ({"body_1": {"shape": "egg"}}, "shape"),
        ({"body_1": object()}, "object"),
        ("friction = 0.1", "the case given"),
        (7, "dict"),
        (b"x", "bytes"),
        ("no_such_file.toml", "no_such_file"),
    ],
)
def test_what_is_no_case_is_refused(case, part):
    with pytest.raises((TypeError, ValueError, OSError), match=part):
        carom.cases.impact(case)


def test_pictures_take_ax_and_show_their_names_only():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    figure, ax = pyplot.subplots()
    assert carom.plot.restitution(1.5, np.linspace(0.1, 5, 9), ax=ax) is ax
    with pytest.raises(TypeError, match="both given"):
        carom.plot.restitution(1.5, [1.0, 2.0], axes=ax, ax=ax)
    pyplot.close(figure)
    assert dir(carom.plot) == sorted(carom.plot.__all__)
