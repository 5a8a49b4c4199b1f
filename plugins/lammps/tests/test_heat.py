"""Heat of each grain and of each contact."""

import pathlib

import numpy as np
import pytest
from conftest import dump, lmp, thermo

HERE = pathlib.Path(__file__).parent
BOX = (HERE / "box.in").read_text()
MADE, PAIRS = BOX[: BOX.index("pair_style")], BOX[BOX.index("pair_style") :]
WALLS = (HERE / "box_walls.in").read_text().replace("norm no format", "norm no line one format")
SUMS = """compute made all carom/heat/atom
compute sum all reduce sum c_made
compute most all reduce max c_made
thermo_style custom step ke c_where[2] c_where[3] c_sum c_most
thermo_modify norm no format float %.17g
thermo 1
"""


def heated(tmp_path, steps, ranks=1, **variables):
    """On several ranks grains would be created with other numbers."""
    lmp(MADE + "write_data grains.data\n", tmp_path)
    read = MADE[: MADE.index("region box")].replace("units si\n", "units si\nprocessors * 1 1\n") + "read_data grains.data\n"
    script = read + PAIRS + WALLS + SUMS + f"run {steps}\n"
    return thermo(lmp(script, tmp_path, ranks=ranks, dt=1e-5, shake=0.3, **variables))


@pytest.mark.parametrize(
    "law, newton", [("law fixed-direction", "off"), ("law fixed-direction torsion yes", "on"), ("law rings", "on")]
)
def test_the_heat_of_all_grains_is_that_of_the_books_in_each_step(tmp_path, law, newton):
    """Grains that collide with each other, with walls and with a moving floor, on one rank and on two. The books
    are sums over the run, so that a step is known to their round-off."""
    wholes = []
    for ranks in (1, 2):
        table = heated(tmp_path, 1500, law=law, newton=newton, ranks=ranks)
        books = table["c_where[2]"] + table["c_where[3]"]
        off = np.abs(table["c_sum"][1:] - np.diff(books)).max()
        assert off < 1e-14 * books[-1], (ranks, off / books[-1])
        assert books[-1] > 0.1 * table["KinEng"][0], "much became heat"
        wholes.append(table["c_sum"].sum())
    assert wholes[1] == pytest.approx(wholes[0], rel=1e-9)


def test_temperature_rises_by_the_heat_of_the_books(tmp_path):
    """Through fix add/heat and fix heat/flow of the host; newton on, where heat of ghosts comes back."""
    capacity = 700.0
    flow = f"""variable rate atom c_made/dt
fix warm all add/heat constant v_rate
fix flow all heat/flow constant {capacity}
compute warmth all property/atom temperature
variable stored atom {capacity}*mass*c_warmth
compute stored all reduce sum v_stored
thermo_style custom step c_where[2] c_where[3] c_stored
thermo_modify norm no format float %.17g
thermo 100
"""
    warm = "fix warmth all property/atom temperature heatflow ghost yes\nset group all temperature 0\n"
    box = BOX.replace("set group all diameter 0.01\n", warm + "set group all diameter 0.01\n")
    for ranks, newton in ((1, "off"), (2, "on"), (2, "off")):
        script = box + WALLS + SUMS + flow + "run 1500\n"
        table = thermo(lmp(script, tmp_path, dt=1e-5, shake=0.3, ranks=ranks, newton=newton))
        books = table["c_where[2]"] + table["c_where[3]"]
        assert books[-1] > 0
        assert np.allclose(table["c_stored"], books, rtol=1e-12, atol=1e-13 * books[-1]), (ranks, newton)


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
create_atoms 1 single -0.29999 0 0
create_atoms 1 single 0.29999 0 0
set group all diameter 0.6 density 1000
group right id 2
set group right omega 40 3 2
velocity all set 0 0.01 0
pair_style carom torsion yes energy yes
pair_coeff * * young 1e7 poisson 0.3 friction 0.4 damping 1e-3
neighbor 0.01 bin
fix move all nve/sphere
{walls}
compute where all carom/energy
compute made all carom/heat/atom
compute each all pair/local p11 p12 cutoff radius
compute contact all reduce sum c_each[1] c_each[2] inputs local
compute sum all reduce sum c_made
group left id 1
compute first left reduce sum c_made
compute second right reduce sum c_made
thermo_style custom step c_where[2] c_where[3] c_sum c_contact[1] c_contact[2] c_first c_second
thermo_modify norm no format float %.17g
thermo 1
timestep 1e-5
"""


@pytest.mark.parametrize("newton, ranks", [("off", 1), ("on", 2), ("off", 2)])
def test_two_grains_share_the_heat_of_their_contact(tmp_path, newton, ranks):
    """Their contact spans the border of the ranks. Friction, twist and damping heat at once. As it slides, the heat of
    friction is ahead of that of damping by the force times the lead."""
    table = thermo(lmp(TWO.format(newton=newton, walls="") + "run 200\n", tmp_path, ranks=ranks))
    books = table["c_where[2]"] + table["c_where[3]"]
    assert table["c_where[2]"][-1] > 0 and table["c_where[3]"][-1] != 0 and books[-1] > 0
    bound = 1e-14 * books[-1]
    assert np.abs(table["c_contact[1]"][1:] - np.diff(books)).max() < bound
    assert np.abs(table["c_contact[2]"] - books).max() < 1e-12 * books[-1]
    assert np.abs(table["c_first"] - table["c_second"]).max() < bound
    assert np.abs(table["c_first"][1:] - 0.5 * np.diff(books)).max() < bound


def test_a_contact_keeps_its_heat_across_restarts(tmp_path):
    """A restart file is written before the host prints: the contacts are then packed."""
    script = TWO.format(newton="off", walls="")
    whole = thermo(lmp(script + "restart 50 heat.*\nrun 100\n", tmp_path))
    plain = thermo(lmp(script + "run 100\n", tmp_path))
    assert np.array_equal(whole["c_contact[1]"], plain["c_contact[1]"])
    tail = script[script.index("neighbor 0.01 bin") :]
    again = "newton off\nplugin load ${plugin}\natom_modify map array\nread_restart heat.50\ncomm_modify vel yes\n" + tail
    rest = thermo(lmp(again + "run 50\n", tmp_path))
    for column in ("c_contact[1]", "c_contact[2]"):
        assert np.array_equal(rest[column], whole[column][50:]), column


def test_a_grain_gets_its_share_of_the_heat_at_a_wall(tmp_path):
    wall = "fix floor all wall/carom plane 0 0 -0.2999 0 0 1 rigid friction 0.3 damping 1e-3\n"
    script = TWO.format(newton="off", walls=wall).replace("set group right omega 40 3 2", "displace_atoms right move 0.1 0 0\nset group right omega 4 3 2")
    for share in (None, 1, 0.25, 0):
        keyword = "" if share is None else f" wall {share}"
        table = thermo(lmp(script.replace("all carom/heat/atom", "all carom/heat/atom" + keyword) + "run 100\n", tmp_path))
        books = table["c_where[2]"] + table["c_where[3]"]
        assert table["c_where[2]"][-1] > 0 and table["c_where[3]"][-1] != 0 and books[-1] > 0
        part = 1 if share is None else share
        assert np.abs(table["c_sum"][1:] - part * np.diff(books)).max() < 1e-14 * books[-1]


def test_a_group_sees_only_its_own_heat(tmp_path):
    script = TWO.format(newton="off", walls="").replace("compute made all", "compute made right")
    table = thermo(lmp(script + "run 50\n", tmp_path))
    assert np.all(table["c_first"] == 0) and table["c_second"][-1] > 0
