"""Reference values of 2F1 and 3F2(s, a, b; s+1, c): 40 digits, printed to 22.

Every value belongs to the exact binary values of the numbers in its row; `complement` is 1 - x
exactly. Run: python3 special_hypergeometric.py ../data/special   (needs mpmath)
"""

import random
import sys

import mpmath as mp

mp.mp.dps = 40

PHI = [1.0, 3.0, 5.5, 7.810249675906654, 9.0, 11.0, 13.2, 16.76305461424021, 18.624777929982858,
       19.5, 20.51828452868319, 23.3, 26.851443164195104, 32.0, 45.0, 60.0]

# 2F1 of the thesis, (9.8)-(9.45), (10.21)-(10.49): functions of phi and fixed ones.
SETS = [
    lambda p: ((1 - p) / 20, (1 + p) / 20, 3 / 5),
    lambda p: ((9 - p) / 20, (9 + p) / 20, 7 / 5),
    lambda p: ((1 - p) / 20, (1 + p) / 20, 1 / 2),
    lambda p: ((11 - p) / 20, (11 + p) / 20, 3 / 2),
    lambda p: ((11 - p) / 20, (11 + p) / 20, 8 / 5),
    lambda p: ((-1 - p) / 20, (-1 + p) / 20, 2 / 5),
    lambda p: ((11 - p) / 20, (11 + p) / 20, 3 / 5),
    lambda p: ((19 - p) / 20, (19 + p) / 20, 7 / 5),
    lambda p: ((9 - p) / 20, (9 + p) / 20, 3 / 2),
]
FIXED = [(1 / 2, 3 / 5, 3 / 2), (1 / 2, 2 / 5, 7 / 5), (1.0, 9 / 10, 12 / 5),
         (1 / 2, 7 / 5, 12 / 5), (6 / 5, 1 / 2, 11 / 5), (1.0, 17 / 10, 11 / 5)]
SETS3 = [
    lambda p: (2 / 5, (11 - p) / 20, (11 + p) / 20, 3 / 5),
    lambda p: (4 / 5, (19 - p) / 20, (19 + p) / 20, 7 / 5),
]
FIXED3 = [(9 / 5, 7 / 5, 3 / 2, 12 / 5), (9 / 5, 19 / 10, 1.0, 12 / 5), (8 / 5, 1.0, 17 / 10, 11 / 5)]

# Arguments as (x, 1 - x): one of both is a double, the other exact.
SMALL = [0.0, 1e-300, 1e-20, 1e-8, 1e-3, 0.1, 0.25, 0.4, 0.49, 0.5]
NEAR = [0.49, 0.4, 0.3, 0.25, 0.1, 1e-2, 1e-3, 1e-6, 1e-10, 1e-14, 1e-20, 1e-100, 1e-300, 0.0]


def arguments():
    for x in SMALL:
        yield x, 1 - mp.mpf(x)
    for y in NEAR:
        yield float(1 - mp.mpf(y)), mp.mpf(y)


def gauss(a, b, c, y):
    """2F1 at 1 - y by mpmath, with digits enough for the complement."""
    a, b, c = mp.mpf(a), mp.mpf(b), mp.mpf(c)
    extra = 0 if y == 0 else int(max(0, -mp.log10(y)))
    with mp.workdps(60 + extra):
        return mp.hyp2f1(a, b, c, 1 - y)


def three(s, a, b, c, y):
    """The series up to 1/2; beyond, s z^-s int t^(s-1) 2F1 dt in u = sqrt(1 - t)."""
    s, a, b, c = (mp.mpf(v) for v in (s, a, b, c))
    z = 1 - y
    if z <= mp.mpf(1) / 2:
        return mp.hyper([s, a, b], [s + 1, c], z)
    half = mp.mpf(1) / 2
    first = half**s / s * mp.hyper([s, a, b], [s + 1, c], half)
    # 15.8.4 written out once: the integrand is analytic in u.
    d = c - a - b
    A = mp.gamma(c) * mp.gamma(d) * mp.rgamma(c - a) * mp.rgamma(c - b)
    B = mp.gamma(c) * mp.gamma(-d) * mp.rgamma(a) * mp.rgamma(b)

    def integrand(u):
        w = u * u
        if w == 0:
            w = mp.mpf(10) ** (-200)
        value = A * mp.hyp2f1(a, b, 1 - d, w) + B * w**d * mp.hyp2f1(c - a, c - b, 1 + d, w)
        return 2 * u * (1 - w) ** (s - 1) * value

    second = mp.quad(integrand, [mp.sqrt(y), mp.sqrt(half)], method="gauss-legendre")
    return s * z ** (-s) * (first + second)


# Parametric excess of 2F1 at or next to an integer.
LOGARITHMIC3 = [(1.0, 0.5, 0.5, 1.0), (0.4, 0.5, 1.5, 2.0), (0.7, 1.2, 0.8, 1.01),
                (1.3, 0.3, 0.7, 2.02), (0.5, 2.0, 1.5, 1.52), (2.5, -0.3, 1.3, 1.0)]


def three_logarithmic(s, a, b, c, y):
    """s z^-s int_0^z t^(s-1) 2F1 dt, the last part on intervals halving towards 1."""
    s, a, b, c = (mp.mpf(v) for v in (s, a, b, c))
    z = 1 - y
    half = mp.mpf(1) / 2
    if z <= half:
        return mp.hyper([s, a, b], [s + 1, c], z)
    total = half**s / s * mp.hyper([s, a, b], [s + 1, c], half)
    points = [half]
    while points[-1] > max(y, mp.mpf(10) ** (-3)):
        points.append(max(points[-1] / 4, y))
    if points[-1] > y:
        points.append(y)

    def integrand(w):
        return (1 - w) ** (s - 1) * mp.hyp2f1(a, b, c, 1 - w)

    with mp.workdps(60):
        total -= mp.quad(integrand, points, method="tanh-sinh")
    return s * z ** (-s) * total


def wide(generator, largest):
    """Random parameters, excess near integers now and then."""
    rows = []
    while len(rows) < 2000:
        a, b = (generator.uniform(-largest, largest) for _ in range(2))
        c = generator.uniform(0.05, largest)
        if generator.random() < 0.2:
            c = a + b + generator.choice([-1, 0, 1, 2]) + generator.choice([0, 1e-9, 1e-3, 0.03])
        if c <= 0.01 or abs(c) > largest:
            continue
        x = generator.choice([generator.uniform(0, 1), 1 - 10 ** generator.uniform(-12, 0)])
        rows.append((a, b, c, x))
    return rows


def write(path, head, digits, rows):
    with open(path, "w") as file:
        file.write("# generator: reference/special_hypergeometric.py\n")
        file.write(f"# accuracy: 22 digits, of {digits}\n# date: 2026-11-21\n{head}\n")
        for row in rows:
            file.write(",".join(v if isinstance(v, str) else repr(v) for v in row) + "\n")


def number(value):
    return mp.nstr(value, 22)


def main():
    folder = sys.argv[1]
    sets = [s(p) for s in SETS for p in PHI] + FIXED
    rows = []
    for a, b, c in sets:
        for x, y in arguments():
            if y == 0 and c - a - b <= 0 and not (a <= 0 and a == int(a)):
                continue
            rows.append((a, b, c, x, float(y), number(gauss(a, b, c, y))))
    write(f"{folder}/gauss.csv", "a,b,c,x,complement,F", "60 and more", rows)

    rows = [(a, b, c, x, float(1 - mp.mpf(x)), number(gauss(a, b, c, 1 - mp.mpf(x))))
            for a, b, c, x in wide(random.Random(1992), 5.0)]
    write(f"{folder}/gauss_wide.csv", "a,b,c,x,complement,F", "60 and more", rows)

    rows = []
    for s, a, b, c in [f(p) for f in SETS3 for p in PHI] + FIXED3:
        for x, y in arguments():
            rows.append((s, a, b, c, x, float(y), number(three(s, a, b, c, y))))
    write(f"{folder}/three_f_two.csv", "s,a,b,c,x,complement,F", "40", rows)

    rows = []
    for s, a, b, c in LOGARITHMIC3:
        for y in (0.6, 0.49, 0.3, 0.1, 1e-2, 1e-3, 1e-5):
            value = three_logarithmic(s, a, b, c, mp.mpf(y))
            rows.append((s, a, b, c, float(1 - mp.mpf(y)), y, number(value)))
    rows.append((1.0, 0.5, 0.5, 1.0, 1.0, 0.0, number(4 / mp.pi)))
    # 3F2(s, a, b; s + 1, b; 1) = gamma(s + 1) gamma(1 - a)/gamma(s + 1 - a), excess -a.
    for s, a in ((0.7, 0.99), (0.4, 0.97), (1.5, 1e-3), (2.5, -1.0 + 1e-4)):
        x, w = mp.mpf(a), mp.mpf(s)
        value = mp.gamma(w + 1) * mp.gamma(1 - x) / mp.gamma(w + 1 - x)
        rows.append((s, a, 1.25, 1.25, 1.0, 0.0, number(value)))
    write(f"{folder}/three_f_two_logarithmic.csv", "s,a,b,c,x,complement,F", "60", rows)


if __name__ == "__main__":
    main()
