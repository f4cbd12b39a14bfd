"""The room as a GLB, and a museum's own room from one. glTF 2.0: metres, +Y up, origin at the wheel head.

Procedural paint does not travel, so each material goes out as its plain colour, roughness and metalness; the
paper window glows. Objects of one material are joined: a room is a handful of meshes.
"""
import bpy
import numpy
from mathutils import Vector

from . import wheel


def _plain_material(name, colour, roughness, metalness):
    material = bpy.data.materials.new("plain " + name)
    material.use_nodes = True
    shader = material.node_tree.nodes["Principled BSDF"]
    shader.inputs["Base Color"].default_value = (*colour, 1.0)
    shader.inputs["Roughness"].default_value = roughness
    shader.inputs["Metallic"].default_value = metalness
    if name == "hanji":
        shader.inputs["Emission"].default_value = (1.0, 0.93, 0.80, 1.0)
        shader.inputs["Emission Strength"].default_value = 1.0
    return material


def export(paint, path):
    """Writes the scene's meshes to `path`. Build the scene with shapes.fineness below 1 first."""
    scene = bpy.context.scene
    for name, (colour, roughness, metalness) in paint.plain.items():
        things = [o for o in scene.objects if o.type == "MESH" and o.data.materials and
                  o.data.materials[0].name == name and o.visible_camera]
        if not things:
            continue
        plain = _plain_material(name, colour, roughness, metalness)
        for other in scene.objects:
            other.select_set(other in things)
        bpy.context.view_layer.objects.active = things[0]
        bpy.ops.object.join()
        joined = bpy.context.view_layer.objects.active
        joined.name = joined.data.name = name
        joined.data.materials.clear()
        joined.data.materials.append(plain)
        bpy.ops.object.transform_apply(location=True, rotation=True, scale=True)
    for thing in scene.objects:
        thing.select_set(thing.type == "MESH" and thing.name in paint.plain)
    bpy.ops.export_scene.gltf(filepath=str(path), export_format="GLB", use_selection=True, export_yup=True,
                              export_apply=True, export_texcoords=False, export_materials="EXPORT",
                              export_animations=False, export_extras=False)


def load(path):
    """Brings in somebody's room. True if it has a wheel of its own: any object whose name begins with "wheel".
    SystemExit says what is wrong with it."""
    if not hasattr(numpy, "bool"):  # Blender 3.4's importer says numpy.bool, which numpy 1.24 no longer knows
        numpy.bool = bool
    before = set(bpy.context.scene.objects)
    try:
        bpy.ops.import_scene.gltf(filepath=str(path))
    except RuntimeError as problem:
        raise SystemExit("%s: expected a glTF 2.0 room: %s" % (path, str(problem).splitlines()[0])) from None
    things = [o for o in bpy.context.scene.objects if o not in before]
    meshes = [o for o in things if o.type == "MESH"]
    if not meshes:
        raise SystemExit("%s: expected a room, found no mesh" % path)
    bpy.context.view_layer.update()
    corners = [o.matrix_world @ Vector(c) for o in meshes for c in o.bound_box]
    size = max(max(c[k] for c in corners) - min(c[k] for c in corners) for k in range(3))
    if not 1.0 < size < 100.0:
        raise SystemExit("%s: expected a room of 1 to 100 m (glTF counts in metres), found %.3g m" % (path, size))
    for thing in things:  # the light is ours, measured for the pot: lamps of the file would fall on the plate only
        if thing.type in ("LIGHT", "CAMERA"):
            bpy.data.objects.remove(thing)
    has_wheel = any(_is_wheel(o.name) or _is_wheel(o.data.name) for o in meshes)
    blocked = [o.name for o in meshes if _stands_on_wheel(o)]
    if blocked:
        print("note: %s reaches into the place of the pot" % ", ".join(blocked))
    return has_wheel


def _is_wheel(name):
    """The rule of game/wheel/room_model.cpp: the word "wheel" and what does not go on with it, no "wheelchair"."""
    rest = name[5:]
    return name[:5].lower() == "wheel" and (rest in ("", "head") or not rest[0].islower())


def _stands_on_wheel(thing):
    reach = wheel.HEAD_RADIUS * 0.9
    return any((v := thing.matrix_world @ vertex.co).z > 0.005 and v.z < 0.3 and v.x ** 2 + v.y ** 2 < reach ** 2
               for vertex in thing.data.vertices)
