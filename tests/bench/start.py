#!/usr/bin/python3
"""How long the kiosk takes from its start to its first picture, and what memory it then holds.

    tests/bench/start.py [--runs N] [--after SECONDS] [PROGRAM]

On a display of its own (Xvfb). A start is over when the program tells its service manager so: a picture is shown and
the hand's loop has ticked. Three kinds: without anything the system or the driver has kept of the program (as root
only: it empties the page cache), without the driver's own cache of compiled shaders, and again.
"""

import argparse
import os
import signal
import socket
import subprocess
import tempfile
import time


def resident_mb(process):
    """VmRSS, in MB of a million bytes."""
    with open(f"/proc/{process}/status") as status:
        for line in status:
            if line.startswith("VmRSS:"):
                return int(line.split()[1]) * 1024 / 1e6
    raise SystemExit(f"/proc/{process}/status: expected VmRSS, found none")


def start(program, folder, display, cache, after_s):
    """Seconds to the first picture, and MB that many seconds later."""
    place = tempfile.mktemp(dir=folder)
    manager = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    manager.bind(place)
    manager.settimeout(120)
    environment = dict(os.environ, DISPLAY=display, NOTIFY_SOCKET=place, MESA_SHADER_CACHE_DIR=cache)
    environment.pop("WAYLAND_DISPLAY", None)
    began = time.monotonic()
    kiosk = subprocess.Popen([program, "kiosk", "--volume", "0", "--device", "mouse", "--gallery", folder + "/pots"],
                             env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        while b"READY=1" not in manager.recv(4096):
            pass
        took_s = time.monotonic() - began
        time.sleep(after_s)
        return took_s, resident_mb(kiosk.pid)
    finally:
        kiosk.send_signal(signal.SIGTERM)
        kiosk.wait()


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--runs", type=int, default=3, help="of each kind (3)")
    words.add_argument("--after", type=float, default=10, help="seconds until the memory is read (10)")
    words.add_argument("program", nargs="?", default="build/release/onggi")
    wish = words.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-noreset", "-screen", "0", "1280x720x24"],
                                  stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
        try:
            display = ":" + server.stdout.readline().decode().strip()
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
                    took_s, mb = start(wish.program, folder, display, cache, wish.after)
                    print(f"{kind}: {took_s:.2f} s, then {mb:.0f} MB", flush=True)
        finally:
            server.terminate()
            server.wait()


if __name__ == "__main__":
    main()
