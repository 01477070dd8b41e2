"""The layout of a view's frames, by section 7 of docs/protocol.md."""

import numpy as np

from wire import morton_key, morton_point, xxh3

TILE_VALUES = 2048
NONE = TILE_VALUES  # of a predictor: means 0
COEFFICIENTS, VERTICES = 0, 1


class Layout:
    """The values that the frames of a view carry, and the predictors of each."""

    def __init__(self, view, content):
        self.content = content
        if content == COEFFICIENTS:
            largest = np.zeros(len(view.corners), np.float32)
            home = view.homes >= 0
            np.maximum.at(largest, view.cell_corners[view.homes[home]], view.weights()[home])
            self.source = np.flatnonzero(largest > 0).astype("<i4")
            places = morton_point(view.corners[self.source])
            tiles = [self._grid_predictors(places[begin:begin + TILE_VALUES])
                     for begin in range(0, len(places), TILE_VALUES)]
            self.predictors = np.concatenate(tiles) if tiles else np.empty((0, 3), "<u2")
        else:
            vertices = np.flatnonzero(view.homes >= 0)
            within = np.minimum((view.locals[vertices] * np.float32(256)).astype(np.int64), 255)
            order = np.lexsort((vertices, morton_key(within), view.homes[vertices]))
            self.source = vertices[order].astype("<i4")
            self.predictors = np.full((len(order), 3), NONE, "<u2")
            index = np.arange(len(order)) % TILE_VALUES
            self.predictors[index > 0, 0] = index[index > 0] - 1
        self.fingerprint = xxh3(self.predictors.tobytes(),
                                seed=xxh3(self.source.tobytes(), seed=content))

    @staticmethod
    def _grid_predictors(places):
        index_of = {tuple(place): index for index, place in enumerate(places)}
        predictors = np.full((len(places), 3), NONE, "<u2")
        for index, (i, j, k) in enumerate(places):
            def at(x, y, z):
                return index_of.get((i - x, j - y, k - z), NONE)
            along = at(1, 0, 0), at(0, 1, 0), at(0, 0, 1)
            squares = [(along[0], along[1], at(1, 1, 0)), (along[0], along[2], at(1, 0, 1)),
                       (along[1], along[2], at(0, 1, 1))]
            whole = [square for square in squares if NONE not in square]
            alone = [one for one in along if one != NONE] + [index - 1 if index else NONE]
            predictors[index] = whole[0] if whole else (alone[0], NONE, NONE)
        return predictors

    @property
    def tile_sizes(self):
        count = len(self.source)
        return [min(TILE_VALUES, count - begin) for begin in range(0, count, TILE_VALUES)]
