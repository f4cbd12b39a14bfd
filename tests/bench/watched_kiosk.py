"""A kiosk on a display of its own, for scripts that measure its picture."""

import contextlib
import os
import shutil
import signal
import socket
import subprocess
import tempfile

# How many times slower this machine is than the reference machine (tests/support/patience.h).
SLOWNESS = max(1.0, float(os.environ.get("ONGGI_SLOWNESS", "1")))


def memory_mb(process, *names):
    """The sum of sizes of a process from /proc/PROCESS/status, MB of a million bytes: RssAnon and RssShmem, the memory that the
    program has allocated itself or shares with the display's server; VmRSS, with the files that it has mapped; VmHWM, its peak."""
    sizes = {}
    with open(f"/proc/{process}/status") as lines:
        for line in lines:
            name, _, value = line.partition(":")
            if name in names:
                sizes[name] = int(value.split()[0]) * 1024 / 1e6
    if len(sizes) != len(names):
        raise ValueError(f"/proc/{process}/status: expected {', '.join(names)}, found {', '.join(sizes) or 'none'}")
    return sum(sizes.values())


@contextlib.contextmanager
def display(size, folder):
    """The name of a new display of WxH pixels; its picture is folder/Xvfb_screen0, in xwd format."""
    server = subprocess.Popen(["Xvfb", "-displayfd", "1", "-noreset", "-fbdir", folder, "-screen", "0", size + "x24"],
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    try:
        yield ":" + server.stdout.readline().decode().strip()
    finally:
        server.terminate()
        server.wait()


def under_cage(folder):
    """The command that starts a program in the museum's compositor, in a window of the display. It refuses root."""
    compositor = ["env", "WLR_BACKENDS=x11", "WLR_RENDERER=pixman", "XDG_RUNTIME_DIR=" + folder, "HOME=" + folder, "cage", "--"]
    if os.geteuid() != 0:
        return compositor
    os.chmod(folder, 0o700)
    shutil.chown(folder, "nobody")
    return ["setpriv", "--reuid=nobody", "--regid=nogroup", "--clear-groups", *compositor]


@contextlib.contextmanager
def kiosk(program, folder, display_name, words=(), starter=(), **environment):
    """Its process, or that of what starts it, from when it tells its service manager that a picture is shown and the hand's
    loop has ticked."""
    place = tempfile.mktemp(dir=folder)
    manager = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
    manager.bind(place)
    manager.settimeout(120 * SLOWNESS)
    environment = dict(os.environ, DISPLAY=display_name, NOTIFY_SOCKET=place, **environment)
    environment.pop("WAYLAND_DISPLAY", None)
    os.chmod(place, 0o777)
    process = subprocess.Popen([*starter, program, "kiosk", "--volume", "0", "--device", "mouse", "--gallery", folder + "/pots", *words],
                               env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        while b"READY=1" not in manager.recv(4096):
            pass
        yield process
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait()
