#!/usr/bin/env python3
"""Lengths of the functions in shaders: at most 80 lines, from the name to the closing brace, and 8 parameters. Prints
each longer one as "FILE:LINE: NAME has N lines, more than 80" or "... N parameters, more than 8"; fails on any.

    shader_lengths.py [FOLDER ...]      shaders and lab/shaders by default, from the root of the repository
"""
import re
import sys
from pathlib import Path

MOST_LINES = 80
MOST_PARAMETERS = 8
SUFFIXES = {".glsl", ".comp", ".frag", ".vert", ".h"}
# A definition begins at the margin: its type, its name, its parameters (which may span lines), a brace.
TYPE = r"^(?!struct\b|layout\b|const\b)\w[\w \t]*?[ \t]"
PARAMETERS = r"\(([^;{}()]*(?:\([^()]*\)[^;{}()]*)*)\)"
DEFINITION = re.compile(TYPE + r"(\w+)" + PARAMETERS + r"\s*\{", re.M)


def without_comments(text: str) -> str:
    """The text with blanks for comments, line for line."""
    return re.sub(r"//[^\n]*|/\*.*?\*/", lambda match: re.sub(r"[^\n]", " ", match.group()), text, flags=re.S)


def closing_brace(text: str, opening: int) -> int:
    depth = 0
    for at in range(opening, len(text)):
        depth += {"{": 1, "}": -1}.get(text[at], 0)
        if depth == 0:
            return at
    return len(text) - 1


def functions(text: str):
    """Name, first line, number of lines and number of parameters of each function."""
    text = without_comments(text)
    for found in DEFINITION.finditer(text):
        end = closing_brace(text, found.end() - 1)
        lines = text.count("\n", found.start(), end) + 1
        parameters = found.group(2).strip()
        count = 0 if parameters in ("", "void") else parameters.count(",") + 1
        yield found.group(1), text.count("\n", 0, found.start()) + 1, lines, count


def breaches(path: Path):
    for name, line, lines, parameters in functions(path.read_text()):
        if lines > MOST_LINES:
            yield f"{path}:{line}: {name} has {lines} lines, more than {MOST_LINES}"
        if parameters > MOST_PARAMETERS:
            yield f"{path}:{line}: {name} has {parameters} parameters, more than {MOST_PARAMETERS}"


def main() -> int:
    folders = [Path(name) for name in sys.argv[1:] or ["shaders", "lab/shaders"]]
    files = sorted(file for folder in folders for file in folder.rglob("*") if file.suffix in SUFFIXES)
    if not files:
        print("shader_lengths.py: no shaders in", ", ".join(map(str, folders)))
        return 1
    found = [breach for file in files for breach in breaches(file)]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
