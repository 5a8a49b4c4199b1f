"""Reference values of the incomplete elliptic integrals: 60 digits and more, printed to 22.

Every value belongs to the exact binary axis ratio and cosine (or sine) of its row; the other of
both is exact too. Run: python3 special_incomplete.py > ../data/special/incomplete.csv
"""

import random

import mpmath as mp


def incomplete(kc, s, c):
    """F, E, D by Carlson's symmetric integrals (DLMF 19.25.5, 19.25.9, 19.25.13)."""
    x, y = c * c, c * c + kc * kc * s * s
    F = s * mp.elliprf(x, y, 1)
    D = s**3 * mp.elliprd(x, y, 1) / 3
    return F, F + (kc * kc - 1) * D, D


def places():
    generator = random.Random(538)
    ends = [1e-300, 1e-160, 1e-30, 1e-12, 1e-9, 3e-9, 1e-6, 1e-3, 0.1, 0.5, 0.9]
    ratios = [10.0**e for e in (-300, -160, -30, -12, -9, -6, -3, -1)]
    ratios += [0.5, 0.9, 0.999999, 1.0, 1.000001, 1.5, 10.0, 1e3, 1e8, 1e9, 1e12, 1e30, 1e160, 1e300]
    for kc in ratios:
        yield kc, "cosine", 0.0
        for end in ends:
            yield kc, "cosine", end
            yield kc, "sine", end
    for _ in range(1200):
        kc = generator.choice([10 ** generator.uniform(-12, 0), 10 ** generator.uniform(-2, 1),
                               10 ** generator.uniform(0, 10)])
        end = generator.choice([10 ** generator.uniform(-12, 0), generator.uniform(0, 1)])
        yield kc, generator.choice(["cosine", "sine"]), end


def main():
    print("# generator: reference/special_incomplete.py")
    print("# accuracy: 22 digits, of 60 and more")
    print("# date: 2026-11-21")
    print("axis_ratio,sine,cosine,by_sine,F,E,D")
    for kc, kind, end in places():
        mp.mp.dps = 60 + int(3 * abs(mp.log10(mp.mpf(kc)))) + (0 if end == 0 else int(3 * abs(mp.log10(end))))
        known = mp.mpf(end)
        other = mp.sqrt(1 - known * known)
        s, c = (known, other) if kind == "sine" else (other, known)
        values = incomplete(mp.mpf(kc), s, c)
        if any(v != 0 and (abs(v) > mp.mpf("1e308") or abs(v) < mp.mpf("1e-307")) for v in values):
            continue
        row = [repr(kc), mp.nstr(s, 20), mp.nstr(c, 20), "1" if kind == "sine" else "0"]
        print(",".join(row + [mp.nstr(v, 22) for v in values]))


if __name__ == "__main__":
    main()
