"""Parts as a GLB (glTF 2.0): a mesh a part, metres. COLOR_0 is (tone, smear, 0, open sky), which is no colour but
what this project's shader wants; other viewers show tinted tools. The same parts give the same bytes."""
import json
import struct

import numpy as np

MATERIALS = {  # base colour (linear), roughness, metalness: of the thing without clay on it
    "skin": ((0.46, 0.265, 0.18), 0.55, 0.0),
    "linen": ((0.50, 0.46, 0.38), 0.95, 0.0),
    "boxwood": ((0.34, 0.19, 0.085), 0.45, 0.0),
    "dark timber": ((0.085, 0.045, 0.026), 0.45, 0.0),
    "sponge": ((0.62, 0.42, 0.16), 1.0, 0.0),
    "brass": ((0.72, 0.52, 0.24), 0.35, 1.0),
    "steel": ((0.56, 0.56, 0.55), 0.30, 1.0),
}


def write(parts, path):
    used = list(dict.fromkeys(part.material for part in parts))
    tree = {"asset": {"version": "2.0", "generator": "onggi assets/tools"}, "scene": 0,
            "scenes": [{"nodes": list(range(len(parts)))}], "nodes": [], "meshes": [], "accessors": [],
            "bufferViews": [], "buffers": [{}],
            "materials": [{"name": name, "pbrMetallicRoughness": {
                "baseColorFactor": [*MATERIALS[name][0], 1.0], "roughnessFactor": MATERIALS[name][1],
                "metallicFactor": MATERIALS[name][2]}} for name in used]}
    binary = bytearray()

    def accessor(array, kind, component, target, **more):
        while len(binary) % 4:
            binary.append(0)
        data = np.ascontiguousarray(array).tobytes()
        tree["bufferViews"].append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data), "target": target})
        binary.extend(data)
        tree["accessors"].append({"bufferView": len(tree["bufferViews"]) - 1, "componentType": component,
                                  "count": len(array), "type": kind, **more})
        return len(tree["accessors"]) - 1

    for number, part in enumerate(parts):
        points = (part.points / 1000.0).astype("<f4")
        colours = np.stack([part.tone, part.smear, np.zeros(len(points)), part.open_sky], axis=1)
        primitive = {"attributes": {
            "POSITION": accessor(points, "VEC3", 5126, 34962, min=points.min(axis=0).tolist(),
                                 max=points.max(axis=0).tolist()),
            "NORMAL": accessor(part.normals.astype("<f4"), "VEC3", 5126, 34962),
            "COLOR_0": accessor(np.round(colours * 255).astype("u1"), "VEC4", 5121, 34962, normalized=True)},
            "indices": accessor(part.faces.astype("<u2").ravel(), "SCALAR", 5123, 34963),
            "material": used.index(part.material)}
        tree["meshes"].append({"name": part.material, "primitives": [primitive]})
        tree["nodes"].append({"name": part.material, "mesh": number})
    while len(binary) % 4:
        binary.append(0)
    tree["buffers"][0]["byteLength"] = len(binary)
    text = json.dumps(tree, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    with open(path, "wb") as file:
        file.write(struct.pack("<III", 0x46546C67, 2, 12 + 8 + len(text) + 8 + len(binary)))
        file.write(struct.pack("<II", len(text), 0x4E4F534A) + text)
        file.write(struct.pack("<II", len(binary), 0x004E4942) + bytes(binary))
