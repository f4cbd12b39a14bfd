"""Between the game's frame (+Y up, +Z towards the visitor, mm) and Blender's (z up, y away, metres)."""
import random

SEED = 20240607  # one seed for the whole workshop: two builds of the same scripts are the same workshop


def from_game_mm(p):
    """A point of the game in mm -> Blender metres."""
    return (p[0] * 1e-3, -p[2] * 1e-3, p[1] * 1e-3)


def to_game(v):
    """A direction in Blender -> the same direction in the game."""
    return (v[0], v[2], -v[1])


def dice(name):
    """A generator of its own for each concept: adding a pot does not move the stains in the pan."""
    return random.Random("%d/%s" % (SEED, name))
