#!/usr/bin/env python3
"""Puts the browser edition into one page: make_page.py SOURCE_FOLDER BUILD_FOLDER PAGE

The program (moltact.wasm), its files (lessons, molecules, models, translations, fonts) and the worker for simulations
(moltact_openmm.js, simulation_worker.js, moltact_openmm.wasm) stand in the page packed by gzip, in base64; page.js
unpacks them, the worker only when a scene needs it. platform.js and classroom.js stand there as text, which page.js runs only in a
page packed for a learning platform, or served by a class. The files are one run of bytes behind a table: four bytes of its length, least
first, then [[path, bytes], ...] as JSON.
"""
import base64
import gzip
import json
import pathlib
import struct
import sys

FONTS = ["/usr/share/fonts/opentype/inter/Inter-Regular.otf", "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
         "/usr/share/fonts/opentype/inter/Inter-Italic.otf", "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"]


def files(source, build):
    for folder in ["lessons", "molecules", "assets/models"]:
        for path in sorted((source / folder).iterdir()):
            if path.is_file():
                yield f"/moltact/{folder}/{path.name}", path.read_bytes()
    for path in sorted((build / "translations").glob("*.mo")):
        yield f"/moltact/translations/{path.name}", path.read_bytes()
    for font in FONTS:
        yield font, pathlib.Path(font).read_bytes()


def packed(data):
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode()


def in_script(text):
    return text.replace("</script", "<\\/script")


def main():
    source, build, page = (pathlib.Path(a) for a in sys.argv[1:4])
    here = source / "app" / "web"
    table, run = [], b""
    for path, data in files(source, build):
        table.append([path, len(data)])
        run += data
    head = json.dumps(table).encode()
    parts = {
        "ICON": base64.b64encode((source / "assets" / "icon.png").read_bytes()).decode(),
        "PROGRAM": packed((build / "moltact.wasm").read_bytes()),
        "FILES": packed(struct.pack("<I", len(head)) + head + run),
        "SIMULATION_PROGRAM": packed((build / "moltact_openmm.wasm").read_bytes()),
        "SIMULATION_SCRIPT": packed((build / "moltact_openmm.js").read_bytes() + (here / "simulation_worker.js").read_bytes()),
        "PLATFORM": in_script((here / "platform.js").read_text()),
        "CLASSROOM": in_script((here / "classroom.js").read_text()),
        "LOADER": in_script((build / "moltact.js").read_text()),
        "DEVICES": in_script((here / "devices.js").read_text()),
        "SIMULATION": in_script((here / "simulation.js").read_text()),
        "SENTENCES": in_script((here / "sentences.js").read_text()),
        "PAGE": in_script((here / "page.js").read_text()),
    }
    text = (here / "page.html").read_text()
    for name, part in parts.items():
        before, mark, after = text.partition(f"@{name}@")
        if not mark:
            raise SystemExit(f"page.html has no place @{name}@")
        text = before + part + after
    page.write_text(text)
    print(f"moltact.html: {page.stat().st_size / 2**20:.2f} MiB")


if __name__ == "__main__":
    main()
