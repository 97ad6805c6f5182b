#!/usr/bin/env python3
"""demo_page.py FOLDER: writes FOLDER/index.html from the pictures and --stats files that scripts/demo made there, with a
link to report.html.

Read from each stats file, where present:  device (a name, or an object with one), rays, lookupsPerRay,
passes ([{name, ms}] or {name: ms}), outcomes ({name: rays}).  A figure that is missing is left out of the page.
"""
import csv
import html
import json
import sys
from pathlib import Path

# The outcome view's colours (shaders/lib/outcome_color.glsl), by name in any case, with spaces, dashes or capitals in
# between; a hit is shown at half of its range.
COLOURS = {
    "hit": "#008000", "sky": "#4099e6", "offscreen": "#ffff00", "behindcamera": "#ff8000", "maxdistance": "#0000ff",
    "outofsteps": "#ff0000", "hidden": "#800080", "toothick": "#e64de6", "backface": "#734d26", "side": "#73bf1a",
    "belowthreshold": "#262626", "toorough": "#4d4d4d", "facingcamera": "#008080",
}


def figures(path: Path) -> dict:
    """The few figures that the page shows, out of one stats file."""
    stats = json.loads(path.read_text()) if path.exists() else {}
    device = stats.get("device")
    passes = stats.get("passes") or {}
    if isinstance(passes, list):
        passes = {entry.get("name", "?"): entry.get("ms", entry.get("gpuMs")) for entry in passes}
    return {
        "device": device.get("name") if isinstance(device, dict) else device,
        "rays": stats.get("rays"),
        "lookups": stats.get("lookupsPerRay"),
        "passes": {name: ms for name, ms in passes.items() if isinstance(ms, (int, float))},
        "outcomes": {name: count for name, count in (stats.get("outcomes") or {}).items() if count},
    }


def words(name: str) -> str:
    """offScreen -> off screen"""
    return "".join(" " + c.lower() if c.isupper() else c for c in name).replace("_", " ").replace("-", " ").strip()


def tile(value: str, unit: str) -> str:
    return f'<div class="tile"><b>{html.escape(value)}</b><span>{html.escape(unit)}</span></div>'


def bars(title: str, rows: dict, show, colour) -> str:
    if not rows:
        return ""
    top = max(rows.values()) or 1
    lines = "".join(
        f'<tr><th>{html.escape(words(name))}</th><td class="bar"><i style="width:{max(100 * value / top, 0.4):.1f}%;'
        f'background:{colour(name)}"></i></td><td class="number">{show(value)}</td></tr>'
        for name, value in sorted(rows.items(), key=lambda row: -row[1]))
    return f"<section><h3>{title}</h3><table>{lines}</table></section>"


def panel(picture: dict) -> str:
    """Everything that is known of one picture: figures, passes, outcomes, command."""
    known = picture["figures"]
    tiles = ""
    if known["passes"]:
        tiles += tile(f"{sum(known['passes'].values()):.1f} ms", "all passes")
    if known["rays"]:
        tiles += tile(f"{known['rays']:,}".replace(",", "\u2009"), "rays")
    if known["lookups"] is not None:
        tiles += tile(f"{known['lookups']:.1f}", "lookups per ray")
    total = sum(known["outcomes"].values()) or 1
    key = lambda name: COLOURS.get("".join(filter(str.isalpha, name.lower())), "#6e7681")
    return (f'<div class="tiles">{tiles}</div><div class="columns">'
            + bars("GPU time by pass", known["passes"], lambda ms: f"{ms:.2f} ms", lambda name: "#58a6ff")
            + bars("How rays ended", known["outcomes"], lambda n: f"{100 * n / total:.1f} %", key)
            + f'</div><pre>{html.escape(picture["command"])}</pre>')


def page(pictures: list[dict]) -> str:
    base = pictures[0]
    layered = [p for p in pictures[1:] if p["scene"] == base["scene"]]
    others = [p for p in pictures if p["scene"] != base["scene"]]
    device = next((p["figures"]["device"] for p in pictures if p["figures"]["device"]), None)
    tabs = "".join(f'<button data-picture="{p["file"]}">{html.escape(p["title"])}</button>' for p in layered)
    panels = "".join(f'<div class="panel" id="panel-{p["file"]}">{panel(p)}</div>' for p in layered)
    cards = "".join(f'<article><a href="{p["file"]}.png"><img src="{p["file"]}.png" alt="{html.escape(p["title"])}"></a>'
                    f'<h2>{html.escape(p["title"])} <small>{html.escape(p["scene"])}</small></h2>{panel(p)}</article>'
                    for p in others)
    compare = f"""
<div class="compare" id="compare">
  <img id="with" src="{layered[0]["file"]}.png" alt="with reflections">
  <img id="without" src="{base["file"]}.png" alt="{html.escape(base["title"])}">
  <div id="line"></div><span class="tag left">{html.escape(base["title"])}</span><span class="tag right" id="name"></span>
  <input type="range" min="0" max="100" step="0.1" value="50" id="slide" aria-label="where one picture ends and the other begins">
</div>
<nav>{tabs}</nav>{panels}""" if layered else f'<img class="wide" src="{base["file"]}.png" alt="{html.escape(base["title"])}">'
    return TEMPLATE.replace("@DEVICE@", f"Rendered on {html.escape(device)}." if device else "").replace(
        "@COMPARE@", compare).replace("@CARDS@", cards)


TEMPLATE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Glint: reflections, without and with</title>
<style>
:root { color-scheme: dark; --line: #262c36; --dim: #8b949e; }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1320px; padding: 3rem 1.25rem 5rem; background: #0d1117; color: #e6edf3;
       font: 16px/1.55 system-ui, sans-serif; }
h1 { margin: 0; font-size: 2.6rem; font-weight: 650; letter-spacing: -.03em; }
header a { color: #58a6ff; }
header p { margin: .4rem 0 2rem; color: var(--dim); max-width: 46rem; }
h2 { margin: 1.1rem 0 .4rem; font-size: 1.2rem; } h2 small { color: var(--dim); font-weight: 400; margin-left: .5rem; }
h3 { margin: 0 0 .5rem; font-size: .8rem; font-weight: 600; color: var(--dim); text-transform: uppercase; letter-spacing: .08em; }
img { display: block; width: 100%; }
.wide, article img, .compare { border-radius: 10px; overflow: hidden; box-shadow: 0 0 0 1px var(--line), 0 18px 50px #0008; }
.compare { position: relative; --at: 50%; }
.compare img + img { position: absolute; inset: 0; height: 100%; clip-path: inset(0 calc(100% - var(--at)) 0 0); }
#line { position: absolute; top: 0; bottom: 0; left: var(--at); width: 2px; margin-left: -1px; background: #fff; pointer-events: none; }
#line::after { content: "\\2194"; position: absolute; top: 50%; left: 50%; translate: -50% -50%; width: 2.4rem; height: 2.4rem;
       border-radius: 50%; background: #fff; color: #111; display: grid; place-items: center; font-size: 1.2rem; }
#slide { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: ew-resize; }
.compare:focus-within #line { background: #58a6ff; }
.tag { position: absolute; top: .9rem; padding: .2rem .7rem; border-radius: 99px; background: #000a; font-size: .85rem; pointer-events: none; }
.left { left: .9rem; } .right { right: .9rem; }
nav { display: flex; flex-wrap: wrap; gap: .5rem; margin: 1rem 0; }
button { font: inherit; font-size: .92rem; color: inherit; background: #161b22; border: 1px solid var(--line); border-radius: 99px;
       padding: .35rem 1rem; cursor: pointer; }
button[aria-pressed=true] { background: #e6edf3; color: #0d1117; border-color: #e6edf3; }
.tiles { display: flex; flex-wrap: wrap; gap: 2.2rem; margin: 1rem 0; }
.tile b { display: block; font-size: 1.5rem; font-weight: 600; font-variant-numeric: tabular-nums; } .tile span { color: var(--dim); font-size: .85rem; }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(300px, 1fr)); gap: 2rem; }
table { width: 100%; border-collapse: collapse; font-size: .86rem; }
th { text-align: left; font-weight: 400; white-space: nowrap; padding: .14rem .9rem .14rem 0; width: 1%; }
.bar i { display: block; height: .55rem; border-radius: 3px; } .number { text-align: right; white-space: nowrap; width: 1%;
       padding-left: .9rem; font-variant-numeric: tabular-nums; color: var(--dim); }
pre { margin: 1.2rem 0 0; padding: .8rem 1rem; background: #161b22; border: 1px solid var(--line); border-radius: 8px; overflow-x: auto; font-size: .84rem; }
main { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(420px, 100%), 1fr)); gap: 2.5rem 2rem; margin-top: 3.5rem; }
article { min-width: 0; } article .columns { grid-template-columns: 1fr; }
</style></head><body>
<header><h1>Glint</h1><p>Reflections for any Vulkan renderer. Drag across the picture to see the same frame without and with
them, and choose below it which technique or view lies on the right. <a href="report.html">The report</a> has the measurements.
@DEVICE@</p></header>
@COMPARE@
<main>@CARDS@</main>
<script>
const slide = document.getElementById("slide");
if (slide) {
  const compare = document.getElementById("compare"), buttons = [...document.querySelectorAll("nav button")];
  slide.oninput = () => compare.style.setProperty("--at", slide.value + "%");
  const show = button => {
    document.getElementById("with").src = button.dataset.picture + ".png";
    document.getElementById("name").textContent = button.textContent;
    for (const other of buttons) {
      other.setAttribute("aria-pressed", other === button);
      document.getElementById("panel-" + other.dataset.picture).hidden = other !== button;
    }
  };
  for (const button of buttons) button.onclick = () => show(button);
  show(buttons[0]);
}
</script></body></html>
"""

folder = Path(sys.argv[1])
rows = csv.reader((folder / "commands.tsv").open(), delimiter="\t", quoting=csv.QUOTE_NONE)
found = [{"file": file, "scene": scene, "title": title, "command": command, "figures": figures(folder / f"{file}.json")}
         for file, scene, title, command in rows]
(folder / "index.html.new").write_text(page(found))
(folder / "index.html.new").replace(folder / "index.html")
(folder / "commands.tsv").unlink()
