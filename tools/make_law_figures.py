#!/usr/bin/env python3
"""Draws the response of each material law, run through one element, beside its closed form.

usage: make_law_figures.py CLEAVE [FOLDER]      (default folder: docs/figures)

One unit cube whose nodes all follow a prescribed homogeneous motion: stretch at constant volume (axial l, across
1/sqrt(l)) for laws with shear, equal stretch along all axes for pressure laws. Lines are what `cleave run` wrote to elout,
rings the closed form. Fails where they differ by more than 1 % of the largest value.
"""
import csv
import math
import subprocess
import sys
import tempfile
from pathlib import Path

YOUNG, POISSON, DENSITY = 2.0e5, 0.3, 7.85e-9  # tonne, mm, s
SHEAR = YOUNG / (2 * (1 + POISSON))
END, POINTS, STEPS = 4.0e-4, 200, 8000


def deck(cards, stretch, volumetric, part="1,1,1"):
    """Deck of one cube; stretch(s) is the axial stretch at the share s of the time."""
    corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
    lines = ["*KEYWORD", f"*CONTROL_TERMINATION\n{END}", f"*DATABASE_ELOUT\n{END / POINTS}",
             "*DATABASE_HISTORY_SOLID\n1", "*SECTION_SOLID\n1,1", "*PART\ncube\n" + part, *cards]
    for curve, power in ((1, 1.0), (2, 1.0 if volumetric else -0.5)):
        points = [(i / POINTS, stretch(i / POINTS) ** power - 1) for i in range(POINTS + 5)]  # beyond the last step
        lines.append(f"*DEFINE_CURVE\n{curve}")
        lines += [f"{t * END:.12g},{v:.12g}" for t, v in points + [(2.0, points[-1][1])]]
    lines.append("*BOUNDARY_PRESCRIBED_MOTION_NODE")
    lines += [f"{n + 1},{k + 1},2,{1 if k == 0 else 2},1.0" for n, c in enumerate(corners) for k in range(3) if c[k]]
    lines.append("*BOUNDARY_SPC_NODE")
    lines += [f"{n + 1},0," + ",".join(str(1 - x) for x in c) for n, c in enumerate(corners) if 0 in c]
    lines.append("*NODE")
    lines += [f"{n + 1},{x},{y},{z}" for n, (x, y, z) in enumerate(corners)]
    return "\n".join(lines + ["*ELEMENT_SOLID", "1,1,1,2,3,4,5,6,7,8", "*END", ""])


def run(program, text, column):
    """(share of the time, value) of each row of elout."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "law.k").write_text(text)
        done = subprocess.run([program, "run", "law.k", "-q", "-o", "out"], cwd=folder, capture_output=True, text=True)
        if done.returncode:
            sys.exit(text + done.stderr)
        with open(Path(folder) / "out/elout.csv", newline="") as file:
            return [(float(row["time"]) / END, float(row[column])) for row in csv.DictReader(file)]


def stepped(rate_of, stretch, steps=STEPS):
    """Values at POINTS + 1 shares of the time of an ordinary differential equation stepped in small steps."""
    state, values = None, []
    for i in range(steps + 1):
        if i % (steps // POINTS) == 0:
            values.append(state[0] if state else 0.0)
        state = rate_of(state, i / steps, stretch(i / steps), stretch((i + 1) / steps))

    def between(share):
        i = min(int(share * POINTS), POINTS - 1)
        return values[i] + (values[i + 1] - values[i]) * (share * POINTS - i)
    return between


def plastic(flow):
    """von Mises stress of an isotropic law, flow(plastic strain, rate, temperature); adiabatic heat through CP."""
    def step(state, s, now, after):
        q, plastic_strain, temperature = state or (0.0, 0.0, 300.0)
        strain = math.log(after / now)
        rate = strain / (END / STEPS)
        trial = q + 3 * SHEAR * strain
        limit = flow(plastic_strain, rate, temperature)
        if trial > limit:
            low, high = 0.0, trial / (3 * SHEAR)
            for _ in range(50):
                gain = 0.5 * (low + high)
                limit = flow(plastic_strain + gain, rate, temperature)
                low, high = (gain, high) if trial - 3 * SHEAR * gain > limit else (low, gain)
            plastic_strain += gain
            temperature += limit * gain / (DENSITY * 4.6e8)
            trial -= 3 * SHEAR * gain
        return trial, plastic_strain, temperature
    return step


def draw(path, title, across, up, curves):
    """curves: (label, [(x, y)] line, [(x, y)] rings)."""
    colours = ("#1f4e9c", "#c4481b", "#2c7a3f")
    width, height, left, bottom, right, top = 640, 360, 70, 45, 20, 40
    xs = [x for _, line, rings in curves for x, _ in line + rings]
    ys = [y for _, line, rings in curves for _, y in line + rings] + [0.0]

    def ticks(low, high):
        raw = (high - low) / 5
        step = 10 ** math.floor(math.log10(raw))
        step *= next(m for m in (1, 2, 5, 10) if m * step >= raw)
        return [step * k for k in range(math.floor(low / step + 1e-9), math.ceil(high / step - 1e-9) + 1)]
    tx, ty = ticks(min(xs), max(xs)), ticks(min(ys), max(ys))
    px = lambda x: left + (x - tx[0]) / (tx[-1] - tx[0]) * (width - left - right)
    py = lambda y: height - bottom - (y - ty[0]) / (ty[-1] - ty[0]) * (height - bottom - top)
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="13">',
           f"<title>{title}</title>", f'<rect width="{width}" height="{height}" fill="#fff"/>',
           f'<text x="{left}" y="22" font-weight="bold">{title}</text>']
    for x in tx:
        out.append(f'<path d="M{px(x):.1f} {py(ty[0]):.1f}V{py(ty[-1]):.1f}" stroke="#ddd"/>'
                   f'<text x="{px(x):.1f}" y="{height - bottom + 17}" text-anchor="middle">{x:g}</text>')
    for y in ty:
        out.append(f'<path d="M{left} {py(y):.1f}H{width - right}" stroke="#ddd"/>'
                   f'<text x="{left - 6}" y="{py(y) + 4:.1f}" text-anchor="end">{y:g}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 8}" text-anchor="middle">{across}</text>'
               f'<text transform="translate(16 {(height - bottom + top) / 2}) rotate(-90)" text-anchor="middle">{up}</text>')
    for number, (label, line, rings) in enumerate(curves):
        colour = colours[number % len(colours)]
        out.append(f'<path fill="none" stroke="{colour}" stroke-width="1.8" d="M'
                   + " ".join(f"{px(x):.1f} {py(y):.1f}" for x, y in line) + '"/>')
        out += [f'<circle cx="{px(x):.1f}" cy="{py(y):.1f}" r="3.5" fill="none" stroke="{colour}"/>' for x, y in rings]
        x, y = line[-1] if label else (0, 0)
        if label:
            out.append(f'<text x="{min(px(x), width - right) - 4:.1f}" y="{py(y) - 8:.1f}" text-anchor="end" '
                       f'fill="{colour}">{label}</text>')
    path.write_text("\n".join(out + ["</svg>", ""]))


STEEL = f"1,{DENSITY},{YOUNG},{POISSON}"
stretch_to = lambda strain: lambda s: math.exp(strain * s)
rubber_stretch = lambda s: 1.0 + 2.0 * s
squeeze = lambda s: (1.0 - 0.25 * s) ** (1 / 3)


def cycle(s):
    """Log strain 0 -> 2 % -> -2 % -> 2 %, as a stretch."""
    corner = [(0, 0), (0.2, 0.02), (0.6, -0.02), (1.0, 0.02)]
    for (a, u), (b, v) in zip(corner, corner[1:]):
        if s <= b:
            return math.exp(u + (v - u) * (s - a) / (b - a))
    return math.exp(0.02)


def kinematic(beta, yield_stress=400.0, tangent=2.0e4):
    """Axial stress difference of bilinear mixed hardening, a one-dimensional return."""
    hardening = YOUNG * tangent / (YOUNG - tangent)

    def step(state, s, now, after):
        q, back, limit = state or (0.0, 0.0, yield_stress)
        q += 3 * SHEAR * math.log(after / now)
        over = abs(q - back) - limit
        if over > 0:
            gain = over / (3 * SHEAR + hardening)
            sign = math.copysign(1.0, q - back)
            q -= 3 * SHEAR * gain * sign
            back += (1 - beta) * hardening * gain * sign
            limit += beta * hardening * gain
        return q, back, limit
    return step


def adiabat(pressure):
    """Pressure while volume falls and work turns into energy per reference volume; pressure(mu, energy)."""
    def step(state, s, now, after):
        p, energy = state or (0.0, 0.0)
        before, volume = now ** 3, after ** 3
        for _ in range(3):
            gain = -0.5 * (p + pressure(1 / volume - 1, energy)) * (volume - before)
            new = pressure(1 / volume - 1, energy + gain)
        return new, energy + gain
    return step


def gruneisen(mu, energy, speed=3.94e6, slope=1.49, gamma=2.0, correction=0.47, density=8.93e-9):
    cold = density * speed ** 2 * mu * (1 + (1 - gamma / 2) * mu - correction / 2 * mu ** 2)
    return cold / (1 - (slope - 1) * mu) ** 2 + (gamma + correction * mu) * energy


def main(program, folder):
    axial = ("logarithmic strain", "stress difference, axial - across [MPa]")
    compression = ("compression, density over reference density", "pressure [MPa]")
    difference = lambda text: [(s, a - b) for (s, a), (_, b) in zip(run(program, text, "stress_xx"), run(program, text, "stress_yy"))]

    def law(name, title, labels, pieces, volumetric=False):
        curves = []
        for label, (cards, stretch, exact, part) in zip(labels, pieces):
            text = deck(cards, stretch, volumetric, part)
            values = run(program, text, "pressure") if volumetric else difference(text)
            x = (lambda s: stretch(s) ** -3) if volumetric else (lambda s: math.log(stretch(s)))
            if title.endswith("stretch"):
                x = stretch
            largest = max(abs(v) for _, v in values)
            worst = max(abs(v - exact(s)) for s, v in values) / largest
            print(f"{name:30} {label:28} {len(values):4} rows, off by {worst:.1e} of the largest")
            if worst > 0.01 or len(values) < 20:
                sys.exit(f"{name} differs from its closed form")
            curves.append((label, [(x(s), v) for s, v in values], [(x(s), exact(s)) for s, _ in values[::max(1, len(values) // 20)]]))
        draw(folder / f"law-{name}.svg", title, *(compression if volumetric else
             ("stretch", axial[1]) if title.endswith("stretch") else axial), curves)

    whole = "1,1,1"
    law("elastic", "*MAT_ELASTIC", [""], [(["*MAT_ELASTIC\n" + STEEL], stretch_to(0.5), lambda s: 3 * SHEAR * 0.5 * s, whole)])
    law("plastic-kinematic", "*MAT_PLASTIC_KINEMATIC, strain to 2 %, -2 %, 2 %", ["BETA = 0", "BETA = 1"],
        [([f"*MAT_PLASTIC_KINEMATIC\n{STEEL},400.0,2.0e4,{beta}\n"], cycle, stepped(kinematic(beta), cycle), whole)
         for beta in (0.0, 1.0)])
    points = [(0.0, 300.0), (0.05, 420.0), (0.15, 520.0), (0.4, 580.0)]

    def table(e, *_):
        for (a, u), (b, v) in zip(points, points[1:]):
            if e <= b:
                return u + (v - u) * (e - a) / (b - a)
        return points[-1][1]
    law("piecewise-linear-plasticity", "*MAT_PIECEWISE_LINEAR_PLASTICITY", [""],
        [([f"*MAT_PIECEWISE_LINEAR_PLASTICITY\n{STEEL},0.0,0.0\n0,0,9\n\n\n", "*DEFINE_CURVE\n9\n"
           + "\n".join(f"{a},{b}" for a, b in points)], stretch_to(0.35), stepped(plastic(table), stretch_to(0.35)), whole)])

    def power(e, *_):  # K (elastic yield strain + e)^N
        first = (YOUNG / 900.0) ** (1 / (0.2 - 1))
        return 900.0 * (first + e) ** 0.2
    law("power-law-plasticity", "*MAT_POWER_LAW_PLASTICITY", [""],
        [([f"*MAT_POWER_LAW_PLASTICITY\n{STEEL},900.0,0.2\n\n"], stretch_to(0.5), stepped(plastic(power), stretch_to(0.5)), whole)])

    def simple(rate):
        return lambda e, *_: (300.0 + 400.0 * max(e, 1e-300) ** 0.3) * (1 + 0.03 * math.log(rate))
    law("simplified-johnson-cook", "*MAT_SIMPLIFIED_JOHNSON_COOK at a rate of 1000 /s", ["C = 0", "C = 0.03"],
        [([f"*MAT_SIMPLIFIED_JOHNSON_COOK\n{STEEL}\n300.0,400.0,0.3,{c}\n"], stretch_to(0.4),
          stepped(plastic(simple(1000.0 if c else 1.0)), stretch_to(0.4)), whole) for c in (0.0, 0.03)])

    def cook(e, rate, t):
        return (300.0 + 400.0 * max(e, 1e-300) ** 0.3) * (1 + 0.03 * math.log(1000.0)) * (1 - max(0.0, (t - 300) / 1500) ** 1.03)
    law("johnson-cook", "*MAT_JOHNSON_COOK, heating adiabatically at 1000 /s", [""],
        [([f"*MAT_JOHNSON_COOK\n1,{DENSITY},{SHEAR},{YOUNG},{POISSON}\n300.0,400.0,0.3,0.03,1.03,1800.0,300.0,1.0\n4.6e8,\n\n",
           "*EOS_LINEAR_POLYNOMIAL\n1,0.0,1.6e5\n\n"], stretch_to(0.4), stepped(plastic(cook), stretch_to(0.4)), "1,1,1,1")])
    law("mooney-rivlin", "*MAT_MOONEY-RIVLIN_RUBBER, A = 80, B = 20, over the stretch", [""],
        [(["*MAT_MOONEY-RIVLIN_RUBBER\n1,1.0e-9,0.495,80.0,20.0\n"], rubber_stretch,
          lambda s: 2 * (rubber_stretch(s) ** 2 - 1 / rubber_stretch(s)) * (80 + 20 / rubber_stretch(s)), whole)])
    law("blatz-ko", "*MAT_BLATZ-KO_RUBBER, G = 100, over the stretch", [""],
        [(["*MAT_BLATZ-KO_RUBBER\n1,1.0e-9,100.0"], rubber_stretch,
          lambda s: 100 * (rubber_stretch(s) ** 2 - 1 / rubber_stretch(s)), whole)])
    eos = "*EOS_GRUNEISEN\n1,3.94e6,1.49,0.0,0.0,2.0,0.47\n"
    law("null", "*MAT_NULL with *EOS_GRUNEISEN, copper", [""],
        [(["*MAT_NULL\n1,8.93e-9", eos], squeeze, stepped(adiabat(gruneisen), squeeze), "1,1,1,1")], True)
    polynomial = lambda mu, e: 1.4e5 * mu + 2.5e5 * mu ** 2 + (2.0 + 0.5 * mu) * e
    law("equations-of-state", "*EOS_LINEAR_POLYNOMIAL: C1 = 1.4e5, C2 = 2.5e5, C4 = 2, C5 = 0.5", [""],
        [(["*MAT_NULL\n1,8.93e-9", "*EOS_LINEAR_POLYNOMIAL\n1,0.0,1.4e5,2.5e5,0.0,2.0,0.5\n"], squeeze,
          stepped(adiabat(polynomial), squeeze), "1,1,1,1")], True)
    law("erosion", "*MAT_ADD_EROSION on *MAT_ELASTIC: SIGVM = 60000 and 100000", ["60000", "100000"],
        [(["*MAT_ELASTIC\n" + STEEL, f"*MAT_ADD_EROSION\n1\n0,0,{bound}"], stretch_to(0.5),
          lambda s: 3 * SHEAR * 0.5 * s, whole) for bound in (6.0e4, 1.0e5)])


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2] if len(sys.argv) > 2 else "docs/figures"))
