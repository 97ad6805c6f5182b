#!/usr/bin/env python3
"""Every file of the repository that a comment or a page names by its path exists: src/reflect/frame.cpp,
shared/outcome.h, docs/settings.md. Prints each that does not, fails on any.

A path has a folder and one of our endings. It may be said from the top, from the folder of the file that says it, or as
an #include says it (any tail of a file's path). What is written in strings and code is the compiler's matter.
"""
import re
import subprocess
import sys
from pathlib import Path

CODE = {".hpp", ".cpp", ".h", ".inl", ".c", ".glsl", ".comp", ".vert", ".frag"}
SCRIPT = {".py", ".cmake", ".sh", ".txt"}
NAMED = r"(?:hpp|cpp|h|inl|glsl|comp|vert|frag|md|json|py|cmake|sh)"
PATH = re.compile(r"(?<![\w./:~$\-*{}<>])((?:\.\.?/)*[\w.\-]+(?:/[\w.\-]+)+\." + NAMED + r")(?![\w/*<{])")
# Made by a build or a run, files of other projects, and ROOT or FOLDER in capitals for one that the reader knows.
FOREIGN = re.compile(r"^(?:[A-Z_]+|build|out|\.deps|vulkan|glm|fmt|GLFW|gtest|gmock|nlohmann|usr)/")


def comments(path: Path, text: str) -> str:
    """The text with all but comments blanked, line for line; a page is all comment but for its fenced blocks."""
    blank = lambda s: re.sub(r"[^\n]", " ", s)
    if path.suffix == ".md":
        return re.sub(r"^(```|~~~).*?^\1[^\n]*$", lambda m: blank(m.group()), text, flags=re.S | re.M)
    if path.suffix in CODE:
        token = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.S)
    else:
        token = re.compile(r'#[^\n]*|""".*?"""|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)
    out, end = [], 0
    for match in token.finditer(text):
        word = match.group()
        is_comment = word[0] in "/#" or word.startswith('"""')
        out += [blank(text[end:match.start()]), word if is_comment else blank(word)]
        end = match.end()
    return "".join(out) + blank(text[end:])


def missing(path: Path, files: set[str], tails: set[str]):
    said = comments(path, path.read_text(errors="replace"))
    for match in PATH.finditer(said):
        name = match.group(1)
        plain = re.sub(r"^(?:\.\.?/)+", "", name)
        beside = str(Path(*path.parent.parts, name)) if path.parent.parts else name
        if FOREIGN.match(name) or plain in tails or plain in files or Path(beside).exists():
            continue
        yield f"{path}:{said.count(chr(10), 0, match.start()) + 1}: no file is called {name}"


def main() -> int:
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"],
                            capture_output=True, text=True, check=True).stdout.splitlines()
    files = {name for name in listed if Path(name).is_file()}
    tails = {"/".join(parts[i:]) for name in files for parts in [name.split("/")] for i in range(len(parts) - 1)}
    wanted = [Path(name) for name in sorted(files) if Path(name).suffix in CODE | SCRIPT | {".md"}
              or name.startswith("scripts/") and "." not in Path(name).name]
    found = [problem for path in wanted for problem in missing(path, files, tails)]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
