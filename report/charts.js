// Plots over time: uPlot with the page's look. Every chart can be redrawn for another theme.

const charts = new Set();

/** The colour of the n-th curve. */
function curveColour(n) {
  return styleColour("s" + (n % 8));
}

/**
 * A chart in `box`. `make` gives, each time it is drawn, {x: name, curves: [{label, x, y, colour, dash, width}]},
 * colours as names of the style sheet. Charts with the same `sync` share their cursor.
 */
class Chart {
  constructor(box, make, { sync = null, height = 250, range = null } = {}) {
    Object.assign(this, { box, make, sync, height, range });
    charts.add(this);
    new ResizeObserver(() => {
      if (this.plot && this.box.clientWidth) this.plot.setSize({ width: this.box.clientWidth, height: this.height });
    }).observe(box);
    this.draw();
  }

  draw() {
    const { x, curves } = this.make();
    this.plot?.destroy();
    this.plot = null;
    this.box.replaceChildren();
    if (!curves.length) {
      this.box.append(element("p", { className: "hint", textContent: "Choose at least one curve." }));
      return;
    }
    this.plot = new uPlot(this.options(x, curves), align(curves), this.box);
  }

  options(xName, curves) {
    const axis = {
      stroke: styleColour("soft"), font: "12px system-ui, 'DejaVu Sans', sans-serif",
      grid: { stroke: styleColour("line"), width: 1 }, ticks: { stroke: styleColour("line"), width: 1, size: 5 },
      values: (_, splits) => splits.map((v) => numberText(v, 6)),
    };
    // Beside the cursor's values; without a cursor, those at the end.
    const value = (plot, v, i, row) => numberText(row === null || row === undefined ? plot.data[i].at(-1) : v, 5);
    return {
      width: this.box.clientWidth || 520, height: this.height,
      scales: { x: { time: false }, y: this.range ? { range: this.range } : {} },
      axes: [
        { ...axis, space: 70, size: 30, label: words(xName), labelSize: 20, labelGap: 0, labelFont: axis.font },
        { ...axis, space: 34, size: (_, values) => 18 + 7.2 * Math.max(3, ...(values ?? []).map((v) => v.length)) },
      ],
      cursor: { points: { size: 7 }, drag: { x: true, y: false }, ...(this.sync && { sync: { key: this.sync } }) },
      legend: { live: true, markers: { width: 0, fill: (_, i) => curves[i - 1]?.colour } },
      series: [
        { label: words(xName), value },
        ...curves.map((curve) => ({
          label: curve.label, stroke: curve.colour, width: curve.width ?? 1.75, dash: curve.dash,
          points: { show: curve.y.length < 25 }, value, spanGaps: false,
        })),
      ],
    };
  }
}

/** Curves on one ascending abscissa, as uPlot wants them; gaps where a value is no number. */
function align(curves) {
  const tables = curves.map(({ x, y }) => {
    const rows = Array.from(x.keys()).filter((i) => Number.isFinite(x[i]));
    return [rows.map((i) => x[i]), rows.map((i) => (Number.isFinite(y[i]) ? y[i] : null))];
  });
  const same = tables.every(([x]) => x.length === tables[0][0].length && x.every((v, i) => v === tables[0][0][i]));
  return same ? [tables[0][0], ...tables.map((t) => t[1])] : uPlot.join(tables);
}

function redrawCharts() {
  for (const chart of charts) chart.draw();
}

/** A plot with a caption, appended to `grid`. */
function addChart(grid, title, make, options) {
  const box = element("div");
  grid.append(element("div", { className: "plot" },
    element("div", { className: "caption" }, element("h3", { textContent: title })), box));
  return new Chart(box, make, options);
}

/** The plots of glstat: energies, their ratio, the time step, and added mass where there is any. */
function showEnergy(table) {
  const { columns, entities: [{ column }] } = table;
  const get = (name) => column[columns.indexOf(name)];
  const used = (name) => get(name)?.some((v) => v !== 0 && Number.isFinite(v));
  const time = column[0], sync = "energy";
  const curve = (name, colour, more) =>
    ({ label: words(name.replace(/_energy$/, "")), x: time, y: get(name), colour: styleColour(colour), ...more });
  const wanted = [
    ["total_energy", "ink", { width: 2.25 }], ["kinetic_energy", "s0"], ["internal_energy", "s1"],
    ["external_work", "s2", { dash: [7, 4] }], ["hourglass_energy", "s3"], ["stonewall_energy", "s4"],
    ["damping_energy", "s5"], ["sliding_interface_energy", "s6"], ["eroded_internal_energy", "s7", { dash: [3, 3] }],
    ["eroded_kinetic_energy", "s7", { dash: [8, 3] }]];
  const core = ["total_energy", "kinetic_energy", "internal_energy", "external_work", "hourglass_energy"];
  const shown = wanted.filter(([name]) => get(name) && (core.includes(name) || used(name)));
  const grid = document.getElementById("energy-plots");
  addChart(grid, "Energies", () => ({ x: "time", curves: shown.map((w) => curve(...w)) }), { sync, height: 320 });
  if (get("energy_ratio")) {
    // One percent off is at least half of the height, so that a flat line looks flat.
    const range = (_, low, high) => [Math.min(low ?? 1, 0.99), Math.max(high ?? 1, 1.01)];
    const ratios = ["energy_ratio", ...(used("eroded_internal_energy") ? ["energy_ratio_without_eroded"] : [])];
    addChart(grid, "Energy ratio: total over initial plus external work",
      () => ({ x: "time", curves: ratios.map((name, i) => curve(name, "s" + i)) }), { sync, range, height: 320 });
  }
  const small = (title, names) => names.some(used) && addChart(grid, title,
    () => ({ x: "time", curves: names.filter(get).map((name, i) => curve(name, "s" + i)) }), { sync });
  small("Time step", ["time_step"]);
  small("Momentum", ["x_momentum", "y_momentum", "z_momentum"]);
  small("Added mass, percent", ["percent_mass_increase"]);
  document.getElementById("energy").hidden = false;
}
