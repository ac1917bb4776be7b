"""Step loading of a semi-infinite crack, plane strain: the exact opening of its faces.

Freund, Dynamic Fracture Mechanics (1990), section 2.4 gives the stress intensity factor by the Wiener-Hopf method.
The same solution yields the displacement of the faces. With slownesses a = 1/c_d, b = 1/c_s, c = 1/c_R,

    R(z) = (b^2 - 2 z^2)^2 + 4 z^2 sqrt(a^2 - z^2) sqrt(b^2 - z^2) = kappa (c^2 - z^2) S+(z) S-(z),
    S-(z) = exp(-1/pi int_a^b atan(4 h^2 sqrt((h^2 - a^2) (b^2 - h^2)) / (b^2 - 2 h^2)^2) dh / (h - z)),
    F-(z) = sqrt(a - z) / ((c - z) S-(z)),   F+(z) = F-(-z),   kappa = 2 (b^2 - a^2),

the transform of the displacement of the upper face is -s_0 b^2 F+(0) F-(z) / (mu kappa z). Inverted after Cagniard and
de Hoop, the residue at z = 0 is a plane wave of velocity s_0/(rho c_d), and the branch cut what comes from the tip:

    u(r, t) = s_0 t/(rho c_d) + (r/pi) int_a^(t/r) (t/r - z) Im U(z) dz,
    Im U(z) = s_0 b^2 F+(0) sqrt(z - a) cos(theta(z)) / (mu kappa z (c - z) |S-(z)|),

theta the arc tangent above for z < b, else 0; a principal value at z = c.

Ahead of the tip, x > 0, waves leave it on circles, and nothing else is there. With potentials of the transforms
    P(z) = -(b^2 - 2 z^2) U(z)/(alpha b^2), Q(z) = -2 z U(z)/b^2, alpha^2 = a^2 - z^2, beta^2 = b^2 - z^2,
the acceleration is 1/pi times the imaginary part of, for the longitudinal and the shear wave,
    (z P, -alpha P) dz/dt,   z = (-t x + i y sqrt(t^2 - a^2 r^2))/r^2,
    (-beta Q, -z Q) dz/dt,   the same z with b for a.
"""
import cmath
import math


def gauss(n):
    """Points and weights of the Gauss-Legendre rule on (-1, 1)."""
    rule = []
    for i in range(n):
        x = math.cos(math.pi * (i + 0.75) / (n + 0.5))
        for _ in range(100):
            p, q = 1.0, x
            for k in range(2, n + 1):
                p, q = q, ((2 * k - 1) * x * q - (k - 1) * p) / k
            slope = n * (x * q - p) / (x * x - 1)
            x -= q / slope
            if abs(q / slope) < 1e-16:
                break
        rule.append((x, 2 / ((1 - x * x) * slope * slope)))
    return rule


RULE = gauss(40)


def integral(f, low, high):
    """Of a function that may have roots at its ends: they are smoothed by a polynomial change of variable."""
    total = 0.0
    for x, w in RULE:
        s = 0.5 * (x + 1)
        total += 0.5 * w * f(low + (high - low) * s ** 3 * (10 - 15 * s + 6 * s * s)) * 30 * (s * (1 - s)) ** 2
    return total * (high - low)


def rayleigh(nu):
    """c_R/c_s."""
    k = (1 - 2 * nu) / (2 * (1 - nu))   # (c_s/c_d)^2
    f = lambda x: 4 * math.sqrt(1 - x * x * k) * math.sqrt(1 - x * x) - (2 - x * x) ** 2
    low, high = 0.5, 1 - 1e-12
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if f(middle) > 0 else (low, middle)
    return low


def intensity(nu, stress, reach):
    """K_I after the wave has had time to run the length `reach` = c_d t: Freund (8.1) of the specification."""
    return 2 * stress / (1 - nu) * math.sqrt(reach * (1 - 2 * nu) / math.pi)


class StepLoadedCrack:
    """Lengths over c_d t, displacements over s_0 t/(rho c_d)."""

    def __init__(self, nu):
        self.a, self.b = 1.0, math.sqrt(2 * (1 - nu) / (1 - 2 * nu))
        self.c = self.b / rayleigh(nu)
        kappa = 2 * (self.b ** 2 - 1)
        s_at_0 = self.b ** 2 / (math.sqrt(kappa) * self.c)
        self.factor = self.b ** 4 / (kappa * self.c * s_at_0 * math.pi)

    def _theta(self, h):
        a, b = self.a, self.b
        if h >= b:
            return 0.0
        return math.atan2(4 * h * h * math.sqrt(max((h * h - a * a) * (b * b - h * h), 0.0)), (b * b - 2 * h * h) ** 2)

    def _log_s(self, z):
        a, b = self.a, self.b
        if z >= b:
            return -integral(lambda h: self._theta(h) / (h - z), a, b) / math.pi
        t = self._theta(z)
        rest = lambda h: (self._theta(h) - t) / (h - z) if h != z else 0.0
        return -(integral(rest, a, z) + integral(rest, z, b) + t * math.log((b - z) / (z - a))) / math.pi

    def _density(self, z):
        """(c - z) Im U(z) / pi."""
        return self.factor * math.sqrt(z - self.a) * math.cos(self._theta(z)) / (z * math.exp(self._log_s(z)))

    def displacement(self, reach):
        """Of the upper face at r = c_d t / reach from the tip; the opening is twice that."""
        a, b, c = self.a, self.b, self.c
        if reach <= a * (1 + 1e-9):   # what has just left the tip is too small to integrate
            return 1.0
        f = lambda z: (reach - z) * self._density(z) / (c - z)
        total = integral(f, a, min(b, reach))
        if b < reach <= c:
            total += integral(f, b, reach)
        elif reach > c:
            d = min(c - b, reach - c)   # the principal value: in pairs about c
            total += integral(lambda h: f(c - h) + f(c + h), 1e-13, d)
            if c - d > b:
                total += integral(f, b, c - d)
            low = c + d
            while low < reach:
                high = min(reach, c + 4 * (low - c))
                total += integral(f, low, high)
                low = high
        return 1 + total / reach

    def _transform(self, z):
        """U(z), of the face's displacement, for complex z; transforms of the length and time used here."""
        a, b, c = self.a, self.b, self.c
        log_s = -integral(lambda h: self._theta(h) / (h - z), a, b) / math.pi
        # U(z) = -b^2 F+(0) F-(z)/(mu kappa z), of which `factor` is what lies before sqrt(z - a)/(...).
        return -math.pi * self.factor * cmath.sqrt(a - z) / (z * (c - z) * cmath.exp(log_s))

    def velocity_ahead(self, x, y, t, parts=60):
        """(v_x, v_y) over s_0/(rho c_d) at a point with x, y > 0 seen from the tip, c_d = 1."""
        a, b = self.a, self.b
        r2 = x * x + y * y
        r, total = math.sqrt(r2), [0.0, 0.0]
        for slowness, wave in ((a, self._longitudinal), (b, self._shear)):
            start = slowness * r
            if t <= start:
                continue
            # t = start cosh(q) takes the root out of dz/dt at the front
            end = math.acosh(t / start)
            for k in range(parts):
                q = end * (k + 0.5) / parts
                z = start * complex(-x * math.cosh(q), y * math.sinh(q)) / r2
                dz = start * complex(-x * math.sinh(q), y * math.cosh(q)) / r2
                gx, gy = wave(z)
                total[0] += (gx * dz).imag * end / parts / math.pi
                total[1] += (gy * dz).imag * end / parts / math.pi
        return tuple(total)

    def _longitudinal(self, z):
        alpha, b2 = cmath.sqrt(self.a ** 2 - z * z), self.b ** 2
        p = -(b2 - 2 * z * z) * self._transform(z) / (alpha * b2)
        return z * p, -alpha * p

    def _shear(self, z):
        q = -2 * z * self._transform(z) / self.b ** 2
        return -cmath.sqrt(self.b ** 2 - z * z) * q, -z * q
