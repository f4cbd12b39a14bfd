"""Measures the light that reaches a pot: a white ball baked over the wheel, and a small panorama from there.

Everything is in the game's frame and already times the plates' exposure, so that the engine's tone curve
(shaders/tone.glsl) takes it as it is. What light.json says is written in README.md.
"""
import json
import math
import pathlib

import bmesh
import bpy
import numpy as np

from . import cameras_file, exr, lights, plates, tone
from .frame import to_game

AT = (0.0, 0.0, 0.10)  # where the belly of a pot is
BALL_M = 0.02
GLINT = 0.4


def _bake(ball, samples, direct_only):
    bpy.context.scene.cycles.samples = samples
    kinds = {"DIRECT"} if direct_only else {"DIRECT", "INDIRECT"}
    bpy.ops.object.bake(type="DIFFUSE", pass_filter=kinds, target="VERTEX_COLORS")
    values = np.zeros(len(ball.data.vertices) * 4, np.float32)
    ball.data.color_attributes["light"].data.foreach_get("color", values)
    return values.reshape(-1, 4)[:, :3].astype(np.float64) * tone.EXPOSURE


def _ball():
    builder = bmesh.new()
    bmesh.ops.create_icosphere(builder, subdivisions=4, radius=BALL_M)
    mesh = bpy.data.meshes.new("probe")
    builder.to_mesh(mesh)
    builder.free()
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    white = bpy.data.materials.new("probe")
    white.use_nodes = True
    mesh.materials.append(white)
    mesh.color_attributes.new("light", "FLOAT_COLOR", "POINT")
    ball = bpy.data.objects.new("probe", mesh)
    bpy.context.scene.collection.objects.link(ball)
    ball.location = AT
    for other in bpy.context.scene.objects:
        other.select_set(False)
    ball.select_set(True)
    bpy.context.view_layer.objects.active = ball
    normals = np.array([to_game(v.co.normalized()) for v in mesh.vertices])
    return ball, normals


def basis(n):
    """The terms of shaders/sky.glsl: c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3zz-1) + c7 xz + c8 (xx-yy)."""
    x, y, z = n[:, 0], n[:, 1], n[:, 2]
    return np.stack([np.ones_like(x), y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y], 1)


def _key(normals, direct):
    """Direction and colour of one far light, from what it alone does to the ball: white = radiance (n.l)+."""
    bright = direct.sum(1)
    lit = bright > 0.25 * bright.max()
    vector, *_ = np.linalg.lstsq(normals[lit], bright[lit], rcond=None)
    towards = vector / np.linalg.norm(vector)
    cosine = np.maximum(normals @ towards, 0.0)
    colour = (direct * cosine[:, None]).sum(0) / (cosine ** 2).sum()
    error = np.sqrt(np.mean((direct - cosine[:, None] * colour) ** 2))
    return towards, colour, error


def _panorama(paint, work, threads):
    """Radiance from everywhere but the key: (directions in the game's frame, solid angles, radiance)."""
    scene = bpy.context.scene
    lens = bpy.data.cameras.new("panorama")
    lens.type = "PANO"
    lens.cycles.panorama_type = "EQUIRECTANGULAR"
    lens.clip_start = 0.001
    eye = bpy.data.objects.new("panorama", lens)
    scene.collection.objects.link(eye)
    eye.location = AT
    eye.rotation_euler = (math.pi / 2, 0, 0)  # looks along +y, away from the visitor
    scene.camera = eye
    lamps = [o for o in scene.objects if o.type == "LIGHT" and o.data.type == "AREA" and o.lightgroup == "rest"]
    for lamp in lamps:
        lamp.visible_camera = True
    lights.set_window(paint, lights.WINDOW_GIVEN, lights.WINDOW_GIVEN)
    path = pathlib.Path(work) / "panorama.0.exr"
    path.unlink(missing_ok=True)
    plates.set_up(64, threads, (160, 80))
    plates.render("panorama", work, 1)
    channels = exr.read(path)
    light = (exr.stack(channels, "Combined_rest", "RGB") + exr.stack(channels, "Combined_key", "RGB")) * tone.EXPOSURE
    height, width = light.shape[:2]
    down = (np.arange(height) + 0.5) / height * math.pi
    round_ = ((np.arange(width) + 0.5) / width - 0.5) * 2 * math.pi  # 0 looks along +y, growing to the right
    down, round_ = np.meshgrid(down, round_, indexing="ij")
    directions = np.stack([np.sin(down) * np.sin(round_), np.cos(down), -np.sin(down) * np.cos(round_)], -1)
    solid = np.sin(down) * (math.pi / height) * (2 * math.pi / width)
    # The bare wheel head mirrors the key light as a glint; with a pot on it nobody sees that.
    light = np.where(directions[..., 1:2] < 0, np.minimum(light, GLINT), light)
    return directions.reshape(-1, 3), solid.reshape(-1), light.reshape(-1, 3)


def _sky_columns(directions, panels):
    """What each unknown of render::Environment adds in each direction: zenith, horizon, nadir, panels."""
    height = np.clip(np.abs(directions[:, 1]), 0, 1)
    share = height * height * (3 - 2 * height)
    up = directions[:, 1] > 0
    columns = [np.where(up, share, 0.0), 1 - share, np.where(up, 0.0, share)]
    for towards, sharpness in panels:
        columns.append(np.exp(sharpness * (directions @ towards - 1)))
    return np.stack(columns, 1)


def _non_negative(columns, values, weights):
    """Least squares with no negative light: columns that come out negative are dropped, the worst first."""
    use = list(range(columns.shape[1]))
    w = np.sqrt(weights)[:, None]
    answer = np.zeros((columns.shape[1], 3))
    for channel in range(3):
        active = list(use)
        while active:
            found, *_ = np.linalg.lstsq(columns[:, active] * w, values[:, channel] * w[:, 0], rcond=None)
            if found.min() >= 0:
                answer[active, channel] = found
                break
            active.pop(int(np.argmin(found)))
    return answer


def fit_sky(directions, solid, light):
    """Gradient and three soft panels: each panel is put where the most light is left over, then all are moved
    and resized together while that helps."""
    light = np.minimum(light, 12.0)
    panels = []

    def cost(trial):
        columns = _sky_columns(directions, trial)
        answer = _non_negative(columns, light, solid)
        return float(((columns @ answer - light) ** 2 * solid[:, None]).sum()), answer

    for _ in range(3):
        _, answer = cost(panels)
        left = (light - _sky_columns(directions, panels) @ answer).sum(1)
        best = None
        for sharpness in (4.0, 12.0, 40.0):
            for k in range(0, len(directions), 97):
                lobe = np.exp(sharpness * (directions @ directions[k] - 1))
                gain = float((lobe * left * solid).sum() * math.sqrt(sharpness))
                if best is None or gain > best[0]:
                    best = (gain, directions[k], sharpness)
        panels.append((best[1], best[2]))
    value, answer = cost(panels)
    for step in (0.3, 0.15, 0.07, 0.03):
        for _ in range(3):
            for k in range(3):
                towards, sharpness = panels[k]
                side = np.cross(towards, (0.0, 1.0, 0.01))
                side /= np.linalg.norm(side)
                over = np.cross(side, towards)
                still = np.zeros(3)
                for move, factor in ((side, 1), (-side, 1), (over, 1), (-over, 1), (still, 1 + step), (still, 1 / (1 + step))):
                    moved = towards + step * move
                    trial = list(panels)
                    trial[k] = (moved / np.linalg.norm(moved), min(max(sharpness * factor, 1.0), 200.0))
                    better, found = cost(trial)
                    if better < value:
                        value, answer, panels = better, found, trial
                        towards, sharpness = trial[k]
    return panels, answer


def measure(paint, key_lamp, work, out, threads):
    """Writes `out` (light.json); `key_lamp` is the key light's object."""
    directions, solid, light = _panorama(paint, work, threads)
    panels, sky = fit_sky(directions, solid, light)

    plates.set_up(256, threads, (16, 16))
    ball, normals = _ball()
    everything = _bake(ball, 512, direct_only=False)
    lamps = [o for o in bpy.context.scene.objects if o.type == "LIGHT" and o is not key_lamp]
    for lamp in lamps:
        lamp.hide_render = True
    lights.set_window(paint, 0.0, 0.0)
    for material in bpy.data.materials:  # whatever glows in a museum's own room
        glow = material.node_tree and material.node_tree.nodes.get("Principled BSDF")
        if glow:
            glow.inputs["Emission Strength"].default_value = 0.0
    background = bpy.context.scene.world.node_tree.nodes["Background"].inputs[1]
    background.default_value = 0.0
    direct = _bake(ball, 256, direct_only=True)
    bpy.data.objects.remove(ball)

    key_towards, colour, key_error = _key(normals, direct)
    ambient = np.maximum(everything - direct, 0.0)
    terms = basis(normals)
    harmonics, *_ = np.linalg.lstsq(terms, ambient, rcond=None)
    harmonic_error = float(np.sqrt(np.mean((terms @ harmonics - ambient) ** 2)))
    key_at = np.array(key_lamp.matrix_world.translation) - np.array(AT)
    angular = math.atan(0.5 * key_lamp.data.size * 2 / math.sqrt(math.pi) / float(np.linalg.norm(key_at)))

    def tidy(values):
        return [round(float(v), 5) for v in values]

    result = {
        "units": "linear light times the plates' exposure of %.2f; directions are unit vectors in the game's frame "
                 "(+y up, +z to the visitor); angles rad" % tone.EXPOSURE,
        "measured_at_mm": [AT[0] * 1000, AT[2] * 1000, -AT[1] * 1000],
        "key": {"towards_light": tidy(key_towards), "radiance": tidy(colour), "angular_radius_rad": round(angular, 4),
                "rms_error": round(float(key_error), 5)},
        "irradiance_over_pi": {"basis": "c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3zz-1) + c7 xz + c8 (xx-yy)",
                               "coefficients": [tidy(row) for row in harmonics],
                               "mean": round(float(ambient.mean()), 5), "rms_error": round(harmonic_error, 5)},
        "environment": {"zenith": tidy(sky[0]), "horizon": tidy(sky[1]), "nadir": tidy(sky[2]),
                        "panels": [{"direction": tidy(towards), "sharpness": round(float(sharpness), 3),
                                    "radiance": tidy(radiance)}
                                   for (towards, sharpness), radiance in zip(panels, sky[3:])]},
        "plates": {"exposure": tone.EXPOSURE, "tone": "c / (0.8 c + 0.35)", "transfer": "sRGB (IEC 61966-2-1)",
                   "cameras": sorted(cameras_file.load())},
    }
    pathlib.Path(out).write_text(json.dumps(result, indent=2) + "\n")
    print("light: key", tidy(key_towards), tidy(colour), "ambient mean", result["irradiance_over_pi"]["mean"],
          "rms", harmonic_error, flush=True)
