"""Recomputes reference values from the inputs in their rows, in up to 80 digits, and compares.

Run: python3 recompute.py   (needs mpmath; half a minute)

Each function below takes the inputs of a row and returns its outputs by definition: integrals by
quadrature or by mpmath's own functions, none by a formula of carom. A table is written again by
printing the same outputs to 25 digits.
"""

import csv
import pathlib

import mpmath as mp

from special_complete import complete
from special_hypergeometric import three

mp.mp.dps = 50
DATA = pathlib.Path(__file__).parent.parent / "data"


def complete_by_argument(kind, argument):
    """kind 0: axis ratio k', 1: modulus k, 2: parameter m = k^2."""
    kc = [argument, mp.sqrt(1 - argument**2), mp.sqrt(1 - argument)][int(kind)]
    return complete(kc) if kc != 0 else None


def incomplete_by_modulus(phi, modulus):
    return mp.ellipf(phi, modulus**2), mp.ellipe(phi, modulus**2)


def impact_functions(phi, s):
    def gauss(i, c, x):
        return mp.hyp2f1((i - phi) / 20, (i + phi) / 20, mp.mpf(c) / 10, x)

    def integral(first, i, c):
        return three(mp.mpf(first) / 10, (i - phi) / 20, (i + phi) / 20, mp.mpf(c) / 10, 1 - s)

    return (gauss(1, 6, s), gauss(9, 14, s), gauss(1, 5, 1 - s), gauss(11, 15, 1 - s),
            integral(4, 11, 6), integral(8, 19, 14), gauss(11, 16, s), gauss(-1, 4, s))


def time(s):
    """(9.8): the integral of dz/sqrt(1 - z^(5/2)) to z = s^(2/5)."""
    end = s ** (mp.mpf(2) / 5)
    # z = 1 - q^2 takes the root at the end away.
    return (mp.quad(lambda q: 2 * q / mp.sqrt(1 - (1 - q * q) ** mp.mpf(2.5)),
                    [mp.sqrt(1 - end), (1 + mp.sqrt(1 - end)) / 2, 1]),)


def no_slip(chi):
    """(9.46): R_x = 1 - 2 u^2, u the adhesion solution F(...; 1/2; 1) by its gamma functions."""
    phi = mp.sqrt(1 + 120 * chi)
    u = mp.gammaprod([mp.mpf(3) / 5, mp.mpf(1) / 2], [(11 - phi) / 20, (11 + phi) / 20])
    return (1 - 2 * u * u,)


def principal_curvatures(r1, r1_across, r2, r2_across, omega):
    """Eigenvalues of half the sum of both curvature forms; the angle from R1 to the larger."""
    k = [1 / r for r in (r1, r1_across, r2, r2_across)]
    c, s = mp.cos(omega), mp.sin(omega)
    xx = (k[0] + k[2] * c * c + k[3] * s * s) / 2
    yy = (k[1] + k[2] * s * s + k[3] * c * c) / 2
    xy = (k[2] - k[3]) * c * s / 2
    mean, radius = (xx + yy) / 2, mp.sqrt(((xx - yy) / 2) ** 2 + xy * xy)
    return mean + radius, mean - radius, mp.atan2(2 * xy, xx - yy) / 2


def corners(function, width_x, width_y, offset_x, offset_y):
    """The double integral over the rectangle of a function with this antiderivative."""
    x = [offset_x - width_x / 2, offset_x + width_x / 2]
    y = [offset_y - width_y / 2, offset_y + width_y / 2]
    return sum((1 if i == j else -1) * function(x[i], y[j]) for i in (0, 1) for j in (0, 1))


def integrals(width_x, width_y, offset_x, offset_y):
    """(4.29): of 1/r, r_xx, r_yy, r_xy, x/r^2, y/r^2 over the rectangle, in closed form."""
    def log(x, y):
        r = mp.hypot(x, y)
        if r == 0:
            return mp.mpf(0)
        return mp.log(y + r) if y >= 0 else mp.log(x * x / (r - y)) if x else mp.mpf(0)

    def times(factor, value):
        return factor * value if factor else mp.mpf(0)

    def xx(x, y):  # of y^2/r^3 it is x log(y + r)
        return times(x, log(x, y))

    def yy(x, y):  # of x^2/r^3
        return times(y, log(y, x))

    def xy(x, y):  # of -x y/r^3 is r
        return mp.hypot(x, y)

    def half_log(x, y):  # of x/r^2 is (y ln r^2)/2 + x atan(y/x) - y
        return times(y, mp.log(x * x + y * y) / 2 if x or y else 0) + times(x, mp.atan(y / x) if x else 0)

    place = (width_x, width_y, offset_x, offset_y)
    a, b = corners(xx, *place), corners(yy, *place)
    log_x = corners(half_log, *place)
    log_y = corners(lambda x, y: half_log(y, x), *place)
    return a + b, a, b, corners(xy, *place), log_x, log_y


def hertz_parameters(ratio):
    """(5.12), (5.25a): (3/(2 pi)) k' E, E/K, B/E = A/(A + B), D/K."""
    K, E, D, B, _ = complete(ratio)
    return 3 / (2 * mp.pi) * ratio * E, E / K, B / E, D / K


def influence(columns, rows, width_x, width_y, shear_1, poisson_1, shear_2, poisson_2):
    """(4.14): relative displacements (u1-u2, v1-v2, w1+w2) by unit tractions (x, y, pressure)."""
    at = integrals(width_x, width_y, columns * width_x, rows * width_y)
    distance, xx, yy, xy, x, y = at
    bodies = [(1 / (2 * mp.pi * shear_1), poisson_1, 1), (1 / (2 * mp.pi * shear_2), poisson_2, -1)]

    def total(term):
        return mp.fsum(flexibility * term(nu, side) for flexibility, nu, side in bodies)

    across = total(lambda nu, _: -nu * xy)
    couple = total(lambda nu, side: side * (1 - 2 * nu) / 2)
    return (total(lambda nu, _: distance - nu * xx), across, couple * x,
            across, total(lambda nu, _: distance - nu * yy), couple * y,
            -couple * x, -couple * y, total(lambda nu, _: (1 - nu) * distance))


def ellipsoid_traction(x, y, a, b, shear, poisson):
    """u, v at a point inside by the traction sqrt(1 - x^2/a^2 - y^2/b^2) along x.

    About the point, with (a cos t, b sin t) for directions, 1/r drops out of the double integral
    and along a ray the traction integrates to what it does along the cord of a circle.
    """
    p, q = x / a, y / b

    def ray(t):
        slope = p * mp.cos(t) + q * mp.sin(t)
        whole = 1 - p * p - q * q + slope**2
        start = slope / mp.sqrt(whole)
        return whole / 2 * (mp.acos(start) - start * mp.sqrt(1 - start**2))

    def integral(weight):
        # Opposite directions together, as t and t + pi; panels halve towards the narrow ones.
        def both(t):
            c, s = a * mp.cos(t), b * mp.sin(t)
            size = mp.hypot(c, s)
            return weight(c / size, s / size) / size * (ray(t) + ray(t + mp.pi))

        narrow = mp.mpf(0) if a <= b else mp.pi / 2
        steps = [mp.pi / 2 / 3**i for i in range(int(mp.log(max(a / b, b / a), 3)) + 2)]
        places = [narrow - step for step in steps] + [narrow] + [narrow + s for s in steps[::-1]]
        return mp.quad(both, places)

    scale = a * b / (2 * mp.pi * shear)
    return (scale * integral(lambda c, s: 1 - poisson * s * s),
            scale * integral(lambda c, s: poisson * s * c))


def cattaneo(ratio, nu, c_z, f, zeta, xi, eta):
    """(5.25a), (5.26), (5.27): stick depth over the approach, F_x, F_y, F_z."""
    K, _, D, B, _ = complete(ratio)
    # x lies along a: compliances of (1 - nu + nu cos^2) and (1 - nu + nu sin^2) over the angles.
    c_x, c_y = (c_z * (1 - nu) * K / (K - nu * part) for part in (D, B))
    normal = 2 * c_z * zeta ** mp.mpf(1.5) / 3
    size = mp.hypot(c_x * xi, c_y * eta)
    if size == 0:
        return mp.mpf(1), mp.mpf(0), mp.mpf(0), normal
    depth = max(1 - size / (f * c_z * zeta), 0)
    force = f * normal * (1 - depth ** mp.mpf(1.5))
    return depth, force * c_x * xi / size, force * c_y * eta / size, normal


TABLES = {
    "special/complete_by_argument.csv": (2, complete_by_argument, 80),
    "special/incomplete_by_modulus.csv": (2, incomplete_by_modulus, 80),
    "special/impact_functions.csv": (2, impact_functions, 80),
    "impact/time.csv": (1, time, 80),
    "impact/no_slip.csv": (1, no_slip, 80),
    "laws/principal_curvatures.csv": (5, principal_curvatures, 80),
    "laws/hertz_parameters.csv": (1, hertz_parameters, 80),
    "halfspace/integrals.csv": (4, integrals, 80),
    "halfspace/influence.csv": (8, influence, 80),
    "halfspace/ellipsoid_traction.csv": (6, ellipsoid_traction, 20),
    "laws/cattaneo.csv": (7, cattaneo, 80),
}


def exact(text):
    """An input: the double that it is, or all digits if it has more than a double."""
    digits = len(text.split("e")[0].replace(".", "").lstrip("-0"))
    return mp.mpf(text) if digits > 17 else mp.mpf(float(text))


def main():
    for path, (inputs, function, digits) in TABLES.items():
        with open(DATA / path) as file:
            rows = list(csv.reader(line for line in file if not line.startswith("#")))[1:]
        worst, count, at = mp.mpf(0), 0, None
        for row in rows:
            with mp.workdps(digits):
                values = function(*[exact(text) for text in row[:inputs]])
                if values is None:
                    continue
                largest = max(map(abs, values))
                for value, text in zip(values, row[inputs:]):
                    # A zero by symmetry is compared with the largest of its row.
                    size = abs(mp.mpf(text))
                    size = size if size > largest * mp.mpf("1e-60") else largest or 1
                    error = abs(value - mp.mpf(text)) / size
                    count += 1
                    if error > worst:
                        worst, at = error, (row[:inputs], mp.nstr(value, 25), text)
        print(f"{path}: {count} values, largest relative difference {mp.nstr(worst, 2)}", at or "")


if __name__ == "__main__":
    main()
