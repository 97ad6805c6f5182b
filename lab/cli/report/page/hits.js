/** Rays against exact rays: precision, recall, cost; how they ended, and why hits were missed or wrong. */
function hitsSection(scene) {
  const bandsOf = config => {
    const {mirror, glossy, rough} = config.hits;
    const some = band => band && band.rays > 0 ? band : null;
    return {all: config.hits, mirror: some(mirror), glossy: some(glossy), rough: some(rough)};
  };
  const main = table("Hits against exact rays", ["settings", "surfaces", "rays", "precision", "recall", "error px, median",
    "95 %", "lookups a ray", "95 %"],
    bandRows(scene.configs, bandsOf, hits => [grouped(hits.rays), fixed(hits.precision, 4), fixed(hits.recall, 4),
      fixed(hits.positionErrorMedian, 2), fixed(hits.positionError95, 2), fixed(hits.lookupsPerRay, 1), String(hits.lookups95)]));

  const outcomes = [...new Set(scene.configs.flatMap(config => Object.keys(config.hits.outcomes)))];
  const ended = table("How rays ended: share of rays, and share of visible true hits that were missed",
    ["outcome", ...scene.configs.flatMap((config, i) => [`${letter(i)}: rays`, `${letter(i)}: missed`])],
    outcomes.map(name => [name, ...scene.configs.flatMap(({hits}) => [
      percent((hits.outcomes[name] || 0) / Math.max(1, hits.rays)),
      percent((hits.missedByOutcome[name] || 0) / Math.max(1, hits.visibleTruths))])]));

  const places = {visibleElsewhere: "visible elsewhere", offScreen: "off the screen", hidden: "hidden",
    behindCamera: "behind the camera", nothing: "nowhere: the ray hits nothing", noRay: "no ray"};
  const found = Object.keys(places).filter(name => scene.configs.some(config => config.hits.wrongByTruth[name]));
  const wrong = found.length ? table("Wrong hits, by where the true hit is", ["the true hit is",
    ...scene.configs.map((config, i) => `${letter(i)}: hits`)],
    found.map(name => [places[name], ...scene.configs.map(({hits}) => grouped(hits.wrongByTruth[name] || 0))])) : null;
  return [main, ended, wrong, statedTable(scene)];
}

/** Stated weights of answers against the share of right ones: equal where weights are probabilities. */
function statedTable(scene) {
  const configs = scene.configs.map(({hits}) => ({bins: hits.stated || [],
    answers: (hits.stated || []).reduce((sum, bin) => sum + bin.answers, 0)}));
  const bins = [...Array(10).keys()].filter(i => configs.some(({bins, answers}) => answers && bins[i].answers >= answers / 1000));
  if (!bins.length) return null;
  return table("Stated weight of answers, and the share of them that is right", ["stated weight",
    ...scene.configs.flatMap((config, i) => [`${letter(i)}: answers`, `${letter(i)}: stated`, `${letter(i)}: right`])],
    bins.map(i => [`${i / 10} to ${(i + 1) / 10}`, ...configs.flatMap(({bins, answers}) => {
      const some = answers && bins[i].answers > 0;
      return [percent(some ? bins[i].answers / answers : 0), fixed(some ? bins[i].stated : null, 3),
        fixed(some ? bins[i].right : null, 3)];
    })]));
}

/** Wrong mirror pixels against the exact picture, where the scene has one. */
function exactSection(scene) {
  if (!scene.configs.some(config => config.exact))
    return [h("p", {class: "dim"}, `Wrong mirror pixels: ${scene.noExact}.`)];
  return [table("Wrong mirror pixels against the exact picture", ["settings", "one bounce", "wrong", "all bounces", "wrong"],
    scene.configs.map((config, i) => [h("span", {}, key(i), config.name), grouped(config.exact.oneBouncePixels),
      percent(config.exact.oneBounceWrongShare, 2), grouped(config.exact.mirrorPixels), percent(config.exact.wrongShare, 2)]))];
}
