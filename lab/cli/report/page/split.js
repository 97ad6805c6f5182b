/** All images of a scene: [{group, label, name}]. */
function scenePictures(scene) {
  const pictures = Object.entries(scene.pictures).map(([label, name]) => ({group: "images", label, name}));
  scene.configs.forEach((config, i) =>
    pictures.push({group: "images", label: `${letter(i)} ${config.name}`, name: config.pictures.composite}));
  const words = {difference: "difference", flip: "FLIP", worst: "worst pixels", outcome: "outcomes", source: "sources", hits: "hits"};
  for (const [map, word] of Object.entries(words))
    scene.configs.forEach((config, i) =>
      pictures.push({group: "maps", label: `${word} of ${letter(i)} ${config.name}`, name: config.pictures[map]}));
  return pictures;
}

function pictureSelect(pictures, chosen, change) {
  const groups = [...new Set(pictures.map(picture => picture.group))];
  const select = h("select", {}, groups.map(group => h("optgroup", {label: group}, pictures.filter(p => p.group === group)
    .map(picture => h("option", {value: picture.name, selected: picture === chosen}, picture.label)))));
  select.addEventListener("change", () => change(pictures.find(picture => picture.name === select.value)));
  return select;
}

/**
 * Two images and a line between them that can be dragged, or moved with the arrow keys.
 * `pictures`  [{group, label, name}];  `sides`  the two of them to begin with;  `shown(sides)` is called when they change
 */
function splitView(data, pictures, sides, shown = () => {}) {
  const images = sides.map(side => image(data, side.name, side.label));
  const tags = sides.map((side, i) => h("span", {class: i ? "tag at-right" : "tag at-left"}, side.label));
  const line = h("div", {class: "line", role: "slider", tabindex: 0, "aria-valuemin": 0, "aria-valuemax": 100,
    "aria-orientation": "horizontal"});
  const view = makeView(data, sides[0].name, "Two images, parted by a line",
    h("div", {class: "layer"}, images[1]), h("div", {class: "left"}, h("div", {class: "layer"}, images[0])), ...tags, line);
  view.classList.add("split");

  let at = 50;
  const moveLine = to => {
    at = Math.min(100, Math.max(0, to));
    view.style.setProperty("--at", at + "%");
    line.setAttribute("aria-valuenow", Math.round(at));
    line.setAttribute("aria-valuetext", `${Math.round(at)} percent: left of it ${sides[0].label}, right of it ${sides[1].label}`);
    line.setAttribute("aria-label", "Line between the two images");
  };
  const show = (side, picture) => {
    sides[side] = picture;
    images[side].src = data.images[picture.name].src;
    images[side].alt = picture.label;
    tags[side].textContent = picture.label;
    moveLine(at);
    shown(sides);
  };
  const lineTo = event => moveLine(100 * (event.clientX - view.getBoundingClientRect().left) / view.clientWidth);
  onDrag(line, view, event => { event.stopPropagation(); return true; }, (dx, dy, event) => lineTo(event));
  let panning = false;
  onDrag(view, view, event => {
    panning = zoom.scale > 1;
    if (!panning) lineTo(event);
    return true;
  }, (dx, dy, event) => panning ? moveZoom(-dx, -dy) : lineTo(event));
  line.addEventListener("keydown", event => {
    const step = event.shiftKey ? 10 : 1;
    const to = {ArrowLeft: at - step, ArrowDown: at - step, ArrowRight: at + step, ArrowUp: at + step, PageUp: at + 10,
      PageDown: at - 10, Home: 0, End: 100}[event.key];
    if (to === undefined) return;
    moveLine(to);
    event.preventDefault();
    event.stopPropagation(); // the same keys move the images
  });
  moveLine(50);
  const bar = h("div", {class: "bar"}, labelled("Left", pictureSelect(pictures, sides[0], picture => show(0, picture))),
    labelled("Right", pictureSelect(pictures, sides[1], picture => show(1, picture))), zoomBar(view));
  return [bar, view, h("p", {class: "dim"}, "Drag the line, or focus it and press the arrow keys. Double-click, Ctrl and the wheel, "
    + "or + and \u2212 zoom all images of this page together; drag a zoomed image to move it.")];
}
