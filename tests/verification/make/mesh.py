"""Small structured meshes: boxes and mapped boxes of hexahedra, split into wedges or tetrahedra when asked."""
import itertools
import math


class Mesh:
    """Nodes (id -> x, y, z) and elements (id -> part, node ids); ids count from 1 in the order of creation."""

    def __init__(self):
        self.nodes, self.elements, self._at = [], [], {}

    def node(self, x, y, z):
        """The id of the node at this place, made when there is none."""
        key = (round(x, 9), round(y, 9), round(z, 9))
        if key not in self._at:
            self.nodes.append((x, y, z))
            self._at[key] = len(self.nodes)
        return self._at[key]

    def element(self, part, nodes):
        self.elements.append((part, list(nodes)))
        return len(self.elements)

    def where(self, test):
        """Ids of the nodes whose x, y, z pass the test."""
        return [i + 1 for i, p in enumerate(self.nodes) if test(*p)]

    def element_near(self, x, y, z):
        """Id of the element whose centre lies nearest to a point."""
        def distance(nodes):
            centre = [sum(self.nodes[n - 1][k] for n in nodes) / len(nodes) for k in range(3)]
            return sum((a - b) ** 2 for a, b in zip(centre, (x, y, z)))
        return min(range(len(self.elements)), key=lambda e: distance(self.elements[e][1])) + 1


def hexahedra(counts, place, part=1):
    """A block of counts = (i, j, k) hexahedra; place(a, b, c) maps grid numbers to x, y, z."""
    mesh = Mesh()
    ni, nj, nk = counts
    ids = {g: mesh.node(*place(*g)) for g in itertools.product(range(ni + 1), range(nj + 1), range(nk + 1))}
    for k, j, i in itertools.product(range(nk), range(nj), range(ni)):
        corner = [(0, 0), (1, 0), (1, 1), (0, 1)]
        mesh.element(part, [ids[i + a, j + b, k + c] for c in (0, 1) for a, b in corner])
    return mesh


def box(counts, size, part=1):
    return hexahedra(counts, lambda *g: tuple(s * n / c for s, n, c in zip(size, g, counts)), part)


# Kuhn's split: six tetrahedra around the diagonal 1-7, faces of neighbouring cells match.
TETRAHEDRA = [(0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)]
WEDGES = [(0, 1, 2, 4, 5, 6), (0, 2, 3, 4, 6, 7)]


def _volume(mesh, nodes):
    a, b, c, d = (mesh.nodes[n - 1] for n in nodes)
    u, v, w = ([q - p for p, q in zip(a, x)] for x in (b, c, d))
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) + u[2] * (v[0] * w[1] - v[1] * w[0])) / 6


CORNERS = [(-1, -1, -1), (1, -1, -1), (1, 1, -1), (-1, 1, -1), (-1, -1, 1), (1, -1, 1), (1, 1, 1), (-1, 1, 1)]
FACES = [(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]   # seen from outside


def hexahedron_volume(points):
    """Volume of a trilinear hexahedron; 2 x 2 x 2 points are exact."""
    total = 0.0
    for at in itertools.product((-1 / math.sqrt(3), 1 / math.sqrt(3)), repeat=3):
        j = [[0.0] * 3 for _ in range(3)]
        for corner, p in zip(CORNERS, points):
            f = [1 + c * x for c, x in zip(corner, at)]
            for k, g in enumerate((corner[0] * f[1] * f[2], corner[1] * f[0] * f[2], corner[2] * f[0] * f[1])):
                for i in range(3):
                    j[i][k] += g * p[i] / 8
        total += (j[0][0] * (j[1][1] * j[2][2] - j[1][2] * j[2][1]) - j[0][1] * (j[1][0] * j[2][2] - j[1][2] * j[2][0])
                  + j[0][2] * (j[1][0] * j[2][1] - j[1][1] * j[2][0]))
    return total


def outer_faces(hexes):
    """Faces that belong to one hexahedron only, counter-clockwise seen from outside."""
    count = {}
    for _, nodes in hexes.elements:
        for face in FACES:
            key = tuple(sorted(nodes[a] for a in face))
            count.setdefault(key, []).append([nodes[a] for a in face])
    return [faces[0] for faces in count.values() if len(faces) == 1]


def mirrored(hexes):
    """The same hexahedra with their node order mirrored, so that the diagonals of a split run the other way. They are
    left-handed: only to be cut into tetrahedra."""
    mesh = Mesh()
    mesh.nodes, mesh._at = list(hexes.nodes), dict(hexes._at)
    for part, nodes in hexes.elements:
        mesh.element(part, [nodes[a] for a in (1, 0, 3, 2, 5, 4, 7, 6)])
    return mesh


def tetrahedra(hexes, quadratic=False):
    """Each hexahedron cut into six tetrahedra; quadratic ones get straight mid nodes."""
    mesh = Mesh()
    mesh.nodes, mesh._at = list(hexes.nodes), dict(hexes._at)
    for part, nodes in hexes.elements:
        for local in TETRAHEDRA:
            tet = [nodes[a] for a in local]
            if _volume(mesh, tet) < 0:
                tet[1], tet[2] = tet[2], tet[1]
            if quadratic:
                for a, b in ((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)):
                    tet.append(mesh.node(*((p + q) / 2 for p, q in zip(mesh.nodes[tet[a] - 1], mesh.nodes[tet[b] - 1]))))
            mesh.element(part, tet)
    return mesh


def wedges(hexes):
    """Each hexahedron cut into two wedges along the diagonal 1-3 of its bottom face."""
    mesh = Mesh()
    mesh.nodes, mesh._at = list(hexes.nodes), dict(hexes._at)
    for part, nodes in hexes.elements:
        for local in WEDGES:
            mesh.element(part, [nodes[a] for a in local])
    return mesh


def quarter_cylinder(core, rings, layers, radius, length, part=1):
    """A quarter of a cylinder about z, x and y positive: a square core of core x core columns inside rings that
    blend into the circle."""
    mesh, half = Mesh(), 0.6 * radius
    def bulge(u, v):     # core square with its outer corner drawn in, so that no column is flat
        return half * u * (1 - 0.15 * v), half * v * (1 - 0.15 * u)
    def rim(s):          # s from 0 to 2 along the core's outer edges, and the circle point it looks at
        inner = bulge(1, s) if s <= 1 else bulge(2 - s, 1)
        angle = math.pi / 4 * s
        return inner, (radius * math.cos(angle) if s < 2 else 0.0, radius * math.sin(angle) if s > 0 else 0.0)
    columns = []
    grid = lambda i, j: bulge(i / core, j / core)
    for j, i in itertools.product(range(core), range(core)):
        columns.append([grid(i, j), grid(i + 1, j), grid(i + 1, j + 1), grid(i, j + 1)])
    def ring(s, r):
        inner, outer = rim(s)
        return tuple(a + (b - a) * r / rings for a, b in zip(inner, outer))
    for r, q in itertools.product(range(rings), range(2 * core)):
        a, b = q / core, (q + 1) / core
        columns.append([ring(a, r), ring(a, r + 1), ring(b, r + 1), ring(b, r)])
    for k, column in itertools.product(range(layers), columns):
        mesh.element(part, [mesh.node(x, y, length * z / layers) for z in (k, k + 1) for x, y in column])
    return mesh
