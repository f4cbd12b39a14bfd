"""blender --background --factory-startup --python blender_picture.py -- POT.glb PICTURE.png SIDE_PX

Draws a pot with Cycles: one soft window to the left, a grey room, the pot filling the picture. For clients_sheet.mjs.
"""
import math
import sys

import bpy
import numpy
from mathutils import Vector

# findings/blender-of-debian-12-refuses-every-glb-unless-told-how-to-shade.sh; with NumPy's name the normals are read.
numpy.bool = bool

pot, picture, side_px = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=pot)
corners = [part.matrix_world @ Vector(corner) for part in bpy.data.objects if part.type == "MESH" for corner in part.bound_box]
low = Vector(min(corner[axis] for corner in corners) for axis in range(3))
high = Vector(max(corner[axis] for corner in corners) for axis in range(3))
centre, size = (low + high) / 2, (high - low).length

scene = bpy.context.scene
scene.render.engine = "CYCLES"
scene.cycles.device = "CPU"
scene.cycles.samples = 96
scene.cycles.use_denoising = False  # Debian builds it without the denoiser
scene.render.resolution_x = scene.render.resolution_y = int(side_px)
scene.render.filepath = picture
scene.view_settings.view_transform = "Standard"
scene.world = bpy.data.worlds.new("room")
scene.world.use_nodes = True
scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.20, 0.22, 0.25, 1.0)

eye = bpy.data.objects.new("eye", bpy.data.cameras.new("eye"))
eye.data.angle = math.radians(30.0)
eye.location = centre + Vector((0.0, -1.0, 0.3)).normalized() * size * 2.0
eye.rotation_euler = (centre - eye.location).to_track_quat("-Z", "Y").to_euler()
window = bpy.data.objects.new("window", bpy.data.lights.new("window", "AREA"))
window.data.size = 1.5 * size
window.data.energy = 60.0 * size * size
window.location = centre + Vector((-1.6, -1.2, 1.6)) * size
window.rotation_euler = (centre - window.location).to_track_quat("-Z", "Y").to_euler()
for part in (eye, window):
    scene.collection.objects.link(part)
scene.camera = eye
bpy.ops.render.render(write_still=True)
