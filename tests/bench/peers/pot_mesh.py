#!/usr/bin/python3
"""pot_mesh.py PROFILE.csv OUT.glb: the outer face of a thrown pot (onggi throw --profile) as a mesh of 256 rings and 128
sectors, for the peers. glTF 2.0, metres, +Y up."""
import csv
import json
import math
import struct
import sys

RINGS, SECTORS = 256, 128


def resampled(profile):
    """(y, radius) in metres at RINGS even heights."""
    heights = [y for y, _ in profile]
    points, k = [], 0
    for ring in range(RINGS):
        y = heights[0] + (heights[-1] - heights[0]) * ring / (RINGS - 1)
        while k < len(profile) - 2 and heights[k + 1] < y:
            k += 1
        (y0, r0), (y1, r1) = profile[k], profile[k + 1]
        share = (y - y0) / (y1 - y0) if y1 > y0 else 0.0
        points.append((y / 1000.0, (r0 + (r1 - r0) * share) / 1000.0))
    return points


def main():
    with open(sys.argv[1], newline="") as file:
        rows = list(csv.DictReader(file))
    points = resampled([(float(row["y_mm"]), float(row["outer_mm"])) for row in rows])
    positions, normals, indices = [], [], []
    for ring, (y, radius) in enumerate(points):
        (y0, r0), (y1, r1) = points[max(ring - 1, 0)], points[min(ring + 1, RINGS - 1)]
        length = math.hypot(y1 - y0, r1 - r0)
        for sector in range(SECTORS):
            angle = 2.0 * math.pi * sector / SECTORS
            c, s = math.cos(angle), math.sin(angle)
            positions += [radius * c, y, radius * s]
            normals += [(y1 - y0) / length * c, (r0 - r1) / length, (y1 - y0) / length * s]
    for ring in range(RINGS - 1):
        for sector in range(SECTORS):
            a, b = ring * SECTORS + sector, ring * SECTORS + (sector + 1) % SECTORS
            indices += [a, a + SECTORS, b, b, a + SECTORS, b + SECTORS]
    parts = [struct.pack("<%df" % len(positions), *positions), struct.pack("<%df" % len(normals), *normals),
             struct.pack("<%dI" % len(indices), *indices)]
    count = len(positions) // 3
    low = [min(positions[k::3]) for k in range(3)]
    high = [max(positions[k::3]) for k in range(3)]
    offsets = [0, len(parts[0]), len(parts[0]) + len(parts[1])]
    tree = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.36, 0.29, 0.215, 1], "metallicFactor": 0,
                                                    "roughnessFactor": 0.62}}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3", "min": low, "max": high},
                          {"bufferView": 1, "componentType": 5126, "count": count, "type": "VEC3"},
                          {"bufferView": 2, "componentType": 5125, "count": len(indices), "type": "SCALAR"}],
            "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": len(part), "target": target}
                            for at, part, target in zip(offsets, parts, (34962, 34962, 34963))],
            "buffers": [{"byteLength": sum(map(len, parts))}]}
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    binary = b"".join(parts)
    with open(sys.argv[2], "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 28 + len(text) + len(binary)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(binary), 0x004E4942) + binary)


main()
