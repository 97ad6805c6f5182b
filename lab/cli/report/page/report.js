/** Builds the page from the report's values. */
function showReport(data) {
  const main = document.getElementById("main"), nav = document.getElementById("sections");
  const compared = data.scenes.length ? data.scenes[0].configs : [];
  document.getElementById("header").append(h("h1", {}, document.title),
    h("p", {class: "dim"}, `${data.device.name}, Glint ${data.glint}.${compared.length ? " Settings compared: " : ""}`,
      compared.map((config, i) => h("span", {}, key(i), config.name, i + 1 < compared.length ? ", " : ""))));

  const section = (title, short, content) => {
    const id = newId();
    main.append(h("section", {"aria-labelledby": id}, h("h2", {id}, title), ...content.filter(Boolean)));
    nav.append(h("a", {href: `#${id}`}, short));
  };
  if (data.gallery) showGallery(data, section);
  if (data.changes) section("Changes since the earlier report", "Changes", changesSection(data.changes));
  for (const scene of data.scenes) {
    const named = text => data.scenes.length > 1 ? `${text}: ${scene.title}` : text;
    const pictures = scenePictures(scene), composite = scene.configs[0].pictures.composite;
    const sides = [pictures[0], pictures.find(picture => picture.name === composite)];
    section(named("Images"), named("Images"), splitView(data, pictures, sides));
    section(named("Error"), named("Error"), errorSection(scene));
    section(named("Maps"), named("Maps"), mapsSection(data, scene));
    section(named("Rays against exact rays"), named("Hits"), [...hitsSection(scene), ...exactSection(scene)]);
    section(named("Time"), named("Time"), timesSection(scene, data.clock));
    if (scene.motion) section(named("Motion"), named("Motion"), motionSection(data, scene));
    section(named("Settings and commands"), named("Settings"), settingsSection(scene));
  }
  if (data.curve) section("Cost and error", "Curve", curveSection(data.curve));
  if (data.figures.length) section("Figures under watch", "Watched", watchedSection(data.figures));
  section("Machine and command", "Machine", originSection(data));
  setZoom(1);
  addEventListener("resize", () => setZoom(zoom.scale));
}
