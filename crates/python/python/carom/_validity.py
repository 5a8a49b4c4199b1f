"""Warnings where results leave the theory."""

from __future__ import annotations

import warnings


class OutsideTheoryWarning(UserWarning):
    """Results exceed a limit of the theory. The text says by how much, and of many results which is the worst.

    The warnings of each impact are also in `Rebound.warnings`.

    >>> import carom, warnings
    >>> rubber = carom.Material(1e6, 0.49)
    >>> ball = carom.sphere(0.03, rubber, 0.057, velocity=(0, 0, -5))
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     rebound = carom.collide(ball, carom.plane(carom.RIGID), friction=0.5)
    >>> told[0].category.__name__, "large contact" in str(told[0].message)
    ('OutsideTheoryWarning', True)
    """


def warn(texts: list[str], depth: int = 3) -> None:
    """Warns once of all limits that results exceed, each in a line; `depth` functions up stands the call of the user."""
    if texts:
        warnings.warn("\n".join(texts), OutsideTheoryWarning, stacklevel=depth)
