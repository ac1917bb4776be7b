"""Writes keyword decks: cards by name, meshes, sets. Figures are written so that they read back to the same bits
where the format has the room (the suffix + makes every field 20 columns wide)."""


def field(value, width):
    """One field, right-adjusted; a real gets as many digits as the width holds."""
    if value is None:
        return " " * width
    if isinstance(value, str):
        return value.ljust(width)
    if isinstance(value, int):
        return str(value).rjust(width)
    for digits in range(17, 0, -1):
        text = f"{value:.{digits}g}"
        if "e" not in text and "." not in text:
            text += "."
        if len(text) < width or (len(text) == width and digits < 3):
            return text.rjust(width)
    raise ValueError(f"{value} does not fit {width} columns")


class Deck:
    def __init__(self, name, title):
        self.name, self.title = name, title
        self.head, self.lines, self.sets = [], [], 0

    def says(self, key, text):
        """A `$@` comment of the head: case, source, expect, vary, ..."""
        self.head.append(f"$@ {key:<7} {text}")

    def card(self, keyword, *rows, wide=False):
        """A keyword and its data lines; wide = every field 20 columns."""
        self.lines.append("*" + keyword + ("+" if wide else ""))
        for row in rows:
            self.lines.append(row if isinstance(row, str) else "".join(field(v, 20 if wide else 10) for v in row))

    def node_set(self, nodes):
        self.sets += 1
        rows = [nodes[i:i + 8] for i in range(0, len(nodes), 8)]
        self.card("SET_NODE_LIST", [self.sets], *rows)
        return self.sets

    def segment_set(self, faces):
        self.sets += 1
        self.card("SET_SEGMENT", [self.sets], *[list(face) + [face[2]] * (4 - len(face)) for face in faces])
        return self.sets

    def curve(self, number, points):
        self.card("DEFINE_CURVE", [number], *["".join(field(float(v), 20) for v in point) for point in points])

    def part(self, number, section, material, state=0, hourglass=0, title="part"):
        self.card("PART", title, [number, section, material, state, hourglass])

    def mesh(self, mesh):
        self.lines.append("*NODE")
        for i, p in enumerate(mesh.nodes):
            self.lines.append(f"{i + 1:8d}" + "".join(field(float(v), 16) for v in p))
        self.lines.append("*ELEMENT_SOLID")
        for i, (part, nodes) in enumerate(mesh.elements):
            n = list(nodes)
            if len(n) == 4:
                n = n[:3] + [n[3]] * 5
            elif len(n) == 6:   # a hexahedron with N5 = N6 and N7 = N8: its triangles are N1 N2 N5 and N4 N3 N7
                a, b, c, d, e, f = n
                n = [d, e, b, a, f, f, c, c]
            if len(n) == 10:
                self.lines.append(f"{i + 1:8d}{part:8d}")
                self.lines.append("".join(f"{k:8d}" for k in n))
            else:
                self.lines.append(f"{i + 1:8d}{part:8d}" + "".join(f"{k:8d}" for k in n))

    def text(self):
        head = self.head + ["$ Written by make.py; change it there."]
        return "\n".join(head + ["*KEYWORD", "*TITLE", self.title] + self.lines + ["*END", ""])
