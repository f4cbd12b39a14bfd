"""cameras.json: the kiosk's fixed cameras. The engine reads the same file."""
import json
import pathlib

FILE = pathlib.Path(__file__).resolve().parent.parent / "cameras.json"


def load():
    """{name: {"eye_mm", "target_mm", "vertical_fov_rad", "size"}}, in the game's frame.
    With "middle_of" a camera has the eye, target and angle of a wider one, and its plate is cut from that. With
    "larger_than" it is another one but for the size of its plates, which not every room has."""
    cameras = json.loads(FILE.read_text())["cameras"]
    cameras = {name: {**cameras.get(spec.get("larger_than"), {}), **spec} for name, spec in cameras.items()}
    for name, spec in cameras.items():
        wider = cameras.get(spec.get("middle_of"))
        if "middle_of" in spec and not (wider and all(spec[k] == wider[k] for k in ("eye_mm", "target_mm", "vertical_fov_rad"))
                                        and spec["size"][0] * wider["size"][1] <= wider["size"][0] * spec["size"][1]):
            raise ValueError("%s: %s: expected the view of a wider camera for middle_of" % (FILE, name))
    return cameras
