"""How a settled bed scales with ranks: the same bed (strong) and a bed twice as large (weak) on two ranks.

CAROM_PLUGIN=... python scaling.py [rounds] [copies]: copies along x and y of a bed of 840 contacts.
"""

import pathlib
import re
import sys
import tempfile

from conftest import lmp
from cost import AGAIN, HERE, STYLES

MEASURED = ["granular mindlin", "carom fixed-direction", "carom coulomb"]


def seconds(folder, style, ranks, copies):
    """Time of the loop by the clock, with its part in messages."""
    name, coeff = STYLES[style]
    script = AGAIN.replace("replicate ${copies}", "replicate ${long}", 1).replace("read_data", "processors * 1 1\nread_data", 1)
    printed = lmp(script, folder, ranks=ranks, style=name, coeff=coeff, copies=copies[1], long=copies[0])
    loop = float(re.search(r"Loop time of (\S+)", printed).group(1))
    messages = float(re.search(r"^Comm +\| +\S+ +\| +(\S+)", printed, re.M).group(1))
    return loop, messages / loop


def main(rounds=3, copies=6):
    with tempfile.TemporaryDirectory() as folder:
        style, coeff = STYLES["carom fixed-direction"]
        lmp((HERE / "bed.in").read_text() + "write_data settled.data\n", folder, n1=24000, style=style, coeff=coeff)
        for style in MEASURED:
            one, strong, weak = [], [], []
            for _ in range(rounds):
                one.append(seconds(folder, style, 1, (copies, copies)))
                strong.append(seconds(folder, style, 2, (copies, copies)))
                weak.append(seconds(folder, style, 2, (2 * copies, copies)))
            (one, _), (strong, part), (weak, _) = min(one), min(strong), min(weak)
            print(
                f"{style}: {840 * copies**2} contacts, {one:.2f} s on one rank, {strong:.2f} s on two (efficiency "
                f"{one / (2 * strong):.2f}, {100 * part:.0f} % in messages); twice as many on two {weak:.2f} s "
                f"(efficiency {one / weak:.2f})",
                flush=True,
            )


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
