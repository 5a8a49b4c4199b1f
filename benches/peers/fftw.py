"""Seconds of FFTW's plain product: `fftw.py CELLS THREADS` prints a line of JSON.

A plain product is: real transform, product with a real spectrum, transform back, no zeros skipped, of twice
the cells along each axis. It is the least of many, in a process of its own.
"""

import json
import sys
import time

import numpy as np
import pyfftw


def product(size, threads):
    field = pyfftw.empty_aligned((size, size))
    spectrum = pyfftw.empty_aligned((size, size // 2 + 1), dtype="complex128")
    options = dict(axes=(0, 1), threads=threads, flags=("FFTW_MEASURE", "FFTW_DESTROY_INPUT"))
    forward = pyfftw.FFTW(field, spectrum, **options)
    backward = pyfftw.FFTW(spectrum, field, direction="FFTW_BACKWARD", **options)
    kernel = np.random.rand(size, size // 2 + 1)
    best = float("inf")
    for _ in range(max(5, min(200, 40_000_000 // size**2))):
        field[:] = 1
        start = time.perf_counter()
        forward.execute()
        np.multiply(spectrum, kernel, out=spectrum)
        backward.execute()
        best = min(best, time.perf_counter() - start)
    return best


if __name__ == "__main__":
    cells, threads = map(int, sys.argv[1:])
    print(json.dumps({"seconds": product(2 * cells, threads)}))
