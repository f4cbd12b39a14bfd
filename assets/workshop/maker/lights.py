"""The light: a warm key from the visitor's left, the paper window as fill, a faint room around.

The key is in the light group "key", everything else in "rest": one rendering gives both plates, the key-lit
(key + rest) and the ambient (rest).
"""
import bpy
from mathutils import Quaternion, Vector

from . import shapes

KEY = {"at": (-0.92, -0.58, 0.80), "towards": (-0.02, -0.03, 0.05), "size": 0.30, "power_w": 9.0,
       "colour": (1.0, 0.79, 0.56), "spread": 1.25}  # rad; a narrow light, so that the wall keeps its own
FILL = {"at": (1.25, -1.5, 1.1), "towards": (0.0, 0.2, 0.0), "size": 1.2, "power_w": 7.5, "colour": (0.84, 0.90, 1.0)}
# Low sun through a lattice behind the visitor. It passes over the wheel and only ever reaches the wall, so it
# belongs to both plates and throws no shadow of the pot.
BEAM = {"at": (-0.62, -1.90, 1.62), "towards": (0.40, 0.95, 0.13), "power_w": 600.0, "colour": (1.0, 0.72, 0.44)}
WINDOW_SEEN = 0.80
WINDOW_GIVEN = 3.4
ROOM = {"colour": (0.60, 0.63, 0.70), "strength": 0.10}


def _group(thing, name):
    groups = bpy.context.view_layer.lightgroups
    if name not in {g.name for g in groups}:
        groups.add(name=name)
    thing.lightgroup = name


def _area(name, spec, group):
    lamp = bpy.data.lights.new(name, "AREA")
    lamp.shape = "SQUARE"
    lamp.size = spec["size"]
    lamp.energy = spec["power_w"]
    lamp.color = spec["colour"]
    lamp.spread = spec.get("spread", 3.14159)
    thing = bpy.data.objects.new(name, lamp)
    bpy.context.scene.collection.objects.link(thing)
    thing.location = spec["at"]
    thing.rotation_euler = (Vector(spec["towards"]) - Vector(spec["at"])).to_track_quat("-Z", "Y").to_euler()
    thing.visible_camera = False
    _group(thing, group)
    return thing


def _beam(paint):
    lamp = bpy.data.lights.new("sun beam", "SPOT")
    lamp.energy = BEAM["power_w"]
    lamp.color = BEAM["colour"]
    lamp.shadow_soft_size = 0.006
    lamp.spot_size = 0.42
    lamp.spot_blend = 0.15
    thing = bpy.data.objects.new("sun beam", lamp)
    bpy.context.scene.collection.objects.link(thing)
    at, towards = Vector(BEAM["at"]), Vector(BEAM["towards"])
    look = (towards - at).to_track_quat("-Z", "Y")
    thing.location = at
    thing.rotation_euler = look.to_euler()
    _group(thing, "rest")
    # The lattice: a card with an opening of 150 x 130 mm and bars in it, 0.75 m in front of the lamp.
    centre = at + (towards - at).normalized() * 0.75
    tilt = (look @ Quaternion((0, 0, 1), 0.16)).to_euler()

    def bar(wide, high, x, y):
        card = shapes.box("lattice card", (wide, high, 0.002), paint["iron"], (0, 0, 0), bevel=0)
        card.rotation_euler = tilt
        card.location = centre + tilt.to_matrix() @ Vector((x, y, 0))
        card.visible_camera = card.visible_glossy = card.visible_diffuse = False

    for side in (-1, 1):
        bar(0.12, 0.40, side * 0.135, 0)
        bar(0.40, 0.12, 0, side * 0.125)
    for k in (-1, 0, 1):
        bar(0.006, 0.14, k * 0.0375, 0)
    for k in (-0.5, 0.5):
        bar(0.16, 0.006, 0, k * 0.044)


def set_window(paint, seen, given):
    """How bright the paper of the window is to the camera, and as a light."""
    nodes = paint["hanji"].node_tree.nodes
    nodes["seen"].outputs[0].default_value = seen
    nodes["given"].outputs[0].default_value = given


def build(paint):
    """Lights the scene; returns the key light's object."""
    key = _area("key", KEY, "key")
    _area("fill", FILL, "rest")
    _beam(paint)
    world = bpy.data.worlds.new("room")
    bpy.context.scene.world = world
    world.use_nodes = True
    background = world.node_tree.nodes["Background"]
    background.inputs[0].default_value = (*ROOM["colour"], 1.0)
    background.inputs[1].default_value = ROOM["strength"]
    _group(world, "rest")
    set_window(paint, WINDOW_SEEN, WINDOW_GIVEN)
    for thing in bpy.context.scene.objects:
        if thing.type == "MESH":
            _group(thing, "rest")
    return key
