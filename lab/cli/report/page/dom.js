// Elements and numbers. All text goes through text nodes, so no value of a file is ever read as HTML.
function h(tag, attributes, ...children) {
  const element = document.createElement(tag);
  setAttributes(element, attributes);
  element.append(...children.flat().filter(child => child !== null && child !== undefined));
  return element;
}

function svg(tag, attributes, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  setAttributes(element, attributes);
  element.append(...children.flat());
  return element;
}

function setAttributes(element, attributes) {
  for (const [name, value] of Object.entries(attributes || {})) {
    if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else if (value !== null && value !== undefined && value !== false) element.setAttribute(name, value);
  }
}

const kUnknown = "\u2013"; // a dash

/** A number with so many significant digits, a dash where it is unknown. */
function digits(value, count = 3) {
  if (typeof value !== "number" || !isFinite(value)) return kUnknown;
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-4 || size >= 1e7) return value.toExponential(count - 1);
  return value.toFixed(Math.max(0, count - 1 - Math.floor(Math.log10(size))));
}

const fixed = (value, places) => typeof value === "number" ? value.toFixed(places) : kUnknown;
const percent = (value, places = 1) => typeof value === "number" ? (100 * value).toFixed(places) + "\u00a0%" : kUnknown;
const grouped = value => typeof value === "number" ? Math.round(value).toLocaleString("en") : kUnknown;

/** The letter of a config in charts and tables. */
const letter = index => index < 26 ? String.fromCharCode(65 + index) : String(index + 1);
const seriesColor = index => `var(--series-${index % 6})`;

function key(index) {
  const element = h("span", {class: "key"}, letter(index));
  element.style.background = seriesColor(index);
  return element;
}

let nextId = 0;
const newId = () => "id" + nextId++;

/** A control with its visible label. */
function labelled(text, control) {
  return h("label", {}, text, control);
}
