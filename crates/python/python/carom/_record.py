"""The base classes of all results."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, ClassVar, Generic, TypeVar, overload

import numpy as np

from . import _show
from ._carom import meant, renamed
from ._types import Array

if TYPE_CHECKING:
    import pandas
    import xarray
    from numpy.typing import NDArray
    from typing_extensions import Self

One = TypeVar("One", bound="Record")


def same(one: Any, other: Any) -> bool:
    """Whether two values are equal; NaN equals NaN."""
    if isinstance(one, np.ndarray) or isinstance(other, np.ndarray):
        floats = np.asarray(one).dtype.kind == "f"
        return np.array_equal(one, other, equal_nan=floats and np.asarray(other).dtype.kind == "f")
    return bool(one == other) or bool(one != one and other != other)


def _plain(value: Any) -> Any:
    """Numbers and lists of Python in place of those of numpy, None in place of NaN, and mappings in place of results."""
    if isinstance(value, Result):
        return value.to_dict()
    if isinstance(value, np.ndarray) and value.dtype.kind == "f":
        plain = value.astype(object)
        plain[np.isnan(value)] = None
        return plain.tolist()
    value = value.tolist() if isinstance(value, np.ndarray | np.generic) else value
    return None if isinstance(value, float) and value != value else value


class Result:
    """Named quantities. Two results are equal if all their quantities are; NaN equals NaN."""

    units: ClassVar[dict[str, str]]
    meanings: ClassVar[dict[str, str]]
    #: What is to be told beside the quantities.
    _note: str = ""

    def __init__(self, columns: dict[str, Any]) -> None:
        for name in self.units:
            value = columns[name]
            if isinstance(value, np.ndarray):
                # A view: the array of the caller stays writable.
                value = value.view()
                value.flags.writeable = False
            object.__setattr__(self, name, value)

    def __getattr__(self, name: str) -> Any:
        # Only names that are not there come here.
        own = type(self).__name__
        if name.startswith("_"):
            raise AttributeError(f"{own} has no attribute {name}")
        new = renamed(name)
        if new in self.units:
            raise AttributeError(f"{own}.{name} is now called {new}")
        raise AttributeError(f"{own} has no {name}{meant(name, list(self.units))}")

    def __setattr__(self, name: str, value: Any) -> None:
        raise AttributeError(f"{name}: results cannot be changed")

    def __delattr__(self, name: str) -> None:
        raise AttributeError(f"{name}: results cannot be changed")

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)

    def _noting(self, note: str) -> Self:
        """The same result, whose text tells this too."""
        if note:
            object.__setattr__(self, "_note", note)
        return self

    def _values(self) -> dict[str, Any]:
        """The quantities by name."""
        return {name: getattr(self, name) for name in self.units}

    def to_dict(self) -> dict[str, Any]:
        """The quantities by name, as numbers, texts and lists, which `json.dumps` takes; None, in JSON null, where one has no value."""
        return {name: _plain(value) for name, value in self._values().items()}

    def __eq__(self, other: object) -> bool:
        if type(self) is not type(other):
            return NotImplemented
        return all(same(value, getattr(other, name)) for name, value in self._values().items())

    __hash__ = None  # type: ignore[assignment]

    def _title(self) -> str:
        return type(self).__name__

    def _rows(self) -> list[_show.Row]:
        """Name, value, unit and meaning of each quantity that has a value."""
        told = ((name, value) for name, value in self._values().items() if not _show.is_nothing(value))
        return [(name, _show.short(value), self.units[name], self.meanings[name]) for name, value in told]

    def __repr__(self) -> str:
        return "\n".join([_show.text(self._title(), self._rows()), *self._note.splitlines()])

    def _repr_html_(self) -> str:
        title = f"{self._title()}, {' '.join(self._note.splitlines())}" if self._note else self._title()
        return _show.html(title, self._rows())


class Record(Result):
    """A result: named quantities. `units` and `meanings` describe them."""

    _vectors: ClassVar[frozenset[str]]
    #: The name of one among many; many records are an axis of this name.
    _axis: ClassVar[str]

    @classmethod
    def _of(cls, columns: dict[str, Any]) -> Self:
        """Makes a result from the first row of native columns."""

        def first(values: Any) -> Any:
            return values[0] if isinstance(values, list) or values.ndim > 1 else values[0].item()

        return cls({name: first(values) for name, values in columns.items()})

    def _shape(self) -> tuple[int, ...]:
        return ()

    def _cells(self) -> dict[str, Any]:
        """The columns by name, flat; vectors are split into components."""
        cells: dict[str, Any] = {}
        for name, values in self._values().items():
            if name in self._vectors:
                for axis, part in zip("xyz", np.moveaxis(values, -1, 0), strict=True):
                    cells[f"{name}_{axis}"] = part.reshape(-1)
            else:
                cells[name] = values if isinstance(values, list) else np.reshape(values, -1)
        return cells

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with one row for each record; the units are in its `attrs`."""
        import pandas

        frame = pandas.DataFrame(self._cells())
        frame.index.name = None if self._axis in frame.columns else self._axis
        units = self.units | {f"{name}_{axis}": self.units[name] for name in self._vectors for axis in "xyz"}
        frame.attrs["units"] = {name: units[name] for name in frame.columns}
        return frame

    def _dims(self) -> list[str]:
        """The names of the axes, without those of vectors."""
        count = len(self._shape())
        return [self._axis] if count == 1 else [f"{self._axis}_{i}" for i in range(count)]

    def to_xarray(self) -> xarray.Dataset:
        """A data set with units and meanings as attributes."""
        import xarray

        def variable(name: str, values: Any) -> Any:
            texts = isinstance(values, list)
            array = np.array(values, dtype=object).reshape(self._shape()) if texts else np.asarray(values)
            dims = self._dims() + ["axis"] * (name in self._vectors)
            about = {"units": self.units[name], "long_name": self.meanings[name]}
            return xarray.Variable(dims, array, about)

        variables = {name: variable(name, values) for name, values in self._values().items()}
        coordinates = {"axis": xarray.Variable(["axis"], list("xyz"))} if self._vectors else {}
        return xarray.Dataset(variables, coordinates)


class Records(Record, Generic[One]):
    """Many results: each quantity is an array, texts are lists.

    `records[i]` is one of them, `records[i:j]` and a mask give several; they can be counted and iterated over.
    """

    _one: ClassVar[type[Any]]
    #: Name, unit and values of the field that a case sweeps over; None without a sweep.
    _swept: tuple[str, str, Array] | None = None

    def __init_subclass__(cls, one: type[Record]) -> None:
        cls._one, cls._axis, cls._vectors = one, one._axis, one._vectors
        cls.units, cls.meanings = one.units, one.meanings

    @classmethod
    def _shaped(
        cls,
        columns: dict[str, Any],
        shape: tuple[int, ...],
        swept: tuple[str, str, Array] | None = None,
    ) -> Self:
        """Makes results from native columns, in the shape of the input."""

        def shaped(values: Any) -> Any:
            return values if isinstance(values, list) else values.reshape(shape + values.shape[1:])

        records = cls({name: shaped(values) for name, values in columns.items()})
        if swept is not None:
            object.__setattr__(records, "_swept", swept)
        return records

    @classmethod
    def _either(cls, columns: dict[str, Any], shape: tuple[int, ...]) -> Any:
        """One result if the input was a number, otherwise many in its shape."""
        return cls._shaped(columns, shape) if shape else cls._one._of(columns)

    def _shape(self) -> tuple[int, ...]:
        name, values = next((n, v) for n, v in self._values().items() if isinstance(v, np.ndarray))
        shape: tuple[int, ...] = values.shape
        return shape[:-1] if name in self._vectors else shape

    @property
    def shape(self) -> tuple[int, ...]:
        """The shape of each quantity, without the components of vectors."""
        return self._shape()

    def __len__(self) -> int:
        return self._shape()[0]

    @overload
    def __getitem__(self, index: int | np.integer[Any] | tuple[int, ...]) -> One: ...
    @overload
    def __getitem__(self, index: slice | NDArray[Any] | list[int]) -> Self: ...
    def __getitem__(self, index: Any) -> Any:
        shape = self._shape()
        place = np.arange(int(np.prod(shape))).reshape(shape)[index]
        taken = {
            name: [values[i] for i in np.ravel(place)] if isinstance(values, list) else values[index]
            for name, values in self._values().items()
        }
        if np.ndim(place):
            swept = self._swept and (*self._swept[:2], self._swept[2][index])
            return self._shaped(taken, np.shape(place), swept)
        flat = {n: v if isinstance(v, list) else np.asarray(v)[np.newaxis] for n, v in taken.items()}
        return self._one._of(flat)

    def __iter__(self) -> Iterator[One]:
        return (self[i] for i in range(len(self)))

    def __eq__(self, other: object) -> bool:
        equal = super().__eq__(other)
        if equal is not True or not isinstance(other, Records):
            return equal
        if self._swept is None or other._swept is None:
            return self._swept is other._swept
        return all(same(one, two) for one, two in zip(self._swept, other._swept, strict=True))

    __hash__ = None  # type: ignore[assignment]

    def _title(self) -> str:
        return f"{type(self).__name__} ({' x '.join(map(str, self._shape()))})"

    def _rows(self) -> list[_show.Row]:
        own = super()._rows()
        if self._swept is None:
            return own
        name, unit, values = self._swept
        return [(name, _show.short(values), unit, "swept"), *own]

    def _repr_html_(self) -> str:
        shape = self._shape()
        if len(shape) != 1:
            return super()._repr_html_()
        columns = {} if self._swept is None else {self._swept[0]: (self._swept[1], "swept", self._swept[2])}
        columns |= {
            name: (self.units[name], self.meanings[name], values)
            for name, values in self._values().items()
            if not _show.is_nothing(values)
        }
        return _show.html_table(self._title(), columns, shape[0])

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with one row for each record; the units are in its `attrs`."""
        frame = super().to_pandas()
        if self._swept is not None:
            import pandas

            frame.index = pandas.Index(self._swept[2], name=self._swept[0])
        return frame

    def _dims(self) -> list[str]:
        return super()._dims() if self._swept is None else [self._swept[0]]

    def to_xarray(self) -> xarray.Dataset:
        """A data set with units and meanings as attributes.

        Of a sweep, its field is the coordinate; otherwise time or the number of the step is, if there is one.
        """
        data = super().to_xarray()
        if self._swept is not None:
            name, unit, values = self._swept
            return data.assign_coords({name: (name, values, {"units": unit})})
        return data
