// Images that zoom and move together, down to single pixels: one zoom for the whole page.
const zoom = {scale: 1, u: 0.5, v: 0.5, views: new Set(), shown: new Set()};
const kLargestZoom = 64;

function setZoom(scale, u = zoom.u, v = zoom.v) {
  zoom.scale = Math.min(kLargestZoom, Math.max(1, scale));
  const edge = 0.5 / zoom.scale; // no view shows what is outside of its image
  zoom.u = Math.min(1 - edge, Math.max(edge, u));
  zoom.v = Math.min(1 - edge, Math.max(edge, v));
  for (const view of zoom.views) applyZoom(view);
  for (const output of zoom.shown) output.textContent = zoomText(output.forView);
}

function applyZoom(view) {
  const {scale, u, v} = zoom;
  for (const layer of view.querySelectorAll(".layer")) {
    layer.style.transform = `translate(${100 * (0.5 - u * scale)}%, ${100 * (0.5 - v * scale)}%) scale(${scale})`;
    layer.classList.toggle("pixels", pixelSize(view) >= 2);
  }
  view.classList.toggle("zoomed", scale > 1);
}

/** CSS pixels of a pixel of the image. */
const pixelSize = view => zoom.scale * view.clientWidth / view.imageWidth;

function zoomText(view) {
  return zoom.scale === 1 ? "whole image" : `1 pixel is ${digits(pixelSize(view), 2)} wide`;
}

/** Zooms so that what is under (x, y), in window coordinates, stays there. */
function zoomAt(view, factor, x, y) {
  const box = view.getBoundingClientRect();
  const fx = (x - box.left) / box.width - 0.5, fy = (y - box.top) / box.height - 0.5;
  const before = zoom.scale, after = Math.min(kLargestZoom, Math.max(1, before * factor));
  setZoom(after, zoom.u + fx / before - fx / after, zoom.v + fy / before - fy / after);
}

const moveZoom = (du, dv) => setZoom(zoom.scale, zoom.u + du / zoom.scale, zoom.v + dv / zoom.scale);

function zoomKey(event) {
  const moves = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]};
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (event.key === "+" || event.key === "=") setZoom(zoom.scale * 2);
  else if (event.key === "-") setZoom(zoom.scale / 2);
  else if (event.key === "0") setZoom(1);
  else if (moves[event.key] && zoom.scale > 1) moveZoom(...moves[event.key]);
  else return;
  event.preventDefault();
}

/** Drags with `move(dx, dy, event)`, in parts of the view; `begin` may refuse. */
function onDrag(element, view, begin, move) {
  let last = null;
  element.addEventListener("pointerdown", event => {
    if (event.button !== 0 || !begin(event)) return;
    last = event;
    element.setPointerCapture(event.pointerId);
  });
  element.addEventListener("pointermove", event => {
    if (!last || event.pointerId !== last.pointerId) return;
    move((event.clientX - last.clientX) / view.clientWidth, (event.clientY - last.clientY) / view.clientHeight, event);
    last = event;
  });
  const end = event => { if (last && event.pointerId === last.pointerId) last = null; };
  element.addEventListener("pointerup", end);
  element.addEventListener("pointercancel", end);
}

const image = (data, name, alt) => h("img", {src: data.images[name].src, alt, draggable: "false"});

/** An element with layers of images; it takes part in the page's zoom. */
function makeView(data, name, label, ...content) {
  const {width, height} = data.images[name];
  const view = h("div", {class: "view", tabindex: 0, role: "group",
    "aria-label": `${label}. Plus and minus zoom all images, arrow keys move them, 0 shows the whole image.`}, ...content);
  view.imageWidth = width;
  view.style.aspectRatio = `${width} / ${height}`;
  view.addEventListener("keydown", zoomKey);
  view.addEventListener("dblclick", event => zoomAt(view, event.shiftKey ? 0.5 : 2, event.clientX, event.clientY));
  view.addEventListener("wheel", event => {
    if (!event.ctrlKey) return; // a pinch on a touchpad, too; without it the page scrolls
    event.preventDefault();
    zoomAt(view, Math.exp(-event.deltaY / 200), event.clientX, event.clientY);
  }, {passive: false});
  zoom.views.add(view);
  return view;
}

/** One image. `show(name, label)` of the result replaces it. */
function imageView(data, name, label) {
  const shown = image(data, name, label);
  const view = makeView(data, name, label, h("div", {class: "layer"}, shown));
  onDrag(view, view, () => zoom.scale > 1, (dx, dy) => moveZoom(-dx, -dy));
  view.show = (other, text) => {
    shown.src = data.images[other].src;
    shown.alt = text;
  };
  return view;
}

/** Buttons of the page's zoom. */
function zoomBar(view) {
  const output = h("output", {"aria-live": "polite"});
  output.forView = view;
  output.textContent = zoomText(view);
  zoom.shown.add(output);
  const button = (text, label, action) => h("button", {type: "button", "aria-label": label, onclick: action}, text);
  return h("div", {class: "group", role: "group", "aria-label": "Zoom of all images"},
    button("\u2212", "Zoom out", () => setZoom(zoom.scale / 2)),
    button("+", "Zoom in", () => setZoom(zoom.scale * 2)),
    button("Whole", "Show the whole image", () => setZoom(1)),
    button("Pixels", "Zoom until a pixel is 8 wide", () => setZoom(8 * view.imageWidth / view.clientWidth)),
    output);
}
