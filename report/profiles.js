// Bodies in one dimension: a field over place and time as a picture, and along the line at one instant.

/** Blue below zero, red above, lightness falling evenly away from the paper. */
function signedColour(share, dark) {
  const paper = dark ? [30, 34, 40] : [255, 255, 255], end = share < 0 ? [33, 102, 172] : [178, 24, 43];
  const s = Math.min(1, Math.abs(share)) ** 0.8;
  return paper.map((v, i) => Math.round(v + s * (end[i] - v)));
}

class Profiles {
  constructor(data) {
    Object.assign(this, data);
    this.x = new Float32Array(readBlock("profile-x"));
    this.values = this.fields.map(({ name }) => new Float32Array(readBlock("profile-" + name)));
    const velocity = this.fields.findIndex(({ name }) => name === "velocity");
    this.field = velocity < 0 ? 0 : velocity;
    this.now = this.times.length - 1;
    document.getElementById("profiles").hidden = false;
    document.getElementById("profile-tools").append(element("label", {}, "Field",
      menu(this.fields.map(({ name }, i) => [String(i), words(name)]), String(this.field),
        (i) => { this.field = Number(i); this.paint(); this.chart.draw(); }, "field of the profiles")));
    this.canvas = document.getElementById("profile-picture");
    this.canvas.addEventListener("pointermove", (event) => {
      const share = 1 - event.offsetY / this.canvas.clientHeight;
      this.show(this.nearest(this.times[0] + share * (this.times.at(-1) - this.times[0])));
    });
    const range = () => {
      const { low, high } = this.fields[this.field], more = 0.05 * (high - low || Math.abs(high) || 1);
      return [low - more, high + more];
    };
    this.chart = addChart(document.getElementById("profile-plot"), "At one instant", () => {
      const count = this.points, begin = this.now * count;
      return { x: "x", curves: [{ label: words(this.fields[this.field].name), x: this.x,
        y: this.values[this.field].subarray(begin, begin + count), colour: styleColour("s0") }] };
    }, { range, height: 300 });
    this.slider = element("input", { type: "range", min: 0, max: this.times.length - 1, step: 1, ariaLabel: "instant" });
    this.output = element("output");
    this.slider.addEventListener("input", () => this.show(Number(this.slider.value)));
    document.getElementById("profile-player").append(this.slider, this.output);
    this.show(this.now);
    new ResizeObserver(() => this.paint()).observe(this.canvas);
  }

  nearest(time) {
    let best = 0;
    this.times.forEach((t, i) => { if (Math.abs(t - time) < Math.abs(this.times[best] - time)) best = i; });
    return best;
  }

  show(n) {
    this.now = n;
    this.slider.value = n;
    this.output.textContent = `t = ${numberText(this.times[n])}   (${n + 1} of ${this.times.length})`;
    this.chart.draw();
    this.paint();
  }

  /** Place to the right, time upwards, linear between frames and between points. */
  paint() {
    const width = Math.max(2, Math.round(this.canvas.clientWidth)), height = 300;
    Object.assign(this.canvas, { width, height });
    const { low, high } = this.fields[this.field], most = Math.max(Math.abs(low), Math.abs(high)) || 1;
    const dark = document.documentElement.dataset.theme === "dark", n = this.points, value = this.values[this.field];
    const image = new ImageData(width, height), from = this.times[0], span = this.times.at(-1) - from || 1;
    const left = this.x[0], length = this.x[n - 1] - left || 1;
    const column = new Float64Array(width);   // the point before each column, and how far beyond it
    for (let i = 0, p = 0; i < width; ++i) {
      const x = left + (i + 0.5) / width * length;
      while (p < n - 2 && this.x[p + 1] <= x) ++p;
      const gap = this.x[p + 1] - this.x[p];
      column[i] = p + (gap > 0 ? Math.min(0.999999, Math.max(0, (x - this.x[p]) / gap)) : 0);
    }
    for (let j = 0, f = 0; j < height; ++j) {
      const t = from + (j + 0.5) / height * span;
      while (f < this.times.length - 2 && this.times[f + 1] <= t) ++f;
      const part = Math.min(1, Math.max(0, (t - this.times[f]) / (this.times[f + 1] - this.times[f] || 1)));
      for (let i = 0; i < width; ++i) {
        const p = Math.floor(column[i]), s = column[i] - p;
        const at = (frame) => (1 - s) * value[frame * n + p] + s * value[frame * n + p + 1];
        image.data.set([...signedColour(((1 - part) * at(f) + part * at(f + 1)) / most, dark), 255],
          4 * ((height - 1 - j) * width + i));
      }
    }
    const context = this.canvas.getContext("2d");
    context.putImageData(image, 0, 0);
    const y = height * (1 - (this.times[this.now] - from) / span);
    context.strokeStyle = styleColour("soft");
    context.beginPath();
    context.moveTo(0, y);
    context.lineTo(width, y);
    context.stroke();
    document.getElementById("profile-axes").textContent =
      `x from ${numberText(left)} to ${numberText(left + length)} to the right, t from ${numberText(from)} to ` +
      `${numberText(from + span)} upwards; ${words(this.fields[this.field].name)} from ${numberText(low)} (blue: below ` +
      `zero) to ${numberText(high)} (red). Point at an instant to see it along the line.`;
  }
}
