"""Published figures of dynamic stress intensity and of a cavity, in spacetime. Used by spacetime.py."""
import math

from basics import Cases
from crack import intensity
from deck import Deck
from mesh import Mesh
from simplices import Triangles, edges_on, faces_on
from spacetime_basics import common, node_at, plane_strain_modulus, push, rollers, step_curve, write_mesh

CASES, LARGE = Cases(), Cases()

# Catalogue I02: K/(s sqrt(pi a)) by time in microseconds, dynamic J integral on graded spectral quadrilaterals.
CHEN = [(3.0, 0.954), (3.5, 1.377), (4.0, 1.730), (4.5, 1.662), (5.0, 1.747), (5.5, 1.899), (6.0, 2.545), (6.5, 2.632),
        (7.5, 2.375), (8.0, 2.258), (8.5, 1.691), (9.0, 1.182), (9.5, 0.695), (10.0, 0.430)]


def peak(deck, tip, value, time, close, close_in_time):
    deck.says("analyse", f"peak.py crack_tip K_I {tip}")
    deck.says("expect", f"K_I file=peak  {value:.6g}  rel={close:g} (order: the largest)")
    deck.says("expect", f"at file=peak  {time:g}  rel={close_in_time:g} (order: and when)")


def centre_crack(name, coarse, fine, growth, degree):
    """I02: half of a 20 x 40 mm plate with a crack of 4.8 mm in its middle, both ends pulled suddenly. g, mm, ms, MPa."""
    half, stress = 2.4, 100.0
    # Triangles of squares 2.5 wide, then a little narrower up to the tip of the crack and wider beyond it.
    place = lambda x: 0.96 * x if x < 2.5 else half + (x - 2.5) * (10.0 - half) / 7.5
    size = lambda x, y: max(fine, min(coarse, growth * math.hypot(x - 2.5, y)))
    mesh = Triangles((0.0, -20.0), (10.0, 20.0), (4, 16), size).mesh()
    mesh.nodes = [(place(x), y, z) for x, y, z in mesh.nodes]
    deck = Deck(name, "Centre crack in a plate under a step of tension")
    tip, unit = node_at(mesh, half, 0.0), stress * math.sqrt(math.pi * half)
    deck.says("case", "stress intensity of a crack in a plate 20 x 40 mm, a step of tension at both ends, to 10 microseconds")
    deck.says("source", "catalogue I02: dynamic J on two meshes of graded spectral quadrilaterals, 2.663 and 2.668; Chen 1975 and "
              "successors 2.6 to 2.8")
    deck.says("expect", f"K_I file=crack_tip id={tip} time=0.0024  0.0  abs={0.01 * unit:.3g} (order: the wave comes at 0.002726)")
    for t, k in CHEN:
        deck.says("expect", f"K_I file=crack_tip id={tip} time={t * 1e-3:g}  {k * unit:.6g}  abs={0.03 * 2.668 * unit:.3g} "
                  f"(order: {k:g} of s sqrt(pi a), to 3 per cent of the largest)")
    peak(deck, tip, 2.668 * unit, 6.82e-3, 0.02, 0.02)
    deck.says("slow", "")
    common(deck, 0.0101, degree=degree, interval=1e-4)
    deck.card("DATABASE_NODOUT", [5e-5])
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 5.0e-3, 200.0e3, 0.3])
    step_curve(deck, 1)
    near = lambda a, b: abs(a - b) < 1e-9
    push(deck, [e + e[1:] for e in edges_on(mesh, lambda x, y, z: near(abs(y), 20.0))], 1, -stress)
    rollers(deck, mesh.where(lambda x, y, z: near(x, 0.0)), "x")
    deck.card("BOUNDARY_PRECRACK", [1, 1, 2], [0.0, 0.0, 0.0], [half, 0.0, 0.0])
    write_mesh(deck, mesh)
    return deck


CASES["spacetime_centre_crack"] = lambda: centre_crack("spacetime_centre_crack", 1.25, 0.15, 0.5, 3)
LARGE["spacetime_centre_crack_fine"] = lambda: centre_crack("spacetime_centre_crack_fine", 1.25, 0.0375, 0.35, 3)


def crack_edges(mesh, test):
    """Both sides of the edges inside a mesh of triangles whose two nodes pass the test, the body to their left."""
    inside = set(mesh.where(test))
    return [[n[k], n[(k + 1) % 3]] for _, n in mesh.elements for k in range(3) if {n[k], n[(k + 1) % 3]} <= inside]


def pushed_crack(name, width, coarse, fine, growth, degree, end, space=3):
    """I03 in the plane: the faces of a crack two long are pushed apart suddenly; half of a large body, silent outside."""
    nu = 0.25
    size = lambda x, y: max(fine, min(coarse, growth * math.hypot(x - 1.0, y)))
    mesh = Triangles((0.0, -width), (width, width), (round(width), round(2 * width)), size).mesh()
    deck = Deck(name, "Crack under sudden pressure")
    tip = node_at(mesh, 1.0, 0.0)
    what = {1: "one field", 2: "three fields", 3: "Trefftz functions"}[space]
    deck.says("case", f"stress intensity of a crack in a large body whose faces are pushed apart suddenly; {what}")
    deck.says("source", "Freund (1990), section 2.4, until waves from the other tip arrive; then catalogue I03: largest 1.30 of static at 3.9")
    for t in (0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0):
        deck.says("expect", f"K_I file=crack_tip id={tip} time={t:g}  {intensity(nu, 1.0, t):.6g}  rel=0.02 (order: of a semi-infinite crack)")
    deck.says("expect", f"K_II file=crack_tip id={tip} peak  0.0  abs=0.01 (order: nothing slides)")
    peak(deck, tip, 1.30 * math.sqrt(math.pi), 3.9, 0.02, 0.04)
    common(deck, end, space, degree, interval=0.05)
    deck.card("DATABASE_NODOUT", [0.025])
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(nu, 1.0, 1.0), nu])
    step_curve(deck, 1)
    faces = crack_edges(mesh, lambda x, y, z: y == 0.0 and x < 1.0 + 1e-9)
    push(deck, [e + e[1:] for e in faces], 1, 1.0)
    near = lambda a, b: abs(a - b) < 1e-9
    outside = edges_on(mesh, lambda x, y, z: near(x, width)) + edges_on(mesh, lambda x, y, z: near(abs(y), width))
    deck.card("BOUNDARY_NON_REFLECTING", [deck.segment_set([e + e[1:] for e in outside])])
    rollers(deck, mesh.where(lambda x, y, z: near(x, 0.0)), "x")
    deck.card("BOUNDARY_PRECRACK", [1, 1, 2], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0])
    write_mesh(deck, mesh)
    return deck


for _name, _space, _degree in (("spacetime_pushed_crack", 3, 3), ("spacetime_pushed_crack_one_field", 1, 3),
                               ("spacetime_pushed_crack_three_fields", 2, 2)):
    CASES[_name] = lambda name=_name, space=_space, degree=_degree: pushed_crack(name, 3.0, 0.5, 0.03125, 0.5, degree, 4.5, space)


# Catalogue D04, nu = 1/4: c_d t/a, hoop stress at the wall over the pressure, u (lambda + 2 mu)/(p a).
CAVITY = [(0.25, -0.1165, 0.2440), (0.5, 0.0872, 0.4731), (1, 0.4453, 0.8759), (1.5, 0.7308, 1.1972), (2, 0.9444, 1.4375),
          (2.5, 1.0931, 1.6048), (3, 1.1870, 1.7104), (4, 1.2548, 1.7866), (5, 1.2290, 1.7576), (6, 1.1684, 1.6895),
          (8, 1.0599, 1.5673), (10, 1.0131, 1.5147), (20, 1.0050, 1.5056)]


def cavity(name, cells, degree):
    """D04: a pressure appears in a cylindrical cavity; a sector out to where no wave comes back from in time."""
    nu, angle, reach = 0.25, 0.2, 2.5
    flat = Triangles((0.0, 0.0), (reach, angle), (round(reach * cells), round(angle * cells)), lambda x, y: 9.0).mesh()
    mesh = Mesh()      # the logarithm of the radius and the angle: elements grow with the radius and keep their shape
    for x, y, _ in flat.nodes:
        mesh.node(math.exp(x) * math.cos(y), math.exp(x) * math.sin(y), 0.0)
    mesh.elements = flat.elements
    deck = Deck(name, "Sudden pressure in a cylindrical cavity")
    wall = node_at(mesh, 1.0, 0.0)
    deck.says("case", f"hoop stress at the wall of a cavity and its displacement, to rest; straight edges, {cells} to the radius")
    deck.says("source", "Selberg 1952; two inversions of the Laplace transform, catalogue D04, nu = 1/4")
    deck.says("analyse", "hoop_at_wall.py 1 0.2")
    for t, hoop, u in CAVITY:
        deck.says("expect", f"hoop file=hoop_at_wall time={t:g}  {hoop:g}  abs=0.01 (order)")
        deck.says("expect", f"x_displacement node={wall} time={t:g}  {u:g}  rel=0.005 (order)")
    deck.says("expect", "hoop file=hoop_at_wall max  1.2553  rel=0.005 (order: the largest, at 4.1)")
    deck.says("slow", "")
    common(deck, 20.0, degree=degree, interval=0.25, nodes=[wall], parts=3)
    deck.card("DATABASE_BINARY_D3PLOT", [0.25])
    deck.card("SECTION_SHELL_SDG", [1, 13])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(nu, 1.0, 1.0), nu])
    step_curve(deck, 1)
    push(deck, [e + e[1:] for e in edges_on(flat, lambda x, y, z: x == 0.0)], 1, 1.0)
    rollers(deck, flat.where(lambda x, y, z: y == 0.0), "y")
    turned_rollers(deck, flat.where(lambda x, y, z: abs(y - angle) < 1e-9), angle)
    write_mesh(deck, mesh)
    return deck


CASES["spacetime_cavity"] = lambda: cavity("spacetime_cavity", 20, 3)


def turned_rollers(deck, nodes, angle):
    """Holds nodes square to the plane that contains the z axis and stands at an angle from the x axis."""
    number = 1 + deck.sets
    deck.card("DEFINE_COORDINATE_VECTOR", [number, math.cos(angle), math.sin(angle), 0.0, -math.sin(angle), math.cos(angle), 0.0], wide=True)
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(nodes), number, 0, 1, 0])


# Catalogue I03, nu = 1/4: c_d t/a, K over 2 p sqrt(a/pi).
PENNY = [(0.25, 0.489), (0.5, 0.634), (0.75, 0.762), (1.0, 0.860), (1.25, 0.955), (1.5, 1.023), (2.0, 1.141), (2.5, 1.212), (3.0, 1.239), (5.0, 0.95),
         (6.0, 0.92)]


def wedge_of(mesh, angle):
    """Tetrahedra of a wedge about the z axis, from y = 0 to `angle`, over triangles in the (r, z) plane."""
    solid = Mesh()
    low = [solid.node(x, 0.0, y) for x, y, _ in mesh.nodes]
    high = [solid.node(x * math.cos(angle), x * math.sin(angle), y) for x, y, _ in mesh.nodes]
    for part, (a, b, c) in ((p, sorted(n)) for p, n in mesh.elements):
        a, b, c = a - 1, b - 1, c - 1
        for tet in ((low[a], low[b], low[c], high[c]), (low[a], low[b], high[b], high[c]), (low[a], high[a], high[b], high[c])):
            if len(set(tet)) < 4:      # on the axis
                continue
            p, *others = (solid.nodes[k - 1] for k in tet)
            (a1, a2, a3), (b1, b2, b3), (c1, c2, c3) = ([q - o for q, o in zip(w, p)] for w in others)
            volume = a1 * (b2 * c3 - b3 * c2) - a2 * (b1 * c3 - b3 * c1) + a3 * (b1 * c2 - b2 * c1)
            solid.element(part, tet if volume > 0 else (tet[1], tet[0], tet[2], tet[3]))
    return solid


def pushed_penny(name, width, coarse, fine, growth, degree, end, times, angle=math.pi / 24):
    """I03 in space: a wedge of a large body with a penny-shaped crack whose faces are pushed apart suddenly."""
    nu = 0.25
    size = lambda x, y: max(fine, min(coarse, growth * math.hypot(x - 1.0, y)))
    mesh = wedge_of(Triangles((0.0, -width), (width, width), (round(width), round(2 * width)), size).mesh(), angle)
    deck = Deck(name, "Penny-shaped crack under sudden pressure")
    tips = [node_at(mesh, 1.0, 0.0, 0.0), node_at(mesh, math.cos(angle), math.sin(angle), 0.0)]
    static = 2 / math.sqrt(math.pi)
    deck.says("case", "stress intensity of a penny-shaped crack whose faces are pushed apart suddenly, both ends of a rim of a wedge")
    deck.says("source", "catalogue I03, nu = 1/4; largest 1.28 +- 0.05 of static near 3.5")
    for t, k in PENNY:
        if times[0] <= t <= times[1]:
            for tip in tips:
                deck.says("expect", f"K_I file=crack_tip id={tip} time={t:g}  {k * static:.6g}  rel=0.06 (model: {k:g} of 2 p sqrt(a/pi))")
    if times[1] > 3:
        for tip in tips:
            deck.says("expect", f"K_I file=crack_tip id={tip} max  {1.28 * static:.6g}  rel={0.1 if end > 4 else 0.06:g} "
                      "(model: the largest, which the reference has to 4 per cent)")
        deck.says("slow", "")
    common(deck, end, degree=degree, interval=0.05)
    deck.card("DATABASE_NODOUT", [0.025])
    deck.card("SECTION_SOLID_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(nu, 1.0, 1.0), nu])
    step_curve(deck, 1)
    near = lambda a, b: abs(a - b) < 1e-9
    push(deck, crack_faces(mesh, lambda x, y, z: near(z, 0.0) and math.hypot(x, y) < 1.0 + 1e-9), 1, 1.0)
    rollers(deck, mesh.where(lambda x, y, z: near(y, 0.0)), "y")
    turned_rollers(deck, mesh.where(lambda x, y, z: near(y * math.cos(angle), x * math.sin(angle))), angle)
    rim = lambda x, y, z: near(math.hypot(x, y), width)
    outside = faces_on(mesh, rim) + faces_on(mesh, lambda x, y, z: near(abs(z), width))
    deck.card("BOUNDARY_NON_REFLECTING", [deck.segment_set([list(f) + [f[2]] for f in outside])])
    deck.card("BOUNDARY_PRECRACK", [1, 1, 3], [0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [math.cos(angle), math.sin(angle), 0.0], wide=True)
    write_mesh(deck, mesh)
    return deck


def crack_faces(mesh, test):
    """Both sides of the faces inside a mesh of tetrahedra whose nodes pass the test, counter-clockwise seen from outside."""
    inside = set(mesh.where(test))
    faces = []
    for _, n in mesh.elements:
        for face in ((n[0], n[2], n[1]), (n[0], n[1], n[3]), (n[1], n[2], n[3]), (n[0], n[3], n[2])):
            if set(face) <= inside:
                faces.append(face)
    return faces


# Early, the elements at the rim must be small against what waves have run.
CASES["spacetime_pushed_penny_early"] = lambda: pushed_penny("spacetime_pushed_penny_early", 2.0, 0.5, 0.015625, 0.6, 2, 0.55, (0.0, 0.6))
CASES["spacetime_pushed_penny"] = lambda: pushed_penny("spacetime_pushed_penny", 3.0, 0.5, 0.0625, 0.6, 2, 3.5, (0.7, 3.5))
LARGE["spacetime_pushed_penny_fine"] = lambda: pushed_penny("spacetime_pushed_penny_fine", 4.0, 0.5, 0.03125, 0.5, 3, 6.5, (0.4, 6.5))
