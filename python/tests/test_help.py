"""`help(mlab)` is complete: every public name says what it is, and every function what it takes."""

import inspect
import pydoc
import unittest

import mlab

# What a class has from the types it is made of, which their own documentation explains.
INHERITED = (dict, tuple, object, ValueError, UserWarning)


def members_of(cls):
    """The public members that a class defines itself, or has from one of ours."""
    for base in cls.__mro__:
        if base in INHERITED or not base.__module__.startswith("mlab"):
            continue
        for name, member in vars(base).items():
            if not name.startswith("_") or name in ("__init__", "__repr__"):
                yield f"{cls.__name__}.{name}", member


def undocumented(where, member):
    """What is missing of a member, as sentences."""
    if isinstance(member, property):
        if not inspect.getdoc(member):
            yield f"{where} has no docstring"
        if inspect.signature(member.fget).return_annotation is inspect.Signature.empty:
            yield f"{where} does not say of which type it is"
    elif inspect.isfunction(member):
        if not inspect.getdoc(member):
            yield f"{where} has no docstring"
        signature = inspect.signature(member)
        if signature.return_annotation is inspect.Signature.empty:
            yield f"{where} does not say what it returns"
        for name, parameter in signature.parameters.items():
            if name != "self" and parameter.annotation is inspect.Parameter.empty:
                yield f"{where} does not say of which type {name} is"


def all_missing(module):
    for name in module.__all__:
        thing = getattr(module, name)
        if not inspect.getdoc(thing):
            yield f"{name} has no docstring"
        if inspect.isclass(thing):
            for where, member in members_of(thing):
                if hasattr(thing, "_fields") and (where.endswith("__init__") or where.endswith("__repr__")):
                    continue
                yield from undocumented(where, member)
        else:
            yield from undocumented(name, thing)


class Help(unittest.TestCase):
    def test_every_public_name_has_a_docstring_and_types(self):
        self.assertEqual(list(all_missing(mlab)), [])

    def test_what_is_missing_is_found(self):
        class Poor:
            """A class."""

            def go(self, how):
                pass

        Poor.__module__ = "mlab.poor"
        found = [one for where, member in members_of(Poor) for one in undocumented(where, member)]
        self.assertEqual(len(found), 3, found)

    def test_nothing_public_is_left_out(self):
        public = {
            name
            for name, thing in vars(mlab).items()
            if not name.startswith("_") and not inspect.ismodule(thing)
        }
        self.assertEqual(public, set(mlab.__all__))

    def test_every_argument_is_explained_where_there_are_several(self):
        for function in (mlab.load, mlab.batch, mlab.Mission.run, mlab.Environment.__init__, mlab.Run.trace):
            text = inspect.getdoc(function)
            for name in inspect.signature(function).parameters:
                if name != "self":
                    self.assertRegex(text, rf"(?m)^(.*, )?{name}(, .*)?: ", f"{function.__qualname__} does not explain {name}")

    def test_help_can_be_printed(self):
        text = pydoc.render_doc(mlab, renderer=pydoc.plaintext)
        for word in ("Environment", "batch(", "metres", "Error", "observation"):
            self.assertIn(word, text)


if __name__ == "__main__":
    unittest.main()
