#!/usr/bin/env python3
"""What it takes to drive vehicles at 10 Hz: a run with so many simulated vehicles of a fleet, each a process
of its own, in real time over DDS on the loopback. Prints processor time of the run's side, and of the vehicles'
side, as shares of a processor, once all of them drive.

usage: bench/vehicles.py [MLAB [VEHICLES [SECONDS]]]
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
TICKS = os.sysconf("SC_CLK_TCK")
SETTLING = 6.0  # until all have started and drive [s]


def processor_time(process):
    """Of a process and all of its threads [s]."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def mission(count, folder):
    """Robots in a column go along a field that is too long to be crossed meanwhile."""
    text = ['MISSION NAME "Twenty"', "OVERLAY field.odl", ""]
    for i in range(count):
        text.append(
            f'NEW-ROBOT r{i} "robot" green "veh-{i}" (base_velocity = 0.8, max_velocity = 1, robot_radius = 0.3)'
        )
    text.append("UNIT <team> " + " ".join(f"r{i}" for i in range(count)))
    text += ["", "COMMAND LIST:", "", "  0. UNIT team START Here", "  1. UNIT team MOVETO There", "  2. UNIT team STOP"]
    (folder / "field.mdl").write_text("\n".join(text) + "\n")
    (folder / "field.odl").write_text(
        f"MISSION-AREA 2000 {3 * count + 20}\n\nCONTROL MEASURES:\n\n"
        f"PP Here 10 {1.5 * count + 10}\nPP There 1900 {1.5 * count + 10}\n"
    )
    return folder / "field.mdl"


def main():
    mlab = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build/release/bin/mlab").resolve()
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    seconds = float(sys.argv[3]) if len(sys.argv) > 3 else 20.0
    fleet = f"bench-{os.getpid()}"
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        file = mission(count, folder)
        vehicles = []
        run = None
        try:
            for i in range(count):
                words = [mlab, "robot", "--binding", "simulated", "--fleet", fleet, "--name", f"veh-{i}"]
                said = (folder / f"veh-{i}").open("w")
                words += ["--at", f"10,{3 * i + 10},0"]
                vehicles.append(subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=said, stderr=said))
            time.sleep(SETTLING)
            log = (folder / "log").open("w")
            words = [mlab, "run", file, "--robots", "fleet", "--fleet", fleet, "--real-time", "--headless", "--proceed"]
            run = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=log, stderr=log)
            time.sleep(SETTLING)
            before = processor_time(run), [processor_time(one) for one in vehicles], time.monotonic()
            time.sleep(seconds)
            if run.poll() is not None:
                sys.exit("the run has ended:\n" + (folder / "log").read_text())
            wall = time.monotonic() - before[2]
            driven = sum("a run drives it" in (folder / f"veh-{i}").read_text() for i in range(count))
            if driven < count:
                sys.exit(f"only {driven} vehicles of {count} are driven:\n" + (folder / "log").read_text())
            of_run = (processor_time(run) - before[0]) / wall
            of_each = [(processor_time(one) - was) / wall for one, was in zip(vehicles, before[1])]
        finally:
            for one in [*vehicles, *([run] if run else [])]:
                one.kill()
                one.wait()
    print(f"{count} vehicles at 10 Hz, {wall:.0f} s: the run {100 * of_run:.1f} % of a processor, ", end="")
    print(f"the vehicles {100 * sum(of_each):.1f} %, {100 * max(of_each):.1f} % at most for one")


if __name__ == "__main__":
    main()
