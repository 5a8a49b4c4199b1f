"""R_x, rebounds of balls and a contact with memory in PyTorch, an optional dependency: `pip install carom[torch]`.

Array code in double precision that autograd takes, from the tables that the library itself uses: values are those of
the library within round-off. Derivatives are those of the tables' polynomials: of like bodies without a loss within 2e-6 of the exact
impact, else as smooth as their tables. At psi = 1, where the contact begins to slide at first, and at the onset of sliding throughout
they are one-sided. Where an argument is out of range the result is NaN, since compiled code cannot raise an error.
"""

from __future__ import annotations

from typing import Any

import torch  # type: ignore[import-not-found,unused-ignore]

from ._gradients import Functions
from ._line_contact import ContactState

__all__ = ["ContactState", "advance", "contact_state", "rebound", "rebound_of_two", "restitution"]


class _Torch:
    def where(self, condition: Any, one: Any, other: Any) -> Any:
        return torch.where(condition, one, other)

    def log(self, values: Any) -> Any:
        return torch.log(values)

    def take(self, table: Any, index: Any) -> Any:
        return torch.as_tensor(table, device=index.device)[index]

    def index(self, values: Any) -> Any:
        return torch.arange(values.shape[-1], device=values.device)

    def integer(self, values: Any) -> Any:
        return values.to(torch.int64)

    def zeros(self, shape: tuple[int, ...]) -> Any:
        return torch.zeros(shape, dtype=torch.float64)

    def shifted(self, values: Any) -> Any:
        return torch.roll(values, -1, dims=-1)

    def broadcast(self, values: list[Any]) -> list[Any]:
        return list(torch.broadcast_tensors(*values))

    def stack(self, parts: list[Any]) -> Any:
        return torch.stack(torch.broadcast_tensors(*parts), dim=-1)


def __dir__() -> list[str]:
    return __all__


def _double(*values: Any) -> list[Any]:
    """Tensors in double precision."""
    return [torch.as_tensor(value, dtype=torch.float64) for value in values]


_OWN = Functions(_Torch(), _double)
restitution = _OWN.restitution
rebound = _OWN.rebound
rebound_of_two = _OWN.rebound_of_two
contact_state = _OWN.contact_state
advance = _OWN.advance
