#!/usr/bin/env python3
"""count_tests.py REPORT FOLDER  prints how many cases passed, failed and were skipped. REPORT is CTest's, in JUnit's
form; FOLDER holds GoogleTest's own for those of its tests that are whole suites (cmake/list_tests.cmake). A test without
such a file is one case, and one that failed though its cases did not (it crashed, or leaked) is one failure more."""
import re
import sys
import xml.etree.ElementTree as xml
from pathlib import Path

report, folder = Path(sys.argv[1]), Path(sys.argv[2])
passed = failed = skipped = 0
for test in xml.parse(report).getroot().iter("testcase"):
    cases = folder / (re.sub(r"[^A-Za-z0-9_]+", "_", test.get("name")) + ".xml")
    bad = test.find("failure") is not None or test.find("error") is not None
    if cases.is_file():
        failures = 0
        for case in xml.parse(cases).getroot().iter("testcase"):
            if case.get("status") != "run":
                continue
            failures += case.find("failure") is not None
            skipped += case.get("result") == "skipped"
            passed += case.find("failure") is None and case.get("result") != "skipped"
        failed += max(failures, bad)
    elif bad:
        failed += 1
    elif test.find("skipped") is not None or test.get("status") in ("disabled", "notrun"):
        skipped += 1
    else:
        passed += 1
print(passed, failed, skipped)
