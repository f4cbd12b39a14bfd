"""Light to eight bits, the same curve as shaders/curve.h (a test compares), and the files.

  c = 0.75 E          exposure, the same for both plates of a camera and for light.json
  c = c / (0.8 c + 0.35)
  v = sRGB(c)         the exact transfer function of IEC 61966-2-1
"""
import numpy as np
from PIL import Image

EXPOSURE = 0.75


def transfer(c):
    return np.where(c <= 0.0031308, c * 12.92, 1.055 * np.power(np.maximum(c, 1e-8), 1 / 2.4) - 0.055)


def curve(light):
    c = np.maximum(light, 0.0) * EXPOSURE
    return transfer(np.minimum(c / (c * 0.8 + 0.35), 1.0))


def from_bytes(values):
    """The inverse of transfer(): what a screen shows of a plate, linear."""
    v = values.astype(np.float32) / 255.0
    return np.where(v <= 0.04045, v / 12.92, np.power((v + 0.055) / 1.055, 2.4)).astype(np.float32)


def dithered(values, seed=1):
    """Bytes, dithered by one step of triangular noise, the same on all three channels: walls do not band."""
    rng = np.random.default_rng(seed)
    shape = values.shape[:2] + (1,)
    dither = rng.random(shape) + rng.random(shape) - 1.0
    return np.clip(values * 255.0 + 0.6 * dither + 0.5, 0, 255).astype(np.uint8)


def write(path, light):
    save(path, dithered(curve(light)))


def save(path, values, quality=95):
    image = Image.fromarray(values)
    if str(path).endswith(".jpg"):
        image.save(path, quality=quality, subsampling=0, optimize=True)
    else:
        image.save(path, optimize=True)
