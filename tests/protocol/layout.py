"""The values that frames carry for a page, by section 7 of docs/protocol.md."""

import numpy as np

from wire import morton_key

VERTICES, CORNERS = 0, 1
OFFSETS = np.array([(a & 1, a >> 1 & 1, a >> 2) for a in range(8)])


def or_the_one_before(predictors):
    """A value without predictors has the value before it; the first has none."""
    return [tuple(sorted(found)) or ((index - 1,) if index else ())
            for index, found in enumerate(predictors)]


def vertex_predictors(page):
    """The predictors of a vertex are the earlier vertices of its triangles."""
    earlier = [set() for _ in page.positions]
    for triangle in page.triangles.tolist():
        for vertex in triangle:
            earlier[vertex].update(other for other in triangle if other < vertex)
    return or_the_one_before(earlier)


class Layout:
    """The values of a page in frames of one kind, and the predictors of each. `shift`: bits of a
    position below its cell."""

    def __init__(self, page, shift, kind):
        self.kind = kind
        if kind == VERTICES:
            self.predictors = vertex_predictors(page)
            return
        cells = page.positions.astype(np.int64) >> shift
        places = (cells[:, None, :] + OFFSETS).reshape(-1, 3)
        _, first, index = np.unique(morton_key(places), return_index=True, return_inverse=True)
        self.corners = places[first]
        self.of_vertex = index.reshape(-1, 8)
        local = ((page.positions.astype(np.int64) & ((1 << shift) - 1)) + 0.5) / (1 << shift)
        self.weights = np.prod(np.where(OFFSETS == 1, local[:, None, :], 1 - local[:, None, :]),
                               axis=2)
        self.predictors = self._corner_predictors()

    def _corner_predictors(self):
        index_of = {tuple(corner): index for index, corner in enumerate(self.corners.tolist())}
        down = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return or_the_one_before(
            [index_of[below] for below in ((i - x, j - y, k - z) for x, y, z in down)
             if below in index_of] for i, j, k in self.corners.tolist())

    def at_vertices(self, displacements):
        """Returns the displacement of each vertex from those of the values."""
        if self.kind == VERTICES:
            return displacements
        return np.einsum("va,vax->vx", self.weights, displacements[self.of_vertex])
