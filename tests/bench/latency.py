#!/usr/bin/python3
"""Measures the latency from a moved pointer to a picture with the moved hand.

    tests/bench/latency.py [--moves N] [--backend gpu|cpu] [--size WxH] [--caged] [PROGRAM]

On a display of its own (Xvfb, whose memory is looked at), in the kiosk, on the screen where pots are thrown: the pointer
goes up and down beside the clay, at any moment of a frame, and the arm that follows it is waited for. Prints the least,
the middle and the 99th of a hundred in ms, and the middle in frames of 60 Hz. A real screen adds its own: the wait for
its next refresh and what its electronics take. With --caged it is measured through the compositor that a museum has, and
Xwayland.
"""

import argparse
import ctypes
import mmap
import os
import random
import tempfile
import time

import watched_kiosk

FRAME_S = 1.0 / 60.0
# In a picture of 1280x720: where a visitor starts, throws freely, and moves a hand; and the part that is
# compared, where the arm of that hand comes from: nothing else moves there.
BEGIN = (640, 360)
FREE = (174, 508)
ABOVE, BELOW = (900, 250), (900, 330)
ARM = (1000, 220, 260, 220)


class Pointer:
    """A pointer event of the display, by the XTEST extension."""

    def __init__(self, display):
        self.x11 = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x11.XOpenDisplay.restype = ctypes.c_void_p
        self.display = ctypes.c_void_p(self.x11.XOpenDisplay(display.encode()))
        self.x11.XDefaultRootWindow.restype = ctypes.c_ulong

    def fill_screen(self, width, height):
        """The only window of the display, which has no window manager."""
        root, parent, children, count = ctypes.c_ulong(), ctypes.c_ulong(), ctypes.POINTER(ctypes.c_ulong)(), ctypes.c_uint()
        self.x11.XQueryTree(self.display, ctypes.c_ulong(self.x11.XDefaultRootWindow(self.display)), ctypes.byref(root),
                            ctypes.byref(parent), ctypes.byref(children), ctypes.byref(count))
        for number in range(count.value):
            self.x11.XMoveResizeWindow(self.display, ctypes.c_ulong(children[number]), 0, 0, width, height)
        self.x11.XFlush(self.display)

    def move(self, place):
        self.test.XTestFakeMotionEvent(self.display, -1, place[0], place[1], ctypes.c_ulong(0))
        self.x11.XFlush(self.display)

    def click(self, place):
        self.move(place)
        time.sleep(0.2)
        for pressed in (1, 0):
            self.test.XTestFakeButtonEvent(self.display, 1, pressed, ctypes.c_ulong(0))
            self.x11.XFlush(self.display)
            time.sleep(0.2)


class Picture:
    """The display's picture in xwd format: a header, a colour table, rows of four bytes per pixel."""

    def __init__(self, path):
        with open(path, "r+b") as file:
            self.bytes = mmap.mmap(file.fileno(), 0, mmap.MAP_SHARED, mmap.PROT_READ)
        word = lambda index: int.from_bytes(self.bytes[4 * index:4 * index + 4], "big")
        colours, bytes_a_colour = word(19), 12
        self.first = word(0) + colours * bytes_a_colour
        self.bytes_a_row = word(12)

    def part(self, x, y, width, height):
        start = self.first + y * self.bytes_a_row + 4 * x
        # Every eighth row is enough for an arm.
        return b"".join(self.bytes[start + row * self.bytes_a_row:start + row * self.bytes_a_row + 4 * width]
                        for row in range(0, height, 8))


def scaled(places, scale):
    return tuple(int(place * scale) for place in places)


def wait_for_another(picture, part, before):
    """Seconds until the compared part differs."""
    most_s = 2.0 * watched_kiosk.SLOWNESS
    began = time.monotonic()
    while picture.part(*part) == before:
        if time.monotonic() - began > most_s:
            raise SystemExit(f"latency: expected the arm to move within {most_s} s, found it still")
    return time.monotonic() - began


def wait_for_rest(picture, part):
    before, since = picture.part(*part), time.monotonic()
    while time.monotonic() - since < 0.5:
        time.sleep(0.01)
        now = picture.part(*part)
        if now != before:
            before, since = now, time.monotonic()
    return before


def measure(pointer, picture, scale, moves):
    arm = scaled(ARM, scale)
    waits_s = []
    for number in range(-1, moves):
        before = wait_for_rest(picture, arm)
        time.sleep(random.uniform(0.0, FRAME_S))
        pointer.move(scaled((ABOVE, BELOW)[number % 2], scale))
        waits_s.append(wait_for_another(picture, arm, before))
    return sorted(waits_s[1:])  # without the first, in which the hand moves over from a touched card


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("--moves", type=int, default=100, help="of the pointer (100)")
    words.add_argument("--backend", choices=("gpu", "cpu"), default="cpu", help="who draws (cpu)")
    words.add_argument("--size", default="1280x720", help="of the picture, 16 to 9 (1280x720)")
    words.add_argument("--caged", action="store_true", help="in the compositor cage, full screen")
    words.add_argument("program", nargs="?", default="build/release/onggi")
    wish = words.parse_args()
    scale = int(wish.size.split("x")[0]) / 1280
    settled_s = 3.0 * watched_kiosk.SLOWNESS
    with (tempfile.TemporaryDirectory() as folder, watched_kiosk.display(wish.size, folder) as display,
          watched_kiosk.kiosk(os.path.abspath(wish.program), folder, display,
                              ["--size", wish.size, "--backend", wish.backend, *(["--full-screen"] if wish.caged else [])],
                              watched_kiosk.under_cage(folder) if wish.caged else ())):
        pointer, picture = Pointer(display), Picture(folder + "/Xvfb_screen0")
        if wish.caged:
            pointer.fill_screen(*map(int, wish.size.split("x")))
        for place in (BEGIN, FREE):
            time.sleep(settled_s)
            pointer.click(scaled(place, scale))
        time.sleep(settled_s)
        waits_s = measure(pointer, picture, scale, wish.moves)
    at = lambda fraction: 1000.0 * waits_s[min(int(fraction * len(waits_s)), len(waits_s) - 1)]
    print(f"{wish.backend} {wish.size}{' caged' if wish.caged else ''}: {at(0.0):.1f} ms at the least, {at(0.5):.1f} in the middle, {at(0.99):.1f} at p99; "
          f"{at(0.5) / (1000.0 * FRAME_S):.2f} frames")


if __name__ == "__main__":
    main()
