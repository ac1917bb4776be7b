#!/usr/bin/env python3
"""Writes the verification decks of contact, each with its expectation: contact.py [NAME...]  (default: all)."""
import math
import sys
from pathlib import Path
from random import Random

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

def velocities_exchanged(deck):
    deck.says("expect", "x_rigid_body_velocity part=1  0.0  abs=0.1 (order: 1 % of the speed)")
    deck.says("expect", "x_rigid_body_velocity part=2  10.0  abs=0.1 (order: 1 % of the speed)")


def bars(name, damping=0.0):
    soft = METHODS[name]
    end = 600e-6
    damped = f", VDC {damping:g}" if damping else ""
    deck = start(f"contact_bars_{name}{'_damped' if damping else ''}", "Two equal bars collide",
                 f"two equal elastic bars collide, SOFT {soft}{damped}",
                 "closed form: full exchange of velocity, rho c v / 2 = 200 MPa, contact for 2 L / c = 400 us", end,
                 interval=1e-6)
    velocities_exchanged(deck)
    # The springs of SOFT 1 are about as stiff as the elements: the two end faces swing on them at a frequency above
    # the highest that the mesh carries away. A little damping ends that.
    rel, ends = {"nodes": (0.02, 460), "soft": (0.02 if damping else 0.25, 430), "segments": (0.02, 430)}[name]
    deck.says("expect", f"x_force contact=1 time=200e-6  -2.0e4  rel={rel} (order: 200 MPa on 1 cm2)")
    deck.says("expect", f"x_force contact=1 time=380e-6  -2.0e4  rel={max(rel, 0.05)} (order)")
    deck.says("expect", f"x_force contact=1 time={ends}e-6  0.0  abs=1.0e2 (order: contact ends at 400 us)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("expect", "x_momentum range 0.0 abs=1e-12 (roundoff)")
    deck.says("vary", "threads=1,2,3,7 restart=no,37")
    material(deck, 1, 8000.0, 200.0e9, 0.0)
    material(deck, 2, 8000.0, 200.0e9, 0.0)
    mesh = Bodies()
    # Unlike meshes across: nodes of one side are not opposite nodes of the other.
    mesh.block(1, (60, 2, 2), box((-1.0, 0.0, 0.0), (1.0, 0.01, 0.01)))
    mesh.block(2, (60, 3, 3), box((0.0, 0.0, 0.0), (1.0, 0.01, 0.01)))
    velocity(deck, mesh.members[1], (10.0, 0.0, 0.0))
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", soft, damping=damping)
    deck.mesh(mesh)
    return deck


for _name in METHODS:
    CASES["bars_" + _name] = lambda name=_name: bars(name)
CASES["bars_soft_damped"] = lambda: bars("soft", 10.0)


# --- far apart at first, and fast ------------------------------------------------------------------------------

@case
def fast():
    """Bars that start 30 elements apart, at a tenth of the speed of sound; the deck asks for a sort every 1000 cycles."""
    end = 20e-3
    deck = start("contact_fast", "Bars meet long before the next sort", "two bars meet at c/10; BSORT asks for a sort "
                 "every 1000 cycles, they meet after 330", "closed form: full exchange of velocity", end)
    deck.says("expect", "x_rigid_body_velocity part=1  0.0  abs=0.2 (order: 2 % of the speed, strains of 5 %)")
    deck.says("expect", "x_rigid_body_velocity part=2  10.0  abs=0.2 (order)")
    deck.says("expect", "x_momentum range 0.0 abs=1e-12 (roundoff)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("vary", "threads=1,2 restart=no,300")
    material(deck, 1, 1.0, 1.0e4, 0.0)
    material(deck, 2, 1.0, 1.0e4, 0.0)
    mesh = Bodies()
    mesh.block(1, (20, 2, 2), box((-0.2, 0.0, 0.0), (0.2, 0.03, 0.03)))
    mesh.block(2, (20, 3, 3), box((0.1, 0.0, 0.0), (0.2, 0.03, 0.03)))
    velocity(deck, mesh.members[1], (10.0, 0.0, 0.0))
    deck.card("CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", [1, 2, 3, 3], [0.0, 0.0, 0.0, 0.0, 0.0, 0, 0.0, 1.0e20],
              [1.0, 1.0], [2, 0.1, 0, 1.025, 2, 2, 1000])
    deck.mesh(mesh)
    return deck


# --- one way, tools of forming ---------------------------------------------------------------------------------

@case
def forming():
    """A punch presses a pad into a die, both one-way: only the pad's nodes look."""
    end, depth = 1.0, 0.01
    deck = start("contact_forming", "A pad between punch and die", "a pad (nu = 0) pressed between two tools, "
                 "FORMING_ONE_WAY, nodes of the pad against faces of the tools",
                 "exact: the pad and both layers of springs share the way: stress E A / L in series with k per area", end)
    young, height, n = 1000.0, 0.5, 5
    material(deck, 1, 1.0, young, 0.0, form=2)
    for tool in (2, 3):
        material(deck, tool, 1.0, 100 * young, 0.0, form=2)
    mesh = Bodies()
    pad = mesh.block(1, (n, n, 4), box((0.0, 0.0, 0.0), (1.0, 1.0, height)))
    die = mesh.block(2, (2, 2, 1), box((-0.2, -0.2, -0.3), (1.4, 1.4, 0.3)))
    punch = mesh.block(3, (3, 3, 1), box((-0.2, -0.2, height), (1.4, 1.4, 0.3)))
    # k of a node: f SLSFAC K A^2 / V of the softest face around it; at the edges that is one of the sides.
    h = height / 4
    spring = 0.1 * (young / 3) * ((n - 1) ** 2 / n ** 2 / h + 4 * n * h)
    force = depth / (height / young + 2.0 / spring)
    deck.says("expect", f"z_force contact=1  {force:.5g}  rel=0.01 (order: the middle is pressed a little more than the "
              "edges)")
    deck.says("expect", f"z_force contact=2  {-force:.5g}  rel=0.01 (order)")
    deck.says("expect", "touches contact=1  36  abs=0 (exact: each node of the pad once)")
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(list(die.values())), 0, 1, 1, 1])
    moved = deck.node_set(list(punch.values()))
    deck.card("BOUNDARY_SPC_SET", [moved, 0, 1, 1, 0])
    deck.curve(1, [(0.0, 0.0), (0.25, -0.5 * depth), (0.5, -depth), (100.0, -depth)])
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [moved, 3, 2, 1, 1.0])
    deck.card("DAMPING_GLOBAL", [0, 60.0])
    contact(deck, "FORMING_ONE_WAY_SURFACE_TO_SURFACE", 0, a=1, b=2)
    contact(deck, "FORMING_ONE_WAY_SURFACE_TO_SURFACE", 0, a=1, b=3)
    deck.mesh(mesh)
    return deck


# --- surfaces that erode ---------------------------------------------------------------------------------------

def erode(name):
    """A hard block goes through the middle of a free plate, layer by layer."""
    soft, end = METHODS[name], 0.4
    deck = start(f"contact_erode_{name}", "A block through a plate", f"a block shot through a free plate, layer after "
                 f"layer is deleted, SOFT {soft}", "conservation of momentum, energy and mass", end)
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("expect", "z_momentum time=0.05  -823.08  abs=1e-9 (roundoff: before the first element is deleted)")
    deck.says("expect", "normal_energy id=1 file=sleout min  0.0  abs=30 (order: contact creates less than 0.5 %)")
    deck.says("expect", "penetration contact=1 max  0.0  abs=0.5 (model: less than half an element)")
    deck.says("vary", "threads=1,3 restart=no,97")
    deck.card("MAT_PLASTIC_KINEMATIC", [1, 1.0, 1.0e4, 0.3, 100.0, 0.0, 1.0], [0.0, 0.0, 0.3, 0.0])
    deck.card("SECTION_SOLID", [1, 1])
    deck.card("HOURGLASS", [1, 5, 0.05])
    deck.part(1, 1, 1, 0, 1)
    material(deck, 2, 1.0, 3.0e4, 0.3, hourglass=5)
    mesh = Bodies()
    mesh.block(1, (10, 10, 3), box((-5.0, -5.0, 0.0), (10.0, 10.0, 3.0)))
    mesh.block(2, (4, 4, 4), turned(20.0, (-1.9, -1.9, 3.05), (3.8, 3.8, 3.8)))
    velocity(deck, mesh.members[2], (0.0, 0.0, -15.0))
    contact(deck, "ERODING_SURFACE_TO_SURFACE", soft, a=2, b=1)
    deck.mesh(mesh)
    return deck


def erode_bars(name, single=False):
    """A bar crushes the weak layer on the end of another; the end that this bares takes the blow."""
    soft, end, layer = METHODS[name], 1.2e-3, 0.004
    deck = start(f"contact_erode_bars_{'single' if single else name}", "Two equal bars collide behind a weak layer",
                 f"a bar meets the face of an equal bar that is bared when a weak layer is deleted, SOFT {soft}",
                 "closed form: full exchange of velocity, rho c v / 2 = 200 MPa, contact for 2 L / c = 400 us", end,
                 interval=1e-6)
    velocities_exchanged(deck)
    rel = {"nodes": 0.02, "soft": 0.05, "segments": 0.02}[name]
    # The layer is gone, and the gap closed, after 0.4 ms.
    deck.says("expect", f"x_force contact=1 time=600e-6  -2.0e4  rel={rel} (order: 200 MPa on 1 cm2)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("expect", "summary eroded_elements  9  abs=0 (exact: the layer)")
    deck.says("vary", "threads=1,3 restart=no,401")
    material(deck, 1, 8000.0, 200.0e9, 0.0)
    material(deck, 2, 8000.0, 200.0e9, 0.0)
    deck.card("MAT_PLASTIC_KINEMATIC", [3, 80.0, 2.0e9, 0.0, 1.0e6, 0.0, 1.0], [0.0, 0.0, 0.1, 0.0])
    deck.card("SECTION_SOLID", [3, 1])
    deck.part(3, 3, 3)
    mesh = Bodies()
    mesh.block(1, (60, 2, 2), box((-1.0 - layer, 0.0, 0.0), (1.0, 0.01, 0.01)))
    grid = mesh.block(2, (61, 3, 3), lambda a, b, c: (a * 61 / 60 - 1 / 60 if a > 0 else -layer, 0.01 * b, 0.01 * c))
    first = {grid[0, j, k] for j in range(4) for k in range(4)}
    mesh.elements = [(3 if first & set(nodes) else part, nodes) for part, nodes in mesh.elements]
    velocity(deck, mesh.members[1], (10.0, 0.0, 0.0))
    deck.card("SET_PART_LIST", [1], [2, 3])
    if single:
        contact(deck, "ERODING_SINGLE_SURFACE", soft, a=0, b=0, types=(5, 0))
    else:
        contact(deck, "ERODING_SURFACE_TO_SURFACE", soft, a=1, b=1, types=(3, 2), damping=10.0 if name == "soft" else 0.0)
    deck.mesh(mesh)
    return deck


for _name in METHODS:
    CASES["erode_" + _name] = lambda name=_name: erode(name)
    CASES["erode_bars_" + _name] = lambda name=_name: erode_bars(name)
CASES["erode_bars_single"] = lambda: erode_bars("segments", True)


# --- friction --------------------------------------------------------------------------------------------------

def block_on_plate(deck, length=0.2, plate=1.2):
    """A block on a plate that is held: 1000 kg/m3, waves at 100 m/s."""
    material(deck, 1, 1000.0, 1.0e7, 0.0, hourglass=6)
    material(deck, 2, 1000.0, 1.0e7, 0.0, hourglass=6)
    mesh = Bodies()
    grid = mesh.block(1, (4, 2, 2), box((0.023, 0.05, 0.0), (length, 0.1, 0.1)))
    mesh.block(2, (24, 4, 1), box((0.0, 0.0, -0.05), (plate, 0.2, 0.05)))
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.members[2]), 0, 1, 1, 1])
    return mesh, grid


def gravity(deck, down, along, ramp=0.0):
    for number, (axis, value) in enumerate((("Z", down), ("X", along)), 1):
        if value:
            # The base accelerates the other way.
            deck.curve(number, [(0.0, 0.0 if ramp else 1.0), (ramp, 1.0), (100.0, 1.0)] if ramp
                       else [(0.0, 1.0), (10000.0, 1.0)])
            deck.card("LOAD_BODY_" + axis, [number, -value])


def slide(name):
    soft, end = METHODS[name], 0.8
    deck = start(f"contact_slide_{name}", "A block slides to rest", f"block slides to rest under friction, SOFT {soft}",
                 "Coulomb: v^2 / (2 mu g) = 2/3 m, and all kinetic energy becomes friction: 4 J", end)
    mesh, grid = block_on_plate(deck)
    middle = grid[2, 1, 1]
    deck.says("expect", f"x_displacement node={middle}  0.66667  rel=0.01 (order: the start, when gravity sets in)")
    deck.says("expect", "friction_energy id=1 file=sleout  4.0  rel=0.01 (order)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.card("DATABASE_NODOUT", [end / 50])
    deck.card("DATABASE_HISTORY_NODE", [middle])
    velocity(deck, mesh.members[1], (2.0, 0.0, 0.0))
    gravity(deck, -10.0, 0.0)
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", soft, friction=0.3, damping=20.0)
    deck.mesh(mesh)
    return deck


def incline(name, friction, travel):
    soft, end = METHODS[name], 0.6
    what = "sticks" if travel == 0.0 else "slides"
    deck = start(f"contact_incline_{name}_{what}", "A block on an incline", f"block {what} on an incline, SOFT {soft}",
                 f"Coulomb: tan = 0.3, friction {friction}", end)
    mesh, grid = block_on_plate(deck)
    middle = grid[2, 1, 1]
    if travel == 0.0:
        deck.says("expect", f"x_displacement node={middle}  0.0  abs=2e-4 (order: of the springs that hold it)")
    else:
        deck.says("expect", f"x_displacement node={middle}  {travel}  rel=0.01 (order)")
    deck.card("DATABASE_NODOUT", [end / 50])
    deck.card("DATABASE_HISTORY_NODE", [middle])
    gravity(deck, -10.0, 3.0, 0.1)
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", soft, friction=friction, damping=20.0)
    deck.mesh(mesh)
    return deck


def travel_on_incline(pull, down, friction, ramp, end):
    """Both grow linearly over the ramp: constant ratio, so the block slides from the start."""
    a = pull - friction * down
    return a * (ramp * ramp / 6.0 + ramp / 2.0 * (end - ramp) + (end - ramp) ** 2 / 2.0)


for _name in METHODS:
    CASES["slide_" + _name] = lambda name=_name: slide(name)
    CASES["incline_sticks_" + _name] = lambda name=_name: incline(name, 0.33, 0.0)
    CASES["incline_slides_" + _name] = lambda name=_name: incline(
        name, 0.2, round(travel_on_incline(3.0, 10.0, 0.2, 0.1, 0.6), 6))


# --- A03: constant pressure through unlike meshes --------------------------------------------------------------

def turned(angle, low, size):
    place = box(low, size)
    c, s = math.cos(math.radians(angle)), math.sin(math.radians(angle))

    def at(*g):
        x, y, z = place(*g)
        return (c * x - s * y, s * x + c * y, z)
    return at


def patch(angle):
    """The lower block is held, so that its surface stays plane; the upper one carries the pressure."""
    end = 1.0
    deck = start(f"contact_patch_{angle}", "Contact patch test",
                 f"constant pressure through unlike meshes, turned by {angle} degrees, SOFT 2",
                 "exact: stress -1 everywhere; catalogue A03 with a plane lower surface", end)
    material(deck, 1, 1.0, 1000.0, 0.0, form=2)
    material(deck, 2, 1.0, 1000.0, 0.0, form=2)
    mesh = Bodies()
    top = mesh.block(1, (3, 3, 2), turned(angle, (-0.5, -0.5, 0.0), (1.0, 1.0, 0.5)))
    mesh.block(2, (5, 5, 2), box((-0.8, -0.8, -0.5), (1.6, 1.6, 0.5)))
    for e in range(1, 19):
        deck.says("expect", f"stress_zz element={e}  -1.0  abs=1e-6 (order: still settling)")
    deck.says("expect", "z_force contact=1  1.0  abs=1e-6 (order: still settling)")
    deck.card("DATABASE_ELOUT", [end / 10])
    deck.card("DATABASE_HISTORY_SOLID", *[list(range(e, min(e + 8, 19))) for e in range(1, 19, 8)])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(mesh.members[2]), 0, 1, 1, 1])
    # Nothing else holds the upper block against drifting along the surface; nothing pushes it either.
    deck.curve(1, [(0.0, 1.0), (100.0, 1.0)])
    deck.card("LOAD_SEGMENT_SET", [deck.segment_set(
        [[top[i, j, 2], top[i + 1, j, 2], top[i + 1, j + 1, 2], top[i, j + 1, 2]] for i in range(3) for j in range(3)]),
        1, 1.0])
    deck.card("DAMPING_GLOBAL", [0, 60.0])
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", 2)
    deck.mesh(mesh)
    return deck


for _angle in (0, 15):
    CASES[f"patch_{_angle}"] = lambda angle=_angle: patch(angle)


# --- one part against itself -----------------------------------------------------------------------------------

def fold(name):
    """A fork whose prongs clap together."""
    soft, end = METHODS[name], 0.06
    deck = start(f"contact_fold_{name}", "A fork claps", f"prongs of one part meet, single surface, SOFT {soft}",
                 "conservation of energy and momentum; the prongs do not pass each other", end)
    material(deck, 1, 1000.0, 1.0e7, 0.3, hourglass=6)
    mesh = Mesh()
    # Cells of 1 cm: a base of 2 x 7, prongs of 10 x 2 at both ends, 2 deep.
    for cell in ([(i, j) for i in range(2) for j in range(7)] + [(i, j) for i in range(2, 12) for j in (0, 1, 5, 6)]):
        for k in range(2):
            at = [(cell[0] + a, cell[1] + b, k + c) for c in (0, 1) for a, b in [(0, 0), (1, 0), (1, 1), (0, 1)]]
            mesh.element(1, [mesh.node(*(0.01 * v for v in p)) for p in at])
    lower = mesh.where(lambda x, y, z: x > 0.0201 and y < 0.0201)
    upper = mesh.where(lambda x, y, z: x > 0.0201 and y > 0.0499)
    tips = mesh.where(lambda x, y, z: abs(x - 0.12) < 1e-9 and z < 1e-9 and abs(abs(y - 0.035) - 0.015) < 1e-9)
    velocity(deck, lower, (0.0, 1.5, 0.0))
    velocity(deck, upper, (0.0, -1.5, 0.0))
    deck.card("DATABASE_NODOUT", [end / 200])
    deck.card("DATABASE_HISTORY_NODE", tips)
    low, high = sorted(tips, key=lambda n: mesh.nodes[n - 1][1])
    deep = 0.001 if name == "segments" else 0.003  # springs of SOFT 0 and 1 give way by a quarter element
    deck.says("expect", f"y_displacement node={low} max  0.015  abs={deep} (order: they meet half way)")
    deck.says("expect", f"y_displacement node={high} min  -0.015  abs={deep} (order)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("expect", "y_momentum range 0.0 abs=1e-13 (roundoff)")
    deck.says("expect", "touches contact=1 max  40  abs=39 (model: any number but none)")
    deck.says("vary", "threads=1,3 restart=no,101")
    contact(deck, "AUTOMATIC_SINGLE_SURFACE", soft, a=0, b=0, types=(5, 0))
    deck.mesh(mesh)
    return deck


for _name in METHODS:
    CASES["fold_" + _name] = lambda name=_name: fold(name)



@case
def crush():
    """A zigzag strip folds up on itself."""
    end, folds, arm, n = 1.0, 4, 10, 10
    deck = start("contact_crush", "A strip folds up", "an elastoplastic zigzag strip pushed together until its folds lie "
                 "on each other, single surface, SOFT 2", "energy; layers do not pass each other", end)
    deck.says("expect", "energy_ratio  1.0 abs=0.01 (order)")
    deck.says("expect", "normal_energy id=1 file=sleout min  0.0  abs=1.0 (order: contact creates none)")
    deck.says("expect", "penetration contact=1 max  0.0  abs=0.2 (model: a fifth of an element, of faces at the root of a fold)")
    deck.says("expect", "touches contact=1 max  300  abs=250 (model: many, once the folds meet)")
    deck.says("vary", "threads=1,3 restart=no,1001")
    deck.card("MAT_PLASTIC_KINEMATIC", [1, 1.0, 1.0e4, 0.3, 50.0, 100.0, 1.0], [0.0])
    deck.card("SECTION_SOLID", [1, 1])
    deck.card("HOURGLASS", [1, 5, 0.1])
    deck.part(1, 1, 1, 0, 1)
    mesh = Bodies()
    slope, thick = math.radians(45.0), 2.0

    def place(a, b, c):
        # Along the strip up and down by turns; across it in z, so that the folds join without a step.
        s = a * folds
        leg = min(int(s), folds - 1)
        t = s - leg
        x = (leg + t) * arm * math.sin(slope)
        z = arm * math.cos(slope) * (t if leg % 2 == 0 else 1.0 - t)
        return (x, 3.0 * b, z + (c - 0.5) * thick / math.sin(slope))

    grid = mesh.block(1, (folds * n, 3, 2), place)
    for end_of, sign in ((0, 1.0), (folds * n, -1.0)):
        held = deck.node_set([v for k, v in grid.items() if k[0] == end_of])
        deck.curve(int(1 + (sign < 0)), [(0.0, 0.0), (0.1, sign * 12.0), (100.0, sign * 12.0)])
        deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [held, 1, 0, int(1 + (sign < 0)), 1.0])
    contact(deck, "AUTOMATIC_SINGLE_SURFACE", 2, a=0, b=0, types=(5, 0), damping=10.0)
    deck.mesh(mesh)
    return deck


# --- E06: a ball that bounces ----------------------------------------------------------------------------------

def cube_to_ball(radius, low):
    """Maps a cube onto a ball so that no cell gets flat."""
    def at(a, b, c):
        u, v, w = 2 * a - 1, 2 * b - 1, 2 * c - 1
        most, size = max(map(abs, (u, v, w))), math.sqrt(u * u + v * v + w * w) or 1.0
        bend = most ** 2  # the outer layers are round, the core is square
        f = radius * ((1 - bend) * 0.62 + bend * most / size)
        return (f * u, f * v, low + radius + f * w)
    return at


def bounce(name):
    soft, end = METHODS[name], 8.6
    deck = start(f"contact_bounce_{name}", "A ball bounces", f"a ball bounces 20 times on a block, no damping, SOFT {soft}",
                 "catalogue E06: the energy drifts by less than 2 %", end)
    deck.says("expect", "energy_ratio range 0.0 abs=0.02 (order: catalogue E06)")
    # Of 2.4 in all. SOFT 1 changes its stiffness with the place on the face.
    most = 0.047 if name == "soft" else 0.012
    deck.says("expect", f"normal_energy id=1 file=sleout min  0.0  abs={most} (order: contact creates at most that)")
    flight = {"nodes": 8.3, "soft": 8.04, "segments": 8.2}[name]
    deck.says("expect", f"normal_energy id=1 file=sleout time={flight}  0.0  abs={most} (order: in flight nothing is left "
              "in it)")
    deck.says("expect", "normal_energy id=1 file=sleout max  5.0  abs=3.0 (model: in the middle of a bounce)")
    material(deck, 1, 1.0, 1.0e4, 0.3, hourglass=5)
    material(deck, 2, 1.0, 1.0e4, 0.3, hourglass=5)
    mesh = Bodies()
    mesh.block(1, (6, 6, 6), cube_to_ball(1.0, 0.01))
    floor = mesh.block(2, (7, 7, 1), box((-1.0, -1.0, -0.3), (2.0, 2.0, 0.3)))
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(list(floor.values())), 0, 1, 1, 1])
    velocity(deck, mesh.members[1], (0.0, 0.0, -1.0))
    gravity(deck, -10.0, 0.0)
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", soft, a=1, b=2)
    deck.mesh(mesh)
    return deck


for _name in METHODS:
    CASES["bounce_" + _name] = lambda name=_name: bounce(name)


# --- many bodies in a box --------------------------------------------------------------------------------------

def rotation(random):
    """A random rotation, from a unit quaternion."""
    while True:
        q = [random.uniform(-1, 1) for _ in range(4)]
        n = math.sqrt(sum(c * c for c in q))
        if 0.1 < n < 1.0:
            break
    w, x, y, z = (c / n for c in q)
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]]


def box_of_bodies(name, soft, across, layers, end, friction=0.2, damping=10.0, cycles=0, interval=None, rim=0.0):
    """across^2 x layers random convex bodies of 2 x 2 x 2 elements, every other one rigid, that have fallen 0.2 m when
    they reach a rigid box, whose walls are `rim` higher than a layer above them. Millimetres, kilograms, milliseconds:
    GPa, kN, J."""
    random = Random(20)
    count, cell, speed = across * across * layers, 38.0, math.sqrt(2 * 9.81 * 0.2)
    deck = start(name, f"{count} bodies in a box",
                 f"{count} random convex bodies, elastic (E = 2 GPa) and rigid (steel) by turns, dropped into a box from "
                 f"0.2 m, single surface, SOFT {soft}, friction {friction:g}, VDC {damping:g}",
                 "no body leaves, nothing goes deeper than 5 % of an element, the energy "
                 "never grows", end, interval=interval)
    deck.lines[1] = f"{end:10g}{cycles:10d}"
    material(deck, 1, 1.1e-6, 2.0, 0.35, hourglass=5)

    def rigid(part, hold=(0.0, 0, 0)):
        # Parts with one rigid material would be one body.
        deck.card("MAT_RIGID", [part, 7.8e-6, 210.0, 0.3], list(hold), [0.0] * 6)
        deck.part(part, 1, part)

    mesh, volume, bodies = Bodies(), 0.0, []
    for place in range(count):
        centre = [cell * (place % across + 0.5), cell * (place // across % across + 0.5),
                  cell * (place // across ** 2 + 0.5)]
        turn, size = rotation(random), [random.uniform(14.0, 20.0) for _ in range(3)]
        skew = [random.uniform(-3.0, 3.0) for _ in range(3)]
        taper = random.uniform(0.8, 1.0)
        volume += size[0] * size[1] * size[2] * (1.0 + taper + taper ** 2) / 3.0

        def put(a, b, c):
            f = taper + (1 - taper) * (1 - c)  # narrower above
            u = [size[0] * f * (a - 0.5) + skew[0] * (b - 0.5), size[1] * f * (b - 0.5) + skew[1] * (c - 0.5),
                 size[2] * (c - 0.5) + skew[2] * (a - 0.5)]
            return tuple(m + sum(r * v for r, v in zip(row, u)) for m, row in zip(centre, turn))

        part = 1 if place % 2 == 0 else 2 + place // 2
        mesh.block(part, (2, 2, 2), put)
        if part > 1:
            rigid(part)
            bodies.append(part)
    # A floor and four walls, each of its own nodes, one rigid body that is held.
    held, wide, tall, thick = 2 + count // 2, cell * across, cell * (layers + 1) + rim, 10.0
    rigid(held, (1.0, 7, 7))
    n = 2 * across
    mesh.block(held, (n, n, 1), box((-thick, -thick, -thick), (wide + 2 * thick, wide + 2 * thick, thick)))
    for low, size, counts in (((-thick, 0.0, 0.0), (thick, wide, tall), (1, n, n)),
                              ((wide, 0.0, 0.0), (thick, wide, tall), (1, n, n)),
                              ((-thick, -thick, 0.0), (wide + 2 * thick, thick, tall), (n, 1, n)),
                              ((-thick, wide, 0.0), (wide + 2 * thick, thick, tall), (n, 1, n))):
        mesh.block(held, counts, box(low, size))
    deep = 0.05 * (volume / (8 * count)) ** (1.0 / 3.0)
    deck.says("expect", f"penetration contact=1 max  0.0  abs={deep:.4f} (model: 5 % of the mean element size)")
    deck.says("expect", "energy_ratio max 1.0 abs=0.01 (order: never grows)")
    deck.says("expect", "friction_energy id=1 file=sleout min  0.0  abs=1e-9 (order: friction only takes)")
    for place, part in enumerate([1] + bodies):
        for axis, (low, high) in enumerate(((0.0, wide), (0.0, wide), (0.0, tall))):
            for end_of in ("low", "high"):
                deck.says("expect", f"summary parts.{place}.final.{end_of}.{axis}  {0.5 * (low + high):g}  "
                          f"abs={0.5 * (high - low) + deep:.6g} (model: in the box)")
    deck.says("vary", "threads=1,2")
    velocity(deck, mesh.members[1], (0.0, 0.0, -speed))
    for part in bodies:
        deck.card("INITIAL_VELOCITY_RIGID_BODY", [part, 0.0, 0.0, -speed, 0.0, 0.0, 0.0])
    gravity(deck, -9.81e-3, 0.0)
    contact(deck, "AUTOMATIC_SINGLE_SURFACE", soft, friction=friction, damping=damping, a=0, b=0, types=(5, 0))
    deck.mesh(mesh)
    return deck


CASES["box"] = lambda: box_of_bodies("contact_box", 2, 3, 3, 20.0)


def torture(soft=2):
    """The whole of it: 500 bodies, 200,000 cycles; half an hour or so. Not among the decks that are tested. Light bodies
    that heavy ones strike leap higher than they fell."""
    return box_of_bodies(f"contact_torture_{soft}", soft, 10, 5, 900.0, cycles=200000, interval=0.5, rim=400.0)



# --- ties ------------------------------------------------------------------------------------------------------

def tied_patch(name):
    """Two blocks with unlike meshes, tied and pulled."""
    kind, error = {"nodes": ("TIED_SURFACE_TO_SURFACE", 0.08), "springs": ("TIED_SURFACE_TO_SURFACE_OFFSET", 1e-6)}[name]
    end = 1.0
    deck = start(f"contact_tied_patch_{name}", "Tied patch test", f"constant stress through a tie of unlike meshes, {kind}",
                 "exact: stress 1 everywhere", end)
    material(deck, 1, 1.0, 1000.0, 0.0, form=2)
    material(deck, 2, 1.0, 1000.0, 0.0, form=2)
    mesh = Bodies()
    top = mesh.block(1, (5, 5, 2), box((0.0, 0.0, 0.5), (1.0, 1.0, 0.5)))
    low = mesh.block(2, (3, 3, 2), box((0.0, 0.0, 0.0), (1.0, 1.0, 0.5)))
    why = "model: nodes tied at points do not share forces as the stress does" if name == "nodes" else "order: settling"
    for e in list(range(1, 51, 7)) + list(range(51, 69)):
        deck.says("expect", f"stress_zz element={e}  1.0  abs={error} ({why})")
    deck.card("DATABASE_ELOUT", [end / 10])
    deck.card("DATABASE_HISTORY_SOLID", *[list(range(e, min(e + 8, 69))) for e in range(1, 69, 8)])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set([low[i, j, 0] for i in range(4) for j in range(4)]), 0, 0, 0, 1])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set([low[0, 0, 0]]), 0, 1, 1, 0])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set([low[3, 0, 0]]), 0, 0, 1, 0])
    deck.curve(1, [(0.0, 1.0), (100.0, 1.0)])
    deck.card("LOAD_SEGMENT_SET", [deck.segment_set(
        [[top[i, j, 2], top[i + 1, j, 2], top[i + 1, j + 1, 2], top[i, j + 1, 2]] for i in range(5) for j in range(5)]),
        1, -1.0])
    deck.card("DAMPING_GLOBAL", [0, 50.0])
    contact(deck, kind, 0)
    deck.mesh(mesh)
    return deck


for _name in ("nodes", "springs"):
    CASES["tied_patch_" + _name] = lambda name=_name: tied_patch(name)


# --- Hertz -----------------------------------------------------------------------------------------------------

def graded(first, fine, factor, to):
    """Places of nodes: equal cells up to `fine`, growing ones up to `to`."""
    places, h = [0.0], first
    while places[-1] < to - 1e-9:
        if places[-1] >= fine - 1e-9:
            h *= factor
        places.append(min(places[-1] + h, to) if to - places[-1] - h > 0.5 * h else to)
    return places


@case
def hertz():
    radius, depth, young, poisson, end = 10.0, 0.1, 1000.0, 0.3, 0.6
    a = math.sqrt(radius * depth)
    force = 4.0 / 3.0 * young / (1 - poisson ** 2) * math.sqrt(radius) * depth ** 1.5 / 4.0
    deck = start("contact_hertz", "Hertz", "a rigid sphere pressed into an elastic block (a quarter), SOFT 2",
                 f"Hertz 1882: force 4/3 E* sqrt(R) d^1.5 at depth d, radius of contact {a:g}", end, step=0.9)
    deck.says("expect", f"z_force contact=1  {force:.5g}  rel=0.03 (order: mesh and springs; the block is 40 radii wide)")
    deck.says("slow", "")
    material(deck, 1, 1.0e-3, young, poisson)
    material(deck, 2, 1.0e-2, young, poisson)
    mesh = Bodies()
    places = graded(0.15, 1.2, 1.5, 40.0)
    n = len(places) - 1
    block = mesh.block(1, (n, n, n), lambda x, y, z: (places[round(x * n)], places[round(y * n)],
                                                      -places[n - round(z * n)]))
    punch = mesh.block(2, (13, 13, 1), lambda x, y, z: (
        1.69 * x, 1.69 * y, 0.25 * z + radius - math.sqrt(radius ** 2 - (1.69 * x) ** 2 - (1.69 * y) ** 2)))
    side = lambda which: [v for k, v in block.items() if which(*k)]
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(side(lambda i, j, k: i == 0)), 0, 1, 0, 0])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(side(lambda i, j, k: j == 0)), 0, 0, 1, 0])
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(side(lambda i, j, k: k == 0)), 0, 0, 0, 1])
    moved = deck.node_set(list(punch.values()))
    deck.card("BOUNDARY_SPC_SET", [moved, 0, 1, 1, 0])
    # A smooth ramp, then rest.
    deck.curve(1, [(0.5 * end * t / 20.0, -depth * 0.5 * (1 - math.cos(math.pi * t / 20.0))) for t in range(21)] + [(end, -depth)])
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [moved, 3, 2, 1, 1.0])
    deck.card("DAMPING_GLOBAL", [0, 60.0])
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", 2, a=2, b=1, scale=20.0)
    deck.mesh(mesh)
    return deck


if __name__ == "__main__":
    for name in sys.argv[1:] or CASES:
        written = CASES[name]()
        (HERE / (written.name + ".k")).write_text(written.text().replace("make.py", "contact.py"))
        print(written.name)
