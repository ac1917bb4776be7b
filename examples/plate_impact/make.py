#!/usr/bin/env python3
"""Writes plate_impact.k, a rigid ball shot through a plate, to standard output.

usage: make.py [CORE RINGS LAYERS BALL]        (20 8 5 6: 5200 hexahedra of the plate, 648 of the ball)

The plate is a square core of CORE x CORE elements inside RINGS rings that blend into the circle, in LAYERS layers;
the ball a cube of BALL^3 elements inside BALL / 3 shells that blend into the sphere.
Units: gram, millimetre, millisecond; hence newton and megapascal.
"""
import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from round_section import round_section  # noqa: E402

PLATE, THICKNESS, BALL, SPEED, GAP = 20.0, 5.0, 5.0, 600.0, 0.05

HEAD = """\
$@ case    a rigid ball shot through an elastoplastic plate with erosion, {elements} hexahedra
$@ source  conservation: momentum is what the support takes, energy; the ball is slowed and gets through (catalogue L02)
$@ expect  summary energy.ratio_low  1.0  abs=0.01 (model: energy is kept to 1 %)
$@ expect  summary energy.ratio_high  1.0  abs=0.01 (model: energy is kept to 1 %)
$@ expect  z_rigid_body_velocity part=2  -430.0  abs=60 (model: slowed, never stopped; bounded by the plug below)
$@ expect  z_rigid_body_velocity part=2 min  -600.0  abs=1 (model: the ball is never pushed forward)
$@ vary    threads=1,2
$
$ A rigid ball of steel, 10 mm across, hits a plate of a soft metal, 5 mm thick and 40 mm across, at 600 m/s. Elements that
$ have been strained too far are deleted; the contact goes on with the faces this lays bare.
$ Units: g, mm, ms, N, MPa. Written by make.py.
$
*KEYWORD
*TITLE
Plate impact, {elements} hexahedra
$
$--- how long, which step ----------------------------------------------------------------------
*CONTROL_TERMINATION
$   ENDTIM    ENDCYC     DTMIN    ENDENG    ENDMAS
      0.05
$ ERODE: elements that fold in on themselves are deleted as well.
*CONTROL_TIMESTEP
$   DTINIT    TSSFAC      ISDO    TSLIMT     DT2MS      LCTM     ERODE
       0.0      0.67         0       0.0       0.0         0         1
*CONTROL_ENERGY
$     HGEN      RWEN    SLNTEN     RYLEN
         2         2         2         1
*CONTROL_BULK_VISCOSITY
$       Q1        Q2
       1.5      0.06
$
$--- what to write ------------------------------------------------------------------------------
*DATABASE_BINARY_D3PLOT
$       DT
    2.5e-3
*DATABASE_GLSTAT
$       DT
    1.0e-4
*DATABASE_MATSUM
    1.0e-4
*DATABASE_RCFORC
    1.0e-4
*DATABASE_SLEOUT
    1.0e-4
*DATABASE_RBDOUT
    1.0e-4
$
$--- the plate and the ball ---------------------------------------------------------------------
*PART
$ TITLE
plate
$      PID     SECID       MID     EOSID      HGID
         1         1         1         0         1
*PART
ball
         2         1         2         0         1
*SECTION_SOLID
$    SECID    ELFORM
         1         1
*HOURGLASS
$     HGID       IHQ        QM
         1         5      0.05
*MAT_PLASTIC_KINEMATIC
$      MID        RO         E        PR      SIGY      ETAN      BETA
         1   7.85e-3     6.9e4       0.3     200.0       0.0       1.0
$ FS: the plastic strain at which an element is deleted
$      SRC       SRP        FS        VP
       0.0       0.0       0.8       0.0
$ The ball does not deform; E and PR give its contact stiffness.
*MAT_RIGID
$      MID        RO         E        PR
         2   7.85e-3     2.1e5       0.3
$      CMO
       0.0
$ (no axes of its own)

$ Faces against faces (SOFT 2), and the surface follows what is deleted.
*CONTACT_ERODING_SURFACE_TO_SURFACE
$    SURFA     SURFB  SURFATYP  SURFBTYP   SABOXID   SBBOXID      SAPR      SBPR
         2         1         3         3         0         0         1         1
$       FS        FD        DC        VC       VDC    PENCHK        BT        DT
       0.0       0.0       0.0       0.0      20.0         0       0.0    1.0e20
$     SFSA      SFSB
       1.0       1.0
$     ISYM    EROSOP      IADJ
         0         1         1
$     SOFT    SOFSCL
         2       0.1
*INITIAL_VELOCITY_GENERATION
$       ID      STYP     OMEGA        VX        VY        VZ
         2         2       0.0       0.0       0.0{speed:10.1f}
$ (no turning)
         0
$ The rim of the plate is held.
*BOUNDARY_SPC_SET
         1         0         1         1         1
"""


def ball(n, radius):
    """Nodes and hexahedra of a ball around the origin: a cube inside shells that blend into the sphere."""
    shells, half = max(n // 3, 1), 0.4 * radius
    nodes, hexes, number = [], [], {}

    def node(p):
        key = tuple(round(c, 9) for c in p)
        if key not in number:
            number[key] = len(nodes)
            nodes.append(key)
        return number[key]

    def place(g, shell):
        """Grid numbers on the surface of the cube, or within it for shell 0."""
        u, v, w = (2.0 * c / n - 1.0 for c in g)
        # Cells of equal size on the sphere; the cube bulges, so that no cell gets flat.
        sphere = [math.tan(0.25 * math.pi * c) for c in (u, v, w)]
        largest = max(map(abs, (u, v, w)))
        size = math.hypot(*sphere) or 1.0
        round_part = [radius * c / size for c in sphere]
        cube = [half * c * (1.25 - 0.25 * math.hypot(u, v, w) / math.sqrt(3.0)) for c in (u, v, w)]
        t = shell / shells
        return cube if shell == 0 else [(1 - t) * a + t * b for a, b in zip(cube, round_part)] if largest else cube

    corner = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    for k in range(n):
        for j in range(n):
            for i in range(n):
                hexes.append([node(place((i + a, j + b, k + c), 0)) for a, b, c in corner])
    for axis in range(3):
        for end in (0, n):
            # Seen from outside counter-clockwise.
            first, second = ((axis + 1) % 3, (axis + 2) % 3) if end else ((axis + 2) % 3, (axis + 1) % 3)
            for a in range(n):
                for b in range(n):
                    quad = []
                    for da, db in ((0, 0), (1, 0), (1, 1), (0, 1)):
                        g = [0, 0, 0]
                        g[axis], g[first], g[second] = end, a + da, b + db
                        quad.append(tuple(g))
                    for shell in range(shells):
                        hexes.append([node(place(g, shell)) for g in quad] + [node(place(g, shell + 1)) for g in quad])
    return nodes, hexes


def main(core=20, rings=8, layers=5, ball_size=6):
    flat, quads, rim = round_section(PLATE, core, rings)
    rows = len(flat)
    nodes = [(x, y, -THICKNESS + THICKNESS * k / layers) for k in range(layers + 1) for x, y in flat]
    elements = [(1, [k * rows + q for q in quad] + [(k + 1) * rows + q for q in quad])
                for k in range(layers) for quad in quads]
    sphere, hexes = ball(ball_size, BALL)
    first = len(nodes)
    nodes += [(x, y, z + BALL + GAP) for x, y, z in sphere]
    elements += [(2, [first + n for n in h]) for h in hexes]
    write = sys.stdout.write
    write(HEAD.format(elements=len(elements), speed=-SPEED))
    write("*SET_NODE_LIST\n         1\n")
    held = [k * rows + n + 1 for k in range(layers + 1) for n in rim]
    for i in range(0, len(held), 8):
        write("".join(f"{n:10d}" for n in held[i:i + 8]) + "\n")
    write("*NODE\n$    NID               X               Y               Z\n")
    for i, (x, y, z) in enumerate(nodes, 1):
        write(f"{i:8d}{x:16.9f}{y:16.9f}{z:16.9f}\n")
    write("*ELEMENT_SOLID\n$    EID     PID      N1      N2      N3      N4      N5      N6      N7      N8\n")
    for e, (part, corners) in enumerate(elements, 1):
        write(f"{e:8d}{part:8d}" + "".join(f"{n + 1:8d}" for n in corners) + "\n")
    write("*END\n")


if __name__ == "__main__":
    main(*(int(word) for word in sys.argv[1:]))
