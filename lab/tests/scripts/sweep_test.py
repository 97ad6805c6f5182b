#!/usr/bin/env python3
"""sweep_test.py shards FOLDER RUN PROGRAM: a small sweep by one process, by four shards, and by a process that is killed in the
middle and begun again. The tables are the same, bit for bit. Leaves the plan and the tables of the one process in FOLDER,
for slurm_test.py and the browser.
sweep_test.py browser FOLDER: opens the page of these tables in a headless Chromium; skipped (77) where none is installed.
"""
import json
import math
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import browser  # noqa: E402
from report_test import NAMELESS, TABLES as WRONG_TABLES  # noqa: E402

PLAN = {
    "scenes": ["builtin:exact", {"name": "spheres", "scene": "builtin:spheres", "env": "none"}],
    "sizes": ["64x36"],
    "configs": ["fast", {"name": "noisy", "config": "balanced", "settings": {"denoise": {"historySeconds": 0.05}}}],
    "seeds": 2,
    "reference": {"config": "screen.march=linear,screen.step=1", "frames": 1},
    "frames": 1,
}
JOBS = 8
TABLES = ["table.json", "table.csv", "index.html"]  # times.csv is not the same on every run


def expect(what: str, true: bool, seen: object = "") -> None:
    if not true:
        sys.exit(f"failed: {what}: {seen}")


class Sweep:
    def __init__(self, folder: Path, program: list[str]):
        self.folder, self.program = folder, program
        self.plan = folder / "plan.json"

    def command(self, *arguments: object) -> list[str]:
        return [*self.program, "sweep", *map(str, arguments)]

    def run(self, *arguments: object, status: int = 0) -> str:
        ended = subprocess.run(self.command(*arguments), capture_output=True, text=True, timeout=300)
        expect(f"sweep {' '.join(map(str, arguments))} ends with {status}", ended.returncode == status,
               ended.stdout + ended.stderr)
        return ended.stdout + ended.stderr

    def shard(self, out: str, shard: str = "0/1", **options) -> str:
        return self.run(self.plan, "--out", self.folder / out, "--shard", shard, **options)

    def results(self, out: str) -> dict[str, int]:
        return {file.name: file.stat().st_mtime_ns for file in (self.folder / out / "jobs").glob("*.json")}

    def tables(self, out: str) -> list[bytes]:
        self.run("--merge", self.folder / out)
        return [(self.folder / out / name).read_bytes() for name in TABLES]


def test_compare(sweep: Sweep, rows: list[dict]) -> None:
    """The figures are those of `glint compare`."""
    row = next(row["figures"] for row in rows if row["scene"] == "builtin:exact" and row["config"] == "fast")
    compared = subprocess.run([*sweep.program, "compare", "builtin:exact", "--size", "64x36", "--config", "fast", "--reference",
                               PLAN["reference"]["config"], "--reference-frames", "1", "--frames", "1", "--json", "-"],
                              capture_output=True, text=True, timeout=300)
    expect("glint compare ends with 0", compared.returncode == 0, compared.stderr)
    config = json.loads(compared.stdout)["configs"][0]
    for figure, value in [("error.relativeMse.all", config["reference"]["bands"]["all"]["relativeMse"]),
                          ("error.psnr", config["reference"]["psnr"]), ("hits.recall.all", config["hits"]["recall"]),
                          ("hits.precision.all", config["hits"]["precision"]), ("work.rays", config["rays"]),
                          ("exact.oneBounceWrong", config["exact"]["oneBounceWrongShare"])]:
        expect(f"{figure} is that of glint compare", row[figure] == value, (row[figure], value))


def test_shards(folder: Path, program: list[str]) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    sweep = Sweep(folder, program)
    sweep.plan.write_text(json.dumps(PLAN))
    listed = sweep.run(sweep.plan, "--list").splitlines()
    expect("every combination is a job", len(listed) == JOBS, listed)

    expect("one process runs all", "8 jobs, 0 done before, 8 done now, 0 failed" in sweep.shard("one"))
    whole = sweep.tables("one")
    rows = json.loads(whole[0])["rows"]
    expect("the table has every job", [row["job"] for row in rows] == [line.split()[0] for line in listed], rows)
    for row in rows:
        for figure in ["error.flip", "error.relativeMse.all", "hits.recall.all", "cost.floors"]:
            expect(f"{figure} is known", row["figures"].get(figure, -1) >= 0, row)
    of = {(row["scene"], row["config"], row["seed"]): row["figures"]["error.flip"] for row in rows}
    expect("errors depend on the scene", of["builtin:exact", "fast", 0] != of["spheres", "fast", 0], of)
    expect("noise depends on the seed", of["spheres", "noisy", 0] != of["spheres", "noisy", 1], of)

    test_compare(sweep, rows)

    before = sweep.results("one")
    expect("a second run has nothing to do", "8 done before, 0 done now" in sweep.shard("one"))
    expect("and leaves all files as they are", sweep.results("one") == before)

    sweep.run(sweep.plan, "--out", folder / "four", "--references", "--shard", "1/2")
    for shard in [2, 0, 3, 1]:
        expect("a shard has every fourth job", "2 jobs, 0 done before, 2 done now" in sweep.shard("four", f"{shard}/4"))
    for name, one, four in zip(TABLES, whole, sweep.tables("four")):
        expect(f"{name} of four shards is that of one process", one == four)

    process = subprocess.Popen(sweep.command(sweep.plan, "--out", folder / "killed"), stdout=subprocess.DEVNULL)
    begun = time.monotonic()
    while len(sweep.results("killed")) < 2:
        expect("the process makes results", process.poll() is None and time.monotonic() - begun < 120)
        time.sleep(0.01)
    process.send_signal(signal.SIGKILL)
    process.wait()
    done = sweep.results("killed")
    expect("it was killed in the middle", 2 <= len(done) < JOBS, done)
    half = folder / "killed" / "jobs" / sorted(done)[0]
    half.write_bytes(half.read_bytes()[:half.stat().st_size // 2])
    told = sweep.run("--merge", folder / "killed", status=1)
    expect("missing jobs are counted", f"{JOBS - len(done) + 1} of {JOBS} jobs have no result" in told, told)
    expect("and named", half.stem in told, told)
    sweep.run("--merge", folder / "killed", "--partial")
    partial = json.loads((folder / "killed" / "table.json").read_text())
    expect("a partial table says what it lacks", half.stem in partial["missing"], partial["missing"])
    told = sweep.shard("killed")
    expect("what is whole is not made again", f"{len(done) - 1} done before" in told, told)
    for name, one, killed in zip(TABLES, whole, sweep.tables("killed")):
        expect(f"{name} after the kill is that of one process", one == killed)

    wrong = dict(PLAN, scenes=[{"name": "a", "scene": "builtin:exact", "camera": "nowhere"}, "builtin:exact"],
                 configs=["fast"], seeds=1)
    sweep.plan = folder / "wrong.json"
    sweep.plan.write_text(json.dumps(wrong))
    for _ in range(2):  # a failed job is tried again
        told = sweep.shard("wrong", status=1)
        expect("one job fails", "1 failed" in told and "nowhere" in told and told.count("no such camera") >= 1, told)
    expect("the other one has its result", len(sweep.results("wrong")) == 1)
    told = sweep.run("--merge", folder / "wrong", status=1)
    expect("the table's error says why a result is missing", "no such camera" in told, told)


def test_browser(folder: Path) -> None:
    with browser.Browser(browser.find_or_skip()) as page:
        for width, dark in ((1280, False), (400, True)):
            page.open(folder / "one" / "index.html", width, 900, dark)
            scroll = page.value("document.documentElement.scrollWidth")
            expect(f"nothing is cut off at {width}", scroll <= width, scroll)
            expect("controls have names", page.value(NAMELESS) == [], page.value(NAMELESS))
            expect("tables have captions and headers", page.value(WRONG_TABLES) == [], page.value(WRONG_TABLES))
            expect("every scene has a chart", page.value("document.querySelectorAll('.chart svg').length") == 2)
            chart = "document.querySelector('.chart svg').getAttribute('aria-label')"
            expect("it begins with FLIP", "FLIP" in page.value(chart), page.value(chart))
            page.value("(() => { const s = document.querySelector('select'); s.value = 'error.relativeMse.mirror';"
                       " s.dispatchEvent(new Event('change')); })()")
            expect("another error is chosen", "mirrors" in page.value(chart), page.value(chart))
            front = page.value("[...document.querySelectorAll('tbody tr')].map(row => row.children[2].textContent)")
            expect("the table says which settings are on the front", "yes" in front, front)
            # Two at one place, a third beside them, and one far away.
            placed = page.value("""(() => {
                const row = (config, cost, error) => ({config, figures: {"cost.floors": {mean: cost}, "error.flip": {mean: error}}});
                const chart = scatterChart([row("a", 10, 0.1), row("b", 10, 0.1), row("c", 10.05, 0.1), row("d", 90, 0.9)],
                                           "cost.floors", "error.flip");
                return [...chart.querySelectorAll("g")].map(g => [+g.querySelector("circle").getAttribute("cx"),
                    +g.querySelector("circle").getAttribute("cy"), g.getAttribute("aria-label"), g.querySelectorAll("line").length]); })()""")
            near = [(a, b) for a in placed for b in placed if a[2] < b[2] and math.hypot(a[0] - b[0], a[1] - b[1]) < 15]
            expect("no letter covers another", len(placed) == 4 and not near, placed)
            expect("lines lead to the places of those moved", [mark[3] for mark in placed] == [0, 1, 1, 0], placed)
            expect("marks say how many share a place", ["at the place of 1 more" in mark[2] for mark in placed]
                   == [True, True, False, False], placed)
        expect("the console shows nothing", page.messages() == [], page.messages())


if __name__ == "__main__":
    if sys.argv[1] == "shards":
        test_shards(Path(sys.argv[2]).resolve(), [str(Path(word).resolve()) for word in sys.argv[3:5]])
    else:
        test_browser(Path(sys.argv[2]).resolve())
