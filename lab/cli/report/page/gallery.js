// Pictures that lie beside the page as PNG files. While some of them are still being rendered, the page loads itself again.
const kReloadMs = 2000, kIdleMs = 4000;
const kStaleMs = 15 * 60 * 1000; // a page that has not been written for so long is not being written any more

/** Not while the page is being used. */
function reloadUntilComplete() {
  if (Date.now() - Date.parse(document.lastModified) > kStaleMs) return;
  let used = 0;
  for (const type of ["pointerdown", "pointermove", "keydown", "wheel"])
    addEventListener(type, () => { used = Date.now(); }, {passive: true});
  setInterval(() => { if (Date.now() - used > kIdleMs) location.reload(); }, kReloadMs);
}

/** What is known of a rendered picture. */
function galleryFigures(data, picture) {
  const ms = picture.passes.reduce((sum, pass) => sum + pass.ms, 0);
  const sum = Math.max(1, Object.values(picture.outcomes).reduce((total, count) => total + count, 0));
  const shares = Object.fromEntries(Object.entries(picture.outcomes).map(([name, count]) => [name, count / sum]));
  const row = (name, value) => value ? [h("dt", {}, name), h("dd", {}, value)] : [];
  return [h("dl", {}, row("Frames until it settled", picture.frames ? String(picture.frames) : ""),
      row("Rays", picture.rays ? grouped(picture.rays) : ""),
      row("Lookups per ray", picture.rays ? fixed(picture.lookupsPerRay, 1) : ""),
      row("Time of all passes", ms ? `${fixed(ms, 2)} ms` : "")),
    picture.rays ? [h("p", {class: "dim"}, "How rays ended, by pixels:"), legend(data.legends.outcome, shares)] : [],
    h("pre", {tabindex: 0, role: "region", "aria-label": `Command of: ${picture.title}`}, picture.command)].flat();
}

const imageName = picture => `picture.${picture.name}`;

/** The line between the first picture and the others of its scene, and what is known of the one on the right. */
function gallerySplit(data, pictures) {
  const choices = pictures.map(picture => ({group: "pictures", label: picture.title, name: imageName(picture), picture}));
  const before = history.state && history.state.sides; // as it was before the page loaded itself again
  const sides = [0, 1].map(side => choices.find(choice => before && choice.name === before[side]) || choices[side]);
  const about = h("div"), buttons = h("div", {class: "bar", role: "group", "aria-label": "Picture on the right"});
  const shown = ([left, right]) => {
    about.replaceChildren(h("h3", {}, right.label), ...galleryFigures(data, right.picture));
    for (const button of buttons.children) button.setAttribute("aria-pressed", button.value === right.name);
    history.replaceState({sides: [left.name, right.name]}, "");
  };
  const [bar, view, hint] = splitView(data, choices, sides, shown);
  const select = bar.querySelectorAll("select")[1];
  buttons.append(...choices.slice(1).map(choice => h("button", {type: "button", value: choice.name, onclick: () => {
    select.value = choice.name;
    select.dispatchEvent(new Event("change"));
  }}, choice.label)));
  shown(sides);
  return [bar, view, buttons, hint, about];
}

function galleryFigure(data, picture) {
  const label = `${picture.title}, ${picture.scene}`;
  return h("figure", {}, picture.width ? imageView(data, imageName(picture), label) : h("div", {class: "pending"}, "to be rendered"),
    h("figcaption", {}, h("b", {}, picture.title), picture.scene),
    picture.width ? h("details", {}, h("summary", {}, "Figures and command"), ...galleryFigures(data, picture)) : null);
}

function showGallery(data, section) {
  const {pictures, complete} = data.gallery;
  for (const {name, width, height} of pictures) data.images[`picture.${name}`] = {width, height, src: `${name}.png`};
  const layered = pictures.filter(picture => picture.scene === pictures[0].scene);
  const done = layered.filter(picture => picture.width);
  const rendered = pictures.filter(picture => picture.width).length;
  const progress = complete ? null : h("p", {role: "status"}, rendered < pictures.length
    ? `${rendered} of ${pictures.length} pictures are rendered; this page loads itself again until all are there.`
    : "All pictures are rendered. A report is being measured; it will follow them on this page.");
  const split = done.length > 1 && done[0] === layered[0];
  const others = pictures.filter(picture => !(split && done.includes(picture)));
  section("Pictures", "Pictures", [progress, ...(split ? gallerySplit(data, done) : [])]);
  if (others.length) section(split ? "More pictures" : "All pictures", "More",
    [h("div", {class: "grid"}, others.map(picture => galleryFigure(data, picture)))]);
  if (!complete) reloadUntilComplete();
}
