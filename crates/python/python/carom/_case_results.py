"""Results of cases that are more than records of numbers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._record import Result
from ._records import (
    BellowsResponse,
    BellowsStates,
    Bounces,
    CreepCoefficients,
    FlangeSummary,
    HertzState,
    PathEvents,
    PathPoint,
    PathPoints,
    Rebound,
    Rebounds,
    RingPlaces,
    RollStates,
    SolverSteps,
    WallPlaces,
)
from ._solver import FIELDS
from ._types import Array

if TYPE_CHECKING:
    import xarray


class Sweep(Rebounds, one=Rebound):
    """The impacts of a case that sweeps over one of its fields."""

    @property
    def swept(self) -> tuple[str, str, Array]:
        """Name, unit and values of that field: the index of `to_pandas` and the coordinate of `to_xarray`."""
        assert self._swept is not None
        return self._swept


class Gridded(Result):
    """A contact on a grid. Fields are arrays (ny, nx)."""

    x: Array
    y: Array
    pressure: Array
    traction_x: Array
    traction_y: Array
    displacement_x: Array
    displacement_y: Array
    cells: NDArray[np.int8]
    warnings: list[str]

    meanings = {
        "x": "cell centres",
        "y": "cell centres",
        "pressure": "at the end",
        "traction_x": "on body 1",
        "traction_y": "on body 1",
        "displacement_x": "elastic, of body 1 against body 2",
        "displacement_y": "elastic, of body 1 against body 2",
        "cells": "0 separated, 1 sticks, 2 slips",
        "warnings": "reasons to distrust the result",
    }
    units = dict(zip(meanings, ("m", "m", "Pa", "Pa", "Pa", "m", "m", "", ""), strict=True))


def gridded(
    axes: list[Array], fields: list[Array], cells: NDArray[np.int8], warnings: list[str]
) -> dict[str, Any]:
    """Fields of a grid by name, in its shape."""
    x, y = axes
    shape = (len(y), len(x))
    named = dict(zip(FIELDS, (field.reshape(shape) for field in fields), strict=True))
    return {"x": x, "y": y, **named, "cells": cells.reshape(shape), "warnings": warnings}


class Solved(Gridded):
    """A contact on a grid after all its steps. Fields are arrays (ny, nx) after the last step.

    steps           the contact after each step, arrays (n,)
    x, y            cell centres, (nx,) and (ny,), m
    pressure        Pa
    traction_x, _y  on body 1, Pa
    displacement_x, _y  elastic, of body 1 against body 2, m
    cells           state of each: 0 separated, 1 sticks, 2 slips
    warnings        reasons to distrust the result: few cells, a plate bent by more than half its thickness
    """

    steps: SolverSteps

    meanings = {"steps": "the contact after each step"} | Gridded.meanings
    units = {"steps": ""} | Gridded.units


class Rolled(Gridded):
    """A rolling contact. Fields are arrays (ny, nx) of the last contact, as in `Solved`.

    rows          the contact under each drive, or from rest after each step, arrays (n,)
    coefficients  Kalker's creep coefficients, if they were asked for
    """

    rows: RollStates
    coefficients: CreepCoefficients | None

    meanings = {"rows": "the contact under each drive", "coefficients": "Kalker's"} | Gridded.meanings
    units = {"rows": "", "coefficients": ""} | Gridded.units


class Stresses(Result):
    """Stresses below a contact.

    contact        the contact under its normal force
    stick_radius   radius of the stick area over that of the contact
    x, y, depth    the places, (nx,), (ny,) and (n,), m
    stress         (xx, yy, zz, xy, yz, zx) along the last axis, tension positive, (n, ny, nx, 6), Pa
    von_mises      equivalent stress, (n, ny, nx), Pa
    maximum_shear  half of Tresca's equivalent stress, (n, ny, nx), Pa
    """

    contact: HertzState
    stick_radius: float
    x: Array
    y: Array
    depth: Array
    stress: Array
    von_mises: Array
    maximum_shear: Array

    meanings = {
        "contact": "under its normal force",
        "stick_radius": "of the stick area over that of the contact",
        "x": "along the larger relative curvature",
        "y": "perpendicular to x",
        "depth": "below the surface",
        "stress": "xx, yy, zz, xy, yz, zx along the last axis",
        "von_mises": "equivalent stress",
        "maximum_shear": "half of Tresca's equivalent stress",
    }
    units = dict(zip(meanings, ("", "", "m", "m", "m", "Pa", "Pa", "Pa"), strict=True))

    def to_xarray(self) -> xarray.Dataset:
        """A data set over depth, y and x, with units and meanings as attributes."""
        import xarray

        def variable(name: str, dims: list[str]) -> xarray.Variable:
            about = {"units": self.units[name], "long_name": self.meanings[name]}
            return xarray.Variable(dims, getattr(self, name), about)

        places = ["depth", "y", "x"]
        fields = {name: variable(name, places) for name in ("von_mises", "maximum_shear")}
        fields["stress"] = variable("stress", [*places, "component"])
        coordinates = {name: variable(name, [name]) for name in places}
        coordinates["component"] = xarray.Variable(["component"], ["xx", "yy", "zz", "xy", "yz", "zx"])
        return xarray.Dataset(fields, coordinates)


class Scene(Result):
    """The path of a ball between walls.

    bounces  each bounce, arrays (n,)
    events   bounces, highest points, where the ball begins to slide or to roll, and the end, arrays (k,)
    ending   why the path ends, in words
    end      the ball at the end
    path     instants of every flight, arrays (m,); none unless they were asked for
    """

    bounces: Bounces
    events: PathEvents
    ending: str
    end: PathPoint
    path: PathPoints

    meanings = {
        "bounces": "each bounce",
        "events": "bounces, highest points, where the ball begins to slide or to roll, and the end",
        "ending": "why the path ends",
        "end": "the ball at the end",
        "path": "instants of every flight",
    }
    units = dict.fromkeys(meanings, "")


class Bellows(Result):
    """A bellows under each load of a case.

    response  spring rate and effective area under small loads
    loads     the bellows under each load, arrays (n,); forces, lengths and energies of all corrugations
    places    displacements and stresses of a corrugation from crest to root after the last load, arrays (m,)
    warnings  reasons to distrust the result
    """

    response: BellowsResponse
    loads: BellowsStates
    places: WallPlaces
    warnings: list[str]

    meanings = {
        "response": "to small loads",
        "loads": "the bellows under each load",
        "places": "from crest to root after the last load",
        "warnings": "reasons to distrust the result",
    }
    units = dict.fromkeys(meanings, "")


class Flange(Result):
    """A flange under the forces of a case.

    summary   greatest absolute values around, and what tells of their accuracy
    places    displacements and loads around, with a place for each force, arrays (n,)
    warnings  reasons to distrust the result
    """

    summary: FlangeSummary
    places: RingPlaces
    warnings: list[str]

    meanings = {
        "summary": "greatest values around",
        "places": "around the ring",
        "warnings": "reasons to distrust the result",
    }
    units = dict.fromkeys(meanings, "")
