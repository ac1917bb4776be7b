#!/usr/bin/env python3
"""Writes the larger verification decks, each with its expectation: make.py [NAME...]  (default: all
but the large ones of spacetime.py, which are written here on demand)."""
import math
import sys
from pathlib import Path

from deck import Deck
import spacetime
from mesh import box, hexahedra, hexahedron_volume, mirrored, outer_faces, quarter_cylinder, tetrahedra, wedges

HERE = Path(__file__).resolve().parent.parent
CASES = {}


def case(function):
    CASES[function.__name__] = function
    return function


def common(deck, end, safety=0.9, interval=None, bulk=True):
    deck.card("CONTROL_TERMINATION", [end])
    deck.card("CONTROL_TIMESTEP", [0.0, safety])
    deck.card("CONTROL_ENERGY", [2, 2, 2, 2])
    if not bulk:
        deck.card("CONTROL_BULK_VISCOSITY", [1.0e-20, 1.0e-20])
    for name in ("GLSTAT", "MATSUM"):
        deck.card("DATABASE_" + name, [interval or end / 100])


def histories(deck, end, nodes=(), elements=(), interval=None):
    every = interval or end / 100
    if nodes:
        deck.card("DATABASE_NODOUT", [every])
        deck.card("DATABASE_HISTORY_NODE", list(nodes))
    if elements:
        deck.card("DATABASE_ELOUT", [every])
        deck.card("DATABASE_HISTORY_SOLID", list(elements))


def elastic(deck, number, density, young, poisson):
    deck.card("MAT_ELASTIC", [number, density, young, poisson])


# --- A01: homogeneous finite strain must stay homogeneous on distorted meshes ------------------------------

PATCH_FORMS = {  # name: (ELFORM, how the hexahedra are split, hourglass type)
    "hex_one_point_flanagan": (1, "hex", 4), "hex_one_point_viscous": (1, "hex", 1),
    "hex_one_point_bindeman": (1, "hex", 6), "hex_selective": (2, "hex", None), "tet": (10, "tet", None),
    "tet_nodal_pressure": (13, "tet", None), "wedge": (15, "wedge", None), "tet_quadratic": (16, "tet10", None)}


def patch(name):
    form, kind, hourglass = PATCH_FORMS[name]
    # 2 x 2 x 2 cells; the interior node and the middles of edges and faces are moved (catalogue A01).
    moved = {(1, 1, 1): (0.59, 0.41, 0.56), (1, 0, 0): (0.42, 0.0, 0.0), (0, 1, 0): (0.0, 0.61, 0.0),
             (2, 2, 1): (1.0, 1.0, 0.38), (1, 1, 0): (0.55, 0.46, 0.0), (2, 1, 1): (1.0, 0.57, 0.44)}
    hexes = hexahedra((2, 2, 2), lambda a, b, c: moved.get((a, b, c), (a / 2, b / 2, c / 2)))
    mesh = {"hex": lambda: hexes, "tet": lambda: tetrahedra(hexes), "wedge": lambda: wedges(hexes),
            "tet10": lambda: tetrahedra(hexes, quadratic=True)}[kind]()
    end, young, poisson = 20.0, 1.0, 0.3
    # Velocity field v = L X with L symmetric: principal axes (2,2,1)/3 (1,-2,2)/3 (-2,1,2)/3 stay where they are,
    # the principal stretches are 1 + t rate, and the stress is Hooke's law in their logarithms.
    axes, rates = ((2, 2, 1), (1, -2, 2), (-2, 1, 2)), (0.005, -0.003, 0.002)
    rate = [[sum(r * a[i] * a[j] / 9 for a, r in zip(axes, rates)) for j in range(3)] for i in range(3)]
    logs = [math.log(1 + end * r) for r in rates]
    lame = young * poisson / ((1 + poisson) * (1 - 2 * poisson))
    shear = young / (2 * (1 + poisson))
    principal = [2 * shear * e + lame * sum(logs) for e in logs]
    stress = [[sum(s * a[i] * a[j] / 9 for a, s in zip(axes, principal)) for j in range(3)] for i in range(3)]

    deck = Deck("patch_" + name, f"Patch test, {name.replace('_', ' ')}")
    deck.says("case", f"linear velocity field on a distorted patch, ELFORM {form}: stress uniform, exact")
    deck.says("source", "closed form: Hooke's law in the logarithms of the principal stretches")
    last = len(mesh.elements)
    for element in sorted({1, last // 2, last}):
        for component, i, j in (("xx", 0, 0), ("yy", 1, 1), ("zz", 2, 2), ("xy", 0, 1), ("yz", 1, 2), ("zx", 2, 0)):
            deck.says("expect", f"stress_{component} element={element} time={end}  {stress[i][j]:.12g}  abs=2e-8 "
                      "(order: step squared in the logarithms; stresses reach 0.1)")
    deck.says("expect", "energy_ratio max 1.0 abs=0.01 (order)")
    # Small steps, each of them written: values between rows are linear.
    common(deck, end + 0.1, safety=0.05)
    inside = mesh.where(lambda x, y, z: 0 < x < 1 and 0 < y < 1 and 0 < z < 1)
    histories(deck, end, inside[:8], sorted({1, last // 2, last}), interval=1.0e-3)
    deck.card("SECTION_SOLID", [1, form])
    if hourglass:
        deck.card("HOURGLASS", [1, hourglass, 0.1])
    deck.part(1, 1, 1, hourglass=1 if hourglass else 0)
    elastic(deck, 1, 1.0, young, poisson)
    deck.curve(1, [(0, 1), (1000, 1)])
    deck.curve(2, [(0, 0), (1000, 0)])   # a scale factor of 0 means 1 in this format, so rest needs its own curve
    velocity = {n + 1: [sum(rate[i][j] * p[j] for j in range(3)) for i in range(3)] for n, p in enumerate(mesh.nodes)}
    rows = [[n, i + 1, 0, 1 if v[i] else 2, v[i] or 1.0] for n, v in velocity.items() if n not in inside
            for i in range(3)]
    deck.card("BOUNDARY_PRESCRIBED_MOTION_NODE", *rows, wide=True)
    deck.card("INITIAL_VELOCITY_NODE", *[[n, *v] for n, v in velocity.items()], wide=True)
    deck.mesh(mesh)
    return deck


for _name in PATCH_FORMS:
    CASES["patch_" + _name] = lambda name=_name: patch(name)


# --- A05: simple shear with the Jaumann rate -----------------------------------------------------------------

@case
def simple_shear():
    deck = Deck("simple_shear", "Simple shear of one element to gamma = 6")
    mesh = box((1, 1, 1), (1.0, 1.0, 1.0))
    end, shear = 600.0, 1.0 / 2.6
    deck.says("case", "hypoelastic simple shear, Jaumann rate")
    deck.says("source", "Dienes 1979: s12 = G sin gamma, s11 = G (1 - cos gamma)")
    for gamma in (0.5, 1, 2, 4, 6):
        deck.says("expect", f"stress_xy element=1 time={100 * gamma:g}  {shear * math.sin(gamma):.8f}  "
                  f"abs={0.005 * shear:.5f} (order: step of about 0.003 in gamma)")
        deck.says("expect", f"stress_xx element=1 time={100 * gamma:g}  {shear * (1 - math.cos(gamma)):.8f}  "
                  f"abs={0.01 * shear:.5f} (order)")
    common(deck, end)
    histories(deck, end, elements=[1], interval=end / 600)
    deck.card("SECTION_SOLID", [1, 1])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, 1.0, 0.3)
    deck.curve(1, [(0, 1), (1000, 1)])
    top = mesh.where(lambda x, y, z: y == 1)
    held = deck.node_set(mesh.where(lambda x, y, z: y == 0))
    moving = deck.node_set(top)
    deck.card("BOUNDARY_SPC_SET", [held, 0, 1, 1, 1])
    deck.card("BOUNDARY_SPC_SET", [moving, 0, 0, 1, 1])
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [moving, 1, 0, 1, 0.01])
    deck.card("INITIAL_VELOCITY", [moving], [0.01, 0.0, 0.0])
    deck.mesh(mesh)
    return deck


# --- pressure on every face: homogeneous at any pressure, on a distorted mesh that nothing holds ----------------

@case
def pressure_bath():
    deck = Deck("pressure_bath", "A distorted block of one-point elements sinks")
    moved = {(1, 1, 1): (0.59, 0.41, 0.56), (1, 0, 0): (0.42, -0.05, 0.04), (0, 1, 0): (0.03, 0.61, 0.02),
             (2, 2, 1): (1.05, 0.96, 0.38), (1, 1, 0): (0.55, 0.46, -0.06), (2, 1, 1): (1.08, 0.57, 0.44)}
    mesh = hexahedra((2, 2, 2), lambda a, b, c: moved.get((a, b, c), (a / 2, b / 2, c / 2)))
    end, bulk, largest = 600.0, 1.0 / 1.2, 0.7
    volume = sum(hexahedron_volume([mesh.nodes[n - 1] for n in nodes]) for _, nodes in mesh.elements)
    deck.says("case", "pressure up to 0.7 E on all faces of a distorted block of one-point elements, held by nothing")
    deck.says("source", "closed form of hypoelasticity under hydrostatic pressure: stress = -p, V = V0 exp(-p/K)")
    for time in (end / 2, end):
        p = largest * time / end
        for element in (1, 4, 8):
            for component in ("xx", "yy", "zz"):
                deck.says("expect", f"stress_{component} element={element} time={time:g}  {-p:.4g}  "
                          "rel=5e-4 (model: oscillation of about 1/(omega t))")
            for component in ("xy", "yz", "zx"):
                deck.says("expect", f"stress_{component} element={element} time={time:g}  0.0  "
                          "abs=1e-6 (model: the same)")
        q = p / bulk
        energy = volume * bulk * (1.0 - math.exp(-q) * (1.0 + q))
        deck.says("expect", f"internal_energy time={time:g}  {energy:.6g}  rel=5e-4 (model: the same)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    common(deck, end + 0.5, interval=0.5)
    histories(deck, end, elements=[1, 4, 8], interval=0.5)
    deck.card("SECTION_SOLID", [1, 1])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, 1.0, 0.3)
    deck.curve(1, [(0, 0), (2 * end, 2 * largest)])
    deck.card("LOAD_SEGMENT_SET", [deck.segment_set(outer_faces(mesh)), 1, 1.0])
    deck.mesh(mesh)
    return deck


# --- waves in bars ---------------------------------------------------------------------------------------------

def bar(deck, cells, length, width, form=1):
    mesh = box((cells, 1, 1), (length, width, width))
    deck.card("SECTION_SOLID", [1, form])
    deck.part(1, 1, 1)
    return mesh


@case
def wave_exact():
    """Central differences at the critical step carry a front along a bar without any error."""
    cells = 40
    deck = Deck("wave_exact", "Step wave in a bar at the critical step")
    deck.says("case", "one-dimensional step wave at dt = h/c: nodally exact")
    deck.says("source", "closed form u = V (t - x/c); catalogue A12 (i)")
    for x in (5, 20, 30):
        deck.says("expect", f"x_displacement node={{x{x}}} time=32  {max(0.0, 1e-9 * (32 - x)):.9g}  abs=1e-14 "
                  "(roundoff: positions of order 10, displacements of order 1e-8)")
    common(deck, 32.0, safety=1.0, bulk=False)
    mesh = bar(deck, cells, 40.0, 1.0)
    watched = {x: mesh.where(lambda a, b, c: a == x and b == 0 and c == 0)[0] for x in (5, 20, 30)}
    deck.head = [line.format(**{f"x{x}": n for x, n in watched.items()}) for line in deck.head]
    histories(deck, 32.0, watched.values(), interval=1.0)
    deck.card("HOURGLASS", [1, 1, 0.0])
    elastic(deck, 1, 1.0, 1.0, 0.0)
    deck.curve(1, [(0, 1), (1000, 1)])
    end_face = deck.node_set(mesh.where(lambda x, y, z: x == 0))
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [end_face, 1, 0, 1, 1.0e-9])
    deck.card("INITIAL_VELOCITY", [end_face], [1.0e-9, 0.0, 0.0])
    deck.mesh(mesh)
    return deck


@case
def bar_rebound():
    """Catalogue D01."""
    deck = Deck("bar_rebound", "Elastic bar against a rigid wall")
    deck.says("case", "elastic bar hits a rigid wall: stress, contact time, rebound")
    deck.says("source", "closed form: rho c v = 400 MPa, 2 L / c = 400 us, rebound -v; catalogue D01")
    end = 600e-6
    deck.says("expect", "x_velocity  10.0  abs=0.2 (order: rebound 1 %, twice that at this size)")
    deck.says("expect", "normal_force wall=1 time=200e-6  4.0e4  rel=0.02 (order: 400 MPa on 1 cm2)")
    deck.says("expect", "normal_force wall=1 time=380e-6  4.0e4  rel=0.05 (order)")
    deck.says("expect", "normal_force wall=1 time=430e-6  0.0  abs=1.0e2 (order: contact ends at 400 us)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("vary", "threads=1,2,3,7")
    common(deck, end, interval=1e-6)
    deck.card("DATABASE_RWFORC", [1e-6])
    mesh = bar(deck, 100, 1.0, 0.01)
    elastic(deck, 1, 8000.0, 200.0e9, 0.0)
    everything = deck.node_set(list(range(1, len(mesh.nodes) + 1)))
    deck.card("INITIAL_VELOCITY", [everything], [-10.0, 0.0, 0.0])
    deck.card("RIGIDWALL_PLANAR", [everything], [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    deck.mesh(mesh)
    return deck


@case
def plastic_wave():
    """Catalogue D03 with stresses and velocities a hundred times smaller: the theory is one of small strains, and
    at 4 % the growing section alone makes the tangent a quarter stiffer."""
    deck = Deck("plastic_wave", "Elastic-plastic wave in a bar")
    deck.says("case", "end of a bar driven at 0.3 m/s: elastic precursor, plastic wave")
    deck.says("source", "one-dimensional theory: 4 MPa ahead, 4.8 MPa and strain 4.2e-4 behind; catalogue D03 / 100")
    end, plastic = 160e-6, 4.2e-4 - 4.8e6 / 200.0e9
    deck.says("expect", "stress_xx element={near}  -4.80e6  rel=0.01 (order)")
    deck.says("expect", "stress_xx element={ahead}  -4.00e6  rel=0.01 (order)")
    deck.says("expect", "stress_xx element={before}  0.0  abs=4e4 (order: precursor has not arrived)")
    deck.says("expect", f"effective_plastic_strain element={{near}}  {plastic:.6g}  rel=0.01 (order)")
    for where, value in (("behind", plastic), ("past", 0.0)):
        deck.says("expect", f"effective_plastic_strain element={{{where}}}  {value:.6g}  abs={plastic / 2:.6g} "
                  "(order: half of the step lies within 2 % of 500 m/s t = 0.08 m)")
    common(deck, end)
    mesh = bar(deck, 400, 1.0, 0.0025)
    watched = dict(near=mesh.element_near(0.03, 0, 0), behind=mesh.element_near(0.0784, 0, 0),
                   past=mesh.element_near(0.0816, 0, 0), ahead=mesh.element_near(0.4, 0, 0),
                   before=mesh.element_near(0.85, 0, 0))
    deck.head = [line.format(**watched) for line in deck.head]
    histories(deck, end, elements=watched.values())
    tangent, young = 2.0e9, 200.0e9
    deck.card("MAT_PLASTIC_KINEMATIC", [1, 8000.0, young, 0.0, 4.0e6, tangent, 1.0], [0.0, 0.0, 0.0])
    deck.curve(1, [(0, 1), (1, 1)])
    end_face = deck.node_set(mesh.where(lambda x, y, z: x == 0))
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [end_face, 1, 0, 1, 0.3])
    deck.card("INITIAL_VELOCITY", [end_face], [0.3, 0.0, 0.0])
    deck.mesh(mesh)
    return deck


# --- bodies in motion --------------------------------------------------------------------------------------------

@case
def tumbling():
    """Catalogue A13: an L-shaped body tumbles freely and deforms."""
    deck = Deck("tumbling", "Tumbling L-shaped body")
    deck.says("case", "free flight of a deforming body: momentum exact, energy kept")
    deck.says("source", "conservation laws")
    end = 200.0
    for axis in "xyz":
        deck.says("expect", f"{axis}_momentum range  0.0  abs=1e-13 (roundoff: masses of order 10, velocities 0.01)")
    deck.says("expect", "energy_ratio range  0.0  abs=0.005 (order)")
    deck.says("vary", "threads=1,2,3,7")
    common(deck, end)
    mesh = box((6, 2, 2), (3.0, 1.0, 1.0))
    upper = box((2, 4, 2), (1.0, 2.0, 1.0))
    for part, nodes in upper.elements:
        mesh.element(part, [mesh.node(x, y + 1.0, z) for x, y, z in (upper.nodes[n - 1] for n in nodes)])
    deck.card("SECTION_SOLID", [1, 1])
    deck.card("HOURGLASS", [1, 5, 0.05])
    deck.part(1, 1, 1, hourglass=1)
    elastic(deck, 1, 1.0, 1.0, 0.3)
    everything = deck.node_set(list(range(1, len(mesh.nodes) + 1)))
    deck.card("INITIAL_VELOCITY_GENERATION", [everything, 3, 0.03, 0.01, -0.02, 0.005], [1.0, 0.8, 0.5, 0.2, 0.5, 1.0])
    deck.mesh(mesh)
    return deck


@case
def cantilever_vibration():
    """Catalogue D05: plane strain cantilever, first mode."""
    deck = Deck("cantilever_vibration", "Vibrating cantilever, plane strain")
    length, height, young, poisson, density = 0.2, 0.02, 2.0e6, 0.3975, 1000.0
    bulk = young / (3 * (1 - 2 * poisson))
    tip = 0.01 * math.sqrt(bulk / density)
    k = 1.8751 / length
    period = 0.25489
    def shape(x):
        # First mode of a clamped beam, 1 at the tip.
        a = k * length
        f = lambda s: ((math.cos(a) + math.cosh(a)) * (math.cosh(k * s) - math.cos(k * s))
                       + (math.sin(a) - math.sinh(a)) * (math.sinh(k * s) - math.sin(k * s)))
        return f(x) / f(length)
    amplitude = tip * period / (2 * math.pi)
    deck.says("case", "first bending period of a plane strain cantilever, ELFORM 2")
    deck.says("source", "two-dimensional elasticity: 0.25489 s; catalogue D05 (Gray, Monaghan & Swift 2001)")
    # After a period the tip is back: what is left over its speed is the error of the period, 1 % allowed.
    deck.says("expect", f"y_displacement node={{tip}} time={period}  0.0  abs={tip * 0.01 * period:.4g} "
              "(order: period within 1 %)")
    deck.says("expect", f"y_displacement node={{tip}} max  {amplitude:.5g}  rel=0.08 "
              "(model: thin-beam mode shape; higher modes take a part)")
    common(deck, 0.26, bulk=False, interval=0.0005)
    mesh = box((40, 4, 1), (length, height, 0.005))
    node = mesh.where(lambda x, y, z: x == length and y == height / 2 and z == 0)[0]
    deck.head = [line.format(tip=node) for line in deck.head]
    histories(deck, 0.26, [node], interval=0.0005)
    deck.card("SECTION_SOLID", [1, 2])
    deck.part(1, 1, 1)
    elastic(deck, 1, density, young, poisson)
    clamped = deck.node_set(mesh.where(lambda x, y, z: x == 0))
    deck.card("BOUNDARY_SPC_SET", [clamped, 0, 1, 1, 1])
    plane = deck.node_set(list(range(1, len(mesh.nodes) + 1)))
    deck.card("BOUNDARY_SPC_SET", [plane, 0, 0, 0, 1])
    deck.card("INITIAL_VELOCITY_NODE",
              *[[n + 1, 0.0, tip * shape(p[0]), 0.0] for n, p in enumerate(mesh.nodes) if p[0] > 0], wide=True)
    deck.mesh(mesh)
    return deck


@case
def collapsing_shell():
    """Catalogue D06 (Verney): a thick cylinder runs inward until plastic work has taken its kinetic energy."""
    deck = Deck("collapsing_shell", "Collapsing cylindrical shell, plane strain")
    inner, outer, density, yield_stress, shear = 80.0, 100.0, 1.845e-9, 330.0, 151.0e3
    target, speed = 50.0, 417.08e3
    poisson = 0.49
    deck.says("case", "imploding cylinder stops where its kinetic energy is spent, ELFORM 2")
    deck.says("source", "closed form (Verney 1968; Howell & Ball 2002); catalogue D06: inner 50 mm, outer 78.10 mm")
    deck.says("expect", f"x_displacement node={{inside}} min  {target - inner}  abs=0.5 (order: 1 % of 50 mm)")
    deck.says("expect", "x_displacement node={outside} min  -21.90  abs=0.79 (order: 1 % of 78.1 mm)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    end = 160e-6
    common(deck, end)
    quarter, cells = 16, 8
    mesh = hexahedra((cells, quarter, 1), lambda i, j, k: (
        (inner + (outer - inner) * i / cells) * math.cos(math.pi / 2 * j / quarter) if j < quarter else 0.0,
        (inner + (outer - inner) * i / cells) * math.sin(math.pi / 2 * j / quarter), 4.0 * k))
    at = lambda r: mesh.where(lambda x, y, z: abs(x - r) < 1e-9 and y == 0 and z == 0)[0]
    deck.head = [line.format(inside=at(inner), outside=at(outer)) for line in deck.head]
    histories(deck, end, [at(inner), at(outer)])
    deck.card("SECTION_SOLID", [1, 2])
    deck.part(1, 1, 1)
    deck.card("MAT_PLASTIC_KINEMATIC", [1, density, 2 * shear * (1 + poisson), poisson, yield_stress, 0.0, 1.0],
              [0.0, 0.0, 0.0])
    everything = deck.node_set(list(range(1, len(mesh.nodes) + 1)))
    deck.card("BOUNDARY_SPC_SET", [everything, 0, 0, 0, 1])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.where(lambda x, y, z: x == 0)), 0, 1, 0, 0])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.where(lambda x, y, z: y == 0)), 0, 0, 1, 0])
    rows = []
    for n, (x, y, z) in enumerate(mesh.nodes):
        s = -speed * inner / (x * x + y * y)
        rows.append([n + 1, s * x, s * y, 0.0])
    deck.card("INITIAL_VELOCITY_NODE", *rows, wide=True)
    deck.mesh(mesh)
    return deck


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


# --- order of convergence --------------------------------------------------------------------------------------------

def standing_wave(cells):
    """Free-free bar in its first longitudinal mode: after half a period every point passes zero."""
    finest = 32
    deck = Deck(f"standing_wave_{cells}", f"Standing wave in a bar, {cells} cells")
    amplitude, length = 1.0e-6, 1.0
    time = 1.0                                       # c = 1, period 2
    if cells == 8:
        deck.says("case", "standing wave in a bar: the phase error falls with the mesh size squared")
        deck.says("source", "closed form u = -U cos(pi x) sin(pi t), zero at t = 1")
        deck.says("order", f"x_displacement node=1 time={time} exact=0 in=1.85..2.15 "
                  f"with=standing_wave_16.k,standing_wave_{finest}.k (order)")
    common(deck, 1.01, safety=0.5, bulk=False, interval=1.0e-5)
    mesh = bar(deck, cells, length, length / cells)
    histories(deck, 1.01, [1], interval=1.0e-5)
    elastic(deck, 1, 1.0, 1.0, 0.0)
    rows = [[n + 1, -amplitude * math.pi * math.cos(math.pi * p[0]), 0.0, 0.0] for n, p in enumerate(mesh.nodes)]
    deck.card("INITIAL_VELOCITY_NODE", *rows, wide=True)
    deck.mesh(mesh)
    return deck


for _cells in (8, 16, 32):
    CASES[f"standing_wave_{_cells}"] = lambda cells=_cells: standing_wave(cells)


# --- Taylor bars -------------------------------------------------------------------------------------------------------

def taylor(deck, speed, end, mesh, form, hourglass, material):
    """A quarter bar that hits z = 0; `material` writes the law and returns the id of the equation of state."""
    common(deck, end)
    deck.card("SECTION_SOLID", [1, form])
    if hourglass:
        deck.card("HOURGLASS", [1, hourglass, 0.05])
    state = material(deck)
    deck.part(1, 1, 1, state=state, hourglass=1 if hourglass else 0)
    everything = deck.node_set(list(range(1, len(mesh.nodes) + 1)))
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.where(lambda x, y, z: x == 0)), 0, 1, 0, 0])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.where(lambda x, y, z: y == 0)), 0, 0, 1, 0])
    deck.card("INITIAL_VELOCITY", [everything], [0.0, 0.0, -speed])
    deck.card("RIGIDWALL_PLANAR", [everything], [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0])
    deck.mesh(mesh)
    return deck


def copper_d07(deck):
    deck.card("MAT_PLASTIC_KINEMATIC", [1, 8.93e-9, 117.0e3, 0.35, 400.0, 100.0, 1.0], [0.0, 0.0, 0.0])
    return 0


def taylor_d07(name, form, split, hourglass, counts):
    """Catalogue D07."""
    deck = Deck(name, f"Taylor bar, copper, ELFORM {form}")
    deck.says("case", f"copper Taylor bar, linear hardening, ELFORM {form}")
    deck.says("source", "axisymmetric B-bar 21.49 to 21.52, 7.24 to 7.33; published about 21.4, 7.0 to 7.2; catalogue D07")
    deck.says("expect", "summary parts.0.final.length.2  21.5  abs=0.25 (model: final length)")
    deck.says("expect", "summary parts.0.final.length.0  7.2  abs=0.25 (model: foot radius)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    return taylor(deck, 227.0e3, 80e-6, split(quarter_cylinder(*counts, 3.2, 32.4)), form, hourglass, copper_d07)


@case
def taylor_one_point():
    return taylor_d07("taylor_one_point", 1, lambda m: m, 3, (3, 2, 36))


@case
def taylor_selective():
    return taylor_d07("taylor_selective", 2, lambda m: m, None, (3, 2, 36))


@case
def taylor_nodal_pressure():
    return taylor_d07("taylor_nodal_pressure", 13, tetrahedra, None, (3, 2, 36))


# Johnson & Cook 1983: A B n C m Tm; E, nu, density, heat capacity (tonne, mm, s, K).
JOHNSON_COOK = {
    "copper": (90.0, 292.0, 0.31, 0.025, 1.09, 1356.0, 124.0e3, 0.34, 8.96e-9, 383.0e6),
    "steel_4340": (792.0, 510.0, 0.26, 0.014, 1.03, 1793.0, 200.0e3, 0.29, 7.83e-9, 477.0e6)}


def johnson_cook(metal):
    def write(deck):
        a, b, n, c, m, melt, young, poisson, density, heat = JOHNSON_COOK[metal]
        deck.card("MAT_JOHNSON_COOK", [1, density, young / (2 * (1 + poisson)), young, poisson, 0.0, 0.0, 0.0],
                  [a, b, n, c, m, melt, 293.0, 1.0], [heat, -1.0e9, 2.0, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 0.0, 0.0])
        bulk = young / (3 * (1 - 2 * poisson))
        deck.card("EOS_LINEAR_POLYNOMIAL", [1, 0.0, bulk, 0.0, 0.0, 0.0, 0.0, 0.0], [0.0, 1.0])
        return 1
    return write


D08 = {  # name: metal, length, diameter, speed [m/s], reference code: length, foot diameter; experiment: the same
    "taylor_copper_130": ("copper", 25.4, 7.62, 130.0, (20.66, 11.20), (19.56, 9.91)),
    "taylor_copper_190": ("copper", 25.4, 7.62, 190.0, (17.31, 14.5), (16.20, 13.56)),
    "taylor_4340_208": ("steel_4340", 25.4, 7.62, 208.0, (22.60, 10.67), (22.48, 11.10)),
    "taylor_4340_343": ("steel_4340", 8.1, 7.62, 343.0, (6.05, 11.63), (6.54, 12.00))}


def taylor_d08(name):
    """Catalogue D08: code against code within 1.5 % of the length (and a twentieth of the shortening) and 4 % of
    the diameter, the measured bar within 8 % and 15 %."""
    metal, length, diameter, speed, code, measured = D08[name]
    deck = Deck(name, f"Taylor test, {metal.replace('_', ' ')}, {speed:g} m/s")
    deck.says("case", f"Johnson-Cook Taylor bar, {metal.replace('_', ' ')}, {speed:g} m/s")
    deck.says("source", "Johnson & Cook 1983 (measured) and an axisymmetric B-bar code with their constants; catalogue D08")
    for words, (final, foot), (of_length, of_foot, of_change) in (("code", code, (0.015, 0.04, 0.05)),
                                                                  ("measured", measured, (0.08, 0.15, 1.0))):
        allowed = min(of_length * final, of_change * (length - final))
        deck.says("expect", f"summary parts.0.final.length.2  {final}  abs={allowed:.3f} (model: {words}, final length)")
        deck.says("expect", f"summary parts.0.final.length.0  {foot / 2}  rel={of_foot} (model: {words}, foot radius)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    layers = 32 if length > 10 else 12
    end = 80e-6 if length > 10 else 40e-6
    return taylor(deck, speed * 1000, end, quarter_cylinder(3, 2, layers, diameter / 2, length),
                  1, 3, johnson_cook(metal))


for _name in D08:
    CASES[_name] = lambda name=_name: taylor_d08(name)


WILKINS = {169: 21.59, 262: 19.81, 306: 18.40, 373: 16.50, 478: 13.19}   # 6061-T6, m/s: final length of 23.47 mm


def taylor_6061(speed):
    """Catalogue D08, 6061-T6: perfectly plastic at 420 MPa, against the bars. (The fit quoted there with this
    strength lies up to 3.6 % below the bars themselves at the highest speeds, so it does not gate.)

    The tolerance is a tenth of the shortening: of the length, 8 % would pass a bar that hardly deforms."""
    length, diameter, strength, density = 23.47, 7.62, 420.0, 2.70e-9
    deck = Deck(f"taylor_6061_{speed}", f"Taylor test, 6061-T6, {speed} m/s")
    deck.says("case", f"perfectly plastic Taylor bar, 6061-T6, {speed} m/s")
    deck.says("source", "Wilkins & Guinan 1973: measured lengths, strength 420 MPa; catalogue D08")
    deck.says("expect", f"summary parts.0.final.length.2  {WILKINS[speed]}  abs={0.1 * (length - WILKINS[speed]):.3f} "
              "(model: measured; a tenth of the shortening)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")

    def material(d):
        d.card("MAT_PLASTIC_KINEMATIC", [1, density, 69.0e3, 0.33, strength, 0.0, 1.0], [0.0, 0.0, 0.0])
        return 0
    return taylor(deck, speed * 1000.0, 60e-6, quarter_cylinder(3, 2, 28, diameter / 2, length), 1, 3, material)


for _speed in WILKINS:
    CASES[f"taylor_6061_{_speed}"] = lambda speed=_speed: taylor_6061(speed)


def taylor_copper_long(speed, measured):
    """Catalogue D08, the copper bars of Wilkins & Guinan with the constants of Johnson & Cook."""
    length, diameter = 23.47, 7.62
    deck = Deck(f"taylor_copper_{speed}", f"Taylor test, copper, {speed} m/s")
    deck.says("case", f"Johnson-Cook Taylor bar, copper, {speed} m/s")
    deck.says("source", "Wilkins & Guinan 1973 (measured); catalogue D08")
    deck.says("expect", f"summary parts.0.final.length.2  {measured}  abs={0.1 * (length - measured):.3f} "
              "(model: measured; a tenth of the shortening)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    return taylor(deck, speed * 1000.0, 80e-6, quarter_cylinder(3, 2, 28, diameter / 2, length), 1, 3,
                  johnson_cook("copper"))


CASES["taylor_copper_123"] = lambda: taylor_copper_long(123, 19.60)
CASES["taylor_copper_183"] = lambda: taylor_copper_long(183, 16.81)


CASES.update({**spacetime.CASES, **spacetime.EXAMPLES})


if __name__ == "__main__":
    for name in sys.argv[1:] or CASES:
        written = {**CASES, **spacetime.LARGE}[name]()
        folder = HERE.parent / "validation" if name.startswith("taylor") else HERE
        if name in spacetime.EXAMPLES:
            folder = HERE.parent.parent / "examples" / name
            folder.mkdir(exist_ok=True)
        elif name in spacetime.LARGE:
            folder = Path(".")
        (folder / (written.name + ".k")).write_text(written.text())
        print(written.name)
