"""Decks of waves in bars. Used by make.py."""
import math

from basics import Cases, bar, common, elastic, histories
from deck import Deck

CASES = case = Cases()


# --- waves in bars ---------------------------------------------------------------------------------------------

@case
def wave_exact():
    """Central differences at the critical step carry a front along a bar without any error."""
    cells = 40
    deck = Deck("wave_exact", "Step wave in a bar at the critical step")
    deck.says("case", "one-dimensional step wave at dt = h/c: nodally exact")
    deck.says("source", "closed form u = V (t - x/c); catalogue A12 (i)")
    for x in (5, 20, 30):
        deck.says("expect", f"x_displacement node={{x{x}}} time=32  {max(0.0, 1e-9 * (32 - x)):.9g}  abs=1e-14 "
                  "(roundoff: positions of order 10, displacements of order 1e-8)")
    common(deck, 32.0, safety=1.0, bulk=False)
    mesh = bar(deck, cells, 40.0, 1.0)
    watched = {x: mesh.where(lambda a, b, c: a == x and b == 0 and c == 0)[0] for x in (5, 20, 30)}
    deck.head = [line.format(**{f"x{x}": n for x, n in watched.items()}) for line in deck.head]
    histories(deck, 32.0, watched.values(), interval=1.0)
    deck.card("HOURGLASS", [1, 1, 0.0])
    elastic(deck, 1, 1.0, 1.0, 0.0)
    deck.curve(1, [(0, 1), (1000, 1)])
    end_face = deck.node_set(mesh.where(lambda x, y, z: x == 0))
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [end_face, 1, 0, 1, 1.0e-9])
    deck.card("INITIAL_VELOCITY", [end_face], [1.0e-9, 0.0, 0.0])
    deck.mesh(mesh)
    return deck


def bar_against_wall(deck, kind, *cards):
    """Catalogue D01: the bar, its velocity and the wall it meets at x = 0."""
    common(deck, 600e-6, interval=1e-6)
    deck.card("DATABASE_RWFORC", [1e-6])
    mesh = bar(deck, 100, 1.0, 0.01)
    elastic(deck, 1, 8000.0, 200.0e9, 0.0)
    everything = deck.node_set(list(range(1, len(mesh.nodes) + 1)))
    deck.card("INITIAL_VELOCITY", [everything], [-10.0, 0.0, 0.0])
    deck.card("RIGIDWALL_" + kind, [everything], *cards)
    deck.mesh(mesh)


@case
def bar_rebound():
    """Catalogue D01."""
    deck = Deck("bar_rebound", "Elastic bar against a rigid wall")
    deck.says("case", "elastic bar hits a rigid wall: stress, contact time, rebound")
    deck.says("source", "closed form: rho c v = 400 MPa, 2 L / c = 400 us, rebound -v; catalogue D01")
    deck.says("expect", "x_velocity  10.0  abs=0.2 (order: rebound 1 %, twice that at this size)")
    deck.says("expect", "normal_force wall=1 time=200e-6  4.0e4  rel=0.02 (order: 400 MPa on 1 cm2)")
    deck.says("expect", "normal_force wall=1 time=380e-6  4.0e4  rel=0.05 (order)")
    deck.says("expect", "normal_force wall=1 time=430e-6  0.0  abs=1.0e2 (order: contact ends at 400 us)")
    deck.says("expect", "energy_ratio range 0.0 abs=0.01 (order)")
    deck.says("vary", "threads=1,2,3,7")
    bar_against_wall(deck, "PLANAR", [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0])
    return deck


@case
def plastic_wave():
    """Catalogue D03 with stresses and velocities a hundred times smaller: the theory is one of small strains, and
    at 4 % the growing section alone makes the tangent a quarter stiffer."""
    deck = Deck("plastic_wave", "Elastic-plastic wave in a bar")
    deck.says("case", "end of a bar driven at 0.3 m/s: elastic precursor, plastic wave")
    deck.says("source", "one-dimensional theory: 4 MPa ahead, 4.8 MPa and strain 4.2e-4 behind; catalogue D03 / 100")
    end, plastic = 160e-6, 4.2e-4 - 4.8e6 / 200.0e9
    deck.says("expect", "stress_xx element={near}  -4.80e6  rel=0.01 (order)")
    deck.says("expect", "stress_xx element={ahead}  -4.00e6  rel=0.01 (order)")
    deck.says("expect", "stress_xx element={before}  0.0  abs=4e4 (order: precursor has not arrived)")
    deck.says("expect", f"effective_plastic_strain element={{near}}  {plastic:.6g}  rel=0.01 (order)")
    for where, value in (("behind", plastic), ("past", 0.0)):
        deck.says("expect", f"effective_plastic_strain element={{{where}}}  {value:.6g}  abs={plastic / 2:.6g} "
                  "(order: half of the step lies within 2 % of 500 m/s t = 0.08 m)")
    common(deck, end)
    mesh = bar(deck, 400, 1.0, 0.0025)
    watched = dict(near=mesh.element_near(0.03, 0, 0), behind=mesh.element_near(0.0784, 0, 0),
                   past=mesh.element_near(0.0816, 0, 0), ahead=mesh.element_near(0.4, 0, 0),
                   before=mesh.element_near(0.85, 0, 0))
    deck.head = [line.format(**watched) for line in deck.head]
    histories(deck, end, elements=watched.values())
    tangent, young = 2.0e9, 200.0e9
    deck.card("MAT_PLASTIC_KINEMATIC", [1, 8000.0, young, 0.0, 4.0e6, tangent, 1.0], [0.0, 0.0, 0.0])
    deck.curve(1, [(0, 1), (1, 1)])
    end_face = deck.node_set(mesh.where(lambda x, y, z: x == 0))
    deck.card("BOUNDARY_PRESCRIBED_MOTION_SET", [end_face, 1, 0, 1, 0.3])
    deck.card("INITIAL_VELOCITY", [end_face], [0.3, 0.0, 0.0])
    deck.mesh(mesh)
    return deck


# --- order of convergence --------------------------------------------------------------------------------------------

def standing_wave(cells):
    """Free-free bar in its first longitudinal mode: after half a period every point passes zero."""
    finest = 32
    deck = Deck(f"standing_wave_{cells}", f"Standing wave in a bar, {cells} cells")
    amplitude, length = 1.0e-6, 1.0
    time = 1.0                                       # c = 1, period 2
    if cells == 8:
        deck.says("case", "standing wave in a bar: the phase error falls with the mesh size squared")
        deck.says("source", "closed form u = -U cos(pi x) sin(pi t), zero at t = 1")
        deck.says("order", f"x_displacement node=1 time={time} exact=0 in=1.85..2.15 "
                  f"with=standing_wave_16.k,standing_wave_{finest}.k (order)")
    common(deck, 1.01, safety=0.5, bulk=False, interval=1.0e-5)
    mesh = bar(deck, cells, length, length / cells)
    histories(deck, 1.01, [1], interval=1.0e-5)
    elastic(deck, 1, 1.0, 1.0, 0.0)
    rows = [[n + 1, -amplitude * math.pi * math.cos(math.pi * p[0]), 0.0, 0.0] for n, p in enumerate(mesh.nodes)]
    deck.card("INITIAL_VELOCITY_NODE", *rows, wide=True)
    deck.mesh(mesh)
    return deck


for _cells in (8, 16, 32):
    CASES[f"standing_wave_{_cells}"] = lambda cells=_cells: standing_wave(cells)
