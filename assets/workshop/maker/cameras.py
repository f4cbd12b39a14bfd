"""Puts a camera of cameras.json into the scene."""
import bpy
from mathutils import Vector

from .frame import from_game_mm


def place(spec):
    """Makes this the scene's camera; returns it."""
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    lens.lens_unit = "FOV"
    lens.angle_y = spec["vertical_fov_rad"]
    lens.clip_start = 0.02
    thing = bpy.data.objects.new("camera", lens)
    bpy.context.scene.collection.objects.link(thing)
    eye, target = Vector(from_game_mm(spec["eye_mm"])), Vector(from_game_mm(spec["target_mm"]))
    thing.location = eye
    thing.rotation_euler = (target - eye).to_track_quat("-Z", "Y").to_euler()
    bpy.context.scene.camera = thing
    return thing
