"""Warnings where results leave the theory."""

from __future__ import annotations

import warnings
from typing import TypeVar

from ._records import Rebound, Rebounds

Impacts = TypeVar("Impacts", bound="Rebound | Rebounds")


class OutsideTheoryWarning(UserWarning):
    """A contact or an impact exceeds a limit of the theory: see `Rebound.warnings`.

    >>> import carom, warnings
    >>> rubber = carom.Material(1e6, 0.49)
    >>> ball = carom.sphere(0.03, rubber, 0.057, velocity=(0, 0, -5))
    >>> with warnings.catch_warnings(record=True) as told:
    ...     warnings.simplefilter("always")
    ...     rebound = carom.collide(ball, carom.plane(carom.RIGID), friction=0.5)
    >>> told[0].category.__name__, "large contact" in str(told[0].message)
    ('OutsideTheoryWarning', True)
    """


def heed(rebound: Impacts) -> Impacts:
    """Warns once of the limits that these impacts exceed."""
    texts = [rebound.warnings] if isinstance(rebound.warnings, str) else rebound.warnings
    exceeding = [text for text in texts if text]
    if exceeding:
        where = "" if len(texts) == 1 else f" (the first of {len(exceeding)} of {len(texts)} impacts)"
        warnings.warn(exceeding[0] + where, OutsideTheoryWarning, stacklevel=3)
    return rebound
