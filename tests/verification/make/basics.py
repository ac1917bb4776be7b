"""What the decks of make.py share: requests, materials, bars, and the list of decks."""
from mesh import box


class Cases(dict):
    """Decks by name. As a decorator it lists a function under its own name."""

    def __call__(self, function):
        self[function.__name__] = function
        return function


def common(deck, end, safety=0.9, interval=None, bulk=True):
    deck.card("CONTROL_TERMINATION", [end])
    deck.card("CONTROL_TIMESTEP", [0.0, safety])
    deck.card("CONTROL_ENERGY", [2, 2, 2, 2])
    if not bulk:
        deck.card("CONTROL_BULK_VISCOSITY", [1.0e-20, 1.0e-20])
    for name in ("GLSTAT", "MATSUM"):
        deck.card("DATABASE_" + name, [interval or end / 100])


def histories(deck, end, nodes=(), elements=(), interval=None):
    every = interval or end / 100
    if nodes:
        deck.card("DATABASE_NODOUT", [every])
        deck.card("DATABASE_HISTORY_NODE", list(nodes))
    if elements:
        deck.card("DATABASE_ELOUT", [every])
        deck.card("DATABASE_HISTORY_SOLID", list(elements))


def elastic(deck, number, density, young, poisson):
    deck.card("MAT_ELASTIC", [number, density, young, poisson])


def bar(deck, cells, length, width, form=1):
    mesh = box((cells, 1, 1), (length, width, width))
    deck.card("SECTION_SOLID", [1, form])
    deck.part(1, 1, 1)
    return mesh
