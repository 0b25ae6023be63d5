"""Each example does what it says at its end."""

import os
import subprocess
import sys
import unittest

from paths import ROOT

FOLDER = os.path.join(ROOT, "python", "examples")
MARK = "# It prints:\n"


def promised(text):
    """What an example says that it prints."""
    return "".join(line.removeprefix("#     ") for line in text[text.index(MARK) + len(MARK) :].splitlines(True))


class Examples(unittest.TestCase):
    def test_each_prints_what_it_says(self):
        names = sorted(name for name in os.listdir(FOLDER) if name.endswith(".py"))
        self.assertTrue(names)
        for name in names:
            with self.subTest(name):
                file = os.path.join(FOLDER, name)
                with open(file) as source:
                    text = source.read()
                done = subprocess.run([sys.executable, file], cwd=ROOT, capture_output=True, text=True)
                self.assertEqual(done.stderr, "")
                self.assertEqual(done.stdout, promised(text))


if __name__ == "__main__":
    unittest.main()
