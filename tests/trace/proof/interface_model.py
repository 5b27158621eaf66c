#!/usr/bin/env python3
"""Computes single interfaces by the model of Mitsuba 3's `roughconductor` and `roughdielectric`, independently of Candela's code.

    python3 tests/trace/proof/interface_model.py

Prints values of f, which interface_test.cpp states. Every facet reflects or refracts by vectors, and the solid angle of
facets for that of directions is a numerical derivative, while Candela has the closed forms of Walter et al. It needs NumPy.
"""
import math

import numpy as np

GOLD_RED, GOLD_BLUE = complex(0.143, 3.983), complex(1.442, 1.603)
STEP = 1e-5


def fresnel(cosine, n):
    """The reflectance of a medium of complex index n relative to that of the light, for unpolarised light."""
    beyond = np.sqrt(complex(1) - (1 - cosine * cosine) / n ** 2)
    if isinstance(n, float) and (1 - cosine * cosine) / n ** 2 >= 1:
        return 1.0
    across = (cosine - n * beyond) / (cosine + n * beyond)
    along = (n * cosine - beyond) / (n * cosine + beyond)
    return (abs(across) ** 2 + abs(along) ** 2) / 2


class Facets:
    def __init__(self, kind, alpha_u, alpha_v):
        self.kind, self.alpha = kind, np.array([alpha_u, alpha_v])

    def density(self, h):
        slope = -h[:2] / h[2]
        scaled = float(((slope / self.alpha) ** 2).sum())
        shape = math.exp(-scaled) if self.kind == "beckmann" else 1 / (1 + scaled) ** 2
        return shape / (math.pi * self.alpha.prod()) / h[2] ** 4

    def masking(self, w):
        azimuth = math.atan2(w[1], w[0])
        alpha = math.hypot(self.alpha[0] * math.cos(azimuth), self.alpha[1] * math.sin(azimuth))
        a = 1 / (alpha * math.tan(math.acos(abs(w[2]))))
        if self.kind == "ggx":
            return 1 / (1 + (math.sqrt(1 + 1 / a ** 2) - 1) / 2)
        return 1.0 if a >= 1.6 else (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a)


def reflect(wo, h):
    return 2 * (wo @ h) * h - wo


def refract(wo, h, n):
    across = (wo - (wo @ h) * h) / n
    return -across - math.sqrt(1 - across @ across) * h


def unit(v):
    return v / np.linalg.norm(v)


def facets_per_direction(h, scatter):
    """The solid angle of facets divided by that of the directions to which they scatter light."""
    a = unit(np.cross(h, [0.3, 0.5, 0.8]))
    b = np.cross(h, a)
    edges = [(scatter(unit(h + STEP * t)) - scatter(unit(h - STEP * t))) / (2 * STEP) for t in (a, b)]
    return 1 / np.linalg.norm(np.cross(*edges))


def value(facets, wo, wi, n, is_metal):
    """f of an interface whose far side has the index n relative to that of wo."""
    is_reflected = wi[2] > 0
    h = unit(wo + wi) if is_reflected else unit(wo + n * wi)
    h = h if h[2] > 0 else -h
    if wo @ h <= 0 or (not is_reflected and wi @ h >= 0):
        return 0.0
    reflectance = fresnel(wo @ h, n)
    fraction = reflectance if is_metal or is_reflected else 1 - reflectance
    scatter = (lambda m: reflect(wo, m)) if is_reflected else (lambda m: refract(wo, m, n))
    assert np.allclose(scatter(h), wi)
    weight = facets.density(h) * facets.masking(wo) * facets.masking(wi) * (wo @ h)
    return fraction * weight * facets_per_direction(h, scatter) / abs(wo[2] * wi[2])


def direction(cosine, turn):
    sine, azimuth = math.sqrt(1 - cosine * cosine), 2 * math.pi * turn
    return np.array([sine * math.cos(azimuth), sine * math.sin(azimuth), cosine])


# Kind, alphas, cosines of wo and wi, turn between their azimuths.
REFLECTIONS = [("ggx", 0.3, 0.3, 0.9, 0.7, 0.45), ("ggx", 0.4, 0.1, 0.6, 0.65, 0.47), ("beckmann", 0.2, 0.2, 0.6, 0.5, 0.52),
               ("beckmann", 0.5, 0.15, 0.25, 0.4, 0.48)]
# The same, with the cosines outside and inside of glass.
REFRACTIONS = [("ggx", 0.3, 0.3, 0.9, -0.95, 0.45), ("ggx", 0.4, 0.1, 0.75, -0.9, 0.51), ("beckmann", 0.2, 0.2, 0.4, -0.8, 0.48),
               ("beckmann", 0.5, 0.15, 0.6, -0.95, 0.46)]


def main():
    for kind, alpha_u, alpha_v, cos_o, cos_i, turn in REFLECTIONS:
        facets, wo, wi = Facets(kind, alpha_u, alpha_v), direction(cos_o, 0.1), direction(cos_i, 0.1 + turn)
        metal = [value(facets, wo, wi, n, True) for n in (GOLD_RED, GOLD_BLUE)]
        glass = [value(facets, wo, wi, n, False) for n in (1.5, 1 / 1.5)]
        print(f"{kind} {alpha_u} {alpha_v} {cos_o} {cos_i} {turn}:", " ".join(f"{f:.9g}" for f in metal + glass))
    for kind, alpha_u, alpha_v, cos_o, cos_i, turn in REFRACTIONS:
        facets, wo, wi = Facets(kind, alpha_u, alpha_v), direction(cos_o, 0.1), direction(cos_i, 0.1 + turn)
        entering, leaving = value(facets, wo, wi, 1.5, False), value(facets, -wi, -wo, 1 / 1.5, False)
        print(f"{kind} {alpha_u} {alpha_v} {cos_o} {cos_i} {turn}: {entering:.9g} {leaving:.9g}")


if __name__ == "__main__":
    main()
