/** Every figure whose noise is known: what --against compares. */
function watchedSection(figures) {
  return [h("p", {class: "dim"}, "With --json these figures are kept, and glint report --against says later which have become better or worse, "
      + "and which differ by noise only."),
    h("details", {}, h("summary", {}, `${figures.length} figures with their standard errors`),
      table("Figures with their noise", ["figure", "scene", "settings", "value", "standard error"],
        figures.map(figure => [figure.name, {text: figure.scene}, {text: figure.config}, digits(figure.value, 4),
          figure.standardError === 0 ? "no noise" : digits(figure.standardError, 2)])))];
}
