#!/usr/bin/env python3
"""Every relative link and picture in our Markdown leads to a file that exists, and every #anchor to a heading of it.
Prints each link that does not, fails on any."""
import re
import subprocess
import sys
from pathlib import Path
from urllib.parse import unquote

LINK = re.compile(r"!?\[[^\]]*\]\(\s*<?([^)>\s]+)>?(?:\s+\"[^\"]*\")?\s*\)")
HTML_LINK = re.compile(r"<(?:a|img|source)\b[^>]*?\b(?:href|src|srcset)=\"([^\"]+)\"")
FENCE = re.compile(r"^(```|~~~).*?^\1[^\n]*$", re.S | re.M)


def anchors(path: Path) -> set[str]:
    """The names that a forge gives to a page's headings."""
    seen: dict[str, int] = {}
    names = set()
    for heading in re.findall(r"^#{1,6}\s+(.*?)\s*#*$", FENCE.sub("", path.read_text()), flags=re.M):
        plain = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading).lower()
        name = re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")
        names.add(name if name not in seen else f"{name}-{seen[name]}")
        seen[name] = seen.get(name, 0) + 1
    return names | set(re.findall(r"<a (?:id|name)=\"([^\"]+)\"", path.read_text()))


def broken(page: Path):
    hide = lambda match: re.sub(r"[^\n]", " ", match.group())
    text = re.sub(r"`[^`\n]*`", hide, FENCE.sub(hide, page.read_text()))
    for pattern in (LINK, HTML_LINK):
        for match in pattern.finditer(text):
            link = match.group(1)
            if re.match(r"[a-z][a-z0-9+.-]*:|//", link, re.I):
                continue
            name, _, anchor = link.partition("#")
            target = (Path(name.lstrip("/")) if name.startswith("/") else page.parent / unquote(name)) if name else page
            line = text.count("\n", 0, match.start()) + 1
            if not target.exists():
                yield f"{page}:{line}: {link} leads nowhere"
            elif anchor and target.suffix == ".md" and anchor not in anchors(target):
                yield f"{page}:{line}: {link}: no such heading in {target}"


def main() -> int:
    pages = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard", "*.md"],
                           capture_output=True, text=True, check=True).stdout.splitlines()
    found = [problem for page in pages if Path(page).exists() for problem in broken(Path(page))]
    print("\n".join(found), end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
