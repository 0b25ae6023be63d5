"""A thousand robots steered by a policy in numpy: straight on, and away from whatever presses from ahead.

    ./mlab python python/examples/crowd.py
"""

import numpy as np

import mlab

environment = mlab.Environment(
    mlab.Scenario(robots=1000),
    observation=["body.ranges", "body.driven"],
    action="wish",
    reward=lambda before, action, after: after[:, 24] - before[:, 24],  # way that was made [m]
)
observation, _ = environment.reset(seed=1)

# 24 beams, evenly all round from 7.5 degrees; they see 1 m far.
angles = np.radians(7.5 + 15.0 * np.arange(24))
angles = (angles + np.pi) % (2 * np.pi) - np.pi
beams = np.stack([np.cos(angles), np.sin(angles)], axis=1) / len(angles)
ahead = np.abs(angles) < np.pi / 2


def policy(observation):
    near = 1.0 - observation[:, :24]  # 0: nothing in reach, 1: it touches
    x, y = (near @ beams).T
    is_free = (np.hypot(x, y) < 0.01) | (np.abs(np.arctan2(y, x)) > 1.75)
    is_blocked = near[:, ahead].max(axis=1) > 0.5
    action = np.zeros(environment.action_space.shape)
    action[:, 0] = np.where(is_free, 0.2, np.where(is_blocked, 0.0, 0.1))  # ahead [m/s]
    action[:, 2] = np.where(is_free, 0.0, np.where(y > 0.0, -1.4286, 1.4286))  # turning [rad/s]
    return action


way = 0.0
for _ in range(200):
    observation, reward, terminated, truncated, info = environment.step(policy(observation))
    way += reward.mean()
print(f"{info['time']:.0f} s, {way:.2f} m on average")

# It prints:
#     20 s, 3.81 m on average
