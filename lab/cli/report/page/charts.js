// Charts as plain SVG. Every one has a label, a title on each mark, and a table with its numbers beside it.
/** Units of a chart's width: CSS pixels, so that texts have the same size at any width. */
const chartWidth = () => Math.min(800, document.getElementById("main").clientWidth || 800);
const textWidth = text => 7.2 * String(text).length;

/** `axis`: the name of the one across, below the chart. */
function chartFrame(label, axis, height, ...content) {
  return h("div", {class: "chart"}, svg("svg", {viewBox: `0 0 ${chartWidth()} ${height}`, role: "group", "aria-label": label}, ...content),
    h("p", {class: "axis-name"}, axis));
}

/** Round numbers from 0 to `most`. */
function linearTicks(most) {
  const raw = most / 5, power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map(factor => factor * power).find(size => size >= raw);
  const ticks = [];
  for (let value = 0; value <= most * 1.0001; value += step) ticks.push(value);
  return ticks;
}

/** Powers of ten, with 2 and 5 between them where their texts have room in `width`. */
function logScale(values, width) {
  const some = values.filter(value => value > 0);
  if (!some.length) return null;
  let low = Math.min(...some), high = Math.max(...some);
  if (high / low < 4) { low /= 2; high *= 2; }
  low /= 1.15; high *= 1.15;
  const ticksOf = factors => {
    const ticks = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); ++power)
      ticks.push(...factors.map(factor => factor * 10 ** power).filter(value => value >= low && value <= high));
    return ticks;
  };
  const ticks = [[1, 2, 5], [1, 3], [1]].map(ticksOf).find((list, i) => i === 2 || list.length * 48 <= width);
  return {at: value => (Math.log(value) - Math.log(low)) / (Math.log(high) - Math.log(low)), ticks};
}

function linearScale(values) {
  const most = Math.max(...values.filter(value => isFinite(value)), 0) * 1.05 || 1;
  return {at: value => value / most, ticks: linearTicks(most)};
}

/** A mark with the letter of its config: the letter says as much as the colour. */
function letterMark(x, y, index, title) {
  const text = svg("text", {x, y: y + 4.5, "text-anchor": "middle", class: "on-mark", "font-size": 12}, letter(index));
  const circle = svg("circle", {cx: x, cy: y, r: 9.5, class: "gap"});
  circle.style.fill = seriesColor(index);
  return svg("g", {role: "img", "aria-label": title}, svg("title", {}, title), circle, text);
}

/** rows: [{name, marks: [{index, name, value}]}] */
function dotChart({label, axis, rows}) {
  const left = 20 + Math.max(...rows.map(row => textWidth(row.name))), right = chartWidth() - 20, step = 46;
  const scale = logScale(rows.flatMap(row => row.marks.map(mark => mark.value)), right - left);
  if (!scale) return h("p", {class: "dim"}, `${label}: nothing differs.`);
  const x = value => left + scale.at(value) * (right - left);
  const bottom = 12 + rows.length * step;
  const content = scale.ticks.map(tick => [svg("line", {x1: x(tick), x2: x(tick), y1: 8, y2: bottom, class: "rule"}),
    svg("text", {x: x(tick), y: bottom + 18, "text-anchor": "middle", class: "tick"}, String(+tick.toPrecision(2)))]).flat();
  rows.forEach((row, i) => {
    const y = 12 + (i + 0.5) * step;
    content.push(svg("text", {x: left - 14, y: y + 4, "text-anchor": "end"}, row.name),
      svg("line", {x1: left, x2: right, y1: y, y2: y, class: "axis"}));
    const placed = [];
    for (const mark of row.marks) {
      if (!(mark.value > 0)) continue;
      const at = x(mark.value), above = placed.filter(other => Math.abs(other - at) < 20).length; // beside each other: apart
      placed.push(at);
      content.push(letterMark(at, y + (above % 2 ? 11 : above ? -11 : 0), mark.index, `${mark.name}, ${row.name}: ${digits(mark.value)}`));
    }
  });
  return chartFrame(label, axis, bottom + 24, ...content);
}

/** rows: [{index, name, parts: [{number, name, value}]}]; the numbers are those of the table's rows. */
function barChart({label, axis, rows}) {
  const sum = row => row.parts.reduce((total, part) => total + part.value, 0);
  const scale = linearScale(rows.map(sum)), left = 34, right = chartWidth() - 20, step = 62;
  const x = value => left + scale.at(value) * (right - left);
  const bottom = 8 + rows.length * step;
  const content = scale.ticks.map(tick => [svg("line", {x1: x(tick), x2: x(tick), y1: 8, y2: bottom, class: "rule"}),
    svg("text", {x: x(tick), y: bottom + 18, "text-anchor": "middle", class: "tick"}, String(+tick.toPrecision(6)))]).flat();
  rows.forEach((row, i) => {
    const y = 30 + i * step;
    content.push(svg("text", {x: left, y: y - 7}, row.name), letterMark(14, y + 13, row.index, row.name));
    let at = 0;
    for (const part of row.parts) {
      const width = x(at + part.value) - x(at);
      const title = `${part.number} ${part.name}: ${digits(part.value)}`;
      const rect = svg("rect", {x: x(at), y, width: Math.max(width, 0), height: 26, class: "gap"});
      rect.style.fill = seriesColor(row.index);
      const group = svg("g", {role: "img", "aria-label": title}, svg("title", {}, title), rect);
      if (width > 10 + textWidth(part.number))
        group.append(svg("text", {x: x(at) + width / 2, y: y + 18, "text-anchor": "middle", class: "on-mark"}, String(part.number)));
      content.push(group);
      at += part.value;
    }
  });
  return chartFrame(label, axis, bottom + 24, ...content);
}

/** series: [{index, name, values}]; x is the place of a value, from 1. Unknown values are left out. */
function lineChart({label, axis, series}) {
  const known = series.filter(one => one.values.some(value => typeof value === "number"));
  if (!known.length) return null;
  const values = known.flatMap(one => one.values.filter(value => typeof value === "number"));
  const low = Math.min(0, ...values), scale = linearScale([...values, 0.1]), height = 190, top = 14, left = 52, right = chartWidth() - 26;
  const reach = scale.ticks[scale.ticks.length - 1];
  const y = value => top + (1 - (value - low) / (Math.max(reach, ...values) - low)) * height;
  const count = Math.max(...known.map(one => one.values.length));
  const x = place => left + (place - 1) / Math.max(1, count - 1) * (right - left);
  const content = scale.ticks.map(tick => [svg("line", {x1: left, x2: right, y1: y(tick), y2: y(tick), class: "rule"}),
    svg("text", {x: left - 8, y: y(tick) + 4, "text-anchor": "end", class: "tick"}, String(+tick.toPrecision(3)))]).flat();
  for (let place = 1; place <= count; place += count > 20 ? 4 : 1)
    content.push(svg("text", {x: x(place), y: top + height + 20, "text-anchor": "middle", class: "tick"}, String(place)));
  known.forEach((one, order) => {
    const points = one.values.map((value, i) => [value, i + 1]).filter(([value]) => typeof value === "number");
    const line = svg("polyline", {points: points.map(([value, place]) => `${x(place)},${y(value)}`).join(" "), fill: "none",
      "stroke-width": 2, "stroke-dasharray": ["none", "7 4", "2 3", "9 3 2 3"][one.index % 4]});
    line.style.stroke = seriesColor(one.index);
    const [value, place] = points[Math.min(points.length - 1, order * 2)];
    content.push(line, letterMark(x(place), y(value), one.index, `${one.name}: from ${digits(points[0][0])} to ${digits(points[points.length - 1][0])}`));
  });
  return chartFrame(label, axis, top + height + 26, ...content);
}
