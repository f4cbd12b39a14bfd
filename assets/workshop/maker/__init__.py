"""The potter's workshop, built by script: shapes, paint, room, furniture, pots, wheel, tools, lights, plates.

Everything in this package is in metres and in Blender's frame: x to the right, y away from the visitor,
z up, the origin at the centre of the top of the wheel head. The game's frame (mm, +Y up, +Z towards the
visitor) appears in two places only, cameras.json and light.json; frame.py converts.
"""
