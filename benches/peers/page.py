"""Makes the page of the book from the answers of rounds.py: `page.py ANSWERS PAGE`. No number in it is typed."""

import json
import math
import pathlib
import sys
from statistics import median

from problem import CASES

CONVERGED = 0.1
MEASURABLE = 16
TITLES = {
    "hertz_force": "Hertz, by the force",
    "hertz_approach": "Hertz, by the approach",
    "cattaneo": "Cattaneo, by force and shift",
}
HEAD = """\
# Beside other programs

`cargo xtask bench --page` measures all numbers of this page in one run and writes it; none is typed. Here are carom
and the programs that were installed, on the same problem and the same machine, in turn.

The run of {date} took {minutes:.0f} minutes on {processor}, {cores} cores; load average {loads} (at the beginning and at
the end; 1 is one busy core).
carom is built by {compiler}. Others: {versions}.

{absent}

**The problem**: a paraboloid on an equal one, on N x N elements of a window 1.2 times as wide as the contact. Hertz's
problem with $\\nu=0.3$; Cattaneo's with $\\nu=0$, $f=0.4$, shifted until half of the contact's radius sticks, where
Cattaneo's solution is exact. carom solves each step to a residual of $10^{{-6}}$, with both components of traction;
slippy solves for one. ContactMechanics is asked for $10^{{-7}}$, tamaas for $10^{{-8}}$, CONTACT for $10^{{-6}}$, slippy for
what is its default: residuals of different kinds, so that *off the grid* below is what compares. Every run is a process of
its own on one thread. A grid of 1024 x 1024 is solved once, at the end, by the programs for which the minutes of the run
sufficed.

**How to read the tables.** *Processor* is the time for which set-up and solution kept a core busy, without imports
(carom's with the start and end of its process): the least, the range, the number of runs. *Clock* is the least by the
clock, which other load on the machine lengthens; *set-up* is its part of that. *Ratio* is the processor's time over
carom's in the same round: the median, and the range.
*Error* is that of the quantity that is not given, against the closed form; most of it is that of the grid, which all
programs share. *Off the grid* is its distance from the error of carom at $10^{{-11}}$ on the same grid: what the
program itself adds. *Memory* is the largest of the process, for programs in Python with their libraries; no less than that of the
measuring script can be seen.
"""
LIMITS = """
## What limits carom

A solution consists of products with the influence matrix by Fourier transforms of length 2N, and of inverses of length
N. By their formulas a product of pressures takes $30N^2\\,\\mathrm{log}_2\\,2N+4N^2$ operations, since zeros are left out, and moves
at least $88N^2$ bytes: fields in and out, the spectra of rows and columns written and read, the kernel. FFTW's plain
product leaves no zeros out.
"""
SHARES = """
*Products* and *inverses* are those that carom took, by the cells that they covered. Their part of the time of solution
is their number times the times above; the rest are sums over cells, and the memory's first use. (Above 100 %: products
on fewer cells cost less than their share of cells, or the load changed meanwhile.) *FFTW's part* is what as many plain
products of FFTW would need, without inverses.
"""


def significant(value, digits=2):
    """A positive number in words of this many digits, without exponents."""
    if value <= 0:
        return "0"
    places = max(0, digits - 1 - math.floor(math.log10(value)))
    return f"{value:.{places}f}"


def seconds(value):
    return f"{significant(value)} s" if value >= 0.1 else f"{significant(1e3 * value)} ms"


def spread(values, shown=significant):
    """The least and the largest, where they differ."""
    low, high = shown(min(values)), shown(max(values))
    return low if low == high else f"{low} to {high}"


def table(heads, rows):
    lines = ["| " + " | ".join(row) + " |" for row in [heads, ["---"] * len(heads), *rows]]
    return "\n".join(lines) + "\n"


def clock(answer):
    return answer["set_up"] + answer["solve"]


def total(answer):
    """Seconds of the processor."""
    return answer["processor"]


def memory(megabytes):
    """A process shows no less than what the script that starts it has."""
    return f"{megabytes:.0f} MB" if megabytes > MEASURABLE else f"at most {MEASURABLE} MB"


def small(value):
    return f"{value:.0e}" if value > 1e-12 else "below 1e-12"


class Answers:
    """What one run of rounds.py has measured."""

    def __init__(self, told):
        self.told = told
        self.all = told["answers"]
        self.sizes = sorted({one["cells"] for one in self.all if one.get("case") in CASES and "cells" in one})

    def of(self, program, case=None, cells=None, **more):
        """The answers of a program, those to the tight tolerance left out."""
        wanted = {"program": program, **({"cells": cells} if cells else {}), **({"case": case} if case else {}), **more}
        found = [one for one in self.all if all(one.get(key) == value for key, value in wanted.items())]
        return found if more else [one for one in found if one.get("tolerance") != "1e-11"]

    def solved(self, program, case, cells):
        return [one for one in self.of(program, case, cells) if "solve" in one and one["error"] is not None]

    def on_the_grid(self, case, cells):
        """The error that the grid has."""
        tight = [one for one in self.of("carom", case, cells, tolerance="1e-11") if "error" in one]
        return tight[0]["error"] if tight else None

    def ratios(self, program, case, cells):
        """Times over carom's of the same round."""
        ratios = []
        for one in self.solved(program, case, cells):
            own = [total(other) for other in self.solved("carom", case, cells) if other["round"] == one["round"]]
            if own and abs(one["error"]) < CONVERGED:
                ratios.append(total(one) / median(own))
        return ratios

    def programs(self, case):
        """carom and the peers that have the case."""
        return ["carom"] + [
            peer
            for peer in self.told["versions"]
            if any(one.get("case") == case and one["program"] == peer and "lacks" not in one for one in self.all)
        ]


def row(answers, program, case, cells):
    found = answers.solved(program, case, cells)
    if not found:
        asked = answers.of(program, case, cells)
        return [str(cells), program, asked[-1]["failed"], *["-"] * 6] if asked else None
    error = found[-1]["error"]
    if not abs(error) < CONVERGED:
        return [str(cells), program, f"did not converge in {seconds(clock(found[-1]))}", *["-"] * 6]
    times = [total(one) for one in found]
    least = min(found, key=total)
    ratios, grid = answers.ratios(program, case, cells), answers.on_the_grid(case, cells)
    return [
        str(cells),
        program,
        f"{seconds(min(times))} ({spread(times, seconds)}; {len(times)} {'run' if len(times) == 1 else 'runs'})",
        seconds(min(map(clock, found))),
        seconds(least["set_up"]),
        "1" if program == "carom" else f"**{significant(median(ratios))}** ({spread(ratios)})" if ratios else "-",
        f"{error:.1e}",
        "-" if grid is None else small(abs(error - grid)),
        memory(max(one["megabytes"] for one in found)),
    ]


def case_section(answers, case):
    heads = ["N", "program", "processor", "clock", "of it set-up", "ratio", "error", "off the grid", "memory"]
    rows = [row(answers, program, case, cells) for cells in answers.sizes for program in answers.programs(case)]
    return f"\n## {TITLES[case]}\n\n" + table(heads, [row for row in rows if row])


def summary(answers):
    """Median ratios of all peers, one line each."""
    rows = []
    for case in CASES:
        for peer in answers.programs(case)[1:]:
            found = [answers.ratios(peer, case, cells) for cells in answers.sizes]
            rows.append([TITLES[case], peer, *(significant(median(some)) if some else "-" for some in found)])
    heads = ["processor's time over carom's, median", "", *(f"{cells} x {cells}" for cells in answers.sizes)]
    return "\n" + table(heads, rows) if rows else ""


def loop_section(answers):
    rows = []
    for cells in answers.sizes:
        times = [[one["solve"] for one in answers.of("carom", "loop", cells, threads=n) if "solve" in one] for n in (1, 2)]
        if all(times):
            gains = [one / two for one, two in zip(*times)]
            shown = [f"{seconds(min(some))} ({spread(some, seconds)})" for some in times]
            rows.append([str(cells), *shown, f"{significant(median(gains))} ({spread(gains)})"])
    text = "\n## A loop of friction, on one and two threads\n\nThe ball is pressed, then shifted to and fro in 19 steps; times by the clock, "
    text += "$\\nu=0.28$:\nboth components of traction, with memory. CONTACT has such histories too, which are not measured here.\nTwo threads gain only where both cores are free: see the load of this run.\n\n"
    return text + table(["N", "one thread", "two threads", "gain"], rows)


ROUGH = """
## A rough surface

A self-affine surface, $H=.8$, with waves of a quarter to a 64th of the side and a rms height of .002 of it, is pressed on a
plane by a mean pressure of $.001E^*$. carom is asked for a residual of $10^{-5}$; ASPHER has its fastest setting for that:
nested grids, single precision, an active set. *Residual* is the greatest gap in the contact, or overlap outside, over the
greatest displacement, by a product that shares no code with either.
Times are compared where the residuals differ by less than three times, or the slower answer is the worse.

"""


def rough_section(answers):
    """Times of carom and ASPHER on a rough surface, with what the judge found."""
    rows = []
    for judged in (one for one in answers.all if one["program"] == "judge" and "residual" in one):
        program, cells = judged["of"], judged["cells"]
        found = [one for one in answers.of(program, "rough", cells) if "solve" in one]
        own = [one for one in answers.of("carom", "rough", cells) if "solve" in one]
        mine = [one["residual"] for one in answers.of("judge", "rough", cells, of="carom") if "residual" in one]
        if not found or not own or not mine:
            continue
        ratios = [total(one) / total(other) for one, other in zip(found, own)]
        is_alike = judged["residual"] < 3 * mine[0] and mine[0] < 3 * judged["residual"]
        is_compared = is_alike or (judged["residual"] > mine[0]) == (median(ratios) > 1)
        rows.append([
            str(cells),
            program,
            f"{100 * judged['contact']:.2f} %",
            f"{seconds(min(map(total, found)))} ({spread([total(one) for one in found], seconds)}; {len(found)} runs)",
            "1" if program == "carom" else f"**{significant(median(ratios))}** ({spread(ratios)})" if is_compared else "not compared",
            small(judged["residual"]),
            memory(max(one["megabytes"] for one in found)),
        ])
    heads = ["N", "program", "contact", "processor", "ratio", "residual", "memory"]
    return ROUGH + table(heads, rows) if rows else ""


GROWTH = """
## Time and memory by size

carom alone, one run of each grid on one thread: without friction only the pressures are kept and solved for, with friction
the tractions too.

"""


def growth(ones):
    """The exponent of the time in the number of cells, and bytes a cell, from the smallest and the largest grid."""
    first, last = ones[0], ones[-1]
    ratio = (last["size"] / first["size"]) ** 2
    exponent = math.log(total(last) / total(first)) / math.log(ratio)
    added = (last["megabytes"] - first["megabytes"]) / (last["size"] ** 2 - first["size"] ** 2)
    return exponent, added * 2**20


def growth_section(answers):
    rows, laws = [], []
    for case in CASES:
        ones = [one for one in answers.of("carom by size", case) if "solve" in one]
        rows += [[TITLES[case], str(one["size"]), seconds(total(one)), memory(one["megabytes"])] for one in ones]
        if len(ones) > 1:
            exponent, added = growth(ones)
            laws.append(f"{TITLES[case]}: time grows with the power {exponent:.2f} of the number of cells, memory by {added:.0f} bytes a cell.")
    return GROWTH + table(["", "N", "processor", "memory"], rows) + "\n" + "\n".join(laws) + "\n" if rows else ""


def products(answers, cells):
    """Least times of carom's products and of FFTW's."""
    own = [one for one in answers.of("product", cells=cells) if "normal" in one]
    least = {key: min(one[key] for one in own) for key in ("normal", "tangential", "inverse_normal")} if own else None
    plain = [one["seconds"] for one in answers.of("FFTW", cells=cells) if "seconds" in one]
    return least, min(plain) if plain else None


def limits_section(answers):
    rows, shares = [], []
    for cells in answers.sizes:
        own, plain = products(answers, cells)
        if own is None:
            continue
        operations = cells**2 * (30 * math.log2(2 * cells) + 4)
        rows.append([
            str(cells), *(seconds(own[key]) for key in ("normal", "tangential", "inverse_normal")),
            seconds(plain) if plain else "-", significant(own["normal"] / plain) if plain else "-",
            f"{significant(operations / own['normal'] / 1e9)} Gflop/s", f"{significant(88 * cells**2 / own['normal'] / 1e9)} GB/s",
        ])
        shares += [share(answers, case, cells, own, plain) for case in CASES[:2] if answers.solved("carom", case, cells)]
    heads = ["N", "product, normal", "product, tangential", "inverse, normal", "FFTW's plain product", "normal over FFTW", "operations", "bytes"]
    text = LIMITS + "\n" + table(heads, rows) + SHARES + "\n"
    return text + table(["N", "", "products", "inverses", "part of the solution", "FFTW's part"], shares)


def share(answers, case, cells, own, plain):
    least = min(answers.solved("carom", case, cells), key=lambda one: one["solve"])
    taken = least["normal"] * own["normal"] + least["preconditioner"] * own["inverse_normal"]
    return [
        str(cells), TITLES[case], f"{least['normal']:.1f}", f"{least['preconditioner']:.1f}",
        f"{100 * taken / least['solve']:.0f} %", f"{100 * least['normal'] * plain / least['solve']:.0f} %" if plain else "-",
    ]


def lammps_section(told):
    costs = told["lammps"]
    if not costs:
        return ""
    rows = []
    for name, own in costs.items():
        ratios = [one / other for one, other in zip(own, costs["granular mindlin"])]
        rows.append([name, f"{min(own):.0f} ns ({spread(own, lambda value: f'{value:.0f}')})", f"{median(ratios):.2f} ({spread(ratios)})"])
    text = "\n## A contact step in LAMMPS\n\n`plugins/lammps/tests/cost.py`: pair styles in turn in the same settled bed, with neighbours and\ngeometry, in the release for which `cargo xtask lammps` builds the plugin.\n\n"
    return text + table(["pair style", "time", "over granular mindlin, same round"], rows)


def head(told):
    versions = ", ".join(f"{peer} {version}".strip() for peer, version in told["versions"].items())
    absent = "; ".join(f"{name}: {reason}" for name, reason in told["absent"].items())
    return HEAD.format(
        date=told["date"],
        minutes=told["minutes"],
        processor=told["machine"]["processor"],
        cores=told["machine"]["cores"],
        compiler=told["machine"]["compiler"],
        loads=" and ".join(f"{load:.1f}" for load in told["loads"]),
        versions=versions or "none",
        absent=f"Absent from this run: {absent}." if absent else "No program that it knows was absent.",
    )


def main(source, page):
    told = json.loads(pathlib.Path(source).read_text())
    answers = Answers(told)
    cases = "".join(case_section(answers, case) for case in CASES)
    parts = [head(told), summary(answers), cases, rough_section(answers), loop_section(answers), growth_section(answers), limits_section(answers), lammps_section(told)]
    pathlib.Path(page).write_text("".join(parts))


if __name__ == "__main__":
    main(*sys.argv[1:])
