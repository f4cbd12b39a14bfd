"""Depth of field after the rendering: the lens is focused on the wheel, the wall behind goes soft.

Blurring the finished plate costs no samples and leaves the wheel, on which the engine draws, perfectly sharp.
"""
import math

import numpy as np

from .denoise import _shifted

SHARP_M = 0.34       # within this of the focal distance nothing is blurred at all: wheel, pan, tools
BLUR_SHARE = 0.0068  # radius of the blur for things infinitely far away, of the picture's height


def blur(lights, depth, focus_m):
    """lights: of one camera, each height x width x 3, linear; depth in metres along the view. A gather over a disc:
    a neighbour counts if its own blur reaches here, and sharp things in front do not bleed outwards."""
    height = depth.shape[0]
    beyond = np.maximum(depth - focus_m - SHARP_M, 0.0)
    radius = BLUR_SHARE * height * beyond / np.maximum(depth - SHARP_M, 1e-3) * 2.2
    radius = np.minimum(radius, BLUR_SHARE * height).astype(np.float32)
    most = int(math.ceil(float(radius.max())))
    totals = [light.copy() for light in lights]
    weight = np.ones(depth.shape, np.float32)
    for dy in range(-most, most + 1):
        for dx in range(-most, most + 1):
            reach = math.hypot(dy, dx)
            if reach > most + 0.5 or not (dx or dy):
                continue
            theirs = np.minimum(_shifted(radius, dy, dx), np.where(_shifted(depth, dy, dx) > depth + 0.02, radius, 1e9))
            w = np.clip(theirs - reach + 0.5, 0.0, 1.0)
            for total, light in zip(totals, lights):
                total += w[..., None] * _shifted(light, dy, dx)
            weight += w
    return [total / weight[..., None] for total in totals]
