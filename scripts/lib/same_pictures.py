#!/usr/bin/env python3
"""Did a change leave every picture and every figure as it was, bit for bit?

    scripts/lib/same_pictures.py record PROGRAM FOLDER      before the change
    scripts/lib/same_pictures.py check PROGRAM FOLDER       after it
        --jobs N       programs at a time (2)
        --only REGEX   cases whose name it matches; `list` instead of `record` or `check` prints all names

PROGRAM is a built `glint`, as in build/dev/bin/glint; copy it out of the build folder first if the next build replaces
it. `record` runs it once for each case and keeps all files that it writes in FOLDER/recorded. A case is one command
line: `glint render` of every built-in scene with every preset, all views in one EXR file; every view of every scene as
a PNG; the settings that the presets leave alone (sources, antialiasing, sampling of frames); compare, inspect, bench,
bake and settings. `check` runs the recorded cases and compares: pictures, reports and everything else byte for byte;
JSON value for value, but for times (and of `glint bench` the names alone); HTML without its numbers, which JSON has.
Files that differ stay in FOLDER/differing beside the recorded ones, JSON values that differ are printed. It ends with
the number of cases that differ, and with 1 if there are any.

Scenes, presets and views are those of the recorded program. Pictures are 192 x 108.
"""
import argparse
import concurrent.futures
import filecmp
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

RUN = Path(__file__).resolve().parent / "run-with-driver"
SIZE = ["--size", "192x108"]
TIME = re.compile(r"ms(95)?$|Ms(95)?$|^floorMultiple$")
CASES = "cases.json"


def output(program: str, arguments: list[str], folder: str | None = None) -> subprocess.CompletedProcess:
    return subprocess.run([RUN, Path(program).resolve(), *arguments], cwd=folder, capture_output=True, text=True)


def named(text: str, pattern: str) -> list[str]:
    """The names of a list in the help, which breaks lines where it likes."""
    found = re.search(pattern, " ".join(text.split()))
    if not found:
        sys.exit(f"same_pictures: the help of `glint render` has no {pattern}")
    return re.split(r",\s*", found.group(1))


def make_cases(program: str) -> dict[str, list[str]]:
    """Command lines by name. Files are written into the current folder."""
    text = output(program, ["render", "--help"]).stdout
    scenes = named(text, r"((?:builtin:[\w-]+(?:, )?)+)")
    presets = named(text, r"Settings to start from: ((?:[\w-]+, )*[\w-]+)")
    views = named(text, r"What to show[^:]*: ((?:\w+, )*\w+)")
    cases: dict[str, list[str]] = {}

    def render(name: str, scene: str, *arguments: str) -> None:
        cases[name] = ["render", scene, *SIZE, "-o", "picture.exr", "--view", ",".join(views), "--stats", "stats.json",
                       *arguments]

    for scene in scenes:
        short = scene.removeprefix("builtin:")
        render(f"{short} plain", scene)
        cases[f"{short} png"] = ["render", scene, *SIZE, "-o", "picture.png", "--view", ",".join(views)]
        for preset in presets:
            render(f"{short} {preset}", scene, "--preset", preset, "--frames", "3")
    rays = ["--set", "rays.enabled=true"]
    for name, arguments in {
        "rays": rays, "rays only": [*rays, "--set", "screen.enabled=false"],
        "rays accumulated": [*rays, "--set", "rays.accumulate=true", "--frames", "4"],
        "rays bvh": [*rays, "--set", "rays.backend=bvh"], "ray shadows": ["--set", "lights.shadows=rays"],
        "probes": ["--probes", "auto"], "planar": ["--planar", "auto"],
        "all sources": [*rays, "--probes", "auto", "--planar", "auto"],
        "no environment": ["--env", "none"], "msaa4": ["--set", "display.antialias=msaa4"],
        "msaa4 geometry": ["--set", "display.antialias=msaa4", "--set", "gbuffer.mode=geometry"],
        "fxaa": ["--set", "display.antialias=fxaa"], "previous": ["--set", "screen.colorSource=previous", "--frames", "3"],
        "debug": ["--set", "debug=true"], "half": ["--set", "resolutionScale=0.5"], "seed": ["--seed", "7"],
        "no refraction": ["--set", "refraction.enabled=false"], "no reflections": ["--set", "screen.enabled=false"],
    }.items():
        for scene in ("hall", "glass"):
            render(f"{scene} {name}", f"builtin:{scene}", *arguments)
    render("exact measured", "builtin:exact", "--set", "measure.exact=true", "--set", "measure.hits=true")
    render("mirror camera", "builtin:mirror", "--planar", "auto", "--camera", "0", "--time", "0.5")
    configs = ["--config", "balanced", "--config", "babylon", "--config", "hdrp", "--frames", "2"]
    cases["compare"] = ["compare", "builtin:exact", *SIZE, *configs, "--report", "report", "--json", "figures.json"]
    cases["compare reference"] = ["compare", "builtin:hall", *SIZE, *configs, "--reference", "reference",
                                  "--reference-frames", "2", "--report", "report", "--json", "figures.json"]
    for index, preset in enumerate(presets):
        cases[f"inspect {preset}"] = ["inspect", "builtin:hall", *SIZE, "--preset", preset, "--pixel",
                                      f"{60 + 10 * index},85", "-o", "ray.png"]
    cases["bench"] = ["bench", "builtin:hall", "--sizes", "192x108", "--shares", "0,50", "--frames", "3", "--warm-up",
                      "1", "--json", "bench.json"]
    cases["bake"] = ["bake", "builtin:hall", "-o", "hall.probes"]
    cases["settings json"] = ["settings", "--json"]
    cases["settings markdown"] = ["settings", "--markdown"]
    for number, arguments in enumerate((["render", "builtin:none"], ["render", "builtin:hall", "--view", "none"],
                                        ["inspect", "builtin:hall", *SIZE, "--pixel", "500,2"],
                                        ["render", "builtin:hall", "--camera", "none"])):
        cases[f"mistake {number}"] = arguments
    return cases


def run(program: str, arguments: list[str], folder: Path) -> None:
    """Runs one case in `folder`; what it says and how it ends are files beside those that it writes."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    done = output(program, arguments, str(folder))
    is_json = done.stdout.lstrip().startswith(("{", "["))
    if is_json or arguments[0] == "settings" or done.returncode:
        (folder / ("stdout.json" if is_json else "stdout.txt")).write_text(done.stdout)
    (folder / "end.txt").write_text(f"{done.returncode}\n{done.stderr}")


def values(json_value, path: str = ""):
    """(path, value) of every leaf; empty lists and objects are leaves."""
    inner = json_value.items() if isinstance(json_value, dict) else enumerate(json_value) if isinstance(
        json_value, list) else ()
    yielded = False
    for key, value in inner:
        yielded = True
        yield from values(value, f"{path}.{key}")
    if not yielded:
        yield path, json_value


def figures(path: Path) -> dict[str, object]:
    bench = path.name == "bench.json"
    result = {}
    for key, value in values(json.loads(path.read_text())):
        last = key.rsplit(".", 1)[-1]
        time = bench or any(TIME.search(part) for part in key.split("."))
        result[key if not bench else re.sub(r"\.\d+", "", key)] = None if time and last != "name" else value
    return result


def difference(recorded: Path, now: Path) -> str | None:
    """In words; None where both are equal."""
    if not now.exists():
        return "is not written any more"
    if not recorded.exists():
        return "was not written before"
    if recorded.suffix == ".json":
        before, after = figures(recorded), figures(now)
        keys = [key for key in {**before, **after} if before.get(key, "absent") != after.get(key, "absent")]
        lines = [f"        {key}: {before.get(key, 'absent')!r} -> {after.get(key, 'absent')!r}" for key in keys[:8]]
        if list(before) != list(after) and not keys:
            lines = ["        the order of its keys"]
        return "has other values\n" + "\n".join(lines) if lines else None
    if recorded.suffix == ".html":
        strip = lambda path: re.sub(r"\d+(\.\d+)?", "", path.read_text())
        return None if strip(recorded) == strip(now) else "has other words"
    return None if filecmp.cmp(recorded, now, shallow=False) else "differs"


def files(folder: Path) -> set[Path]:
    return {path.relative_to(folder) for path in folder.rglob("*") if path.is_file()}


def check(program: str, name: str, arguments: list[str], folder: Path) -> list[str]:
    recorded = folder / "recorded" / name.replace(" ", "_")
    differing = folder / "differing" / name.replace(" ", "_")
    found = []
    with tempfile.TemporaryDirectory(dir=folder) as temporary:
        now = Path(temporary) / "case" # ends with the check
        run(program, arguments, now)
        for path in sorted(files(recorded) | files(now)):
            words = difference(recorded / path, now / path)
            if words is None:
                continue
            found.append(f"    {path} {words}")
            if (now / path).exists():
                (differing / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(now / path, differing / path)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=["record", "check", "list"])
    parser.add_argument("program")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--only", default="")
    options = parser.parse_args()
    folder = options.folder.resolve()
    if options.task == "check":
        cases = json.loads((folder / CASES).read_text())
        shutil.rmtree(folder / "differing", ignore_errors=True)
    else:
        cases = make_cases(options.program)
    chosen = {name: arguments for name, arguments in cases.items() if re.search(options.only, name)}
    if options.task == "list":
        print("\n".join(chosen))
        return 0
    if options.task == "record":
        folder.mkdir(parents=True, exist_ok=True)
        (folder / CASES).write_text(json.dumps(chosen, indent=1))

    def one(name: str) -> list[str]:
        if options.task == "check":
            return check(options.program, name, chosen[name], folder)
        run(options.program, chosen[name], folder / "recorded" / name.replace(" ", "_"))
        end = (folder / "recorded" / name.replace(" ", "_") / "end.txt").read_text()
        return [] if end.startswith("0") or name.startswith("mistake") else [f"    ended with {end.rstrip()}"]

    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for name, found in zip(chosen, pool.map(one, chosen)):
            if found:
                wrong += 1
                print(f"{name}\n" + "\n".join(found), flush=True)
    print(f"{len(chosen)} cases, {wrong} {'fail' if options.task == 'record' else 'differ'}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
