"""A damaged restart file ends in an error that says so: never in a jump, and never in a run."""

import os
import pathlib
import struct
import subprocess

import pytest
from conftest import Failed, lmp

HERE = pathlib.Path(__file__).parent
ROOT = HERE.parents[2]
NUMBERS, WITH_TWIST = 82, 165

START = """plugin load ${plugin}
units si
atom_style sphere
atom_modify map array
boundary f f f
newton off
comm_modify vel yes
"""
WALL = "fix floor all wall/carom plane 0 0 0 0 0 1 young 1e9 poisson 0.3 friction 0.4\n"
MOVE = "fix move all nve/sphere\ntimestep 1e-6\n"


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    """The bytes of a restart file of two grains in contact, one of them on a wall, all with friction."""
    folder = tmp_path_factory.mktemp("whole")
    make = START + "region all block -2 2 -2 2 -0.1 3 units box\ncreate_box 1 all\n"
    make += "create_atoms 1 single 0 0 0.4999 units box\ncreate_atoms 1 single 0 0 1.4997 units box\n"
    make += "set type 1 diameter 1.0\nset type 1 density 2000\nvelocity all set 0.02 0.01 -0.01\n"
    make += "pair_style carom\npair_coeff * * young 1e9 poisson 0.3 friction 0.4\n" + WALL + MOVE
    lmp(make + "run 20\nwrite_restart whole.bin\n", folder)
    return (folder / "whole.bin").read_bytes()


def doubles(data):
    """Where a double may stand, and what it would be."""
    for at in range(len(data) - 16):
        yield at, *struct.unpack_from("<2d", data, at)


def is_mark(number):
    return 2e4 <= number < 2.1e4 and number == int(number)


def count_of_wall(data):
    """The place at which the wall's contact says how many numbers it has."""
    return next(at for at, number, mark in doubles(data) if number == NUMBERS and is_mark(mark))


def contacts(data):
    """The places of packed contacts: of the two grains, which the host keeps with each of them, and of the wall."""
    wall = count_of_wall(data) + 8
    marks = [at for at, number, zeta in doubles(data) if is_mark(number) and 0 < zeta < 1]
    assert wall in marks and len(marks) == 3
    return [at for at in marks if at != wall], [wall]


def go_on(data, folder, **variables):
    (folder / "damaged.bin").write_bytes(data)
    return lmp(START.replace("boundary f f f\n", "") + "read_restart damaged.bin\n" + WALL + MOVE + "run 5\n", folder, **variables)


def changed(data, places, number):
    for at in places:
        data = data[:at] + struct.pack("<d", number) + data[at + 8 :]
    return data


def test_the_whole_file_goes_on(whole, tmp_path):
    assert "Loop time" in go_on(whole, tmp_path)


@pytest.mark.parametrize("number", [-1.0, -3.0, -1e9, -1e300, float("-inf"), float("nan"), 1.0])
def test_a_contact_that_says_it_is_unpacked_is_an_error_not_an_address(whole, tmp_path, number):
    for places in contacts(whole):
        with pytest.raises(Failed) as failed:
            go_on(changed(whole, places, number), tmp_path)
        said = str(failed.value)
        assert "ERROR" in said and "mark" in said, said[-600:]
        assert "damaged" in said or not number < 0.0, said[-600:]


@pytest.mark.parametrize("number", [1e9, 80.0, -5.0, 1e300, float("nan"), float(WITH_TWIST)])
def test_a_count_of_numbers_beyond_their_room_is_an_error_not_a_copy(whole, tmp_path, number):
    with pytest.raises(Failed) as failed:
        go_on(changed(whole, [count_of_wall(whole)], number), tmp_path)
    assert "the restart file is damaged" in str(failed.value), str(failed.value)[-600:]


def test_a_force_beyond_friction_is_an_error(whole, tmp_path):
    """The slope of the force of the lowest ring."""
    for places in contacts(whole):
        with pytest.raises(Failed) as failed:
            go_on(changed(whole, [at + 8 * 9 for at in places], 1e30), tmp_path)
        assert "ERROR" in str(failed.value) and "slope of the force" in str(failed.value)


def material(data):
    """The place of the material of the pair: Young's modulus and twelve other numbers; four settings come before it."""
    return next(at for at, young, poisson in doubles(data) if (young, poisson) == (1e9, 0.3))


def test_a_material_that_is_none_is_an_error(whole, tmp_path):
    for k in range(13):
        for number in (-1.0, float("nan")):
            with pytest.raises(Failed) as failed:
                go_on(changed(whole, [material(whole) + 8 * k], number), tmp_path)
            assert "the restart file is damaged: the material" in str(failed.value), k


@pytest.mark.parametrize("back", [32, 28, 16, 12], ids=["law", "torsion", "energy", "space"])
def test_a_setting_that_is_none_is_an_error(whole, tmp_path, back):
    at = material(whole) - back
    with pytest.raises(Failed) as failed:
        go_on(whole[:at] + struct.pack("<i", -1) + whole[at + 4 :], tmp_path)
    assert "the restart file is damaged: law, tolerance, torsion, energy or the space" in str(failed.value)


def test_slots_without_a_host_under_sanitizers(tmp_path):
    built = [ROOT / "target/lammps" / cpu / "release/libcarom_capi.a" for cpu in ("x86-64-v3", "generic")]
    if "CAROM_LIBRARY" in os.environ:
        built = [pathlib.Path(os.environ["CAROM_LIBRARY"])]
    library = next(library for library in built if library.exists())
    program = tmp_path / "touches"
    command = ["g++", "-std=c++17", "-g", "-O1", "-Wall", "-Wextra", "-Werror", "-fsanitize=address,undefined"]
    command += ["-fno-sanitize-recover=all", f"-I{ROOT / 'crates/capi/include'}", str(HERE / "touches.cpp")]
    command += [str(HERE.parent / "src/touches.cpp"), str(HERE.parent / "src/wall_contact.cpp"), str(library), "-lpthread", "-ldl", "-lm", "-o", str(program)]
    subprocess.run(command, check=True)
    said = subprocess.run([program], text=True, capture_output=True)
    assert said.returncode == 0 and said.stdout == "all is well\n", said.stdout + said.stderr[-3000:]
