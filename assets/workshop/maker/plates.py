"""Renders a camera's plate with Cycles, in several passes with seeds of their own, as OpenEXR files.

Passes instead of one long rendering: how much they differ tells the denoiser how noisy each pixel is, and a
rendering that was stopped goes on where it was.
"""
import pathlib
import time

import bpy


def set_up(samples, threads, size, scale=1.0):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples = samples
    cycles.use_adaptive_sampling = False  # equal samples everywhere: the passes' spread is then the noise
    cycles.use_denoising = False
    cycles.max_bounces = 6
    cycles.diffuse_bounces = 4
    cycles.glossy_bounces = 3
    cycles.caustics_reflective = False
    cycles.caustics_refractive = False
    cycles.sample_clamp_indirect = 3.0
    cycles.blur_glossy = 0.6
    scene.render.use_persistent_data = True
    scene.render.threads_mode = "FIXED"
    scene.render.threads = threads
    scene.render.resolution_x = int(size[0] * scale)
    scene.render.resolution_y = int(size[1] * scale)
    scene.render.resolution_percentage = 100
    scene.view_settings.view_transform = "Standard"
    layer = bpy.context.view_layer
    layer.use_pass_z = True
    layer.cycles.denoising_store_passes = True
    image = scene.render.image_settings
    image.file_format = "OPEN_EXR_MULTILAYER"
    image.color_depth = "16"
    image.exr_codec = "NONE"


def render(name, folder, passes):
    """Writes folder/name.K.exr for each pass K that is not there yet; returns the paths."""
    scene = bpy.context.scene
    written = []
    for k in range(passes):
        path = pathlib.Path(folder) / ("%s.%d.exr" % (name, k))
        written.append(path)
        if path.exists():
            continue
        partial = path.with_suffix(".part.exr")
        scene.cycles.seed = 101 + k
        scene.render.filepath = str(partial)
        began = time.time()
        bpy.ops.render.render(write_still=True)
        partial.rename(path)
        print("plate %s pass %d of %d: %.0f s" % (name, k + 1, passes, time.time() - began), flush=True)
    return written
