"""The section of a round bar, or of a round plate: for the make.py of the examples."""
import math


def round_section(radius, core, rings):
    """Nodes (x, y), counter-clockwise quads, and the nodes of the rim: a square of core x core quads inside rings that
    blend into the circle."""
    half = 0.45 * radius  # of the core square: leaves ring elements about as deep as the core's are wide
    nodes, quads, number = [], [], {}

    def node(x, y):
        key = (round(x, 9), round(y, 9))
        if key not in number:
            number[key] = len(nodes)
            nodes.append(key)
        return number[key]

    side = [-half + 2.0 * half * i / core for i in range(core + 1)]
    grid = [[node(x, y) for y in side] for x in side]
    quads += [(grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1])
              for i in range(core) for j in range(core)]

    # The core's outline, counter-clockwise from its corner at -135 degrees, blends into the circle.
    loop = ([grid[i][0] for i in range(core)] + [grid[core][j] for j in range(core)] +
            [grid[i][core] for i in range(core, 0, -1)] + [grid[0][j] for j in range(core, 0, -1)])
    inner = loop
    for ring in range(1, rings + 1):
        t, outer = ring / rings, []
        for q, start in enumerate(loop):
            angle = -0.75 * math.pi + 2.0 * math.pi * q / len(loop)
            x, y = nodes[start]
            outer.append(node((1 - t) * x + t * radius * math.cos(angle), (1 - t) * y + t * radius * math.sin(angle)))
        quads += [(inner[q], outer[q], outer[p], inner[p]) for q in range(len(loop)) for p in [(q + 1) % len(loop)]]
        inner = outer
    return nodes, quads, inner
