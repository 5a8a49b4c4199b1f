"""The log tells where contacts leave the theory, once in a run, in the words of the library."""

import math
import re
import struct
from pathlib import Path

import pytest
from conftest import Failed, lmp

RADIUS, DENSITY = 0.5, 1000.0
MASS = DENSITY * math.pi / 6
YOUNG, POISSON = 1e7, 0.3
# Of two equal materials, as here; a wall has the same.
MODULUS = YOUNG / (2 * (1 - POISSON**2))
LARGE, DEEP = "large contact: a/R exceeds 0.1", "the approach exceeds a tenth of the radius"
YIELDS, WAVES = "yields: the greatest pressure", "elastic waves would carry away"

BALL = """newton off
plugin load ${plugin}
units si
atom_style sphere
boundary f f f
comm_modify vel yes
region box block -2 2 -2 2 -2 3
create_box 1 box
create_atoms 1 single 0 0 0.51
set group all diameter 1 density 1000
pair_style carom
pair_coeff 1 1 young 1e7 poisson 0.3 friction 0.1 ${more}
neighbor 0.01 bin
"""
FLOOR = "fix floor all wall/carom plane 0 0 0 0 0 1 young 1e7 poisson 0.3 friction 0.1 {}\n"


def approach(radius, mass, velocity):
    """Of an impact on a wall, or of two bodies with their relative radius and mass, by Hertz."""
    return (15 * mass * velocity**2 / (16 * MODULUS * math.sqrt(radius))) ** 0.4


def speed(radius, mass, deep):
    return math.sqrt(16 * MODULUS * math.sqrt(radius) * deep**2.5 / (15 * mass))


def said(folder, script, words, ranks=1, more=""):
    """Who says these words in the log, and the number at their end."""
    lmp(script, folder, ranks=ranks, more=more)
    log = (folder / "log.lammps").read_text()
    lines = [line for line in log.split("\n") if line.startswith("WARNING: ") and words in line]
    told = [re.match(r"WARNING: (.*?): .*: (?:it is|about) (\S+)", line).groups() for line in lines]
    return [(who, float(number)) for who, number in told]


def fall(velocity, floor="", more=""):
    steps = max(400, math.ceil(0.03 / velocity / 1e-4))
    step = f"velocity all set 0.1 0 -{velocity}\nfix move all nve/sphere\ntimestep 1e-4\nrun {steps}\n"
    return BALL + FLOOR.format(floor) + step


def test_an_impact_on_a_wall_is_told_with_its_largest_contact(tmp_path):
    # a^2 = R zeta.
    fast, slow = (speed(RADIUS, MASS, ratio**2 * RADIUS) for ratio in (0.13, 0.099))
    for ranks in (1, 2):
        ((who, number),) = said(tmp_path, fall(fast), LARGE, ranks=ranks)
        assert who == "fix floor wall/carom" and number == pytest.approx(0.13, rel=5e-3)
    assert said(tmp_path, fall(slow), LARGE) == said(tmp_path, fall(fast), DEEP) == []
    deep = speed(RADIUS, MASS, 0.12 * RADIUS)
    assert said(tmp_path, fall(deep), DEEP)[0] == ("fix floor wall/carom", pytest.approx(0.12, rel=5e-3))


def test_two_grains_of_two_sizes_are_judged_by_the_smaller(tmp_path):
    small, large = 0.2, 0.4
    radius, mass = 1 / (1 / small + 1 / large), 4 / 3 * math.pi * DENSITY / (1 / small**3 + 1 / large**3)
    velocity = speed(radius, mass, (0.14 * small) ** 2 / radius)
    two = BALL.replace("create_atoms 1 single 0 0 0.51\n", "create_atoms 1 single 0 0 0\ncreate_atoms 1 single 0 0.601 0\n")
    two = two.replace("set group all diameter 1", "set atom 1 diameter 0.4 density 1000\nset atom 2 diameter 0.8")
    two += f"group high id 2\nvelocity high set 0 -{velocity} 0\nfix move all nve/sphere\ntimestep 1e-4\nrun 400\n"
    for ranks in (1, 2):
        assert said(tmp_path, two, LARGE, ranks=ranks) == [("pair carom", pytest.approx(0.14, rel=5e-3))]


def test_yield_is_told_where_a_yield_stress_is_given(tmp_path):
    velocity = 0.5
    # p = (2/pi) E* sqrt(zeta/R), against 1.6 Y.
    pressure = 2 / math.pi * MODULUS * math.sqrt(approach(RADIUS, MASS, velocity) / RADIUS)
    weak, strong = (f"yield {pressure / 1.6 / ratio}" for ratio in (1.2, 0.98))
    for floor, ball in ((weak, ""), ("", weak), (weak, strong), (strong, weak)):
        told = said(tmp_path, fall(velocity, floor), YIELDS, more=ball)
        assert told == [("fix floor wall/carom", pytest.approx(1.2, rel=5e-3))]
    assert said(tmp_path, fall(velocity, strong), YIELDS, more=strong) == said(tmp_path, fall(velocity), YIELDS) == []


def test_waves_are_told_of_grains_without_damping(tmp_path):
    # (3.2) with the coefficient of Lamb's integral for nu = .3; the wall counts as of the grain's material.
    share = 1.131809722782 * (0.05 / math.sqrt(YOUNG / DENSITY)) ** 0.6
    assert share > 0.01
    assert said(tmp_path, fall(0.05), WAVES) == [("fix floor wall/carom", pytest.approx(100 * share, rel=5e-3))]
    assert said(tmp_path, fall(0.05), WAVES, more="damping 1e-6") != []
    # The damping of the wall is that of its contacts.
    assert said(tmp_path, fall(0.05, "damping 1e-6"), WAVES) == []


def press(overlap, more=""):
    """A wall moves into a ball that is held, from a gap of .01 with .1 m/s: no impact that would be large."""
    steps = round((0.01 + overlap) / 0.1 / 1e-4)
    return BALL + FLOOR.format("velocity 0 0 0.1") + f"timestep 1e-4\n{more}run {steps}\n"


def test_a_contact_that_no_impact_made_is_looked_at(tmp_path):
    ((who, number),) = said(tmp_path, press(0.02), LARGE)
    # In one of ten steps.
    assert who == "fix floor wall/carom" and 0.199 < number <= 0.2
    assert said(tmp_path, press(0.0049), LARGE) == []
    assert said(tmp_path, press(0.0052), LARGE) != []


def test_a_limit_is_told_early_and_again_if_it_is_exceeded_twice_as_far(tmp_path):
    often = "neigh_modify delay 0 every 100 check no\n"
    for overlap, end in ((0.0195, []), (0.03, [0.245])):
        told = [number for _, number in said(tmp_path, press(overlap, often), LARGE)]
        assert 0.1 < told[0] < 0.11 and told[1:] == pytest.approx(end, rel=5e-3)


GO_ON = """newton off
plugin load ${plugin}
read_restart fallen
comm_modify vel yes
"""


def test_the_yield_stress_goes_on_after_a_restart(tmp_path):
    weak = "yield 1e3"
    lmp(BALL + "fix move all nve/sphere\ntimestep 1e-4\nrun 1\nwrite_restart fallen\n", tmp_path, more=weak)
    rest = fall(0.05).split("neighbor 0.01 bin\n")[1]
    assert said(tmp_path, GO_ON + "neighbor 0.01 bin\n" + rest, YIELDS)[0][0] == "fix floor wall/carom"
    assert said(tmp_path, fall(0.05), YIELDS) == []


def test_a_restart_file_of_another_version_is_refused(tmp_path):
    lmp(BALL + "run 0\nwrite_restart fallen\n", tmp_path, more="")
    data = (tmp_path / "fallen").read_bytes()
    version = struct.pack("<I", 7003)
    assert data.count(version) == 1
    (tmp_path / "fallen").write_bytes(data.replace(version, struct.pack("<I", 1)))
    with pytest.raises(Failed, match="written by another version of carom"):
        lmp(GO_ON + "run 0\n", tmp_path)


def test_one_line_names_the_worst_style(tmp_path):
    """A ball that falls on a wall, and two grains beside it that meet faster or slower."""
    for of_wall, of_pair, expected in ((0.13, 0.15, ("pair carom", 0.15)), (0.14, 0.12, ("fix floor wall/carom", 0.14))):
        fast = speed(RADIUS, MASS, of_wall**2 * RADIUS)
        meet = speed(RADIUS / 2, MASS / 2, (of_pair * RADIUS) ** 2 / (RADIUS / 2))
        three = BALL.replace("0 0 0.51\n", "-1.3 0 0.51\ncreate_atoms 1 single 0.2 0 2\ncreate_atoms 1 single 1.21 0 2\n")
        three += FLOOR.format("") + f"group first id 1\ngroup third id 3\nvelocity first set 0 0 -{fast}\nvelocity third set -{meet} 0 0\n"
        # The list of neighbors is built once.
        three += "neigh_modify delay 0 every 100000 check no\nneighbor 0.3 bin\nfix move all nve/sphere\ntimestep 1e-4\nrun 1000\n"
        for ranks in (1, 2):
            assert said(tmp_path, three, LARGE, ranks=ranks) == [(expected[0], pytest.approx(expected[1], rel=5e-3))]


#: What each style of the plugin does about the limits of the theory; the first two are asked by the tests above.
STYLES = {
    "carom": "tells",
    "wall/carom": "tells",
    "CAROM_KEEP": "keeps contacts that the pair style has made",
    "CAROM_RESTORE": "keeps contacts that a restart file holds",
    "carom/energy": "adds up what contacts store",
    "carom/heat/atom": "adds up what contacts lost",
}


def test_every_style_is_known_to_tell_or_to_load_nothing():
    text = (Path(__file__).parent.parent / "src/plugin.cpp").read_text(encoding="utf-8")
    assert sorted(re.findall(r'plugin\.name = "([^"]+)"', text)) == sorted(STYLES)
