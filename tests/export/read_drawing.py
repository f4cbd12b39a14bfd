"""read_drawing.py FOLDER SCHEMA: measures the drawings that make_pots wrote (NAME.svg) against the triangles of the same pots
(NAME.stl), by readers that share no code with their writers; and NAME.json against the schema's names and kinds. Lengths mm."""

import json
import re
import struct
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

MOST_OFF_MM = 0.1
HEIGHTS = 25
SVG = "{http://www.w3.org/2000/svg}"


def expect(is_so, words):
    if not is_so:
        sys.exit(words)


def near(found, wanted, words):
    expect(abs(found - wanted) <= MOST_OFF_MM, f"{words}: expected {wanted:.3f} mm, found {found:.3f}")


def strokes_of(root):
    """Each stroked path: (line width, points)."""
    strokes = []
    expect(not any("style" in part.attrib for part in root.iter()), "expected no style, which a server's policy may forbid")
    for path in root.iter(SVG + "path"):
        if "stroke-width" not in path.attrib or path.get("stroke", "none") == "none":
            continue
        matrix = [float(number) for number in re.findall(r"[-\d.e]+", path.get("transform", "matrix(1,0,0,1,0,0)"))]
        for part in re.findall(r"M[^M]*", path.get("d")):
            numbers = [float(number) for number in re.findall(r"[-\d.]+", part)]
            points = [(matrix[0] * x + matrix[2] * y + matrix[4], matrix[1] * x + matrix[3] * y + matrix[5])
                      for x, y in zip(numbers[::2], numbers[1::2])]
            strokes.append((round(float(path.get("stroke-width")), 2), points))
    return strokes


def triangles_of(stl):
    data = stl.read_bytes()
    (count,) = struct.unpack_from("<I", data, 80)
    for i in range(count):
        numbers = struct.unpack_from("<12f", data, 84 + 50 * i)
        yield numbers[3:6], numbers[6:9], numbers[9:12]


def crossings(points, height):
    """Where a closed outline crosses a height, from left to right."""
    found = []
    for (x0, y0), (x1, y1) in zip(points, points[1:] + points[:1]):
        if (y0 > height) != (y1 > height):
            found.append(x0 + (x1 - x0) * (height - y0) / (y1 - y0))
    return found


def at_height(triangles, height):
    """The section of the triangles at a height: pairs of points (x, depth)."""
    for corners in triangles:
        cut = []
        for one, other in zip(corners, corners[1:] + corners[:1]):
            if (one[2] > height) != (other[2] > height):
                part = (height - one[2]) / (other[2] - one[2])
                cut.append((one[0] + (other[0] - one[0]) * part, one[1] + (other[1] - one[1]) * part))
        if len(cut) == 2:
            yield cut


def walls(cuts):
    """Where those cross the drawing's plane left of the axis."""
    found = []
    for (x0, depth0), (x1, depth1) in cuts:
        if (depth0 > 0.0) != (depth1 > 0.0):
            x = x0 + (x1 - x0) * -depth0 / (depth1 - depth0)
            if x < 0.0:
                found.append(x)
    return sorted(found)


def check_drawing(folder, name):
    root = xml.parse(folder / f"{name}.svg").getroot()
    width, height = (root.get(side) for side in ("width", "height"))
    expect(width.endswith("mm") and height.endswith("mm"), f"{name}: expected a page in mm, found {width} x {height}")
    page = [float(number) for number in root.get("viewBox").split()]
    expect(page == [0.0, 0.0, float(width[:-2]), float(height[:-2])], f"{name}: expected 1:1, found {page} for {width}")
    strokes = strokes_of(root)
    axis = max((points for weight, points in strokes if weight == 0.25 and len(points) == 2 and points[0][0] == points[1][0]),
               key=lambda points: abs(points[0][1] - points[1][1]))
    middle, foot = axis[0][0], max(point[1] for point in axis)

    def from_foot(points):
        return [(x - middle, foot - y) for x, y in points]

    outlines = [from_foot(points) for weight, points in strokes if weight == 0.5]
    sections = [points for points in outlines if min(x for x, _ in points) < -0.1]
    (elevation,) = [points for points in outlines if points not in sections]
    triangles = list(triangles_of(folder / f"{name}.stl"))
    top = max(corner[2] for triangle in triangles for corner in triangle)
    near(elevation[-1][1], top, f"{name}: height")
    near(abs(axis[0][1] - axis[1][1]), top, f"{name}: axis")
    near(max(x for x, _ in elevation), max(corner[0] for triangle in triangles for corner in triangle), f"{name}: widest")
    compared = 0
    for i in range(HEIGHTS):
        level = top * (i + 0.37) / HEIGHTS
        cuts = list(at_height(triangles, level))
        found = sorted(x for outline in sections for x in crossings(outline, level) if x < 0.0)
        wanted = walls(cuts)
        expect(len(found) == len(wanted), f"{name}: at {level:.2f} mm expected walls at {wanted}, found {found}")
        for one, other in zip(found, wanted):
            near(one, other, f"{name}: section at {level:.2f} mm")
            compared += 1
        right = max(crossings(elevation + [(0.0, top), (0.0, 0.0)], level))
        near(right, max(max(cut[0][0], cut[1][0]) for cut in cuts), f"{name}: elevation at {level:.2f} mm")
    hatching = [points for weight, points in strokes if weight == 0.13]
    expect(len(hatching) > 5, f"{name}: expected hatching, found {len(hatching)} lines")
    for (x0, y0), (x1, y1) in hatching:
        expect(max(x0, x1) <= middle + 1e-3 and abs(abs(x1 - x0) - abs(y1 - y0)) < 1e-2, f"{name}: hatching at 45 degrees, left")
    return compared


def check_measures(file, schema):
    found = json.loads(file.read_text())
    expect(found["version"] == schema["properties"]["version"]["const"], f"{file}: version")
    known, required = set(schema["properties"]), set(schema["required"])
    expect(required <= set(found) <= known, f"{file}: expected {required} and perhaps {known - required}, found {set(found)}")
    known = schema["$defs"]["measures"]
    kinds = {"number": (int, float), "string": str, "array": list}
    for stage in ("wet", "fired"):
        said = found[stage]
        unknown = set(said) - set(known["properties"])
        missing = set(known["required"]) - set(said)
        expect(not unknown and not missing, f"{file}: {stage}: not in the schema {unknown}, missing {missing}")
        for name, value in said.items():
            expect(isinstance(value, kinds[known["properties"][name]["type"]]), f"{file}: {stage}: {name}: {value}")
            expect(known["properties"][name].get("description"), f"schema: {name}: expected a description")


def main():
    folder, schema = Path(sys.argv[1]), json.loads(Path(sys.argv[2]).read_text())
    drawings = sorted(file.stem for file in folder.glob("studio_*.svg"))
    expect(len(drawings) > 5, f"expected drawings in {folder}, found {drawings}")
    for name in drawings:
        check_measures(folder / f"{name}.json", schema)
        print(f"{name}: {check_drawing(folder, name)} walls within {MOST_OFF_MM} mm")


main()
