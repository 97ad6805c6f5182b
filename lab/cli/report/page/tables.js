/**
 * `columns`  texts
 * `rows`     [first cell, ...cells]; {cells, first: true} begins a group; cells are texts, elements or {text}, left-aligned
 */
function table(caption, columns, rows, foot = []) {
  const row = cells => cells.map((cell, i) => i === 0 ? h("th", {scope: "row"}, cell)
    : cell && cell.text !== undefined ? h("td", {class: "text"}, cell.text) : h("td", {}, cell));
  const body = rows.map(entry => h("tr", {class: entry.first ? "first" : null}, row(entry.cells || entry)));
  const first = rows.length ? rows[0].cells || rows[0] : [];
  const head = columns.map((text, i) => h("th", {scope: "col", class: first[i] && first[i].text !== undefined ? "text" : null}, text));
  const id = newId();
  return h("div", {class: "scroll", role: "region", tabindex: 0, "aria-labelledby": id},
    h("table", {}, h("caption", {id}, h("span", {}, caption)),
      h("thead", {}, h("tr", {}, head)),
      h("tbody", {}, body),
      foot.length ? h("tfoot", {}, foot.map(cells => h("tr", {}, row(cells)))) : null));
}

/** Rows of each config by roughness band: `cells(figures of the band)` for those that exist. */
function bandRows(configs, bandsOf, cells) {
  const names = {all: "all", mirror: "mirrors", glossy: "glossy", rough: "rough"};
  return configs.flatMap((config, index) => {
    const bands = bandsOf(config);
    if (!bands) return [];
    return Object.keys(names).filter(band => bands[band]).map((band, i) => ({
      first: i === 0 && index > 0,
      cells: [h("span", {}, key(index), config.name), {text: names[band]}, ...cells(bands[band], config)],
    }));
  });
}

/** A table without the columns whose every cell is unknown. */
function knownTable(caption, columns, rows) {
  const cells = row => row.cells || row;
  const kept = columns.map((_, i) => i === 0 || rows.some(row => cells(row)[i] !== kUnknown));
  const only = list => list.filter((_, i) => kept[i]);
  return table(caption, only(columns), rows.map(row => ({first: row.first, cells: only(cells(row))})));
}
