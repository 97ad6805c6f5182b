#!/usr/bin/env python3
"""layout.py HEADER: prints a C program that lists the binary interface of include/glint/glint.h: the size of each struct,
offset and size of each member, and the value of each constant. tests/abi/layout.txt is its output. A host that was
compiled with an older header relies on every line of it, so members and constants are only ever appended."""
import re
import sys

text = open(sys.argv[1], encoding="utf-8").read()
text = re.sub(r"//[^\n]*", "", text)
lines = []
for name, body in re.findall(r"typedef enum (\w+) \{(.*?)\} \1;", text, re.S):
    for constant in re.findall(r"\b(GLINT_\w+)\b", body):
        lines.append(f'    printf("{constant} %d\\n", (int){constant});')
for name, body in re.findall(r"typedef struct (\w+) \{(.*?)\} \1;", text, re.S):
    lines.append(f'    printf("{name} %zu\\n", sizeof({name}));')
    for member in re.findall(r"(\w+)(?:\[\d+\])?;", body):
        place = f"offsetof({name}, {member}), sizeof((({name}*)0)->{member})"
        lines.append(f'    printf("{name}.{member} %zu %zu\\n", {place});')
assert len(lines) > 300, "the header is not in the form that this script reads"
print("#include <glint/glint.h>\n#include <stdio.h>\n\nint main(void) {")
print("\n".join(lines))
print('    printf("GLINT_C_ABI %u\\n", GLINT_C_ABI);\n    return 0;\n}')
