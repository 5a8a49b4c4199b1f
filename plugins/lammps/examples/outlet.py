"""A hopper with a rectangular outlet: `python outlet.py outlet.stl` writes its surface, and
`python outlet.py outlet.dump outlet.png` draws what outlet.in left (wants numpy and matplotlib)."""

import sys

# Half widths along x and y, and heights, of outlet, bin and rim, in mm.
RINGS = [(17, 10, 0), (35, 30, 36), (35, 30, 200)]


def corners(ring):
    x, y, z = ring
    return [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z)]


def triangles():
    for lower, upper in zip(RINGS, RINGS[1:]):
        low, high = corners(lower), corners(upper)
        for k in range(4):
            a, b, c, d = low[k], low[(k + 1) % 4], high[(k + 1) % 4], high[k]
            yield from ((a, b, c), (a, c, d))


def write(path):
    with open(path, "w") as file:
        file.write("solid hopper\n")
        for triangle in triangles():
            file.write("facet normal 0 0 0\nouter loop\n")
            for x, y, z in triangle:
                file.write(f"vertex {x} {y} {z}\n")
            file.write("endloop\nendfacet\n")
        file.write("endsolid hopper\n")


def draw(dump, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import numpy as np
    from matplotlib.collections import EllipseCollection
    from matplotlib.colors import ListedColormap

    rows = np.loadtxt(dump, skiprows=9)
    figure, sides = plt.subplots(1, 2, figsize=(9, 5), sharey=True)
    for axes, across, along, name in ((sides[0], 0, 1, "x"), (sides[1], 1, 0, "y")):
        half = rows[np.abs(rows[:, 2 + along]) < 0.004]
        half = half[np.argsort(np.abs(half[:, 2 + along]))[::-1]]
        discs = EllipseCollection(
            half[:, 11] * 1e3, half[:, 11] * 1e3, 0 * half[:, 0], units="x",
            offsets=1e3 * half[:, [2 + across, 4]], offset_transform=axes.transData,
            cmap=ListedColormap(["C0", "C1", "C2", "C3"]), edgecolor="0.2", linewidth=0.3,
        )
        discs.set_array(half[:, 1])
        discs.set_clim(0.5, 4.5)
        axes.add_collection(discs)
        for sign in (-1, 1):
            axes.plot([sign * ring[across] for ring in RINGS], [ring[2] for ring in RINGS], "k")
            axes.plot([55 * sign, 55 * sign], [-60, -20], "k")
        axes.plot([-55, 55], [-60, -60], "k")
        axes.set(aspect="equal", xlim=(-60, 60), ylim=(-64, 110), xlabel=f"{name} (mm)")
    sides[0].set(ylabel="z (mm)", title="Along the outlet")
    sides[1].set(title="Across it")
    figure.tight_layout()
    figure.savefig(picture, dpi=100)


if __name__ == "__main__":
    write(sys.argv[1]) if len(sys.argv) == 2 else draw(*sys.argv[1:3])
