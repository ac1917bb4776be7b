"""Decks of rigid walls. Used by make.py."""
import math

from basics import Cases, bar, common, elastic, histories
from deck import Deck
from mesh import box
from waves import bar_against_wall

CASES = case = Cases()

# A wall of each shape with its surface at x = 0, met by a bar that comes along -x: what stands in the cards after
# the nodes. The tail of a cylinder or prism lies off the bar's axis, so that a wrong place or direction shows.
SHAPES = {
    "flat": ("FLAT", [0.0, -1.0, -1.0, 1.0, -1.0, -1.0, 0.0], [0.0, 0.0, -1.0, 2.0, 2.0]),
    "prism": ("PRISM", [-2.0, -1.0, 3.0, -2.0, -1.0, 4.0, 0.0], [-1.0, -1.0, 3.0, 2.0, 2.0, 6.0]),
    "cylinder": ("CYLINDER", [-50.0, 0.005, -3.0, -50.0, 0.005, -2.0, 0.0], [50.0, 6.0]),
    "sphere": ("SPHERE", [-50.0, 0.005, 0.005, 0.0, 0.0, 0.0, 0.0], [50.0])}


def rebound(name):
    """The bar of bar_rebound against a wall of simple geometry."""
    shape, tail_head, size = SHAPES[name]
    deck = Deck("wall_rebound_" + name, f"Elastic bar against a rigid {name}")
    deck.says("case", f"elastic bar hits a rigid {name}: stress, contact time, rebound along the normal")
    deck.says("source", "closed form: rho c v = 400 MPa, 2 L / c = 400 us, rebound -v; curvature 1e-4 of the width")
    deck.says("expect", "x_velocity  10.0  abs=0.25 (order: rebound 1 %, twice that at this size)")
    for axis in "yz":
        deck.says("expect", f"{axis}_velocity  0.0  abs=1e-3 (order: the normal turns by 1e-4 over the section)")
    deck.says("expect", "normal_force wall=1 time=200e-6  4.0e4  rel=0.02 (order: 400 MPa on 1 cm2)")
    deck.says("expect", "x_force wall=1 time=200e-6  4.0e4  rel=0.02 (order)")
    deck.says("expect", "normal_force wall=1 time=430e-6  0.0  abs=1.0e2 (order: contact ends at 400 us)")
    deck.says("expect", "stonewall_energy  0.2  rel=0.05 (order: the impact of the first nodes, 0.5 % of the mass)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("vary", "threads=1,3 restart=no,57")
    bar_against_wall(deck, "GEOMETRIC_" + shape, tail_head, size)
    return deck


for _name in SHAPES:
    CASES["wall_rebound_" + _name] = lambda name=_name: rebound(name)


@case
def wall_moving_flat():
    """The wall is driven into a bar at rest by a curve that begins at the wall's birth."""
    deck = Deck("wall_moving_flat", "A driven wall sends a wave into a bar")
    speed, birth, end = 2.0, 20e-6, 160e-6
    deck.says("case", "flat wall moved by a displacement curve from its birth: wave in the bar, place of the nodes")
    deck.says("source", "closed form: the end moves with the wall, force rho c V A = 8000 N, strain V / c")
    deck.says("expect", f"x_displacement node=1 time=150e-6  {speed * 130e-6:.9g}  abs=1e-13 (roundoff: the node lies on the wall)")
    deck.says("expect", f"position wall=4 time=150e-6  {speed * 130e-6:.9g}  abs=1e-13 (roundoff)")
    deck.says("expect", "normal_force wall=4 time=100e-6  8.0e3  rel=0.02 (order)")
    deck.says("expect", "normal_force wall=4 time=15e-6  0.0  (exact)")
    deck.says("expect", "x_velocity node={middle} time=150e-6  2.0  rel=0.02 (order)")
    deck.says("expect", "stress_xx element={strained} time=150e-6  -8.0e7  rel=0.02 (order)")
    deck.says("expect", f"external_work  {8000.0 * speed * (end - birth):.6g}  rel=0.02 (order)")
    deck.says("expect", "energy_ratio  1.0  abs=0.01 (order)")
    deck.says("vary", "threads=1,3 restart=no,31")
    common(deck, end, interval=1e-6)
    deck.card("DATABASE_RWFORC", [1e-6])
    mesh = bar(deck, 100, 1.0, 0.01)
    elastic(deck, 1, 8000.0, 200.0e9, 0.0)
    watched = dict(middle=mesh.where(lambda x, y, z: abs(x - 0.4) < 1e-9 and y == 0 and z == 0)[0],
                   strained=mesh.element_near(0.4, 0, 0))
    deck.head = [line.format(**watched) for line in deck.head]
    histories(deck, end, [1, watched["middle"]], [watched["strained"]], interval=1e-6)
    deck.curve(1, [(0, 0), (1, speed)])
    deck.card("RIGIDWALL_GEOMETRIC_FLAT_DISPLAY_MOTION_ID", "         4ram", [0, 0, 0, birth],
              [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 0.0], [1, 1, 1.0, 0.0, 0.0], [None, 1.0])
    deck.mesh(mesh)
    return deck


@case
def wall_hollow():
    """Point masses in hollows: one runs around, one swings, one is carried; a cube far away makes it a model."""
    deck = Deck("wall_hollow", "Point masses in a hollow cylinder and a hollow sphere")
    mass, speed, radius, gravity, swing, end = 2.0, 3.0, 0.5, 10.0, 0.02, 5.0
    deck.says("case", "point masses slide in a hollow cylinder and swing in a hollow sphere, without friction")
    deck.says("source", "closed form: circle at constant speed, force m v^2 / R; pendulum of length R")
    turned = speed * end / radius
    # Angles are those of steps of constant size, so the place is good to the square of the angle per step.
    for axis, at in (("x", math.cos(turned)), ("y", math.sin(turned))):
        deck.says("expect", f"{axis}_coordinate node=9 time={end}  {radius * at:.9g}  abs=2e-4 (order: second in the step)")
    deck.says("expect", f"x_coordinate node=9 max  {radius}  abs=1e-5 (order: rows lie a degree apart)")
    deck.says("expect", f"normal_force wall=1 time=2.0  {mass * speed ** 2 / radius}  rel=1e-4 (order)")
    period = 2 * math.pi * math.sqrt(radius / gravity) * (1 + swing ** 2 / 16)
    deck.says("expect", f"x_displacement node=10 time={3 * period:.9g}  0.0  abs=1e-6 (order: after three swings it is back)")
    deck.says("expect", f"x_coordinate node=10 time={0.75 * period:.9g}  0.0  abs=1e-5 (order)")
    deck.says("expect", f"normal_force wall=2 max  {gravity * (3 - 2 * math.cos(swing)):.9g}  rel=1e-4 (order)")
    deck.says("expect", "stonewall_energy peak 0.0 abs=1e-4 (order: nothing is lost along a curved wall)")
    deck.says("vary", "threads=1,3 restart=no,57")
    common(deck, end + 0.01, interval=0.01)
    for name in ("NODOUT", "RWFORC"):
        deck.card("DATABASE_" + name, [0.002])
    deck.card("DATABASE_HISTORY_NODE", [9, 10])
    deck.card("SECTION_SOLID", [1, 1])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, 1.0e6, 0.0)   # a step of 0.9 ms, 0.005 radian on the circle
    mesh = box((1, 1, 1), (1.0, 1.0, 1.0))
    mesh.nodes = [(x + 50.0, y, z) for x, y, z in mesh.nodes]
    mesh.nodes.append((radius, 0.0, 0.0))
    mesh.nodes.append((radius * math.sin(swing), 10.0, -radius * math.cos(swing)))
    deck.card("ELEMENT_MASS", f"{1:8d}{9:8d}{mass:16.1f}", f"{2:8d}{10:8d}{1.0:16.1f}")
    deck.card("INITIAL_VELOCITY_NODE", [9, 0.0, speed, 0.0], [10, 0.0, 0.0, 0.0])
    deck.curve(1, [(0, 1), (1000, 1)])
    deck.card("LOAD_BODY_GENERALIZED", [10, 10, 1], [0.0, 0.0, gravity])
    deck.card("RIGIDWALL_GEOMETRIC_CYLINDER_INTERIOR", [deck.node_set([9])],
              [0.0, 0.0, -1.0, 0.0, 0.0, 1.0, 0.0], [radius, 2.0])
    deck.card("RIGIDWALL_GEOMETRIC_SPHERE_INTERIOR", [deck.node_set([10])],
              [0.0, 10.0, 0.0, 0.0, 0.0, 0.0, 0.0], [radius])
    deck.mesh(mesh)
    return deck


@case
def wall_friction_two_ways():
    """Cubes slide on a floor whose friction is twice as large across as along. Along, it does not decay and the static
    coefficient stays; across, it has decayed to the dynamic one at the least speed."""
    deck = Deck("wall_friction_two_ways", "Cubes slide to rest on orthotropic friction")
    speed, gravity, along, across, end = 2.0, 10.0, 0.2, 0.4, 1.2
    deck.says("case", "cubes slide on a wall with friction 0.2 along x + y and 0.4 across it")
    deck.says("source", "closed form: they stop after v^2 / (2 mu g); heat is the kinetic energy")
    half = 1 / math.sqrt(2)
    for node, mu, sign in ((1, along, 1), (9, across, -1)):
        slide = speed ** 2 / (2 * mu * gravity)
        for axis, part in (("x", slide * half), ("y", sign * slide * half)):
            deck.says("expect", f"{axis}_displacement node={node}  {part:.6g}  rel=0.01 (order: it rocks a little)")
    deck.says("expect", "kinetic_energy time={0}  0.0  abs=1e-3 (order)".format(end))
    deck.says("expect", f"stonewall_energy  {2 * 0.5 * speed ** 2:g}  rel=0.01 (order)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("vary", "threads=1,3 restart=no,101")
    common(deck, end, interval=0.01)
    histories(deck, end, [1, 9])
    deck.card("SECTION_SOLID", [1, 2])
    deck.part(1, 1, 1)
    elastic(deck, 1, 1.0, 2.0e5, 0.0)
    mesh = box((1, 1, 1), (1.0, 1.0, 1.0))
    mesh.element(1, [n + 8 for n in mesh.elements[0][1]])
    mesh.nodes += [(x + 5.0, y, z) for x, y, z in mesh.nodes]
    deck.card("INITIAL_VELOCITY_NODE", *[[n, speed * half, (speed if n < 9 else -speed) * half, 0.0] for n in range(1, 17)])
    deck.curve(1, [(0, gravity), (1000, gravity)])
    deck.card("LOAD_BODY_Z", [1, 1.0])
    floor = deck.node_set(mesh.where(lambda x, y, z: z == 0))
    deck.card("RIGIDWALL_PLANAR_ORTHO", [floor], [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
              [along, 1.5 * across, 0.5 * along, across, 0.0, 100.0], [0, 0, 1.0, 1.0, 0.0])
    deck.mesh(mesh)
    return deck
