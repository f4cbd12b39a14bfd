"""Reads the OpenEXR files that plates.py writes: multi-layer, scan lines, uncompressed, half or float.

Layout from the public file format description of OpenEXR ("OpenEXR File Layout").
"""
import struct

import numpy as np


def _name(data, at):
    end = data.index(b"\0", at)
    return data[at:end].decode("ascii"), end + 1


def read(path):
    """{channel name: float32 array of height x width}. ValueError names the file and what is wrong."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:4] != b"\x76\x2f\x31\x01":
        raise ValueError("%s: expected an OpenEXR file" % path)
    at, channels, window = 8, [], None
    while True:
        name, at = _name(data, at)
        if not name:
            break
        _, at = _name(data, at)
        (size,) = struct.unpack_from("<i", data, at)
        at += 4
        if name == "channels":
            inner = at
            while data[inner]:
                channel, inner = _name(data, inner)
                channels.append((channel, struct.unpack_from("<i", data, inner)[0]))
                inner += 16
        elif name == "dataWindow":
            window = struct.unpack_from("<4i", data, at)
        elif name == "compression" and data[at] != 0:
            raise ValueError("%s: expected no compression, found method %d" % (path, data[at]))
        at += size
    x0, y0, x1, y1 = window
    width, height = x1 - x0 + 1, y1 - y0 + 1
    kinds = {0: np.dtype("<u4"), 1: np.dtype("<f2"), 2: np.dtype("<f4")}
    out = {channel: np.empty((height, width), np.float32) for channel, _ in channels}
    for start in struct.unpack_from("<%dQ" % height, data, at):
        row = struct.unpack_from("<i", data, start)[0] - y0
        start += 8
        for channel, kind in channels:
            out[channel][row] = np.frombuffer(data, kinds[kind], width, start)
            start += width * kinds[kind].itemsize
    return out


def stack(channels, layer, letters):
    """The channels `*.layer.R` and so on as height x width x n."""
    picked = []
    for letter in letters:
        found = [c for c in channels if c.endswith("." + layer + "." + letter)]
        if len(found) != 1:
            raise ValueError("expected one channel %s.%s, found %s" % (layer, letter, found))
        picked.append(channels[found[0]])
    return np.stack(picked, -1)
