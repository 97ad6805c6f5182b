/** Frames in motion, which play at the sequence's rate or are chosen, and the figures of motion. */
function motionSection(data, scene) {
  const motion = scene.motion;
  if (!motion) return [h("p", {class: "dim"}, "Not measured.")];
  const about = `${motion.frames} frames of ${motion.width}x${motion.height} at ${motion.fps} a second; the camera's path: ${motion.path}.`
    + (motion.reference ? ` Reference: ${motion.reference.name}, ${motion.reference.frames} frames averaged for each frame and seed.`
      : " Without a reference, only flicker is known.");
  return [h("p", {class: "dim"}, about), motion.strips.length ? player(data, scene) : null, motionTable(motion), trailChart(motion)];
}

function player(data, scene) {
  const {strips, fps, configs} = scene.motion;
  const views = configs.map((config, i) => imageView(data, strips[0].pictures[i], `first frame of ${config.name}`));
  const output = h("output", {});
  const range = h("input", {type: "range", min: 0, max: strips.length - 1, value: 0, step: 1});
  const show = index => {
    range.value = index;
    output.textContent = `frame ${strips[index].frame}`;
    range.setAttribute("aria-valuetext", output.textContent);
    views.forEach((view, i) => view.show(strips[index].pictures[i], `frame ${strips[index].frame} of ${configs[i].name}`));
  };
  let timer = null;
  const play = h("button", {type: "button", "aria-pressed": "false", onclick: () => {
    if (timer === null) {
      const stride = strips.length > 1 ? strips[1].frame - strips[0].frame : 1;
      timer = setInterval(() => show((+range.value + 1) % strips.length), Math.max(50, 1000 * stride / fps));
    } else {
      clearInterval(timer);
      timer = null;
    }
    play.setAttribute("aria-pressed", timer !== null);
    play.textContent = timer === null ? "Play" : "Stop";
  }}, "Play");
  range.addEventListener("input", () => show(+range.value));
  show(0);
  return h("div", {}, h("div", {class: "bar"}, play, labelled("Frame", range), output),
    h("div", {class: "grid"}, views.map((view, i) => h("figure", {}, view, h("figcaption", {}, key(i), configs[i].name)))));
}

const meanOf = figure => figure ? figure.mean : null;
const shareOf = (list, index) => list && list[index] ? list[index].share : null;

function motionTable(motion) {
  return knownTable("Motion of the reflected radiance", ["settings", "surfaces", "relative MSE", "bias", "noise", "flicker", "swim",
    "lag90, frames", "trail4", "lead4", "ghost4", "sharp", "energy", "fireflies a million"],
    bandRows(motion.configs, config => config.figures && config.figures.reflection, band => [
      digits(meanOf(band.relMse)), digits(meanOf(band.bias)), digits(meanOf(band.noise)), digits(meanOf(band.flicker)),
      digits(meanOf(band.swim)), band.lag90.reached === band.lag90.steps ? fixed(band.lag90.mean, 1) : kUnknown,
      digits(shareOf(band.trail, 3), 2), digits(shareOf(band.lead, 3), 2), digits(shareOf(band.ghost, 4), 2),
      fixed(meanOf(band.sharp), 3), fixed(meanOf(band.energy), 3), digits(meanOf(band.fireflies), 2)]));
}

function trailChart(motion) {
  const series = motion.configs.map((config, index) => ({index, name: config.name,
    values: config.figures && config.figures.reflection && config.figures.reflection.all
      ? config.figures.reflection.all.trail.map(one => one.share) : []}));
  const chart = lineChart({label: "Trails", axis: "frames ago: how much of that frame still shows (1 all, 0 none)", series});
  return chart ? h("div", {}, h("h3", {}, "Trails"), chart) : null;
}
