// The 3D view: WebGL 2, parallel projection, turned with the mouse.

const vertexShader = `#version 300 es
in vec3 position; in vec3 normal; in float value; in vec4 side;
uniform mat3 turn; uniform vec3 centre; uniform vec4 frame;  // frame: scale x, scale y, shift x, shift y
uniform float depth; uniform vec2 range;
out vec3 facing; out float t; out vec4 sides;
void main() {
  vec3 seen = turn * (position - centre);
  facing = turn * normal;
  t = (value - range.x) / (range.y - range.x);
  sides = side;
  gl_Position = vec4(seen.xy * frame.xy + frame.zw, -seen.z * depth, 1.0);
}`;

const fragmentShader = `#version 300 es
precision highp float;
in vec3 facing; in float t; in vec4 sides;
uniform sampler2D colours; uniform float lines; uniform float ratio;
out vec4 pixel;
void main() {
  // Light from beside the eye, as in the static pictures.
  vec3 n = normalize(facing);
  float light = 0.54 + 0.40 * abs(n.z) + 0.24 * (n.z < 0.0 ? -1.0 : 1.0) * (0.55 * n.y - 0.45 * n.x);
  bool known = t > -1e20;
  vec3 colour = known ? texture(colours, vec2(clamp(t, 0.0, 1.0) * (32.0 / 33.0) + 0.5 / 33.0, 0.5)).rgb : vec3(0.66);
  // Mesh lines: distance from the sides in pixels; they fade where elements are as small as pixels.
  vec4 slope = max(fwidth(sides), vec4(1e-6)), away = sides / slope;
  float nearest = min(min(away.x, away.y), min(away.z, away.w)) / ratio;
  float size = 1.0 / (max(max(slope.x, slope.y), max(slope.z, slope.w)) * ratio);
  float dark = lines * 0.5 * clamp((size - 2.5) / 14.0, 0.0, 1.0) * clamp(1.15 - nearest, 0.0, 1.0);
  pixel = vec4(colour * clamp(light, 0.32, 1.08) * (1.0 - dark), 1.0);
}`;

/** Rows: right, up, towards the eye. */
function lookFrom(azimuth, elevation) {
  const [a, e] = [azimuth, elevation].map((degrees) => (degrees * Math.PI) / 180);
  const towards = [Math.cos(e) * Math.cos(a), Math.cos(e) * Math.sin(a), Math.sin(e)];
  const right = [-Math.sin(a), Math.cos(a), 0];
  return [right, cross(towards, right), towards];
}

function cross(a, b) {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

class Viewer {
  constructor(scene, colours) {
    this.scene = scene;
    this.colours = colours;
    this.topologies = scene.topologies.map((t) => new Topology(t));
    this.frames = scene.frames.map((f) => new Frame(scene, f, this.topologies));
    this.canvas = document.getElementById("canvas");
    this.overlay = document.getElementById("overlay");
    this.now = this.frames.length - 1;
    Object.assign(this, { field: 0, smooth: true, lines: true, wholeRange: true });
    this.size = scene.low.map((low, i) => scene.high[i] - low);
    this.radius = Math.hypot(...this.size) / 2 || 1;
    this.centre = scene.low.map((low, i) => low + this.size[i] / 2);
    const flat = this.size[2] < 0.25 * Math.max(this.size[0], this.size[1]);
    this.best = [this.size[0] >= this.size[1] ? -62 : -28, flat ? 42 : 24];
    this.prepare();
    this.look(...this.best);
    new ResizeObserver(() => this.paint()).observe(this.canvas);
    this.listen();
  }

  /** Compiles the program and fills what never changes. Throws when there is no WebGL 2. */
  prepare() {
    const gl = (this.gl = this.canvas.getContext("webgl2", { antialias: true, alpha: true, preserveDrawingBuffer: true }));
    if (!gl) throw new Error("this browser has no WebGL 2");
    const program = (this.program = gl.createProgram());
    for (const [type, source] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]]) {
      const shader = gl.createShader(type);
      gl.shaderSource(shader, source);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      gl.attachShader(program, shader);
    }
    ["position", "normal", "value", "side"].forEach((name, i) => gl.bindAttribLocation(program, i, name));
    gl.linkProgram(program);
    gl.useProgram(program);
    gl.enable(gl.DEPTH_TEST);
    this.buffers = { position: gl.createBuffer(), normal: gl.createBuffer(), value: gl.createBuffer(),
      side: gl.createBuffer(), index: gl.createBuffer() };
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    const texels = new Uint8Array(this.colours.flatMap((c) => [c >> 16, (c >> 8) & 255, c & 255, 255]));
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA, this.colours.length, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    for (const [name, value] of [[gl.TEXTURE_MIN_FILTER, gl.LINEAR], [gl.TEXTURE_MAG_FILTER, gl.LINEAR],
      [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE], [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]])
      gl.texParameteri(gl.TEXTURE_2D, name, value);
  }

  // --- what is shown --------------------------------------------------------------------------------
  get frame() { return this.frames[this.now]; }

  /** Ends of the colours; from 0 where the field nearly starts there. */
  get range() {
    const { low, high } = this.scene.fields[this.field];
    const [from, to] = this.wholeRange ? [low, high] : this.frame.range(this.field);
    const start = from > 0 && from < 0.1 * to ? 0 : from;
    return [start, to > start ? to : start + 1];
  }

  set(change) {
    Object.assign(this, change);
    this.loaded = null;
    this.paint();
    this.changed?.();
  }

  look(azimuth, elevation) {
    this.turn = lookFrom(azimuth, elevation);
    this.fit();
  }

  /** Frames the first and the last moment as seen from here; turning later keeps the scale. */
  fit() {
    const low = [Infinity, Infinity], high = [-Infinity, -Infinity];
    for (const { position: p } of [this.frames[0], this.frames.at(-1)])
      for (let i = 0; i < p.length; i += 3)
        for (const row of [0, 1]) {
          const t = this.turn[row];
          const at = t[0] * (p[i] - this.centre[0]) + t[1] * (p[i + 1] - this.centre[1]) + t[2] * (p[i + 2] - this.centre[2]);
          if (at < low[row]) low[row] = at;
          if (at > high[row]) high[row] = at;
        }
    this.extent = high.map((v, row) => v - low[row] || 1);
    this.middle = high.map((v, row) => (v + low[row]) / 2);
    this.zoom = 1;
    this.shift = [0, 0];
    this.paint();
  }

  /** Pixels per length, and where the model's centre lies; the model keeps clear of the colour bar. */
  placing() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    const bar = width > 700 ? 150 : 90;
    const scale = this.zoom * Math.min((0.9 * (width - bar)) / this.extent[0], (0.88 * height) / this.extent[1]);
    return { scale, x: (width - bar) / 2 - scale * this.middle[0] + this.shift[0],
      y: height / 2 + scale * this.middle[1] + this.shift[1] };
  }

  // --- painting -------------------------------------------------------------------------------------
  paint() {
    this.asked ??= requestAnimationFrame(() => {
      this.asked = null;
      this.paintNow();
    });
  }

  load() {
    const { gl, frame, buffers } = this, key = [this.now, this.field, this.smooth].join();
    if (this.loaded === key) return;
    const attribute = (i, buffer, data, size, type, normalised) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
      gl.enableVertexAttribArray(i);
      gl.vertexAttribPointer(i, size, type, normalised, 0, 0);
    };
    attribute(0, buffers.position, frame.cornerPositions(), 3, gl.FLOAT, false);
    attribute(1, buffers.normal, frame.cornerNormals(), 3, gl.BYTE, true);
    attribute(2, buffers.value, frame.cornerValues(this.field, this.smooth), 1, gl.FLOAT, false);
    if (this.shownTopology !== frame.topology) {
      attribute(3, buffers.side, frame.topology.sideDistances(), 4, gl.UNSIGNED_BYTE, true);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffers.index);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, frame.topology.triangles(), gl.DYNAMIC_DRAW);
      this.shownTopology = frame.topology;
    }
    this.loaded = key;
    this.projected = null;
  }

  paintNow() {
    const { gl, program, canvas } = this, ratio = window.devicePixelRatio || 1;
    const width = canvas.clientWidth, height = canvas.clientHeight;
    if (!width || !height) return;
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
    gl.viewport(0, 0, canvas.width, canvas.height);
    this.load();
    const { scale, x, y } = this.placing();
    const uniform = (name) => gl.getUniformLocation(program, name);
    // Columns of the matrix, as the language has them.
    gl.uniformMatrix3fv(uniform("turn"), false, [0, 1, 2].flatMap((i) => this.turn.map((row) => row[i])));
    gl.uniform3fv(uniform("centre"), this.centre);
    gl.uniform4f(uniform("frame"), (2 * scale) / width, (2 * scale) / height, (2 * x) / width - 1, 1 - (2 * y) / height);
    gl.uniform1f(uniform("depth"), 0.5 / this.radius);
    gl.uniform2fv(uniform("range"), this.range);
    gl.uniform1f(uniform("lines"), this.lines ? 1 : 0);
    gl.uniform1f(uniform("ratio"), ratio);
    gl.clearColor(0, 0, 0, 0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.drawElements(gl.TRIANGLES, 6 * this.frame.topology.faces, gl.UNSIGNED_INT, 0);
    this.projected = null;
    this.paintAxes(ratio);
    this.paintBar();
  }

  paintAxes(ratio) {
    const { overlay } = this, pen = overlay.getContext("2d"), length = 38;
    overlay.width = overlay.clientWidth * ratio;
    overlay.height = overlay.clientHeight * ratio;
    pen.scale(ratio, ratio);
    pen.translate(62, overlay.clientHeight - 62);
    pen.font = "13px system-ui, 'DejaVu Sans', sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.lineWidth = 2;
    const axes = ["x", "y", "z"].map((name, i) => ({ name, end: this.turn.map((row) => row[i]), colour: ["#c63d38", "#388c40", "#3f6fd0"][i] }));
    for (const { name, end, colour } of axes.sort((a, b) => a.end[2] - b.end[2])) {
      const [dx, dy] = [end[0] * length, -end[1] * length], long = Math.hypot(dx, dy);
      if (long < 0.12 * length) continue;
      pen.strokeStyle = colour;
      pen.beginPath();
      pen.moveTo(0, 0);
      pen.lineTo(dx, dy);
      pen.stroke();
      pen.fillStyle = styleColour("soft");
      pen.fillText(name, dx * (1 + 12 / long), dy * (1 + 12 / long));
    }
  }

  paintBar() {
    const bar = document.getElementById("bar"), [low, high] = this.range;
    const hex = this.colours.map((c) => "#" + c.toString(16).padStart(6, "0"));
    bar.style.background = `linear-gradient(to top, ${hex.join(",")})`;
    const mark = (value, className) => {
      const label = element("span", { className, textContent: numberText(value) });
      label.style.top = `${100 * (1 - (value - low) / (high - low))}%`;
      return label;
    };
    const near = (high - low) * 0.045;
    const inner = roundTicks(low, high, 8).filter((v) => v - low > near && high - v > near);
    bar.replaceChildren(element("em", { textContent: words(this.scene.fields[this.field].name) }),
      mark(low, "end"), ...inner.map((v) => mark(v, "")), mark(high, "end"));
  }

  // --- the mouse ------------------------------------------------------------------------------------
  /** Turns about the picture's axes, then makes the rows orthonormal again. */
  rotate(dx, dy) {
    const spin = (rows, i, j, angle) => {
      const [c, s] = [Math.cos(angle), Math.sin(angle)], [a, b] = [rows[i], rows[j]];
      rows[i] = a.map((v, k) => c * v + s * b[k]);
      rows[j] = a.map((v, k) => -s * v + c * b[k]);
    };
    spin(this.turn, 0, 2, -dx * 0.008);
    spin(this.turn, 1, 2, dy * 0.008);
    const unit = (v) => v.map((x) => x / Math.hypot(...v));
    const towards = unit(this.turn[2]), right = unit(cross(this.turn[1], towards));
    this.turn = [right, cross(towards, right), towards];
    this.paint();
  }

  /** Zooms about a point of the canvas. */
  zoomAt(factor, px, py) {
    const { x, y } = this.placing();
    this.zoom *= factor;
    this.shift[0] += (px - x) * (1 - factor);
    this.shift[1] += (py - y) * (1 - factor);
    this.paint();
  }

  listen() {
    const { canvas } = this, pointers = new Map();
    canvas.addEventListener("pointerdown", (event) => {
      canvas.setPointerCapture(event.pointerId);
      pointers.set(event.pointerId, [event.offsetX, event.offsetY]);
      canvas.classList.add("busy");
      this.hide();
    });
    const up = (event) => {
      pointers.delete(event.pointerId);
      canvas.classList.remove("busy");
    };
    canvas.addEventListener("pointerup", up);
    canvas.addEventListener("pointercancel", up);
    canvas.addEventListener("pointerleave", () => this.hide());
    canvas.addEventListener("contextmenu", (event) => event.preventDefault());
    canvas.addEventListener("pointermove", (event) => {
      const here = [event.offsetX, event.offsetY], before = pointers.get(event.pointerId);
      if (!before) return this.point(...here);
      const [dx, dy] = [here[0] - before[0], here[1] - before[1]];
      if (pointers.size === 2) {  // two fingers: pinch and move
        const [other] = [...pointers].filter(([id]) => id !== event.pointerId).map(([, at]) => at);
        const apart = (p) => Math.hypot(p[0] - other[0], p[1] - other[1]) || 1;
        this.zoomAt(apart(here) / apart(before), (here[0] + other[0]) / 2, (here[1] + other[1]) / 2);
        this.shift = [this.shift[0] + dx / 2, this.shift[1] + dy / 2];
      } else if (event.shiftKey || event.buttons & 6) {
        this.shift = [this.shift[0] + dx, this.shift[1] + dy];
        this.paint();
      } else {
        this.rotate(dx, dy);
      }
      pointers.set(event.pointerId, here);
    });
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      this.zoomAt(Math.exp(-event.deltaY * 0.0015), event.offsetX, event.offsetY);
    }, { passive: false });
    canvas.addEventListener("dblclick", () => this.fit());
  }

  hide() {
    document.getElementById("hover").hidden = true;
  }

  /** Nodes in the picture: x, y in pixels and the depth towards the eye. */
  project() {
    if (this.projected) return this.projected;
    const { scale, x, y } = this.placing(), p = this.frame.position, out = new Float32Array(p.length), t = this.turn;
    for (let i = 0; i < p.length; i += 3) {
      const [a, b, c] = [p[i] - this.centre[0], p[i + 1] - this.centre[1], p[i + 2] - this.centre[2]];
      out[i] = x + scale * (t[0][0] * a + t[0][1] * b + t[0][2] * c);
      out[i + 1] = y - scale * (t[1][0] * a + t[1][1] * b + t[1][2] * c);
      out[i + 2] = t[2][0] * a + t[2][1] * b + t[2][2] * c;
    }
    return (this.projected = out);
  }

  /** The face under a point, with the weights of its three corners; null beside the model. */
  pick(px, py) {
    const s = this.project(), { node, faces } = this.frame.topology;
    let best = null, depth = -Infinity;
    for (let f = 0; f < faces; ++f) {
      for (const [i, j, k] of [[0, 1, 2], [0, 2, 3]]) {
        const [a, b, c] = [3 * node[4 * f + i], 3 * node[4 * f + j], 3 * node[4 * f + k]];
        const area = (s[b] - s[a]) * (s[c + 1] - s[a + 1]) - (s[c] - s[a]) * (s[b + 1] - s[a + 1]);
        if (!area) continue;
        const u = ((s[b] - px) * (s[c + 1] - py) - (s[c] - px) * (s[b + 1] - py)) / area;
        const v = ((s[c] - px) * (s[a + 1] - py) - (s[a] - px) * (s[c + 1] - py)) / area;
        const w = 1 - u - v;
        if (u < 0 || v < 0 || w < 0) continue;
        const here = u * s[a + 2] + v * s[b + 2] + w * s[c + 2];
        if (here > depth) [depth, best] = [here, { face: f, corners: [[a / 3, u], [b / 3, v], [c / 3, w]] }];
      }
    }
    return best;
  }

  /** Shows what lies under the mouse. */
  point(px, py) {
    this.pointed = [px, py];
    this.pointing ??= requestAnimationFrame(() => {
      this.pointing = null;
      this.showPoint(...this.pointed);
    });
  }

  showPoint(px, py) {
    const found = this.pick(px, py), hover = document.getElementById("hover");
    hover.hidden = !found;
    if (!found) return;
    const { frame, field } = this, { name, on } = this.scene.fields[field];
    const mix = (value) => found.corners.reduce((sum, [n, weight]) => sum + weight * value(n), 0);
    const value = on === "face" ? frame.value(field, found.face) : mix((n) => frame.value(field, n));
    const at = [0, 1, 2].map((i) => numberText(mix((n) => frame.position[3 * n + i]))).join(",  ");
    hover.replaceChildren(element("b", { textContent: numberText(value) }), " " + words(name), element("br"),
      "element " + frame.topology.element[found.face], element("br"), "at " + at);
    const room = this.canvas.clientWidth - hover.offsetWidth - 8;
    hover.style.left = Math.min(px + 16, room) + "px";
    hover.style.top = Math.max(py - hover.offsetHeight - 12, 6) + "px";
  }
}
