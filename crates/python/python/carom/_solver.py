"""The numerical contact solver: any gap on a grid, any load history."""

from __future__ import annotations

from copy import copy
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _carom, _show
from ._arrays import blocks, counted, counts, line, number, numbers, two
from ._carom import Material, MaterialPair, Plate
from ._records import SolverStep
from ._surface import MISSING, Surface, of_object
from ._types import Array

if TYPE_CHECKING:
    from collections.abc import Mapping

    from typing_extensions import Self

MOTIONS = (("zeta", "F_z"), ("xi", "F_x"), ("eta", "F_y"), ("omega", "M_z"))
UNITS = {"zeta": "m", "xi": "m", "eta": "m", "omega": "rad", "F_z": "N", "F_x": "N", "F_y": "N", "M_z": "N*m"}
#: The form of stored solvers; another one when what they keep changes.
STATE_FORM = 3
FIELDS = ("pressure", "traction_x", "traction_y", "displacement_x", "displacement_y")


def cells(shape: tuple[int, int], size: tuple[float, float]) -> tuple[Array, Array]:
    """x and y of the cell centres, each an array (ny, nx), with the origin in the middle of the window.

    `shape` is (ny, nx), `size` (m) is (along x, along y).

    >>> import carom
    >>> x, y = carom.cells((2, 4), size=(4.0, 2.0))
    >>> x[0]
    array([-1.5, -0.5,  0.5,  1.5])
    """
    ny, nx = counts("shape", shape, "(ny, nx)")
    counted("shape", nx * ny, 2 * 8)
    width, height = two("size", size, "m")
    if not (0 < width < np.inf and 0 < height < np.inf):
        raise ValueError(f"size: must be finite and > 0, not {(width, height)}")
    x = (np.arange(nx) - 0.5 * (nx - 1)) * (width / max(nx, 1))
    y = (np.arange(ny) - 0.5 * (ny - 1)) * (height / max(ny, 1))
    return np.meshgrid(x, y)


def gap_of(
    gap: ArrayLike | Surface, size: tuple[float, float] | None, missing: str | None
) -> tuple[Array, tuple[float, float]]:
    """The gap of an array or of a surface, and the size of its window. An array without missing points is not copied."""
    if missing not in (None, *MISSING):
        raise ValueError(f"missing = {missing!r}: must be 'fill' or 'no contact'")
    own = gap if isinstance(gap, Surface) else of_object(gap, None)
    if own is not None:
        heights, size = -own.heights, own.size if size is None else size
    elif np.ma.is_masked(gap) and np.ma.asarray(gap).ndim == 2:
        heights = np.ma.filled(np.ma.asarray(gap, dtype=float), np.nan)
    else:
        heights = numbers("gap", gap, "m")  # type: ignore[arg-type]
    if heights.ndim != 2:
        raise ValueError(f"gap has {heights.ndim} dimensions: must be an array (ny, nx)")
    if heights.size == 0:
        raise ValueError(f"gap has the shape {heights.shape}: must have rows and columns")
    if size is None:
        raise ValueError("size is None: must be two lengths, unless the gap is a surface that knows its size")
    holes = np.isnan(heights)
    if holes.any() and missing is None:
        row, column = np.argwhere(holes)[0]
        text = f"gap is not measured at {holes.sum()} points, the first in row {row + 1}, column {column + 1}: give missing"
        raise ValueError(f"{text}='fill' or 'no contact'")
    if holes.any() and missing == "fill":
        # Where there is no body, nothing was measured either.
        infinite = np.isinf(heights)
        filled = Surface(np.where(infinite, np.nan, heights), None).prepared(missing="fill").heights
        heights = np.where(infinite, np.inf, filled)
    elif holes.any():
        heights = np.where(holes, np.inf, heights)
    return heights - heights.min() if own is not None else heights, size


class Solver:
    """Two elastic bodies on a grid of cells, with friction and memory.

    `gap` is the distance of the undeformed surfaces, an array (ny, nx) in m, over a window of `size` (m,
    along x and y), infinite where there is no body. It may also be a `Surface` of `carom.surface`, or an object of
    SurfaceTopography or surfalize; these have heights towards the other body, and a size if `size` is None. Points that
    are not measured (NaN, masked) need `missing`: "fill", a smooth patch of the gap around them, or "no contact". The contact
    must not reach the border of the window, unless the bodies end there (`cut`) or repeat themselves (`periodic`; the
    approach is then measured from the mean plane). `friction` is a number or an array (ny, nx), from 0 to infinity. Each step is solved to
    `tolerance`, relative to the largest displacement and friction limit. Body 2 is shifted against body 1;
    loads act on body 1. Solvers can be pickled and copied.

    With a `plate`, body 2 is that plate: simply supported at its edges, covered by the grid, `size` its
    sides. Friction is then 0, and the contact must not reach an edge. `warnings` says whether it is bent by more
    than half its thickness.

    With `influence`, the bodies are no half-spaces: the displacement of one cell by a unit traction on another (m/Pa) is
    `influence["zz"]` for the pressure, `influence["xz"]` for the displacement along x by the pressure, and so on; blocks
    that are missing are zero. Each is an array of the shape of `gap`, for offsets (source minus receiver) of 0, 1, 2...
    rows and columns, if both bodies are symmetric about both axes; or (2 ny - 1, 2 nx - 1), from 1 - ny and 1 - nx.
    They must obey Betti's theorem, and tractions must do positive work. Materials then count for warnings only.

    Each step has error estimates from two coarser grids (`zeta_error`, `F_z_error`, ...), where these can be solved; `estimates=False`
    saves two fifths of the time. A contact of few cells, one that yields and a plate bent too far are told by a warning, once
    each.

    A steel ball of 1 cm radius on steel, pressed with 10 N and loaded tangentially:

    >>> import carom
    >>> steel = carom.MaterialPair(carom.Material(208e9, 0.3))
    >>> x, y = carom.cells((40, 40), size=(2.6e-4, 2.6e-4))
    >>> solver = carom.Solver((x**2 + y**2) / (2 * 0.01), (2.6e-4, 2.6e-4), steel, friction=0.3)
    >>> step = solver.step(F_z=10.0)
    >>> hertz = carom.hertz_of_spheres(0.01, float("inf"), carom.Material(208e9, 0.3))
    >>> exact = carom.hertz(hertz, force=10.0)
    >>> bool(abs(step.zeta / exact.approach - 1) < 0.01)
    True
    >>> step = solver.step(F_x=2.0)
    >>> int(solver.cells.max()), bool(step.stick_area < step.contact_area)
    (2, True)
    """

    def __init__(
        self,
        gap: ArrayLike | Surface,
        size: tuple[float, float] | None,
        materials: MaterialPair | Material,
        friction: ArrayLike,
        *,
        tolerance: float = 1e-9,
        cut: bool = False,
        periodic: bool = False,
        missing: str | None = None,
        plate: Plate | None = None,
        influence: Mapping[str, ArrayLike] | None = None,
        estimates: bool = True,
    ) -> None:
        heights, size = gap_of(gap, size, missing)
        ny, nx = heights.shape
        fine = numbers("friction", friction)
        if fine.shape not in ((), (ny, nx)):
            raise ValueError(f"friction has the shape {fine.shape}: must be a number or {(ny, nx)}")
        self._shape, self._size = (ny, nx), two("size", size, "m")
        self._materials = MaterialPair(materials) if isinstance(materials, Material) else materials
        self._friction, self._tolerance, self._cut = fine, number("tolerance", tolerance), bool(cut)
        self._periodic = bool(periodic)
        if self._cut and self._periodic:
            raise ValueError("cut and periodic: bodies that end at the border are not periodic")
        if self._periodic and (plate is not None or influence is not None):
            raise ValueError("periodic: must be False beside a plate or influence numbers")
        self._plate = plate
        if plate is not None and influence is not None:
            raise ValueError("plate and influence are both given: give one of them")
        table = blocks(influence)
        self._influence = None if influence is None else {name: flat.reshape(-1, many) for name, many, flat in table}
        self._estimates = bool(estimates)
        cell = [self._size[0] / max(nx, 1), self._size[1] / max(ny, 1)]
        self._native = _carom.Solver(
            [nx, ny], cell, line(heights), materials, line(fine), self._tolerance,
            [self._cut, self._periodic], plate, table, self._estimates
        )

    def step(
        self,
        *,
        zeta: float | None = None,
        F_z: float | None = None,
        xi: float | None = None,
        F_x: float | None = None,
        eta: float | None = None,
        F_y: float | None = None,
        omega: float | None = None,
        M_z: float | None = None,
    ) -> SolverStep:
        """Moves straight to a given shift (m, rad) or load (N, N m) of each motion.

        The motions are approach, shift along x and y, and twist. A motion that is not given keeps its last
        value. A failed step leaves the contact as it was.
        """
        given: list[tuple[bool, float] | None] = [None] * 4
        values = ((zeta, F_z), (xi, F_x), (eta, F_y), (omega, M_z))
        for i, (names, (shift, load)) in enumerate(zip(MOTIONS, values, strict=True)):
            if shift is not None and load is not None:
                raise ValueError(f"{names[0]} and {names[1]}: only one of them can be given")
            if shift is not None or load is not None:
                name = names[load is not None]
                given[i] = (load is not None, number(name, shift if load is None else load, UNITS[name]))
        if given[0] is None and not self._native.summary()["step"][0]:
            raise ValueError("zeta or F_z: the first step needs one of them")
        return SolverStep._of(self._native.step(given))

    def summary(self) -> SolverStep:
        """Summary of the last step; zeros before the first."""
        return SolverStep._of(self._native.summary())

    @property
    def plate(self) -> Plate | None:
        """The plate that body 2 is; None for a half-space."""
        return self._plate

    @property
    def influence(self) -> Mapping[str, Array] | None:
        """The influence numbers (m/Pa) of the bodies; None for half-spaces and a plate."""
        return self._influence

    @property
    def warnings(self) -> list[str]:
        """Reasons to distrust the last step: few cells, a border that the contact reaches, a bent plate."""
        return self._native.warnings()

    @property
    def shape(self) -> tuple[int, int]:
        """Shape of the grid, (ny, nx)."""
        return self._shape

    @property
    def gap(self) -> Array:
        """The gap of the undeformed surfaces, m."""
        return self._native.gap().reshape(self.shape)

    @property
    def size(self) -> tuple[float, float]:
        """Size of the window along x and y, m."""
        return self._size

    def _field(self, name: str) -> Array:
        return self._native.field(FIELDS.index(name)).reshape(self.shape)

    @property
    def pressure(self) -> Array:
        """Pressure (ny, nx), Pa."""
        return self._field("pressure")

    @property
    def traction_x(self) -> Array:
        """Traction on body 1 along x (ny, nx), Pa."""
        return self._field("traction_x")

    @property
    def traction_y(self) -> Array:
        """Traction on body 1 along y (ny, nx), Pa."""
        return self._field("traction_y")

    @property
    def gap_left(self) -> Array:
        """Distance of the deformed surfaces (ny, nx), m, by a fresh product; infinite where there is no body. In contact
        it is what is left of the conditions."""
        return self._native.gap_left().reshape(self.shape)

    @property
    def displacement_x(self) -> Array:
        """Elastic displacement of body 1 against body 2 along x (ny, nx), m."""
        return self._field("displacement_x")

    @property
    def displacement_y(self) -> Array:
        """Elastic displacement of body 1 against body 2 along y (ny, nx), m."""
        return self._field("displacement_y")

    @property
    def cells(self) -> NDArray[np.int8]:
        """State of each cell, an array (ny, nx): 0 separated, 1 sticks, 2 slips."""
        return self._native.cells().reshape(self.shape)

    def stress(self, x: ArrayLike, y: ArrayLike, z: ArrayLike, *, body: int = 1) -> Array:
        """The stress (xx, yy, zz, xy, yz, zx), Pa, at points of a body: z > 0 in body 1, z < 0 in body 2.

        A sum over all cells, exact for tractions that are constant on each cell. A plate has no such stresses:
        they are those of a half-space.
        """
        if self._influence is not None:
            raise ValueError("stress: is that of half-spaces, and unknown beside influence numbers")
        if self._plate is not None and body == 2:
            raise ValueError("body = 2: must be 1 beside a plate; stresses are those of a half-space")
        body = counted("body", body)
        arrays = np.broadcast_arrays(*(numbers(n, a, "m") for n, a in zip("xyz", (x, y, z), strict=True)))
        material = (self._materials.material_1, self._materials.material_2)[body == 2]
        stress = self._native.stress(material, body, *(line(a) for a in arrays))
        return stress.reshape((*arrays[0].shape, 6))

    def _rows(self) -> list[_show.Row]:
        """What the solver is, and its last step."""
        ny, nx = self.shape
        own = [
            ("cells", f"{ny} x {nx}", "", "along y and x"),
            ("size", _show.short(self._size), "m", "of the window, along x and y"),
            ("materials", _show.short(repr(self._materials)), "", "of both bodies"),
            ("friction", _show.number(self._friction.item()) if self._friction.ndim == 0 else "of each cell", "", ""),
        ]
        own += [] if self._plate is None else [("plate", repr(self._plate), "", "body 2")]
        own += [] if self._influence is None else [("influence", ", ".join(self._influence), "", "blocks of numbers")]
        step = self.summary()
        return own + (step._rows() if step.step else [("step", "0", "", "no step yet")])

    def __repr__(self) -> str:
        return _show.text("Solver", self._rows())

    def _repr_html_(self) -> str:
        return _show.html("Solver", self._rows())

    def __getstate__(self) -> dict[str, Any]:
        state = {name: value for name, value in self.__dict__.items() if name != "_native"}
        return {**state, "_gap": self.gap, "_state": self._native.state(), "_form": STATE_FORM}

    def __setstate__(self, state: dict[str, Any]) -> None:
        form = state.pop("_form", None)
        if form != STATE_FORM:
            raise ValueError(f"form of the stored Solver = {form}: this version reads {STATE_FORM}; compute it again")
        native = state.pop("_state")
        self.__init__(  # type: ignore[misc]
            state["_gap"],
            state["_size"],
            state["_materials"],
            state["_friction"],
            tolerance=state["_tolerance"],
            cut=state["_cut"],
            periodic=state["_periodic"],
            plate=state["_plate"],
            influence=state["_influence"],
            estimates=state["_estimates"],
        )
        self._native.restore(*native)

    def __copy__(self) -> Self:
        new = object.__new__(type(self))
        new.__setstate__(copy(self.__getstate__()))
        return new

    def __deepcopy__(self, _memo: object) -> Self:
        return self.__copy__()
