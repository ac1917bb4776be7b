"""Decks in which strain and stress are the same everywhere. Used by make.py."""
import math

from basics import Cases, common, elastic, histories
from deck import Deck
from mesh import box, hexahedra, hexahedron_volume, outer_faces, tetrahedra, wedges

CASES = case = Cases()


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
