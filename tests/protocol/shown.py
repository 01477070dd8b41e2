"""Pages that a client has, and where frames move them (docs/protocol.md, sections 6 and 7)."""

import numpy as np

from burnish.formats.frames import FrameDecoder
from burnish.formats.layout import Layout


class Scan:
    """The pages of a session's scan, as far as they are fetched."""

    def __init__(self, client, session):
        self._client, self._id = client, session.scan_id
        self.depth = session.depth
        self.head = client.describe_pages(session.scan_id)
        self.pages = {}

    @property
    def cell_size(self):
        return self.head.side / (1 << self.depth)

    @property
    def level_0(self):
        """The numbers of the pages that are the scan itself."""
        return list(range(self.head.level_pages[0]))

    def fetch(self, numbers):
        missing = [number for number in numbers if number not in self.pages]
        self.pages.update(self._client.fetch_pages(self._id, missing))

    def layout(self, number, kind):
        return Layout(self.pages[number], self.head.bits - self.depth, kind)

    def decoder(self):
        return FrameDecoder(self.layout)

    def cells(self, number):
        """Returns the cell of each vertex of a page."""
        return self.pages[number].positions.astype(np.int64) >> (self.head.bits - self.depth)


def match(places, vertices, step):
    """Returns for each place the index of the vertex that is at most one step away on each axis."""
    def key(points):
        return [tuple(point) for point in np.floor(points / (4 * step)).astype(np.int64)]
    index_of = {}
    for shift in np.array([(a & 1, a >> 1 & 1, a >> 2) for a in range(8)]) * 2 - 1:
        for index, bin_ in enumerate(key(vertices + shift * step)):
            index_of.setdefault(bin_, set()).add(index)
    found = []
    for place, bin_ in zip(places, key(places)):
        near = [index for index in index_of.get(bin_, ())
                if np.abs(vertices[index] - place).max() <= step]
        assert len(near) == 1, (place, near)
        found.append(near[0])
    return np.array(found)
