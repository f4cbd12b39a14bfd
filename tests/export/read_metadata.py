"""read_metadata.py FOLDER [EXIFTOOL [FFPROBE]]: what the files named `told` of make_pots say about themselves, by readers that
share no code with their writers: exiftool for PNG, WebP, MP4 and SVG, ffprobe for MP4, Python's zipfile for 3MF and USDZ, its XML
parser and its JSON for GLB. Missing programs are empty words."""

import json
import re
import struct
import subprocess
import sys
import xml.etree.ElementTree as xml
import zipfile
from pathlib import Path

MODEL = "{http://schemas.microsoft.com/3dmanufacturing/core/2015/02}"
TERMS = {
    "Title": "Moon jar, celadon",
    "Title-ko": "달항아리, 청자",
    "Title-ar": "جرة القمر، سيلادون",
    "Description": "Thrown & fired.",
    "Rights": "CC BY 4.0",
    "Rights-ko": "저작자표시 4.0",
    "Publisher": ["House of Clay", "흙의 집"],
    "Date": "2026-11-28",
    "Identifier": "onggi-session:0123456789abcdef",
    "Relation": "Moon jar, British Museum (1333756)",
}


def expect(found, wanted, where):
    if found != wanted:
        sys.exit(f"{where}: expected {wanted!r}, found {found!r}")


def check_picture(exiftool, picture):
    report = subprocess.run([exiftool, "-json", "-charset", "utf8", "-XMP:all", str(picture)],
                            check=True, capture_output=True, text=True, encoding="utf8")
    said = json.loads(report.stdout)[0]
    for term, wanted in TERMS.items():
        found = said.get(term)
        expect(found.replace(":", "-") if term == "Date" else found, wanted, f"{picture}: {term}")
    known = {term.split("-")[0] for term in TERMS} | {"SourceFile", "CreatorTool"}
    expect({term.split("-")[0] for term in said} - known, set(), f"{picture}: nothing else")


def check_film(ffprobe, film):
    report = subprocess.run([ffprobe, "-v", "error", "-count_frames", "-show_streams", "-show_format", "-of", "json", str(film)],
                            check=True, capture_output=True, text=True, encoding="utf8")
    expect(report.stderr, "", f"{film}: no complaint")
    found = json.loads(report.stdout)
    (video,) = found["streams"]
    for term, wanted in {"codec_name": "h264", "pix_fmt": "yuv420p", "color_range": "tv", "color_space": "smpte170m",
                         "color_primaries": "bt709", "color_transfer": "iec61966-2-1", "width": 64, "height": 64,
                         "avg_frame_rate": "25/2", "nb_read_frames": "2", "start_pts": 0, "has_b_frames": 0}.items():
        expect(video[term], wanted, f"{film}: {term}")
    expect(found["format"]["duration"], "0.160000", f"{film}: duration")
    tags = found["format"]["tags"]
    for term, wanted in {"title": "Moon jar, celadon", "description": "Thrown & fired.", "date": "2026-11-28",
                         "copyright": "House of Clay. CC BY 4.0"}.items():
        expect(tags.get(term), wanted, f"{film}: {term}")
    expect(set(tags) - {"major_brand", "minor_version", "compatible_brands", "title", "description", "date", "copyright",
                        "encoder"}, set(), f"{film}: nothing else")


def check_3mf(file):
    with zipfile.ZipFile(file) as archive:
        for entry in archive.infolist():
            expect(entry.date_time[:3], (1980, 1, 1), f"{file}: {entry.filename}: date")
        model = xml.fromstring(archive.read("3D/3dmodel.model"))
    said = {entry.get("name"): entry.text for entry in model.iter(MODEL + "metadata")}
    expect(said.pop("Title").rsplit(",", 1)[0], "Moon jar, celadon", f"{file}: Title")
    expect(said.pop("Description").startswith("Thrown & fired."), True, f"{file}: Description")
    expect(said.pop("Application").startswith("Onggi "), True, f"{file}: Application")
    expect(said, {"Copyright": "House of Clay", "LicenseTerms": "CC BY 4.0", "CreationDate": "2026-11-28"}, f"{file}")


def check_glb(file):
    data = file.read_bytes()
    (length,) = struct.unpack_from("<I", data, 12)
    model = json.loads(data[20:20 + length])
    expect(model["asset"]["copyright"], "House of Clay. CC BY 4.0", f"{file}: copyright")
    packet = model["extensions"]["KHR_xmp_json_ld"]["packets"][0]
    titles = {item["@language"]: item["@value"] for key, item in packet["dc:title"].items() if key != "@type"}
    expect(titles["ko"], TERMS["Title-ko"], f"{file}: title")
    expect(packet["dc:rights"]["rdf:_1"]["@value"], "CC BY 4.0", f"{file}: rights")
    node = model["nodes"][0]
    expect((node["name"], model["scenes"][0]["name"]), ("Moon jar, celadon",) * 2, f"{file}: names")
    expect(node["extras"], model["asset"]["extras"], f"{file}: extras of node and asset")
    expect(node["extras"]["session_hash"], "0123456789abcdef", f"{file}: session")


def check_usdz(file):
    data = file.read_bytes()
    with zipfile.ZipFile(file) as archive:
        expect(archive.testzip(), None, f"{file}: checksums")
        for entry in archive.infolist():
            name_and_extra = sum(struct.unpack_from("<2H", data, entry.header_offset + 26))
            expect((entry.header_offset + 30 + name_and_extra) % 64, 0, f"{file}: {entry.filename}: place")
            expect(entry.compress_type, zipfile.ZIP_STORED, f"{file}: {entry.filename}: compression")
        names = archive.namelist()
        scene = archive.read(names[0]).decode()
    expect(names[0], "pot.usda", f"{file}: first file")
    expect(sorted(re.findall("@([^@]*)@", scene)), sorted(names[1:]), f"{file}: pictures")
    said = dict(re.findall(r'string "([^"]*)" = "([^"]*)"', scene))
    for term in ("Title", "Title-ko", "Title-ar", "Description", "Rights", "Rights-ko", "Date", "Identifier", "Relation"):
        expect(said.pop(term.lower(), None), TERMS[term], f"{file}: {term}")
    expect(said.pop("copyright"), "House of Clay. CC BY 4.0", f"{file}: copyright")
    expect(said.pop("onggi-session_hash"), "0123456789abcdef", f"{file}: session")
    known = {"creator", "publisher", "publisher-en", "publisher-ko", "title-en", "description-en", "description-ko",
             "rights-en", "onggi-body", "onggi-stage", "onggi-glaze", "onggi-date"}
    expect(set(said) - known, set(), f"{file}: nothing else")


def main():
    folder = Path(sys.argv[1])
    check_glb(folder / "told.glb")
    check_3mf(folder / "told.3mf")
    check_usdz(folder / "told.usdz")
    exiftool, ffprobe = (sys.argv[2:] + ["", ""])[:2]
    if exiftool:
        for name in ("told.png", "told.webp", "told.mp4", "told.svg"):
            check_picture(exiftool, folder / name)
    if ffprobe:
        check_film(ffprobe, folder / "told.mp4")


main()
