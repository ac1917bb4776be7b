"""Decks of bodies in motion. Used by make.py."""
import math

from basics import Cases, common, elastic, histories
from deck import Deck
from mesh import box, hexahedra

CASES = case = Cases()


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
