"""What must neither crash nor hang: threads, forks, Ctrl-C, odd orders of deletion, pickles."""

import copy
import gc
import multiprocessing
import os
import pickle
import signal
import subprocess
import sys
import threading
import time
import unittest

import numpy as np

import mlab
from paths import ROOT, mission

PATROL = mission("patrol")

# Robots that act by themselves for ever would be best; a mission that waits two hours for a time-out is as good.
LONG = """
import sys, mlab
mission = mlab.load(sys.argv[1])
{what}
"""


def in_own_process(what):
    return subprocess.Popen(
        [sys.executable, "-c", LONG.format(what=what), PATROL], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
    )


class CtrlC(unittest.TestCase):
    def ends(self, what):
        process = in_own_process(what)
        self.assertEqual(process.stdout.readline(), "begins\n")
        process.send_signal(signal.SIGINT)
        out, err = process.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", err)
        return out

    def test_ends_a_run(self):
        # Restored again and again it never ends by itself.
        out = self.ends(
            "run = mission.run(); begin = run.save()\n"
            "try:\n    print('begins', flush=True)\n    while True: run.finish(); run.restore(begin)\n"
            "finally: run.step(1); print('cycle', run.cycle > 0)"
        )
        self.assertEqual(out, "cycle True\n")

    def test_ends_a_batch(self):
        self.ends("print('begins', flush=True); mlab.batch(sys.argv[1], 10_000_000)")

    def test_ends_a_trace(self):
        self.ends("print('begins', flush=True)\nwhile True: mission.run().trace('*')")


class Threads(unittest.TestCase):
    def test_runs_of_their_own_go_side_by_side(self):
        patrol = mlab.load(PATROL)
        alone = patrol.run(seed=7)
        alone.step(300)
        poses = [None] * 4

        def go(i):
            run = patrol.run(seed=7)
            for _ in range(30):
                run.step(10)
            poses[i] = run.poses

        threads = [threading.Thread(target=go, args=(i,)) for i in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        for one in poses:
            np.testing.assert_array_equal(one, alone.poses)

    def test_one_run_refuses_a_second_thread(self):
        run = mlab.load(PATROL).run()
        begin = run.save()
        stops = threading.Event()
        refused = []

        def go():
            while not stops.is_set():
                try:
                    run.step(1_000)
                    run.restore(begin)
                except RuntimeError as error:
                    refused.append(str(error))

        thread = threading.Thread(target=go)
        thread.start()
        until = time.monotonic() + 30
        while time.monotonic() < until and not refused:
            try:
                run.step(1)
                run.poses
            except RuntimeError as error:
                refused.append(str(error))
        stops.set()
        thread.join()
        self.assertEqual(set(refused), {"this run is in use by another thread"})

    def test_a_thread_that_ends_takes_no_robots_along(self):
        own = os.path.join(ROOT, "docs", "examples", "own_behavior", "mine.mdl")
        runs = []
        thread = threading.Thread(target=lambda: runs.append(mlab.load(own).run()))
        thread.start()
        thread.join()
        self.assertEqual(runs[0].finish(), "done")
        self.assertEqual(runs[0].robots[0].fault, "")


class Endings(unittest.TestCase):
    def ends(self, what):
        process = in_own_process("import threading, time\n" + what)
        out, err = process.communicate(timeout=60)
        self.assertEqual((process.returncode, err), (0, ""))

    def test_python_ends_while_a_thread_steps(self):
        self.ends(
            "run = mission.run(); begin = run.save()\n"
            "def go():\n    while True: run.finish(); run.restore(begin)\n"
            "threading.Thread(target=go, daemon=True).start(); time.sleep(0.1)"
        )

    def test_python_ends_while_a_thread_learns(self):
        self.ends(
            "e = mlab.Environment(mission, observation='body.x', action=[])\n"
            "def go():\n    while True:\n        e.reset()\n        for _ in range(100): e.step([[], []])\n"
            "threading.Thread(target=go, daemon=True).start(); time.sleep(0.1)"
        )


class Forks(unittest.TestCase):
    def in_child(self, work):
        reader, writer = os.pipe()
        child = os.fork()
        if child == 0:
            try:
                os.write(writer, str(work()).encode())
            finally:
                os._exit(0)
        os.close(writer)
        with os.fdopen(reader) as file:
            said = file.read()
        self.assertEqual(os.waitpid(child, 0)[1], 0)
        return said

    def test_a_run_belongs_to_the_process_that_made_it(self):
        own = os.path.join(ROOT, "docs", "examples", "own_behavior", "mine.mdl")
        held = [mlab.load(own).run()]
        held[0].step(3)

        def meddle():
            try:
                held[0].step()
            except RuntimeError as error:
                held.clear()
                gc.collect()
                return error
            return "stepped"

        self.assertIn("belongs to the process", self.in_child(meddle))
        self.assertEqual(held[0].finish(), "done", held[0].messages[-3:])

    def test_a_child_makes_runs_of_its_own(self):
        patrol = mlab.load(PATROL)
        run = patrol.run(seed=5)
        run.step(50)
        self.assertEqual(self.in_child(lambda: self.poses_of(patrol)), str(run.poses.tolist()))

    @staticmethod
    def poses_of(patrol):
        run = patrol.run(seed=5)
        run.step(50)
        return run.poses.tolist()

    def test_a_pool_of_processes(self):
        with multiprocessing.get_context("fork").Pool(2) as pool:
            tables = pool.map(duration_of, [1, 2, 1])
        self.assertEqual(tables[0], tables[2])
        with multiprocessing.get_context("fork").Pool(1) as pool:
            with self.assertRaisesRegex(mlab.Error, "cannot read `none.mdl`"):
                pool.map(mlab.load, ["none.mdl"])


def duration_of(seed):
    run = mlab.load(PATROL).run(seed=seed)
    run.finish()
    return run.time


class Memory(unittest.TestCase):
    def test_arrays_outlive_what_they_come_from(self):
        run = mlab.load(PATROL).run()
        run.step(50)
        poses, pose, values = run.poses, run.robots[0].pose, run.port(1, "*")
        table = run.trace("*", seconds=1.0)
        environment = mlab.Environment(mlab.Scenario(robots=20), observation="body.ranges", action="wish")
        seen, _ = environment.reset()
        copies = [poses.copy(), pose.copy(), seen.copy()]
        robot = run.robots[1]
        del run, environment
        gc.collect()
        for one, was in zip((poses, pose, seen), copies):
            np.testing.assert_array_equal(one, was)
            one += 1.0
        self.assertEqual(table.rows, 20)
        self.assertTrue(values)
        self.assertEqual(robot.life, "running", "a robot keeps its run")

    def test_nothing_changes_in_an_array_behind_its_owners_back(self):
        run = mlab.load(PATROL).run()
        run.step(10)
        poses = run.poses
        before = poses.copy()
        run.step(100)
        np.testing.assert_array_equal(poses, before)

    def test_things_are_deleted_in_any_order(self):
        for order in range(6):
            patrol = mlab.load(PATROL)
            run = patrol.run()
            run.step(3)
            things = {"mission": patrol, "run": run, "checkpoint": run.save()}
            del patrol, run
            names = list(things)
            names = names[order % 3 :] + names[: order % 3]
            for name in names if order < 3 else reversed(names):
                del things[name]
                gc.collect()
                if "run" in things:
                    things["run"].step(2)
                if "checkpoint" in things and "run" in things:
                    things["run"].restore(things["checkpoint"])

    def test_many_runs_take_no_more_and_more(self):
        patrol = mlab.load(PATROL)

        def resident():
            with open("/proc/self/statm") as file:
                return int(file.read().split()[1]) * os.sysconf("SC_PAGESIZE")

        for _ in range(20):
            patrol.run().step(5)
        before = resident()
        for _ in range(200):
            patrol.run().step(5)
        self.assertLess(resident() - before, 8_000_000)


class Pickles(unittest.TestCase):
    def test_what_lives_here_is_refused_with_a_sentence(self):
        patrol = mlab.load(PATROL)
        run = patrol.run()
        environment = mlab.Environment(patrol, observation="body.x", action=[])
        for thing in (patrol, run, run.robots[0], run.save(), environment, environment.action_space):
            for refuse in (pickle.dumps, copy.copy, copy.deepcopy):
                with self.assertRaisesRegex(TypeError, r"can't be pickled or copied: \w+ .*"):
                    refuse(thing)

    def test_errors_and_ports_go_along(self):
        with self.assertRaises(mlab.Error) as caught:
            mlab.load("none.mdl")
        again = pickle.loads(pickle.dumps(caught.exception))
        self.assertEqual((str(again), again.problems), (str(caught.exception), caught.exception.problems))
        ports = mlab.load(PATROL).ports()
        self.assertEqual(pickle.loads(pickle.dumps(ports)), ports)


class Nonsense(unittest.TestCase):
    def test_paths(self):
        for wrong in ("", "none.mdl", ROOT, "/dev/null/x", "a\0b", "x" * 5000, "/proc/self/mem"):
            with self.assertRaises(mlab.Error, msg=repr(wrong)):
                mlab.load(wrong)
        for wrong in (None, 3, b"x", [PATROL]):
            with self.assertRaises(TypeError, msg=repr(wrong)):
                mlab.load(wrong)

    def test_values(self):
        run = mlab.load(PATROL).run()
        for wrong in (float("nan"), float("inf"), -1, 1e300, "fast", [1, 2], True, "1; 2", "{", "9" * 5000):
            with self.assertRaises(mlab.Error, msg=repr(wrong)):
                run.set(1, "base_velocity", wrong)
        for wrong in (None, object(), {}, [], [[1]], [None]):
            with self.assertRaises((TypeError, mlab.Error), msg=repr(wrong)):
                run.set(1, "base_velocity", wrong)
        for wrong in (-1, 2**40, 99):
            with self.assertRaises(mlab.Error, msg=repr(wrong)):
                run.port(wrong, "base_velocity")
        for wrong in ("", "no", "base_velocity.x", "zz*", "\0", "*" * 3000 + "zz"):
            with self.assertRaises(mlab.Error, msg=repr(wrong)):
                run.port(1, wrong)
        for wrong in (None, 3, b"x"):
            with self.assertRaises(TypeError):
                run.port(1, wrong)
        with self.assertRaises(mlab.Error):
            run.answer(12)
        with self.assertRaises(mlab.Error):
            run.force(1, "no", "state")
        with self.assertRaises(mlab.Error):
            run.hold(1, "base_velocity", 1)
        with self.assertRaises(mlab.Error):
            run.release(7)

    def test_words(self):
        run = mlab.load(PATROL).run()
        not_utf8 = "\udc80.mdl"
        for name, call in (
            ("path", lambda wrong: mlab.load(wrong)),
            ("mission", lambda wrong: mlab.batch(wrong, runs=1)),
            ("record", lambda wrong: run.mission.run(record=wrong)),
            ("type", run.mission.ports),
            ("line", run.order),
            ("name", lambda wrong: run.port(1, wrong)),
            ("port", lambda wrong: run.set(1, wrong, 1)),
            ("port", lambda wrong: run.hold(1, wrong, 1)),
            ("port", lambda wrong: run.release(1, wrong)),
            ("sequence", lambda wrong: run.force(1, wrong, "state")),
            ("state", lambda wrong: run.force(1, "sequence", wrong)),
        ):
            for wrong in (3, b"x", run):
                with self.assertRaisesRegex(TypeError, f"^{name}: expected .* as text, not {type(wrong).__name__}"):
                    call(wrong)
            for wrong in (not_utf8, "a\0b"):
                with self.assertRaisesRegex(mlab.Error, f"^{name}: "):
                    call(wrong)
        with self.assertRaisesRegex(TypeError, "^set: expected names with their values"):
            mlab.load(PATROL, set=3)

    def test_times(self):
        run = mlab.load(PATROL).run()
        for wrong in (-1, 2**70):
            with self.assertRaises(mlab.Error):
                run.step(wrong)
        for wrong in (0, -1, float("nan"), float("inf")):
            with self.assertRaises(mlab.Error):
                run.finish(limit=wrong)
        self.assertEqual(run.finish(limit=1e300), "done")
        for wrong in ({"seed": -1}, {"threads": 0}, {"threads": 10**6}, {"patience": 0}, {"start_time": "noon"}):
            with self.assertRaises(mlab.Error, msg=str(wrong)):
                mlab.load(PATROL).run(**wrong)


if __name__ == "__main__":
    unittest.main()
