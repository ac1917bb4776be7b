"""Meshes of triangles, graded towards points, and of tetrahedra around a penny-shaped crack."""
import math

from mesh import Mesh, hexahedra, tetrahedra


class Triangles:
    """A rectangle of squares, each cut into four triangles by its diagonals, refined by bisection of the longest edge
    until no edge is longer than size(x, y) allows at its middle. Angles stay between 45 and 90 degrees."""

    def __init__(self, low, high, counts, size):
        self.points, self.at = [], {}
        self.triangles, self.of_edge = {}, {}     # (newest, b, c) by number; numbers by edge
        (x0, y0), (x1, y1), (nx, ny) = low, high, counts
        x = lambda i: x0 + (x1 - x0) * i / nx
        y = lambda j: y0 + (y1 - y0) * j / ny
        for j in range(ny):
            for i in range(nx):
                corners = [(x(i), y(j)), (x(i + 1), y(j)), (x(i + 1), y(j + 1)), (x(i), y(j + 1))]
                ids = [self._node(*p) for p in corners]
                middle = self._node((x(i) + x(i + 1)) / 2, (y(j) + y(j + 1)) / 2)
                for k in range(4):
                    self._add((middle, ids[k], ids[(k + 1) % 4]))
        waiting = list(self.triangles)
        while waiting:
            number = waiting.pop()
            if number not in self.triangles:
                continue
            _, b, c = self.triangles[number]
            p, q = self.points[b], self.points[c]
            if math.dist(p, q) > size((p[0] + q[0]) / 2, (p[1] + q[1]) / 2) * (1 + 1e-9):
                waiting.extend(self._bisect(number))

    def _node(self, x, y):
        key = (round(x, 9), round(y, 9))
        if key not in self.at:
            self.at[key] = len(self.points)
            self.points.append((x, y))
        return self.at[key]

    def _add(self, triangle):
        number = self._next = getattr(self, "_next", -1) + 1
        self.triangles[number] = triangle
        for k in range(3):
            self.of_edge.setdefault(frozenset((triangle[k], triangle[(k + 1) % 3])), []).append(number)
        return number

    def _remove(self, number):
        triangle = self.triangles.pop(number)
        for k in range(3):
            self.of_edge[frozenset((triangle[k], triangle[(k + 1) % 3]))].remove(number)

    def _halve(self, number):
        a, b, c = self.triangles[number]
        self._remove(number)
        (p, q) = self.points[b], self.points[c]
        middle = self._node((p[0] + q[0]) / 2, (p[1] + q[1]) / 2)
        return [self._add((middle, a, b)), self._add((middle, c, a))]

    def _bisect(self, number):
        """Halves a triangle along its longest edge, and its neighbour there, which is first made ready for it."""
        made = []
        _, b, c = self.triangles[number]
        edge = frozenset((b, c))
        across = [n for n in self.of_edge[edge] if n != number]
        if across and frozenset(self.triangles[across[0]][1:]) != edge:
            made += self._bisect(across[0])
            across = [n for n in self.of_edge[edge] if n != number]
        for one in [number] + across:
            made += self._halve(one)
        return made

    def mesh(self, part=lambda x, y: 1):
        """The triangles, counter-clockwise, with the part of their middle."""
        mesh = Mesh()
        for x, y in self.points:
            mesh.node(x, y, 0.0)
        for n in sorted(self.triangles):
            a, b, c = self.triangles[n]
            middle = [sum(self.points[v][k] for v in (a, b, c)) / 3 for k in (0, 1)]
            mesh.element(part(*middle), [a + 1, b + 1, c + 1])
        return mesh


def edges_on(mesh, test):
    """Boundary edges of a mesh of triangles whose two nodes pass the test, the body to their left."""
    count = {}
    for _, nodes in mesh.elements:
        for k in range(len(nodes)):
            edge = (nodes[k], nodes[(k + 1) % len(nodes)])
            count.setdefault(frozenset(edge), []).append(edge)
    inside = set(mesh.where(test))
    return [e[0] for e in count.values() if len(e) == 1 and set(e[0]) <= inside]


def penny_quarter(radius, rings, outer, width, heights):
    """Tetrahedra of a quarter of a square block, x and y positive, with circles of nodes around the axis up to `rings`
    steps to the radius, `outer` more to the sides at `width`; layers at `heights`."""
    def plane(i, j):
        k = max(i, j)
        if k == 0:
            return 0.0, 0.0
        angle = math.pi / 4 * (j / i if i >= j else 2 - i / j)
        circle = (math.cos(angle), math.sin(angle))
        square = (i / k, j / k)
        if k <= rings:      # the first ring is drawn in towards the square, so that its cells stay fat
            blend, size = 1.0, radius * k / rings
        else:
            s = (k - rings) / outer
            blend, size = 1.0 - s, radius + (width - radius) * s * (0.6 + 0.4 * s)
        return tuple(size * (blend * c + (1 - blend) * q) for c, q in zip(circle, square))
    n = rings + outer
    place = lambda i, j, k: tuple(0.0 if abs(c) < 1e-12 else c for c in (*plane(i, j), heights[k]))
    return tetrahedra(hexahedra((n, n, len(heights) - 1), place))


def faces_on(mesh, test):
    """Boundary faces of a mesh of tetrahedra whose nodes pass the test, counter-clockwise seen from outside."""
    count = {}
    for _, n in mesh.elements:
        for face in ((n[0], n[2], n[1]), (n[0], n[1], n[3]), (n[1], n[2], n[3]), (n[0], n[3], n[2])):
            count.setdefault(frozenset(face), []).append(face)
    inside = set(mesh.where(test))
    return [f[0] for f in count.values() if len(f) == 1 and set(f[0]) <= inside]
