#!/usr/bin/env python3
"""test_report.py BUILD: prints, after the tests in a build folder ran, which took longest (25 cases, 25 files compiled, each
with its seconds), then every suite with skipped cases, and why they were skipped."""
import collections
import re
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

SHOWN = 25
build = Path(sys.argv[1])
times: dict[str, float] = {}
skipped = collections.defaultdict(collections.Counter)


def first_line(text: str | None) -> str:
    lines = [line for line in (text or "").splitlines() if line.strip() and not re.match(r".*:\d+$", line)]
    return lines[0].strip() if lines else "no reason given"


for file in sorted((build / "test-results").glob("*.xml")):
    for case in xml.parse(file).getroot().iter("testcase"):
        suite = case.get("classname")
        times[f"{suite}.{case.get('name')}"] = float(case.get("time", 0))
        skip = case.find("skipped")
        if skip is not None:
            skipped[suite][first_line(skip.get("message") or skip.text)] += 1
for case in xml.parse(build / "tests.xml").getroot().iter("testcase"):
    name = case.get("name")
    if not (build / "test-results" / (re.sub(r"[^A-Za-z0-9_]+", "_", name) + ".xml")).is_file():
        times[name] = float(case.get("time", 0))
        output = case.find("system-out")
        if case.find("skipped") is not None or case.get("status") == "notrun":
            skipped[name][first_line(output.text if output is not None else None)] += 1

objects = {}
for line in (build / ".ninja_log").read_text().splitlines()[1:]: # the last line of a file is its last build
    start, end, _, output, _ = line.split("\t")
    if re.search(r"\.(o|gch)$", output):
        objects[output] = (int(end) - int(start)) / 1000

for title, rows in (("cases", times), ("files compiled", objects)):
    slowest = sorted(rows.items(), key=lambda row: -row[1])[:SHOWN]
    print(f"The slowest {title}, of {sum(rows.values()):.0f} s in all:")
    print("".join(f"{seconds:8.1f} s  {name}\n" for name, seconds in slowest), end="")
for suite, reasons in sorted(skipped.items()):
    for reason, count in reasons.items():
        print(f"skipped: {suite}, {count} {'case' if count == 1 else 'cases'}: {reason}")
