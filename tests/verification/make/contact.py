#!/usr/bin/env python3
"""Writes the verification decks of contact, each with its expectation: contact.py [NAME...]  (default: all)."""
import math
import sys
from pathlib import Path

from deck import Deck
from mesh import Mesh

HERE = Path(__file__).resolve().parent.parent
CASES = {}


def case(function):
    CASES[function.__name__] = function
    return function


class Bodies(Mesh):
    """Bodies that do not share nodes, however close they are."""

    def __init__(self):
        super().__init__()
        self.members = {}  # part -> node ids

    def block(self, part, counts, place):
        """counts = (i, j, k) hexahedra of a part; place(a, b, c) maps grid fractions to x, y, z.
        Returns the ids of its nodes by grid numbers."""
        ni, nj, nk = counts
        ids = {}
        for a in range(ni + 1):
            for b in range(nj + 1):
                for c in range(nk + 1):
                    self.nodes.append(place(a / ni, b / nj, c / nk))
                    ids[a, b, c] = len(self.nodes)
        corner = [(0, 0), (1, 0), (1, 1), (0, 1)]
        for k in range(nk):
            for j in range(nj):
                for i in range(ni):
                    self.element(part, [ids[i + a, j + b, k + c] for c in (0, 1) for a, b in corner])
        self.members.setdefault(part, []).extend(ids.values())
        return ids


def box(low, size):
    return lambda a, b, c: tuple(l + s * f for l, s, f in zip(low, size, (a, b, c)))


def start(name, title, case, source, end, step=0.9, interval=None):
    deck = Deck(name, title)
    deck.says("case", case)
    deck.says("source", source)
    deck.card("CONTROL_TERMINATION", [end])
    deck.card("CONTROL_TIMESTEP", [0.0, step])
    deck.card("CONTROL_ENERGY", [2, 2, 2, 2])
    for file in ("GLSTAT", "MATSUM", "RCFORC", "SLEOUT"):
        deck.card("DATABASE_" + file, [interval or end / 200])
    return deck


def material(deck, number, density, young, poisson, form=1, hourglass=None):
    deck.card("MAT_ELASTIC", [number, density, young, poisson])
    deck.card("SECTION_SOLID", [number, form])
    if hourglass:
        deck.card("HOURGLASS", [number, hourglass, 0.1])
    deck.part(number, number, number, 0, number if hourglass else 0)


def velocity(deck, nodes, v):
    deck.card("INITIAL_VELOCITY", [deck.node_set(nodes)], list(v))


METHODS = {"nodes": 0, "soft": 1, "segments": 2}


def contact(deck, kind, soft, friction=0.0, damping=0.0, a=1, b=2, types=(3, 3), ignore=None, scale=1.0, decay=0.0,
            dynamic=None):
    deck.card("CONTACT_" + kind, [a, b, types[0], types[1]],
              [friction, friction if dynamic is None else dynamic, decay, 0.0, damping, 0, 0.0, 1.0e20], [scale, scale],
              *([[1, 1, 1]] if "ERODING" in kind else []),
              [soft, 0.1], *([[0.0], [0, ignore]] if ignore is not None else []))


# --- D: two equal bars: they exchange their velocities ---------------------------------------------------------

def bars(name):
    soft = METHODS[name]
    end = 600e-6
    deck = start(f"contact_bars_{name}", "Two equal bars collide", f"two equal elastic bars collide, SOFT {soft}",
                 "closed form: full exchange of velocity, rho c v / 2 = 200 MPa, contact for 2 L / c = 400 us", end,
                 interval=1e-6)
    deck.says("expect", "x_rigid_body_velocity part=1  0.0  abs=0.1 (order: 1 % of the speed)")
    deck.says("expect", "x_rigid_body_velocity part=2  10.0  abs=0.1 (order: 1 % of the speed)")
    deck.says("expect", "x_force contact=1 time=200e-6  -2.0e4  rel=0.02 (order: 200 MPa on 1 cm2)")
    deck.says("expect", "x_force contact=1 time=380e-6  -2.0e4  rel=0.05 (order)")
    deck.says("expect", "x_force contact=1 time=430e-6  0.0  abs=1.0e2 (order: contact ends at 400 us)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("expect", "x_momentum range 0.0 abs=1e-13 (roundoff)")
    deck.says("vary", "threads=1,2,3,7 restart=no,37")
    material(deck, 1, 8000.0, 200.0e9, 0.0)
    material(deck, 2, 8000.0, 200.0e9, 0.0)
    mesh = Bodies()
    # Unlike meshes across: nodes of one side are not opposite nodes of the other.
    mesh.block(1, (60, 2, 2), box((-1.0, 0.0, 0.0), (1.0, 0.01, 0.01)))
    mesh.block(2, (60, 3, 3), box((0.0, 0.0, 0.0), (1.0, 0.01, 0.01)))
    velocity(deck, mesh.members[1], (10.0, 0.0, 0.0))
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", soft)
    deck.mesh(mesh)
    return deck


for _name in METHODS:
    CASES["bars_" + _name] = lambda name=_name: bars(name)


if __name__ == "__main__":
    for name in sys.argv[1:] or CASES:
        written = CASES[name]()
        (HERE / (written.name + ".k")).write_text(written.text().replace("make.py", "contact.py"))
        print(written.name)
