"""What a potter's hands do, as rows of a gesture: moves that follow one another, each said in lengths of the
pot. mm, s. The form of the table: onggi throw --help."""
import math

COLUMNS = ("t_s,x_mm,y_mm,z_mm,button,tool_radius_mm,"
           "tool,water,wheel_rev_min,assist_gap_mm,shaft_mm,wire,wire_y_mm")
STEP_S = 0.02      # between rows: finer than a hand can turn
TOWARDS_US = 0.5   # rad, where around the wheel the hand works: to the right, a little to the front
REST = (150.0, 205.0)  # radius and height of a hand that waits


def eased(share):
    """How far a hand has come that starts and ends at rest (least jerk)."""
    return share * share * share * (10.0 - 15.0 * share + 6.0 * share * share)


class Hands:
    """A gesture as it grows. Radii are distances of the tool's centre from the axis, outside positive."""

    def __init__(self, radius=10.0, wheel_rev_min=120.0):
        self.tool_radius = radius
        self.wheel = wheel_rev_min
        self.turning = True
        self.tool = "hand"
        self.water = 1.0
        self.gap = 0.0
        self.shaft = 0.0
        self.wire = "none"
        self.wire_height = 0.0
        self.time = 0.0
        self.at = REST
        self.rows = []
        self._row()

    def _row(self):
        r, y = self.at
        self.rows.append(
            f"{self.time:.3f},{r * math.cos(TOWARDS_US):.4f},{y:.4f},{r * math.sin(TOWARDS_US):.4f},"
            f"{int(self.turning)},{self.tool_radius:g},{self.tool},{self.water:g},{self.wheel:g},"
            f"{self.gap:g},{self.shaft:g},{self.wire},{self.wire_height:g}")

    def follow(self, seconds, path):
        """Along path(share), radius and height at 0 to 1 of the time."""
        steps = max(1, round(seconds / STEP_S))
        start = self.time
        for step in range(1, steps + 1):
            self.time = start + seconds * step / steps
            self.at = path(step / steps)
            self._row()

    def move(self, seconds, radius, height, gently=True):
        """In a straight line; gently: from rest to rest."""
        r0, y0 = self.at
        ease = eased if gently else (lambda share: share)
        self.follow(seconds, lambda s: (r0 + ease(s) * (radius - r0), y0 + ease(s) * (height - y0)))

    def press(self, seconds, radius, height):
        """A working stroke: even, so that the clay comes along."""
        self.move(seconds, radius, height, gently=False)

    def hold(self, seconds):
        self.follow(seconds, lambda s, at=self.at: at)

    def rest(self, seconds=0.8):
        """Away from the clay, the way a hand lifts off: out first, then up."""
        r, y = self.at
        self.move(0.4 * seconds, max(r + 18.0, r), y + 4.0)
        self.move(0.6 * seconds, *REST)

    def lift_out(self, seconds, top):
        """Out of the pot over its rim."""
        self.move(0.5 * seconds, self.at[0], top + 40.0)
        self.move(0.5 * seconds, REST[0], max(REST[1], top + 40.0))

    def cut(self, kind, height):
        """The wire, drawn once; kind: rim or off."""
        self.wire, self.wire_height = kind, height
        self.hold(0.1)
        self.wire = "none"
        self.hold(0.4)

    def table(self):
        return COLUMNS + "\n" + "\n".join(self.rows) + "\n"


def centre(hands, radius, low, high, squeeze):
    """Both palms on the lump: from its shoulder down, then still while it runs true."""
    r1 = hands.tool_radius
    hands.move(1.0, radius + r1 + 8.0, high)
    hands.press(0.8, radius + r1 + 1.0, high)
    hands.press(1.2, radius + r1 - squeeze, low)
    hands.press(2.2, radius + r1 - squeeze, 0.5 * (low + high))
    hands.rest()


def open_up(hands, top, floor, width, seconds=3.0):
    """A thumb down the middle to the floor, then out along it. width: inner radius at the floor."""
    r1 = hands.tool_radius
    hands.move(0.6, 40.0, top + 2.0 * r1 + 20.0)
    hands.move(0.6, 0.0, top + r1 + 6.0)
    hands.press(seconds, 0.0, floor + r1 - 4.0)
    hands.hold(0.3)
    hands.shaft = 0.9 * r1
    hands.press(seconds, width - r1 + 0.5, floor + r1 - 4.0)
    hands.hold(0.4)
    hands.press(0.4, width - r1 - 4.0, floor + r1 - 4.0)
    hands.lift_out(1.0, top + 30.0)
    hands.shaft = 0.0


def foot(hands, radius, height):
    """The corner under the wall, pressed in from outside."""
    r1 = hands.tool_radius
    hands.move(0.8, radius + r1 + 12.0, 3.0)
    hands.press(1.2, radius + r1 - 0.5, 3.0)
    hands.press(1.0, radius + r1 - 0.5, height)
    hands.rest(0.6)


def pull(hands, low, outer, gap, speed=22.0, top=100.0):
    """One pull: the hand outside, the other inside at `gap`, from height `low` past the rim at `top`. outer:
    radius of the outer face as a function of height."""
    r1 = hands.tool_radius
    hands.move(0.8, outer(low) + r1 + 10.0, low)
    hands.gap = gap
    hands.press(0.7, outer(low) + r1 - 0.25, low)
    y0 = low
    hands.follow((top - low) / speed,
                 lambda s: (outer(y0 + s * (top - y0)) + r1 * slant(outer, y0 + s * (top - y0)) - 0.25,
                            y0 + s * (top - y0)))
    hands.gap = 0.0
    hands.rest(0.7)


def slant(face, y):
    """sqrt(1 + T^2): how much farther out a ball must stand beside a leaning wall than its own radius."""
    slope = (face(y + 0.5) - face(y - 0.5))
    return math.sqrt(1.0 + slope * slope)


def shape_inside(hands, face, low, high, seconds, clear):
    """The ball inside, up the inner face that the wall shall have; clear: above the rim on the way in."""
    r1 = hands.tool_radius

    def beside(y):
        return face(y) - r1 * slant(face, y)

    hands.move(0.6, 30.0, clear + r1 + 15.0)
    hands.move(0.8, max(0.0, beside(low) - 10.0), low)
    hands.press(0.5, beside(low), low)
    hands.follow(seconds, lambda s: (beside(low + s * (high - low)), low + s * (high - low)))
    hands.move(0.4, max(0.0, hands.at[0] - 10.0), hands.at[1] + 4.0)
    hands.lift_out(0.9, clear)


def shape_outside(hands, face, low, high, seconds):
    """The ball outside, up the outer face that the wall shall have."""
    r1 = hands.tool_radius

    def beside(y):
        return face(y) + r1 * slant(face, y)

    hands.move(0.8, beside(low) + 12.0, low)
    hands.press(0.6, beside(low), low)
    hands.follow(seconds, lambda s: (beside(low + s * (high - low)), low + s * (high - low)))
    hands.rest(0.7)


def fair(hands, tool, face, low, high, seconds, water=1.0):
    """Up the outside with a sponge or a rib that just touches."""
    r1 = hands.tool_radius
    before = hands.tool, hands.water
    hands.tool, hands.water = tool, water
    hands.move(0.7, face(low) + r1 * slant(face, low) + 8.0, low)

    def beside(s):
        y = low + s * (high - low)
        return face(y) + r1 * slant(face, y) - 0.4, y

    hands.follow(seconds, beside)
    hands.rest(0.7)
    hands.tool, hands.water = before


def towards(face, other, share):
    """The face that lies that share of the way from one to the other."""
    return lambda y: face(y) + share * (other(y) - face(y))


def between(*points):
    """A smooth curve through (y, radius) points, as a function of height; straight on beyond the ends."""
    ys = [p[0] for p in points]
    rs = [p[1] for p in points]

    def face(y):
        if y <= ys[0]:
            return rs[0]
        if y >= ys[-1]:
            return rs[-1] + (y - ys[-1]) * (rs[-1] - rs[-2]) / (ys[-1] - ys[-2])
        i = max(k for k in range(len(ys) - 1) if ys[k] <= y)
        s = (y - ys[i]) / (ys[i + 1] - ys[i])
        return rs[i] + (rs[i + 1] - rs[i]) * s * s * (3.0 - 2.0 * s)

    return face
