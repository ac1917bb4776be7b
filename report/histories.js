// Plots the reader composes: a table, a quantity over time, and the entities to show.

const kinds = { nodout: "node", crack: "node", elout: "element", matsum: "part", rwforc: "wall", spcforc: "support", glstat: "" };
const titles = { nodout: "Nodes", crack: "Cracks", elout: "Elements", matsum: "Parts", rwforc: "Rigid walls", spcforc: "Supports",
  glstat: "Whole model" };
const firstChoices = {
  nodout: ["z_displacement", "y_displacement", "x_displacement"],
  crack: ["opening", "sliding"],
  elout: ["effective_plastic_strain", "von_mises"],
  rwforc: ["normal_force"], matsum: ["internal_energy", "kinetic_energy"],
};

/** Difference of the largest and the smallest finite value of a column, over all entities. */
function spanOf(table, name) {
  const c = table.columns.indexOf(name);
  let low = Infinity, high = -Infinity;
  for (const { column } of table.entities)
    for (const v of column[c])
      if (Number.isFinite(v)) { low = Math.min(low, v); high = Math.max(high, v); }
  return high > low ? high - low : 0;
}

/** The column to show first: of the usual ones that which moves most, else the first that moves. */
function firstColumn(table) {
  const moving = table.columns.slice(2).filter((name) => spanOf(table, name) > 0);
  const usual = (firstChoices[table.name] ?? []).filter((name) => moving.includes(name));
  if (table.name === "nodout") usual.sort((a, b) => spanOf(table, b) - spanOf(table, a));
  return usual[0] ?? moving[0] ?? table.columns[2] ?? table.columns[1];
}

/** One plot with its menus. */
class HistoryPlot {
  constructor(tables, table) {
    this.tables = tables;
    this.caption = element("div", { className: "caption tools" });
    this.printed = element("h3", { className: "printed" });  // paper has no menus
    this.chips = element("div", { className: "chips" });
    this.box = element("div");
    this.root = element("div", { className: "plot" }, this.printed, this.caption, this.chips, this.box);
    document.getElementById("history-plots").append(this.root);
    this.choose(table);
    this.chart = new Chart(this.box, () => this.curves(), { height: 270 });
  }

  choose(table) {
    this.table = table;
    this.quantity = firstColumn(table);
    this.chosen = new Set(table.entities.slice(0, 6).map((entity) => entity.id));
    this.showMenus();
  }

  showMenus() {
    const redraw = () => this.chart?.draw();
    this.caption.replaceChildren(
      menu(this.tables.map((t) => [t.name, `${titles[t.name] ?? t.name} (${t.name})`]), this.table.name,
        (name) => { this.choose(this.tables.find((t) => t.name === name)); redraw(); }, "table"),
      menu(this.table.columns.slice(1), this.quantity, (name) => { this.quantity = name; redraw(); }, "quantity"));
    this.chips.replaceChildren();
    if (this.table.entities.length < 2) return;
    this.table.entities.forEach(({ id }, n) => {
      const chip = toggle(`${kinds[this.table.name] ?? ""} ${id}`, this.chosen.has(id), (on) => {
        if (on) this.chosen.add(id); else this.chosen.delete(id);
        redraw();
      });
      chip.className = "chip";
      chip.style.setProperty("--tone", `var(--s${n % 8})`);
      this.chips.append(chip);
    });
  }

  curves() {
    const { columns, entities, name } = this.table;
    const y = columns.indexOf(this.quantity);
    this.printed.textContent = `${titles[name] ?? name}: ${words(this.quantity)}`;
    const curves = entities
      .map((entity, n) => ({ entity, n }))
      .filter(({ entity }) => this.chosen.has(entity.id))
      .map(({ entity, n }) => ({
        label: entities.length > 1 || name !== "glstat" ? `${kinds[name] ?? ""} ${entity.id}` : words(this.quantity),
        x: entity.column[0], y: entity.column[y], colour: curveColour(n),
        dash: n >= 8 ? [6, 3] : undefined,
      }));
    return { x: columns[0], curves };
  }
}

function showHistories(tables) {
  const entities = tables.filter((table) => table.name !== "glstat");
  if (!tables.length) return;
  document.getElementById("history").hidden = false;
  for (const table of entities.length ? entities : tables) new HistoryPlot(tables, table);
  document.getElementById("add-plot").addEventListener("click", () => new HistoryPlot(tables, entities[0] ?? tables[0]));
}
