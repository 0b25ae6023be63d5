"""Robots of a mission that learn: how fast should they go, so that they get far and spare their batteries?

The search is the simplest there is (try something near the best, keep it where it is better); what learns is
yours to exchange.

    ./mlab python python/examples/learn.py
"""

import numpy as np

import mlab


def reward(before, action, after):
    way = after[:, 0] - before[:, 0]
    return way - 0.02 * action[:, 0] ** 2  # going fast costs more than it brings


environment = mlab.Environment(
    "missions/patrol/patrol.mdl",
    observation="body.driven",
    action="base_velocity",
    reward=reward,
    limit=10.0,
)


def episode(speed):
    environment.reset(seed=1)
    gain = 0.0
    done = np.zeros(environment.num_envs, dtype=bool)
    while not done.all():
        action = np.full(environment.action_space.shape, speed)
        _, reward, terminated, truncated, _ = environment.step(action)
        gain += reward.sum()
        done = terminated | truncated
    return gain


random = np.random.default_rng(1)
best, gain = 1.0, episode(1.0)
first = gain
for _ in range(30):
    speed = abs(best + random.normal(scale=0.5))
    if (tried := episode(speed)) > gain:
        best, gain = speed, tried
print("better than at 1 m/s:", bool(gain > first))
print(f"base velocity: {best:.1f} m/s")

# It prints:
#     better than at 1 m/s: True
#     base velocity: 2.2 m/s
