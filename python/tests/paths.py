"""Where the tests find missions."""

import os

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def mission(name):
    """The file of one of our missions."""
    return os.path.join(ROOT, "missions", name, f"{name}.mdl")
