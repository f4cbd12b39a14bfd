"""cameras.json: the kiosk's fixed cameras. The engine reads the same file."""
import json
import pathlib

FILE = pathlib.Path(__file__).resolve().parent.parent / "cameras.json"


def load():
    """{name: {"eye_mm", "target_mm", "vertical_fov_rad", "size"}}, in the game's frame."""
    return json.loads(FILE.read_text())["cameras"]
