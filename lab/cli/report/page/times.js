/** Times pass by pass, in multiples of the floor. */
function timesSection(scene, clock) {
  const passes = [...new Set(scene.configs.flatMap(config => config.passes.map(pass => pass.name)))]
    .filter(name => name !== "composite/statistics" && name !== "prepare/dfg"); // as the sum of the effect counts
  const ms = (config, name) => (config.passes.find(pass => pass.name === name) || {}).ms;
  const floors = scene.configs.every(config => config.floorMs > 0);
  const unit = config => floors ? config.floorMs : 1;
  const chart = barChart({
    label: "Time of the reflections, pass by pass",
    axis: (floors ? "multiples of the floor" : "milliseconds") + "; the numbers are the table's passes",
    rows: scene.configs.map((config, i) => ({index: i, name: `${config.name}: ${digits(config.effectMs / unit(config))}`,
      parts: passes.map((name, k) => ({number: k + 1, name, value: (ms(config, name) || 0) / unit(config)}))})),
  });
  const cells = config => [config.effectMs, config.effectMs / unit(config)];
  return [h("p", {class: "dim"}, `${clock}. Medians; the floor is a pass that only reads the G-buffer and writes one image.`),
    chart,
    table("Times pass by pass", ["pass", ...scene.configs.flatMap((config, i) =>
      [`${letter(i)}: ms`, ...(floors ? [`${letter(i)}: floors`] : [])])],
      passes.map((name, k) => [`${k + 1} ${name}`, ...scene.configs.flatMap(config => {
        const value = ms(config, name);
        return [digits(value), ...(floors ? [value === undefined ? kUnknown : digits(value / unit(config))] : [])];
      })]),
      [["sum", ...scene.configs.flatMap(config => cells(config).slice(0, floors ? 2 : 1).map(value => digits(value)))],
        ...(floors ? [["floor", ...scene.configs.flatMap(config => [digits(config.floorMs), "1"])]] : [])])];
}
