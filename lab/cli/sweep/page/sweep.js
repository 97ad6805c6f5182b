// The page of a sweep: for each scene a chart of cost against error, and a table of all figures.
const mostRows = 2000;        // of a table on the page
const mostLetters = 40;       // configs whose marks have letters; more would cover each other
const costs = {"cost.floors": "cost, floors", "motion.raysPerPixel": "cost, rays per pixel"};
const errors = {
  "error.flip": "FLIP, mean", "error.relativeMse.all": "relative MSE of reflective surfaces",
  "error.relativeMse.mirror": "relative MSE of mirrors", "error.relativeMse.glossy": "relative MSE of glossy surfaces",
  "error.relativeMse.rough": "relative MSE of rough surfaces", "exact.oneBounceWrong": "wrong mirror pixels, share",
  "motion.relMse": "relative MSE in motion", "motion.noise": "noise in motion", "motion.flicker": "flicker", "motion.swim": "swim",
};

const meanOf = (row, figure) => row.figures[figure] ? row.figures[figure].mean : null;
const known = (rows, figures) => Object.keys(figures).filter(figure => rows.some(row => meanOf(row, figure) !== null));

/** The rows that none beats in both, by rising cost. */
function frontOf(rows, cost, error) {
  const sorted = rows.filter(row => meanOf(row, cost) !== null && meanOf(row, error) !== null)
    .sort((a, b) => meanOf(a, cost) - meanOf(b, cost) || meanOf(a, error) - meanOf(b, error));
  let least = Infinity;
  return sorted.filter(row => meanOf(row, error) < least && (least = meanOf(row, error), true));
}

/** Where letters stand, across: those that would cover each other side by side, towards the middle. */
function apart(points, middle) {
  const reach = 15, step = 20; // of a mark 19 wide
  const placed = [];
  for (const [x, y] of points) {
    let at = x;
    while (placed.some(other => Math.hypot(other.at - at, other.y - y) < reach)) at += x > middle ? -step : step;
    placed.push({at, y});
  }
  return placed.map(place => place.at);
}

function scatterChart(rows, cost, error) {
  const shown = rows.filter(row => meanOf(row, cost) > 0 && meanOf(row, error) > 0);
  const left = 64, right = chartWidth() - 24, top = 18, bottom = 330;
  const across = logScale(shown.map(row => meanOf(row, cost)), right - left);
  const up = logScale(shown.map(row => meanOf(row, error)), bottom - top);
  if (!across || !up) return h("p", {class: "dim"}, `${errors[error]}: no row has both a cost and an error above 0.`);
  const x = row => left + across.at(meanOf(row, cost)) * (right - left), y = row => bottom - up.at(meanOf(row, error)) * (bottom - top);
  const front = frontOf(shown, cost, error);
  // Rows whose words say the same: a fact about the figures, at any width of the window.
  const place = row => [cost, error].map(figure => digits(meanOf(row, figure))).join();
  const atPlace = new Map();
  for (const row of shown) atPlace.set(place(row), (atPlace.get(place(row)) || 0) + 1);
  const places = rows.length <= mostLetters ? apart(shown.map(row => [x(row), y(row)]), (left + right) / 2) : [];
  const marks = shown.map((row, i) => {
    const index = rows.indexOf(row);
    const others = atPlace.get(place(row)) - 1;
    const words = `${row.config}: ${costs[cost]} ${digits(meanOf(row, cost))}, ${errors[error]} ${digits(meanOf(row, error))}`
      + (front.includes(row) ? ", on the front" : "") + (others ? `, at the place of ${others} more` : "");
    if (rows.length <= mostLetters) {
      const mark = letterMark(places[i], y(row), index, words);
      if (places[i] !== x(row)) mark.prepend(svg("line", {x1: x(row), x2: places[i], y1: y(row), y2: y(row), class: "axis"}));
      return mark;
    }
    const circle = svg("circle", {cx: x(row), cy: y(row), r: 4, class: "gap"});
    circle.style.fill = seriesColor(front.includes(row) ? 0 : 5);
    return svg("g", {role: "img", "aria-label": words}, svg("title", {}, words), circle);
  });
  return chartFrame(`Cost against error: ${errors[error]}`, `${costs[cost]} across, ${errors[error]} up; both logarithmic, left and down is better`, bottom + 24,
    ...across.ticks.map(tick => { const at = left + across.at(tick) * (right - left); return [
      svg("line", {x1: at, x2: at, y1: top, y2: bottom, class: "rule"}),
      svg("text", {x: at, y: bottom + 18, "text-anchor": "middle", class: "tick"}, String(+tick.toPrecision(4)))]; }).flat(),
    ...up.ticks.map(tick => { const at = bottom - up.at(tick) * (bottom - top); return [
      svg("line", {x1: left, x2: right, y1: at, y2: at, class: "rule"}),
      svg("text", {x: left - 8, y: at + 4, "text-anchor": "end", class: "tick"}, String(+tick.toPrecision(4)))]; }).flat(),
    svg("polyline", {points: front.map(row => `${x(row)},${y(row)}`).join(" "), class: "front"}), ...marks);
}

/** A mean with its standard error, where that is known. */
function meanCell(row, figure) {
  const value = row.figures[figure];
  if (!value) return kUnknown;
  return digits(value.mean) + (value.standardError > 0 ? `\u00a0\u00b1\u00a0${digits(value.standardError, 2)}` : "");
}

function sweepTable(rows, cost, error) {
  const names = [...new Set(rows.flatMap(row => Object.keys(row.figures)))];
  const first = [cost, error].filter(name => name && names.includes(name));
  const order = [...first, ...names.filter(name => !first.includes(name))];
  const front = cost && error ? frontOf(rows, cost, error) : [];
  const shown = rows.slice(0, mostRows);
  return [rows.length > shown.length ? h("p", {}, `The first ${shown.length} of ${rows.length} settings; table.csv has all.`) : null,
    table("Figures, means over the seeds", ["settings", "seeds", "front", ...order],
      shown.map((row, i) => [rows.length <= mostLetters ? h("span", {}, key(i), row.config) : row.config, String(row.seeds),
        {text: front.includes(row) ? "yes" : ""}, ...order.map(name => meanCell(row, name))]))];
}

function sweepSection(rows) {
  const cost = known(rows, costs)[0], choices = known(rows, errors);
  const content = h("div", {});
  const show = error => content.replaceChildren(...[cost && error ? scatterChart(rows, cost, error) : null,
    ...sweepTable(rows, cost, error)].filter(Boolean));
  show(choices[0]);
  if (choices.length < 2) return [content];
  const select = h("select", {onchange: event => show(event.target.value)},
    choices.map(name => h("option", {value: name}, errors[name])));
  return [h("div", {class: "bar"}, labelled("Error", select)),
    h("p", {class: "dim"}, "The line joins the front: settings that no others beat in both cost and error. "
      + "Letters that would cover each other stand side by side; a line leads to their place."), content];
}

function showSweep(data) {
  const main = document.getElementById("main"), nav = document.getElementById("sections");
  document.getElementById("header").append(h("h1", {}, `Glint sweep: ${data.plan}`),
    h("p", {class: "dim"}, `${data.jobs - data.missing.length} of ${grouped(data.jobs)} jobs, ${data.program}, on ${data.devices.join("; ")}.`),
    ...(data.missing.length ? [h("p", {class: "fails"}, `${grouped(data.missing.length)} jobs are missing: means are of the seeds that are there.`)] : []));
  const groups = new Map();
  for (const row of data.means) {
    const name = `${row.scene}, ${row.width}x${row.height}${row.kind === "motion" ? ", in motion" : ""}`;
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(row);
  }
  for (const [name, rows] of groups) {
    const id = newId();
    main.append(h("section", {"aria-labelledby": id}, h("h2", {id}, name), ...sweepSection(rows)));
    nav.append(h("a", {href: `#${id}`}, name));
  }
}
