"""A deck of waves in sheets of a material with directions. Used by spacetime.py."""
import math

from basics import Cases
from deck import Deck
from mesh import Mesh
from simplices import Triangles
from spacetime_basics import common, node_at, pulse, pulse_curve, rollers, write_mesh

CASES = case = Cases()

FIBRES = {"density": 2.0, "young": (10.0, 4.0, 5.0), "ba": 0.12, "ca": 0.1, "cb": 0.25, "shear": (1.5, 1.0, 0.8)}


def fibre_stiffness(angle, stress):
    """C_11 C_12 C_16, C_22 C_26, C_66 in the plane as a dictionary of pairs, and C_31 C_32 C_36 across it, of FIBRES with
    axis a at an angle to x [rad]: the compliance inverted, turned as a tensor, reduced in plane stress."""
    (e, f, g), (ba, ca, cb) = FIBRES["young"], (FIBRES[k] for k in ("ba", "ca", "cb"))
    s = [[1 / e, -ba / f, -ca / g], [-ba / f, 1 / f, -cb / g], [-ca / g, -cb / g, 1 / g]]
    minor = lambda i, j: s[(j + 1) % 3][(i + 1) % 3] * s[(j + 2) % 3][(i + 2) % 3] - s[(j + 1) % 3][(i + 2) % 3] * s[(j + 2) % 3][(i + 1) % 3]
    det = sum(s[0][j] * minor(j, 0) for j in range(3))
    c = [[minor(i, j) / det for j in range(3)] for i in range(3)]
    local = {}
    for i in range(3):
        for j in range(3):
            local[i, i, j, j] = c[i][j]
    for p in ((0, 1, 0, 1), (0, 1, 1, 0), (1, 0, 0, 1), (1, 0, 1, 0)):
        local[p] = FIBRES["shear"][0]
    axes = [(math.cos(angle), math.sin(angle), 0.0), (-math.sin(angle), math.cos(angle), 0.0), (0.0, 0.0, 1.0)]
    turned = lambda *to: sum(v * math.prod(axes[a][k] for a, k in zip(of, to)) for of, v in local.items())
    pairs = [(0, 0), (1, 1), (0, 1)]
    across = [turned(2, 2, *p) for p in pairs]
    plane = [[turned(*p, *q) - (across[i] * across[j] / turned(2, 2, 2, 2) if stress else 0.0) for j, q in enumerate(pairs)]
             for i, p in enumerate(pairs)]
    return plane, [0.0] * 3 if stress else across


def quasi_longitudinal(plane, density):
    """Speed and direction of motion of the faster wave along x: the larger eigenvalue of the Christoffel matrix."""
    a, b, d = plane[0][0], plane[0][2], plane[2][2]
    value = (a + d) / 2 + math.hypot((a - d) / 2, b)
    angle = 0.5 * math.atan2(2 * b, a - d)
    return math.sqrt(value / density), (math.cos(angle), math.sin(angle))


@case
def spacetime_fibres():
    """Quasi-longitudinal pulses along x through four sheets: fibres along x and at 30 degrees, plane strain and stress."""
    deck = Deck("spacetime_fibres", "Pulses through orthotropic sheets")
    deck.says("case", "quasi-longitudinal waves along and at 30 degrees to the fibres, plane strain and plane stress")
    deck.says("source", "Christoffel: rho c^2 is the larger eigenvalue of C_1j1l, whose eigenvector is the motion")
    length, h, end, rise = 1.0, 0.125, 0.5, 0.3
    whole = Mesh()
    plan = []   # part, angle, stress, height, foot
    for part, (angle, stress) in enumerate(((0.0, False), (0.0, True), (30.0, False), (30.0, True)), 1):
        # Across the fibres symmetric; at an angle what the free edges change must not reach the middle.
        plan.append((part, angle, stress, 2.5 if angle else 0.25, 3.0 * part))
    nodes, sides, driven = [], [], []
    for part, angle, stress, height, foot in plan:
        counts = (round(length / h), round(height / h))
        mesh = Triangles((0.0, foot), (length, foot + height), counts, lambda x, y: h).mesh(lambda x, y: part)
        first = len(whole.nodes)
        whole.nodes += mesh.nodes
        whole.elements += [(part, [n + first for n in e]) for part, e in mesh.elements]
        at = lambda x: first + node_at(mesh, x, foot + height / 2)
        plane, across = fibre_stiffness(math.radians(angle), stress)
        speed, motion = quasi_longitudinal(plane, FIBRES["density"])
        place = at(0.5)
        what = f"{'at 30 degrees to' if angle else 'along'} the fibres, plane {'stress' if stress else 'strain'}"
        # On the flanks, where a speed off by 1 % shows as 4 % of the crest, and on the crest; and what has passed.
        for phase in (0.28, 0.5, 0.72):
            t = 0.5 / speed + phase * rise
            for k in (0, 1):
                deck.says("expect", f"{'xy'[k]}_velocity node={place} time={t:.8g}  {motion[k] * pulse(phase * rise, rise):.6g}  "
                          f"abs=0.008 (order: c = {speed:.6g}, {what})")
        strain = (-motion[0] / speed, 0.0, -motion[1] / speed / 2)   # at the crest, of velocity 1 along `motion`
        zz = 0.0 if stress else across[0] * strain[0] + 2 * across[2] * strain[2]
        nodes.append((place, part, 0.5 / speed + 0.5 * rise, zz, foot + height / 2))
        edge = [first + k for k in mesh.where(lambda x, y, z: x == 0.0)]
        driven.append((edge, motion))
        if not angle:
            sides.append([first + k for k in mesh.where(lambda x, y, z: y in (foot, foot + height))])
    moment = nodes[0][2]   # of the pictures: the crest of the first sheet
    deck.says("analyse", "field_at.py stress_across " + " ".join(f"0.5,{y:g}" for _, _, _, _, y in nodes))
    for place, part, t, zz, _ in nodes:
        deck.says("expect", f"stress_across file=field_at place={part} time={t:.8g}  {zz + 0.0:.6g}  "
                  + ("abs=1e-12 (roundoff: plane stress)" if zz == 0.0 else "rel=0.04 (order: linear between frames)"))
    common(deck, end, degree=4, interval=0.0025, nodes=[n[0] for n in nodes], frames=50)
    deck.card("SECTION_SHELL_SDG", [1, 13])
    deck.card("SECTION_SHELL_SDG", [2, 12])
    (ea, eb, ec), (gab, gbc, gca) = FIBRES["young"], FIBRES["shear"]
    for part, angle, stress, _, _ in plan:
        deck.part(part, 2 if stress else 1, part)
        turn = math.radians(angle)
        # Both ways to say where the fibres are: v x n turned by BETA, or two vectors.
        rows = [[0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, angle]] if stress else \
            [[0.0, 0.0, 0.0, round(math.cos(turn), 7), round(math.sin(turn), 7), 0.0], [0.0, 0.0, 0.0, 0.0, 1.0, 0.0]]
        deck.card("MAT_ORTHOTROPIC_ELASTIC", [part, FIBRES["density"], ea, eb, ec, FIBRES["ba"], FIBRES["ca"], FIBRES["cb"]],
                  [gab, gbc, gca, 3 if stress else 2], *rows)
    pulse_curve(deck, 1, rise)
    for edge, motion in driven:
        moved = deck.node_set(edge)
        for k in (0, 1):
            if motion[k]:      # a factor of zero would be the default, one
                deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [moved, k + 1, 0, 1, round(motion[k], 7)])
            else:
                rollers(deck, edge, "xy"[k])
    for edge in sides:
        rollers(deck, edge, "y")
    write_mesh(deck, whole)
    return deck
