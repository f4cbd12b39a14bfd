"""What things are made of: Cycles materials, all procedural, so that no picture has to travel along.

Colours are linear reflectances. Textures are laid out in object space in metres; each object sees its own
piece of the pattern. `Paint` keeps also the plain colour, roughness and metalness of each material, which is
what goes into the room's GLB.
"""
import bpy


class Graph:
    """Node graphs in one line a node: g.node('TexNoise', Scale=8.0, Vector=socket)."""

    def __init__(self, material):
        material.use_nodes = True
        self.tree = material.node_tree
        self.surface = self.tree.nodes["Principled BSDF"]

    def node(self, kind, settings=None, **inputs):
        node = self.tree.nodes.new("ShaderNode" + kind)
        for key, value in (settings or {}).items():
            setattr(node, key, value)
        for key, value in inputs.items():
            self.feed(node.inputs[int(key[1:])] if key[0] == "i" and key[1:].isdigit() else node.inputs[key], value)
        return node

    def feed(self, socket, value):
        if isinstance(value, bpy.types.NodeSocket):
            self.tree.links.new(value, socket)
        else:
            socket.default_value = value

    def math(self, operation, a, b=0.0):
        return self.node("Math", {"operation": operation}, i0=a, i1=b).outputs[0]

    def mix(self, amount, a, b):
        """Colours a and b (tuples or sockets) by `amount`."""
        rgba = [(*c, 1.0) if isinstance(c, tuple) and len(c) == 3 else c for c in (a, b)]
        return self.node("MixRGB", Fac=amount, Color1=rgba[0], Color2=rgba[1]).outputs[0]

    def ramp(self, value, low, high):
        """0 below low, 1 above high, smooth between."""
        return self.node("MapRange", {"interpolation_type": "SMOOTHSTEP"}, Value=value,
                         **{"From Min": low, "From Max": high}).outputs[0]

    def place(self, stretch=(1, 1, 1)):
        """Object space, shifted by a different amount for each object, then stretched."""
        where = self.node("TexCoord").outputs["Object"]
        shift = self.math("MULTIPLY", self.node("ObjectInfo").outputs["Random"], 7.0)
        moved = self.node("VectorMath", {"operation": "ADD"}, i0=where, i1=shift).outputs[0]
        return self.node("VectorMath", {"operation": "MULTIPLY"}, i0=moved, i1=stretch).outputs[0]

    def noise(self, where, scale, detail=5.0, rough=0.6, twist=0.0):
        return self.node("TexNoise", Vector=where, Scale=scale, Detail=detail, Roughness=rough,
                         Distortion=twist).outputs["Fac"]

    def bump(self, height, distance_m, strength=1.0, after=None):
        inputs = {"Normal": after} if after else {}
        return self.node("Bump", Height=height, Distance=distance_m, Strength=strength, **inputs).outputs[0]

    def radius(self):
        """Distance from the object's z axis."""
        at = self.node("SeparateXYZ", Vector=self.node("TexCoord").outputs["Object"]).outputs
        return self.math("SQRT", self.math("ADD", self.math("MULTIPLY", at[0], at[0]),
                                           self.math("MULTIPLY", at[1], at[1])))

    def height(self):
        return self.node("SeparateXYZ", Vector=self.node("TexCoord").outputs["Object"]).outputs[2]


class Paint:
    """All materials of the workshop by name: paint['oak']."""

    def __init__(self):
        self.made = {}
        self.plain = {}  # name -> (colour, roughness, metalness): for the GLB
        self._room()
        self._wood()
        self._metal()
        self._clay()
        self._soft()

    def __getitem__(self, name):
        return self.made[name]

    def _new(self, name, colour, roughness, metalness=0.0, coat=0.0, coat_roughness=0.1, specular=0.5):
        material = bpy.data.materials.new(name)
        g = Graph(material)
        g.feed(g.surface.inputs["Base Color"], (*colour, 1.0))
        g.feed(g.surface.inputs["Roughness"], roughness)
        g.feed(g.surface.inputs["Metallic"], metalness)
        g.feed(g.surface.inputs["Clearcoat"], coat)
        g.feed(g.surface.inputs["Clearcoat Roughness"], coat_roughness)
        g.feed(g.surface.inputs["Specular"], specular)
        self.made[name] = material
        self.plain[name] = (colour, coat_roughness if coat > 0.5 else roughness, metalness)
        return g

    def _room(self):
        colour = (0.50, 0.415, 0.315)
        g = self._new("plaster", colour, 0.92, specular=0.2)
        where = g.place()
        clouds = g.noise(where, 2.6, 6.0, 0.62)
        trowel = g.noise(g.place((1.0, 1.0, 2.6)), 9.0, 5.0, 0.55, twist=1.2)
        straw = g.ramp(g.noise(g.place((1, 1, 5)), 75.0, 2.0), 0.66, 0.76)  # chopped straw in the plaster
        tone = g.mix(g.ramp(clouds, 0.3, 0.72), tuple(c * 0.80 for c in colour), tuple(c * 1.12 for c in colour))
        g.feed(g.surface.inputs["Base Color"], g.mix(g.math("MULTIPLY", straw, 0.22), tone, (0.30, 0.22, 0.13)))
        fine = g.bump(g.noise(where, 160.0, 4.0), 0.0006)
        g.feed(g.surface.inputs["Normal"], g.bump(trowel, 0.006, 0.55, after=fine))

        g = self._new("earth", (0.17, 0.135, 0.10), 0.85, specular=0.2)
        clouds = g.noise(g.place(), 3.0, 8.0, 0.66)
        g.feed(g.surface.inputs["Base Color"], g.mix(clouds, (0.10, 0.078, 0.058), (0.25, 0.20, 0.15)))
        g.feed(g.surface.inputs["Normal"], g.bump(g.noise(g.place(), 30.0), 0.006, 0.5))

        # Mulberry paper in the window, lit from outside: it shines with the evening behind it.
        g = self._new("hanji", (0.75, 0.70, 0.60), 0.9, specular=0.1)
        fibres = g.noise(g.place((1.0, 1.0, 3.0)), 45.0, 6.0, 0.7, twist=2.0)
        leaves = g.ramp(g.noise(g.place((1.0, 1.0, 0.8)), 7.5, 3.0, 0.5, twist=0.8), 0.40, 0.62)
        glow = g.mix(leaves, (0.70, 0.66, 0.56), (1.0, 0.92, 0.78))
        g.feed(g.surface.inputs["Emission"], g.mix(g.math("MULTIPLY", g.ramp(fibres, 0.3, 0.7), 0.16), glow,
                                                   (0.62, 0.57, 0.48)))
        # A photographer would expose the window down: seen, it is dimmer than the light it gives.
        seen = g.node("Value")
        given = g.node("Value")
        seen.name, given.name = "seen", "given"  # lights.py sets both
        eye = g.node("LightPath").outputs["Is Camera Ray"]
        g.feed(g.surface.inputs["Emission Strength"],
               g.math("ADD", g.math("MULTIPLY", eye, seen.outputs[0]),
                      g.math("MULTIPLY", g.math("SUBTRACT", 1.0, eye), given.outputs[0])))

    def _wood(self):
        def wood(name, light, dark, rough, board_m=None, clay=0.0):
            middle = tuple(0.55 * a + 0.45 * b for a, b in zip(light, dark))
            g = self._new(name, middle, rough, specular=0.35)
            where = g.place()
            boards = None
            if board_m:  # boards side by side along x: each its own piece of the tree, a dark seam between
                axis = g.node("SeparateXYZ", Vector=g.node("TexCoord").outputs["Object"]).outputs[1]
                position = g.math("DIVIDE", axis, board_m)
                which = g.math("FLOOR", position)
                across = g.math("ABSOLUTE", g.math("SUBTRACT", g.math("SUBTRACT", position, which), 0.5))
                boards = g.ramp(across, 0.484, 0.496)
                step = g.node("CombineXYZ", X=g.math("MULTIPLY", which, 3.7), Y=g.math("MULTIPLY", which, 0.43),
                              Z=g.math("MULTIPLY", which, 0.29)).outputs[0]
                where = g.node("VectorMath", {"operation": "ADD"}, i0=where, i1=step).outputs[0]
            lay = lambda s: g.node("VectorMath", {"operation": "MULTIPLY"}, i0=where, i1=s).outputs[0]
            rings = g.node("TexWave", {"wave_type": "RINGS", "rings_direction": "X"}, Vector=lay((0.10, 1.0, 1.7)),
                           Scale=9.0, Distortion=7.0, Detail=3.0, **{"Detail Scale": 3.5}).outputs["Fac"]
            fibre = g.noise(lay((2.2, 70.0, 70.0)), 5.0, 5.0, 0.65)
            drift = g.noise(lay((1.0, 3.0, 3.0)), 2.5, 3.0)
            figure = g.math("ADD", g.math("MULTIPLY", rings, 0.22),
                            g.math("ADD", g.math("MULTIPLY", fibre, 0.60), g.math("MULTIPLY", drift, 0.55)))
            colour = g.mix(g.ramp(figure, 0.35, 1.0), dark, light)
            normal = g.bump(fibre, 0.0009, 0.5)
            if boards:
                colour = g.mix(boards, colour, tuple(0.25 * c for c in dark))
                normal = g.bump(g.math("MULTIPLY", boards, -1.0), 0.002, 1.0, after=normal)
            if clay:  # dry clay around the wheel: thick by the pan, gone at the edge of the deck
                near = g.ramp(g.radius(), 0.46, 0.22)
                smear = g.ramp(g.math("ADD", g.noise(g.place((1.0, 1.8, 1.0)), 9.0, 7.0, 0.7),
                                      g.math("MULTIPLY", near, 0.20)), 0.52, 0.82)
                # Stoneware's colour; kStoneware in game/finish/clay_body.h, and a test compares.
                colour = g.mix(g.math("MULTIPLY", smear, clay), colour, (0.36, 0.29, 0.215))
            g.feed(g.surface.inputs["Base Color"], colour)
            g.feed(g.surface.inputs["Roughness"], g.node("MapRange", Value=fibre, **{
                "To Min": rough - 0.10, "To Max": rough + 0.14}).outputs[0])
            g.feed(g.surface.inputs["Normal"], normal)

        wood("oak", (0.40, 0.245, 0.125), (0.20, 0.105, 0.048), 0.52)
        wood("oak boards", (0.37, 0.225, 0.115), (0.185, 0.098, 0.045), 0.50, board_m=0.118)
        wood("deck boards", (0.235, 0.145, 0.080), (0.105, 0.060, 0.031), 0.52, board_m=0.150, clay=0.55)
        wood("dark timber", (0.135, 0.078, 0.045), (0.055, 0.031, 0.019), 0.55)
        wood("boxwood", (0.55, 0.36, 0.17), (0.38, 0.22, 0.09), 0.42)

    def _metal(self):
        # The wheel head: turned aluminium. Slip dries on it in rings, for it turns: nothing on it may show
        # an angle, since the plate stands still while the wheel goes round.
        metal = (0.56, 0.545, 0.52)
        g = self._new("wheel head", metal, 0.36, 1.0)
        radius = g.radius()
        line = g.node("CombineXYZ", X=radius).outputs[0]
        grooves = g.noise(line, 620.0, 3.0, 0.7)
        film = g.ramp(g.noise(line, 34.0, 5.0, 0.7), 0.46, 0.74)
        near = g.ramp(radius, 0.128, 0.085)  # fingers leave most of it around the foot
        slip = g.math("MULTIPLY", film, g.math("ADD", g.math("MULTIPLY", near, 0.12), 0.08))
        g.feed(g.surface.inputs["Base Color"], g.mix(slip, metal, (0.36, 0.28, 0.20)))
        g.feed(g.surface.inputs["Metallic"], g.math("SUBTRACT", 1.0, slip))
        g.feed(g.surface.inputs["Roughness"], g.math("ADD", g.math("MULTIPLY", slip, 0.5),
                                                     g.math("ADD", 0.27, g.math("MULTIPLY", grooves, 0.16))))
        g.feed(g.surface.inputs["Normal"], g.bump(grooves, 0.0005, 0.35))

        self._new("steel", (0.55, 0.54, 0.52), 0.28, 1.0)
        self._new("brass", (0.62, 0.44, 0.18), 0.34, 1.0)
        g = self._new("iron", (0.055, 0.05, 0.046), 0.55)
        g.feed(g.surface.inputs["Base Color"], g.mix(g.noise(g.place(), 25.0), (0.035, 0.03, 0.028), (0.09, 0.07, 0.055)))

    def _clay(self):
        def ware(name, colour, rough, coat=0.0, coat_rough=0.1, speck=0.0, cloud=0.14, bumpy=0.0004):
            g = self._new(name, colour, rough, coat=coat, coat_roughness=coat_rough)
            where = g.place()
            clouds = g.noise(g.place((1, 1, 1.8)), 14.0, 5.0, 0.6)
            tone = g.mix(g.ramp(clouds, 0.3, 0.7), tuple(c * (1 - cloud) for c in colour),
                         tuple(min(c * (1 + 0.7 * cloud), 0.9) for c in colour))
            if speck:
                dots = g.ramp(g.noise(where, 420.0, 2.0, 0.4), 0.64, 0.72)
                tone = g.mix(g.math("MULTIPLY", dots, speck), tone, (0.06, 0.04, 0.025))
            g.feed(g.surface.inputs["Base Color"], tone)
            g.feed(g.surface.inputs["Normal"], g.bump(g.noise(where, 130.0, 4.0), bumpy))
            return g, tone

        ware("bisque", (0.56, 0.29, 0.165), 0.86)
        ware("greenware", (0.40, 0.33, 0.25), 0.80)
        ware("wet clay", (0.25, 0.175, 0.118), 0.38, bumpy=0.0012, cloud=0.25)
        ware("moon white", (0.74, 0.715, 0.66), 0.35, coat=0.8, coat_rough=0.12, cloud=0.06, speck=0.05)
        ware("celadon", (0.31, 0.405, 0.325), 0.30, coat=1.0, coat_rough=0.07, cloud=0.16)
        ware("ash", (0.34, 0.31, 0.235), 0.55, coat=0.35, coat_rough=0.3, speck=0.35, cloud=0.25)
        # Onggi: iron-brown ash glaze, thinner and redder where it ran off the shoulder.
        g, tone = ware("onggi glaze", (0.085, 0.042, 0.023), 0.36, coat=0.9, coat_rough=0.16, cloud=0.4, bumpy=0.0012)
        runs = g.ramp(g.noise(g.place((1, 1, 0.12)), 34.0, 3.0, 0.6), 0.50, 0.74)
        g.feed(g.surface.inputs["Base Color"], g.mix(g.math("MULTIPLY", runs, 0.75), tone, (0.20, 0.098, 0.045)))
        # Buncheong: grey body under white slip laid on with a coarse brush.
        g, tone = ware("buncheong", (0.27, 0.255, 0.215), 0.45, coat=0.6, coat_rough=0.16, speck=0.25)
        brush = g.noise(g.place((2.0, 2.0, 46.0)), 5.0, 6.0, 0.72)
        g.feed(g.surface.inputs["Base Color"], g.mix(g.ramp(brush, 0.42, 0.58), tone, (0.66, 0.63, 0.56)))

        # The splash pan: cream enamel, slip dried on it, thicker towards the bottom.
        g = self._new("pan", (0.47, 0.44, 0.375), 0.34, coat=0.3, coat_roughness=0.2)
        clouds = g.noise(g.place((1, 1, 1.6)), 11.0, 7.0, 0.68)
        splash = g.ramp(g.noise(g.place(), 55.0, 4.0, 0.55), 0.58, 0.64)
        low = g.ramp(g.height(), 0.045, 0.0)  # the pan's own origin is its bottom
        dirt = g.ramp(g.math("ADD", clouds, g.math("MULTIPLY", low, 0.22)), 0.52, 0.78)
        dirt = g.math("MAXIMUM", dirt, g.math("MULTIPLY", splash, 0.55))
        g.feed(g.surface.inputs["Base Color"], g.mix(g.math("MULTIPLY", dirt, 0.8), (0.47, 0.44, 0.375), (0.30, 0.225, 0.155)))
        g.feed(g.surface.inputs["Roughness"], g.math("ADD", 0.32, g.math("MULTIPLY", dirt, 0.4)))
        g.feed(g.surface.inputs["Normal"], g.bump(dirt, 0.0008))

        g = self._new("slip water", (0.27, 0.20, 0.14), 0.08)
        g.feed(g.surface.inputs["Normal"], g.bump(g.noise(g.place(), 18.0, 2.0), 0.0012, 0.4))

    def _soft(self):
        g = self._new("sponge", (0.66, 0.43, 0.15), 0.95, specular=0.1)
        where = g.place()
        pores = g.node("TexVoronoi", Vector=where, Scale=330.0).outputs["Distance"]
        wide = g.noise(where, 120.0, 4.0)  # where the pores are open and where they have closed
        solid = g.ramp(g.math("SUBTRACT", pores, g.math("MULTIPLY", wide, 0.5)), -0.10, 0.10)
        body = g.mix(g.noise(where, 40.0), (0.56, 0.36, 0.13), (0.72, 0.50, 0.21))
        g.feed(g.surface.inputs["Base Color"], g.mix(solid, (0.27, 0.155, 0.05), body))
        g.feed(g.surface.inputs["Normal"], g.bump(g.math("ADD", solid, g.math("MULTIPLY", wide, 0.8)), 0.0016))

        self._new("bristle", (0.60, 0.52, 0.40), 0.8)
        self._new("twig", (0.10, 0.065, 0.045), 0.8)
        self._new("bud", (0.46, 0.20, 0.17), 0.7)
