"""Reference values of the complete elliptic integrals: 50 digits, printed to 25.

Run: python3 special_complete.py > ../data/special/complete.csv   (needs mpmath)
"""

import mpmath as mp

mp.mp.dps = 50


def complete(kc):
    """K, E, D, B, C of one axis ratio by Carlson's symmetric integrals (DLMF 19.25)."""
    x = kc * kc
    K = mp.elliprf(0, x, 1)
    D = mp.elliprd(0, x, 1) / 3
    B = x * mp.elliprd(0, 1, x) / 3
    E = B + x * D
    m = 1 - x
    if abs(m) > mp.mpf("1e-12"):
        C = (D - B) / m
    else:
        C = mp.pi / 16 * mp.hyp2f1(1.5, 1.5, 3, m)
    return K, E, D, B, C


def ratios():
    """Log-spaced axis ratios of both ends, of the neighbourhood of 1, and the border cases."""
    values = [5e-324, 3e-310, 2.2250738585072014e-308, 1.7976931348623157e308]
    values += [float(mp.mpf(10) ** (-i)) for i in range(13, 301, 7)]
    values += [float(mp.mpf(10) ** (mp.mpf(-i) / 10)) for i in range(0, 125)]
    values += [float(1 - mp.mpf(10) ** (mp.mpf(-i) / 4)) for i in range(1, 64)]
    values += [float(1 + mp.mpf(10) ** (mp.mpf(-i) / 4)) for i in range(1, 64)]
    values += [float(mp.mpf(10) ** (mp.mpf(i) / 10)) for i in range(1, 125)]
    values += [float(mp.mpf(10) ** i) for i in range(13, 301, 7)]
    return sorted(set(values))


def main():
    print("# generator: reference/special_complete.py")
    print("# accuracy: 25 digits, of 50 and more")
    print("# date: 2026-11-21")
    print("axis_ratio,K,E,D,B,C,dK,dE,dB,dD")
    for kc in ratios():
        mp.mp.dps = 50
        # Digits enough for differences at extreme ratios.
        mp.mp.dps = 50 + int(3 * abs(mp.log10(mp.mpf(kc))))
        x = mp.mpf(kc)
        K, E, D, B, C = complete(x)
        row = [K, E, D, B, C, -B / x, x * D, -x * C, -(B - x * x * C) / x]
        print(",".join([repr(kc)] + [mp.nstr(v, 25) for v in row]))


if __name__ == "__main__":
    main()
