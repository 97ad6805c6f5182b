#!/usr/bin/env python3
"""Every file that others copy into their own projects states its licence, and THIRD-PARTY.md names every package that
packages.sh installs. Prints each that is missing, fails on any.

Copied are the public headers and the example host: the first line of each is the SPDX line. Everything else in the
repository is covered by LICENSE at its root.
"""
import re
import subprocess
import sys
from pathlib import Path

COPIED = ("include/glint", "examples/embed", "examples/embed-c")
SPDX = "SPDX-License-Identifier: MIT"
COMMENT = {".hpp": "//", ".cpp": "//", ".h": "//", ".c": "//", ".txt": "#"}


def without_licence():
    listed = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "--", *COPIED],
                            capture_output=True, text=True, check=True).stdout.splitlines()
    for path in filter(Path.is_file, map(Path, sorted(listed))):
        line = f"{COMMENT[path.suffix]} {SPDX}" if path.suffix in COMMENT else SPDX
        if path.read_text(errors="replace").partition("\n")[0] != line:
            yield f"{path}:1: the first line must be '{line}'"


def without_notice():
    script = Path("scripts/lib/packages.sh").read_text()
    packages = re.search(r"build_packages=\((.*?)\n\)", script, re.S).group(1)
    named = set(re.findall(r"`([a-z0-9.+-]+)`", Path("THIRD-PARTY.md").read_text()))
    for package in re.sub(r"#[^\n]*", "", packages).split():
        if package not in named:
            yield f"THIRD-PARTY.md: the package {package} of scripts/lib/packages.sh is missing"


def main() -> int:
    found = [*without_licence(), *without_notice()]
    if "MIT License" not in Path("LICENSE").read_text():
        found.append("LICENSE: is not the MIT licence that the SPDX lines name")
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
