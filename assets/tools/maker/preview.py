"""A quick look at a tool, at the wall of a stand-in pot, by Cycles. Not what the engine draws; enough to see a shape."""
import math

import bpy
from mathutils import Vector

from . import glb

CLAY = (0.30, 0.23, 0.17)


def _blender(point):
    """The game's frame in mm to Blender's in metres."""
    return Vector((point[0], -point[2], point[1])) / 1000.0


def _material(name, colour, roughness, metalness=0.0):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metalness
    return material


def _thing(name, points, faces, normals, material):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata([_blender(p) for p in points], [], [tuple(int(i) for i in face) for face in faces])
    mesh.materials.append(material)
    for polygon in mesh.polygons:
        polygon.use_smooth = True
    if normals is not None:
        mesh.use_auto_smooth = True
        mesh.normals_split_custom_set_from_vertices([_blender(n).normalized() for n in normals])
    thing = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(thing)
    return thing


def picture(parts, path):
    path.parent.mkdir(parents=True, exist_ok=True)
    scene = bpy.context.scene
    for part in parts:
        colour, roughness, metalness = glb.MATERIALS[part.material]
        smear = float(part.smear.mean())
        mixed = tuple(c * (1 - smear) + k * smear for c, k in zip(colour, CLAY))
        _thing(part.material, part.points, part.faces, part.normals, _material(part.material, mixed, roughness, metalness))
    bpy.ops.mesh.primitive_cylinder_add(radius=0.07, depth=0.2, vertices=128, location=_blender((-70, 0, 0)))
    bpy.context.object.data.materials.append(_material("clay", CLAY, 0.4))
    sun = bpy.data.objects.new("sun", bpy.data.lights.new("sun", "SUN"))
    sun.data.energy, sun.data.angle = 3.0, 0.1
    sun.rotation_euler = (math.radians(52), 0, math.radians(-50))
    scene.collection.objects.link(sun)
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.45, 0.48, 0.55, 1.0)
    camera = bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.location = _blender((60, 185, 800))
    aim = _blender((60, 0, 0)) - camera.location
    camera.rotation_euler = aim.to_track_quat("-Z", "Y").to_euler()
    camera.data.angle = 0.42
    scene.camera = camera
    scene.render.engine = "CYCLES"
    scene.cycles.samples = 12
    scene.cycles.use_denoising = False
    scene.render.threads_mode, scene.render.threads = "FIXED", 1
    scene.render.resolution_x, scene.render.resolution_y = 640, 420
    scene.render.filepath = str(path)
    bpy.ops.render.render(write_still=True)
