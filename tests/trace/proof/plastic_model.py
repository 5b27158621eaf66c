#!/usr/bin/env python3
"""Computes plastic by the published formulas of Mitsuba 3's `plastic` and `roughplastic`, independently of Candela's code.

    python3 tests/trace/proof/plastic_model.py

Prints the reflectance for diffuse light from the inside, transmittances, and values of f, which plastic_test.cpp here and in
tests/scene states. Normals are integrated over their two angles, and the density of visible normals has its exact
normalisation, while Candela integrates over slopes and divides by the integral. It needs NumPy and takes some minutes.
"""
import math

import numpy as np

POLYPROPYLENE_IN_AIR = 1.49 / 1.000277
NODES = 64
POLAR_NODES = 1200
AZIMUTHS = 600
BOUNDARIES = [("smooth", 0), ("ggx", 0.1), ("beckmann", 0.1), ("ggx", 0.3), ("beckmann", 0.5)]
# Cosines of wo and wi, turn between their azimuths, base colour, specular colour, nonlinear.
QUERIES = [(0.9, 0.8, 0.45, 0.5, 1, False), (0.6, 0.7, 0.5, 0.5, 1, True), (0.3, 0.35, 0.52, 0.2, 0.7, False),
           (0.12, 0.5, 0.3, 0.8, 1, True)]


def fresnel(cosine, n):
    """The reflectance, and the cosine beyond the boundary, of a medium that is n times as dense as that of the light."""
    squared_sine = (1 - cosine * cosine) / (n * n)
    beyond = np.sqrt(np.maximum(0, 1 - squared_sine))
    across = (cosine - n * beyond) / (cosine + n * beyond)
    along = (n * cosine - beyond) / (n * cosine + beyond)
    return np.where(squared_sine >= 1, 1.0, (across * across + along * along) / 2), beyond


class Microfacets:
    """A distribution of normals with Smith's masking."""

    def __init__(self, kind, alpha):
        self.kind, self.alpha = kind, alpha

    def slope(self, cosine):
        return self.alpha * np.sqrt(np.maximum(0, 1 - cosine * cosine)) / cosine

    def masking(self, cosine):
        """As Mitsuba computes it: for Beckmann, a rational approximation."""
        slope = self.slope(cosine)
        if self.kind == "ggx":
            return 2 / (1 + np.sqrt(1 + slope * slope))
        a = 1 / np.maximum(slope, 1e-30)
        return np.where(a >= 1.6, 1.0, (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a))

    def exact_masking(self, cosine):
        if self.kind == "ggx":
            return float(self.masking(np.array(cosine)))
        slope = float(self.slope(np.array(cosine)))
        if slope < 0.05:
            return 1
        a = 1 / slope
        return 2 / (1 + math.erf(a) + math.exp(-a * a) / (a * math.sqrt(math.pi)))

    def density(self, cosine):
        scaled = (1 - cosine * cosine) / (cosine * self.alpha) ** 2
        shape = np.exp(-scaled) if self.kind == "beckmann" else 1 / (1 + scaled) ** 2
        return shape / (math.pi * self.alpha ** 2 * cosine ** 4)

    def mean_over_visible(self, cosine, value):
        """The mean of value(w.m, m.z) over the normals m that are visible from a direction w with this cosine."""
        nodes, weights = np.polynomial.legendre.leggauss(POLAR_NODES)
        root = (nodes + 1) / 2
        polar, weights = math.pi / 2 * root * root, weights / 2 * math.pi * root
        azimuth = (np.arange(AZIMUTHS) + 0.5) * math.pi / AZIMUTHS
        z, sine = np.cos(polar)[:, None], np.sin(polar)[:, None]
        projected = cosine * z + math.sqrt(1 - cosine * cosine) * sine * np.cos(azimuth)[None, :]
        values = value(np.clip(projected, 1e-12, 1), z)
        total = (self.density(z) * sine * np.maximum(projected, 0) * values * weights[:, None]).sum()
        return float(total) * 2 * math.pi / AZIMUTHS * self.exact_masking(cosine) / cosine

    def transmittance(self, cosine, n):
        def value(projected, z):
            reflectance, beyond = fresnel(projected, n)
            refracted = (projected / n - beyond) * z - cosine / n
            return np.where(refracted < 0, (1 - reflectance) * self.masking(np.maximum(-refracted, 1e-9)), 0)

        return self.mean_over_visible(cosine, value)

    def reflectance(self, cosine, n):
        def value(projected, z):
            reflected = 2 * projected * z - cosine
            return np.where(reflected > 0, fresnel(projected, n)[0] * self.masking(np.maximum(reflected, 1e-9)), 0)

        return self.mean_over_visible(cosine, value)


class Plastic:
    """The model, for grey colours."""

    def __init__(self, kind, alpha, n):
        self.is_smooth, self.n, self.facets = kind == "smooth", n, Microfacets(kind, alpha)
        if self.is_smooth:
            self.internal = -1.4399 / n ** 2 + 0.7099 / n + 0.6681 + 0.0636 * n
            return
        cosines = [max(1e-6, i / (NODES - 1)) for i in range(NODES)]
        self.transmittances = [self.facets.transmittance(cosine, n) for cosine in cosines]
        self.internal = sum(2 * c * self.facets.reflectance(c, 1 / n) for c in cosines) / NODES

    def transmittance(self, cosine):
        if self.is_smooth:
            return 1 - float(fresnel(np.array(cosine), self.n)[0])
        position = cosine * (NODES - 1)
        node = min(int(position), NODES - 2)
        low, high = self.transmittances[node], self.transmittances[node + 1]
        return low + (high - low) * (position - node)

    def f(self, wo, wi, base, specular, nonlinear):
        both = self.transmittance(wo[2]) * self.transmittance(wi[2])
        diffuse = base / (1 - (base if nonlinear else 1) * self.internal) * both / (math.pi * self.n ** 2)
        if self.is_smooth:
            return diffuse
        h = (wo + wi) / np.linalg.norm(wo + wi)
        shape = self.facets.density(h[2]) * self.facets.masking(wo[2]) * self.facets.masking(wi[2])
        return diffuse + specular * float(fresnel(wo @ h, self.n)[0] * shape / (4 * wo[2] * wi[2]))


def direction(cosine, turn):
    sine, azimuth = math.sqrt(1 - cosine * cosine), 2 * math.pi * turn
    return np.array([sine * math.cos(azimuth), sine * math.sin(azimuth), cosine])


def main():
    for kind, alpha in BOUNDARIES:
        plastic = Plastic(kind, alpha, POLYPROPYLENE_IN_AIR)
        nodes = " ".join(f"{plastic.transmittance(i / (NODES - 1)):.5f}" for i in (0, 1, 5, 20, 40, 63))
        print(f"{kind} {alpha}: internal reflectance {plastic.internal:.6f}, transmittances {nodes}")
        for cos_o, cos_i, turn, base, specular, nonlinear in QUERIES:
            f = plastic.f(direction(cos_o, 0.1), direction(cos_i, 0.1 + turn), base, specular, nonlinear)
            print(f"  {cos_o} {cos_i} {turn} {base} {specular} {nonlinear}: {f:.9g}")


if __name__ == "__main__":
    main()
