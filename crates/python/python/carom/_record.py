"""The base class of all results."""

from __future__ import annotations

from dataclasses import fields
from typing import TYPE_CHECKING, Any, ClassVar, Self

import numpy as np

from ._arrays import Array

if TYPE_CHECKING:
    import pandas
    import xarray


class Record:
    """A result: named quantities, each an array if many cases were computed.

    `units` and `meanings` describe them.
    """

    units: ClassVar[dict[str, str]]
    meanings: ClassVar[dict[str, str]]
    #: Name, unit and values of the field that a case sweeps over; None without a sweep.
    swept: ClassVar[tuple[str, str, Array] | None] = None

    @classmethod
    def _of(
        cls,
        columns: dict[str, Any],
        shape: tuple[int, ...],
        swept: tuple[str, str, Array] | None = None,
    ) -> Self:
        """Makes a result from native columns, in the shape of the input; a number takes the first row."""

        def shaped(values: Any) -> Any:
            if isinstance(values, list):
                return values if shape else values[0]
            if not shape:
                return values[0].item() if values.ndim == 1 else values[0]
            return values.reshape(shape + values.shape[1:])

        record = cls(**{name: shaped(values) for name, values in columns.items()})
        if swept is not None:
            object.__setattr__(record, "swept", swept)
        return record

    def to_dict(self) -> dict[str, Any]:
        """The columns by name."""
        return {field.name: getattr(self, field.name) for field in fields(self)}  # type: ignore[arg-type]

    def _cells(self) -> dict[str, Any]:
        """The columns of numbers; vectors are split into components."""
        cells: dict[str, Any] = {}
        for name, values in self.to_dict().items():
            if isinstance(values, np.ndarray) and values.shape[-1:] == (3,) and name in self._vectors:
                for axis, part in zip("xyz", np.moveaxis(values, -1, 0), strict=True):
                    cells[f"{name}_{axis}"] = part.reshape(-1)
            else:
                cells[name] = values if isinstance(values, list) else np.reshape(values, -1)
        return cells

    _vectors: ClassVar[frozenset[str]]

    def to_pandas(self) -> pandas.DataFrame:
        """A data frame with one row for each record; the units are in its `attrs`."""
        import pandas

        frame = pandas.DataFrame(self._cells())
        if self.swept is not None:
            frame.index = pandas.Index(self.swept[2], name=self.swept[0])
        units = self.units | {f"{name}_{axis}": self.units[name] for name in self._vectors for axis in "xyz"}
        frame.attrs["units"] = {name: units[name] for name in frame.columns}
        return frame

    def to_xarray(self) -> xarray.Dataset:
        """A data set with units and meanings as attributes."""
        import xarray

        def variable(name: str, values: Any) -> Any:
            array = np.asarray(values)
            vector = name in self._vectors
            dims = [f"dim_{i}" for i in range(array.ndim - vector)] + ["axis"] * vector
            if self.swept is not None:
                dims[0] = self.swept[0]
            about = {"units": self.units[name], "long_name": self.meanings[name]}
            return xarray.Variable(dims, array, about)

        coordinates = {}
        if self.swept is not None:
            name, unit, values = self.swept
            coordinates[name] = xarray.Variable([name], values, {"units": unit})
        variables = {name: variable(name, x) for name, x in self.to_dict().items()}
        if any("axis" in variable.dims for variable in variables.values()):
            coordinates["axis"] = xarray.Variable(["axis"], list("xyz"))
        return xarray.Dataset(variables, coordinates)
