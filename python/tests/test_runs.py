"""Missions and runs, as somebody uses them in an interpreter."""

import json
import os
import subprocess
import tempfile
import unittest
import warnings

import numpy as np

import mlab
from paths import ROOT, mission

PATROL = mission("patrol")


class Missions(unittest.TestCase):
    def test_a_mission_says_what_it_is(self):
        patrol = mlab.load(PATROL)
        self.assertEqual(patrol.name, "Patrol")
        self.assertEqual(patrol.robots, {1: "ROBOT", 2: "ROBOT"})
        self.assertEqual(patrol.warnings, ())
        port = patrol.ports()["base_velocity"]
        self.assertEqual((port.role, port.type, port.unit, port.low, port.high), ("parameter", "double", "m/s", 0.0, 100.0))

    def test_missions_that_come_along_are_found(self):
        names = [os.path.basename(path) for path in mlab.missions()]
        self.assertIn("demo_c.mdl", names)

    def test_settings_count_in_place_of_what_the_mission_says(self):
        run = mlab.load(PATROL, set={"base_velocity": 0.5}).run()
        self.assertEqual(run.port(1, "base_velocity"), 0.5)

    def test_what_is_odd_is_warned_of(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "odd.mdl"), "w") as out:
                out.write('NEW-ROBOT ghost "no_such_program"\nUNIT <a> ghost\nCOMMAND LIST:\n0. UNIT a START 1 1\n')
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                odd = mlab.load(os.path.join(folder, "odd.mdl"))
        self.assertTrue(odd.warnings)
        self.assertEqual({one.category for one in caught}, {mlab.MissionWarning})

    def test_mistakes_say_where_they_are(self):
        with tempfile.NamedTemporaryFile("w", suffix=".mdl") as file:
            file.write("UNIT <a> ROBOT\nCOMMAND LIST:\n0. UNIT a START 1 1\n1. UNIT a MOVETO Nowhere\n2. UNIT b STOP\n")
            file.flush()
            with self.assertRaises(mlab.Error) as caught:
                mlab.load(file.name)
        self.assertIsInstance(caught.exception, ValueError)
        places = {(one.kind, one.line) for one in caught.exception.problems}
        self.assertIn(4, {line for _, line in places})
        self.assertIn(5, {line for _, line in places})
        first = caught.exception.problems[0]
        self.assertEqual(first.file, file.name)
        self.assertGreater(first.column, 1)
        self.assertIn(f"{file.name}:{first.line}:{first.column}: error:", str(caught.exception))


class Runs(unittest.TestCase):
    def test_a_run_is_that_of_the_command(self):
        with tempfile.TemporaryDirectory() as folder:
            report = os.path.join(folder, "report.json")
            subprocess.run(
                [os.environ["MLAB_COMMAND"], "run", PATROL, "--headless", "--proceed", "--quiet", "--seed", "5"]
                + ["--start-time", "2026-03-01 08:30", "--report", report],
                check=True,
                stdout=subprocess.DEVNULL,
            )
            with open(report) as file:
                theirs = json.load(file)
        run = mlab.load(PATROL).run(seed=5, start_time="2026-03-01 08:30")
        self.assertEqual(run.finish(), "done")
        ours = run.report()
        self.assertTrue(run.is_over)
        for report in (ours, theirs):
            del report["performance"]
        self.assertEqual(ours, theirs)

    def test_time_passes_in_cycles(self):
        run = mlab.load(PATROL).run()
        self.assertEqual((run.time, run.cycle, run.outcome), (0.0, 0, "running"))
        self.assertEqual(run.step(), 1)
        self.assertEqual(run.step(9), 9)
        self.assertEqual(run.cycle, 10)
        self.assertAlmostEqual(run.time, 1.0)
        run.finish(limit=2.0)
        self.assertAlmostEqual(run.time, 3.0)

    def test_after_the_end_nothing_happens(self):
        run = mlab.load(PATROL).run()
        run.finish()
        time = run.time
        self.assertEqual(run.step(100), 0)
        self.assertEqual(run.finish(), "done")
        self.assertEqual(run.time, time)

    def test_the_same_seed_is_the_same_run_for_any_number_of_threads(self):
        patrol = mlab.load(PATROL)
        one, two, other = patrol.run(seed=3), patrol.run(seed=3, threads=2), patrol.run(seed=4)
        for run in (one, two, other):
            run.step(200)
        np.testing.assert_array_equal(one.poses, two.poses)
        self.assertFalse(np.array_equal(one.poses, other.poses))

    def test_robots_tell_how_they_stand(self):
        run = mlab.load(PATROL).run()
        run.step(20)
        robot = run.robots[0]
        self.assertEqual((robot.number, robot.type, robot.life, robot.fault), (1, "ROBOT", "running", ""))
        self.assertEqual(robot.pose.shape, (3,))
        np.testing.assert_array_equal(run.poses[0], robot.pose)
        self.assertGreater(robot.distance, 0.0)
        self.assertEqual(robot.contacts, 0)
        self.assertIn("robot 1", repr(robot))
        self.assertIs(run.robots[0], robot)
        self.assertTrue(robot.explain())

    def test_ports_are_what_they_are_in_python(self):
        run = mlab.load(PATROL).run()
        run.step(20)
        values = run.port(1, "*")
        ports = run.robots[0].ports
        self.assertEqual(set(values), set(ports))
        kinds = {"double": float, "bool": bool, "int": int, "Vector": np.ndarray, "Point": np.ndarray, "Pose": np.ndarray, "Text": str, "Task": str}
        for path, value in values.items():
            if ports[path].type in kinds:
                self.assertIs(type(value), kinds[ports[path].type], path)
        some = run.port(1, "navigation_*")
        self.assertTrue(some and all(path.startswith("navigation_") for path in some))
        self.assertEqual(run.robots[0].port("base_velocity"), run.port(run.robots[0], "base_velocity"))

    def test_parameters_are_set(self):
        run = mlab.load(PATROL).run()
        run.set(1, "base_velocity", 0.25)
        self.assertEqual(run.port(1, "base_velocity"), 0.25)
        self.assertNotEqual(run.port(2, "base_velocity"), 0.25)
        run.set(2, "cautious_mode", True)
        self.assertIs(run.port(2, "cautious_mode"), True)

    def test_outputs_are_held_and_released(self):
        run = mlab.load(PATROL).run()
        run.step(5)
        run.hold(1, "motion", [0.5, -0.25])
        run.step(2)
        np.testing.assert_array_equal(run.port(1, "motion"), [0.5, -0.25, 0.0])
        run.release(1)
        run.step(2)
        self.assertFalse(np.array_equal(run.port(1, "motion"), [0.5, -0.25, 0.0]))

    def test_an_operator_is_asked_and_answers(self):
        run = mlab.load(PATROL).run(proceed=False)
        for _ in range(20):
            run.finish()
            if not run.questions:
                break
            self.assertEqual(run.outcome, "waiting")
            run.answer(min(run.questions))
        self.assertEqual(run.outcome, "done")

    def test_an_order_is_carried_out(self):
        run = mlab.load(PATROL).run()
        run.step(10)
        before = np.hypot(*(run.robots[1].pose[:2] - [70, 150]))
        run.order("ROBOT 2 MOVETO 70 150")
        run.step(100)
        self.assertLess(np.hypot(*(run.robots[1].pose[:2] - [70, 150])), before - 5.0)
        with self.assertRaises(mlab.Error) as caught:
            run.order("UNIT nobody STOP")
        self.assertEqual(caught.exception.problems[0].line, 1)

    def test_a_mission_is_aborted(self):
        run = mlab.load(PATROL).run()
        run.step(10)
        run.abort()
        self.assertEqual(run.outcome, "aborted")

    def test_a_checkpoint_leads_back(self):
        patrol = mlab.load(PATROL)
        run = patrol.run(seed=2)
        run.step(50)
        checkpoint = run.save()
        run.step(100)
        poses = run.poses
        run.restore(checkpoint)
        self.assertEqual((run.cycle, checkpoint.cycle), (50, 50))
        other = patrol.run(seed=2)
        other.restore(checkpoint)
        for one in (run, other):
            one.step(100)
            np.testing.assert_array_equal(one.poses, poses)
        with self.assertRaisesRegex(mlab.Error, "another mission or seed"):
            patrol.run(seed=3).restore(checkpoint)
        with self.assertRaisesRegex(mlab.Error, "another mission or seed"):
            mlab.load(mission("demo_c")).run(seed=2).restore(checkpoint)

    def test_a_trace_has_a_row_for_each_robot_and_cycle(self):
        run = mlab.load(PATROL).run()
        table = run.trace(["base_velocity", "max_*"], seconds=2.0, every=2)
        self.assertEqual(table.columns[:7], ("cycle", "time", "robot", "x", "y", "heading", "base_velocity"))
        self.assertEqual(table.rows, 20)
        np.testing.assert_array_equal(table.where(table["robot"] == 1)["cycle"], np.arange(2, 21, 2))
        last = table.where((table["robot"] == 2) & (table["cycle"] == 20))
        np.testing.assert_array_equal([last["x"][0], last["y"][0], last["heading"][0]], run.poses[1])

    def test_messages_are_kept(self):
        run = mlab.load(PATROL).run()
        run.finish()
        self.assertEqual(run.messages[-1][1:], ("mission ended", "mission done"))

    def test_a_run_is_recorded(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "run.mcap")
            run = mlab.load(PATROL).run(seed=2, record=file)
            run.step(10)
            run.set(1, "base_velocity", 0.5)
            run.finish()
            run.end_recording()
            done = subprocess.run(
                [os.environ["MLAB_COMMAND"], "replay", "--headless", file], capture_output=True, text=True
            )
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            with self.assertRaisesRegex(mlab.Error, "never written over"):
                mlab.load(PATROL).run(record=file)

    def test_a_robot_that_comes_later_is_traced(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "run.mcap")
            run = mlab.load(PATROL).run(seed=2, record=file)
            run.step(10)
            run.order("UNIT <late> ROBOT AND UNIT late START 60 60")
            run.step(20)
            number = run.robots[-1].number
            self.assertEqual(number, 3)
            run.end_recording()
            done = subprocess.run(
                [os.environ["MLAB_COMMAND"], "trace", file, "--robot", str(number), "--ports", "base_velocity"],
                capture_output=True,
                text=True,
            )
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            header, *rows = done.stdout.splitlines()
            self.assertEqual(header, "cycle,time,robot,x,y,heading,base_velocity")
            self.assertGreater(len(rows), 15)
            self.assertTrue(all(row.split(",")[2] == "3" and int(row.split(",")[0]) > 10 for row in rows))

    def test_robots_in_cells_run(self):
        own = mlab.load(os.path.join(ROOT, "docs", "examples", "own_behavior", "mine.mdl"))
        run = own.run()
        self.assertEqual(run.finish(), "done")
        self.assertTrue(run.port(1, "*"))


class Tables(unittest.TestCase):
    def test_columns_are_of_one_length(self):
        with self.assertRaisesRegex(ValueError, "different lengths"):
            mlab.Table({"a": [1, 2], "b": [1]})

    def test_pandas_takes_them(self):
        table = mlab.Table({"a": np.arange(3), "b": np.array(["x", "y", "z"])})
        try:
            import pandas
        except ImportError:
            with self.assertRaisesRegex(ImportError, "python3-pandas"):
                table.to_pandas()
            return
        frame = table.to_pandas()
        self.assertIsInstance(frame, pandas.DataFrame)
        self.assertEqual(list(frame["a"]), [0, 1, 2])


if __name__ == "__main__":
    unittest.main()
