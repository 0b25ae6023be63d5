"""Environments for learning."""

import os
import tempfile
import unittest

import numpy as np

import mlab
from paths import ROOT, mission

PATROL = mission("patrol")


def crowd(**more):
    return mlab.Environment(mlab.Scenario(robots=50), **{"observation": "body.ranges", "action": "wish", **more})


class Scenarios(unittest.TestCase):
    def test_arrays_have_a_row_for_each_robot(self):
        environment = crowd(observation=["body.pose", "wish.x"])
        observation, info = environment.reset(seed=1)
        self.assertEqual(observation.shape, environment.observation_space.shape)
        self.assertEqual([one.name for one in environment.observation_space.columns], ["body.x", "body.y", "body.heading", "wish.x"])
        self.assertEqual([one.name for one in environment.action_space.columns], ["wish.x", "wish.y", "wish.z"])
        self.assertEqual(info, {"time": 0.0, "cycle": 0, "seed": 1})
        self.assertEqual(environment.num_envs, 50)
        observation, reward, terminated, truncated, info = environment.step(np.full((50, 3), 0.1))
        self.assertEqual((observation[:, 3] == 0.1).sum(), 50)
        self.assertEqual((reward.shape, terminated.shape, truncated.shape), ((50,), (50,), (50,)))
        self.assertEqual((terminated.dtype, info["cycle"]), (bool, 1))

    def test_robots_go_as_they_are_told(self):
        environment = crowd(observation="body.driven")
        environment.reset(seed=1)
        action = np.zeros((50, 3))
        action[7, 0] = 0.2
        driven = environment.step(action)[0][:, 0]
        self.assertAlmostEqual(driven[7], 0.02)
        self.assertEqual(driven.sum(), driven[7])

    def test_the_same_seed_and_actions_give_the_same(self):
        one, two = crowd(), crowd(threads=2)
        one.action_space.seed(5)
        self.assertEqual(one.reset(seed=4)[1]["seed"], 4)
        two.reset(seed=4)
        for _ in range(10):
            action = one.action_space.sample()
            np.testing.assert_array_equal(one.step(action)[0], two.step(action)[0])
        first = one.reset(seed=4)[0]
        np.testing.assert_array_equal(first, two.reset(seed=4)[0])
        self.assertEqual(one.reset()[1]["seed"], 5)

    def test_spaces_are_what_gymnasium_asks_of_a_box(self):
        environment = crowd(action="wheels.max_velocity")
        space = environment.action_space
        self.assertEqual((space.shape, space.dtype), ((50, 1), np.float64))
        self.assertEqual((space.low.min(), space.high.max()), (0.0, 100.0))
        self.assertIn(space.sample(), space)
        self.assertNotIn(space.sample() - 1000.0, space)
        self.assertNotIn(np.full((50, 1), np.nan), space)
        self.assertNotIn("words", space)
        beam = environment.observation_space.columns[0]
        self.assertEqual((beam.unit, beam.low, beam.high), ("m", 0.0, 1.0))
        self.assertIn(environment.reset()[0], environment.observation_space)

    def test_rewards_are_a_function_of_the_users(self):
        calls = []

        def reward(before, action, after):
            calls.append((before.copy(), after.copy()))
            return after[:, 0] - before[:, 0]

        environment = crowd(observation="body.driven", reward=reward)
        begin, _ = environment.reset()
        begin += 100.0  # what was handed out is the user's
        after, gain, *_ = environment.step(np.full((50, 3), 0.1))
        np.testing.assert_array_equal(gain, after[:, 0])
        self.assertEqual(calls[0][0].max(), 0.0)

    def test_rewards_are_a_number_for_each_robot(self):
        for wrong in (None, "much", np.zeros(3), np.zeros((50, 1)), 1j):
            environment = crowd(reward=lambda before, action, after, wrong=wrong: wrong)
            environment.reset()
            with self.assertRaisesRegex(mlab.Error, "expected a number for each of 50 robots", msg=repr(wrong)):
                environment.step(np.zeros((50, 3)))
        environment = crowd(reward=lambda before, action, after: after[:, 0] > 0.5)
        environment.reset()
        self.assertEqual(environment.step(np.zeros((50, 3)))[1].dtype, np.float64)

    def test_rewards_are_a_port(self):
        environment = crowd(observation="body.pose", reward="wish.x")
        environment.reset()
        observation, reward, *_ = environment.step(np.full((50, 3), 0.1))
        self.assertEqual((observation.shape, reward.min()), ((50, 3), 0.1))
        with self.assertRaisesRegex(mlab.Error, "is not one number"):
            crowd(reward="wish")

    def test_a_network_of_the_users_own(self):
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, "mine.cnl")
            with open(file, "w") as text:
                text.write("parameter double speed = 0.1 in 0 .. 1;\nnode ahead is MoveForward with nend\n"
                           "node drive is Drive with v = ahead; base_velocity = speed; max_velocity = 1; nend\n")
            environment = mlab.Environment(mlab.Scenario(robots=3, control=file), observation="ahead", action="speed")
            environment.reset()
            np.testing.assert_array_equal(environment.step(np.full((3, 1), 0.1))[0], [[1, 0, 0]] * 3)

    def test_what_can_not_be_is_refused(self):
        environment = crowd()
        with self.assertRaisesRegex(mlab.Error, "reset"):
            environment.step(np.zeros((50, 3)))
        environment.reset()
        for wrong in (np.zeros((50, 2)), np.zeros(50), 0.0, np.full((50, 3), np.nan), np.full((50, 3), np.inf), []):
            with self.assertRaises(mlab.Error):
                environment.step(wrong)
        with self.assertRaises((TypeError, ValueError)):
            environment.step("forward")
        self.assertEqual(environment.step(np.zeros((50, 3)))[4]["cycle"], 1)
        for wrong in ({"observation": "body.rnges"}, {"action": "body.x"}, {"action": ["wish", "wish"]}, {"threads": 0}, {"limit": -1}, {"robots": [1]}):
            with self.assertRaises(mlab.Error, msg=str(wrong)):
                crowd(**wrong)
        with self.assertRaises(TypeError):
            crowd(reward=3)
        with self.assertRaises(TypeError):
            crowd(action=[3])
        for wrong in ({"robots": 0}, {"robots": 10**9}, {"control": "no_such_file.cnl"}, {"range": float("nan")}, {"cycle_duration": 0}):
            with self.assertRaises(mlab.Error, msg=str(wrong)):
                mlab.Environment(mlab.Scenario(**wrong), observation="body.x", action="wish")


class InMissions(unittest.TestCase):
    def test_without_actions_it_is_the_mission(self):
        environment = mlab.Environment(PATROL, observation="body.pose", action=[])
        environment.reset(seed=3)
        run = mlab.load(PATROL).run(seed=3)
        terminated = np.zeros(2, dtype=bool)
        while not terminated.all():
            run.step()
            observation, _, terminated, truncated, info = environment.step(np.zeros((2, 0)))
            np.testing.assert_array_equal(observation, run.poses)
        self.assertEqual([robot.life for robot in run.robots], ["stopped"] * 2)
        self.assertFalse(truncated.any())

    def test_parameters_are_actions(self):
        environment = mlab.Environment(PATROL, observation="body.driven", action="base_velocity", robots=[2])
        way = []
        for speed in (0.5, 2.0):
            environment.reset(seed=1)
            for _ in range(50):
                observation = environment.step([[speed]])[0]
            way.append(observation[0, 0])
        self.assertLess(2 * way[0], way[1])

    def test_outputs_are_held(self):
        patrol = mlab.load(PATROL)
        environment = mlab.Environment(patrol, observation="motion", action="motion")
        environment.reset()
        observation = environment.step([[0.5, 0.25, 0.0]] * 2)[0]
        np.testing.assert_array_equal(observation, [[0.5, 0.25, 0.0]] * 2)

    def test_what_can_not_be_held_is_said(self):
        patrol = mlab.load(PATROL)
        numbers = [path for path, port in patrol.ports().items() if port.role == "output" and port.type in ("Vector", "double")]
        environment = mlab.Environment(patrol, observation="body.x", action=numbers)
        environment.reset()
        with self.assertRaisesRegex(mlab.Error, r"row 0 \(robot 1\): "):
            environment.step(np.zeros(environment.action_space.shape))

    def test_robots_in_cells_learn(self):
        own = os.path.join(ROOT, "docs", "examples", "own_behavior", "mine.mdl")
        environment = mlab.Environment(own, observation=["speed", "body.driven"], action="speed")
        way = []
        for speed in (0.5, 2.0):
            environment.reset(seed=1)
            for _ in range(30):
                observation = environment.step([[speed]])[0]
            self.assertEqual(observation[0, 0], speed)
            way.append(observation[0, 1])
        self.assertLess(2 * way[0], way[1])

    def test_episodes_are_cut_off(self):
        environment = mlab.Environment(PATROL, observation="body.x", action=[], limit=1.0)
        environment.reset()
        cut = [environment.step(np.zeros((2, 0)))[3].all() for _ in range(11)]
        self.assertEqual(cut, [False] * 9 + [True] * 2)

    def test_what_can_not_be_is_refused(self):
        with self.assertRaisesRegex(mlab.Error, "there is no robot 9"):
            mlab.Environment(PATROL, observation="body.x", action=[], robots=[9])
        with self.assertRaisesRegex(mlab.Error, "did you mean `base_velocity`"):
            mlab.Environment(PATROL, observation="body.x", action="base_velocty")
        with self.assertRaises(mlab.Error):
            mlab.Environment("no_such_file.mdl", observation="body.x", action=[])
        environment = mlab.Environment(PATROL, observation="body.x", action="base_velocity")
        environment.reset()
        with self.assertRaisesRegex(mlab.Error, r"row 1 \(robot 2\): -1: `base_velocity` takes numbers from 0 to 100 m/s"):
            environment.step([[1], [-1]])


if __name__ == "__main__":
    unittest.main()
