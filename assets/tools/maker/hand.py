"""A pair of calm hands, covered in slip, in rolled linen sleeves: sculpted, not copied from life. A hand is built
lying on its palm, wrist at the origin, fingers to -X, thumb to +Z (a right hand), bones first; then it is turned
into the pose in which it touches the clay."""
import numpy as np

from . import skin, solid
from .solid import bone, rotation, soft_union, vector

# A finger: knuckle, lengths of its three bones, radii at its four joints, and how far it lies apart, degrees.
FINGERS = {
    "index": ((-88, 5, 24), (44, 26, 19), (10.8, 9.5, 8.5, 7.5), -1.0),
    "middle": ((-92, 7, 4), (47, 30, 20), (11.0, 9.7, 8.7, 7.7), 0.5),
    "ring": ((-88, 5, -16), (43, 28, 20), (10.4, 9.2, 8.2, 7.3), 2.0),
    "little": ((-79, 0, -34), (34, 21, 18), (9.4, 8.2, 7.3, 6.5), 4.5),
}
SLEEVE_FROM = 92.0  # mm from the wrist
ARM_LENGTH = 330.0


def _finger(name, bends):
    """bends: at its three joints, degrees towards the palm. Returns its joints."""
    knuckle, lengths, _, apart = FINGERS[name]
    joints = [vector(*knuckle)]
    turn = rotation((0, 1, 0), apart)
    bend = 0.0
    for length, more in zip(lengths, bends):
        bend += more
        joints.append(joints[-1] + turn @ rotation((0, 0, 1), bend) @ vector(-length, 0, 0))
    return joints


def _sleeve(arm):
    """Rolled up to below the elbow, with the creases that rolling leaves."""
    def radius_mm(x):
        roll = 5.0 * np.exp(-((x - SLEEVE_FROM - 7.0) / 7.0) ** 2) + 3.0 * np.exp(-((x - SLEEVE_FROM - 21.0) / 6.5) ** 2)
        return 5.5 + roll

    def distance(points):
        x, angle = points[:, 0], np.arctan2(points[:, 1], points[:, 2])
        crease = 1.6 * np.sin(x / 9.0 + 1.7 * np.sin(angle) + 0.8 * np.cos(2 * angle)) * np.clip(
            (x - SLEEVE_FROM - 26.0) / 40.0, 0.0, 1.0)
        return np.maximum(arm(points) - radius_mm(x) - crease, SLEEVE_FROM - x)

    return distance


def build(pose):
    """pose: dict of bends a finger, thumb joints, place (3 x 3 and an offset made from the finger tips), mirrored.
    Returns parts."""
    fingers = {name: _finger(name, bends) for name, bends in pose["fingers"].items()}
    flesh = [solid.chain(joints, FINGERS[name][2]) for name, joints in fingers.items()]
    thumb = [vector(*joint) for joint in pose["thumb"]]
    flesh.append(solid.chain(thumb, (14.5, 12.0, 10.2, 8.4)))
    # The middle joints show on the back of a bent finger.
    flesh[:4] = [soft_union([chain, solid.ball(joints[1] + (joints[1] - joints[2]) * 0.02 + vector(0, 2.2, 0), 8.6)], 4.0)
                 for chain, joints in zip(flesh[:4], fingers.values())]
    # Fingers keep a crease between them; the palm takes them up softly.
    digits = soft_union(flesh[:4], 1.6)
    palm = [bone((-8, 0, 10), joints[0], 17.0, 12.0) for joints in fingers.values()]
    palm += [bone((-14, -7, 14), thumb[1], 16.0, 13.0),            # the ball of the thumb
             bone((-12, -8, -16), (-66, -7, -31), 15.0, 11.5),     # and the heel of the hand
             bone(thumb[1] + vector(4, 4, -6), fingers["index"][0] + vector(22, -4, -2), 9.0, 9.0)]  # skin between
    arm = soft_union([bone((-6, 0, 10), (130, 2, 13), 18.5, 27.0), bone((-6, 0, -9), (130, 2, -9), 17.5, 27.0),
                      bone((110, 2, 2), (ARM_LENGTH, 4, 2), 33.0, 43.0)], 16.0)
    hand = soft_union([soft_union(palm, 15.0), arm], 20.0)
    hand = soft_union([hand, digits], 9.0)
    hand = soft_union([hand, flesh[4]], 8.0)
    sleeve = _sleeve(arm)
    bare = solid.without(hand, solid.half_space((-1, 0, 0), -(SLEEVE_FROM + 9.0)), 1.0)  # hidden below the sleeve
    whole = solid.soft_union([hand, sleeve], 0.5)

    tips = np.array([fingers[name][-1] for name in ("index", "middle")])

    def smear(points):
        """Slip up to the wrist, thin and in streaks over the back of the hand."""
        streaks = 0.5 + 0.5 * np.sin(points[:, 1] * 0.31 + 2.0 * np.sin(points[:, 0] * 0.045) + points[:, 2] * 0.17)
        return np.clip(0.96 - 0.007 * np.maximum(points[:, 0] + 60.0, 0.0) - 0.28 * streaks * (points[:, 0] > -999.0)
                       + 0.25 * (points[:, 0] < -85.0), 0.0, 1.0)

    def tone(points):
        return 0.5 + 0.06 * np.sin(points[:, 0] * 0.09 + points[:, 2] * 0.13)

    low, high = vector(-200, -110, -75), vector(ARM_LENGTH + 50, 60, 85)
    parts = [skin.part("skin", bare, low, vector(SLEEVE_FROM + 30, 60, 85), 1.9, pose["triangles"], smear, tone, whole),
             skin.part("linen", sleeve, vector(SLEEVE_FROM - 6, -70, -70), high, 3.4, 400,
                       lambda p: 0.35 * np.clip(1.0 - (p[:, 0] - SLEEVE_FROM) / 40.0, 0.0, 1.0), tone, whole)]
    for part in parts:
        _place(part, pose, tips)
    return parts


def _place(part, pose, tips):
    turn = pose["turn"]
    touch = (tips @ turn.T).mean(axis=0) + np.asarray(pose["pad"], float)
    part.points = part.points @ turn.T - touch
    part.normals = part.normals @ turn.T
    if pose.get("mirrored"):
        part.points[:, 2] *= -1.0
        part.normals[:, 2] *= -1.0
        part.faces = part.faces[:, ::-1]


# Outside: finger tips against the wall, the hand beyond the outline so that it hides nothing, the forearm coming
# from the visitor's right.
OUTER = {
    "fingers": {"index": (12, 24, 12), "middle": (15, 25, 12), "ring": (18, 26, 13), "little": (21, 27, 13)},
    "thumb": [(-22, -9, 22), (-55, -20, 42), (-86, -24, 40), (-108, -24, 32)],
    "turn": rotation((0, 1, 0), -24) @ rotation((0, 0, 1), 8) @ rotation((1, 0, 0), -34),
    "pad": (-7.0, -1.5, 0.0),
    "triangles": 1700,
}
# Inside: fingers pointing down into the pot, their pads towards the wall (-X is the clay here too), the forearm
# leaving through the mouth towards the visitor's left.
INNER = {
    "fingers": {"index": (6, 12, 8), "middle": (8, 13, 8), "ring": (9, 14, 9), "little": (11, 16, 10)},
    "thumb": [(-22, -9, 22), (-50, -14, 42), (-82, -12, 48), (-104, -6, 46)],
    "turn": rotation((0, 0, 1), 78) @ rotation((1, 0, 0), 180),
    "pad": (-10.5, 0.0, 0.0),
    "triangles": 1500,
}
