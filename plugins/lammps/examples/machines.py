"""Draws drum and hopper: python machines.py drum.dump hopper.dump machines.png (wants numpy and matplotlib)."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection
from matplotlib.colors import ListedColormap


def draw(axes, rows, colours):
    """Grains seen along y, the nearest last."""
    rows = rows[np.argsort(-rows[:, 3])]
    discs = EllipseCollection(
        rows[:, 11] * 1e3, rows[:, 11] * 1e3, 0 * rows[:, 0], units="x",
        offsets=1e3 * rows[:, [2, 4]], offset_transform=axes.transData,
        cmap=ListedColormap(colours), edgecolor="0.2", linewidth=0.3,
    )
    discs.set_array(rows[:, 1])
    discs.set_clim(0.5, len(colours) + 0.5)
    axes.add_collection(discs)
    axes.set(aspect="equal", xlabel="x (mm)", ylabel="z (mm)")


def main(drum, hopper, picture):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 5.4))
    rows = np.loadtxt(drum, skiprows=9)
    draw(left, rows, ["C0", "C1"])
    left.add_patch(plt.Circle((0, 0), 60, fill=False, color="k"))
    left.set(xlim=(-62, 62), ylim=(-62, 62), title="A drum turns, through its front wall")
    rows = np.loadtxt(hopper, skiprows=9)
    # A slice about the middle.
    draw(right, rows[rows[:, 3] > -0.001], ["C0", "C1", "C2", "C3"])
    for side in (-1, 1):
        right.plot([15 * side, 35 * side, 35 * side], [0, 34.64, 130], "k")
        right.plot([50 * side, 50 * side], [-60, -20], "k")
    right.plot([-50, 50], [-60, -60], "k")
    right.set(xlim=(-75, 75), ylim=(-64, 130), title="A hopper runs empty, cut through its axis")
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


if __name__ == "__main__":
    main(*sys.argv[1:4])
