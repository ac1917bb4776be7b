// Puts the page together from the summary and whatever else the run left.

const summary = readJson("summary", null);

/** A value of the summary by its path, undefined where it is missing. */
function fact(path) {
  return path.split(".").reduce((node, step) => node?.[step], summary ?? {});
}

function known(value) {
  return value !== null && value !== undefined && value !== "";
}

function badge(text, tone) {
  return element("span", { className: "badge " + tone, textContent: text });
}

function showHead() {
  const title = (fact("title") ?? "").trim() || "Untitled run";
  document.title = title + " – cleave";
  document.getElementById("title").textContent = title;
  const origin = [fact("deck"), known(fact("version")) && "version " + fact("version")];
  document.getElementById("origin").textContent = origin.filter(Boolean).join("  ·  ");
  const ending = document.getElementById("ending");
  if (!summary) return ending.append(badge("no summary", "warn"), "The run goes on, or was killed.");
  const text = fact("ending_text") ?? words(fact("ending") ?? "");
  ending.append(badge(fact("normal") ? "normal termination" : "error termination", fact("normal") ? "good" : "bad"),
    text && text[0].toUpperCase() + text.slice(1) + ".");
  const failure = fact("failure");
  if (failure) ending.append(`Part ${failure.part}, element ${failure.element}: ${failure.what}. ${failure.likely_cause ?? ""}`);
  if (known(fact("files_failed"))) ending.append(badge("files missing", "bad"), fact("files_failed"));
  const unsupported = fact("unsupported") ?? [];
  if (unsupported.length) ending.append(badge("unsupported input", "warn"), unsupported.join(", "));
  if (fact("warnings")) ending.append(badge(fact("warnings") === 1 ? "1 warning" : fact("warnings") + " warnings", "plain"));
}

function showFigures() {
  const box = document.getElementById("figures");
  const tile = (value, label, more) => known(value) && value !== "–" && box.append(element("div", { className: "tile" },
    element("b", { textContent: value }), element("span", { textContent: label }),
    element("i", { textContent: more ?? "" })));
  const number = (path, digits) => (known(fact(path)) ? numberText(fact(path), digits) : null);
  const count = (path) => (known(fact(path)) ? countText(fact(path)) : null);
  const step = fact("time_step"), eroded = fact("eroded_elements"), energy = fact("energy"), mass = fact("mass");
  tile(number("final_time"), "final time", known(fact("cycles")) && count("cycles") + " cycles");
  tile(count("counts.elements"), "elements", [count("counts.nodes") + " nodes", eroded && countText(eroded) + " eroded"].filter(Boolean).join(", "));
  if (energy) tile(numberText(energy.ratio, 5), "energy ratio", `${numberText(energy.ratio_low, 5)} to ${numberText(energy.ratio_high, 5)}`);
  if (energy?.internal) tile(numberText((100 * energy.hourglass) / energy.internal, 3) + " %", "hourglass energy", "of internal energy");
  if (step) tile(numberText(step.last), "last time step", "smallest " + numberText(step.smallest));
  if (mass?.added) tile(numberText(mass.percent_increase, 3) + " %", "added mass", numberText(mass.added) + " of " + numberText(mass.total));
  const speed = fact("speed");
  if (!speed) return;
  tile(durationText(speed.seconds), "time in the loop", speed.threads + (speed.threads === 1 ? " thread" : " threads"));
  tile(numberText(speed.element_cycles_per_second / 1e6, 3) + " M/s", "element-cycles", numberText(speed.nanoseconds_per_element_cycle, 3) + " ns each");
}

const policies = { honoured: ["honoured", "good"], in_part: ["in part", "warn"], output_only: ["output only", "plain"],
  refused: ["refused", "bad"], unknown: ["unknown", "bad"] };

function showKeywords() {
  const account = fact("deck_account") ?? [];
  if (!account.length) return;
  document.getElementById("keywords").hidden = false;
  const tally = Object.entries(policies)
    .map(([key, [label]]) => [account.filter((entry) => entry.policy === key).length, label])
    .filter(([n]) => n).map(([n, label]) => `${n} ${label}`);
  document.getElementById("keyword-count").textContent = tally.join(" · ");
  const table = document.getElementById("keyword-table");
  const cell = (text, className = "") => element("td", { className, textContent: text });
  table.append(element("tr", {}, ...["Keyword", "Taken as", "Cards", "Fields by default", "Not honoured", "Remark"].map((text, i) =>
    element("th", { textContent: text, className: i === 2 || i === 3 ? "number" : "" }))));
  for (const entry of account) {
    const [label, tone] = policies[entry.policy] ?? [entry.policy, "plain"];
    table.append(element("tr", {}, element("td", {}, element("code", { textContent: "*" + entry.keyword.replace(/^\*/, "") })),
      element("td", {}, badge(label, tone)), cell(countText(entry.cards ?? 0), "number"),
      cell(entry.defaulted ? countText(entry.defaulted) : "", "number soft"),
      cell((entry.ignored_fields ?? []).join(", ")), cell(entry.remark ?? "", "soft")));
  }
}

function showPhases() {
  const phases = Object.entries(fact("speed.phases") ?? {}).filter(([, seconds]) => seconds > 0);
  const total = Math.max(fact("speed.seconds") ?? 0, phases.reduce((sum, [, s]) => sum + s, 0));
  if (!phases.length || !total) return;
  document.getElementById("phases").hidden = false;
  phases.sort((a, b) => b[1] - a[1]);
  const rest = total - phases.reduce((sum, [, s]) => sum + s, 0);
  if (rest > 0.005 * total) phases.push(["other", rest]);
  const bar = document.getElementById("phase-bar"), table = document.getElementById("phase-table");
  phases.forEach(([name, seconds], n) => {
    const colour = name === "other" ? "var(--faint)" : `var(--s${n % 8})`, share = (100 * seconds) / total;
    const part = element("div", { title: `${name}: ${share.toFixed(1)} %` });
    part.style.cssText = `flex: ${share} 0 0; background: ${colour}`;
    bar.append(part);
    const key = element("i");
    key.style.background = colour;
    table.append(element("tr", {}, element("td", {}, key, words(name)),
      element("td", { className: "number", textContent: durationText(seconds) }),
      element("td", { className: "number soft", textContent: share.toFixed(1) + " %" })));
  });
}

/** Size, mass and energy of each part, before and after. */
function showParts() {
  const parts = fact("parts") ?? [];
  if (!parts.length) return;
  document.getElementById("parts").hidden = false;
  const lengths = (extent) => (extent?.length ?? []).map((v) => numberText(v, 5)).join(" × ");
  const columns = [
    ["Part", (part) => part.id, "number"], ["Title", (part) => part.title],
    ["Elements", (part) => countText(part.elements), "number"],
    ["Eroded", (part) => (part.eroded_elements ? countText(part.eroded_elements) : ""), "number"],
    ["Mass", (part) => numberText(part.mass, 5), "number"],
    ["Kinetic energy", (part) => numberText(part.kinetic_energy, 5), "number"],
    ["Internal energy", (part) => numberText(part.internal_energy, 5), "number"],
    ["Size x × y × z at first", (part) => lengths(part.initial), "number"],
    ["at last", (part) => lengths(part.final), "number"],
    ["Diameter", (part) => [part.initial, part.final].map((e) => numberText(e?.diameter, 5)).join(" → "), "number"]];
  const used = columns.filter(([, value]) => parts.some((part) => !/^[–→ ]*$/.test(String(value(part) ?? ""))));
  document.getElementById("part-table").append(
    element("tr", {}, ...used.map(([textContent, , className = ""]) => element("th", { textContent, className }))),
    ...parts.map((part) => element("tr", {}, ...used.map(([, value, className = ""]) =>
      element("td", { className, textContent: value(part) ?? "" })))));
}

/** Everything the summary says that has no place above. */
function showMore() {
  const list = document.getElementById("more-list");
  const line = (name, value) => list.append(element("div", {}, element("span", { textContent: name }), element("b", { textContent: value })));
  const shown = new Set(["title", "program", "version", "deck", "ending", "ending_text", "normal", "failure", "files_failed",
    "final_time", "cycles", "deck_account", "unsupported", "warnings", "speed", "time_step", "eroded_elements", "parts"]);
  const walk = (name, value) => {
    if (!known(value)) return;
    if (typeof value === "number") line(name, Number.isInteger(value) && Math.abs(value) < 1e15 ? countText(value) : numberText(value, 6));
    else if (Array.isArray(value) && value.every((v) => typeof v !== "object")) {
      if (value.length) line(name, value.map((v) => (typeof v === "number" ? numberText(v, 6) : v)).join(",  "));
    } else if (Array.isArray(value)) value.forEach((v, i) => walk(`${name.replace(/s$/, "")} ${v.id ?? i + 1}`, v));
    else if (typeof value === "object") for (const key of Object.keys(value)) key !== "id" && walk(`${name}: ${words(key)}`, value[key]);
    else line(name, String(value));
  };
  for (const key of Object.keys(summary ?? {})) if (!shown.has(key)) walk(words(key), summary[key]);
  document.getElementById("more").hidden = !list.children.length;
}

function showPictures() {
  const captions = { picture: "The last state.", initial: "The state at the start." };
  for (const name of readJson("pictures", []).reverse()) {
    document.getElementById("pictures").hidden = false;
    const image = element("img", { alt: captions[name] ?? name,
      src: "data:image/png;base64," + document.getElementById("data-image-" + name).textContent });
    document.getElementById("picture-list").append(element("figure", {}, image,
      element("figcaption", { textContent: `${captions[name] ?? ""} ${name}.png in the run directory.` })));
  }
}

function showNotes(notes) {
  document.getElementById("remarks").hidden = !notes.length;
  document.getElementById("remark-list").replaceChildren(...notes.map((text) => element("li", { textContent: text })));
}

/** The tools above the 3D view and the slider below it. */
function showModel(scene, colours, notes) {
  document.getElementById("model").hidden = false;
  let viewer;
  try {
    viewer = new Viewer(scene, colours);
  } catch (problem) {
    document.getElementById("model").hidden = true;
    notes.push(`There is no 3D view: ${problem.message}. The pictures below need none.`);
    return;
  }
  const views = [["3/4", viewer.best], ["front", [-90, 0]], ["right", [0, 0]], ["top", [-90, 89.999]], ["below", [-90, -89.999]]];
  const group = element("span", { className: "group" });
  for (const [label, angles] of views)
    group.append(element("button", { type: "button", className: "quiet", textContent: label, onclick: () => viewer.look(...angles) }));
  document.getElementById("model-tools").append(
    element("label", {}, "Colour", menu(scene.fields.map(({ name }, i) => [String(i), words(name)]), "0",
      (i) => viewer.set({ field: Number(i) }), "field")),
    element("label", {}, "range of", menu([["all", "all frames"], ["now", "this frame"]], "all",
      (which) => viewer.set({ wholeRange: which === "all" }), "range of the colours")),
    toggle("averaged at nodes", true, (smooth) => viewer.set({ smooth })),
    toggle("mesh", true, (lines) => viewer.set({ lines })), group);

  const last = viewer.frames.length - 1;
  const slider = element("input", { type: "range", min: 0, max: last, value: last, step: 1, ariaLabel: "frame" });
  const time = element("output"), play = element("button", { type: "button", className: "quiet", textContent: "Play" });
  let playing = null;
  const show = (n) => {
    slider.value = n;
    time.textContent = `t = ${numberText(viewer.frames[n].time)}   (${n + 1} of ${last + 1})`;
    viewer.hide();
    viewer.set({ now: n });
  };
  const stop = () => { clearInterval(playing); playing = null; play.textContent = "Play"; };
  slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
  play.addEventListener("click", () => {
    if (playing) return stop();
    play.textContent = "Stop";
    if (viewer.now === last) show(0);
    playing = setInterval(() => { if (viewer.now === last) stop(); else show(viewer.now + 1); }, 160);
  });
  if (last > 0) document.getElementById("player").append(play, slider, time);
  show(last);
  return viewer;
}

function start() {
  const notes = readJson("notes", []), tables = readHistories(), scene = readJson("scene", null);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const setTheme = (theme) => { document.documentElement.dataset.theme = theme; };
  setTheme(dark.matches ? "dark" : "light");
  showHead();
  showFigures();
  const viewer = scene && showModel(scene, readJson("colours", []), notes);
  const line = readJson("profiles", null), profiles = line && new Profiles(line);
  const whole = tables.find((table) => table.name === "glstat");
  if (whole) showEnergy(whole);
  showHistories(tables);
  showPictures();
  showParts();
  showKeywords();
  showPhases();
  showMore();
  showNotes(notes);
  document.getElementById("footer").textContent = "Written by cleave view. Numbers are in the units of the deck.";
  const change = (theme) => {
    setTheme(theme);
    redrawCharts();
    viewer?.paint();
    profiles?.paint();
  };
  document.getElementById("theme").addEventListener("click", () =>
    change(document.documentElement.dataset.theme === "dark" ? "light" : "dark"));
  dark.addEventListener("change", () => change(dark.matches ? "dark" : "light"));
  // Paper is white whatever the screen is.
  let before = null;
  addEventListener("beforeprint", () => { before = document.documentElement.dataset.theme; change("light"); });
  addEventListener("afterprint", () => change(before));
  document.documentElement.dataset.ready = viewer ? "with model" : "without model";
}

start();
