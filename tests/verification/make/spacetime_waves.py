"""Decks of waves along a bar, through a strip of two materials, across a sheet, through a block. Used by spacetime.py."""
import math

from basics import Cases
from deck import Deck
from mesh import Mesh, hexahedra, tetrahedra
from simplices import Triangles, edges_on, faces_on
from spacetime_basics import (common, element_at, node_at, plane_strain_modulus, pulse, pulse_curve,
                              pulse_integral, push, rollers, write_mesh)

CASES = case = Cases()
EXAMPLES = example = Cases()


def bar(count):
    """A pulse of prescribed velocity runs along a bar to its free end, which moves twice as fast."""
    deck = Deck(f"spacetime_bar_{count}", f"Pulse in a bar, {count} elements")
    length, end = 0.5, 1.5
    mesh = Mesh()
    at = lambda i: (i + (0.2 * math.sin(5.0 * i) if 0 < i < count else 0.0)) / count
    free, driven = mesh.node(1.0, 0.0, 0.0), mesh.node(0.0, 0.0, 0.0)   # the same numbers on every mesh
    for i in range(count):
        mesh.element(1, [mesh.node(at(i), 0.0, 0.0), mesh.node(at(i + 1), 0.0, 0.0)])
    if count == 8:
        deck.says("case", "a smooth pulse along a bar of uneven elements, three fields of degree 2: order 3")
        deck.says("source", "d'Alembert: the free end has moved by twice the integral of the pulse")
        deck.says("order", f"x_displacement node={free} time=1.2 exact={2 * pulse_integral(0.2, length):.10g} "
                  "in=2.2..6 with=spacetime_bar_16.k,spacetime_bar_32.k (order)")
        deck.says("vary", "threads=1,2,3")
    common(deck, end, space=2, degree=2, interval=0.05, nodes=[free, driven])
    deck.card("SECTION_BEAM_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, 1.0, 0.3])
    pulse_curve(deck, 1, length)
    deck.card("BOUNDARY_PRESCRIBED_MOTION_NODE", [driven, 1, 0, 1, 1.0])
    write_mesh(deck, mesh)
    return deck


for _count in (8, 16, 32):
    CASES[f"spacetime_bar_{_count}"] = lambda count=_count: bar(count)


def strip(name, space, repeat):
    """A pulse of pressure meets another material and leaves through a silent end."""
    deck = Deck(name, "Pulse through two materials")
    mesh = Triangles((0.0, 0.0), (2.0, 0.25), (16, 2), lambda x, y: 0.125).mesh(lambda x, y: 1 if x < 1 else 2)
    left, right = node_at(mesh, 0.5, 0.125), node_at(mesh, 1.5, 0.125)
    what = "tents that repeat, three fields" if repeat else "Trefftz functions"
    deck.says("case", f"transmission and reflection at an interface, and a silent end; {what} of degree 4")
    deck.says("source", "impedances 1 and 4: velocities 2/5 and -3/5 of the incident, traction 8/5 of it")
    deck.says("expect", f"x_velocity node={left} time=0.75  1.0  rel=0.01 (order: the crest stands on a border of elements)")
    deck.says("expect", f"x_velocity node={right} time=1.5  0.4  rel=0.004 (order)")
    deck.says("expect", f"x_velocity node={left} time=1.75  -0.6  rel=0.004 (order)")
    deck.says("expect", f"x_velocity node={right} time=2.3  0.0  abs=0.002 (order: nothing comes back from the end)")
    # In the middle of elements: -rho c v along the wave, nu / (1 - nu) of it across.
    watched = []
    for x, time, size, start in ((0.5, 0.75, -1.0, lambda x: x), (1.5, 1.5, -1.6, lambda x: 1 + (x - 1) / 2)):
        element, middle = element_at(mesh, x, 0.125)
        watched.append(element)
        stress = size * pulse(time - start(middle[0]), 0.5)
        for component, share in (("xx", 1.0), ("yy", 1 / 3), ("zz", 1 / 3)):
            deck.says("expect", f"stress_{component} element={element} time={time}  {share * stress:.6g}  rel=0.015 (order)")
    deck.says("vary", "threads=1,3 restart=no,20" if repeat else "threads=1,2,3")
    common(deck, 2.3, space, degree=4, interval=0.05, nodes=[left, right], repeat=repeat)
    deck.card("DATABASE_ELOUT", [0.05])
    deck.card("SET_SHELL_LIST", [1, 0.0], watched)
    deck.card("DATABASE_HISTORY_SHELL_SET", [1])
    deck.card("SECTION_SHELL_SDG", [1])
    for part, density, speed in ((1, 1.0, 1.0), (2, 2.0, 2.0)):
        deck.part(part, 1, part)
        deck.card("MAT_ELASTIC", [part, density, plane_strain_modulus(0.25, density, speed), 0.25])
    pulse_curve(deck, 1, 0.5)
    push(deck, [e + e[1:] for e in edges_on(mesh, lambda x, y, z: x == 0.0)], 1, 1.0)
    deck.card("BOUNDARY_NON_REFLECTING", [deck.segment_set([e + e[1:] for e in edges_on(mesh, lambda x, y, z: x == 2.0)])])
    rollers(deck, mesh.where(lambda x, y, z: y in (0.0, 0.25)), "y")
    write_mesh(deck, mesh)
    return deck


for _name, _space, _repeat in (("spacetime_strip", 3, False), ("spacetime_repeat", 2, True)):
    CASES[_name] = lambda arguments=(_name, _space, _repeat): strip(*arguments)


@case
def spacetime_mixed():
    """The strip of two materials again; local spaces and degrees change along lines that are not those of materials."""
    deck = Deck("spacetime_mixed", "Pulse through four local spaces and two materials")
    spaces = [(3, 5), (2, 4), (1, 4), (3, 3)]   # Trefftz, three fields, one field, Trefftz
    part = lambda x, y: 1 + (x + y > 0.55) + (x > 1) + (x - y > 1.45)
    mesh = Triangles((0.0, 0.0), (2.0, 0.25), (16, 2), lambda x, y: 0.125).mesh(part)
    places = [node_at(mesh, x, 0.125) for x in (0.25, 0.75, 1.25, 1.75)]
    deck.says("case", "three fields, one field, Trefftz functions and three degrees meet in one body, across materials as well")
    deck.says("source", "d'Alembert; impedances 1 and 4: velocities 2/5 and -3/5 of the incident")
    for node, x in zip(places, (0.25, 0.75, 1.25, 1.75)):
        # The pulse is 0.5 long in time; material 2 is twice as fast.
        arrival = x if x < 1 else 1 + (x - 1) / 2
        height = 1.0 if x < 1 else 0.4
        for phase in (0.15, 0.25, 0.4):
            deck.says("expect", f"x_velocity node={node} time={arrival + phase:g}  {height * pulse(phase, 0.5):.6g}  "
                      f"abs={0.01 * height:g} (order: {('Trefftz, 5', 'three fields, 4', 'one field, 4', 'Trefftz, 3')[places.index(node)]})")
    deck.says("expect", f"x_velocity node={places[1]} time=1.5  -0.6  rel=0.01 (order: what came back)")
    deck.says("expect", f"x_velocity node={places[0]} time=2.0  -0.6  rel=0.01 (order: and passed a change of space)")
    for node, x in zip(places[:2], (0.25, 0.75)):
        deck.says("expect", f"x_displacement node={node} time=2.25  {0.4 * pulse_integral(0.5, 0.5):.6g}  rel=0.01 (order: both have passed)")
    deck.says("expect", f"y_velocity node={places[1]} peak  0.0  abs=0.01 (order)")
    deck.says("expect", f"x_velocity node={places[3]} time=2.4  0.0  abs=0.002 (order: nothing comes back from the end)")
    deck.says("vary", "threads=1,3 restart=no,20")
    common(deck, 2.4, interval=0.025, nodes=places)
    for number, (space, degree) in enumerate(spaces, 1):
        deck.card("SECTION_SHELL_SDG", [number, 13, space, degree])
        deck.part(number, number, 1 if number < 3 else 2)
    for material, density, speed in ((1, 1.0, 1.0), (2, 2.0, 2.0)):
        deck.card("MAT_ELASTIC", [material, density, plane_strain_modulus(0.25, density, speed), 0.25])
    pulse_curve(deck, 1, 0.5)
    push(deck, [e + e[1:] for e in edges_on(mesh, lambda x, y, z: x == 0.0)], 1, 1.0)
    deck.card("BOUNDARY_NON_REFLECTING", [deck.segment_set([e + e[1:] for e in edges_on(mesh, lambda x, y, z: x == 2.0)])])
    rollers(deck, mesh.where(lambda x, y, z: y in (0.0, 0.25)), "y")
    write_mesh(deck, mesh)
    return deck


@case
def spacetime_shear():
    """A shear pulse through uneven quadrilaterals, one field."""
    deck = Deck("spacetime_shear", "Shear pulse through a sheet")
    nx, ny = 16, 3
    mesh = Mesh()
    place = lambda i, j: ((i + (0.15 * math.sin(3.7 * i + 2.1 * j) if 0 < i < nx else 0.0)) / nx,
                          (j + (0.15 * math.cos(2.9 * i + 1.3 * j) if 0 < j < ny else 0.0)) / nx, 0.0)
    for j in range(ny):
        for i in range(nx):
            mesh.element(1, [mesh.node(*place(i + a, j + b)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))])
    free = node_at(mesh, 1.0, 1.0 / nx)
    deck.says("case", "a shear pulse at unit speed through quadrilaterals, one field of degree 4: doubled at the free end")
    deck.says("source", "d'Alembert")
    deck.says("expect", f"y_velocity node={free} time=1.25  2.0  rel=0.005 (order)")
    deck.says("expect", f"y_displacement node={free} time=1.6  {2 * pulse_integral(0.5, 0.5):.8g}  rel=0.002 (order)")
    deck.says("expect", f"x_velocity node={free} time=1.25  0.0  abs=0.005 (order)")
    common(deck, 1.6, space=1, degree=4, interval=0.05, nodes=[free])
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, 2.5, 0.25])
    pulse_curve(deck, 1, 0.5)
    moved = deck.node_set(mesh.where(lambda x, y, z: x == 0.0))
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [moved, 2, 0, 1, 1.0])
    rollers(deck, mesh.where(lambda x, y, z: x == 0.0 or y in (0.0, ny / nx)), "x")
    write_mesh(deck, mesh)
    return deck


@case
def spacetime_block():
    """A pulse of pressure through tetrahedra."""
    deck = Deck("spacetime_block", "Pressure pulse through a block")
    counts = (8, 2, 2)
    inside = lambda n, k: 0 < n < counts[k]
    place = lambda *g: tuple((n + (0.12 * math.sin(3.1 * g[0] + 2.3 * g[1] + 1.7 * g[2] + k) if inside(n, k) else 0.0)) / 8
                             for k, n in enumerate(g))
    mesh = tetrahedra(hexahedra(counts, place))
    free = node_at(mesh, 1.0, 0.125, 0.125)
    deck.says("case", "a pulse of pressure through uneven tetrahedra, Trefftz functions of degree 3: doubled at the free end")
    deck.says("source", "d'Alembert")
    deck.says("expect", f"x_velocity node={free} time=1.35  2.0  rel=0.02 (order)")
    deck.says("expect", f"x_displacement node={free} time=1.8  {2 * pulse_integral(0.7, 0.7):.8g}  rel=0.01 (order)")
    element, middle = element_at(mesh, 0.5, 0.125, 0.125)
    for component, share in (("xx", 1.0), ("yy", 1 / 3), ("zz", 1 / 3)):
        deck.says("expect", f"stress_{component} element={element} time=0.85  {-share * pulse(0.85 - middle[0], 0.7):.6g}  "
                  "abs=0.03 (order: in its middle)")
    deck.says("vary", "threads=1,2")
    common(deck, 1.8, degree=3, interval=0.05, nodes=[free])
    deck.card("DATABASE_ELOUT", [0.05])
    deck.card("DATABASE_HISTORY_SOLID", [element])
    deck.card("SECTION_SOLID_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(0.25, 1.0, 1.0), 0.25])
    pulse_curve(deck, 1, 0.7)
    push(deck, faces_on(mesh, lambda x, y, z: x == 0.0), 1, 1.0)
    rollers(deck, mesh.where(lambda x, y, z: y in (0.0, 0.25)), "y")
    rollers(deck, mesh.where(lambda x, y, z: z in (0.0, 0.25)), "z")
    write_mesh(deck, mesh)
    return deck


@example
def spacetime_mesh():
    """A few triangles under a pulse: to look at the tents."""
    deck = Deck("spacetime_mesh", "Tents over a square")
    mesh = Triangles((0.0, 0.0), (1.0, 1.0), (4, 4), lambda x, y: max(0.0625, 0.6 * math.hypot(x - 0.5, y - 0.5))).mesh()
    deck.says("case", "tents over a square whose triangles are smaller in the middle")
    deck.says("source", "balance of momentum and energy; the impulse of the pulse, to the quadrature of its curve in tents")
    for end in (0.4, 0.5):
        deck.says("expect", f"x_momentum file=spacetime time={end:g}  {pulse_integral(end, 0.5):.6g}  rel=0.01 (order)")
    deck.says("expect", "y_momentum file=spacetime range  0.0  abs=1e-12 (roundoff: nothing acts along y)")
    common(deck, 0.5, degree=2, interval=0.1, nodes=[1])
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(0.25, 1.0, 1.0), 0.25])
    pulse_curve(deck, 1, 0.5, 40)
    push(deck, [e + e[1:] for e in edges_on(mesh, lambda x, y, z: x == 0.0)], 1, 1.0)
    write_mesh(deck, mesh)
    return deck
