"""Reference values of gamma and ln|gamma|: 60 digits, printed to 22.

Run: python3 special_gamma.py > ../data/special/gamma.csv   (needs mpmath)
"""

import random

import mpmath as mp

mp.mp.dps = 60


def arguments():
    generator = random.Random(1729)
    yield from (10.0**-e for e in (300, 100, 20, 16, 10, 5, 2))
    yield from (1 - 1e-15, 1 + 1e-15, 2 - 1e-12, 2 + 1e-12, 1.4616321449683623)
    yield from (i / 20 for i in range(1, 80))
    for _ in range(400):
        yield generator.uniform(0.0, 20.0)
        yield generator.uniform(20.0, 171.0)
        yield generator.uniform(-20.0, 0.0)
    yield from (-n + s * 10.0**-e for n in (1, 2, 7, 15) for s in (1, -1) for e in (3, 8, 12))


def main():
    print("# generator: reference/special_gamma.py")
    print("# accuracy: 22 digits, of 60")
    print("# date: 2026-11-21")
    print("x,gamma,ln_gamma")
    for x in arguments():
        value = mp.gamma(mp.mpf(x))
        print(",".join([repr(x), mp.nstr(value, 22), mp.nstr(mp.log(abs(value)), 22)]))


if __name__ == "__main__":
    main()
