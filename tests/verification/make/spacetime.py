"""Decks of the spacetime wing: waves in one, two and three dimensions, waves at cracks. Used by make.py."""
import math

from crack import StepLoadedCrack, intensity, rayleigh
from deck import Deck
from mesh import Mesh, hexahedra, tetrahedra
from simplices import Triangles, edges_on, faces_on, penny_quarter

CASES, EXAMPLES, LARGE = {}, {}, {}   # decks that are tests; those that are examples too; on demand only


def case(function):
    CASES[function.__name__] = function
    return function


def example(function):
    EXAMPLES[function.__name__] = function
    return function


def common(deck, end, space=3, degree=3, interval=None, nodes=(), frames=0, repeat=False):
    deck.card("CONTROL_TERMINATION", [end])
    deck.card("CONTROL_SPACETIME", [space, degree], [0, 1, 0, 1] if repeat else [0, 1])
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


# --- a crack under a step wave --------------------------------------------------------------------------------

STEEL = {"young": 211.0e9, "poisson": 0.3, "density": 7800.0}
STEP_STRESS, PLATE_HEIGHT = 500.0e6, 2.0   # of the half plate


def speed_d(young, poisson, density):
    return math.sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density)


def crack_plate(name, half_width, coarse, fine, growth, degree, whole):
    """Catalogue I01 and V4: a plate 4 m high with a crack to its middle, a step of tension at its top. Only what can
    tell the crack from a semi-infinite one before 3 t_c is cut away at the sides, which are planes of symmetry."""
    height, stress = PLATE_HEIGHT, STEP_STRESS
    c = speed_d(**STEEL)
    arrival = height / c
    grid = (round(2 * half_width / coarse), round(height / coarse))
    size = lambda x, y: max(fine, min(coarse, growth * math.hypot(x, y)))
    bottom = -height if whole else 0.0
    mesh = Triangles((-half_width, bottom), (half_width, height),
                     (grid[0], grid[1] * (2 if whole else 1)), size).mesh()
    deck = Deck(name, "Step wave on a semi-infinite crack")
    deck.says("case", "dynamic stress intensity: faces of a crack open under a step wave, "
              + ("whole plate, crack opened in the mesh" if whole else "half of it, by symmetry"))
    deck.says("source", "Freund, Dynamic Fracture Mechanics (1990), section 2.4; faces by make/crack.py; catalogue I01")
    exact = StepLoadedCrack(STEEL["poisson"])
    velocity = stress / (STEEL["density"] * c)
    places = [node_at(mesh, -r, 0.0) for r in (0.125, 0.25, 0.5, 1.0)]
    for node in places:
        r = -mesh.nodes[node - 1][0]
        for share in (1.5, 2.0, 2.5, 2.95):
            t = (share - 1) * arrival
            u = velocity * t * exact.displacement(c * t / r)
            what = f"opening node={node} file=crack" if whole else f"y_displacement node={node}"
            deck.says("expect", f"{what} time={share * arrival:.10g}  {(2 if whole else 1) * u:.6g}  rel=0.01 "
                      f"(order: {r:g} m from the tip)")
    near_tip = (3 * fine, 8 * fine)
    if not whole:
        deck.says("analyse", f"crack_intensity.py {near_tip[0]:g} {near_tip[1]:g}")
        for share in (1.2, 1.3, 1.5, 2.0, 2.5, 3.0):
            deck.says("expect", f"K file=intensity time={share * arrival:.10g}  "
                      f"{intensity(0.3, stress, c * (share - 1) * arrival):.6g}  rel=0.03 (order: Freund's, {share:g} arrivals)")
        places += [k for k in mesh.where(lambda x, y, z: y == 0.0 and near_tip[0] <= -x <= near_tip[1] + 1e-9) if k not in places]
    common(deck, 3 * arrival, degree=degree, interval=arrival / 40, nodes=places, frames=12)
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, STEEL["density"], STEEL["young"], STEEL["poisson"]])
    step_curve(deck, 1)
    near = lambda a, b: abs(a - b) < 1e-9
    top = edges_on(mesh, lambda x, y, z: near(y, height))
    push(deck, [e + e[1:] for e in top], 1, -stress * (1.0 if whole else 0.5))
    rollers(deck, mesh.where(lambda x, y, z: near(abs(x), half_width)), "x")
    if whole:
        deck.card("BOUNDARY_PRECRACK", [1, 1, 2], [-half_width, 0.0, 0.0], [0.0, 0.0, 0.0])
    else:
        rollers(deck, mesh.where(lambda x, y, z: near(y, 0.0) and x > -1e-9), "y")
    write_mesh(deck, mesh)
    return deck


EXAMPLES["crack_step"] = lambda: crack_plate("crack_step", 2.25, 0.25, 0.015625, 0.5, 3, whole=False)
LARGE["crack_step_fine"] = lambda: crack_plate("crack_step_fine", 2.25, 0.125, 0.015625, 0.25, 3, whole=False)
LARGE["crack_step_whole"] = lambda: crack_plate("crack_step_whole", 5.0, 0.25, 0.03125, 0.35, 3, whole=True)


# --- waves along a bar, through a strip of two materials, across a sheet, through a block ------------------------

def plane_strain_modulus(nu, density, speed):
    """Young's modulus that gives a longitudinal wave speed in a solid."""
    return density * speed * speed * (1 + nu) * (1 - 2 * nu) / (1 - nu)


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


def pulse_integral(t, length):
    """Of pulse() from 0 to t."""
    x = math.pi * t / length
    return length / math.pi * (3 * x / 8 - math.sin(2 * x) / 4 + math.sin(4 * x) / 32)


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
    deck.says("vary", "threads=1,3 restart=no,20" if repeat else "threads=1,2,3")
    common(deck, 2.3, space, degree=4, interval=0.05, nodes=[left, right], repeat=repeat)
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
    deck.says("vary", "threads=1,2")
    common(deck, 1.8, degree=3, interval=0.05, nodes=[free])
    deck.card("SECTION_SOLID_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(0.25, 1.0, 1.0), 0.25])
    pulse_curve(deck, 1, 0.7)
    push(deck, faces_on(mesh, lambda x, y, z: x == 0.0), 1, 1.0)
    rollers(deck, mesh.where(lambda x, y, z: y in (0.0, 0.25)), "y")
    rollers(deck, mesh.where(lambda x, y, z: z in (0.0, 0.25)), "z")
    write_mesh(deck, mesh)
    return deck


# --- sheets of a material with directions ----------------------------------------------------------------------------

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


# --- a crack inside a plate, and a penny-shaped one ----------------------------------------------------------------

FRONTS = {"incident": "the wave arrives at the crack", "P": "circle around a tip", "S": "circle around a tip",
          "Rayleigh": "along the faces"}


def scattering(name, coarse, fine, degree, end, case=True):
    """V3: both ends of a plate two crack lengths wide are pulled suddenly; the waves meet at the crack."""
    nu = 0.3
    exact = StepLoadedCrack(nu)
    on_face = coarse / 2   # distance from a face, and from the tips
    def size(x, y):
        tip = math.hypot(abs(x) - 0.5, y)
        return max(fine, min(coarse, 0.35 * tip, on_face + 0.35 * (abs(y) if abs(x) < 0.5 else tip)))
    mesh = Triangles((-1.0, -1.0), (1.0, 1.0), (round(2 / coarse),) * 2, size).mesh()
    deck = Deck(name, "Waves at the tips of a crack")
    places = [node_at(mesh, x, 0.0) for x in (0.0, 0.25, 0.375)]
    if case:
        deck.says("case", "a crack in a plate pulled at both ends: faces open as in an infinite body, tip by tip")
        deck.says("source", "Freund (1990), section 2.4, two tips superposed; faces by make/crack.py")
        for node in places:
            x = mesh.nodes[node - 1][0]
            for t in (0.12, 0.25, 0.5, 0.75, 0.95):
                u = 2 * t * (1 + sum(exact.displacement(t / r) - 1 for r in (0.5 - x, 0.5 + x)))
                far = t < 0.5 - x
                deck.says("expect", f"opening node={node} file=crack time={1 + t:g}  {2 * u:.6g}  "
                          f"rel={0.02 if t < 0.2 else 0.005 if far else 0.01} (order{': before the tips are felt' if far else ''})")
    # Where tests/analysis/wave_fronts.py looks for the Rayleigh wave and the circles that leave the right tip.
    ahead = [node_at(mesh, 0.125, 0.0)] + [node_at(mesh, 0.5 + a, b) for a, b in ((0.125, 0.125), (0.1875, 0.1875), (0.25, 0.25), (0.25, 0.125), (0.125, 0.25))]
    if case:
        deck.says("analyse", "wave_fronts.py")
        for front, exact_speed in (("incident", 1.0), ("P", 1.0), ("S", 1 / exact.b), ("Rayleigh", rayleigh(nu) / exact.b)):
            deck.says("expect", f"speed file=fronts front={front}  {exact_speed:.6g}  rel=0.01 (order: {FRONTS[front]})")
    common(deck, end, degree=degree, interval=0.01, nodes=places + ahead, frames=20)
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(nu, 1.0, 1.0), nu])
    step_curve(deck, 1)
    push(deck, [e + e[1:] for e in edges_on(mesh, lambda x, y, z: abs(y) == 1.0)], 1, -1.0)
    rollers(deck, mesh.where(lambda x, y, z: abs(x) == 1.0), "x")
    deck.card("BOUNDARY_PRECRACK", [1, 1, 2], [-0.5, 0.0, 0.0], [0.5, 0.0, 0.0])
    write_mesh(deck, mesh)
    return deck


EXAMPLES["wave_scattering"] = lambda: scattering("wave_scattering", 0.125, 0.03125, 3, 2.0)


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
LARGE["wave_scattering_fine"] = lambda: scattering("wave_scattering_fine", 0.0625, 0.015625, 4, 2.0)
# Far sides, to the static limit; and near ones with elements of one size, for pictures.
LARGE["penny_crack_fine"] = lambda: penny("penny_crack_fine", 8, 6, 4.0, (0.05, 0.11, 0.2, 0.33, 0.5, 0.75, 1.1, 1.6, 2.3, 3.2), 3,
                                          4.8, whole=False)
LARGE["penny_crack_waves"] = lambda: penny("penny_crack_waves", 8, 6, 2.3, (0.06, 0.14, 0.25, 0.38, 0.53, 0.7, 0.88, 1.07, 1.27, 1.5),
                                           3, 1.6, whole=False)


@example
def spacetime_mesh():
    """A few triangles under a pulse: to look at the tents."""
    deck = Deck("spacetime_mesh", "Tents over a square")
    mesh = Triangles((0.0, 0.0), (1.0, 1.0), (4, 4), lambda x, y: max(0.0625, 0.6 * math.hypot(x - 0.5, y - 0.5))).mesh()
    deck.says("case", "tents over a square whose triangles are smaller in the middle")
    deck.says("source", "balance of momentum and energy")
    common(deck, 0.5, degree=2, interval=0.1, nodes=[1])
    deck.card("SECTION_SHELL_SDG", [1])
    deck.part(1, 1, 1)
    deck.card("MAT_ELASTIC", [1, 1.0, plane_strain_modulus(0.25, 1.0, 1.0), 0.25])
    pulse_curve(deck, 1, 0.5, 40)
    push(deck, [e + e[1:] for e in edges_on(mesh, lambda x, y, z: x == 0.0)], 1, 1.0)
    write_mesh(deck, mesh)
    return deck
