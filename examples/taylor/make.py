#!/usr/bin/env python3
"""Writes taylor.k, a copper bar thrown at a rigid wall, to standard output.

usage: make.py [CORE RINGS LAYERS]        (6 3 48: 5184 hexahedra)

The section of the bar is a square core of CORE x CORE elements inside RINGS rings that blend into the circle.
Units: tonne, millimetre, second; hence newton and megapascal.
"""
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from round_section import round_section  # noqa: E402

RADIUS, LENGTH, SPEED = 3.2, 32.4, 227.0e3

HEAD = """\
$@ case    copper Taylor bar, linear hardening, frictionless wall, 227 m/s, {elements} hexahedra
$@ source  axisymmetric B-bar reference 21.49..21.52 and 7.24..7.33; published lengths 21.4..21.7, radii 6.9..7.2
$@ expect  summary parts.0.final.length.2  21.5  abs=0.25 (model: published 21.4 to 21.7)
$@ expect  summary parts.0.final.diameter.2  14.4  abs=0.5 (model: of the mushroom; published radii 6.9 to 7.3)
$@ expect  summary energy.ratio_low  1.0  abs=0.01 (model: energy is kept to 1 %)
$@ expect  summary energy.ratio_high  1.0  abs=0.01 (model: energy is kept to 1 %)
$@ vary    threads=1,2
$
$ A bar of copper, 6.4 mm across and 32.4 mm long, hits a rigid wall at 227 m/s. Its foot mushrooms; after
$ 80 microseconds it is at rest. The oldest test of high-rate plasticity (Taylor 1948).
$ Units: tonne, mm, s, N, MPa. Written by make.py.
$
*KEYWORD
*TITLE
Taylor bar, copper, {elements} hexahedra
$
$--- how long, which step ----------------------------------------------------------------------
*CONTROL_TERMINATION
$   ENDTIM    ENDCYC     DTMIN    ENDENG    ENDMAS
    8.0e-5
*CONTROL_TIMESTEP
$   DTINIT    TSSFAC
       0.0       0.9
*CONTROL_ENERGY
$     HGEN      RWEN    SLNTEN     RYLEN
         2         2         1         1
*CONTROL_BULK_VISCOSITY
$       Q1        Q2
       1.5      0.06
$
$--- what to write ------------------------------------------------------------------------------
*DATABASE_BINARY_D3PLOT
$       DT
    4.0e-6
*DATABASE_GLSTAT
$       DT
    4.0e-7
*DATABASE_MATSUM
    4.0e-7
*DATABASE_NODOUT
    4.0e-7
*DATABASE_ELOUT
    4.0e-7
*DATABASE_RWFORC
    4.0e-7
*DATABASE_HISTORY_NODE
$      ID1       ID2
{foot:10d}{tail:10d}
*DATABASE_HISTORY_SOLID
$      ID1       ID2
{centre:10d}{rim:10d}
$
$--- the bar ------------------------------------------------------------------------------------
*PART
$ TITLE
copper bar
$      PID     SECID       MID     EOSID      HGID
         1         1         1         0         1
*SECTION_SOLID
$    SECID    ELFORM
         1         1
$ Assumed strain (Belytschko-Bindeman), with little of the elastic stiffness: the metal flows nearly everywhere.
$ The control then holds 0.3 % of the internal energy; with QM = 0.1 it holds 1.5 % and the foot is 4 % smaller.
*HOURGLASS
$     HGID       IHQ        QM
         1         6      0.01
*MAT_PLASTIC_KINEMATIC
$      MID        RO         E        PR      SIGY      ETAN      BETA
         1  8.930e-9   117.0e3      0.35     400.0     100.0       1.0
$      SRC       SRP        FS        VP
       0.0       0.0       0.0       0.0
*INITIAL_VELOCITY
$     NSID    NSIDEX     BOXID
         0         0         0
$       VX        VY        VZ
       0.0       0.0{speed:10.1f}
$
$--- the wall: plane z = 0, the bar is on its positive side -------------------------------------
*RIGIDWALL_PLANAR
$     NSID    NSIDEX     BOXID
         0         0         0
$       XT        YT        ZT        XH        YH        ZH      FRIC
       0.0       0.0       0.0       0.0       0.0       1.0       0.0
$
$--- the mesh -----------------------------------------------------------------------------------
"""


def main(core=6, rings=3, layers=48):
    if core % 2:
        sys.exit("make.py: CORE must be even, so that nodes lie on the axes")
    nodes, quads, _ = round_section(RADIUS, core, rings)
    rows = len(nodes)
    foot = nodes.index((RADIUS, 0.0)) + 1
    axis = nodes.index((0.0, 0.0)) + 1
    centre = next(i for i, quad in enumerate(quads, 1) if axis - 1 in quad)
    rim = next(i for i, quad in enumerate(quads, 1) if foot - 1 in quad)
    write = sys.stdout.write
    write(HEAD.format(elements=len(quads) * layers, tail=axis + rows * layers, foot=foot, centre=centre, rim=rim,
                      speed=-SPEED))
    write("*NODE\n$    NID               X               Y               Z\n")
    for layer in range(layers + 1):
        for i, (x, y) in enumerate(nodes):
            write(f"{layer * rows + i + 1:8d}{x:16.9f}{y:16.9f}{LENGTH * layer / layers:16.9f}\n")
    write("*ELEMENT_SOLID\n$    EID     PID      N1      N2      N3      N4      N5      N6      N7      N8\n")
    element = 0
    for layer in range(layers):
        for quad in quads:
            element += 1
            low = [layer * rows + n + 1 for n in quad]
            write(f"{element:8d}{1:8d}" + "".join(f"{n:8d}" for n in low + [n + rows for n in low]) + "\n")
    write("*END\n")


if __name__ == "__main__":
    main(*(int(word) for word in sys.argv[1:]))
