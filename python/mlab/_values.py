"""Values as people write them in missions."""

from __future__ import annotations

import operator
import os

import numpy as np

from ._errors import Error


def written(value: object, what: str) -> str:
    """A value as the languages of missions write it.

    Numbers, truths, words, and sequences of numbers such as a vector. What is no number is refused.
    """
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, (int, np.integer)):
        return str(int(value))
    if isinstance(value, (float, np.floating)):
        if not np.isfinite(value):
            raise Error(f"{what}: {value} is no number that can be set")
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)) and len(value) and np.ndim(value) == 1:
        return "{" + ", ".join(written(one, what) for one in np.asarray(value).tolist()) + "}"
    raise TypeError(f"{what}: expected a number, a truth, a text or a few numbers, not {type(value).__name__}")


def whole(value: object, what: str, least: int = 0, most: int = 2**63 - 1) -> int:
    """A whole number within limits."""
    try:
        number = operator.index(value)  # type: ignore[arg-type]
    except TypeError:
        raise TypeError(f"{what}: expected a whole number, not {type(value).__name__}") from None
    if not least <= number <= most:
        raise Error(f"{what}: {number} is out of range; expected {least} to {most}")
    return number


def positive(value: object, what: str) -> float:
    """A number above zero."""
    try:
        number = float(value)  # type: ignore[arg-type]
    except (TypeError, ValueError):
        raise TypeError(f"{what}: expected a number, not {type(value).__name__}") from None
    if not (number > 0.0 and np.isfinite(number)):
        raise Error(f"{what}: {number} is out of range; expected a number above 0")
    return number


def path_of(file: str | os.PathLike, what: str) -> str:
    """The name of a file."""
    name = os.fspath(file) if isinstance(file, os.PathLike) else file
    return text_of(name, what, "the name of a file")


def text_of(text: object, what: str, expected: str) -> str:
    """A text that can be told to the program."""
    if not isinstance(text, str):
        raise TypeError(f"{what}: expected {expected} as text, not {type(text).__name__}")
    if "\0" in text:
        raise Error(f"{what}: {expected} has no byte 0 in it")
    try:
        text.encode()
    except UnicodeEncodeError:
        raise Error(f"{what}: expected {expected} in UTF-8, found {text!r}") from None
    return text


def names_of(names: object, what: str) -> list[str]:
    """Names of ports: one, or several."""
    out = [names] if isinstance(names, str) else list(names)  # type: ignore[call-overload]
    if not all(isinstance(name, str) for name in out):
        raise TypeError(f"{what}: expected names of ports, such as 'base_velocity'")
    return out


class NotPickled:
    """Something that can't be written down or sent to another process."""

    _why = "it belongs to this process"

    def __reduce_ex__(self, protocol: object) -> tuple:
        """Refuses, with the reason."""
        raise TypeError(f"a {type(self).__name__} can't be pickled or copied: {self._why}")
