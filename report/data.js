"use strict";
// What the page carries: JSON in script elements, blocks of numbers as base64 beside them.

/** A parsed JSON element, or `otherwise` when it is missing or broken. */
function readJson(id, otherwise) {
  try {
    return JSON.parse(document.getElementById("data-" + id).textContent) ?? otherwise;
  } catch {
    return otherwise;
  }
}

/** The bytes of a block as an ArrayBuffer. */
function readBlock(id) {
  const text = atob(document.getElementById("data-" + id).textContent);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
}

/** Tables of histories: {name, columns, entities: [{id, rows, column: [array per column]}]}. */
function readHistories() {
  return readJson("histories", []).map((table) => {
    const buffer = readBlock("history-" + table.name);
    let at = 0;
    const entities = table.entities.map(({ id, rows }) => {
      const column = [new Float64Array(buffer, at, rows)];
      at += 8 * rows;
      for (let c = 1; c < table.columns.length; ++c, at += 4 * rows) column.push(new Float32Array(buffer, at, rows));
      at = Math.ceil(at / 8) * 8;
      return { id, rows, column };
    });
    return { ...table, entities };
  });
}

/** A number for people: `digits` significant ones, powers of ten only where they are shorter. */
function numberText(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 10 ** Math.max(digits, 5)) return String(Number(value.toPrecision(digits)));
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return Number(mantissa) + "e" + Number(exponent);
}

/** 1234567 as 1,234,567 with thin spaces. */
function countText(value) {
  return String(Math.round(value)).replace(/\B(?=(\d{3})+$)/g, "\u2009");
}

/** "12.3 s", "4 min 05 s", "2 h 07 min". */
function durationText(seconds) {
  if (seconds < 60) return numberText(seconds, 3) + " s";
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return minutes + " min " + String(Math.round(seconds - 60 * minutes)).padStart(2, "0") + " s";
  return Math.floor(minutes / 60) + " h " + String(minutes % 60).padStart(2, "0") + " min";
}

/** "effective_plastic_strain" as "effective plastic strain". */
function words(name) {
  return name === "von_mises" ? "von Mises stress" : name.replaceAll("_", " ");
}

/** Round numbers inside a range, about `wanted` of them. */
function roundTicks(low, high, wanted) {
  const rough = (high - low) / wanted, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 2.5, 5, 10].map((f) => f * power).find((s) => s >= rough * 0.999);
  const ticks = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * (high - low); ++i) ticks.push(i * step);
  return ticks;
}

/** An element with properties and children. */
function element(tag, properties = {}, ...children) {
  const node = Object.assign(document.createElement(tag), properties);
  node.append(...children.filter((child) => child !== null && child !== undefined));
  return node;
}

/** The value of a colour of the style sheet. */
function styleColour(name) {
  return getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();
}

/** A drop-down menu: options are strings or [value, label]. */
function menu(options, value, change, title) {
  const select = element("select", { title: title ?? "" });
  for (const option of options) {
    const [key, label] = Array.isArray(option) ? option : [option, words(option)];
    select.append(element("option", { value: key, textContent: label }));
  }
  select.value = value;
  select.addEventListener("change", () => change(select.value));
  return select;
}

/** A button that stays down. */
function toggle(label, pressed, change) {
  const button = element("button", { type: "button", className: "quiet", textContent: label });
  const show = () => button.setAttribute("aria-pressed", pressed);
  button.addEventListener("click", () => { pressed = !pressed; show(); change(pressed); });
  show();
  return button;
}
