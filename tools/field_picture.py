#!/usr/bin/env python3
"""Draws fields of spacetime runs as PNG: field_picture.py OUT.png PANEL [PANEL...] [options]

A PANEL is FILE.vtu or FILE.vtu@TEXT, the words written into it. Triangles are drawn in the plane; tetrahedra where a
plane cuts them. Standard library only.

  --field NAME[:COMPONENT]  point data (default max_shear_stress); a vector or tensor needs the number of its component
  --range LOW:HIGH          of the colours (default: 0 or minus the largest, to the largest magnitude)
  --box X0:X1:Y0:Y1         what is shown, in the plane of the picture
  --cut y=0.0               the plane through tetrahedra: one coordinate is constant, the others span the picture
  --line X0,Y0,X1,Y1        a line drawn on top (a crack); may be repeated
  --mesh                    draws the edges of the mesh, thin
  --columns N --width W     panels per row; pixels of one panel
  --title TEXT              beside the colour bar
"""
import argparse
import array
import math
import re
import struct
import sys
import zlib

# Lightness falls evenly away from white on either side; sequential fields use the warm half from white.
WARM = [(255, 255, 255), (254, 232, 200), (253, 187, 132), (239, 101, 72), (179, 0, 0), (70, 0, 20)]
COLD = [(255, 255, 255), (205, 225, 240), (130, 180, 215), (55, 120, 185), (20, 60, 130), (5, 20, 60)]
GLYPHS = {  # 5 x 7 dots, a row per hexadecimal pair
    "0": "0e11131519110e", "1": "040c040404040e", "2": "0e11010204081f", "3": "1f02040201110e", "4": "02060a121f0202",
    "5": "1f101e0101110e", "6": "0608101e11110e", "7": "1f010204080808", "8": "0e11110e11110e", "9": "0e11110f01020c",
    ".": "00000000000c0c", "-": "0000001f000000", "=": "00001f001f0000", "+": "0004041f040400", " ": "00000000000000",
    "a": "00000e010f110f", "b": "10101619111e00", "c": "00000e1010110e", "d": "01010d1311110f", "e": "00000e111f100e",
    "f": "0609081c080808", "g": "000f11110f010e", "h": "10101619111111", "i": "04000c0404040e", "k": "10101214181412",
    "l": "0c04040404040e", "m": "00001a15151111", "n": "00001619111111", "o": "00000e1111110e", "p": "00001e111e1010",
    "r": "00001619101010", "s": "00000e100e011e", "t": "08081c08080906", "u": "0000111111130d", "v": "000011110a0a04",
    "w": "0000111115150a", "x": "0000110a040a11", "y": "00001111 0f010e".replace(" ", ""), "z": "00001f0204081f",
    "/": "01010204081010", ",": "0000000c040800", "(": "02040808080402", ")": "08040202020408", "*": "00150e1f0e1500",
    "_": "0000000000001f", "j": "0200060202120c", "q": "00000d130f0101"}


def read_vtu(path):
    """Points, connectivity, offsets, types and point data by name (components, values) of a file with raw arrays."""
    data = open(path, "rb").read()
    start = data.index(b"<AppendedData")
    base = data.index(b"_", start) + 1
    head = data[:start].decode()
    arrays, section = {}, ""
    for tag in re.finditer(r"<(\w+)([^>]*)>", head):
        if tag[1] in ("PointData", "CellData", "Points", "Cells"):
            section = tag[1]
        if tag[1] != "DataArray" or "offset=" not in tag[2]:
            continue
        attributes = dict(re.findall(r'(\w+)="([^"]*)"', tag[2]))
        at = base + int(attributes["offset"])
        size = struct.unpack_from("<Q", data, at)[0]
        code = {"Float64": "d", "Float32": "f", "Int64": "q", "Int32": "i", "UInt8": "B"}[attributes["type"]]
        values = array.array(code)
        values.frombytes(data[at + 8:at + 8 + size])
        arrays[section, attributes["Name"]] = (int(attributes.get("NumberOfComponents", 1)), values)
    points = arrays.pop(("Points", next(n for s, n in arrays if s == "Points")))[1]
    return points, arrays


def triangles_of(path, field, cut):
    """Triangles of a panel: three (x, y, value) each."""
    points, arrays = read_vtu(path)
    name, _, component = field.partition(":")
    size, values = arrays["PointData", name]
    if size > 1 and not component:
        sys.exit(f"field_picture: {name} has {size} components, say {name}:0 to {name}:{size - 1}")
    value = lambda p: values[p * size + int(component or 0)]
    ends, nodes = arrays["Cells", "offsets"][1], arrays["Cells", "connectivity"][1]
    out, begin = [], 0
    axis, where = ("xyz".index(cut[0]), float(cut[2:])) if cut else (2, 0.0)
    u, v = [k for k in range(3) if k != axis]
    for end in ends:
        cell = nodes[begin:end]
        begin = end
        place = lambda p: (points[3 * p + u], points[3 * p + v], value(p))
        if len(cell) == 3:
            out.append([place(p) for p in cell])
        elif len(cell) == 4:
            above = [p for p in cell if points[3 * p + axis] > where]
            below = [p for p in cell if points[3 * p + axis] <= where]
            corners = []
            for p in above:
                for q in below:
                    s = (where - points[3 * q + axis]) / (points[3 * p + axis] - points[3 * q + axis])
                    corners.append([b + s * (a - b) for a, b in zip(place(p), place(q))])
            if len(corners) == 4:
                corners[2], corners[3] = corners[3], corners[2]
            out += [[corners[0], corners[k], corners[k + 1]] for k in range(1, len(corners) - 1)]
    return out


class Canvas:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.pixels = bytearray(b"\xff" * (3 * width * height))

    def put(self, x, y, colour):
        if 0 <= x < self.width and 0 <= y < self.height:
            at = 3 * (y * self.width + x)
            self.pixels[at:at + 3] = bytes(colour)

    def text(self, x, y, words, scale, colour=(20, 20, 20)):
        for letter in words.lower():
            rows = bytes.fromhex(GLYPHS.get(letter, GLYPHS[" "]))
            for j, row in enumerate(rows):
                for i in range(5):
                    if row >> (4 - i) & 1:
                        for b in range(scale):
                            for a in range(scale):
                                self.put(x + i * scale + a, y + j * scale + b, colour)
            x += 6 * scale
        return x

    def line(self, x0, y0, x1, y1, colour, width=1):
        steps = int(max(abs(x1 - x0), abs(y1 - y0))) + 1
        for k in range(steps + 1):
            x, y = x0 + (x1 - x0) * k / steps, y0 + (y1 - y0) * k / steps
            for b in range(width):
                for a in range(width):
                    self.put(round(x - width / 2 + a), round(y - width / 2 + b), colour)

    def triangle(self, corners, colour_of):
        """Corners (x, y, value) in pixels; the value is linear between them."""
        (x0, y0, f0), (x1, y1, f1), (x2, y2, f2) = corners
        area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0)
        if area == 0.0:
            return
        fx = ((f1 - f0) * (y2 - y0) - (f2 - f0) * (y1 - y0)) / area
        fy = ((f2 - f0) * (x1 - x0) - (f1 - f0) * (x2 - x0)) / area
        for y in range(max(0, math.ceil(min(y0, y1, y2) - 0.5)), min(self.height, math.ceil(max(y0, y1, y2) - 0.5))):
            at, cross = y + 0.5, []
            for (xa, ya), (xb, yb) in (((x0, y0), (x1, y1)), ((x1, y1), (x2, y2)), ((x2, y2), (x0, y0))):
                if (ya <= at) != (yb <= at):
                    cross.append(xa + (xb - xa) * (at - ya) / (yb - ya))
            if len(cross) < 2:
                continue
            low, high = max(0, math.ceil(min(cross) - 0.5)), min(self.width, math.ceil(max(cross) - 0.5))
            f, spot = f0 + fx * (low + 0.5 - x0) + fy * (at - y0), 3 * (y * self.width + low)
            for _ in range(low, high):
                self.pixels[spot:spot + 3] = colour_of(f)
                f += fx
                spot += 3

    def halved(self):
        """Half the size, each pixel the mean of four."""
        small, w = Canvas(self.width // 2, self.height // 2), 3 * self.width
        p = self.pixels
        for y in range(small.height):
            for c in range(3):
                top, bottom = p[2 * y * w + c:(2 * y + 1) * w:3], p[(2 * y + 1) * w + c:(2 * y + 2) * w:3]
                sums = [(a + b + d + e) // 4 for a, b, d, e in zip(top[::2], top[1::2], bottom[::2], bottom[1::2])]
                small.pixels[3 * y * small.width + c:3 * (y + 1) * small.width:3] = bytes(sums[:small.width])
        return small

    def save(self, path, table):
        """As PNG of 256 colours, 208 of the table and 48 greys: a third of the size."""
        chosen = [bytes(table[255 * k // 207]) for k in range(208)] + [bytes([255 * k // 47] * 3) for k in range(48)]
        near, rows = {}, bytearray()
        for y in range(self.height):
            rows.append(0)
            row = self.pixels[3 * y * self.width:3 * (y + 1) * self.width]
            for k in range(0, len(row), 3):
                colour = bytes(c & 0xFC for c in row[k:k + 3])
                if colour not in near:
                    near[colour] = min(range(256), key=lambda i: sum((a - b) ** 2 for a, b in zip(colour, chosen[i])))
                rows.append(near[colour])
        colours = b"".join(chosen)
        chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", self.width, self.height, 8, 3, 0, 0, 0))
                       + chunk(b"PLTE", colours) + chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def ramp(stops, s):
    s = min(max(s, 0.0), 1.0) * (len(stops) - 1)
    k = min(int(s), len(stops) - 2)
    return bytes(round(a + (b - a) * (s - k)) for a, b in zip(stops[k], stops[k + 1]))


def colours(low, high):
    """256 colours from low to high: white at zero if it lies between, else from white."""
    table = []
    for k in range(256):
        value = low + (high - low) * k / 255
        table.append(ramp(WARM, value / high) if low >= 0 or value >= 0 else ramp(COLD, value / low))
    return table


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("out")
    parser.add_argument("panels", nargs="+")
    parser.add_argument("--field", default="max_shear_stress")
    parser.add_argument("--range")
    parser.add_argument("--box")
    parser.add_argument("--cut")
    parser.add_argument("--line", action="append", default=[])
    parser.add_argument("--mesh", action="store_true")
    parser.add_argument("--columns", type=int, default=3)
    parser.add_argument("--width", type=int, default=300)
    parser.add_argument("--title", default="")
    o = parser.parse_args()

    panels = [(triangles_of(p.partition("@")[0], o.field, o.cut), p.partition("@")[2]) for p in o.panels]
    values = [corner[2] for triangles, _ in panels for t in triangles for corner in t]
    if o.range:
        low, high = map(float, o.range.split(":"))
    else:
        high = max(map(abs, values))
        low = -high if min(values) < 0 else 0.0
    everything = [c for triangles, _ in panels for t in triangles for c in t]
    x0, x1, y0, y1 = (map(float, o.box.split(":")) if o.box else
                      (min(c[0] for c in everything), max(c[0] for c in everything),
                       min(c[1] for c in everything), max(c[1] for c in everything)))
    table = colours(low, high)
    colour_of = lambda f: table[min(255, max(0, int(256 * (f - low) / (high - low))))]

    width = 2 * o.width
    scale = width / (x1 - x0)
    height = 2 * round(o.width * (y1 - y0) / (x1 - x0))
    gap, bar, columns = 16, 90, min(o.columns, len(panels))
    rows = -(-len(panels) // columns)
    whole = Canvas(columns * (width + gap) + gap, rows * (height + gap) + gap + bar)
    for number, (triangles, words) in enumerate(panels):
        panel = Canvas(width, height)
        to = lambda c: ((c[0] - x0) * scale, (y1 - c[1]) * scale, c[2])
        for t in triangles:
            panel.triangle([to(c) for c in t], colour_of)
        if o.mesh:
            for t in triangles:
                for a, b in ((0, 1), (1, 2), (2, 0)):
                    panel.line(*to(t[a])[:2], *to(t[b])[:2], (150, 150, 150))
        for line in o.line:
            a, b, c, d = map(float, line.split(","))
            panel.line(*to((a, b, 0))[:2], *to((c, d, 0))[:2], (0, 0, 0), 5)
        for y in range(4, 52 if words else 0):   # a plate for the words: colours may be dark there
            for x in range(4, min(width, 24 * len(words) + 24)):
                panel.put(x, y, (255, 255, 255))
        panel.text(16, 14, words, 4)
        left, top = gap + (number % columns) * (width + gap), gap + (number // columns) * (height + gap)
        for y in range(height):
            at = 3 * ((top + y) * whole.width + left)
            whole.pixels[at:at + 3 * width] = panel.pixels[3 * y * width:3 * (y + 1) * width]
        for a, b, c, d in ((0, 0, width, 0), (width, 0, width, height), (width, height, 0, height), (0, height, 0, 0)):
            whole.line(left + a, top + b, left + c, top + d, (120, 120, 120), 2)
    top, left, length = whole.height - bar + 10, gap, min(whole.width // 2, 600)
    for x in range(length):
        for y in range(24):
            whole.put(left + x, top + y, table[255 * x // (length - 1)])
    for x, words in ((0, f"{low:.3g}"), (length - 1, f"{high:.3g}")):
        whole.line(left + x, top, left + x, top + 32, (20, 20, 20), 2)
        whole.text(left + x - (0 if x == 0 else 12 * len(words)), top + 40, words, 4)
    whole.text(left + length + 30, top + 4, o.title, 4)
    whole.halved().save(o.out, table)


if __name__ == "__main__":
    main()
