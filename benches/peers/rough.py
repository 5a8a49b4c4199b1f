"""A rough surface pressed on a plane by carom and by a peer; both answers are judged by one product of its own.

    rough.py make FOLDER CELLS [SHORTEST] writes the heights, CELLS x CELLS numbers
    rough.py ASPHER FOLDER CELLS          solves with ASPHER, prints a line of JSON
    rough.py judge FOLDER CELLS PROGRAM   judges the pressures that PROGRAM has written

The surface is self-affine, H = 0.8, with waves of a quarter to a 64th of the side, or to SHORTEST cells, and rms .002 of the
side; the mean pressure is .001 E*. Pressures are judged by the greatest gap in the contact, or overlap outside, over the greatest
displacement, with the convolution of numpy and the closed form of the influence; with another load there is none.
"""

import json
import pathlib
import resource
import sys
import time

from problem import SHEAR, SIDE

MODULUS = SHEAR / 0.7
MEAN_PRESSURE = 1e-3 * MODULUS


def make(folder, cells, shortest=None):
    import numpy as np

    random = np.random.default_rng(7)
    waves = np.fft.fftfreq(cells, 1 / cells)[:, None], np.fft.rfftfreq(cells, 1 / cells)[None, :]
    size = np.hypot(*waves)
    within = (size >= 4) & (size <= (cells / shortest if shortest else 64))
    amplitude = np.where(within, np.maximum(size, 1) ** -1.8, 0.0)
    noise = np.fft.rfft2(random.standard_normal((cells, cells)))
    heights = np.fft.irfft2(amplitude * noise, s=(cells, cells))
    heights *= 0.002 * SIDE / heights.std()
    (heights.max() - heights).tofile(folder / f"rough{cells}.f64")


def read(path, cells):
    import numpy as np

    return np.fromfile(path).reshape(cells, cells)


def aspher(folder, cells):
    import aspher as solver

    gap = read(folder / f"rough{cells}.f64", cells).ravel()
    begin, processor = time.perf_counter(), time.process_time()
    # Its fastest setting for a residual of 1e-5.
    found = solver.solve_nested(
        grid_size=cells, gap=gap, p_nominal=MEAN_PRESSURE, domain_size=SIDE, E_star=MODULUS, coarsest=64,
        single_precision=True, light_result=True, active_set=True, tol=1e-5,
    )
    solve, used = time.perf_counter() - begin, time.process_time() - processor
    megabytes = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    found.pressure.astype("f8").tofile(folder / f"ASPHER{cells}.f64")
    return {"solve": solve, "processor": used, "megabytes": megabytes, "converged": bool(found.converged)}


def influence(cells):
    """The displacement by a unit pressure on a square cell, at all offsets from 0."""
    import numpy as np

    width = SIDE / cells
    edge = (np.arange(cells + 1) - 0.5) * width
    x, y = edge[:, None], edge[None, :]
    corner = x * np.arcsinh(y / np.abs(x)) + y * np.arcsinh(x / np.abs(y))
    return (corner[1:, 1:] - corner[1:, :-1] - corner[:-1, 1:] + corner[:-1, :-1]) / (np.pi * MODULUS)


def judge(folder, cells, program):
    import numpy as np

    pressure = read(folder / f"{program}{cells}.f64", cells)
    gap = read(folder / f"rough{cells}.f64", cells)
    kernel = np.zeros((2 * cells, 2 * cells))
    kernel[:cells, :cells] = influence(cells)
    kernel[cells + 1 :] = kernel[cells - 1 : 0 : -1]
    kernel[:, cells + 1 :] = kernel[:, cells - 1 : 0 : -1]
    padded = np.zeros_like(kernel)
    padded[:cells, :cells] = pressure
    displacement = np.fft.irfft2(np.fft.rfft2(kernel) * np.fft.rfft2(padded), s=kernel.shape)[:cells, :cells]
    touching = pressure > 0
    left = displacement + gap
    left -= left[touching].mean()
    worst = max(np.abs(left[touching]).max(), -left[~touching].min())
    # A solution for another load is none.
    is_loaded = abs(pressure.mean() / MEAN_PRESSURE - 1) < 1e-5 and pressure.min() >= 0
    return {
        "residual": float(worst / displacement[touching].max()) if is_loaded else float("inf"),
        "contact": float(touching.mean()),
    }


if __name__ == "__main__":
    task, folder, cells, *more = sys.argv[1:]
    folder, cells = pathlib.Path(folder), int(cells)
    if task == "make":
        make(folder, cells, *map(float, more))
    elif task == "judge":
        print(json.dumps(judge(folder, cells, more[0])))
    else:
        print(json.dumps(aspher(folder, cells)))
