"""Warnings where results leave the theory."""

from __future__ import annotations

import os
import sys
import warnings

PACKAGE = os.path.dirname(__file__)


class CaromWarning(UserWarning):
    """What a result leaves out is noticeable, but the result holds: what the command tells as `warning:`.

    For example, elastic waves would carry away more than 1 % of the energy, the spin about the normal is left alone, or
    the coupling of dissimilar materials is neglected.
    """


class OutsideTheoryWarning(CaromWarning):
    """Results exceed a limit of the theory. The text says by how much, and of many results which is the worst.

    The limits are those of the command: the contact radius over the radius of curvature 0.1, the approach over it 0.1,
    the greatest pressure 1.6 times the yield stress of a material that has one, energy carried away by elastic waves
    10 %. The text begins with OUTSIDE THE THEORY where results are approximate at best. The warnings of each impact are
    also in `Rebound.warnings`.

    >>> import carom, warnings
    >>> rubber = carom.Material(1e6, 0.49)
    >>> ball = carom.sphere(0.03, rubber, 0.057, velocity=(0, 0, -5))
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     rebound = carom.collide(ball, carom.plane(carom.RIGID), friction=0.5)
    >>> told[0].category.__name__, "large contact" in str(told[0].message)
    ('OutsideTheoryWarning', True)
    """


def warn(told: tuple[list[str], bool]) -> None:
    """Warns once of all that results exceed, each in a line, at the call of the user: the first outside the package.

    `told` is the texts, and whether a limit of the theory is exceeded.
    """
    texts, is_outside = told
    if texts:
        category = OutsideTheoryWarning if is_outside else CaromWarning
        frame, depth = sys._getframe().f_back, 2
        while frame is not None and os.path.dirname(frame.f_code.co_filename) == PACKAGE:
            frame, depth = frame.f_back, depth + 1
        warnings.warn("\n".join(texts), category, stacklevel=depth)
