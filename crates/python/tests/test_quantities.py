"""Quantities with units: converted to the unit of the argument, or refused by its name."""

import inspect

import carom
import numpy as np
import pytest
from every_call import CALLS, HERTZ, NO_CALLS, STEEL, numbers, public, same

ALL = {f"{name} {argument} {i}": (call, argument, one) for i, (name, call, argument, one) in enumerate(numbers())}
#: How many of the smaller unit make the unit of an argument; a power of 2, so that no digit is lost.
MANY = 1024.0


class Silent(np.ndarray):
    """Like the quantities that shed their unit wherever plain numbers are read."""

    def __new__(cls, values, units):
        made = np.asarray(values).view(cls)
        made.units = units
        return made

    def __array_finalize__(self, other):
        self.units = getattr(other, "units", None)

    def to_value(self, unit):
        known = {self.units: 1.0} | ({self.units[1:]: 1 / MANY} if self.units.startswith("µ") else {})
        if unit not in known:
            raise TypeError(f"{self.units} is not {unit}")
        return np.asarray(self) if known[unit] == 1.0 else np.asarray(self) * known[unit]


def apart(quantity):
    """A list of quantities."""
    return [Silent(piece, quantity.units) for piece in np.asarray(quantity)]


def test_the_table_knows_everything_public_and_all_its_arguments():
    for name, one in public():
        if name in NO_CALLS:
            continue
        asked = set(inspect.signature(one).parameters) - {"self"}
        told = {argument for call in CALLS.get(name, []) for argument in call.arguments}
        assert name in CALLS and asked == told, (name, asked ^ told)
    assert {name for name, _ in public()} == CALLS.keys() | NO_CALLS.keys()


@pytest.mark.parametrize("which", ALL)
def test_a_unit_that_does_not_fit_is_refused_by_name(which):
    call, argument, one = ALL[which]
    wrong = Silent(one.value, "furlong")
    for given in (wrong, apart(wrong)) if np.ndim(wrong) and argument != "out" else (wrong,):
        with pytest.raises(ValueError, match=rf"^{argument}: .*furlong: must be"):
            call(**{argument: given})


@pytest.mark.parametrize("which", [which for which, (_, argument, _) in ALL.items() if argument != "out"])
def test_a_unit_that_fits_is_converted(which):
    call, argument, one = ALL[which]
    expected = call()
    dimensionless = Silent(one.value, "")
    assert same(call(**{argument: dimensionless}), expected)
    if one.unit:
        smaller = Silent(np.asarray(one.value) * MANY, "µ" + one.unit)
        assert same(call(**{argument: smaller}), expected)
        if np.ndim(smaller):
            assert same(call(**{argument: apart(smaller)}), expected)


def test_units_of_influence_numbers_are_theirs():
    for call in CALLS["Solver"] + CALLS["roll"]:
        if (blocks := call.arguments.get("influence")) is None:
            continue
        plain = {name: block.value for name, block in blocks.items()}
        expected = call(influence=plain)
        for name, block in blocks.items():
            quantity = Silent(block.value * MANY, "µm/Pa")
            assert same(call(influence=plain | {name: quantity}), expected)
            with pytest.raises(ValueError, match=rf"^influence\['{name}'\]: .* furlong"):
                call(influence=plain | {name: Silent(block.value, "furlong")})


def test_units_of_friction_by_slip_speed_are_plain_afterwards():
    friction = carom.SlipSpeedFriction(0.1, 0.2, Silent(0.9 * MANY, "µs/m"))
    assert friction == carom.SlipSpeedFriction(0.1, 0.2, 0.9) and type(friction.c) is float


class Words:
    """A variable of a file, whose unit is a text."""

    dtype = np.dtype(float)

    def __init__(self, units):
        self.units = units

    def __array__(self, dtype=None, copy=None):
        return np.array([1.0, 2.0])


def test_a_unit_in_words_is_read():
    expected = carom.hertz(HERTZ, force=[1.0, 2.0])
    for words in ("N", "", "1", "dimensionless"):
        assert carom.hertz(HERTZ, force=Words(words)) == expected
    with pytest.raises(ValueError, match="^force: .* has the unit kN: must be in N"):
        carom.hertz(HERTZ, force=Words("kN"))


def maker(package):
    """What makes a quantity of a value and a unit, and the package's name of revolutions a minute."""
    if package == "unyt":
        unyt = pytest.importorskip("unyt")
        return lambda value, unit: (unyt.unyt_array if np.ndim(value) else unyt.unyt_quantity)(value, unit), "rpm"
    if package == "astropy":
        return pytest.importorskip("astropy.units").Quantity, "cycle / min"
    return pytest.importorskip("pint").UnitRegistry().Quantity, "rpm"


@pytest.mark.filterwarnings("error")
@pytest.mark.parametrize("package", ["unyt", "astropy", "pint"])
def test_quantities_of_the_packages_of_units(package):
    quantity, turns = maker(package)
    expected = carom.hertz(HERTZ, force=[1e3, 2e3])
    for force in (quantity([1.0, 2.0], "kN"), [quantity(1.0, "kN"), quantity(2.0, "kN")], (quantity(1.0, "kN"), quantity(2e3, "N"))):
        assert same(carom.hertz(HERTZ, force=force), expected)
    assert same(carom.hertz(HERTZ, force=quantity(np.array(1.0), "kN")), carom.hertz(HERTZ, force=1e3))
    ball = carom.sphere(quantity(20.0, "mm"), STEEL, quantity(30.0, "g"), spin=(quantity(1900.0, turns), 0.0, 0.0))
    assert ball.sizes == pytest.approx([0.02]) and ball.mass == pytest.approx(0.03)
    assert ball.spin == pytest.approx([1900 * 2 * np.pi / 60, 0.0, 0.0])
    assert carom.Material(quantity(208.0, "GPa"), 0.3).young_modulus == pytest.approx(208e9)
    contact, other = carom.Contact(HERTZ, 0.3), carom.Contact(HERTZ, 0.3)
    assert contact.advance(quantity(1.0, "um"), quantity(1e-4, "mm")) == pytest.approx(other.advance(1e-6, 1e-7))
    contact.turn_frame(quantity(90.0, "deg"))
    other.turn_frame(np.pi / 2)
    assert contact.load == pytest.approx(other.load)
    assert carom.fastsim(HERTZ, 0.3, F_z=10.0, spin=quantity(1e-4, "1/mm")).F_y == pytest.approx(carom.fastsim(HERTZ, 0.3, F_z=10.0, spin=0.1).F_y)
    assert carom.restitution(1.2, quantity(2.0, "")) == carom.restitution(1.2, 2.0)
    for wrong, name in (
        (lambda: carom.hertz(HERTZ, force=quantity([1.0, 2.0], "mm")), "force"),
        (lambda: carom.hertz(HERTZ, force=[quantity(1.0, "mm"), 2.0]), "force"),
        (lambda: carom.sphere(quantity(20.0, "s"), STEEL, 1.0), "radius"),
        (lambda: carom.Material(quantity(208.0, "mm"), 0.3), "young_modulus"),
        (lambda: carom.Contact(HERTZ, quantity(0.3, "m")), "friction"),
        (lambda: carom.collide(carom.sphere(0.01, STEEL, 0.1), carom.plane(STEEL), 0.1, relaxation=quantity(1.0, "m")), "relaxation"),
        (lambda: carom.Contacts(quantity(3, "m"), HERTZ, 0.3), "count"),
    ):
        with pytest.raises(ValueError, match=f"^{name}: .* has the unit .*: must be"):
            wrong()


@pytest.mark.filterwarnings("error")
def test_quantities_within_tables_are_seen():
    units = pytest.importorskip("astropy.units")
    unyt = pytest.importorskip("unyt")
    pint = pytest.importorskip("pint").UnitRegistry()
    pandas, xarray = pytest.importorskip("pandas"), pytest.importorskip("xarray")
    expected = carom.hertz(HERTZ, force=[1e3, 2e3])
    for held in (
        pandas.Series([1.0 * units.kN, 2.0 * units.kN]),
        pandas.Series(unyt.unyt_array([1.0, 2.0], "kN")),
        xarray.DataArray(pint.Quantity(np.array([1.0, 2.0]), "kN")),
        xarray.DataArray(unyt.unyt_array([1.0, 2.0], "kN")),
        np.array([1.0 * units.kN, pint.Quantity(2.0, "kN")], dtype=object),
    ):
        assert same(carom.hertz(HERTZ, force=held), expected)
    with pytest.raises(ValueError, match="^force: .* has the unit kN"):
        carom.hertz(HERTZ, force=xarray.DataArray([1.0, 2.0], attrs={"units": "kN"}))
    assert carom.hertz(HERTZ, force=xarray.DataArray([1e3, 2e3], attrs={"units": "N"})) == expected
    # What carom has made itself goes back in.
    assert carom.hertz(HERTZ, force=expected.to_xarray().force) == expected
