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
THUMB_RADII = (14.5, 12.0, 10.2, 8.4)
# Slip thrown off the wheel onto wrist and forearm: place and size, mm.
SPLASHES = np.array([(8, 17, 14, 9), (30, 12, 24, 7), (38, 21, 2, 6), (55, 6, 30, 9), (62, 22, 10, 5), (74, 14, 26, 6),
                     (20, -4, 28, 8), (46, -8, 30, 6), (70, -2, 33, 5), (26, 18, -14, 8), (58, 18, -18, 7)], float)
SLEEVE_FROM = 92.0  # mm from the wrist
ARM_LENGTH = 330.0


class Digit:
    """A finger or a thumb: its joints, radii, and the direction of its back at each bone (unit vectors)."""

    def __init__(self, joints, radii, backs):
        self.joints, self.radii, self.backs = joints, radii, backs

    def flesh(self):
        """Bones, slimmer between the joints than at them, with a pad below the tip."""
        links = []
        for i in range(len(self.joints) - 1):
            a, b, back = self.joints[i], self.joints[i + 1], self.backs[i]
            waist = 0.5 * (a + b) - 0.4 * back
            slim = 0.5 * (self.radii[i] + self.radii[i + 1]) - 0.55
            links += [bone(a, waist, self.radii[i], slim), bone(waist, b, slim, self.radii[i + 1])]
        tip, back, radius = self.joints[-1], self.backs[-1], self.radii[-1]
        along = _unit(self.joints[-1] - self.joints[-2])
        links.append(solid.ball(tip - 4.0 * along - 1.6 * back, radius * 0.96))
        middle = self.joints[1] + 1.8 * self.backs[0]  # this joint shows on the back of a bent finger
        links.append(solid.ball(middle, self.radii[1] - 0.7))
        return soft_union(links, 2.5)

    def frame(self, bone_index, origin):
        """Turns points into this bone's (along, across, up its back), mm from the origin."""
        along = _unit(self.joints[bone_index + 1] - self.joints[bone_index])
        back = _unit(self.backs[bone_index] - (self.backs[bone_index] @ along) * along)
        across = np.cross(along, back)
        return lambda points: (points - origin) @ np.stack([along, across, back], axis=1)

    def nail(self):
        """Returns a function of points: how much nail (0 to 1), and how much of the groove round it."""
        radius = self.radii[-1]
        local = self.frame(len(self.joints) - 2, self.joints[-1] - 2.2 * _unit(self.joints[-1] - self.joints[-2]))
        half_length, half_width = 0.86 * radius, 0.74 * radius

        def cover(points):
            along, across, up = local(points).T
            oval = (np.abs(along / half_length) ** 3 + np.abs(across / half_width) ** 3) ** (1.0 / 3.0)
            is_back = np.clip(up / (0.3 * radius), 0.0, 1.0)
            plate = np.clip((1.0 - oval) / 0.12, 0.0, 1.0) * is_back
            # No groove at the free edge, where the plate stands over the tip.
            groove = np.exp(-((oval - 1.08) / 0.13) ** 2) * is_back * np.clip(1.0 - along / half_length, 0.0, 1.0)
            return plate, groove

        return cover

    def folds(self):
        """Returns a function of points: skin folds, 0 to 1, on the back of each joint and across its inside."""
        joints = [(self.frame(i, self.joints[i + 1]), self.radii[i + 1], 4.2 if i == 0 else 2.6)
                  for i in range(len(self.joints) - 2)]

        def depth(points):
            total = np.zeros(len(points))
            for local, radius, spread in joints:
                along, across, up = local(points).T
                near = np.exp(-(across / (0.8 * radius)) ** 2) * (np.hypot(across, up) < 2.0 * radius)
                waves = 0.5 + 0.5 * np.cos(2.0 * np.pi * (along + 0.08 * across ** 2 / radius) / 3.3)
                on_back = waves * np.exp(-(along / spread) ** 2) * np.clip(up / (0.5 * radius), 0.0, 1.0)
                inside = np.exp(-(along / 1.3) ** 2) * np.clip(-up / (0.4 * radius), 0.0, 1.0)
                total = np.maximum(total, near * np.maximum(on_back, inside))
            return total

        return depth


def _unit(v):
    return v / np.linalg.norm(v)


def _finger(name, bends):
    """bends: at its three joints, degrees towards the palm."""
    knuckle, lengths, radii, apart = FINGERS[name]
    joints, backs = [vector(*knuckle)], []
    turn = rotation((0, 1, 0), apart)
    bend = 0.0
    for length, more in zip(lengths, bends):
        bend += more
        tilt = turn @ rotation((0, 0, 1), bend)
        joints.append(joints[-1] + tilt @ vector(-length, 0, 0))
        backs.append(tilt @ vector(0, 1, 0))
    return Digit(joints, radii, backs)


def _thumb(joints, back):
    """back: where its nail looks."""
    joints = [vector(*joint) for joint in joints]
    return Digit(joints, THUMB_RADII, [_unit(vector(*back))] * 3)


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


def _path(points, radius):
    """A cord under the skin: a tendon or a vein."""
    points = [vector(*p) for p in points]
    return [bone(a, b, radius) for a, b in zip(points, points[1:])]


def _back_of_hand(fingers):
    """What shows through the skin: knuckles, the tendons that run from them, veins, the wrist's bone."""
    shown = [solid.ball(finger.joints[0] + vector(1.0, 4.6, 0), 7.6) for finger in fingers.values()]
    for finger in fingers.values():
        knuckle = finger.joints[0]
        shown += [bone(knuckle + vector(4, 7.2, 0), knuckle * 0.45 + vector(-4, 11.4, 2), 3.2, 2.4)]
    shown += _path([(-72, 13.0, -6), (-52, 15.2, -4), (-36, 15.6, -9), (-14, 16.0, -7), (16, 17.6, -12), (60, 19.5, -9)], 2.1)
    shown += _path([(-70, 12.0, 14), (-50, 14.6, 10), (-36, 15.6, -9)], 1.9)
    shown += _path([(-50, 14.6, 10), (-26, 15.4, 17), (10, 17.2, 16), (58, 19.8, 14)], 2.0)
    return shown + [solid.ball((12, 10, -19), 10.5), solid.ball((4, 7, 24), 9.0)]


def _hand(fingers, thumb):
    """The flesh up to the elbow, and the arm alone, as distance functions."""
    palm = [bone((-8, 0, 10), finger.joints[0], 17.0, 12.0) for finger in fingers.values()]
    palm += [bone((-14, -7, 14), thumb.joints[1], 16.0, 13.0),     # the ball of the thumb
             bone((-12, -8, -16), (-66, -7, -31), 15.0, 11.5),     # and the heel of the hand
             bone(thumb.joints[1] + vector(4, 4, -6), fingers["index"].joints[0] + vector(22, -4, -2), 9.0, 9.0)]  # skin between
    arm = soft_union([bone((-6, 0, 10), (130, 2, 13), 18.5, 27.0), bone((-6, 0, -9), (130, 2, -9), 17.5, 27.0),
                      bone((110, 2, 2), (ARM_LENGTH, 4, 2), 33.0, 43.0)], 16.0)
    hand = soft_union([soft_union(palm, 15.0), arm], 20.0)
    hand = soft_union([hand, soft_union(_back_of_hand(fingers), 2.0)], 5.0)
    # Fingers keep a crease between them; the palm takes them up softly.
    hand = soft_union([hand, soft_union([finger.flesh() for finger in fingers.values()], 1.6)], 9.0)
    return soft_union([hand, thumb.flesh()], 8.0), arm


def build(pose):
    """pose: dict of bends a finger, thumb joints and the way its nail looks, place (3 x 3 and an offset made from
    the finger tips), mirrored. Returns parts."""
    fingers = {name: _finger(name, bends) for name, bends in pose["fingers"].items()}
    thumb = _thumb(pose["thumb"], pose["nail"])
    digits = [*fingers.values(), thumb]
    smooth, arm = _hand(fingers, thumb)
    nails, folds = [digit.nail() for digit in digits], [digit.folds() for digit in digits]

    def detail(points):
        """Nail, groove and fold, each 0 to 1."""
        covers = [nail(points) for nail in nails]
        return (np.max([plate for plate, _ in covers], axis=0), np.max([groove for _, groove in covers], axis=0),
                np.max([fold(points) for fold in folds], axis=0))

    def hand(points):
        plate, groove, fold = detail(points)
        return smooth(points) - 0.5 * plate + 0.8 * groove + 0.9 * fold

    sleeve = _sleeve(arm)
    bare = solid.without(hand, solid.half_space((-1, 0, 0), -(SLEEVE_FROM + 9.0)), 1.0)  # hidden below the sleeve
    whole = solid.soft_union([smooth, sleeve], 0.5)

    def splashes(points):
        return np.max([np.clip(1.4 - np.linalg.norm(points - spot, axis=1) / size, 0.0, 0.75)
                       for spot, size in zip(SPLASHES[:, :3], SPLASHES[:, 3])], axis=0)

    def smear(points):
        """Slip up to the wrist, thin and in streaks over the back of the hand, thick in folds and round nails."""
        plate, groove, fold = detail(points)
        streaks = 0.5 + 0.5 * np.sin(points[:, 1] * 0.31 + 2.0 * np.sin(points[:, 0] * 0.045) + points[:, 2] * 0.17)
        worked = np.maximum(0.96 - 0.007 * np.maximum(points[:, 0] + 60.0, 0.0), splashes(points))
        return np.clip(worked - 0.28 * streaks
                       + 0.25 * (points[:, 0] < -85.0) - 0.55 * plate, 0.0, 1.0) + 0.4 * np.maximum(groove, fold)

    def tone(points):
        plate, groove, fold = detail(points)
        return (0.5 + 0.06 * np.sin(points[:, 0] * 0.09 + points[:, 2] * 0.13)
                + 0.14 * plate - 0.36 * groove - 0.30 * fold)

    low, high = vector(-200, -110, -75), vector(ARM_LENGTH + 50, 60, 85)
    parts = [skin.part("skin", bare, low, vector(SLEEVE_FROM + 30, 60, 85), 1.0, pose["triangles"], smear, tone, whole,
                       lambda p: np.clip(np.sum(detail(p), axis=0) + 0.2 * splashes(p), 0.0, 1.0)),
             skin.part("linen", sleeve, vector(SLEEVE_FROM - 6, -70, -70), high, 3.4, 400,
                       lambda p: 0.35 * np.clip(1.0 - (p[:, 0] - SLEEVE_FROM) / 40.0, 0.0, 1.0),
                       lambda p: 0.5 + 0.06 * np.sin(p[:, 0] * 0.09 + p[:, 2] * 0.13), whole)]
    tips = np.array([fingers[name].joints[-1] for name in ("index", "middle")])
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
    "nail": (0.15, 0.75, 0.65),
    "turn": rotation((0, 1, 0), -24) @ rotation((0, 0, 1), 8) @ rotation((1, 0, 0), -34),
    "pad": (-7.0, -1.5, 0.0),
    "triangles": 4400,
}
# Inside: two fingers pointing down into the pot, their pads towards the wall (-X is the clay here too), the others
# curled, since a wall of 50 mm radius has no room for four side by side. The forearm leaves through the mouth towards
# the visitor's left.
INNER = {
    "fingers": {"index": (6, 12, 8), "middle": (8, 13, 8), "ring": (66, 92, 42), "little": (70, 92, 42)},
    "thumb": [(-22, -9, 22), (-50, -14, 42), (-82, -12, 48), (-104, -6, 46)],
    "nail": (0.2, 0.7, 0.7),
    "turn": rotation((0, 0, 1), 78) @ rotation((1, 0, 0), 180),
    "pad": (-10.5, 0.0, 0.0),
    "triangles": 4000,
}
