// The surface of the model: decoded frames, normals, values at corners.

const noNumber = 65535, steps = 65534;
const notShown = -3e38;  // a value without a colour: shaders cannot be trusted with NaN

/** Faces that several frames share. */
class Topology {
  constructor({ block, faces, nodes }) {
    const buffer = readBlock(block);
    this.faces = faces;
    this.nodes = nodes;
    this.element = new Float64Array(buffer, 0, faces);
    this.node = new Uint32Array(buffer, 8 * faces, 4 * faces);
    this.edges = new Uint8Array(buffer, 24 * faces, faces);
    this.cornersByNode();
  }

  isTriangle(face) {
    return this.node[4 * face + 3] === this.node[4 * face + 2];
  }

  /** Corners around each node: around[begin[n]] .. around[begin[n + 1] - 1] are 4 * face + corner. */
  cornersByNode() {
    const each = (visit) => {
      for (let f = 0; f < this.faces; ++f)
        for (let k = 0; k < (this.isTriangle(f) ? 3 : 4); ++k) visit(this.node[4 * f + k], 4 * f + k);
    };
    this.begin = new Uint32Array(this.nodes + 1);
    each((n) => { ++this.begin[n + 1]; });
    for (let n = 0; n < this.nodes; ++n) this.begin[n + 1] += this.begin[n];
    this.around = new Uint32Array(this.begin[this.nodes]);
    const next = this.begin.slice();
    each((n, corner) => { this.around[next[n]++] = corner; });
  }

  /** Two triangles per face, as indices of corners. */
  triangles() {
    const index = new Uint32Array(6 * this.faces);
    for (let f = 0; f < this.faces; ++f) index.set([0, 1, 2, 0, 2, 3].map((k) => 4 * f + k), 6 * f);
    return index;
  }

  /** Distance from each side at each corner, 0 or 255; sides that are no edge of the element are 255 everywhere. */
  sideDistances() {
    const distance = new Uint8Array(16 * this.faces).fill(255);
    for (let f = 0; f < this.faces; ++f) {
      const sides = this.isTriangle(f) ? 3 : 4;
      for (let side = 0; side < sides; ++side) {
        if (!((this.edges[f] >> side) & 1)) continue;
        for (const k of [side, (side + 1) % sides]) distance[16 * f + 4 * k + side] = 0;
      }
      if (sides === 3) distance.copyWithin(16 * f + 12, 16 * f + 8, 16 * f + 12);
    }
    return distance;
  }
}

/** One moment: positions, and the fields in 16 bits. */
class Frame {
  constructor(scene, { time, topology, block }, topologies) {
    this.time = time;
    this.topology = topologies[topology];
    this.scene = scene;
    const numbers = new Uint16Array(readBlock(block)), { nodes, faces } = this.topology;
    this.position = new Float32Array(3 * nodes);
    for (let i = 0; i < 3 * nodes; ++i) {
      const low = scene.low[i % 3], high = scene.high[i % 3];
      this.position[i] = numbers[i] === noNumber ? NaN : low + ((high - low) * numbers[i]) / steps;
    }
    let at = 3 * nodes;
    this.raw = scene.fields.map(({ on }) => {
      const count = on === "face" ? faces : nodes;
      return numbers.subarray(at, (at += count));
    });
    this.cache = new Map();
  }

  /** Value of a field at one of its faces or nodes; NaN where there is none. */
  value(field, i) {
    const { low, high } = this.scene.fields[field], raw = this.raw[field][i];
    return raw === noNumber ? NaN : low + ((high - low) * raw) / steps;
  }

  once(key, make) {
    if (!this.cache.has(key)) this.cache.set(key, make());
    return this.cache.get(key);
  }

  /** Least and greatest value of a field in this frame. */
  range(field) {
    return this.once("range" + field, () => {
      let low = Infinity, high = -Infinity;
      for (let i = 0; i < this.raw[field].length; ++i) {
        const v = this.value(field, i);
        if (v < low) low = v;
        if (v > high) high = v;
      }
      return low <= high ? [low, high] : [0, 1];
    });
  }

  /** [face][corner][3] */
  cornerPositions() {
    const { node } = this.topology, corners = new Float32Array(3 * node.length);
    for (let c = 0; c < node.length; ++c)
      for (let i = 0; i < 3; ++i) corners[3 * c + i] = this.position[3 * node[c] + i];
    return corners;
  }

  /** [face][corner]: of the face's element, or averaged at nodes. */
  cornerValues(field, smooth) {
    return this.once(`values${field}${smooth}`, () => {
      const { node, nodes, begin, around, faces } = this.topology, corners = new Float32Array(node.length);
      if (this.scene.fields[field].on === "node") {
        for (let c = 0; c < node.length; ++c) corners[c] = this.value(field, node[c]);
      } else if (smooth) {
        const own = Float32Array.from({ length: faces }, (_, f) => this.value(field, f));
        const mean = new Float32Array(nodes);
        for (let n = 0; n < nodes; ++n) {
          let sum = 0;
          for (let i = begin[n]; i < begin[n + 1]; ++i) sum += own[around[i] >> 2];
          mean[n] = sum / (begin[n + 1] - begin[n]);
        }
        for (let c = 0; c < node.length; ++c) corners[c] = mean[node[c]];
      } else {
        for (let c = 0; c < node.length; ++c) corners[c] = this.value(field, c >> 2);
      }
      return corners.map((v) => (Number.isNaN(v) ? notShown : v));
    });
  }

  /** [face][corner][3] in steps of 1/127: smooth on curved skin, sharp where faces meet at more than 35 degrees. */
  cornerNormals() {
    return this.once("normals", () => {
      const { node, begin, around, faces } = this.topology, p = this.position;
      const area = new Float64Array(4 * faces);  // normal times twice the area, and its length
      for (let f = 0; f < faces; ++f) {
        const [a, b, c, d] = node.subarray(4 * f, 4 * f + 4).map((n) => 3 * n);
        const ux = p[c] - p[a], uy = p[c + 1] - p[a + 1], uz = p[c + 2] - p[a + 2];
        const vx = p[d] - p[b], vy = p[d + 1] - p[b + 1], vz = p[d + 2] - p[b + 2];
        const n = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
        area.set([...n, Math.hypot(...n)], 4 * f);
      }
      const crease = Math.cos((35 * Math.PI) / 180), normals = new Int8Array(3 * node.length);
      for (let c = 0; c < node.length; ++c) {
        const own = 4 * (c >> 2), n = node[c];
        let x = 0, y = 0, z = 0;
        for (let i = begin[n]; i < begin[n + 1]; ++i) {
          const other = 4 * (around[i] >> 2);
          const cosine = area[own] * area[other] + area[own + 1] * area[other + 1] + area[own + 2] * area[other + 2];
          if (other !== own && cosine < crease * area[own + 3] * area[other + 3]) continue;
          x += area[other];
          y += area[other + 1];
          z += area[other + 2];
        }
        const length = Math.hypot(x, y, z) || 1;
        normals[3 * c] = Math.round((127 * x) / length);
        normals[3 * c + 1] = Math.round((127 * y) / length);
        normals[3 * c + 2] = Math.round((127 * z) / length);
      }
      return normals;
    });
  }
}
