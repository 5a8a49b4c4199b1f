"""Makes `_records.py` from the tables of columns: `python -m carom._make_records > _records.py`."""

from __future__ import annotations

from . import _carom

RESULTS = {
    "DissimilarRestitution": "R_x of spheres of dissimilar materials.",
    "HertzState": "A Hertz contact under load.",
    "HistoryPoint": "Instants of an impact, in contact axes.",
    "HistoryStep": "A contact after the steps of a history case. SI units; loads act on body 1.",
    "SolverStep": "A step of the numerical solver.",
    "Rebound": "How two bodies part. What only an impact has is not a number where they do not meet.",
}


def made() -> str:
    """The text of `_records.py`."""
    text = '"""Results. Made by `carom._make_records`; not to be edited."""\n\n'
    text += "from __future__ import annotations\n\nfrom dataclasses import dataclass\n\n"
    text += "from ._arrays import Array, Numbers\nfrom ._record import Record\n"
    for name, about in RESULTS.items():
        columns = _carom.columns(name)
        width = max(len(column) for column, *_ in columns)
        text += f'\n\n@dataclass(frozen=True, eq=False)\nclass {name}(Record):\n    """{about}\n\n'
        for column, unit, meaning, _ in columns:
            text += f"    {column:<{width}}  {meaning}{f', {unit}' if unit else ''}\n"
        text += '    """\n\n'
        for column, _, _, parts in columns:
            kind = {0: "str | list[str]", 1: "Numbers", 3: "Array"}[parts]
            text += f"    {column}: {kind}\n"
        units = {column: unit for column, unit, _, _ in columns}
        meanings = {column: meaning for column, _, meaning, _ in columns}
        vectors = [column for column, _, _, parts in columns if parts == 3]
        text += f"\n\n{name}.units = {units!r}\n{name}.meanings = {meanings!r}\n"
        text += f"{name}._vectors = frozenset({vectors!r})\n"
    return text


if __name__ == "__main__":
    print(made(), end="")
