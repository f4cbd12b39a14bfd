#!/usr/bin/python3
"""Measures the kiosk's time from start to the first picture, and its memory afterwards.

    tests/bench/start.py [--runs N] [--after SECONDS] [PROGRAM]

On a display of its own (Xvfb). A start is over when the program tells its service manager so: a picture is shown and
the hand's loop has ticked. Three kinds: without anything the system or the driver has kept of the program (as root
only: it empties the page cache), without the driver's own cache of compiled shaders, and again.
"""

import argparse
import os
import tempfile
import time

import watched_kiosk


def start(program, folder, display, cache, after_s):
    """Returns the seconds to the first picture, and its own and the resident memory, MB, some seconds later."""
    began = time.monotonic()
    with watched_kiosk.kiosk(program, folder, display, MESA_SHADER_CACHE_DIR=cache) as kiosk:
        took_s = time.monotonic() - began
        time.sleep(after_s)
        own_mb = watched_kiosk.memory_mb(kiosk.pid, "RssAnon", "RssShmem")
        resident_mb = watched_kiosk.memory_mb(kiosk.pid, "VmRSS")
        return took_s, own_mb, resident_mb


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--runs", type=int, default=3, help="of each kind (3)")
    words.add_argument("--after", type=float, default=10, help="seconds until the memory is read (10)")
    words.add_argument("program", nargs="?", default="build/release/onggi")
    wish = words.parse_args()
    with tempfile.TemporaryDirectory() as folder, watched_kiosk.display("1280x720", folder) as display:
        for kind in ("nothing kept", "driver's cache empty", "again"):
            if kind == "nothing kept" and os.geteuid() != 0:
                continue
            for run in range(wish.runs):
                if kind == "nothing kept":
                    os.sync()
                    with open("/proc/sys/vm/drop_caches", "w") as caches:
                        caches.write("3")
                cache = folder + ("/kept" if kind == "again" else f"/{kind[0]}{run}")
                if kind == "again" and run == 0:
                    start(wish.program, folder, display, cache, 0)
                took_s, own_mb, resident_mb = start(wish.program, folder, display, cache, wish.after)
                print(f"{kind}: {took_s:.2f} s, then {own_mb:.0f} MB of its own, {resident_mb:.0f} MB resident", flush=True)


if __name__ == "__main__":
    main()
