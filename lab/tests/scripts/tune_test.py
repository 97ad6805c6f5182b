#!/usr/bin/env python3
"""tune_test.py FOLDER RUN PROGRAM: small searches by the program, their files and their exit codes."""
import base64
import json
import shutil
import struct
import subprocess
import sys
from pathlib import Path


def expect(what: str, true: bool, seen: object = "") -> None:
    if not true:
        sys.exit(f"failed: {what}: {seen}")


def write_scene(path: Path, roughness: float) -> None:
    """A square that reflects, as one glTF file."""
    corners = [(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)]
    data = b"".join(struct.pack("<3f", *corner) for corner in corners) + struct.pack("<3f", 0, 0, 1) * 4
    data += struct.pack("<6H", 0, 1, 2, 0, 2, 3)
    path.write_text(json.dumps({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"metallicFactor": 1, "roughnessFactor": roughness}}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC3"},
                      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 48},
                        {"buffer": 0, "byteOffset": 96, "byteLength": 12}],
        "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
    }))


class Tune:
    def __init__(self, folder: Path, run: str, program: str):
        self.folder, self.program = folder, [run, program]

    def run(self, *arguments: str, status: int = 0) -> subprocess.CompletedProcess:
        small = ["--size", "64x36", "--generations", "0", "--population", "8", "--presets", "none", "--reference-frames", "1",
                 "--cost", "counted"]
        return self.call("tune", *arguments, *small, status=status)

    def call(self, *arguments: str, status: int = 0) -> subprocess.CompletedProcess:
        ended = subprocess.run([*self.program, *arguments], cwd=self.folder, capture_output=True, text=True, timeout=280)
        expect(f"glint {' '.join(arguments)} ends with {status}", ended.returncode == status, ended.stdout + ended.stderr)
        return ended


def test_resume(tune: Tune) -> None:
    """A state file goes with the contents of the scene's file, not with its name."""
    scene = tune.folder / "scene.gltf"
    search = ["scene.gltf", "--budget", "1", "--vary", "hiz.minLevel", "--resume", "state.json"]
    write_scene(scene, 0.1)
    first = tune.run(*search)
    state = (tune.folder / "state.json").read_bytes()
    expect("the same search goes on", tune.run(*search).stdout == first.stdout)
    write_scene(scene, 0.3)
    refused = tune.run(*search, status=2).stderr
    expect("another scene under the same name is refused", "state.json: the state of a search with other scenes, contents of files"
           in refused and refused.count("\n") == 1, refused)
    expect("the state file stays", (tune.folder / "state.json").read_bytes() == state)
    write_scene(scene, 0.1)
    tune.run(*search)


def test_start(tune: Tune) -> None:
    """What the page says of a point draws the picture of the settings that were found."""
    tune.run("builtin:exact", "--budget", "0.9", "--vary", "screen.thicknessMode,hiz.minLevel", "--start",
             "fast+screen.step=3,screen.thicknessMode=backface", "--set", "fade.border=none", "--json", "curve.json", "-o", "tuned.json")
    tune.call("report", "builtin:exact", "--size", "64x36", "--config", "fast", "--reference", "none", "--frames", "1",
              "--motion-frames", "0", "--curve", "curve.json", "-o", "page.html", "--json", "page.json")
    curve = json.loads((tune.folder / "page.json").read_text())["curve"]
    point = next(point for point in curve["points"] if point["chosen"])
    expect("settings of --set and --start are there", {"fade.border=none", "screen.step=3"} <= set(point["assignments"]), point)
    picture = ["render", "builtin:exact", "--size", "64x36"]
    tune.call(*picture, "-o", "page.png", "--preset", curve["preset"],
              *(word for text in point["assignments"] for word in ("--set", text)))
    tune.call(*picture, "-o", "tuned.png", "--settings", "tuned.json")
    expect("the command draws the settings found", (tune.folder / "page.png").read_bytes()
           == (tune.folder / "tuned.png").read_bytes())


def test_missed_target(tune: Tune) -> None:
    """The best that was found is written, and the exit code says that it is not what was asked for."""
    ended = tune.run("builtin:exact", "--max-error", "1e-9", "--vary", "screen.march", "-o", "missed.json", "--json", "missed_curve.json",
                     status=1)
    expect("one line says so", ended.stderr.count("glint: error: nothing that was tried meets the target, error at most") == 1
           and ended.stderr.endswith("--generations\n"), ended.stderr)
    curve = json.loads((tune.folder / "missed_curve.json").read_text())
    expect("the curve is written", curve["met"] is False, curve)
    expect("and the settings", "description" in json.loads((tune.folder / "missed.json").read_text()))
    tried = [point["settings"].get("screen.march") for point in curve["points"]]
    expect("without probes no proxy is tried", tried and "proxy" not in tried and curve["tried"] == 3, curve)


if __name__ == "__main__":
    folder, run, program = (Path(word).resolve() for word in sys.argv[1:4])
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    tune = Tune(folder, str(run), str(program))
    test_resume(tune)
    test_start(tune)
    test_missed_target(tune)
