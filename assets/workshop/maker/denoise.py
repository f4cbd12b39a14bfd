"""Takes the grain out of a plate: an edge-stopping a-trous wavelet filter on light without colour.

After H. Dammertz et al., "Edge-Avoiding A-Trous Wavelet Transform for fast Global Illumination Filtering",
2010, with the noise measured as in C. Schied et al., "Spatiotemporal Variance-Guided Filtering", 2017: here
from the spread of independent passes. Light is divided by the surface's colour first, so textures stay sharp.
Arrays are height x width x 3, float32, linear.
"""
import numpy as np

KERNEL = np.array([1, 4, 6, 4, 1], np.float32) / 16.0


def _shifted(image, dy, dx):
    """image moved by (dy, dx), its border repeated."""
    height, width = image.shape[:2]
    rows = np.clip(np.arange(height) + dy, 0, height - 1)
    columns = np.clip(np.arange(width) + dx, 0, width - 1)
    return image[rows][:, columns]


def _blur3(image):
    taps = ((-1, 0.25), (0, 0.5), (1, 0.25))
    image = sum(w * _shifted(image, d, 0) for d, w in taps)
    return sum(w * _shifted(image, 0, d) for d, w in taps)


def luminance(light):
    return light @ np.array([0.2126, 0.7152, 0.0722], np.float32)


def unit(normals):
    """Pixels that mix two surfaces have short normals: full length again, or they would stop every edge."""
    return normals / np.maximum(np.linalg.norm(normals, axis=-1, keepdims=True), 1e-4)


def _without_fireflies(passes):
    """Caps a pixel of one pass at a few times what its neighbourhood in all passes has on the average. (Not
    the median: in the outer penumbra most pixels see nothing of a light, and the few that do are right.)"""
    around = luminance(passes.mean(0))
    for axis in (0, 1):
        around = sum(_shifted(around, d * (axis == 0), d * (axis == 1)) for d in range(-3, 4)) / 7.0
    limit = around * 6.0 + 0.01
    scale = np.minimum(1.0, limit[None] / np.maximum(luminance(passes), 1e-6))
    return passes * scale[..., None]


def _without_specks(light):
    """A pixel that mixes two surfaces resembles none of its neighbours and keeps its noise: bring it back
    between the second darkest and the second brightest of them. Lines and edges have two, so they stay."""
    around = np.sort(np.stack([_shifted(light, dy, dx) for dy in (-1, 0, 1) for dx in (-1, 0, 1) if dy or dx]), 0)
    return np.clip(light, around[1], around[-2])


def denoise(passes, albedo, normal, depth, levels=5, strength=3.0):
    """passes: n x height x width x 3 renderings with independent noise. Returns their cleaned mean."""
    count = len(passes)
    normal = unit(normal)
    base = np.maximum(albedo, 0.03)
    light = _without_fireflies(passes.astype(np.float32)) / base[None]
    mean = light.mean(0)
    # Variance of the mean's brightness; few passes tell it roughly, so neighbours are asked too.
    variance = luminance(light).var(0, ddof=1) / count if count > 1 else (0.25 * luminance(mean)) ** 2
    for _ in range(4):
        variance = _blur3(variance)

    slope = np.max([np.abs(_shifted(depth, dy, dx) - depth) for dy, dx in ((0, 1), (0, -1), (1, 0), (-1, 0))], 0)
    slope = np.minimum(slope, 0.02 * depth)
    for level in range(levels):
        step = 1 << level
        bright = luminance(mean)
        if level < 2:
            bright = _blur3(bright)  # still too noisy to tell an edge of light by
        spread = strength * np.sqrt(_blur3(variance)) + 1e-3 + 0.004 * bright
        total = np.zeros_like(mean)
        total_variance = np.zeros_like(variance)
        weight = np.zeros_like(variance)
        for i, ky in enumerate(KERNEL):
            for j, kx in enumerate(KERNEL):
                dy, dx = (i - 2) * step, (j - 2) * step
                w = np.full_like(variance, ky * kx)
                if dy or dx:
                    facing = np.clip((_shifted(normal, dy, dx) * normal).sum(-1), 0, 1)
                    reach = slope * np.hypot(dy, dx) * 1.5 + 0.0025 * depth
                    colour = np.abs(_shifted(albedo, dy, dx) - albedo).sum(-1)
                    w *= facing ** 48 * np.exp(-np.abs(_shifted(depth, dy, dx) - depth) / reach -
                                               np.abs(_shifted(bright, dy, dx) - bright) / spread - 2.0 * colour)
                total += w[..., None] * _shifted(mean, dy, dx)
                total_variance += w * w * _shifted(variance, dy, dx)
                weight += w
        mean = total / weight[..., None]
        variance = total_variance / weight ** 2
    return _without_specks(mean * base)
