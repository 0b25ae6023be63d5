#!/usr/bin/python3
"""What an environment for learning costs beside `mlab bench`: processor time of the same scenario, in turns.

    PYTHONPATH=build/test/python bench/python_environment.py [--command build/test/bin/mlab] [--robots 1000]

Each turn runs `mlab bench` and the same cycles through mlab.Environment, one array in and one out in each cycle; of
both the processor time of the cycles alone counts, by running twice as many and taking the difference. The check
values of both are compared: they have to be the same, with the bench's own control and with a policy in numpy.
What the policy itself computes, in numpy, is the user's, and stands by itself.
Exit status: 0 within 1.5 times the bench's time with the same values, 1 not.
"""

import argparse
import json
import math
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np

import mlab

MOST = 1.5  # times the bench's time
WARM_UP = 5  # cycles that the bench does not time
COUNTED = 100  # cycles in which the bench counts hits


def bench(options, cycles, control):
    """Processor seconds of `mlab bench`, and what it says."""
    with tempfile.NamedTemporaryFile(suffix=".json") as file:
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(
            [options.command, "bench", "--robots", str(options.robots), "--threads", "1", "--control", control]
            + ["--cycles", str(cycles), "--json", file.name],
            check=True,
            stdout=subprocess.DEVNULL,
        )
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
        said = json.load(open(file.name))
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, said


class Own:
    """The bench's own control: one of its parameters goes in, what a policy would look at comes out."""

    def __init__(self, robots, control):
        half = 0.9 * math.sqrt(10.0 * robots) / 2.0
        self.program = control
        self.acted, value = {"schemas": ("half", half), "diffusion": ("wheels.cruise", 0.2)}[control]
        self.action = np.full((robots, 1), value)

    def act(self, ranges):
        return self.action


class Numpy:
    """The bench's diffusion as a policy in numpy: straight on, and away from what is ahead."""

    program, acted = "steered", "wish"

    def __init__(self, robots):
        angles = (np.arange(24) + 0.5) * (2 * np.pi / 24)
        angles = np.where(angles > np.pi + 1e-9, angles - 2 * np.pi, angles)
        self.beams = np.stack([np.cos(angles), np.sin(angles)], axis=1) / 24
        self.ahead = np.flatnonzero(np.abs(angles) <= np.pi / 2 + 1e-9)
        self.action = np.zeros((robots, 3))

    def act(self, ranges):
        near = 1.0 - ranges
        x, y = (near @ self.beams).T
        is_free = (x * x + y * y < 0.01**2) | (np.abs(np.arctan2(y, x)) > 1.7453293)
        ahead = near[:, self.ahead].max(axis=1)
        self.action[:, 0] = np.where(is_free, 0.2, np.where(ahead > 0.5, 0.0, 0.1))
        self.action[:, 2] = np.where(is_free, 0.0, np.where(y > 0.0, -1.4286, 1.4286))
        return self.action


def environment_for(policy, robots, observation):
    scenario = mlab.Scenario(robots=robots, control=policy.program)
    return mlab.Environment(scenario, observation=observation, action=policy.acted)


def cycles_of(policy, robots, cycles):
    """Processor seconds of so many cycles, one array in, one array out; and of the policy between them."""
    environment = environment_for(policy, robots, "body.ranges")
    ranges, _ = environment.reset(seed=1)
    for _ in range(WARM_UP):
        ranges = environment.step(policy.act(ranges))[0]
    ours = theirs = 0.0
    before = time.process_time()
    for _ in range(cycles):
        action = policy.act(ranges)
        decided = time.process_time()
        ranges = environment.step(action)[0]
        after = time.process_time()
        theirs += decided - before
        ours += after - decided
        before = after
    return ours, theirs


def values_of(policy, robots, cycles):
    """What `mlab bench` says of a run, counted from the arrays."""
    environment = environment_for(policy, robots, ["body.ranges", "body.x", "body.y", "body.contacts"])
    seen, _ = environment.reset(seed=1)
    hits = distance = 0.0
    begin = None
    for cycle in range(max(COUNTED, WARM_UP + cycles)):
        if cycle < COUNTED:
            hit = seen[:, :24] < 1.0
            hits += hit.sum()
            distance += seen[:, :24][hit].sum()
        if cycle == WARM_UP:
            begin = seen
        if cycle == WARM_UP + cycles:
            break
        seen = environment.step(policy.act(seen[:, :24]))[0]
    way = seen[:, 24:26] - begin[:, 24:26]
    return {
        "hit_share": hits / (24 * robots * COUNTED),
        "mean_hit_distance_m": distance / hits,
        "mean_displacement_m": np.sqrt((way**2).sum(axis=1)).mean(),
        "contacts": seen[:, 26].sum(),
    }


def compare(name, policy, control, options, tolerance):
    """Prints a row. Whether time and values are as they have to be."""
    ours, theirs, thinking = [], [], []
    for _ in range(options.turns):
        twice, _ = bench(options, 2 * options.cycles, control)
        once, _ = bench(options, options.cycles, control)
        theirs.append(twice - once)
        stepping, deciding = cycles_of(policy, options.robots, options.cycles)
        ours.append(stepping)
        thinking.append(deciding)
    said = bench(options, COUNTED * 2, control)[1]
    values = values_of(policy, options.robots, COUNTED * 2)
    worst = max(abs(values[one] - said[one]) / max(1e-12, abs(said[one])) for one in values)
    ratio = min(ours) / min(theirs)
    each = 1e9 / (options.robots * options.cycles)
    print(f"{name:34} {min(theirs) * each:7.0f} {min(ours) * each:7.0f} {ratio:6.2f} {min(thinking) * each:7.0f} {worst:10.1e}")
    for one in values:
        print(f"    {one:30} {said[one]:.6f} {values[one]:.6f}")
    return ratio <= MOST and worst <= tolerance


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--command", default="build/test/bin/mlab", help="the mlab command (%(default)s)")
    parser.add_argument("--robots", type=int, default=1000)
    parser.add_argument("--cycles", type=int, default=1000, help="of each measurement")
    parser.add_argument("--turns", type=int, default=5, help="the best of each counts")
    options = parser.parse_args()
    print(f"{options.robots} robots, one thread, processor time in ns for each robot and cycle, best of {options.turns}")
    print(f"{'':34} {'bench':>7} {'arrays':>7} {'ratio':>6} {'policy':>7} {'difference':>10}")
    good = [
        compare("its own control by schemas", Own(options.robots, "schemas"), "schemas", options, 1e-9),
        compare("its own control by diffusion", Own(options.robots, "diffusion"), "diffusion", options, 1e-9),
        compare("diffusion as a policy in numpy", Numpy(options.robots), "diffusion", options, 1e-9),
    ]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
