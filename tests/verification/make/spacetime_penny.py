"""Decks of a penny-shaped crack. Used by spacetime.py."""
import math

from basics import Cases
from crack import StepLoadedCrack
from deck import Deck
from simplices import faces_on, penny_quarter
from spacetime_basics import common, node_at, plane_strain_modulus, push, rollers, step_curve, write_mesh

EXAMPLES, LARGE = Cases(), Cases()   # tests that are shown, too; on demand only


def penny(name, rings, outer, width, heights, degree, end, whole):
    """V14: the faces of a penny-shaped crack are pushed apart suddenly (which is what scatters from a step wave of
    tension); a quarter of the body, silent outside, or of its upper half. Layers are thin where the wave starts."""
    nu, speed, height = 0.25, 1.0, heights[-1]
    mesh = penny_quarter(1.0, rings, outer, width, [-h for h in reversed(heights)] * whole + [0.0] + list(heights))
    deck = Deck(name, "Penny-shaped crack under a step wave")
    side = -1 if whole else 1
    at = lambda r, angle=0.0: node_at(mesh, r * math.cos(math.radians(angle)), r * math.sin(math.radians(angle)), 0.0)
    radii = [k / rings for k in range(rings)]
    nodes = [at(r) for r in radii] + [at(r, angle) for r in radii[1:] for angle in (45.0, 90.0)] + [at(0.5, 22.5)]
    deck.says("case", "faces of a penny-shaped crack before the waves of its rim arrive, and after; the same all round")
    deck.says("source", "opening 2 s t/(rho c_d) until t = (a - r)/c_d; specification V14")
    face = "the lower face, which comes first in the mesh" if whole else "the upper face"
    for r, times in ((0.0, (0.2, 0.4, 0.6, 0.9)), (0.25, (0.2, 0.4, 0.7)), (0.5, (0.2, 0.3, 0.45))):
        for t in times:
            deck.says("expect", f"z_displacement node={at(r)} time={t:g}  {side * t / speed:.6g}  "
                      f"rel={0.004 if r == 0.0 and whole else 0.015 if t < 0.25 and not whole else 0.01} (order: {face})")
    deck.says("analyse", "axisymmetry.py")
    for r in (0.25, 0.5, 0.75):
        for t in (0.3, 0.6, 0.9):
            deck.says("expect", f"spread file=axisymmetry radius={r:g} time={t:g}  0.0  abs=0.03 (order)")
    exact = StepLoadedCrack(nu)
    for t in (0.3, 0.45, 0.6):
        deck.says("expect", f"z_displacement node={at(0.75)} time={t:g}  {side * t * exact.displacement(t / 0.25):.6g}  rel={0.03 if whole else 0.02} "
                  "(model: a straight rim with the intensity of Freund, until the rest of the rim is felt)")
    if end > 4.5:
        for r in (0.0, 0.25, 0.5, 0.75):
            u = 4 * (1 - nu ** 2) * math.sqrt(1 - r * r) / (math.pi * plane_strain_modulus(nu, 1.0, speed))
            deck.says("expect", f"z_displacement node={at(r)} time=4.75  {u:.6g}  rel=0.1 (model: at rest, Sneddon 1946)")
    common(deck, end, degree=degree, interval=0.01 if end < 1 else 0.05, nodes=nodes, frames=9 if end < 1 else 16)
    deck.card("SECTION_SOLID_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(nu, 1.0, speed), nu])
    step_curve(deck, 1)
    near = lambda a, b: abs(a - b) < 1e-9
    inside = set(mesh.where(lambda x, y, z: near(z, 0.0) and math.hypot(x, y) < 1.0 + 1e-9))
    upper, lower = [], []
    for _, n in mesh.elements:
        face = [k for k in n if k in inside]
        if len(face) == 3:
            apex = next(k for k in n if k not in inside)
            a, b, c = (mesh.nodes[k - 1] for k in face)
            turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            if mesh.nodes[apex - 1][2] > 0:      # the body above: its face looks down
                upper.append(face if turn < 0 else [face[0], face[2], face[1]])
            else:
                lower.append(face if turn > 0 else [face[0], face[2], face[1]])
    push(deck, upper + lower, 1, 1.0)
    rollers(deck, mesh.where(lambda x, y, z: near(x, 0.0)), "x")
    rollers(deck, mesh.where(lambda x, y, z: near(y, 0.0)), "y")
    outside = (faces_on(mesh, lambda x, y, z: near(x, width)) + faces_on(mesh, lambda x, y, z: near(y, width))
               + faces_on(mesh, lambda x, y, z: near(abs(z), height)))
    deck.card("BOUNDARY_NON_REFLECTING", [deck.segment_set([list(f) + [f[2]] for f in outside])])
    if whole:
        rim = [mesh.nodes[k - 1] for k in inside if near(math.hypot(*mesh.nodes[k - 1][:2]), 1.0)]
        rim.sort(key=lambda p: math.atan2(p[1], p[0]))
        deck.card("BOUNDARY_PRECRACK", [1, 1, len(rim) + 1], [0.0, 0.0, 0.0], *[list(p) for p in rim], wide=True)
    else:
        rollers(deck, mesh.where(lambda x, y, z: near(z, 0.0) and math.hypot(x, y) > 1.0 - 1e-9), "z")
    write_mesh(deck, mesh)
    return deck


EXAMPLES["penny_crack"] = lambda: penny("penny_crack", 4, 2, 1.8, (0.06, 0.14, 0.25, 0.42, 0.7), 3, 0.9, whole=True)
# Far sides, to the static limit; and near ones with elements of one size, for pictures.
LARGE["penny_crack_fine"] = lambda: penny("penny_crack_fine", 8, 6, 4.0, (0.05, 0.11, 0.2, 0.33, 0.5, 0.75, 1.1, 1.6, 2.3, 3.2), 3,
                                          4.8, whole=False)
LARGE["penny_crack_waves"] = lambda: penny("penny_crack_waves", 8, 6, 2.3, (0.06, 0.14, 0.25, 0.38, 0.53, 0.7, 0.88, 1.07, 1.27, 1.5),
                                           3, 1.6, whole=False)
