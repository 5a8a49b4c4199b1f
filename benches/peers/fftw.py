"""Time of FFTW's plain product, to set beside `cargo bench --bench halfspace -- product`.

Run both on a quiet machine, one after the other:  pip install pyfftw numpy;  python fftw.py
A plain product is: real transform, product with a real spectrum, transform back, no zeros
skipped. Sizes are padded lengths, twice the cells of the bench of the same row.
"""
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
    for _ in range(max(5, min(200, 160_000_000 // size**2))):
        field[:] = 1
        start = time.perf_counter()
        forward.execute()
        np.multiply(spectrum, kernel, out=spectrum)
        backward.execute()
        best = min(best, time.perf_counter() - start)
    return best


if __name__ == "__main__":
    print("padded  cells  threads  milliseconds")
    for size in (128, 256, 512, 1024, 2048, 4096):
        for threads in (1, 2):
            print(f"{size:6} {size // 2:6} {threads:8} {1e3 * product(size, threads):13.3f}")
