/** What has become better or worse since an earlier report. */
function changesSection(changes) {
  const marks = {better: "\u25bc better", worse: "\u25b2 worse", noise: "\u2248 noise", same: "= same"};
  const points = change => change.kind === "share" || change.kind === "wrong";
  const amount = value => value === null ? "without bound" : (value > 0 ? "+" : "") + digits(value);
  const row = change => [h("span", {class: `verdict-${change.verdict}`}, marks[change.verdict]),
    {text: `${change.scene}, ${change.config}`}, {text: change.name}, digits(change.before, 4), digits(change.now, 4),
    `${amount(change.worse)} ${points(change) ? "points" : "%"}`, `${amount(change.low)} to ${amount(change.high)}`,
    change.fails ? h("span", {class: "fails"}, "yes") : "no"];
  const columns = ["verdict", "settings", "figure", "before", "now", "worse by", "95 % interval", "over the threshold"];
  const clear = changes.changes.filter(change => change.verdict === "better" || change.verdict === "worse");
  const rest = changes.changes.filter(change => !clear.includes(change));
  const failing = changes.changes.filter(change => change.fails).length;
  const count = (number, rest) => number === 1 ? `1 figure is ${rest}` : `${number} figures are ${rest}`;
  const list = figures => h("ul", {}, figures.map(one => h("li", {}, `${one.scene}, ${one.config}: ${one.name}`)));
  return [h("p", {}, `Against ${changes.file} (glint ${changes.glint}, ${changes.device}). `
      + (failing ? count(failing, "worse by more than the threshold") : "No figure is worse by more than the threshold")
      + ` of ${changes.threshold} percent or points, ${changes.timeThreshold} percent for times.`),
    clear.length ? table("Better and worse", columns, clear.map(row)) : h("p", {}, "Nothing is better or worse."),
    rest.length ? h("details", {}, h("summary", {}, count(rest.length, "the same, or differ by noise alone")),
      table("The same, or noise", columns, rest.map(row))) : null,
    changes.otherDevice ? h("p", {}, `${changes.otherDevice} times are of another device or driver and are not compared.`) : null,
    changes.added.length ? h("details", {}, h("summary", {}, count(changes.added.length, "new")), list(changes.added)) : null,
    changes.removed.length ? h("details", {}, h("summary", {}, count(changes.removed.length, "no longer measured")), list(changes.removed)) : null];
}
