/** Errors of the image against the reference, by roughness band. */
function errorSection(scene) {
  if (!scene.reference)
    return [h("p", {class: "dim"}, "No reference was rendered; maps of differences show the change from the first settings.")];
  const bands = ["mirror", "glossy", "rough", "all"].filter(band => scene.configs.some(config => config.reference.bands[band]));
  const words = {mirror: "mirrors", glossy: "glossy", rough: "rough", all: "all"};
  const chart = dotChart({
    label: "Relative mean squared error by roughness",
    axis: "relative mean squared error (logarithmic; left is better)",
    rows: bands.map(band => ({name: words[band],
      marks: scene.configs.map((config, i) => ({index: i, name: config.name,
        value: config.reference.bands[band] ? config.reference.bands[band].relativeMse : null}))})),
  });
  const whole = table(`Error of the whole image against ${scene.reference}`, ["settings", "displayed error", "of it in the worst 0.1 %",
    "relative MSE", "of it in the worst 0.1 %", "FLIP, mean", "PSNR, dB", "PSNR of mirrors, dB"],
    scene.configs.map((config, i) => [h("span", {}, key(i), config.name), digits(config.reference.displayedError),
      percent(config.reference.displayedWorstShare), digits(config.reference.relativeMse),
      percent(config.reference.relativeMseWorstShare), digits(config.flip), fixed(config.reference.psnr, 1),
      fixed(config.reference.psnrMirrors, 1)]));
  return [whole, chart,
    table(`Error against ${scene.reference}, by roughness`, ["settings", "surfaces", "pixels", "relative MSE"],
      bandRows(scene.configs, config => config.reference.bands, band => [grouped(band.pixels), digits(band.relativeMse)]))];
}
