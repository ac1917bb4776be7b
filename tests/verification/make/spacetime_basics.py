"""What the decks of spacetime parts share: control and requests, meshes, loads, pulses. Used by spacetime_*.py."""
import math


def common(deck, end, space=3, degree=3, interval=None, nodes=(), frames=0, repeat=False, parts=0):
    """Control, tables and checks; `parts`: of the sides of elements in field files, 0 by degree."""
    deck.card("CONTROL_TERMINATION", [end])
    deck.card("CONTROL_SPACETIME", [space, degree], [0, 1, parts, 1] if repeat else [0, 1, parts] if parts else [0, 1])
    deck.card("DATABASE_GLSTAT", [interval or end / 100])
    if frames:
        deck.card("DATABASE_BINARY_D3PLOT", [end / frames])
    if nodes:
        deck.card("DATABASE_NODOUT", [interval or end / 100])
        for i in range(0, len(nodes), 8):
            deck.card("DATABASE_HISTORY_NODE", list(nodes[i:i + 8]))
    # Balance of momentum and energy of every patch, and the volume of all tents.
    deck.says("expect", "summary facts.worst_momentum_residual  0.0  abs=1e-12 (roundoff)")
    deck.says("expect", "summary facts.worst_energy_residual  0.0  abs=1e-10 (roundoff)")
    deck.says("expect", "summary facts.volume_error  0.0  abs=1e-11 (roundoff)")


def write_mesh(deck, mesh):
    """Bars, shells or tetrahedra, by the number of nodes of the elements and whether they are flat."""
    size = len(mesh.elements[0][1])
    flat = all(p[2] == 0.0 for p in mesh.nodes)
    if size == 4 and not flat:
        return deck.mesh(mesh)
    deck.lines.append("*NODE")
    for i, p in enumerate(mesh.nodes):
        deck.lines.append(f"{i + 1:8d}" + "".join(f"{v:16.10g}" for v in p))
    deck.lines.append("*ELEMENT_BEAM" if size == 2 else "*ELEMENT_SHELL")
    for i, (part, nodes) in enumerate(mesh.elements):
        nodes = list(nodes) + [nodes[-1]] * (4 - len(nodes)) if size > 2 else nodes
        deck.lines.append(f"{i + 1:8d}{part:8d}" + "".join(f"{k:8d}" for k in nodes))


def node_at(mesh, *place):
    place = tuple(place) + (0.0,) * (3 - len(place))
    return min(range(len(mesh.nodes)), key=lambda i: math.dist(mesh.nodes[i], place)) + 1


def element_at(mesh, *place):
    """Number and middle of the element nearest to a place."""
    middle = lambda nodes: [sum(mesh.nodes[k - 1][i] for k in nodes) / len(nodes) for i in range(3)]
    place = tuple(place) + (0.0,) * (3 - len(place))
    best = min(range(len(mesh.elements)), key=lambda i: math.dist(middle(mesh.elements[i][1]), place))
    return best + 1, middle(mesh.elements[best][1])


def push(deck, segments, curve, factor):
    deck.card("LOAD_SEGMENT_SET", [deck.segment_set(segments), curve, factor])


def rollers(deck, nodes, *held):
    deck.card("BOUNDARY_SPC_SET", [deck.node_set(nodes), 0] + [1 if k in held else 0 for k in "xyz"])


def step_curve(deck, number):
    deck.curve(number, [(0.0, 1.0), (1.0e3, 1.0)])


def pulse(t, length):
    return math.sin(math.pi * t / length) ** 4 if 0 < t < length else 0.0


def pulse_curve(deck, number, length, points=400):
    deck.curve(number, [(length * i / points, pulse(length * i / points, length)) for i in range(points + 1)]
               + [(1.0e3, 0.0)])


def pulse_integral(t, length):
    """Of pulse() from 0 to t."""
    x = math.pi * t / length
    return length / math.pi * (3 * x / 8 - math.sin(2 * x) / 4 + math.sin(4 * x) / 32)


def speed_d(young, poisson, density):
    return math.sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density)


def plane_strain_modulus(nu, density, speed):
    """Young's modulus that gives a longitudinal wave speed in a solid."""
    return density * speed * speed * (1 + nu) * (1 - 2 * nu) / (1 - nu)
