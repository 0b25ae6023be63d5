"""What is wrong with files and values, as Python has it."""

from __future__ import annotations

from typing import NamedTuple


class Problem(NamedTuple):
    """One thing that is wrong, or that people should know, where it stands."""

    file: str | None
    """Name of the file; None: it stands nowhere."""
    line: int
    """Counted from 1; 0 without a file."""
    column: int
    """Counted from 1, in characters; 0 without a file."""
    severity: str
    """``error``, ``warning`` or ``note``."""
    kind: str
    """What sort of problem, always called the same: ``unknown-control-measure``; empty where it has no name."""
    message: str
    """What was seen and what is expected, in one line."""
    hints: tuple[str, ...]
    """What may help."""
    text: str
    """All of it as ``mlab check`` prints it, with the line and carets below what is wrong."""


class Error(ValueError):
    """Something that was given can't be used: a file with mistakes, an unknown port, a value out of range.

    ``str(error)`` is what ``mlab`` prints in a terminal; ``error.problems`` holds each problem with its place.
    """

    problems: tuple[Problem, ...]
    """All that is wrong; at least one."""

    def __init__(self, message: str, problems: tuple[Problem, ...] = ()) -> None:
        """Makes an error of a sentence, or of problems that were found."""
        super().__init__(message)
        self.problems = tuple(problems) or (Problem(None, 0, 0, "error", "", message, (), message),)

    def __reduce__(self) -> tuple:
        """Errors cross processes whole, as from a pool's workers."""
        return (type(self), (str(self), self.problems))


class MissionWarning(UserWarning):
    """Something in a mission is odd, and it runs all the same; see :attr:`Mission.warnings`."""


def problems_of(said: list[dict]) -> tuple[Problem, ...]:
    """What the compiled half says, as problems."""
    return tuple(Problem(**{**one, "hints": tuple(one["hints"])}) for one in said)


def raise_error(said: list[dict]) -> None:
    """Called by the compiled half."""
    problems = problems_of(said)
    has_place = any(one.file for one in problems)
    text = "".join(one.text for one in problems).rstrip() if has_place else "\n".join(one.message for one in problems)
    raise Error(text, tuple(one for one in problems if one.severity == "error") or problems)
