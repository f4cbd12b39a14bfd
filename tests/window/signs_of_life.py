"""A service manager's socket: signs_of_life.py FILE writes a byte into FILE for each "WATCHDOG=1" that it gets (sd_notify(3)).

Prints the name of its socket, which the kernel picks, as NOTIFY_SOCKET takes it. Ends with the process that started it.
"""

import os
import socket
import sys

manager = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
manager.bind("")
manager.settimeout(1.0)
print("@" + manager.getsockname()[1:].decode(), flush=True)
starter = os.getppid()
with open(sys.argv[1], "wb", buffering=0) as signs:
    while os.getppid() == starter:
        try:
            if manager.recv(512) == b"WATCHDOG=1":
                signs.write(b".")
        except socket.timeout:
            pass
