#!/usr/bin/env python3
"""Which sources can be compiled as one: unity_groups.py SIZE FILE...  prints a line "GROUP FILE" for each file that has
company. Most of a file's compile time goes into the headers that all of them include, so a group of sixteen costs little
more than four files. Files go together in the given order, neighbours first, where no name that one of them keeps to itself
(in an unnamed namespace, or static) occurs in another one or in its headers; files with macros or an allocator of their
own stay alone. Constants such as the kWidth of many tests would keep many files apart: a line "own NAME" says that several
files have one of that name, and no header, so that each can get a name of its own by a macro."""
import collections
import functools
import re
import sys
from pathlib import Path

TOKENS = re.compile(r"[A-Za-z_]\w*|[{}();=<>\[\],:~]")
NOISE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.S)
TYPES = {"struct", "class", "enum", "union"}


def declared(statement: list[str]) -> str:
    """The name that a statement at the level of a namespace declares, given its tokens up to ; or {."""
    said = [token for token in statement if token not in ("const", "constexpr", "static", "inline", "class", "struct")]
    if not said or re.match(r"(TEST|TYPED_TEST|INSTANTIATE|static_assert)", said[0]):
        return ""  # tests have names that are theirs alone
    if said[0] == "using" and "=" not in said and "namespace" not in said:
        return ""  # a name of another namespace, which all may repeat
    if said[0].startswith("MATCHER") and len(said) > 2:
        return said[2]
    if statement[0] in TYPES | {"using"}:
        return said[1] if said[0] in ("enum", "union", "using") and len(said) > 1 else said[0]
    depth = 0
    for before, token in zip(statement, statement[1:]):
        depth += (before == "<") - (before == ">")
        if depth == 0 and token in ("(", "=", "[") and re.match(r"[A-Za-z_]", before):
            return before
    return next((token for token in reversed(statement) if re.match(r"[A-Za-z_]", token)), "")


def own_names(text: str) -> dict[str, str]:
    """What a source keeps to itself. For another name of a type also which type: two files may say the same."""
    names, statement, scopes = {}, [], []  # scopes: "named", "unnamed" or "body", outermost first
    for match in TOKENS.finditer(text):
        token = match.group()
        if scopes and scopes[-1] == "body":
            scopes += ["body"] if token == "{" else []
            if token == "}":
                scopes.pop()
            continue
        if token in "{;":
            if token == "{" and "namespace" in statement:
                scopes.append("unnamed" if statement[-1] == "namespace" else "named")
            else:
                if "unnamed" in scopes or "static" in statement:
                    names[declared(statement)] = " ".join(statement) if "using" in statement[:1] else ""
                scopes += ["body"] if token == "{" else []
            statement = []
        elif token == "}":
            scopes = scopes[:-1]
            statement = []
        else:
            statement.append(token)
    names.pop("", None)
    return names


ROOT = Path(__file__).resolve().parent.parent
FOLDERS = [ROOT / folder for folder in ("src", "include", "shaders", "tests", "apps/glint", "apps/view")]


@functools.cache
def headers(path: Path) -> frozenset[Path]:
    """Our own headers that a file includes by itself."""
    found = re.findall(r'^\s*#\s*include [<"]([^>"]+)[>"]', path.read_text(), re.M)
    places = [folder / name for name in found for folder in (path.parent, *FOLDERS)]
    return frozenset(place for place in places if place.is_file())


def all_headers(path: Path) -> set[Path]:
    seen, new = set(), {path}
    while new:
        seen |= new
        new = {header for file in new for header in headers(file)} - seen
    return seen - {path}


@functools.cache
def plain(path: Path) -> str:
    """A file's code without comments, strings and directives."""
    return re.sub(r"^\s*#[^\n]*", "", NOISE.sub(" ", path.read_text()), flags=re.M)


@functools.cache
def words(path: Path) -> frozenset[str]:
    """The names by which a file may mean what another one keeps to itself: not those after a dot, an arrow or ::."""
    return frozenset(re.findall(r"(?<![.>:\w])[A-Za-z_]\w*|(?<=[^-]>)[A-Za-z_]\w*|(?<=[^:]:)[A-Za-z_]\w*", plain(path)))


class Source:
    def __init__(self, name: str):
        path = Path(name)
        self.path = path
        self.alone = re.search(r"^\s*#\s*define|\boperator new\b", path.read_text(), re.M) is not None
        self.names = own_names(plain(path))
        self.in_headers = frozenset().union(*map(words, all_headers(path)))
        self.words = words(path) | self.in_headers

    def disturbs(self, other: "Source") -> bool:
        return any(name in other.words and not (said and other.names.get(name) == said) for name, said in self.names.items())

    def goes_with(self, other: "Source") -> bool:
        return not self.disturbs(other) and not other.disturbs(self)


def renamed_constants(sources: list[Source]) -> set[str]:
    """Constants of several sources that no header mentions. The sources get names of their own for them."""
    count = collections.Counter(name for source in sources for name in source.names)
    shared = {name for name in count if count[name] > 1 and re.match("k[A-Z]", name)}
    shared.difference_update(*(source.in_headers for source in sources))
    for source in sources:
        source.names = {name: said for name, said in source.names.items() if name not in shared}
        source.words -= shared
    return shared


size = int(sys.argv[1])
sources = list(map(Source, sys.argv[2:]))
for name in sorted(renamed_constants(sources)):
    print("own", name)
groups: list[list[Source]] = []
for source in sources:
    if source.alone:
        continue
    for group in groups:
        if len(group) < size and all(source.goes_with(other) for other in group):
            group.append(source)
            break
    else:
        groups.append([source])
for number, group in enumerate(group for group in groups if len(group) > 1):
    for source in group:
        print(number, source.path)
