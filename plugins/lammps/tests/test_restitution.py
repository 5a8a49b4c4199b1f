"""The restitution that is given is the one that is got: two grains, walls, curved walls, frozen grains, rings."""

import math

import pytest
from test_impact import restitution

COEFF = "young 1e9 poisson 0.3 friction 0.1"


def style(e, law="fixed-direction", more=""):
    return [f"pair_style carom law {law} {more}", f"pair_coeff * * {COEFF} restitution {e}"]


@pytest.mark.parametrize("e", [0.1, 0.3, 0.5, 0.7, 0.9, 1.0])
def test_two_grains(host, e):
    _, normal = restitution(host, style(e), 0.3, [0.5, 4.0], 50)
    assert normal == pytest.approx([e, e], abs=1e-3)


def test_with_torsion_rolling_and_other_radii(host):
    coeff = f"pair_coeff * * {COEFF} restitution 0.4 rolling 1e4 1 0.05"
    _, normal = restitution(host, ["pair_style carom torsion yes energy yes", coeff], 0.3, [1.0], 50, radii=(0.3, 0.9))
    assert normal == pytest.approx([0.4], abs=1e-3)


def test_rings(host):
    _, normal = restitution(host, style(0.6, "rings"), 0.3, [1.0], 100)
    assert normal == pytest.approx([0.6], abs=2e-3)


SETTINGS = """
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -2 2 -2 2 -2 2
create_box 1 box
"""


def speed_after(host, commands, velocity, steps=4000):
    """The speed along z, over `velocity`, of grain 1 of radius 0.5 a little above z = 0.5, after an impact."""
    host.commands_string(SETTINGS)
    host.create_atoms(1, [1], [1], [0.0, 0.0, 0.5 + 1e-9], [0.0, 0.0, -velocity])
    host.commands_list(["set atom 1 diameter 1", "set group all density 2500", "neighbor 0.1 bin"])
    mass = 2500 * math.pi / 6
    stiffness = 4 / 3 * 1e9 / (2 * 0.91) * math.sqrt(0.5)
    dt = 2.943275 * (mass**2 / (stiffness**2 * velocity)) ** 0.2 / 60
    host.commands_list([*commands, "group mover id 1", "fix move mover nve/sphere", f"timestep {dt}", "run 300"])
    return host.numpy.extract_atom("v")[0, 2] / velocity


@pytest.mark.parametrize(
    "wall",
    ["plane 0 0 0 0 0 1", "sphere 0 0 20 20 inside", "cylinder 0 0 20 1 0 0 20 inside"],
)
@pytest.mark.parametrize("velocity", [1e-4, 1e-2])
def test_walls(host, wall, velocity):
    commands = [
        "pair_style carom",
        f"pair_coeff * * {COEFF}",
        f"fix wall all wall/carom {wall} young 1e9 poisson 0.3 friction 0.3 restitution 0.45",
    ]
    assert speed_after(host, commands, velocity) == pytest.approx(0.45, abs=1e-3)


def test_a_frozen_grain_is_as_heavy_as_a_wall(host):
    host.commands_string(SETTINGS)
    host.create_atoms(2, [1, 2], [1, 1], [0, 0, 0.5 + 1e-9, 0, 0, -0.5], [0, 0, -1e-3, 0, 0, 0])
    mass = 2500 * math.pi / 6
    stiffness = 4 / 3 * 1e9 / (2 * 0.91) * math.sqrt(0.25)
    dt = 2.943275 * (mass**2 / (stiffness**2 * 1e-3)) ** 0.2 / 60
    host.commands_list(
        [
            "set group all diameter 1",
            "set group all density 2500",
            "neighbor 0.1 bin",
            *style(0.45),
            "group mover id 1",
            "group still id 2",
            "fix still still freeze",
            "fix move mover nve/sphere",
            f"timestep {dt}",
            "run 300",
        ]
    )
    tags = list(host.numpy.extract_atom("id")[:2])
    assert host.numpy.extract_atom("v")[tags.index(1), 2] / 1e-3 == pytest.approx(0.45, abs=1e-3)


@pytest.mark.parametrize(
    ("words", "told"),
    [
        ("restitution 0", "restitution = 0 is out of range: must be from 0.01 to 1"),
        ("restitution 1.2", "restitution = 1.2 is out of range"),
        ("restitution nan", "restitution"),
        ("restitution 0.5 damping 1e-4", "damping and restitution are both given"),
        ("damping 1e-4 restitution 0.5", "damping and restitution are both given"),
        ("restitution", "restitution requires a value"),
    ],
)
def test_wrong_restitutions_are_named(host, words, told):
    host.commands_string(SETTINGS)
    host.command("pair_style carom")
    with pytest.raises(Exception, match=told):
        host.command(f"pair_coeff * * {COEFF} {words}")
