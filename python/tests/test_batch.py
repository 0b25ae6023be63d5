"""Batches in numpy."""

import csv
import os
import pickle
import subprocess
import tempfile
import threading
import unittest

import numpy as np

import mlab
from paths import mission

PATROL = mission("patrol")


class Batches(unittest.TestCase):
    def test_the_table_is_that_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "table.csv")
            subprocess.run(
                [os.environ["MLAB_COMMAND"], "batch", PATROL, "--runs", "4", "--set", "base_velocity=0.8,1.2", "--quiet"]
                + ["--seed", "3", "--start-time", "2026-03-01 08:30", "--table", file],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            with open(file, newline="") as text:
                theirs = list(csv.DictReader(text))
        ours = mlab.batch(PATROL, 4, seed=3, set={"base_velocity": [0.8, 1.2]}, start_time="2026-03-01 08:30")
        self.assertEqual(ours.rows, 8)
        self.assertEqual(set(ours.columns), set(theirs[0]))
        for name in ("seed", "base_velocity", "duration_s", "distance_m"):
            np.testing.assert_array_equal(ours[name], [float(row[name]) for row in theirs])
        self.assertEqual(list(ours["outcome"]), [row["outcome"] for row in theirs])

    def test_columns_have_the_types_of_what_stands_in_them(self):
        table = mlab.batch(PATROL, 3, set={"base_velocity": "0.5..1.5"})
        self.assertEqual(table["seed"].dtype, np.int64)
        self.assertEqual(table["success"].dtype, bool)
        self.assertEqual(table["duration_s"].dtype, np.float64)
        self.assertEqual(table["base_velocity"].dtype, np.float64)
        self.assertEqual(table["outcome"].dtype.kind, "U")
        self.assertEqual(list(table["cause"]), ["", "", ""])

    def test_threads_do_not_matter(self):
        one, two = mlab.batch(PATROL, 6, threads=1), mlab.batch(PATROL, 6, threads=2)
        for name in one.columns:
            np.testing.assert_array_equal(one[name], two[name])

    def test_it_says_what_the_runs_say_together(self):
        table = mlab.batch(PATROL, 5, success="contacts == 0", require="success >= 0.1 @ 0.9", against=PATROL)
        combination, other = table.combinations
        self.assertEqual((combination.runs, combination.against, other.against), (5, False, True))
        self.assertLessEqual(combination.low, combination.share)
        self.assertTrue(table.requirements_met)
        self.assertFalse(mlab.batch(PATROL, 5, limit=1.0, require="success >= 0.9 @ 0.9").requirements_met)

    def test_a_page_is_written(self):
        with tempfile.TemporaryDirectory() as folder:
            page = os.path.join(folder, "page.html")
            mlab.batch(PATROL, 2, page=page)
            with open(page) as text:
                self.assertIn("<!doctype html", text.read().lower())

    def test_a_definition_is_taken(self):
        with tempfile.TemporaryDirectory() as folder:
            study = os.path.join(folder, "study.toml")
            with open(study, "w") as text:
                text.write(f'mission = "{PATROL}"\nruns = 2\n[set]\nbase_velocity = "1,2"\n')
            self.assertEqual(mlab.batch(study).rows, 4)
            self.assertEqual(mlab.batch(study, runs=1, set={"base_velocity": 1}).rows, 1)

    def test_progress_is_told_and_may_end_it(self):
        told = []
        mlab.batch(PATROL, 3, progress=lambda done, all: told.append((done, all)))
        self.assertEqual(told[-1][1], 3)

        def stop(done, all):
            raise StopIteration("enough")

        with self.assertRaisesRegex(StopIteration, "enough"):
            mlab.batch(PATROL, 100_000, progress=stop)

    def test_two_at_once(self):
        tables = {}
        threads = [
            threading.Thread(target=lambda seed=seed: tables.update({seed: mlab.batch(PATROL, 2, seed=seed)}))
            for seed in (1, 9)
        ]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(list(tables[9]["seed"]), [9, 10])

    def test_a_table_can_be_pickled(self):
        table = mlab.batch(PATROL, 2)
        again = pickle.loads(pickle.dumps(table))
        self.assertEqual(again.combinations, table.combinations)
        np.testing.assert_array_equal(again["duration_s"], table["duration_s"])

    def test_what_can_not_be_is_refused(self):
        for wrong in ({"runs": 10**9}, {"runs": 0}, {"combine": "somehow"}, {"success": "outcome = done"}, {"start_time": "soon"}, {"set": {"nothing": 1}}, {"set": {"base_velocity": []}}, {"confidence": 2.0}):
            with self.assertRaises(mlab.Error, msg=str(wrong)):
                mlab.batch(PATROL, **{"runs": 1, **wrong})
        with self.assertRaises(mlab.Error):
            mlab.batch("no_such_file.mdl", 1)
        with self.assertRaises(TypeError):
            mlab.batch(PATROL, 1, progress=3)
        for wrong in ({"set": ["base_velocity"]}, {"require": 5}, {"require": [5]}, {"limit": "soon"}):
            with self.assertRaisesRegex(TypeError, f"{next(iter(wrong))}: expected", msg=str(wrong)):
                mlab.batch(PATROL, 1, **wrong)

    def test_a_page_that_can_not_be_written_is_told_before_the_runs(self):
        told = []
        with self.assertRaisesRegex(mlab.Error, "page /no/such/folder/page.html: the file can't be written"):
            mlab.batch(PATROL, 50, page="/no/such/folder/page.html", progress=lambda *of: told.append(of))
        self.assertEqual(told, [])

    def test_a_page_is_named_as_for_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.txt", "a.HTML", "a", ".html", "-"):
                page = os.path.join(folder, name)
                with self.assertRaises(mlab.Error) as told:
                    mlab.batch(PATROL, 1, page=page)
                self.assertEqual(str(told.exception), f"page {page}: expected FILE.html")
                by_command = subprocess.run(
                    [os.environ["MLAB_COMMAND"], "batch", PATROL, "--runs", "1", "--html", page], capture_output=True, text=True
                )
                self.assertIn("expected FILE.html", by_command.stderr)
                self.assertEqual(by_command.returncode, 2)
            self.assertEqual(os.listdir(folder), [])


if __name__ == "__main__":
    unittest.main()
