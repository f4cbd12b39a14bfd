#!/usr/bin/python3
"""Measures the kiosk's peak memory during a visit.

    tests/bench/visit_memory.py [--size WxH] [--runs N] [PROGRAM [TARGETS]]

The visitor is tests/window/visit.sh, by mouse and on one core of the renderer; TARGETS is the folder of screen_targets,
clay_places and judge_session. Told are the program's own memory, which this project answers for, and, for information,
all that is resident: fonts and drivers of the machine are in it.
"""

import argparse
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import watched_kiosk

CHECKOUT = pathlib.Path(__file__).resolve().parents[2]


def most_of_visit(program, targets, size):
    """The largest own and resident memory, MB; the first is sampled ten times a second."""
    with tempfile.TemporaryDirectory() as folder:
        starter = pathlib.Path(folder, "onggi")
        starter.write_text(f'#!/bin/sh\n[ "$1" != kiosk ] || echo $$ >{folder}/process\nexec {program} "$@"\n')
        starter.chmod(0o700)
        visit = subprocess.Popen(["bash", CHECKOUT / "tests/window/visit.sh", starter, targets, folder + "/visit", "mouse", "en", size],
                                 env=dict(os.environ, LP_NUM_THREADS="0"), stdout=sys.stderr)
        most_own_mb, most_resident_mb = 0, 0
        while visit.poll() is None:
            time.sleep(0.1)
            try:
                process = int(pathlib.Path(folder, "process").read_text())
                most_own_mb = max(most_own_mb, watched_kiosk.memory_mb(process, "RssAnon", "RssShmem"))
                most_resident_mb = max(most_resident_mb, watched_kiosk.memory_mb(process, "VmHWM"))
            except (OSError, ValueError):
                pass  # not started yet, or ended
        if visit.returncode != 0:
            raise SystemExit(f"{visit.args[1]}: exit code {visit.returncode}")
        return most_own_mb, most_resident_mb


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--size", default="1280x720", help="of the picture (1280x720)")
    words.add_argument("--runs", type=int, default=3, help="visits (3)")
    words.add_argument("program", nargs="?", default=str(CHECKOUT / "build/release/onggi"))
    words.add_argument("targets", nargs="?", default=str(CHECKOUT / "build/release/tests"))
    wish = words.parse_args()
    for _ in range(wish.runs):
        own_mb, resident_mb = most_of_visit(os.path.abspath(wish.program), os.path.abspath(wish.targets), wish.size)
        print(f"{wish.size}: {own_mb:.0f} MB of its own at most, {resident_mb:.0f} MB resident", flush=True)


if __name__ == "__main__":
    main()
