#!/usr/bin/env bash
# Finding: Gwyddion makes the map of a Keyence VK file one pixel shorter and narrower than its points, so the pixel and the curvature of a ball depend on how many points the image has, and on the direction.
# Package: gwyddionpy 0.1.0 with gwyddionpy-converter 0.1.0 (Gwyddion 2.71; PyPI), surfalize 0.19.2 (PyPI), SurfaceTopography 1.27.1 (PyPI)
# Expected: The file states the length of a pixel; n points are n pixels long, as Gwyddion has it for its own files and for those of other profilometers, and a ball has one radius.
# Seen: n points are n - 1 pixels long: 256 by 16 points of 0.5 um have pixels of 0.498 by 0.469 um, and a ball of 100 um has 99.2 um along x and 87.8 um along y. surfalize and SurfaceTopography keep 0.5 um and 100 um.
# Touches carom: Multiply the pixel by n / (n - 1) along each axis before carom takes radii or slopes from such a map; on 1024 by 768 points the radii are 0.2 and 0.3 % small.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
python3 -m venv "$folder/env"
"$folder/env/bin/pip" install -q --disable-pip-version-check --no-compile gwyddionpy==0.1.0 gwyddionpy-converter==0.1.0 surfalize==0.19.2 SurfaceTopography==1.27.1 numpy==2.4.6
export XDG_CACHE_HOME="$folder/cache"
cd "$folder"
cat > short.py <<'PYTHON'
import importlib.metadata
import struct
import sys

import gwyddionpy
import numpy as np
import surfalize
import SurfaceTopography

for name in ("gwyddionpy", "gwyddionpy-converter", "surfalize", "SurfaceTopography"):
    print(name, importlib.metadata.version(name))
PITCH, STEP, RADIUS = 0.5, 0.0001, 100.0  # um


def vk4(heights: np.ndarray) -> bytes:
    """A VK4 file with one image of heights: offsets, conditions (lengths in pm), image, two names."""
    conditions = [480, 2020, 1, 2, 3, 4, 5] + [0] * 113
    conditions[42:45] = [round(PITCH * 1e6), round(PITCH * 1e6), round(STEP * 1e6)]
    counts = np.round(heights / STEP).astype("<u4")
    image = struct.pack("<7I768x", *counts.shape[::-1], 32, 0, counts.nbytes, 0, 0) + counts.tobytes()
    names = struct.pack("<I2sI2s", 1, b"a", 1, b"b")
    start = 12 + 17 * 4 + 4
    offsets = [start] + [0] * 5 + [start + 480] + [0] * 9 + [start + 480 + len(image)]
    return b"VK4_" + bytes(8) + struct.pack("<17I4x", *offsets) + struct.pack("<120I", *conditions) + image + names


def radius(profile: np.ndarray, pitch: float) -> float:
    """Of the parabola through a profile."""
    return float(-0.5 / np.polyfit((np.arange(len(profile)) - len(profile) / 2) * pitch, profile, 2)[0])


fault = False
for columns, rows in ((256, 16), (16, 256), (64, 64)):
    x, y = (np.arange(columns) - columns // 2) * PITCH, (np.arange(rows) - rows // 2) * PITCH
    heights = 50.0 - (x[None, :] ** 2 + y[:, None] ** 2) / (2 * RADIUS)
    with open("ball.vk4", "wb") as file:
        file.write(vk4(heights - heights.min()))
    channel = next(iter(gwyddionpy.load("ball.vk4").channels.values()))
    own = surfalize.Surface.load("ball.vk4")
    topography = SurfaceTopography.read_topography("ball.vk4").to_unit("um")
    readers = {
        "Gwyddion": (channel.data * 1e6, channel.xreal * 1e6 / columns, channel.yreal * 1e6 / rows),
        "surfalize": (own.data, own.step_x, own.step_y),
        "SurfaceTopography": (np.asarray(topography.heights()).T, *topography.pixel_size),
    }
    print(f"{columns} by {rows} points: expected pixels of {PITCH} by {PITCH} um, radii {RADIUS:g} and {RADIUS:g} um")
    for name, (points, across, along) in readers.items():
        radii = radius(points[rows // 2], across), radius(points[:, columns // 2], along)
        print(f"  {name}: pixels of {across:.4f} by {along:.4f} um, radii {radii[0]:.1f} and {radii[1]:.1f} um")
        short = (1 - 1 / columns, 1 - 1 / rows) if name == "Gwyddion" else (1, 1)
        fault |= points.shape != (rows, columns) or not np.allclose((across, along), PITCH * np.array(short), rtol=1e-5)
        fault |= not np.allclose(radii, RADIUS * np.array(short) ** 2, rtol=2e-3)
sys.exit(int(fault))
PYTHON
env/bin/python -W ignore short.py
