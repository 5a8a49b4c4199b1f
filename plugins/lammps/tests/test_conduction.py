"""Heat that contacts conduct, through fix heat/flow of the host."""

import pathlib

import numpy as np
import pytest
from conftest import Failed, dump, lmp, thermo

HERE = pathlib.Path(__file__).parent
BOX = (HERE / "box.in").read_text()
WARM = "fix warmth all property/atom temperature heatflow ghost yes\n"

# Two grains that are held where they touch: R 10 and 5 mm, overlap 20 um.
TWO = """newton {newton}
plugin load ${{plugin}}
units si
atom_style sphere
atom_modify map array
boundary f f f
comm_modify vel yes
processors * 1 1
region box block -1 1 -1 1 -1 1
create_box 1 box
fix warmth all property/atom temperature heatflow ghost yes
create_atoms 1 single -0.00999 0 0
create_atoms 1 single 0.00499 0 0
set atom 1 diameter 0.02 density 2000
set atom 2 diameter 0.01 density 3000
set atom 1 temperature 300
set atom 2 temperature 400
pair_style carom
pair_coeff 1 1 young 1e7 poisson 0.3 friction 0.5 conductivity {conductivity}
{wall}
fix flow all heat/flow constant 500
timestep {dt}
compute warmth all property/atom temperature mass
thermo 1000000
run {steps}
write_dump all custom end.dump id c_warmth[1] c_warmth[2] modify format float %.17g sort id
"""
MASS = np.array([2000 * 4 / 3 * np.pi * 0.01**3, 3000 * 4 / 3 * np.pi * 0.005**3])


@pytest.mark.parametrize("newton, ranks", [("off", 1), ("on", 2), ("off", 2)])
def test_two_grains_come_to_one_temperature_exponentially(tmp_path, newton, ranks):
    """T_2 - T_1 falls with 2 k a (1/(m_1 c) + 1/(m_2 c)), a^2 = R zeta, 1/R = 1/R_1 + 1/R_2."""
    k, dt, steps = 50.0, 1e-3, 100_000
    radius = 1 / (1 / 0.01 + 1 / 0.005)
    rate = 2 * k * np.sqrt(radius * 2e-5) * np.sum(1 / (500 * MASS))
    # Steps of a thousandth of the time in which the difference falls are too long for the exponential.
    dt *= 5e-6 / (rate * dt)
    lmp(TWO.format(newton=newton, conductivity=k, dt=dt, steps=steps, wall=""), tmp_path, ranks=ranks)
    found = dump(tmp_path / "end.dump")[:, 1]
    mean = MASS @ [300, 400] / MASS.sum()
    difference = 100 * np.exp(-rate * dt * steps)
    wanted = mean + difference * np.array([-MASS[1], MASS[0]]) / MASS.sum()
    assert np.abs(found - wanted).max() < 1e-6 * 100 * 2
    # The steps of fix heat/flow themselves.
    stepped = 100 * (1 - rate * dt) ** steps
    assert found[1] - found[0] == pytest.approx(stepped, rel=1e-10)


@pytest.mark.parametrize(
    "floor, curvature",
    [
        ("plane 0 0 -0.00998 0 0 1", 0),
        ("cylinder -0.00999 0 -0.02998 0 1 0 0.02 outside", 1 / 0.02),
        ("cylinder -0.00999 0 0.04002 0 1 0 0.05 inside", -1 / 0.05),
    ],
)
def test_a_wall_of_constant_temperature_warms_a_grain(tmp_path, floor, curvature):
    """Grain 1 also lies 20 um deep on a floor: the wall says how much heat it gave. a^2 is the overlap over the mean
    relative curvature."""
    wall = (
        f"fix floor all wall/carom {floor} rigid friction 0.1 conductivity 20 temperature 500\n"
        "thermo_style custom step f_floor[12]\nthermo_modify format float %.17g"
    )
    printed = lmp(TWO.format(newton="off", conductivity=0, dt=1e-3, steps=2000, wall=wall), tmp_path)
    given = thermo(printed)["f_floor[12]"][-1]
    found = dump(tmp_path / "end.dump")[:, 1]
    rate = 2 * 20 * np.sqrt(2e-5 / (1 / 0.01 + 0.5 * curvature)) / (500 * MASS[0])
    assert 500 - found[0] == pytest.approx(200 * (1 - rate * 1e-3) ** 2000, rel=1e-10)
    assert found[1] == 400
    assert given == pytest.approx(500 * MASS[0] * (found[0] - 300), rel=1e-9)


def test_unlike_grains_conduct_by_the_coefficient_of_their_pair(tmp_path):
    one = TWO.format(newton="off", conductivity=7, dt=1e-3, steps=1000, wall="")
    lmp(one, tmp_path)
    wanted = dump(tmp_path / "end.dump")
    pairs = "conductivity 5\npair_coeff 2 2 young 1e7 poisson 0.3 friction 0.5\npair_coeff 1 2 friction 0.5 conductivity 7\n"
    two = one.replace("create_box 1", "create_box 2").replace("conductivity 7\n", pairs)
    for place in ("-0.00999", "0.00499"):
        lmp(two.replace(f"create_atoms 1 single {place}", f"create_atoms 2 single {place}"), tmp_path)
        assert np.array_equal(dump(tmp_path / "end.dump"), wanted), place


BED = """set group all temperature 300
variable hot atom 300+100*(id%7)
set group all temperature v_hot
fix flow all heat/flow constant 700
compute warmth all property/atom temperature mass
variable stored atom 700*c_warmth[1]*c_warmth[2]
compute stored all reduce sum v_stored
compute least all reduce min c_warmth[1]
compute most all reduce max c_warmth[1]
variable square atom c_warmth[1]^2*c_warmth[2]
compute square all reduce sum v_square
thermo_style custom step c_stored c_least c_most c_square
thermo_modify norm no format float %.17g
thermo 500
"""


def bed(extra, **variables):
    """Grains that collide in a box without walls that conduct."""
    made = BOX.replace("set group all diameter 0.01\n", WARM + "set group all diameter 0.01\n")
    made = made.replace("friction", "conductivity 3000 friction", 1)
    walls = (HERE / "box_walls.in").read_text().replace("norm no format", "norm no line one format")
    return made + walls + BED + extra


@pytest.mark.parametrize("newton, ranks", [("off", 1), ("on", 2), ("off", 2)])
def test_the_heat_of_a_closed_bed_stays(tmp_path, newton, ranks):
    table = thermo(lmp(bed("run 3000\n"), tmp_path, dt=1e-5, shake=0.3, newton=newton, ranks=ranks))
    stored = table["c_stored"]
    assert np.abs(stored / stored[0] - 1).max() < 1e-9
    # Heat goes from the warmer to the colder.
    assert (np.diff(table["c_least"]) >= 0).all() and (np.diff(table["c_most"]) <= 0).all()
    squares = table["c_square"]
    assert (np.diff(squares) <= 0).all() and squares[-1] < 0.9999 * squares[0]


def test_temperatures_go_on_after_a_restart_bit_for_bit(tmp_path):
    """Conductivity is in the restart file, and temperatures by fix property/atom of the host."""
    made = TWO.format(newton="off", conductivity=50, dt=1e-3, steps=1000, wall="")
    lmp(made, tmp_path)
    whole = dump(tmp_path / "end.dump")
    lmp(made.replace("run 1000", "run 400\nwrite_restart half.restart"), tmp_path)
    go_on = made[made.index("fix flow") :].replace("run 1000", "run 600")
    lmp(
        "plugin load ${plugin}\ncomm_modify vel yes\nread_restart half.restart\n" + WARM + go_on,
        tmp_path,
    )
    assert (dump(tmp_path / "end.dump") == whole).all()
    assert whole[0, 1] > 300.1


def test_what_does_not_fit_is_refused_by_name(tmp_path):
    def refused(script, *parts):
        with pytest.raises(Failed) as error:
            lmp(script, tmp_path)
        assert all(part in str(error.value) for part in parts), str(error.value)[-500:]

    whole = TWO.format(newton="off", conductivity=5, dt=1e-3, steps=1, wall="")
    bare = "\n".join(line for line in whole.split("\n") if not any(word in line for word in ("warmth", "temperature", "flow")))
    refused(bare, "pair carom", "conductivity", "fix property/atom temperature heatflow")
    refused(whole.replace("conductivity 5", "conductivity -5"), "conductivity = -5", ">= 0")
    wall = "fix floor all wall/carom plane 0 0 -1 0 0 1 rigid friction 0.1 "
    for words, part in [("conductivity 5", "requires the temperature"), ("temperature 5", "requires conductivity")]:
        refused(TWO.format(newton="off", conductivity=5, dt=1e-3, steps=1, wall=wall + words), "fix floor", part)
