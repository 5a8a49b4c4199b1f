"""The problem that all programs solve: a paraboloid on an equal one, R = 100 and G = 80000, pressed until a = 1.

The window is a square of side 2.4. `hertz_force` and `hertz_approach` have nu = 0.3 and no friction; `cattaneo`
has nu = 0 and f = 0.4, is pressed by the force and shifted until half of the contact's radius sticks. Where
nu = 0 Cattaneo's solution is exact.
"""

RADIUS, SHEAR, SIDE, FRICTION = 100.0, 80000.0, 2.4, 0.4
CASES = ("hertz_force", "hertz_approach", "cattaneo")


class Problem:
    """What is given in a case, and its closed form."""

    def __init__(self, case):
        self.poisson = 0.0 if case == "cattaneo" else 0.3
        self.modulus = SHEAR / (1 - self.poisson)
        self.force = 4 / 3 * self.modulus / RADIUS
        self.approach = 1 / RADIUS
        self.by_force = case != "hertz_approach"
        self.is_shifted = case == "cattaneo"
        self.shift = 0.75 * 3 * FRICTION * self.force * (2 - self.poisson) / (8 * SHEAR)
        self.tangential = 0.875 * FRICTION * self.force

    def error(self, normal, approach, tangential=None):
        """Relative error of the quantity that is not given."""
        if self.is_shifted:
            return float(abs(tangential) / self.tangential - 1)
        return float(approach / self.approach - 1 if self.by_force else normal / self.force - 1)


def paraboloid(cells):
    """Width of a cell, and the gap at the centres of the cells."""
    import numpy as np

    width = SIDE / cells
    x = (np.arange(cells) + 0.5) * width - SIDE / 2
    return width, (x[:, None] ** 2 + x[None, :] ** 2) / (2 * RADIUS)
