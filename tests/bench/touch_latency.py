#!/usr/bin/python3
"""Compares the latency of a touch to two smallest clients of the museum's compositor: one of Wayland, one of X11.

    tests/window/with_display.sh --touch FOLDER python3 tests/bench/touch_latency.py [--touches N] [--moving] PROGRAMS

PROGRAMS is the folder of the test program `finger`. cage runs in a window of the display that with_display.sh opens; the
display's touch screen is touched, and the display's picture is looked at until it changes. Either client fills its window
with the other of two greys at each touch: the Wayland client reads wl_touch and shows buffers of wl_shm, the X11 client reads
XInput 2 in Xwayland and shows a picture by MIT-SHM. With --moving they also draw a new frame 60 times a second, and a touch
is seen in the next of them. The clients take turns, ten touches each. Prints the least latency, the median and the 90th
percentile in ms.
"""

import argparse
import array
import ctypes
import mmap
import os
import random
import selectors
import signal
import socket
import statistics
import struct
import subprocess
import tempfile
import time

import watched_kiosk

GREYS = (0x40, 0xC0)  # of each channel, before and after a touch
SIZE = (1024, 768)  # of cage's window and its clients'
BYTES_A_PICTURE = 4 * SIZE[0] * SIZE[1]
TOUCHED = (300, 300)
FRAME_S = 1.0 / 60.0
TOUCHES_A_TURN = 10


class WaylandWindow:
    """A full-screen window by the Wayland wire protocol: object, size and opcode, then arguments of 32 bits."""

    DISPLAY, REGISTRY, COMPOSITOR, SHM, SEAT, SHELL, SURFACE, XDG_SURFACE, TOPLEVEL, TOUCH, POOL, FIRST_BUFFER = range(1, 13)
    GLOBALS = ("wl_compositor", "wl_shm", "wl_seat", "xdg_wm_base")  # from COMPOSITOR on: a new object has the next number
    TOUCH_CAPABILITY = 4
    XRGB = 1

    def __init__(self):
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_STREAM)
        self.socket.connect(os.path.join(os.environ["XDG_RUNTIME_DIR"], os.environ["WAYLAND_DISPLAY"]))
        self.received = b""
        self.offered = {}
        self.touches = 0
        self.has_touch = self.is_configured = False
        self.shown = 0
        self.tell(self.DISPLAY, 1, self.REGISTRY)
        self.read_until(lambda: len(self.offered) == len(self.GLOBALS))
        for number, interface in enumerate(self.GLOBALS):
            self.tell(self.REGISTRY, 0, text=self.offered[interface] + struct.pack("=II", 1, self.COMPOSITOR + number))
        self.read_until(lambda: self.has_touch)
        self.tell(self.COMPOSITOR, 0, self.SURFACE)
        self.tell(self.SHELL, 2, self.XDG_SURFACE, self.SURFACE)
        self.tell(self.XDG_SURFACE, 1, self.TOPLEVEL)
        self.tell(self.SEAT, 2, self.TOUCH)
        self.tell(self.SURFACE, 6)
        self.read_until(lambda: self.is_configured)
        self.make_buffers()

    def make_buffers(self):
        file = os.memfd_create("pictures")
        os.ftruncate(file, 2 * BYTES_A_PICTURE)
        self.memory = mmap.mmap(file, 2 * BYTES_A_PICTURE)
        message = struct.pack("=IIII", self.SHM, 16 << 16, self.POOL, 2 * BYTES_A_PICTURE)
        self.socket.sendmsg([message], [(socket.SOL_SOCKET, socket.SCM_RIGHTS, array.array("i", [file]))])
        for number in range(2):
            self.tell(self.POOL, 0, self.FIRST_BUFFER + number, number * BYTES_A_PICTURE, *SIZE, 4 * SIZE[0], self.XRGB)

    def tell(self, target, opcode, *words, text=b""):
        body = struct.pack(f"={len(words)}I", *words) + text
        self.socket.sendall(struct.pack("=II", target, (8 + len(body)) << 16 | opcode) + body)

    def handle(self, target, opcode, body):
        if (target, opcode) == (self.DISPLAY, 0):
            raise SystemExit(f"touch_latency: expected an obedient compositor, found {body!r}")
        if (target, opcode) == (self.REGISTRY, 0):
            length = struct.unpack_from("=I", body, 4)[0]
            interface = body[8:8 + length - 1].decode()
            if interface in self.GLOBALS:
                self.offered[interface] = body[:-4]  # its number and name, without the version
        elif (target, opcode) == (self.SEAT, 0):
            self.has_touch |= bool(struct.unpack("=I", body)[0] & self.TOUCH_CAPABILITY)
        elif (target, opcode) == (self.SHELL, 0):
            self.tell(self.SHELL, 3, *struct.unpack("=I", body))
        elif (target, opcode) == (self.XDG_SURFACE, 0):
            self.tell(self.XDG_SURFACE, 4, *struct.unpack("=I", body))
            self.is_configured = True
        elif (target, opcode) == (self.TOUCH, 0):
            self.touches += 1

    def read(self):
        part = self.socket.recv(65536)
        if not part:
            raise SystemExit(0)
        self.received += part
        while len(self.received) >= 8:
            target, word = struct.unpack_from("=II", self.received)
            if len(self.received) < word >> 16:
                break
            self.handle(target, word & 0xFFFF, self.received[8:word >> 16])
            self.received = self.received[word >> 16:]

    def read_until(self, is_true):
        while not is_true():
            self.read()

    def show(self, picture):
        start = self.shown * BYTES_A_PICTURE
        self.memory[start:start + BYTES_A_PICTURE] = picture
        self.tell(self.SURFACE, 1, self.FIRST_BUFFER + self.shown, 0, 0)
        self.tell(self.SURFACE, 2, 0, 0, *SIZE)
        self.tell(self.SURFACE, 6)
        self.shown = 1 - self.shown

    def wait(self, seconds):
        selector = selectors.DefaultSelector()
        selector.register(self.socket, selectors.EVENT_READ)
        if selector.select(seconds):
            self.read()


class X11:
    """Xlib by ctypes, and one pixel of the root window."""

    def __init__(self):
        self.x11 = ctypes.CDLL("libX11.so.6")
        for name in ("XOpenDisplay", "XGetImage", "XDefaultVisual"):
            getattr(self.x11, name).restype = ctypes.c_void_p
        for name in ("XDefaultRootWindow", "XCreateSimpleWindow"):
            getattr(self.x11, name).restype = ctypes.c_ulong
        self.x11.XCreateGC.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(None))
        self.root = ctypes.c_ulong(self.x11.XDefaultRootWindow(self.display))

    def blue_of(self, x, y):
        """The first byte of that pixel."""
        image = ctypes.c_void_p(self.x11.XGetImage(self.display, self.root, x, y, 1, 1, ctypes.c_ulong(0xFFFFFFFF), 2))
        data = ctypes.cast(image.value + 16, ctypes.POINTER(ctypes.c_void_p))[0]
        value = ctypes.cast(data, ctypes.POINTER(ctypes.c_ubyte))[0]
        self.x11.XDestroyImage(image)
        return value


class ShmSegmentInfo(ctypes.Structure):
    _fields_ = [("segment", ctypes.c_ulong), ("id", ctypes.c_int), ("address", ctypes.c_void_p), ("read_only", ctypes.c_int)]


class TouchMask(ctypes.Structure):
    _fields_ = [("device", ctypes.c_int), ("length", ctypes.c_int), ("mask", ctypes.c_char_p)]


class X11Window(X11):
    """A full-screen window of Xwayland."""

    GENERIC_EVENT, TOUCH_BEGIN, TOUCH_END, ALL_MASTERS = 35, 18, 20, 1

    def __init__(self):
        super().__init__()
        self.touches = 0
        self.event = (ctypes.c_byte * 192)()
        self.window = ctypes.c_ulong(self.x11.XCreateSimpleWindow(self.display, self.root, 0, 0, *SIZE, 0, ctypes.c_ulong(0), ctypes.c_ulong(0)))
        input_library = ctypes.CDLL("libXi.so.6")
        input_library.XIQueryVersion(self.display, ctypes.byref(ctypes.c_int(2)), ctypes.byref(ctypes.c_int(2)))
        bits = sum(1 << event for event in range(self.TOUCH_BEGIN, self.TOUCH_END + 1)).to_bytes(4, "little")
        mask = TouchMask(self.ALL_MASTERS, len(bits), bits)
        input_library.XISelectEvents(self.display, self.window, ctypes.byref(mask), 1)
        exposure_mask = 1 << 15
        self.x11.XSelectInput(self.display, self.window, ctypes.c_long(exposure_mask))
        self.x11.XMapWindow(self.display, self.window)
        self.read()  # exposed
        self.make_picture()

    def make_picture(self):
        libc = ctypes.CDLL(None)
        libc.shmat.restype = ctypes.c_void_p
        self.shm = ctypes.CDLL("libXext.so.6")
        self.shm.XShmCreateImage.restype = ctypes.c_void_p
        private, read_write, remove = 0, 0o600, 0
        self.info = ShmSegmentInfo()
        self.info.id = libc.shmget(private, ctypes.c_size_t(BYTES_A_PICTURE), read_write)
        self.info.address = libc.shmat(self.info.id, None, 0)
        screen, depth, z_pixmap = 0, 24, 2
        visual = ctypes.c_void_p(self.x11.XDefaultVisual(self.display, screen))
        self.image = ctypes.c_void_p(self.shm.XShmCreateImage(self.display, visual, depth, z_pixmap, ctypes.c_void_p(self.info.address),
                                                              ctypes.byref(self.info), *SIZE))
        self.shm.XShmAttach(self.display, ctypes.byref(self.info))
        self.x11.XSync(self.display, 0)
        libc.shmctl(self.info.id, remove, None)
        self.context = ctypes.c_void_p(self.x11.XCreateGC(self.display, self.window, ctypes.c_ulong(0), None))

    def read(self):
        """Waits for an event; offsets as in XGenericEventCookie."""
        self.x11.XNextEvent(self.display, self.event)
        number = lambda offset: struct.unpack_from("=i", self.event, offset)[0]
        self.touches += number(0) == self.GENERIC_EVENT and number(36) == self.TOUCH_BEGIN

    def show(self, picture):
        ctypes.memmove(self.info.address, picture, BYTES_A_PICTURE)
        self.shm.XShmPutImage(self.display, self.window, self.context, self.image, 0, 0, 0, 0, *SIZE, 0)
        self.x11.XFlush(self.display)

    def wait(self, seconds):
        selector = selectors.DefaultSelector()
        selector.register(self.x11.XConnectionNumber(self.display), selectors.EVENT_READ)
        if self.x11.XPending(self.display) or selector.select(seconds):
            while self.x11.XPending(self.display):
                self.read()


def be_client(kind, is_moving):
    window = {"wayland": WaylandWindow, "x11": X11Window}[kind]()
    row = 4 * SIZE[0]
    pictures = [bytes([grey]) * BYTES_A_PICTURE for grey in GREYS]
    window.show(pictures[0])
    shown, frames, next_frame_s = 0, 0, time.monotonic() + FRAME_S
    while True:
        window.wait(max(0.0, next_frame_s - time.monotonic()) if is_moving else None)
        if is_moving:
            if time.monotonic() < next_frame_s:
                continue
            next_frame_s = max(next_frame_s + FRAME_S, time.monotonic())
            frames += 1
            picture = pictures[window.touches % 2]
            window.show(bytes([frames % 256]) * row + picture[row:])
        elif shown != window.touches:
            shown = window.touches
            window.show(pictures[shown % 2])


def wait_for(display, grey):
    """Until the pixel has that grey; seconds of waiting."""
    began = time.monotonic()
    while display.blue_of(*TOUCHED) != grey:
        if time.monotonic() - began > 20.0 * watched_kiosk.SLOWNESS:
            raise SystemExit(f"touch_latency: expected grey {grey:#x}, found {display.blue_of(*TOUCHED):#x}")
        time.sleep(0.0003)
    return time.monotonic() - began


class Finger:
    def __init__(self, programs):
        self.process = subprocess.Popen([programs + "/finger", os.environ["TOUCH_SCREEN"], "1280", "720"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)

    def does(self, *words):
        self.process.stdin.write((" ".join(map(str, words)) + "\n").encode())
        self.process.stdin.flush()
        self.process.stdout.readline()


def take_turn(kind, is_moving, display, finger, touches):
    """The latencies in s of that many touches to a new client."""
    with tempfile.TemporaryDirectory() as folder:
        client = subprocess.Popen([*watched_kiosk.under_cage(folder), os.path.abspath(__file__), "client", kind,
                                   *(["--moving"] if is_moving else [])], stdout=subprocess.DEVNULL, stderr=open("cage.log", "a"))
        try:
            wait_for(display, GREYS[0])
            latencies_s = []
            for number in range(-1, touches):  # the first warms up
                time.sleep(random.uniform(0.3, 0.3 + FRAME_S))
                began = time.monotonic()
                finger.does("mousemove", *TOUCHED, "mousedown 1")
                wait_for(display, GREYS[number % 2])
                latencies_s.append(time.monotonic() - began)
                finger.does("mouseup 1")
            return latencies_s[1:]
        finally:
            client.send_signal(signal.SIGTERM)
            client.wait()


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--touches", type=int, default=100, help="of each client (100)")
    words.add_argument("--moving", action="store_true", help="the clients draw 60 frames a second")
    words.add_argument("programs", nargs="+", help="the folder of `finger`")
    wish = words.parse_args()
    if wish.programs[0] == "client":
        be_client(wish.programs[1], wish.moving)
    display, finger = X11(), Finger(wish.programs[0])
    latencies_ms = {"wayland": [], "x11": []}
    for _ in range(0, wish.touches, TOUCHES_A_TURN):
        for kind, found in latencies_ms.items():
            found += [1000.0 * s for s in take_turn(kind, wish.moving, display, finger, TOUCHES_A_TURN)]
    for kind, found in latencies_ms.items():
        tenths = statistics.quantiles(found, n=10)
        print(f"{kind}: {min(found):.1f} ms at the least, {tenths[4]:.1f} in the middle, {tenths[8]:.1f} at p90")


if __name__ == "__main__":
    main()
