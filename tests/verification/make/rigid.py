#!/usr/bin/env python3
"""Writes the verification decks of rigid bodies, each with its expectation: rigid.py [NAME...]  (default: all)."""
import math
import sys
from pathlib import Path

from contact import Bodies, box, contact, velocity
from deck import Deck
from mesh import hexahedron_volume

HERE = Path(__file__).resolve().parent.parent
CASES = {}


def case(function):
    CASES[function.__name__] = function
    return function


def start(name, title, what, source, end, step=None, files=("GLSTAT", "MATSUM", "RBDOUT"), frames=100):
    """step: of the whole run, where nothing deforms."""
    deck = Deck(name, title)
    deck.says("case", what)
    deck.says("source", source)
    deck.card("CONTROL_TERMINATION", [end])
    if step:
        deck.card("CONTROL_TIMESTEP", [0.0, 0.9, 0, 0.0, 0.0, 99])
        deck.curve(99, [(0.0, step), (100.0 * end, step)])
    else:
        deck.card("CONTROL_TIMESTEP", [0.0, 0.9])
    deck.card("CONTROL_ENERGY", [2, 2, 2, 2])
    for file in files:
        deck.card("DATABASE_" + file, [end / frames])
    return deck


def rigid(deck, number, density, young=1.0, poisson=0.3, hold=(0, 0, 0), section=True):
    deck.card("MAT_RIGID", [number, density, young, poisson], list(hold), [0.0] * 6)
    if section:
        deck.card("SECTION_SOLID", [number, 1])


def histories(deck, nodes, interval):
    deck.card("DATABASE_NODOUT", [interval])
    deck.card("DATABASE_HISTORY_NODE", list(nodes))


def rotated(v, axis, angle):
    """Rodrigues' formula, axis of unit length."""
    c, s = math.cos(angle), math.sin(angle)
    along = sum(a * b for a, b in zip(axis, v)) * (1 - c)
    x = (axis[1] * v[2] - axis[2] * v[1], axis[2] * v[0] - axis[0] * v[2], axis[0] * v[1] - axis[1] * v[0])
    return [c * p + s * q + along * a for p, q, a in zip(v, x, axis)]


# --- free flight ------------------------------------------------------------------------------------------------

@case
def rigid_top():
    """A square bar spins about a line that leans from its axis."""
    end, step, size, density = 10.0, 0.002, (1.0, 1.0, 2.0), 3.0
    deck = start("rigid_top", "Free symmetric top", "free symmetric top: precession, momentum, energy",
                 "closed form (Landau & Lifshitz, Mechanics, sec. 33): precession L / A, own rotation (1 / C - 1 / A) L_z",
                 end, step)
    m = density * size[0] * size[1] * size[2]
    a, c = m / 12 * (size[1] ** 2 + size[2] ** 2), m / 12 * (size[0] ** 2 + size[1] ** 2)
    spin, speed = (0.8, 0.0, 1.5), (0.3, -0.2, 0.1)
    momentum = (a * spin[0], 0.0, c * spin[2])
    size_l = math.sqrt(sum(l * l for l in momentum))
    mesh = Bodies()
    grid = mesh.block(1, (2, 2, 4), box((0.0, 0.0, 0.0), size))
    corner = grid[2, 2, 4]
    arm = [0.5 * s for s in size]
    own = rotated(arm, (0.0, 0.0, 1.0), end * momentum[2] * (1 / c - 1 / a))
    turned = rotated(own, [l / size_l for l in momentum], end * size_l / a)
    for axis, now, was, v in zip("xyz", turned, arm, speed):
        deck.says("expect", f"{axis}_displacement node={corner}  {now - was + v * end:.9g}  abs=1e-5 (order: second in the step)")
    for axis, l in zip("xyz", momentum):
        deck.says("expect", f"{axis}_angular_momentum body=1 range  0.0  abs=1e-13 (roundoff)")
        deck.says("expect", f"{axis}_angular_momentum body=1  {l:.12g}  abs=1e-12 (roundoff: integrals over the elements)")
    deck.says("expect", "energy_ratio range  0.0  abs=1e-12 (roundoff)")
    deck.says("vary", "threads=1,2,3,7 restart=no,1234")
    rigid(deck, 1, density)
    deck.part(1, 1, 1)
    deck.card("INITIAL_VELOCITY_RIGID_BODY", [1, *speed, *spin])
    histories(deck, [1, corner], end / 100)
    deck.mesh(mesh)
    return deck


@case
def rigid_tumbling():
    """An L of three different extents spins about its middle axis: it turns over again and again."""
    end, step = 200.0, 0.01
    deck = start("rigid_tumbling", "Free body that tumbles", "free asymmetric body: momentum and energy over 20000 steps",
                 "conservation laws; distance of two nodes as at the start", end, step)
    mesh = Bodies()
    first = mesh.block(1, (3, 1, 1), box((0.0, 0.0, 0.0), (3.0, 1.0, 0.5)))
    second = mesh.block(2, (1, 2, 1), box((0.0, 1.0, 0.0), (1.0, 2.0, 0.7)))
    for axis in "xyz":
        deck.says("expect", f"{axis}_angular_momentum body=1 range  0.0  abs=1e-12 (roundoff)")
        deck.says("expect", f"{axis}_momentum range  0.0  abs=1e-12 (roundoff)")
    deck.says("expect", "energy_ratio range  0.0  abs=1e-11 (roundoff: 20000 steps)")
    deck.says("vary", "threads=1,2,3,7 restart=no,777")
    rigid(deck, 1, 2.0)
    deck.part(1, 1, 1)
    deck.part(2, 1, 1)
    deck.card("CONSTRAINED_RIGID_BODIES", [1, 2])
    deck.card("INITIAL_VELOCITY_GENERATION", [0, 0, 0.8, 0.01, -0.02, 0.005], [1.0, 0.8, 0.25, 0.3, 1.0, 0.1])
    deck.mesh(mesh)
    return deck


# --- forces and motions -----------------------------------------------------------------------------------------

@case
def rigid_pushed():
    """Force at the centre, moment, gravity, and a force on one node."""
    end, step = 2.0, 0.001
    deck = start("rigid_pushed", "Forces on rigid bodies", "F = m a and M = J alpha, by load of body, of node, and gravity",
                 "closed form: uniform acceleration; work done equals kinetic energy", end, step)
    mesh = Bodies()
    bodies = {1: (2.0, 1.0, 1.0), 2: (1.0, 1.0, 1.0), 3: (1.0, 2.0, 3.0)}
    grids = {p: mesh.block(p, (2, 2, 2), box((10.0 * p, 0.0, 0.0), s)) for p, s in bodies.items()}
    mass = {p: 4.0 * s[0] * s[1] * s[2] for p, s in bodies.items()}
    jz = {p: mass[p] / 12 * (s[0] ** 2 + s[1] ** 2) for p, s in bodies.items()}
    half = 0.5 * end * end
    g, force, moment = 2.0, 5.0, 0.3
    deck.says("expect", f"x_displacement body=1  {half * force / mass[1]:.12g}  rel=1e-9 (roundoff: uniform acceleration)")
    deck.says("expect", f"z_rotation body=1  {half * moment / jz[1]:.12g}  rel=1e-9 (roundoff)")
    deck.says("expect", f"z_spin body=1  {end * moment / jz[1]:.12g}  rel=1e-9 (roundoff)")
    # Gravity: the base accelerates the other way. All three fall alike.
    for p in bodies:
        deck.says("expect", f"z_displacement body={p}  {-half * g:.12g}  rel=1e-9 (roundoff)")
    # Two opposite forces on nodes of body 2 at the middle of its edges: a couple about z, arm 1.
    deck.says("expect", f"z_spin body=2  {end * 2 * 0.5 * 0.05 / jz[2]:.12g}  rel=2e-2 (order: the arms turn with the body)")
    deck.says("expect", "x_displacement body=2  0.0  abs=1e-12 (roundoff)")
    # Body 3 is held but for its rotation about x, with a constant moment.
    jx = mass[3] / 12 * (bodies[3][1] ** 2 + bodies[3][2] ** 2)
    deck.says("expect", f"x_rotation body=3  {half * 0.7 / jx:.12g}  rel=1e-9 (roundoff)")
    deck.says("expect", "energy_ratio range  0.0  abs=1e-4 (order: work at nodes is booked by the trapezoidal rule)")
    deck.says("vary", "threads=1,2,3,7 restart=no,500")
    rigid(deck, 1, 4.0)
    rigid(deck, 3, 4.0, hold=(1, 0, 5))
    deck.part(1, 1, 1)
    deck.part(2, 1, 1)
    deck.part(3, 3, 3)
    deck.curve(1, [(0.0, 1.0), (100.0, 1.0)])
    deck.card("LOAD_BODY_Z", [1, g])
    deck.card("LOAD_RIGID_BODY", [1, 1, 1, force], [1, 7, 1, moment], [3, 5, 1, 0.7])
    low, high = grids[2][1, 0, 1], grids[2][1, 2, 1]
    deck.card("LOAD_NODE_POINT", [low, 1, 1, 0.05], [high, 1, 1, -0.05])
    deck.mesh(mesh)
    return deck


@case
def rigid_driven():
    """Rotation as told about z, and a centre that goes round as told: every node is where it must be."""
    end, step, angle, radius = 3.0, 0.004, 5.0, 0.5
    deck = start("rigid_driven", "Rigid body moved as told", "prescribed rotation and translation: positions exact",
                 "closed form: rotation by the curve about the centre; its kinetic energy is the work done", end, step)
    mesh = Bodies()
    grid = mesh.block(1, (3, 2, 2), box((1.0, 2.0, 3.0), (3.0, 2.0, 1.0)))
    grid2 = mesh.block(2, (1, 1, 1), box((10.0, 0.0, 0.0), (2.0, 1.0, 1.0)))
    node = grid[3, 2, 2]
    arm = [1.5, 1.0, 0.5]
    now = rotated(arm, (0.0, 0.0, 1.0), angle)
    go = (2.0, -1.0, 0.7)
    for axis, a, b, d in zip("xyz", now, arm, go):
        deck.says("expect", f"{axis}_displacement node={node}  {a - b + d:.12g}  abs=1e-11 (roundoff)")
    # Body 2: spin of velocity type about its own long axis, which it keeps; the centre follows an acceleration.
    deck.says("expect", "x_rotation body=2  1.5  abs=1e-9 (roundoff: 0.5 for 3)")
    deck.says("expect", "y_displacement body=2  9.0  rel=1e-9 (roundoff: uniform acceleration 2)")
    deck.says("expect", "energy_ratio range  0.0  abs=1e-9 (roundoff: the work of the motions is all that comes in)")
    deck.says("vary", "threads=1,2,3,7 restart=no,100")
    rigid(deck, 1, 1.0)
    deck.part(1, 1, 1)
    deck.part(2, 1, 1)
    # A smooth angle, then its last value for the step beyond the end.
    points = 60
    smooth = lambda t: 0.5 * (1 - math.cos(math.pi * min(t / end, 1.0)))
    deck.curve(1, [(end * i / points, smooth(end * i / points)) for i in range(points + 1)] + [(10 * end, 1.0)])
    deck.curve(2, [(0.0, 1.0), (100.0, 1.0)])
    deck.curve(3, [(0.0, 0.0), (100.0, 0.0)])
    deck.card("BOUNDARY_PRESCRIBED_MOTION_RIGID", [1, 7, 2, 1, angle], [1, 5, 2, 3, 1.0], [1, 6, 2, 3, 1.0],
              *[[1, k + 1, 2, 1, go[k]] for k in range(3)], [2, 5, 0, 2, 0.5], [2, 2, 1, 2, 2.0])
    histories(deck, [node], end / 10)
    deck.mesh(mesh)
    return deck


@case
def rigid_merged():
    """Two boxes and a point mass are one body: parallel axes."""
    end, step = 1.0, 0.01
    deck = start("rigid_merged", "Merged rigid bodies", "merged bodies, an extra node with a mass, a stated inertia",
                 "closed form: sums of masses, moments about the common centre by parallel axes", end, step)
    mesh = Bodies()
    mesh.block(1, (1, 1, 1), box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)))
    mesh.block(2, (2, 1, 1), box((4.0, 0.0, 0.0), (2.0, 1.0, 1.0)))
    mesh.nodes.append((-3.0, 0.5, 0.5))
    extra = len(mesh.nodes)
    stated = mesh.block(3, (1, 1, 1), box((0.0, 20.0, 0.0), (1.0, 1.0, 1.0)))
    # Masses 2, 4 and 1.5 at 0.5, 5 and -3 along x.
    parts = [(2.0, 0.5, (1 + 1) * 2.0 / 12), (4.0, 5.0, (4 + 1) * 4.0 / 12), (1.5, -3.0, 0.0)]
    total = sum(m for m, _, _ in parts)
    centre = sum(m * x for m, x, _ in parts) / total
    jz = sum(j + m * (x - centre) ** 2 for m, x, j in parts)
    spin = 1.3
    deck.says("expect", f"mass body=1  {total:.12g}  rel=1e-12 (roundoff)")
    deck.says("expect", f"x_coordinate body=1 time=0.0  {centre:.12g}  rel=1e-12 (roundoff)")
    deck.says("expect", f"z_angular_momentum body=1  {jz * spin:.12g}  rel=1e-12 (roundoff)")
    deck.says("expect", f"kinetic_energy body=1  {0.5 * jz * spin ** 2:.12g}  rel=1e-12 (roundoff)")
    deck.says("expect", f"z_rotation body=1  {spin * end:.12g}  rel=1e-10 (roundoff: spin about a principal axis)")
    deck.says("expect", "mass part=2  4.0  rel=1e-12 (roundoff)")
    deck.says("expect", "mass body=3  7.0  rel=1e-12 (roundoff)")
    deck.says("expect", "y_angular_momentum body=3  -0.4  rel=1e-12 (roundoff: 2 by -0.2)")
    rigid(deck, 1, 2.0)
    deck.part(1, 1, 1)
    deck.part(2, 1, 1)
    deck.card("PART_INERTIA", "stated", [3, 1, 1], [0.5, 20.5, 0.5, 7.0], [1.0, 0.0, 0.0, 2.0, 0.0, 3.0],
              [0.0, 0.0, 0.0, 0.0, -0.2, 0.0])
    deck.card("ELEMENT_MASS", f"{1:8d}{extra:8d}" + f"{1.5:16.1f}")
    deck.card("CONSTRAINED_RIGID_BODIES", [1, 2])
    deck.card("CONSTRAINED_EXTRA_NODES_NODE", [1, extra])
    deck.card("INITIAL_VELOCITY_RIGID_BODY", [1, 0.0, 0.0, 0.0, 0.0, 0.0, spin])
    deck.mesh(mesh)
    return deck


@case
def rigid_walls():
    """Rigid bodies and planar walls, by penalty: a ball bounces, a box rests, one slides, a wall pushes one."""
    end, step, weight, mu, v = 0.5, 1e-4, 20.0, 0.2, 0.8
    deck = start("rigid_walls", "Rigid bodies on rigid walls", "rigid bodies meet planar rigid walls by penalty (RWPNAL)",
                 "closed form: elastic rebound, weight, v^2 / (2 mu g), exchange of velocity with a wall of equal mass",
                 end, step, files=("GLSTAT", "MATSUM", "RBDOUT", "RWFORC"))
    mesh = Bodies()
    ball(mesh, 1, (0.0, 0.0, 1.2), 1.0, 4)
    size = (1.0, 1.0, 0.5)
    for p in (2, 3, 4):
        mesh.block(p, (2, 2, 2), box((10.0 * p, 0.0, 0.0), size))
    mass = 4.0 * size[0] * size[1] * size[2]
    accel = weight / mass
    for axis, expected in (("z", "2.0  rel=0.01"), ("x", "0.3  abs=1e-12")):
        deck.says("expect", f"{axis}_velocity body=1  {expected} ({'order: the force ends within a step' if axis == 'z' else 'roundoff'})")
    deck.says("expect", "y_spin body=1  0.0  abs=1e-10 (roundoff)")
    deck.says("expect", f"normal_force wall=1  {weight:.6g}  rel=1e-3 (order: it has come to rest)")
    deck.says("expect", "z_velocity body=2  0.0  abs=1e-6 (order)")
    deck.says("expect", f"x_displacement body=3  {v * v / (2 * mu * accel):.9g}  rel=0.005 (order: the springs of friction)")
    deck.says("expect", "x_velocity body=4  2.0  rel=0.01 (order)")
    deck.says("expect", "velocity wall=3  0.0  abs=0.02 (order)")
    deck.says("expect", f"stonewall_energy  {0.5 * mass * v * v:.6g}  rel=0.02 (order: the heat of the sliding box)")
    deck.says("expect", "energy_ratio range  0.0  abs=1e-10 (roundoff: all work is booked)")
    deck.says("vary", "threads=1,2,3,7 restart=no,1234")
    deck.card("CONTROL_CONTACT", [0.1, 1.0], [0])
    rigid(deck, 1, 4.0, 1.0e3)
    for p in (1, 2, 3, 4):
        deck.part(p, 1, 1)
    deck.card("INITIAL_VELOCITY_RIGID_BODY", [1, 0.3, 0.0, -2.0], [3, v])
    deck.curve(1, [(0.0, 1.0), (100.0, 1.0)])
    deck.card("LOAD_RIGID_BODY", [2, 3, 1, -weight], [3, 3, 1, -weight])
    # Near critical damping of the box on its springs, 2 w with w^2 = k / m = 0.1 / (6 dt^2): it comes to rest at once.
    deck.card("DAMPING_PART_MASS", [2, 1, 400.0])
    first = deck.node_set(mesh.members[1] + mesh.members[2])
    second = deck.node_set(mesh.members[3])
    third = deck.node_set(mesh.members[4])
    deck.card("RIGIDWALL_PLANAR_ID", "         1floor", [first], [0.0, 0.0, 0.0, 0.0, 0.0, 1.0])
    deck.card("RIGIDWALL_PLANAR_FINITE_ID", "         2rough", [second], [25.0, -1.0, 0.0, 25.0, -1.0, 1.0, mu],
              [26.0, -1.0, 0.0, 10.0, 3.0])
    deck.card("RIGIDWALL_PLANAR_MOVING_ID", "         3piston", [third], [39.9, 0.0, 0.0, 41.0, 0.0, 0.0], [mass, 2.0])
    deck.mesh(mesh)
    return deck


# --- with bodies that deform -------------------------------------------------------------------------------------

YOUNG, DENSITY, WAVE = 200.0e9, 8000.0, 5000.0
AREA = 1.0e-4
IMPEDANCE = DENSITY * WAVE * AREA


def elastic_bar(deck, number):
    deck.card("MAT_ELASTIC", [number, DENSITY, YOUNG, 0.0])
    deck.card("SECTION_SOLID", [number, 1])


@case
def rigid_nodes_in_bar():
    """A nodal rigid body joins two bars; a step of velocity arrives."""
    end, v = 260e-6, 5.0
    deck = start("rigid_nodes_in_bar", "Wave through a nodal rigid body",
                 "a wave passes a nodal rigid body between two elastic bars",
                 "closed form: behind the mass v = V (1 - exp(-2 rho c A t / m))", end, files=("GLSTAT", "RBDOUT"))
    mesh = Bodies()
    n = 200
    left = mesh.block(1, (n, 1, 1), box((0.0, 0.0, 0.0), (1.0, 0.01, 0.01)))
    right = mesh.block(2, (n, 1, 1), box((1.0, 0.0, 0.0), (1.0, 0.01, 0.01)))
    faces = [left[n, b, c] for b in (0, 1) for c in (0, 1)] + [right[0, b, c] for b in (0, 1) for c in (0, 1)]
    added = 0.2
    mass = added + DENSITY * AREA * 1.0 / n  # half an element on either side
    arrive = 1.0 / WAVE
    for t in (20e-6, 50e-6):
        value = v * (1 - math.exp(-2 * IMPEDANCE * t / mass))
        deck.says("expect", f"x_velocity body=7 time={arrive + t:.4g}  {value:.6g}  rel=0.01 (order)")
    deck.says("expect", f"mass body=7  {mass:.9g}  rel=1e-12 (roundoff)")
    deck.says("expect", "energy_ratio  1.0  abs=0.01 (order: after the first steps, when there is hardly any)")
    deck.says("vary", "threads=1,2,3,7 restart=no,150")
    elastic_bar(deck, 1)
    deck.part(1, 1, 1)
    deck.part(2, 1, 1)
    deck.card("ELEMENT_MASS", *[f"{i + 1:8d}{node:8d}{added / len(faces):16.6g}" for i, node in enumerate(faces)])
    deck.card("CONSTRAINED_NODAL_RIGID_BODY", [7, 0, deck.node_set(faces)])
    deck.curve(1, [(0.0, 1.0), (1.0, 1.0)])
    ends = deck.node_set([left[0, b, c] for b in (0, 1) for c in (0, 1)])
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [ends, 1, 0, 1, v])
    deck.mesh(mesh)
    return deck


@case
def rigid_hits_bar():
    """A rigid block hits a long elastic bar."""
    end, v, length = 380e-6, 10.0, 1.0
    deck = start("rigid_hits_bar", "Rigid block hits an elastic bar", "a rigid block hits an elastic bar (contact)",
                 "closed form (St. Venant): v = V exp(-rho c A t / m) until the wave is back after 2 L / c = 400 us", end,
                 files=("GLSTAT", "MATSUM", "RBDOUT", "RCFORC", "SLEOUT"), frames=380)
    size = 0.05
    mass = 0.8
    mesh = Bodies()
    mesh.block(1, (2, 2, 2), box((-size, -0.02, -0.02), (size, 0.05, 0.05)))
    mesh.block(2, (100, 2, 2), box((0.0, 0.0, 0.0), (length, 0.01, 0.01)))
    rate = IMPEDANCE / mass
    for t in (100e-6, 300e-6):
        deck.says("expect", f"x_velocity body=1 time={t:.4g}  {v * math.exp(-rate * t):.6g}  rel=0.01 (order: of the springs between them)")
    deck.says("expect", f"x_force contact=1 time=0.0002  {-IMPEDANCE * v * math.exp(-rate * 200e-6):.6g}  rel=0.03 (order)")
    deck.says("expect", "x_momentum range  0.0  abs=1e-11 (roundoff: 8 in all)")
    deck.says("expect", "energy_ratio range  0.0  abs=0.01 (order)")
    deck.says("vary", "threads=1,2,3,7 restart=no,60")
    rigid(deck, 1, mass / (size * 0.05 * 0.05), YOUNG, 0.0)
    deck.part(1, 1, 1)
    elastic_bar(deck, 2)
    deck.part(2, 2, 2)
    velocity(deck, mesh.members[1], (v, 0.0, 0.0))
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", 0, scale=30.0)
    deck.mesh(mesh)
    return deck


def ball(mesh, part, centre, radius, n):
    """A cube of n^3 hexahedra blown up to a sphere."""
    def place(a, b, c):
        p = [2 * q - 1 for q in (a, b, c)]
        most = max(map(abs, p))
        length = math.sqrt(sum(q * q for q in p))
        scale = radius * most / length if length > 0 else 0.0
        return tuple(m + scale * q for m, q in zip(centre, p))
    return mesh.block(part, (n, n, n), place)


@case
def rigid_ball():
    """A rigid ball comes down on a free elastic block, off its middle, and leaves it."""
    end = 4.0e-3
    deck = start("rigid_ball", "Rigid ball rebounds from an elastic block", "a rigid ball rebounds from a free elastic block",
                 "conservation laws; elastic impact of two free bodies, one of them off its centre", end,
                 files=("GLSTAT", "MATSUM", "RBDOUT", "RCFORC", "SLEOUT"), frames=200)
    mesh = Bodies()
    ball(mesh, 1, (0.06, 0.05, 0.1201), 0.02, 4)
    mesh.block(2, (6, 6, 6), box((0.0, 0.0, 0.0), (0.1, 0.1, 0.1)))
    mass = 8000.0 * sum(hexahedron_volume([mesh.nodes[n - 1] for n in nodes]) for part, nodes in mesh.elements if part == 1)
    lever, block = 0.01, 1.0  # the block turns away where it is hit
    felt = 1 / (1 / block + lever ** 2 / (block * 0.1 ** 2 / 6))
    for axis in "xyz":
        deck.says("expect", f"{axis}_momentum range  0.0  abs=1e-12 (roundoff)")
    deck.says("expect", "energy_ratio range  0.0  abs=0.01 (order)")
    deck.says("expect", f"z_velocity body=1  {5 * (felt - mass) / (felt + mass):.6g}  rel=0.02 (model: the block keeps some as vibration)")
    deck.says("expect", "touches contact=1  0.0  (exact)")
    deck.says("vary", "threads=1,2,3,7 restart=no,200")
    rigid(deck, 1, 8000.0, 200.0e9, 0.3)
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [2, 1000.0, 1.0e9, 0.3])
    deck.card("SECTION_SOLID", [2, 1])
    deck.card("HOURGLASS", [2, 6, 0.1])
    deck.part(2, 2, 2, 0, 2)
    velocity(deck, mesh.members[1], (0.0, 0.0, -5.0))
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", 0)
    deck.mesh(mesh)
    return deck


@case
def rigid_rolling():
    """A cylinder comes down sliding on a plate of rigid shells that is held, and begins to roll."""
    end, v, g, mu, radius = 0.45, 3.0, 10.0, 0.3, 0.1
    mass = 12.0
    deck = start("rigid_rolling", "A sliding cylinder begins to roll", "rigid cylinder: from sliding to rolling",
                 "closed form: v = 2/3 V whatever the friction, after V / (3 mu g) = 0.333 s; rolls without loss then", end,
                 files=("GLSTAT", "MATSUM", "RBDOUT", "RCFORC", "SLEOUT"))
    mesh = Bodies()
    around, long = 240, 0.2
    ids = {}
    for i in range(around):
        for j in (0, 1):
            for k in (0, 1):
                r = radius * (1.0 if k else 0.8)
                angle = 2 * math.pi * i / around
                mesh.nodes.append((r * math.sin(angle), 0.05 + long * j, radius + r * math.cos(angle)))
                ids[i, j, k] = len(mesh.nodes)
    for i in range(around):
        n = (i + 1) % around
        mesh.element(1, [ids[i, 0, 0], ids[n, 0, 0], ids[n, 1, 0], ids[i, 1, 0],
                         ids[i, 0, 1], ids[n, 0, 1], ids[n, 1, 1], ids[i, 1, 1]])
    plate = []
    corner = {}
    for i in range(21):
        for j in range(3):
            mesh.nodes.append((-0.2 + 0.1 * i, 0.15 * j, -0.0005))
            corner[i, j] = len(mesh.nodes)
    for i in range(20):
        for j in range(2):
            plate.append([corner[i, j], corner[i + 1, j], corner[i + 1, j + 1], corner[i, j + 1]])
    deck.says("expect", "x_velocity body=1  2.0  rel=0.002 (order: the facets of the cylinder)")
    deck.says("expect", f"y_spin body=1  {2.0 / radius:.6g}  rel=0.002 (order)")
    deck.says("expect", f"x_velocity body=1 time=0.2  {v - mu * g * 0.2:.6g}  rel=0.005 (order: it bounces a little)")
    deck.says("expect", f"friction_energy id=1 file=sleout  {0.5 * mass * v * v / 3:.6g}  rel=0.002 (order: a third of the energy)")
    deck.says("expect", "energy_ratio range  0.0  abs=1e-4 (order)")
    deck.says("vary", "threads=1,2,3 restart=no,2000")
    # The density sets the step alone: mass and inertia are stated.
    rigid(deck, 1, 1.0e5, 1.0e8, 0.0)
    deck.card("PART_INERTIA", "cylinder", [1, 1, 1], [0.0, 0.05 + long / 2, radius, mass],
              [mass * (radius ** 2 / 4 + long ** 2 / 12), 0.0, 0.0, mass * radius ** 2 / 2, 0.0,
               mass * (radius ** 2 / 4 + long ** 2 / 12)], [v, 0.0, 0.0, 0.0, 0.0, 0.0])
    rigid(deck, 2, 1.0e5, 1.0e8, 0.0, hold=(1, 7, 7), section=False)
    deck.card("SECTION_SHELL", [2, 2], [0.001])
    deck.part(2, 2, 2)
    deck.curve(1, [(0.0, 1.0), (100.0, 1.0)])
    deck.card("LOAD_BODY_Z", [1, g])
    contact(deck, "AUTOMATIC_SURFACE_TO_SURFACE", 2, friction=mu)
    deck.mesh(mesh)
    deck.lines.append("*ELEMENT_SHELL")
    for e, nodes in enumerate(plate):
        deck.lines.append(f"{e + 1:8d}{2:8d}" + "".join(f"{n:8d}" for n in nodes))
    return deck


if __name__ == "__main__":
    for name in sys.argv[1:] or CASES:
        written = CASES[name]()
        (HERE / (written.name + ".k")).write_text(written.text().replace("make.py", "rigid.py"))
        print(written.name)
