"""Decks of step waves at a semi-infinite crack and at one in a plate. Used by spacetime.py."""
import math

from basics import Cases
from crack import StepLoadedCrack, intensity, rayleigh
from deck import Deck
from simplices import Triangles, edges_on
from spacetime_basics import common, node_at, plane_strain_modulus, push, rollers, speed_d, step_curve, write_mesh

CASES, EXAMPLES, LARGE = Cases(), Cases(), Cases()   # tests; those that are shown, too; on demand only

STEEL = {"young": 211.0e9, "poisson": 0.3, "density": 7800.0}
STEP_STRESS, PLATE_HEIGHT = 500.0e6, 2.0   # of the half plate


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
    if whole:
        tip = node_at(mesh, 0.0, 0.0)
        for share, of_root in ((1.5, 0.7209), (2.0, 1.0195), (3.0, 1.4418)):
            deck.says("expect", f"K_I file=crack_tip id={tip} time={share * arrival:.10g}  {of_root * stress * math.sqrt(height):.6g}  "
                      f"rel=0.01 (order: Freund's, {share:g} arrivals, {of_root:g} of s sqrt(2 m))")
        deck.says("slow", "")
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
CASES["spacetime_step_plate"] = lambda: crack_plate("spacetime_step_plate", 5.0, 0.25, 0.03125, 0.5, 3, whole=True)
LARGE["crack_step_whole"] = lambda: crack_plate("crack_step_whole", 5.0, 0.25, 0.03125, 0.35, 3, whole=True)


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
LARGE["wave_scattering_fine"] = lambda: scattering("wave_scattering_fine", 0.0625, 0.015625, 4, 2.0)
