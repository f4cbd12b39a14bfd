#!/usr/bin/python3
"""attract_load.py ROUNDS PROGRAM...: the processor time and the wakes of a kiosk that nobody is at, without devices, at
1280x720 on Xvfb with software Vulkan; several builds in turns. Prints the least of the rounds: % of a core, of it the main
thread, which draws, and wakes a second. By hand only."""
import glob
import sys
import tempfile
import time

import watched_kiosk

SETTLED_S = 8  # after the first picture: fonts, plates and the first demonstration are there
MEASURED_S = 15


def used(process):
    """Nanoseconds of processor time of the main thread and of all, and wakes of all."""
    times = {}
    wakes = 0
    for thread in glob.glob(f"/proc/{process}/task/*"):
        with open(thread + "/schedstat") as line:
            times[thread.rsplit("/", 1)[1]] = int(line.read().split()[0])
        with open(thread + "/status") as lines:
            wakes += next(int(line.split()[1]) for line in lines if line.startswith("voluntary_ctxt_switches"))
    return times[str(process)], sum(times.values()), wakes


def measure(program):
    with tempfile.TemporaryDirectory() as folder, watched_kiosk.display("1280x720", folder) as name, \
            watched_kiosk.kiosk(program, folder, name) as process:
        time.sleep(SETTLED_S)
        before = used(process.pid)
        began_s = time.monotonic()
        time.sleep(MEASURED_S)
        after = used(process.pid)
        seconds = time.monotonic() - began_s
        main, total, wakes = ((late - early) / seconds for early, late in zip(before, after))
        return total / 1e7, main / 1e7, wakes


def main():
    rounds, programs = int(sys.argv[1]), sys.argv[2:]
    found = {program: [] for program in programs}
    for _ in range(rounds):
        for program in programs:
            found[program].append(measure(program))
    for program, values in found.items():
        print("%s: %.1f %% of a core, of it %.1f the main thread, %.0f wakes a second" % (program, *map(min, zip(*values))))


main()
