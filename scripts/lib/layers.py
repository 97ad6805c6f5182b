#!/usr/bin/env python3
"""The layer rules of the house, checked on #include lines and on calls of Vulkan. Prints each breach, fails on any.

    include/glint <- base <- gpu <- rays <- reflect             the library
                     base <- check <- reflect                   its check of G-buffers, which scene has too
                     base <- c_api                              its interface for C, made of include/glint alone
                          gpu <- scene <- render <- measure <- tune <- apps
Left never includes right; the library never sees scene, render, measure, tune or apps, and those four beside scene reach
reflect only through include/glint/. Only src/gpu calls Vulkan; apps/view alone sees GLFW and Dear ImGui.
"""
import re
import subprocess
import sys
from pathlib import Path

# What each layer may include, besides itself and shaders/shared (which belongs to all).
ALLOWED = {
    "include": set(),
    "base": {"include"},
    "check": {"include", "base"},
    "gpu": {"include", "base"},
    "rays": {"include", "base", "gpu"},
    "reflect": {"include", "base", "check", "gpu", "rays"},
    "c_api": {"include", "base"},
    "scene": {"include", "base", "check", "gpu"},
    "render": {"include", "base", "gpu", "scene"},
    "measure": {"include", "base", "gpu", "scene", "render"},
    "tune": {"include", "base", "gpu", "scene", "render", "measure"},
    "apps": {"include", "base", "gpu", "scene", "render", "measure", "tune"},
    "examples": {"include"},
}
SOURCE = {".hpp", ".cpp", ".h", ".inl"}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
WINDOW_INCLUDE = re.compile(r'^\s*#\s*include\s*[<"](?:GLFW/|imgui)')
VULKAN_CALL = re.compile(r"\bvk(?:Cmd|Create|Destroy|Allocate|Free|Queue|Get|Enumerate|Bind|Map|Wait|Reset|Update)\w+\s*\(")


def layer_of(path: Path) -> str | None:
    parts = path.parts
    if parts[:2] == ("include", "glint"):
        return "include"
    if parts[0] in ("apps", "examples"):
        return parts[0]
    if parts[0] == "src" and len(parts) > 2:
        return parts[1]
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
        if target and target != layer and target not in ALLOWED[layer]:
            yield f"{path}:{number}: {layer} includes {found.group(2)} of {target}, which it may not see"
    if path.parts[:2] != ("apps", "view"):
        for number, line in enumerate(text.splitlines(), 1):
            if WINDOW_INCLUDE.match(line):
                yield f"{path}:{number}: GLFW and Dear ImGui belong to apps/view"
    if layer not in ("gpu", "include", "examples"):
        for number, line in enumerate(code_only(text).splitlines(), 1):
            if call := VULKAN_CALL.search(line):
                yield f"{path}:{number}: {call.group().rstrip('(').rstrip()} outside src/gpu: give src/gpu a function for it"


def main() -> int:
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=True).stdout.splitlines()
    files = {Path(name) for name in listed if Path(name).suffix in SOURCE and Path(name).exists()}
    found = [breach for path in sorted(files) for breach in breaches(path, files)]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
