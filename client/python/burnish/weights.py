"""Values of vertices as edits of cells."""

from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt

from .cells import CellEdges, CellFields, CellProtection, CellTexture

SAMPLES_PER_CELL = 3
SAMPLES_MAX = 64
GAIN_MAX = 4
Floats = npt.NDArray[np.float64]


@dataclasses.dataclass(frozen=True)
class Weighed:
    """A surface on its grid: n vertices and m x 3 faces; the scan's units."""

    vertices: Floats
    faces: npt.NDArray[np.int64]
    origin: Floats
    cell_size: float

    def fields(self, beta: npt.ArrayLike, alpha: npt.ArrayLike) -> CellFields:
        """See Live.cell_fields()."""
        cells, (betas, alphas) = self._means(beta=beta, alpha=alpha)
        return CellFields(cells, alphas, alphas, betas)

    def edges(self, strength: npt.ArrayLike) -> CellEdges:
        """See Live.cell_edges()."""
        return CellEdges(*self._weights(strength, "strength"))

    def texture(self, gain: npt.ArrayLike) -> CellTexture:
        """See Live.cell_texture()."""
        return CellTexture(*self._weights(gain, "gain", GAIN_MAX))

    def protection(self, weights: npt.ArrayLike) -> CellProtection:
        """See Live.cell_protection()."""
        cells, means = self._weights(weights, "weights")
        return CellProtection(cells, means >= 0.5)

    def _weights(self, weights: npt.ArrayLike, name: str,
                 most: int = 1) -> tuple[npt.NDArray[np.int64], Floats]:
        values = _per_vertex(weights, len(self.vertices), name)
        wrong = values[(values < 0) | (values > most)]
        if wrong.size:
            raise ValueError(f"{name} has {wrong[0]:g}: each must be within 0 to {most}, or NaN")
        cells, (means,) = self._means(**{name: weights})
        return cells, means

    def _means(self, **of_vertices: npt.ArrayLike) -> tuple[npt.NDArray[np.int64], Floats]:
        """Returns the cells of the surface, and a row of their means for each of the values."""
        values = np.stack([_per_vertex(value, len(self.vertices), name)
                           for name, value in of_vertices.items()], axis=1)
        faces = self.faces[np.isfinite(values[self.faces]).all(axis=(1, 2))]
        if not len(faces):
            raise ValueError(f"{' and '.join(of_vertices)}: no triangle is without NaN, "
                             "1 at least must be")
        places, samples = _sample(self.vertices, values, faces, self.cell_size)
        cells, owner = _unique_rows(np.floor((places - self.origin) / self.cell_size).astype(np.int64))
        counts = np.bincount(owner, minlength=len(cells))
        sums = np.stack([np.bincount(owner, column, len(cells)) for column in samples.T], axis=1)
        used = values[faces]  # rounding must not put a mean beyond them: 10 is the most of a beta
        means = np.clip(sums / counts[:, None], used.min(axis=(0, 1)), used.max(axis=(0, 1)))
        return cells, means.T


def _per_vertex(values: npt.ArrayLike, count: int, name: str) -> Floats:
    array = np.asarray(values, np.float64)
    if array.ndim > 1 or array.size not in (1, count):
        raise ValueError(f"{name} has the shape {array.shape}: it must be ({count},), or one number")
    return np.broadcast_to(array, (count,))


def _sample(vertices: Floats, values: Floats, faces: npt.NDArray[np.int64],
            cell_size: float) -> tuple[Floats, Floats]:
    """Returns places within the triangles, some in each cell that they cross well, and their values."""
    corners = vertices[faces]
    longest = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    wanted = np.ceil(longest * SAMPLES_PER_CELL / cell_size)
    parts = 2 ** np.ceil(np.log2(np.clip(wanted, 1, SAMPLES_MAX))).astype(int)
    places, samples = [np.empty((0, 3))], [np.empty((0, values.shape[1]))]
    for count in np.unique(parts).tolist():
        weights = _inner_weights(count)
        chosen = parts == count
        places.append(np.einsum("sc,fcx->fsx", weights, corners[chosen]).reshape(-1, 3))
        samples.append(np.einsum("sc,fcx->fsx", weights, values[faces[chosen]]).reshape(-1, values.shape[1]))
    return np.concatenate(places), np.concatenate(samples)


def _inner_weights(parts: int) -> Floats:
    """Returns the barycentric weights of the middles of a triangle's parts, `parts` an edge. Middles
    are never on an edge: a place there may be in a cell that the surface only touches."""
    steps = [((i + 1 / 3) / parts, (j + 1 / 3) / parts) for i in range(parts) for j in range(parts - i)]
    return np.array([(a, b, 1 - a - b) for a, b in steps])


def _unique_rows(cells: npt.NDArray[np.int64]) -> tuple[npt.NDArray[np.int64], npt.NDArray[np.int64]]:
    """Returns the different rows, and for each row of `cells` the number of its own."""
    order = np.lexsort(cells.T)
    rising = cells[order]
    is_first = np.ones(len(cells), bool)
    is_first[1:] = (rising[1:] != rising[:-1]).any(axis=1)
    owner = np.empty(len(cells), np.int64)
    owner[order] = np.cumsum(is_first) - 1
    return rising[is_first], owner
