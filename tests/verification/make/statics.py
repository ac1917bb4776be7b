"""Decks of statics by damping. Used by make.py."""
import math

from basics import Cases, common, elastic, histories
from deck import Deck
from mesh import hexahedra, mirrored, tetrahedra

CASES = case = Cases()


# --- statics by damping: nearly incompressible solids do not lock ---------------------------------------------

def settle(deck, rate):
    """Mass damping of this rate [1/time] lets the motion die out around the static solution."""
    deck.curve(99, [(0, rate), (1.0e9, rate)])
    deck.card("DAMPING_GLOBAL", [99, 0.0])


def plane(deck, mesh):
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(list(range(1, len(mesh.nodes) + 1))), 0, 0, 0, 1])


def cook(name, form, split, cells, expected, tolerance):
    """Catalogue B04, plane strain, nu = 0.4999; the load is a thousandth, the reference is linear."""
    deck = Deck(name, "Cook's membrane, nearly incompressible")
    deck.says("case", f"Cook's membrane, plane strain, nu = 0.4999, {cells} x {cells} cells, ELFORM {form}")
    deck.says("source", "order 4 spectral elements on graded meshes: 7.695 per unit load; catalogue B04")
    deck.says("expect", f"y_displacement node={{tip}}  {expected}  rel={tolerance} (order)")
    deck.says("slow", "")
    end = 60.0
    common(deck, end)
    mesh = hexahedra((cells, cells, 1), lambda i, j, k: (
        48.0 * i / cells, 44.0 * i / cells + (44.0 - 28.0 * i / cells) * j / cells, 2.0 * k))
    mesh = split(mesh)
    tip = mesh.where(lambda x, y, z: x == 48 and abs(y - 52) < 1e-9 and z == 0)[0]
    deck.head = [line.format(tip=tip) for line in deck.head]
    histories(deck, end, [tip])
    deck.card("SECTION_SOLID", [1, form])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, 240.565, 0.4999)
    clamped = deck.node_set(mesh.where(lambda x, y, z: x == 0))
    deck.card("BOUNDARY_SPC_SET", [clamped, 0, 1, 1, 1])
    plane(deck, mesh)
    settle(deck, 0.4)
    deck.curve(1, [(0, 1), (1000, 1)])
    # Traction 6.25e-3 over 16 x 2, lumped to the nodes of the edge: ends of the edge get half.
    share = 6.25e-3 * 16 / cells
    rows = []
    for n in mesh.where(lambda x, y, z: x == 48):
        y = mesh.nodes[n - 1][1]
        rows.append([n, 2, 1, share * (0.5 if min(abs(y - 44), abs(y - 60)) < 1e-9 else 1.0)])
    deck.card("LOAD_NODE_POINT", *rows)
    deck.mesh(mesh)
    return deck


@case
def cook_selective():
    return cook("cook_selective", 2, lambda m: m, 16, 7.695e-3, 0.02)


@case
def cook_nodal_pressure():
    # The diagonals run from upper left to lower right: the plain linear tetrahedron locks, 40 % short. The other way it
    # is 71 % short and this one 9.6 %; crosswise the plain one does not lock, 6.7 %, and this one is 4.1 % short.
    return cook("cook_nodal_pressure", 13, lambda m: tetrahedra(mirrored(m)), 16, 7.695e-3, 0.06)


def bending_beam(name, form, split, cells, tolerance, poisson=0.4999):
    """Catalogue B01 in plane strain: a cantilever under a parabolic end shear, clamped with the exact
    displacements, so that the exact solution holds everywhere."""
    length, depth, load, young = 48.0, 12.0, 1000.0, 3.0e7
    modulus, ratio = young / (1 - poisson ** 2), poisson / (1 - poisson)    # plane strain as plane stress
    inertia, half = depth ** 3 / 12, depth / 2
    tip = load / (6 * modulus * inertia) * ((4 + 5 * ratio) * depth ** 2 * length / 4 + 2 * length ** 3)
    deck = Deck(name, "Cantilever under end shear, nearly incompressible")
    deck.says("case", f"bending of a nearly incompressible beam, plane strain, {cells[0]} x {cells[1]} cells, ELFORM {form}")
    deck.says("source", "closed form, Timoshenko & Goodier, Theory of Elasticity, art. 21; catalogue B01")
    deck.says("expect", f"y_displacement node={{tip}}  {-tip:.6g}  rel={tolerance} (order)")
    deck.says("slow", "")
    end = 0.3
    common(deck, end)
    mesh = split(hexahedra((*cells, 1), lambda i, j, k: (
        length * i / cells[0], depth * j / cells[1] - half, 1.5 * k)))
    node = mesh.where(lambda x, y, z: x == length and abs(y) < 1e-9 and z == 0)[0]
    deck.head = [line.format(tip=node) for line in deck.head]
    histories(deck, end, [node])
    deck.card("SECTION_SOLID", [1, form])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, young, poisson)
    plane(deck, mesh)
    settle(deck, 66.0)
    deck.curve(1, [(0, 1), (1000, 1)])
    deck.curve(2, [(0, 0), (1000, 0)])
    rows = []
    for n in mesh.where(lambda x, y, z: x == 0):
        y = mesh.nodes[n - 1][1]
        exact = (load * y / (6 * modulus * inertia) * (2 + ratio) * (y * y - half * half),
                 -load / (6 * modulus * inertia) * 3 * ratio * y * y * length)
        rows += [[n, i + 1, 2, 1 if v else 2, v or 1.0] for i, v in enumerate(exact)]
    deck.card("BOUNDARY_PRESCRIBED_MOTION_NODE", *rows, wide=True)
    # End shear P (h^2 - y^2) / 2I over the depth and the thickness, lumped to the nodes by exact integrals.
    step, rows = depth / cells[1], []
    for n in mesh.where(lambda x, y, z: x == length):
        y = mesh.nodes[n - 1][1]
        part = 0.0
        for a, b in ((max(y - step, -half), y), (y, min(y + step, half))):
            for g in (-math.sqrt(0.6), 0.0, math.sqrt(0.6)):
                at = (a + b) / 2 + g * (b - a) / 2
                weight = (8 if g == 0 else 5) / 18 * (b - a)
                part += weight * (1 - abs(at - y) / step) * load / (2 * inertia) * (half * half - at * at)
        rows.append([n, 2, 1, -0.75 * part])     # half the thickness of 1.5 belongs to each of two nodes
    deck.card("LOAD_NODE_POINT", *rows)
    deck.mesh(mesh)
    return deck


@case
def bending_beam_selective():
    return bending_beam("bending_beam_selective", 2, lambda m: m, (24, 6), 0.01)


@case
def bending_beam_nodal_pressure():
    return bending_beam("bending_beam_nodal_pressure", 13, tetrahedra, (32, 8), 0.06)


def sector(cells, around, inner, outer, depth, angle=math.pi / 2, grade=1.0):
    """A sector of a thick tube; radii grow by `grade` from cell to cell."""
    steps = [grade ** i for i in range(cells)]
    radii = [inner + (outer - inner) * sum(steps[:i]) / sum(steps) for i in range(cells + 1)]
    def place(i, j, k):
        a = angle * j / around
        x, y = radii[i] * math.cos(a), radii[i] * math.sin(a)
        return (0.0 if abs(x) < 1e-12 else x, y, depth * k)
    return hexahedra((cells, around, 1), place)


def quarter_tube(deck, mesh, inner):
    """Symmetry planes, plane strain, and the faces of the bore."""
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.where(lambda x, y, z: x == 0)), 0, 1, 0, 0])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.where(lambda x, y, z: y == 0)), 0, 0, 1, 0])
    plane(deck, mesh)
    bore = {n for n in mesh.where(lambda x, y, z: abs(math.hypot(x, y) - inner) < 1e-9)}
    faces = []
    for _, nodes in mesh.elements:
        face = (nodes[0], nodes[4], nodes[7], nodes[3])   # outward normal towards the axis
        if bore.issuperset(face):
            faces.append(face)
    return faces


def thick_cylinder(name, form, poisson, expected, tolerance, around=18):
    """Catalogue B03 (MacNeal & Harder): five elements through the wall, pressure 1."""
    deck = Deck(name, "Thick cylinder under pressure")
    deck.says("case", f"thick cylinder, plane strain, nu = {poisson}, five elements radially, ELFORM {form}")
    deck.says("source", "Lame's solution, MacNeal & Harder 1985; catalogue B03")
    deck.says("expect", f"x_displacement node={{bore}}  {expected}  rel={tolerance} (order)")
    end = 12.0
    common(deck, end)
    mesh = sector(5, around, 3.0, 9.0, 1.0, grade=1.2)
    bore = mesh.where(lambda x, y, z: x == 3 and y == 0 and z == 0)[0]
    deck.head = [line.format(bore=bore) for line in deck.head]
    histories(deck, end, [bore])
    deck.card("SECTION_SOLID", [1, form])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, 1000.0, poisson)
    faces = quarter_tube(deck, mesh, 3.0)
    settle(deck, 6.0)
    deck.curve(1, [(0, 0), (1, 1), (1000, 1)])
    deck.card("LOAD_SEGMENT_SET", [deck.segment_set(faces), 1, 1.0])
    deck.mesh(mesh)
    return deck


@case
def thick_cylinder_030():
    return thick_cylinder("thick_cylinder_030", 2, 0.3, 4.58250e-3, 0.015)


@case
def thick_cylinder_0499():
    return thick_cylinder("thick_cylinder_0499", 2, 0.499, 5.06025e-3, 0.015)


@case
def thick_cylinder_04999():
    return thick_cylinder("thick_cylinder_04999", 2, 0.4999, 5.06227e-3, 0.015)


@case
def tube_inflation():
    """Catalogue C02 (i): Mooney-Rivlin tube, finite strain."""
    deck = Deck("tube_inflation", "Inflated rubber tube, Mooney-Rivlin")
    deck.says("case", "plane strain inflation of a Mooney-Rivlin tube at p = 100, ELFORM 2")
    deck.says("source", "closed form for the incompressible tube; catalogue C02: u(A) = 3.21150, u(B) = 1.42906")
    deck.says("expect", "x_displacement node={a}  3.21150  rel=0.01 (order: 10 cells, and nu = 0.4997)")
    deck.says("expect", "x_displacement node={b}  1.42906  rel=0.01 (order)")
    end = 60.0
    common(deck, end)
    mesh = sector(10, 16, 7.0, 18.625, 1.0, grade=1.08)
    at = lambda r: mesh.where(lambda x, y, z: abs(x - r) < 1e-9 and y == 0 and z == 0)[0]
    deck.head = [line.format(a=at(7.0), b=at(18.625)) for line in deck.head]
    histories(deck, end, [at(7.0), at(18.625)])
    deck.card("SECTION_SOLID", [1, 2])
    deck.part(1, 1, 1)
    deck.card("MAT_MOONEY-RIVLIN_RUBBER", [1, 1.0, 0.4997, 80.0, 20.0])
    faces = quarter_tube(deck, mesh, 7.0)
    settle(deck, 1.0)
    deck.curve(1, [(0, 0), (15, 100), (1000, 100)])
    deck.card("LOAD_SEGMENT_SET", [deck.segment_set(faces), 1, 1.0])
    deck.mesh(mesh)
    return deck
