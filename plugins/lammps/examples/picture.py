"""Draws the sheared grains: python picture.py sheared.dump sheared.png (wants numpy and matplotlib)."""

import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection


def main(dump, picture):
    rows = np.loadtxt(dump, skiprows=9)
    x, y, z, vx, diameter = rows[:, 2], rows[:, 3], rows[:, 4], rows[:, 5], rows[:, 11]
    figure, (above, profile) = plt.subplots(1, 2, figsize=(10, 5), width_ratios=[1.15, 1])
    # The uppermost last.
    order = np.argsort(z)
    discs = EllipseCollection(
        diameter[order] * 1e3, diameter[order] * 1e3, 0 * order, units="x",
        offsets=1e3 * np.column_stack([x, y])[order], offset_transform=above.transData,
        cmap="coolwarm", edgecolor="0.2", linewidth=0.3,
    )
    discs.set_array(vx[order])
    discs.set_clim(-0.25, 0.25)
    above.add_collection(discs)
    above.set(xlim=(0, 80), ylim=(-41, 41), aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    above.set_title(f"{len(rows)} grains from above")
    figure.colorbar(discs, ax=above, label="velocity along x (m/s)", shrink=0.8)
    edges = np.linspace(-0.04, 0.04, 17)
    place = np.digitize(y, edges) - 1
    for low, high, colour in ((0, 0.03, "C0"), (0.03, 0.06, "C1"), (0.06, 1, "C2")):
        layer = (z >= low) & (z < high)
        mean = [vx[layer & (place == k)].mean() if (layer & (place == k)).any() else np.nan for k in range(16)]
        label = f"{1e3 * low:.0f} to {1e3 * high:.0f} mm high" if high < 1 else f"above {1e3 * low:.0f} mm"
        profile.plot(500 * (edges[1:] + edges[:-1]), mean, "o-", color=colour, label=label)
    profile.set(xlabel="y (mm)", ylabel="mean velocity along x (m/s)")
    profile.legend()
    figure.tight_layout()
    figure.savefig(picture, dpi=120)


if __name__ == "__main__":
    main(*sys.argv[1:3])
