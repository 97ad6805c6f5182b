/** Cost against error of tuned settings: a point shows its settings. */
function curveSection(curve) {
  const unit = {floors: "multiples of the floor", ms: "milliseconds", lookups: "depth lookups a ray"}[curve.unit] || curve.unit;
  const everything = [...curve.points, ...curve.presets];
  const left = 60, right = chartWidth() - 20, top = 12, bottom = 372;
  const scaleOf = (values, width) => Math.min(...values) > 0 && Math.max(...values) > 20 * Math.min(...values)
    ? logScale(values, width) : linearScale(values);
  const across = scaleOf(everything.map(point => point.cost), right - left);
  const up = scaleOf(everything.map(point => point.error), 2 * (bottom - top));
  const x = cost => left + across.at(cost) * (right - left), y = error => bottom - up.at(error) * (bottom - top);

  const detail = h("div", {class: "detail", "aria-live": "polite"});
  const marks = curve.points.map((point, i) => {
    const words = [`point ${i + 1} of ${curve.points.length}`, `cost ${digits(point.cost)}`, `error ${digits(point.error)}`,
      point.preset ? `preset ${point.preset}` : null, point.chosen ? "chosen" : null].filter(Boolean).join(", ");
    const mark = svg("circle", {cx: x(point.cost), cy: y(point.error), r: 6.5, class: "mark"});
    mark.style.fill = seriesColor(0);
    const ring = point.chosen ? [svg("circle", {cx: x(point.cost), cy: y(point.error), r: 11, fill: "none", class: "axis"})] : [];
    return svg("g", {class: "point", role: "button", tabindex: i === 0 ? 0 : -1, "aria-pressed": "false", "aria-label": words},
      svg("title", {}, words), svg("circle", {cx: x(point.cost), cy: y(point.error), r: 14, fill: "transparent", class: "hit"}), ...ring, mark);
  });
  const choose = (index, focus) => {
    marks.forEach((mark, i) => {
      mark.setAttribute("aria-pressed", i === index);
      mark.setAttribute("tabindex", i === index ? 0 : -1);
    });
    detail.replaceChildren(...curvePoint(curve, index, unit));
    if (focus) marks[index].focus();
  };
  marks.forEach((mark, i) => {
    mark.addEventListener("click", () => choose(i, false));
    mark.addEventListener("keydown", event => {
      const to = {ArrowLeft: i - 1, ArrowDown: i - 1, ArrowRight: i + 1, ArrowUp: i + 1, Home: 0, End: marks.length - 1,
        Enter: i, " ": i}[event.key];
      if (to === undefined) return;
      choose(Math.min(marks.length - 1, Math.max(0, to)), true);
      event.preventDefault();
    });
  });
  const presets = curve.presets.map(preset => {
    const px = x(preset.cost), py = y(preset.error), title = `preset ${preset.name}: cost ${digits(preset.cost)}, error ${digits(preset.error)}`;
    const name = preset.name.length > 20 ? preset.name.slice(0, 19) + "\u2026" : preset.name;
    const square = svg("rect", {x: px - 6, y: py - 6, width: 12, height: 12});
    square.style.fill = seriesColor(1);
    return svg("g", {role: "img", "aria-label": title}, svg("title", {}, title), square, px + 11 + textWidth(name) > right
      ? svg("text", {x: px - 11, y: py + 4, "text-anchor": "end"}, name) : svg("text", {x: px + 11, y: py + 4}, name));
  });
  const front = svg("polyline", {points: curve.points.map(point => `${x(point.cost)},${y(point.error)}`).join(" "), class: "front"});
  const chart = chartFrame("Cost and error", `cost, ${unit}`, bottom + 24,
    ...across.ticks.map(tick => [svg("line", {x1: x(tick), x2: x(tick), y1: top, y2: bottom, class: "rule"}),
      svg("text", {x: x(tick), y: bottom + 18, "text-anchor": "middle", class: "tick"}, String(+tick.toPrecision(4)))]).flat(),
    ...up.ticks.map(tick => [svg("line", {x1: left, x2: right, y1: y(tick), y2: y(tick), class: "rule"}),
      svg("text", {x: left - 8, y: y(tick) + 4, "text-anchor": "end", class: "tick"}, String(+tick.toPrecision(4)))]).flat(),
    svg("text", {x: 14, y: top + 4, class: "tick"}, "error"), front, ...presets, ...marks);
  const chosen = curve.points.findIndex(point => point.chosen);
  choose(Math.max(0, chosen), false);
  const rows = curve.points.map((point, i) => [`point ${i + 1}${point.chosen ? ", chosen" : ""}${point.preset ? ", " + point.preset : ""}`,
    digits(point.cost), digits(point.error), digits(point.heldError), {text: point.assignments.join(" ")}]);
  return [h("p", {class: "dim"}, `${curve.scenes.join(", ")} at ${curve.size.join("x")} on ${curve.device}; settings start from ${curve.start}. `
      + "Circles: settings found by tuning, none of which is better in both cost and error than another. Squares: presets. Choose a point "
      + "with the mouse, or with Tab and the arrow keys."),
    chart, detail,
    h("details", {}, h("summary", {}, "All points as a table"),
      table("Points", ["point", `cost, ${unit}`, "error", "error on views held back", "settings"], rows),
      curve.presets.length ? table("Presets", ["preset", "cost", "error"],
        curve.presets.map(preset => [preset.name, digits(preset.cost), digits(preset.error)])) : null,
      curve.sensitivities.length ? table("Sensitivities: change of error and cost with a setting", ["setting", "error", "cost"],
        curve.sensitivities.map(one => [one.setting, digits(one.error), digits(one.cost)])) : null)];
}

function curvePoint(curve, index, unit) {
  const point = curve.points[index];
  const command = [`--preset ${curve.preset}`, ...point.assignments.map(text => `--set ${text}`)].join(" \\\n  ");
  return [h("h4", {}, `Point ${index + 1} of ${curve.points.length}${point.preset ? `: preset ${point.preset}` : ""}${point.chosen ? ", chosen" : ""}`),
    h("dl", {}, h("dt", {}, `cost, ${unit}`), h("dd", {}, digits(point.cost)), h("dt", {}, "error"), h("dd", {}, digits(point.error)),
      point.heldError === null ? [] : [h("dt", {}, "error on views held back"), h("dd", {}, digits(point.heldError))]),
    h("pre", {tabindex: 0, role: "region", "aria-label": "Settings of the point"}, command)];
}
