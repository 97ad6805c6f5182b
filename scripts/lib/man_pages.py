#!/usr/bin/env python3
"""man_pages.py PROGRAM FOLDER: writes glint.1 and a page for each command, glint-render.1 and so on, from what the program
says with --help. The build runs it (cmake/GlintInstall.cmake)."""
import re
import subprocess
import sys
from pathlib import Path


def said(program: str, *arguments: str) -> str:
    return subprocess.run([program, *arguments], capture_output=True, text=True, check=True).stdout


def roff(text: str) -> str:
    """Text as man shows it, letter by letter: no escape, no request, and hyphens that can be copied."""
    text = text.replace("\\", "\\e").replace("-", "\\-").replace("'", "\\(aq").replace("`", "\\(ga")
    return re.sub(r"^(?=[.'])", r"\\&", text, flags=re.M)


def items(body: str) -> list[str]:
    """Lines of two columns, a name and its text, as tagged paragraphs. A long name has its text in the next line."""
    lines = []
    for line in body.splitlines():
        name, text = re.fullmatch(r"(?:  (\S.*?))?(?:\s{2,}(\S.*))?", line).groups()
        lines += [".TP", f".B {roff(name)}"] if name else []
        lines += [roff(text)] if text else []
    return lines


def page(name: str, version: str, help_text: str, see_also: list[str]) -> str:
    # CLI11 2.4 and older write "Usage: glint ..." below the purpose, newer ones "glint ..." in a paragraph of its own.
    purpose, usage, sections = re.fullmatch(r"(.*?)\n\s*(?:Usage: )?(glint [^\n]*)\n(.*)", help_text, re.S).groups()
    purpose = " ".join(purpose.split())
    blocks = [block for block in re.split(r"\n\s*\n", sections.strip("\n")) if block.strip()]
    first = purpose.partition(": ")[0].rstrip(".")
    lines = [f'.TH {name.upper()} 1 "" "glint {version}"', ".SH NAME", f"{roff(name)} \\- {roff(first)}"]
    lines += [".SH SYNOPSIS", roff(usage), ".SH DESCRIPTION", roff(purpose)]
    for block in blocks:
        title, _, body = block.strip("\n").partition("\n")
        lines += [f".SH {roff(title.rstrip(':').upper())}", *items(body)]
    lines += [".SH SEE ALSO", ", ".join(f"{roff(other)}(1)" for other in see_also if other != name)]
    return "\n".join(lines) + "\n"


def main() -> int:
    program, folder = sys.argv[1], Path(sys.argv[2])
    version = said(program, "--version").split()[-1]
    overview = said(program, "--help")
    listed = re.split(r"(?i)\nSubcommands:", overview)[-1]
    commands = re.findall(r"^  (\w[\w-]*)", listed, re.M)
    if len(commands) < 3:
        sys.exit(f"{program} --help names no commands in the form that this script reads")
    names = ["glint"] + [f"glint-{command}" for command in commands]
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "glint.1").write_text(page("glint", version, overview, names))
    for command in commands:
        (folder / f"glint-{command}.1").write_text(
            page(f"glint-{command}", version, said(program, command, "--help"), names))
    return 0


if __name__ == "__main__":
    sys.exit(main())
