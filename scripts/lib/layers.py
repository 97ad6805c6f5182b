#!/usr/bin/env python3
"""The layer rules of the house, checked on #include lines and on calls of Vulkan. Prints each breach, fails on any.

The library, src/ and include/:   include/glint <- base <- gpu <- rays <- reflect
                                                   base <- check <- reflect      its check of G-buffers
                                                   base <- c_api                 the interface for C, of include/glint alone
The programs, lab/:   scene <- gbuffer_files, renderer <- job <- sources <- session <- measure <- tune <- cli <- view
Left never includes right, and the library never includes lab/. The programs use the library through include/glint, as
any host does, but for what OPEN_TO_LAB names. Only src/gpu and lab/gpu call Vulkan; lab/view alone sees GLFW and Dear
ImGui.
"""
import re
import subprocess
import sys
from pathlib import Path

# What a layer may include, besides itself and shaders/shared (which belongs to all).
LIBRARY = {
    "include": set(),
    "base": {"include"},
    "check": {"include", "base"},
    "gpu": {"include", "base"},
    "rays": {"include", "base", "gpu"},
    "reflect": {"include", "base", "check", "gpu", "rays"},
    "c_api": {"include", "base"},
    "examples": {"include"},
}
# Parts of the library that hosts do not see and the programs share: messages, files and tables of settings; the device,
# its images and passes; the rules that G-buffers in files are held against.
OPEN_TO_LAB = {"include", "base", "gpu", "check/rules.hpp"}
LAB = {
    "gpu": set(),
    "scene": set(),
    "gbuffer_files": {"scene"},
    "renderer": {"scene", "gpu"},
    "job": {"scene", "renderer"},
    "sources": {"scene", "renderer", "job"},
    "session": {"scene", "gbuffer_files", "renderer", "job", "sources"},
    "measure": {"scene", "renderer", "job", "session"},
    "tune": {"scene", "job", "session", "measure"},
    "cli": {"scene", "job", "sources", "session", "measure", "tune", "view"}, # view: main.cpp names its command
    "view": {"gpu", "scene", "renderer", "job", "session", "measure", "cli"},
}
ALLOWED = {**LIBRARY, **{f"lab/{layer}": {f"lab/{other}" for other in seen} | OPEN_TO_LAB for layer, seen in LAB.items()}}
SOURCE = {".hpp", ".cpp", ".h", ".inl"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
WINDOW_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](?:GLFW/|imgui)')
VULKAN_CALL = re.compile(r"\bvk(?:Cmd|Create|Destroy|Allocate|Free|Queue|Get|Enumerate|Bind|Map|Wait|Reset|Update)\w+\s*\(")


def layer_of(path: Path) -> str | None:
    parts = path.parts
    if parts[:2] == ("include", "glint"):
        return "include"
    if parts[0] == "examples":
        return parts[0]
    if parts[0] == "src" and len(parts) > 2:
        return parts[1]
    if parts[0] == "lab" and len(parts) > 2 and parts[1] not in ("shaders", "tests"):
        return "/".join(parts[:2])
    return None


def target_of(path: Path, bracket: str, name: str, known: set[Path]) -> str | None:
    """The layer that an include line reaches; None for the standard library and packages."""
    if name.startswith("glint/"):
        return "include"
    places = [Path("src") / name, Path(name)] + ([path.parent / name] if bracket == '"' else [])
    for place in places:
        place = Path(*[p for p in place.parts if p != "."])
        if place in known:
            return layer_of(place)
    first = Path(name).parts[0]
    return first if first in ALLOWED and first not in ("include", "examples") else None


def code_only(text: str) -> str:
    """The text without comments and strings, line for line."""
    blank = lambda match: re.sub(r"[^\n]", " ", match.group())
    return re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', blank, text, flags=re.S)


def breaches(path: Path, known: set[Path]):
    layer = layer_of(path)
    if layer is None:
        return
    text = path.read_text(errors="replace")
    if layer not in ALLOWED:
        yield f"{path}: no layer is called {layer}: add it to scripts/lib/layers.py if the design has it"
        return
    for number, line in enumerate(text.splitlines(), 1):
        found = INCLUDE.match(line)
        target = target_of(path, *found.groups(), known) if found else None
        if target and target != layer and target not in ALLOWED[layer] and found.group(2) not in ALLOWED[layer]:
            yield f"{path}:{number}: {layer} includes {found.group(2)} of {target}, which it may not see"
    if layer != "lab/view":
        for number, line in enumerate(text.splitlines(), 1):
            if WINDOW_INCLUDE.match(line):
                yield f"{path}:{number}: GLFW and Dear ImGui belong to lab/view"
    if layer not in ("gpu", "lab/gpu", "include", "examples"):
        for number, line in enumerate(code_only(text).splitlines(), 1):
            if call := VULKAN_CALL.search(line):
                yield f"{path}:{number}: {call.group().rstrip('(').rstrip()} outside src/gpu and lab/gpu: give one of them a function for it"


def main() -> int:
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=True).stdout.splitlines()
    files = {Path(name) for name in listed if Path(name).suffix in SOURCE and Path(name).exists()}
    found = [breach for path in sorted(files) for breach in breaches(path, files)]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
