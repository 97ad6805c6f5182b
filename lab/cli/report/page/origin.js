// Where the figures are from: machine, device, settings, command lines.
function flatSettings(value, prefix = "", into = {}) {
  for (const [name, inner] of Object.entries(value)) {
    if (inner !== null && typeof inner === "object" && !Array.isArray(inner)) flatSettings(inner, `${prefix}${name}.`, into);
    else into[prefix + name] = typeof inner === "string" ? inner : JSON.stringify(inner);
  }
  return into;
}

function settingsSection(scene) {
  const flat = scene.configs.map(config => flatSettings(config.settings));
  const names = [...new Set(flat.flatMap(settings => Object.keys(settings)))];
  const differing = names.filter(name => new Set(flat.map(settings => settings[name])).size > 1);
  const columns = ["setting", ...scene.configs.map((config, i) => `${letter(i)} ${config.name}`)];
  const rows = list => list.map(name => [name, ...flat.map(settings => settings[name] ?? kUnknown)]);
  return [differing.length ? table("Settings that differ", columns, rows(differing)) : null,
    h("details", {}, h("summary", {}, `All ${names.length} settings in force`), table("Settings in force", columns, rows(names))),
    h("h3", {}, "Commands that render these images"),
    h("pre", {tabindex: 0, role: "region", "aria-label": "Commands"}, scene.configs.map(config => config.command).join("\n")),
    ...scene.configs.filter(config => config.notes.length).map(config => h("div", {}, h("h3", {}, `Notes on ${config.name}`),
      h("ul", {}, config.notes.map(note => h("li", {}, note)))))];
}

function originSection(data) {
  const row = (name, value) => value === "" ? [] : [h("dt", {}, name), h("dd", {}, String(value))];
  return [h("dl", {}, row("Device", data.device.name), row("Driver", data.device.driver), row("Clock", data.clock),
      row("Processor", data.machine.processor), row("Threads", data.machine.threads), row("System", data.machine.system),
      row("Glint", data.glint), row("Images", data.pictureLoss)),
    h("h3", {}, "Command"), h("pre", {tabindex: 0, role: "region", "aria-label": "Command of this report"}, data.command)];
}
