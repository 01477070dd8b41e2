"""Pages, decoded as docs/protocol.md says in section 6. Arrays are NumPy's, a row per element."""

import dataclasses
import struct

import numpy as np

from wire import checksum, decompress, require, unzigzag


@dataclasses.dataclass
class Page:
    number: int
    border: int                 # so many of the first vertices are on the border
    positions: np.ndarray       # n x 3 integers
    triangles: np.ndarray       # n x 3, patch by patch
    patches: list               # (finer page, triangles)
    normals: np.ndarray         # of the border, or of all
    colours: np.ndarray         # n x 4 bytes, or empty


@dataclasses.dataclass
class Head:
    bits: int            # Q
    origin: np.ndarray   # the scan's units
    side: float
    level_pages: list    # level 0 first
    fingerprint: int     # its checksum

    @property
    def page_count(self):
        return sum(self.level_pages)

    def places(self, positions):
        """Returns what positions mean, in the scan's units."""
        return self.origin + (positions + 0.5) * (self.side / (1 << self.bits))


def read_head(data):
    require(data[:4] == b"BnPh" and data[4] == 1, "not a head of version 1")
    bits, levels = data[5], data[6]
    numbers = struct.unpack_from("<4d4QQ", data, 8)
    require(numbers[-1] == checksum(data, 80), "the head's checksum is wrong")
    return Head(bits, np.array(numbers[:3]), numbers[3],
                list(struct.unpack_from(f"<{levels}I", data, 80)), numbers[-1])


@dataclasses.dataclass
class Edge:
    start: int
    end: int
    apex: int
    patch: int
    before: "Edge" = None
    after: "Edge" = None
    is_open: bool = True


def join(before, after):
    before.after, after.before = after, before


class Walk:
    """The triangles, the patches and the predictors of new vertices, in the order of the walk."""

    def __init__(self, steps, vertices, turns, patches):
        self.triangles, self.patches, self.origins = [], [], []
        self.edges, self.newest = [], {}
        self.vertices, self.turns, self.names = iter(vertices), iter(turns), iter(patches)
        current = 0
        for step in steps:
            while current < len(self.edges) and not self.edges[current].is_open:
                current += 1
            if current == len(self.edges):
                self.start(step)
            else:
                self.step(self.edges[current], step)

    def named(self):
        return len(self.origins) - 1 - next(self.vertices)

    def new(self, *origin):
        self.origins.append(origin)
        return len(self.origins) - 1

    def add(self, triangle, patch):
        self.triangles.append(triangle)
        self.patches.append(next(self.names) if next(self.turns) else patch)
        return self.patches[-1]

    def edge(self, start, end, apex, patch):
        self.edges.append(Edge(start, end, apex, patch))
        self.newest[start] = self.edges[-1]
        return self.edges[-1]

    def start(self, step):
        require(8 <= step < 16, "a start is needed")
        corners = []
        for bit in range(3):
            before = max(len(self.origins) - 1, 0)
            corners.append(self.named() if step >> bit & 1 else self.new(before, before, before))
        a, b, c = corners
        patch = self.add((a, b, c), self.patches[-1] if self.patches else 0)
        ring = [self.edge(a, b, c, patch), self.edge(b, c, a, patch), self.edge(c, a, b, patch)]
        for k in range(3):
            join(ring[k], ring[(k + 1) % 3])

    def step(self, edge, step):
        require(step <= 4, "no start is needed")
        if step == 3:
            edge.is_open = False
            return
        w = [lambda: self.new(edge.start, edge.end, edge.apex), lambda: edge.before.start,
             lambda: edge.after.end, None, self.named][step]()
        patch = self.add((edge.end, edge.start, w), edge.patch)
        before, after = edge.before, edge.after
        keeps_before, keeps_after = before.start != w, after.end != w
        cut = self.newest.get(w)
        edge.is_open = False
        left, right = before, after
        if keeps_before:
            left = self.edge(edge.start, w, edge.end, patch)
            join(before, left)
        else:
            before.is_open = False
            left = before.before
        if keeps_after:
            right = self.edge(w, edge.end, edge.start, patch)
            join(right, after)
        else:
            after.is_open = False
            right = after.after
        if keeps_before and keeps_after and cut is not None and cut.is_open:
            join(cut.before, right)
            right = cut
        join(left, right)


def bits(data, count):
    return np.unpackbits(data, bitorder="little")[:count]


def numbers(data, planes):
    """Of byte planes."""
    words = np.zeros((len(data) // max(planes, 1), 4), np.uint8)
    words[:, :planes] = data.reshape(planes, -1).T
    return words.view("<u4")[:, 0]


def read_positions(residuals, first, origins):
    positions = np.zeros((len(origins), 3), np.uint32)
    for v, (a, b, c) in enumerate(origins):
        prediction = first if v == 0 else positions[a] + positions[b] - positions[c]
        positions[v] = prediction + residuals[:, v]
    return positions


def folded(u, v, one):
    return (abs(v) - one if u < 0 else one - abs(v)), (abs(u) - one if v < 0 else one - abs(u))


def predicted_codes(triangles, positions):
    sums = [[0, 0, 0] for _ in positions]
    places = positions.astype(object)  # of any size
    for triangle in triangles:
        p0, p1, p2 = (places[v] for v in triangle)
        a, b = p1 - p0, p2 - p0
        cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
        for v in triangle:
            sums[v] = [one + other for one, other in zip(sums[v], cross)]
    codes = []
    for part in sums:
        shift = max(0, int(sum(map(abs, part))).bit_length() - 21)
        x, y, z = (int(value) >> shift for value in part)
        size = abs(x) + abs(y) + abs(z)
        u, v = (int(np.sign(value)) * (127 * abs(value) // size) if size else 0 for value in (x, y))
        codes.append(folded(u, v, 127) if z < 0 else (u, v))
    return np.array(codes)


def normals_of(codes):
    normals = []
    for u, v in codes / 127:
        z = 1 - abs(u) - abs(v)
        normal = np.array((*(folded(u, v, 1) if z < 0 else (u, v)), z))
        normals.append(normal / np.linalg.norm(normal))
    return np.array(normals).reshape(-1, 3)


def read_colours(planes, origins):
    green = planes[0]
    residuals = np.stack([planes[1] + green, green, planes[2] + green, planes[3]], axis=1)
    colours = np.zeros((len(origins), 4), np.uint8)
    for v, (a, b, _) in enumerate(origins):
        mean = (colours[a].astype(int) + colours[b]) // 2 if v else 0
        colours[v] = (mean + residuals[v]) & 255
    return colours


def read_page(data):
    require(data[:4] == b"BnPg" and data[4] == 1, "not a page of version 1")
    (flags, planes, zero, number, vertices, triangles, border, patches, steps, named_vertices,
     named_patches, zero16, *first, check) = struct.unpack_from("<3BI8H3IQ", data, 5)
    require(check == checksum(data, 48), "the page's checksum is wrong")
    require(zero == 0 and zero16 == 0 and flags < 4, "reserved bits are set")
    normals = vertices if flags & 1 else border
    sizes = [4 * patches, (steps + 1) // 2, 2 * named_vertices,
             (triangles + 7) // 8 if patches > 1 else 0, 2 * named_patches, (vertices + 7) // 8,
             3 * planes * vertices, 2 * normals, 4 * vertices if flags & 2 else 0]
    body = np.frombuffer(decompress(data[48:], sum(sizes)), np.uint8)
    finer, step, named, turn, patch, is_border, place, code, colour = np.split(
        body, np.cumsum(sizes)[:-1])

    walk = Walk(np.stack([step & 15, step >> 4], axis=1).ravel()[:steps].tolist(),
                numbers(named, 2).tolist(),
                bits(turn, triangles).tolist() if patches > 1 else [0] * triangles,
                numbers(patch, 2).tolist())
    require(len(walk.origins) == vertices and len(walk.triangles) == triangles, "the walk ends early")
    residuals = unzigzag(numbers(place, planes)).reshape(3, -1) if planes else np.zeros(
        (3, vertices), np.uint32)
    positions = read_positions(residuals, np.array(first, np.uint32), walk.origins)
    is_border = bits(is_border, vertices).astype(bool)
    has_normal = np.ones(vertices, bool) if flags & 1 else is_border
    codes = (predicted_codes(walk.triangles, positions)[has_normal]
             + unzigzag(code).reshape(2, -1).T).astype(np.uint8).view(np.int8)

    order = np.argsort(~is_border, kind="stable")
    number_of = np.argsort(order)
    by_patch = np.argsort(walk.patches, kind="stable")
    coded_order = np.argsort(~is_border[has_normal], kind="stable")
    return Page(number=number, border=int(is_border.sum()), positions=positions[order],
                triangles=number_of[np.array(walk.triangles)[by_patch]],
                patches=list(zip(np.cumsum(numbers(finer, 4), dtype=np.uint32).tolist(),
                                 np.bincount(walk.patches, minlength=patches).tolist())),
                normals=normals_of(codes.astype(int))[coded_order],
                colours=read_colours(colour.reshape(4, -1), walk.origins)[order]
                if flags & 2 else np.zeros((0, 4), np.uint8))
