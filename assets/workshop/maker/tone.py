"""Light to eight bits, the same curve as shaders/curve.h (a test compares), and the files.

  c = 0.75 E          exposure, the same for both plates of a camera and for light.json
  c = c / (0.8 c + 0.35)
  v = sRGB(c)         the exact transfer function of IEC 61966-2-1
"""
import numpy as np
from PIL import Image

EXPOSURE = 0.75


def curve(light):
    c = np.maximum(light, 0.0) * EXPOSURE
    c = np.minimum(c / (c * 0.8 + 0.35), 1.0)
    return np.where(c <= 0.0031308, c * 12.92, 1.055 * np.power(np.maximum(c, 1e-8), 1 / 2.4) - 0.055)


def to_bytes(light, seed=1):
    """Dithered by one step of triangular noise, the same on all three channels: walls do not band."""
    rng = np.random.default_rng(seed)
    shape = light.shape[:2] + (1,)
    dither = rng.random(shape) + rng.random(shape) - 1.0
    return np.clip(curve(light) * 255.0 + 0.6 * dither + 0.5, 0, 255).astype(np.uint8)


def write(path, light, quality=95):
    image = Image.fromarray(to_bytes(light))
    if str(path).endswith(".jpg"):
        image.save(path, quality=quality, subsampling=0, optimize=True)
    else:
        image.save(path, optimize=True)
