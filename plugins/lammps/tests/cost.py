"""What a contact step costs: pair carom against pair granular with mindlin, in turn, in the same settled bed.

CAROM_PLUGIN=... python cost.py [rounds] [copies] [--json]: copies along x and y of a bed of 840 contacts.
"""

import json
import pathlib
import re
import sys
import tempfile

from conftest import lmp

HERE = pathlib.Path(__file__).parent
CAROM = "young 1e7 poisson 0.3 friction 0.5 damping 2e-4"
STYLES = {
    "granular mindlin": ("granular", "hertz/material 1e7 100 0.3 damping viscoelastic tangential mindlin NULL 0.0 0.5"),
    "carom fixed-direction": ("carom law fixed-direction", CAROM),
    "carom coulomb": ("carom law coulomb", CAROM),
    "carom fixed-direction torsion": ("carom law fixed-direction torsion yes", CAROM),
    "carom rings": ("carom law rings", CAROM),
}
AGAIN = """
plugin load ${plugin}
units si
atom_style sphere
atom_modify map array sort 0 0
boundary p p f
comm_modify vel yes
read_data settled.data
replicate ${copies} ${copies} 1
region low block INF INF INF INF INF 0.0001 units box
group floor region low
group grain subtract all floor
pair_style ${style}
pair_coeff * * ${coeff}
neighbor 0.001 bin
fix gravity grain gravity 9.81 vector 0 0 -1
fix move grain nve/sphere
fix floor floor freeze
timestep 1e-5
compute touching all contact/atom
compute sum all reduce sum c_touching
thermo_style custom step c_sum
thermo 1500
run 3000
"""


def measured(rounds, copies):
    """Nanoseconds of a contact step in each round, by style."""
    costs = {name: [] for name in STYLES}
    with tempfile.TemporaryDirectory() as folder:
        style, coeff = STYLES["carom fixed-direction"]
        lmp((HERE / "bed.in").read_text() + "write_data settled.data\n", folder, n1=24000, style=style, coeff=coeff)
        for _ in range(rounds):
            for name, (style, coeff) in STYLES.items():
                printed = lmp(AGAIN, folder, style=style, coeff=coeff, copies=copies)
                seconds = float(re.search(r"^Pair +\| +\S+ +\| +(\S+)", printed, re.M).group(1))
                share = float(re.search(r"([\d.]+)% CPU use", printed).group(1)) / 100
                sums = [float(words[1]) for words in map(str.split, printed.split("\n")) if len(words) == 2 and words[0] in ("0", "1500", "3000")]
                contacts = sum(sums) / len(sums) / 2
                costs[name].append(seconds * share / (3000 * contacts) * 1e9)
    return costs


def main(rounds, copies, as_json):
    costs = measured(rounds, copies)
    if as_json:
        print(json.dumps(costs))
        return
    reference = min(costs["granular mindlin"])
    for name, of_rounds in costs.items():
        cost = min(of_rounds)
        print(f"{name}: {cost:.0f} ns a contact step, {cost / reference:.2f} of granular mindlin")


if __name__ == "__main__":
    numbers = [int(word) for word in sys.argv[1:] if word != "--json"]
    rounds, copies = (*numbers, *(3, 1)[len(numbers) :])
    main(rounds, copies, "--json" in sys.argv)
