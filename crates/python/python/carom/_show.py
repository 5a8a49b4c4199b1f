"""Results as short texts and as HTML: numbers with six digits, of long arrays the first and the last."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

#: Entries shown at either end of an array; of vectors one.
ENDS = 3
#: Rows shown at either end of a table.
ROWS = 5
#: Longest text within a table.
WIDEST = 60
#: What stands for entries that are left out.
MORE = "..."

Row = tuple[str, str, str, str]


def number(x: Any) -> str:
    """A number with at most six digits; a text as it is."""
    if isinstance(x, (bool, np.bool_, str, int)):
        return str(x)
    return f"{x:.6g}"


def short(x: Any) -> str:
    """A value in one line."""
    if isinstance(x, str):
        return x if len(x) <= WIDEST else x[: WIDEST - len(MORE)] + MORE
    if isinstance(x, np.ndarray) and (x.ndim > 2 or x.ndim == 2 and x.shape[1] > 4) and x.size:
        return f"{' x '.join(map(str, x.shape))}, {number(x.min())} to {number(x.max())}"
    if isinstance(x, (list, tuple, np.ndarray)):
        shown = ENDS if np.ndim(x[0] if len(x) else 0) == 0 else 1
        long = len(x) > 2 * shown
        parts = [short(part) for part in (x[:shown] if long else x)]
        parts += [MORE, *(short(part) for part in x[-shown:])] if long else []
        return f"[{' '.join(parts)}]" if not any(isinstance(part, str) for part in x) else ", ".join(parts)
    return number(x) if isinstance(x, (int, float, np.generic)) else str(x).partition("\n")[0]


def is_nothing(x: Any) -> bool:
    """Whether a value tells nothing: NaN, an empty text, or only such."""
    if x is None or isinstance(x, (str, list)):
        return not any(x) if isinstance(x, list) else not x
    if not isinstance(x, (float, np.ndarray)):
        return False
    values = np.asarray(x)
    return values.dtype.kind == "f" and values.size > 0 and bool(np.isnan(values).all())


def text(title: str, rows: Iterable[Row]) -> str:
    """A title, and name, value and unit of each quantity in a line; without those that have no value."""
    told = [(name, value, unit) for name, value, unit, _ in rows]
    width = max((len(name) for name, *_ in told), default=0)
    lines = [f"  {name:<{width}}  {value}{f' {unit}' if unit else ''}" for name, value, unit in told]
    return "\n".join([title, *lines])


def escape(text: str) -> str:
    """A text as HTML. Python's module is imported when it is needed, since that takes milliseconds."""
    from html import escape

    return escape(text)


def html(title: str, rows: Iterable[Row]) -> str:
    """Like `text`, as an HTML table with the meanings."""
    line = '<tr><th style="text-align:left">{}</th><td style="text-align:left">{}</td><td style="text-align:left">{}</td></tr>'
    body = "".join(
        line.format(escape(name), escape(f"{value} {unit}".strip()), escape(meaning))
        for name, value, unit, meaning in rows
    )
    return f"<table><caption>{escape(title)}</caption><tbody>{body}</tbody></table>"


def html_table(title: str, columns: dict[str, tuple[str, str, Any]], count: int) -> str:
    """Columns with units and meanings as an HTML table, with the first and the last rows."""
    few = range(count) if count <= 2 * ROWS else [*range(ROWS), None, *range(count - ROWS, count)]
    head = "".join(
        f'<th title="{escape(meaning)}">{escape(name)}<br>{escape(unit)}</th>'
        for name, (unit, meaning, _) in columns.items()
    )

    def line(i: int | None) -> str:
        cells = ((MORE if i is None else short(values[i])) for *_, values in columns.values())
        return "".join(f"<td>{escape(cell)}</td>" for cell in cells)

    body = "".join(f"<tr><th>{MORE if i is None else i}</th>{line(i)}</tr>" for i in few)
    return (
        f"<table><caption>{escape(title)}</caption><thead><tr><th></th>{head}</tr></thead>"
        f"<tbody>{body}</tbody></table>"
    )


def html_of(thing: Any, quantities: list[tuple[str, str, str]]) -> str:
    """The attributes of an object, each with name, unit and meaning, as an HTML table."""
    values = ((name, getattr(thing, name), unit, meaning) for name, unit, meaning in quantities)
    rows = [(name, short(value), unit, meaning) for name, value, unit, meaning in values if not is_nothing(value)]
    return html(type(thing).__name__, rows)
