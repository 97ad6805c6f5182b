#!/usr/bin/env python3
"""report_test.py page FOLDER RUN PROGRAM: writes a report of a small scene into FOLDER and reads it as a browser would.
report_test.py browser FOLDER: opens that page in a headless Chromium and uses it; skipped (77) where none is installed.
"""
import base64
import json
import re
import shutil
import subprocess
import sys
from html.parser import HTMLParser
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))
import browser  # noqa: E402

HOSTILE = "<script>window.hurt=1</script>"
CURVE = {
    "glint": "0.1.0", "device": "made up", "scenes": ["builtin:exact"], "size": [160, 90], "seed": 1, "generations": 3,
    "start": "fast", "cost": {"unit": "floors"},
    "points": [{"settings": {"screen": {"step": 16 - 2 * i}}, "cost": 1 + i * i, "error": 0.5 / (1 + i),
                "held": {"error": 0.6 / (1 + i)}, "preset": HOSTILE if i == 2 else None, "chosen": i == 3} for i in range(6)],
    "presets": [{"name": HOSTILE, "cost": 12.5, "error": 0.4}, {"name": "fast", "cost": 2.5, "error": 0.7}],
    "sensitivities": [{"setting": "screen.step", "error": 0.2, "cost": -3}],
}


def expect(what: str, true: bool, seen: object = "") -> None:
    if not true:
        sys.exit(f"failed: {what}: {seen}")


# --- the page as a file

class Structure(HTMLParser):
    """Every element that is opened is closed, in order; ids are unique; the data is kept."""
    ALONE = {"meta", "link", "img", "input", "br"}

    def __init__(self):
        super().__init__()
        self.open, self.ids, self.data, self.in_data = [], [], "", False

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.ids += [values["id"]] if "id" in values else []
        self.in_data = values.get("id") == "data"
        if tag not in self.ALONE:
            self.open.append(tag)

    def handle_endtag(self, tag):
        expect(f"</{tag}> ends what is open", self.open and self.open[-1] == tag, self.open)
        self.open.pop()
        self.in_data = False

    def handle_data(self, text):
        if self.in_data:
            self.data += text


def pictures(value) -> list[str]:
    """All names of pictures: the values of "pictures", wherever they are."""
    if isinstance(value, list):
        return [name for inner in value for name in pictures(inner)]
    if not isinstance(value, dict):
        return []
    own = value.get("pictures", [])
    return list(own.values() if isinstance(own, dict) else own) + [
        name for key, inner in value.items() if key != "pictures" for name in pictures(inner)]


GALLERY = {"softwareSize": "64x36", "size": "64x36", "settle": 2, "pictures": [
    {"name": "none", "scene": "builtin:exact", "title": HOSTILE, "config": "screen.enabled=false"},
    {"name": "fast", "scene": "builtin:exact", "config": "fast"},
    {"name": "hit", "scene": "builtin:mirror", "view": "outcome"}]}


def page_data(path: Path) -> dict:
    text = path.read_text(encoding="utf-8")
    expect("the page is smaller than 15 MB", len(text.encode()) < 15e6, len(text))
    structure = Structure()
    structure.feed(text)
    structure.close()
    expect("all elements are closed", not structure.open, structure.open)
    expect("ids are unique", len(set(structure.ids)) == len(structure.ids), structure.ids)
    return json.loads(structure.data)


def read_page(path: Path) -> dict:
    data = page_data(path)
    names = pictures(data["scenes"])
    expect("the page names pictures", len(names) >= 7, names)
    for name in names:
        source = data["images"].get(name, {}).get("src", "")
        expect(f"image {name} is there", source.startswith("data:image/webp;base64,"), source[:50])
        file = base64.b64decode(source.split(",", 1)[1], validate=True)
        expect(f"image {name} is a whole WebP", file[:4] == b"RIFF" and file[8:12] == b"WEBP"
               and int.from_bytes(file[4:8], "little") + 8 == len(file), file[:16])
    return data


def glint(run: str, program: str, folder: Path, *arguments: str) -> subprocess.CompletedProcess:
    return subprocess.run([run, program, *arguments], cwd=folder, capture_output=True, text=True, timeout=280)


def test_gallery(folder: Path, command: list[str]) -> None:
    """The page is there with its first picture, and complete at the end."""
    with subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True) as process:
        named = process.stdout.readline().strip()
        expect("the page is named", named == "report.html", named or process.stderr.read())
        early = page_data(folder / named)["gallery"]
        rendered = [picture["name"] for picture in early["pictures"] if "width" in picture]
        expect("it has a picture, and places for all", rendered and len(early["pictures"]) == 3, early)
        expect("it says that more will come", not early["complete"], early)
        expect("that picture is there", (folder / f"{rendered[0]}.png").read_bytes()[:4] == b"\x89PNG")
        errors = process.communicate(timeout=280)[1]
    expect("a report is made", process.returncode == 0, errors)
    gallery = page_data(folder / "report.html")["gallery"]
    expect("all pictures are rendered", gallery["complete"] and all(picture["width"] == 64 for picture in gallery["pictures"]),
           gallery)
    for picture in gallery["pictures"]:
        expect("and are files", (folder / f"{picture['name']}.png").is_file(), picture)


def test_page(folder: Path, run: str, program: str) -> None:
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "curve.json").write_text(json.dumps(CURVE))
    (folder / "pictures.json").write_text(json.dumps(GALLERY))
    report = ["report", "builtin:exact", "--size", "160x90", "--config", "fast", "--config", "babylon+screen.step=8",
              "--reference", "screen.march=linear", "--frames", "2", "--motion-frames", "4", "--motion-samples", "0",
              "--curve", "curve.json", "--validate"]
    test_gallery(folder, [run, program, *report, "-o", "report.html", "--json", "report.json", "--pictures", "pictures.json"])
    data = read_page(folder / "report.html")
    values = json.loads((folder / "report.json").read_text())
    expect("the JSON has the page's figures", values["figures"] == data["figures"] and "images" not in values)
    kinds = {figure["name"].split(".")[0] for figure in values["figures"]}
    expect("figures of every kind are watched", kinds == {"hits", "exact", "error", "time", "motion"}, kinds)

    # A recall that was better before; of it alone, so that no time fails on a busy machine.
    for figure in values["figures"]:
        if figure["name"] == "hits.recall.all" and figure["config"] == "fast":
            figure["value"] += 0.2
    (folder / "old.json").write_text(json.dumps(values))
    worse = glint(run, program, folder, *report, "-o", "against.html", "--against", "old.json", "--time-threshold", "1e6")
    expect("a passed threshold ends with 1", worse.returncode == 1, worse.stdout + worse.stderr)
    expect("one line says so", worse.stderr.count("\n") == 1 and "1 figure is worse" in worse.stderr
           and "hits.recall.all" in worse.stderr, worse.stderr)
    expect("the figure is named", re.search(r"worse +builtin:exact 160x90, fast: hits.recall.all .* -20.00 points: more than",
                                            worse.stdout) is not None, worse.stdout)
    expect("the page is written all the same", read_page(folder / "against.html")["changes"]["changes"])
    # With a curve that a search made: its choice is nearly equal to another point.
    tuned = glint(run, program, folder, "tune", "builtin:exact", "--size", "160x90", "--budget", "0.5", "--cost", "counted",
                  "--vary", "screen,fade.border,denoise.enabled", "--generations", "0", "--population", "8", "--presets", "none",
                  "--reference-frames", "1", "--json", "tuned.json")
    expect("a curve is found", tuned.returncode == 0, tuned.stderr)
    with_choice = ["tuned.json" if word == "curve.json" else word for word in report]
    loose = glint(run, program, folder, *with_choice, "-o", "loose.html", "--against", "old.json", "--threshold", "25",
                  "--time-threshold", "1e6")
    expect("below the threshold it ends with 0", loose.returncode == 0, loose.stdout + loose.stderr)
    curve, choice = read_page(folder / "loose.html")["curve"], json.loads((folder / "tuned.json").read_text())["choice"]
    expect("the choice is a point of the curve", [(point["cost"], point["error"]) for point in curve["points"] if point["chosen"]]
           == [(choice["cost"], choice["error"])], curve["points"])
    unlike = glint(run, program, folder, *report, "--env", "none", "-o", "unlike.html", "--against", "old.json")
    expect("a report measured with other options ends with 2", unlike.returncode == 2 and unlike.stderr.count("\n") == 1
           and "no --env (now --env none)" in unlike.stderr and not (folder / "unlike.html").exists(), unlike.stderr)
    gone = [word for i, word in enumerate(report) if "babylon+screen.step=8" not in report[i:i + 2]]
    lost = glint(run, program, folder, *gone, "-o", "lost.html", "--against", "old.json", "--threshold", "25",
                 "--time-threshold", "1e6")
    expect("a config that is gone ends with 1", lost.returncode == 1 and "no longer measured; the first: " in lost.stderr
           and "babylon+screen.step=8" in lost.stderr and lost.stderr.count("\n") == 1, lost.stderr)
    (folder / "broken.json").write_text("{")
    broken = glint(run, program, folder, *report, "-o", "broken.html", "--against", "broken.json")
    expect("a broken file ends with 2", broken.returncode == 2 and broken.stderr.count("\n") == 1, broken.stderr)
    compared = glint(run, program, folder, "compare", "builtin:exact", "--size", "64x36", "--config", "fast", "--report",
                     "compare.html")
    expect("compare writes such a page", compared.returncode == 0, compared.stderr)
    expect("of its one scene", len(read_page(folder / "compare.html")["scenes"]) == 1)


# --- the page in use

NAMELESS = """[...document.querySelectorAll('button, select, input, [tabindex="0"], [role=slider], svg[role], g[role]')]
  .filter(e => !(e.getAttribute('aria-label') || e.closest('label') || e.textContent.trim()
          || (e.getAttribute('aria-labelledby') && document.getElementById(e.getAttribute('aria-labelledby')))))
  .map(e => e.outerHTML.slice(0, 100))"""
TABLES = """[...document.querySelectorAll('table')].filter(t => !t.caption || !t.querySelector('thead th[scope=col]')
  || [...t.querySelectorAll('tbody tr')].some(r => !r.querySelector('th[scope=row]'))
  || [...t.querySelectorAll('tr')].some(r => r.children.length !== t.rows[0].children.length)).map(t => t.textContent.slice(0, 80))"""
CONTRAST = """(() => {
  const style = getComputedStyle(document.documentElement);
  const light = name => {
    const hex = style.getPropertyValue(name).trim();
    const [r, g, b] = [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16) / 255)
      .map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4);
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const ratio = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
  const low = [];
  for (const [names, least] of [['text dim link good bad series-0 series-1 series-2 series-3 series-4 series-5', 4.5], ['focus', 3]])
    for (const name of names.split(' '))
      for (const under of ['page', 'panel'])
        if (ratio(light('--' + name), light('--' + under)) < least) low.push(name + ' on ' + under);
  return low;
})()"""


def centre(page: browser.Browser, selector: str) -> tuple[float, float]:
    """In the middle of the window, where no other element covers it."""
    return tuple(page.value(f"""(() => {{ const e = document.querySelector({json.dumps(selector)});
        e.scrollIntoView({{block: 'center', behavior: 'instant'}}); const b = e.getBoundingClientRect();
        return [b.left + b.width / 2, b.top + b.height / 2]; }})()"""))


def number(page: browser.Browser, selector: str, attribute: str) -> float:
    return float(page.value(f"document.querySelector({json.dumps(selector)}).getAttribute('{attribute}')"))


def test_split(page: browser.Browser) -> None:
    x, y = centre(page, ".split .line")
    expect("the line begins in the middle", number(page, ".split .line", "aria-valuenow") == 50)
    width = page.value("document.querySelector('.split').clientWidth")
    page.mouse("Pressed", x, y)
    page.mouse("Moved", x + width / 8, y)
    page.mouse("Moved", x + width / 4, y)
    page.mouse("Released", x + width / 4, y)
    dragged = number(page, ".split .line", "aria-valuenow")
    expect("it was dragged", abs(dragged - 75) <= 1, dragged)
    page.value("document.querySelector('.split .line').focus()")
    page.press("ArrowRight")
    expect("an arrow key moves it", number(page, ".split .line", "aria-valuenow") == dragged + 1)
    page.press("Home")
    expect("Home moves it to the left", number(page, ".split .line", "aria-valuenow") == 0)
    clip = page.value("getComputedStyle(document.querySelector('.split .left')).clipPath")
    expect("the left image follows", "100%" in clip, clip)
    page.click(x, y)
    expect("a click sets it", abs(number(page, ".split .line", "aria-valuenow") - 50) <= 1)


def test_zoom(page: browser.Browser) -> None:
    transforms = "[...new Set([...document.querySelectorAll('.layer')].map(l => l.style.transform))]"
    page.click(*centre(page, "button[aria-label='Zoom in']"))
    page.value("document.querySelector('.grid .view').focus()")
    page.press("+")
    page.press("ArrowRight")
    seen = page.value(transforms)
    expect("all images have one zoom", len(seen) == 1 and "scale(4)" in seen[0], seen)
    x, y = centre(page, ".grid .view")
    page.mouse("Pressed", x, y)
    page.mouse("Moved", x + 40, y)
    page.mouse("Released", x + 40, y)
    moved = page.value(transforms)
    expect("dragging moves all of them", len(moved) == 1 and moved != seen, moved)
    page.click(*centre(page, "button[aria-label^='Zoom until']"))
    expect("single pixels are shown", page.value("document.querySelectorAll('.layer:not(.pixels)').length") == 0)
    page.press("0")
    page.value("document.querySelector('.view').focus()")
    page.press("0")
    expect("0 shows the whole image", "scale(1)" in page.value(transforms)[0], page.value(transforms))


def test_curve(page: browser.Browser) -> None:
    detail = "document.querySelector('.detail').textContent"
    expect("the chosen point is shown first", "Point 4 of 6" in page.value(detail), page.value(detail))
    page.click(*centre(page, ".point"))
    expect("a click shows a point's settings", "screen.step=16" in page.value(detail), page.value(detail))
    page.value("document.querySelector('.point[aria-pressed=true]').focus()")
    page.press("ArrowRight")
    expect("an arrow key goes on", "screen.step=14" in page.value(detail), page.value(detail))
    expect("a name stays text", page.value("window.hurt") is None)


def test_motion(page: browser.Browser) -> None:
    frame = "document.querySelector('input[type=range]').value"
    page.value("document.querySelector('input[type=range]').focus()")
    page.press("ArrowRight")
    expect("an arrow key shows the next frame", page.value(frame) == "1", page.value(frame))
    play = "[...document.querySelectorAll('button')].find(b => b.textContent === 'Play')"
    page.value(play + ".click()")
    played = page.value(f"new Promise(done => setTimeout(() => done({frame}), 130))")
    expect("frames play", played != "1", played)
    page.value("[...document.querySelectorAll('button')].find(b => b.textContent === 'Stop').click()")


def test_choice(page: browser.Browser) -> None:
    """Another image on the left, other settings for the maps."""
    source = "document.querySelector('.split .left img').src"
    before = page.value(source)
    page.value("""(() => { const s = document.querySelector('select'); s.selectedIndex = 1; s.dispatchEvent(new Event('change')); })()""")
    expect("another image is chosen", page.value(source) != before)
    maps = "document.querySelector('.grid img').alt"
    page.value("""(() => { const s = document.querySelectorAll('select')[2]; s.selectedIndex = 1; s.dispatchEvent(new Event('change')); })()""")
    expect("maps of other settings", "babylon" in page.value(maps), page.value(maps))


def test_pictures(page: browser.Browser) -> None:
    """The pictures beside the page: two under one line, the third below."""
    broken = page.value("[...document.images].filter(i => !i.complete || !i.naturalWidth || !i.alt).map(i => i.src)")
    expect("pictures beside the page are whole", broken == [], broken)
    expect("controls have names", page.value(NAMELESS) == [], page.value(NAMELESS))
    right = "document.querySelector('.split .layer img').src"
    expect("the second is on the right", page.value(right).endswith("/fast.png"), page.value(right))
    pressed = "[...document.querySelectorAll('button[aria-pressed=true]')].map(b => b.textContent)"
    expect("its button says so", page.value(pressed) == ["fast"], page.value(pressed))
    expect("the third is below", page.value("document.querySelector('.grid img').src").endswith("/hit.png"))
    expect("a title stays text", page.value("window.hurt") is None)


def test_browser(folder: Path) -> None:
    with browser.Browser(browser.find_or_skip()) as page:
        for width, height, dark in ((1280, 900, False), (400, 800, True)):
            page.open(folder / "against.html", width, height, dark)
            expect(f"nothing is cut off at {width}", page.value("document.documentElement.scrollWidth") <= width,
                   page.value("document.documentElement.scrollWidth"))
            broken = page.value("[...document.images].filter(i => !i.complete || !i.naturalWidth || !i.alt).map(i => i.alt)")
            expect("images are whole and have texts", broken == [], broken)
            expect("controls have names", page.value(NAMELESS) == [], page.value(NAMELESS))
            expect("tables have captions and headers", page.value(TABLES) == [], page.value(TABLES))
            expect("contrast suffices", page.value(CONTRAST) == [], page.value(CONTRAST))
            expect("what is worse is said in words", "worse" in page.value("document.querySelector('.verdict-worse').textContent"))
            page.screenshot(folder / f"page-{width}.png", whole=True)
            test_split(page)
            test_zoom(page)
            test_curve(page)
            test_motion(page)
            test_choice(page)
        page.open(folder / "loose.html", 1280, 900)
        shown = page.value("document.querySelector('.detail h4').textContent")
        expect("a curve opens on the search's choice", shown.endswith(", chosen"), shown)
        page.open(folder / "report.html", 400, 800)
        scroll = page.value("document.documentElement.scrollWidth")
        expect("nothing of the pictures is cut off", scroll <= 400, scroll)
        test_pictures(page)
        page.open(folder / "compare.html", 1280, 900)
        expect("a comparison is a page, too", page.value("document.querySelectorAll('h2').length") >= 5)
        messages = page.messages()
        expect("the console shows nothing", messages == [], messages)


if __name__ == "__main__":
    if sys.argv[1] == "page":
        test_page(Path(sys.argv[2]).resolve(), *(str(Path(word).resolve()) for word in sys.argv[3:5]))
    else:
        test_browser(Path(sys.argv[2]).resolve())
