"""The regime of a contact."""

import carom
import pytest

HERTZ = carom.hertz_of_spheres(0.01, 0.01, carom.Material(208e9, 0.3))


@pytest.mark.parametrize("law", ["coulomb", "fixed-direction", "rings"])
@pytest.mark.parametrize("heat", [True, False])
def test_bodies_that_have_parted_are_separated(law, heat):
    contact = carom.Contact(HERTZ, 0.3, law=law, heat=heat)
    assert contact.regime == "separated"
    for parted in (0.0, -1e-7):
        contact.advance(1e-6)
        contact.advance(1e-6, 1e-5)
        assert contact.regime == "sliding"
        assert contact.advance(parted, 1e-5) == (0.0, 0.0, 0.0) and contact.regime == "separated"
        contact.advance(1e-6, 1e-5)
        assert contact.regime == "adhesion"
    # As all of a path.
    contact.follow([1e-6, 0.0], [1e-5, 1e-5])
    assert contact.regime == "separated" and contact.sticking in (0.0, 1.0)
