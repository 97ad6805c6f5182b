#!/usr/bin/env python3
"""clang-tidy over every source file of a build folder, in parallel; a file that passed is not looked at again until it,
a header that it includes, its compile command or .clang-tidy changes. Files that the build compiles as one (GLINT_UNITY)
are read as one: most of the time goes into their headers.    tidy.py CLANG-TIDY BUILD-FOLDER"""
import concurrent.futures
import hashlib
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path.cwd().resolve()
OURS = ("src/", "lab/", "examples/", "bench/")
TESTS = ("lab/tests/",)  # held by warnings and sanitizers: they would double the time


def our_files(text: str) -> list[str]:
    """The paths in `ninja -t deps` output that lie in the repository, built folders aside."""
    found = []
    for line in text.splitlines():
        if line.startswith("    "):
            path = Path(os.path.normpath(build / line.strip()))
            if path.is_relative_to(ROOT) and not path.is_relative_to(build):
                found.append(str(path))
    return sorted(found)


def fingerprint(entry: dict) -> str:
    """Of everything of ours that the verdict on one file depends on."""
    deps = subprocess.run(["ninja", "-C", str(build), "-t", "deps", entry["output"]], capture_output=True, text=True)
    digest = hashlib.sha256((entry["command"] + tidy).encode())
    for path in [str(ROOT / ".clang-tidy"), entry["file"], *our_files(deps.stdout)]:
        digest.update(Path(path).read_bytes())
    return digest.hexdigest()


def sources(entry: dict) -> list[str]:
    """What an entry compiles, relative to the root: one file, or those that a file of the build folder includes."""
    files = [entry["file"]]
    if Path(entry["file"]).is_relative_to(build) and "/Unity/" in entry["file"]:
        files = re.findall(r'^#include "(.*)"', Path(entry["file"]).read_text(), re.M)
    return [os.path.relpath(file, ROOT) for file in files]


def without_precompiled(command: str) -> str:
    """The command with a copy of each precompiled header's text in its place: clang takes GCC's for a broken one."""
    def copied(found: re.Match) -> str:
        header = Path(found.group(1))
        copy = build / "tidy" / f"{header.parent.name}.hxx"
        if header.exists():
            copy.write_text(header.read_text())
        return f"-include {copy if copy.exists() else header}"
    return re.sub(r"-include (\S+cmake_pch\.hxx)", copied, command)


def check(entry: dict) -> str:
    """What clang-tidy says against an entry's files: nothing if they are clean."""
    stamp = build / "tidy" / fingerprint(entry)
    if stamp.exists():
        return ""
    run = subprocess.run([tidy, "-p", str(build / "tidy"), "--quiet", "--extra-arg=-Wno-unknown-warning-option",
                          "--checks=-bugprone-suspicious-include",  # what the files that are read as one consist of
                          "--extra-arg=-Wno-ignored-optimization-argument", entry["file"]], capture_output=True, text=True)
    if run.returncode == 0:
        stamp.touch()
        return ""
    return (run.stdout or run.stderr).strip()


tidy, build = sys.argv[1], Path(sys.argv[2]).resolve()
(build / "tidy").mkdir(exist_ok=True)
entries = []
for entry in json.loads((build / "compile_commands.json").read_text()):
    entry["file"] = os.path.normpath(os.path.join(entry["directory"], entry["file"]))
    output = re.search(r" -o (\S+)", entry["command"])
    entry["output"] = output.group(1) if output else ""
    if all(source.startswith(OURS) and not source.startswith(TESTS) for source in sources(entry)):
        entries.append(entry)
entries = list({entry["file"]: entry for entry in entries}.values())
commands = [entry | {"command": without_precompiled(entry["command"])} for entry in entries]
(build / "tidy" / "compile_commands.json").write_text(json.dumps(commands))
bad = 0
with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
    for complaint in pool.map(check, entries):
        if complaint:
            bad += 1
            print(complaint, flush=True)
sys.exit(1 if bad else 0)
