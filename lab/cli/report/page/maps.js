// Maps of one config: differences, outcomes, sources, hits, each with what its colours mean.

function legend(entries, shares) {
  const shown = shares ? entries.filter(entry => shares[entry.name] > 0) : entries;
  return h("ul", {class: "legend"}, shown.map(entry => {
    const swatch = h("i", {"aria-hidden": "true"});
    swatch.style.background = entry.color;
    return h("li", {title: entry.meaning}, swatch, entry.name + (shares ? ` ${percent(shares[entry.name])}` : ""));
  }));
}

function ramp(data, low, high) {
  const element = h("div", {class: "ramp", "aria-hidden": "true"});
  element.style.setProperty("--stops", data.legends.error.join(","));
  return [element, h("div", {class: "ends"}, h("span", {}, low), h("span", {}, high))];
}

function mapsSection(data, scene) {
  const base = scene.reference ? `the reference (${scene.reference})` : `${letter(0)} ${scene.configs[0].name}`;
  const shares = outcomes => {
    const sum = Object.values(outcomes).reduce((total, count) => total + count, 0);
    return Object.fromEntries(Object.entries(outcomes).map(([name, count]) => [name, count / Math.max(1, sum)]));
  };
  const captions = {
    difference: config => [h("b", {}, "Difference"), `largest difference of a channel from ${base}`, ramp(data, "none", "a quarter or more")],
    flip: config => [h("b", {}, config.flip === undefined ? "FLIP" : `FLIP, mean ${digits(config.flip)}`),
      `what a person sees to differ from ${base}`, ramp(data, "0", "1")],
    worst: config => [h("b", {}, "Worst pixels"), config.reference
      ? `the worst 0.1 % of the pixels hold ${percent(config.reference.displayedWorstShare)} of the displayed error (blue) and `
        + `${percent(config.reference.relativeMseWorstShare)} of the relative error (orange; white: both)`
      : "known with a reference only"],
    outcome: config => [h("b", {}, "Outcomes"), "how each ray ended, by pixels", legend(data.legends.outcome, shares(config.outcomes))],
    source: config => [h("b", {}, "Sources"), "which source answered most", legend(data.legends.source)],
    hits: config => [h("b", {}, "Hits"), "each mirror ray against the exact one", legend(data.legends.hits)],
  };
  const grid = h("div", {class: "grid"});
  const shown = {};
  for (const name of Object.keys(captions)) {
    const view = imageView(data, scene.configs[0].pictures[name], name);
    const caption = h("figcaption");
    shown[name] = {view, caption};
    grid.append(h("figure", {}, view, caption));
  }
  const show = index => {
    const config = scene.configs[index];
    for (const [name, {view, caption}] of Object.entries(shown)) {
      view.show(config.pictures[name], `map: ${name} of ${config.name}`);
      caption.replaceChildren(...captions[name](config).flat());
    }
  };
  const select = h("select", {onchange: () => show(select.selectedIndex)},
    scene.configs.map((config, i) => h("option", {}, `${letter(i)} ${config.name}`)));
  show(0);
  return [h("div", {class: "bar"}, labelled("Settings", select)), grid];
}
