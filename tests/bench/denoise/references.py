"""The two filters of normals that newer methods are measured by, after their papers, in NumPy.

Bilateral: Zheng, Fu, Au, Tai 2011, local and iterative. Guided: Zhang, Deng, Zhang, Bouaziz, Liu
2015. Vertices follow the normals as Sun, Rosin, Martin, Langbein 2007 do. A triangle's neighbours
are those that share a vertex with it.
"""

import functools

import numpy as np

CHUNK = 4096  # rings at a time
VERTEX_UPDATES = 20  # after filtering
GUIDED_UPDATES = 10  # in each round


class Rings:
    """Who is whose neighbour among triangles; each is its own neighbour too."""

    def __init__(self, triangles):
        self.triangles = triangles
        count = len(triangles)
        order = np.argsort(triangles.ravel(), kind="stable")
        fans = np.split(order // 3, np.cumsum(np.bincount(triangles.ravel()))[:-1])
        keys = [np.unique((fan[:, None] * count + fan).ravel()) for fan in fans if len(fan)]
        pairs = np.unique(np.concatenate(keys))
        self.one, self.other = pairs // count, pairs % count
        sizes = np.bincount(self.one, minlength=count)
        starts = np.cumsum(sizes) - sizes
        self.place = np.arange(len(pairs)) - starts[self.one]  # within the ring
        self.rows = np.full((count, sizes.max()), -1)
        self.rows[self.one, self.place] = self.other

    @functools.cache
    def pairs(self, begin):
        """Returns, for a chunk of rings, which two places have a triangle."""
        there = self.rows[begin:begin + CHUNK] >= 0
        return there[:, :, None] & there[:, None, :]

    @functools.cache
    def sides(self, begin):
        """Returns, for a chunk of rings, which two of its triangles have a common side."""
        corners = self.triangles[self.rows[begin:begin + CHUNK]]
        shared = sum((corners[:, :, None, i] == corners[:, None, :, j]).astype(np.uint8)
                     for i in range(3) for j in range(3))
        return (shared == 2) & self.pairs(begin)

    def sum(self, values):
        """Sums values of pairs, n x 3, over each triangle's ring."""
        return sums_at(self.one, values, len(self.triangles))


def sums_at(index, values, count):
    return np.column_stack([np.bincount(index, column, count) for column in values.T])


def unit(vectors):
    return vectors / np.maximum(np.linalg.norm(vectors, axis=1, keepdims=True), 1e-300)


def measure(points, triangles):
    """Returns centres, unit normals and areas."""
    a, b, c = (points[triangles[:, i]] for i in range(3))
    doubled = np.cross(b - a, c - a)
    return (a + b + c) / 3, unit(doubled), np.linalg.norm(doubled, axis=1) / 2


def follow(points, triangles, normals, updates):
    """Moves vertices towards planes with these normals (Sun 2007)."""
    corners = triangles.ravel()
    degree = np.maximum(np.bincount(corners, minlength=len(points)), 1)[:, None]
    of_corner = np.repeat(normals, 3, axis=0)
    for _ in range(updates):
        centres = np.repeat(points[triangles].mean(axis=1), 3, axis=0)
        away = ((centres - points[corners]) * of_corner).sum(axis=1, keepdims=True)
        points = points + sums_at(corners, away * of_corner, len(points)) / degree
    return points


def nearness(rings, centres, areas, reach):
    between = np.linalg.norm(centres[rings.one] - centres[rings.other], axis=1)
    width = reach * between[between > 0].mean()
    return areas[rings.other] * np.exp(-between**2 / (2 * width**2))


def filtered(rings, normals, guides, near, sigma):
    apart = ((guides[rings.one] - guides[rings.other]) ** 2).sum(axis=1)
    weights = near * np.exp(-apart / (2 * sigma**2))
    return unit(rings.sum(weights[:, None] * normals[rings.other]))


def bilateral(shape):
    rings = Rings(shape.triangles)
    centres, noisy, areas = measure(shape.points, shape.triangles)
    near = nearness(rings, centres, areas, 1)
    for sigma in (0.2, 0.3, 0.4, 0.5):
        normals = noisy
        for done in range(1, 21):
            normals = filtered(rings, normals, normals, near, sigma)
            if done in (1, 2, 5, 10, 20):
                moved = follow(shape.points, shape.triangles, normals, VERTEX_UPDATES)
                yield f"σ {sigma:g}, {done}", moved


def unevenness(rings, normals):
    """Returns H of each ring (Zhang 2015): its widest difference of normals, times the
    share of the sharpest step in all steps."""
    uneven = np.empty(len(normals))
    normals = normals.astype(np.float32)
    for begin in range(0, len(normals), CHUNK):
        rows = rings.rows[begin:begin + CHUNK]
        of_ring = normals[rows]
        cosines = of_ring @ of_ring.transpose(0, 2, 1)
        apart = np.sqrt(np.maximum(2 - 2 * cosines, 0)) * rings.pairs(begin)
        steps = apart * rings.sides(begin)
        uneven[begin:begin + CHUNK] = apart.max(axis=(1, 2)) * (
            steps.max(axis=(1, 2)) / (steps.sum(axis=(1, 2)) / 2 + 1e-9))
    return uneven


def guides_of(rings, normals, areas):
    """Returns, for each triangle, the mean normal of the most even ring that has it."""
    means = unit(rings.sum(areas[rings.other, None] * normals[rings.other]))
    uneven = np.append(unevenness(rings, normals), np.inf)
    best = rings.rows[np.arange(len(rings.rows)), uneven[rings.rows].argmin(axis=1)]
    return means[best]


def guided(shape):
    rings = Rings(shape.triangles)
    for sigma in (0.2, 0.3, 0.4):
        points = shape.points
        for done in range(1, 21):
            centres, normals, areas = measure(points, shape.triangles)
            guides = guides_of(rings, normals, areas)
            near = nearness(rings, centres, areas, 2)
            normals = filtered(rings, normals, guides, near, sigma)
            points = follow(points, shape.triangles, normals, GUIDED_UPDATES)
            if done in (1, 2, 5, 10, 20):
                yield f"σ {sigma:g}, {done}", points
