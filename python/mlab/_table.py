"""Columns of numbers and words."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np


class Table(dict):
    """Columns by name, each a numpy array of the same length: ``table["duration_s"].mean()``.

    A table is a dictionary, so ``pandas.DataFrame(table)`` and the like take it as it is. Its arrays are its own:
    nothing changes in them when a run goes on, and they live as long as somebody has them.
    """

    def __init__(self, columns: Mapping[str, np.ndarray]) -> None:
        """Makes a table of columns, which all have the same length."""
        super().__init__({name: np.asarray(values) for name, values in columns.items()})
        lengths = {len(values) for values in self.values()}
        if len(lengths) > 1:
            raise ValueError(f"the columns have different lengths: {sorted(lengths)}")

    @property
    def columns(self) -> tuple[str, ...]:
        """The names of the columns, in their order."""
        return tuple(self)

    @property
    def rows(self) -> int:
        """How many rows there are. ``len(table)`` is, as of every dictionary, how many columns there are."""
        return len(next(iter(self.values()))) if self else 0

    def where(self, mask: np.ndarray) -> Table:
        """The rows for which the mask is true: ``table.where(table["robot"] == 3)``."""
        return Table({name: values[np.asarray(mask, dtype=bool)] for name, values in self.items()})

    def to_pandas(self) -> "pandas.DataFrame":  # noqa: F821
        """The same as a pandas.DataFrame; needs pandas (Debian: ``python3-pandas``)."""
        try:
            import pandas
        except ImportError as missing:
            raise ImportError("to_pandas() needs pandas; Debian's package is python3-pandas") from missing
        return pandas.DataFrame(dict(self))

    def __repr__(self) -> str:
        """How large it is, and what its columns are called."""
        return f"<{type(self).__name__} of {self.rows} rows: {', '.join(self.columns)}>"
