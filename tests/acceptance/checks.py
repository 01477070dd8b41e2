"""What must be true of a result."""

import dataclasses
import pathlib

import burnish
import numpy as np

EXACT_DISTANCE = 1e-5  # of the diagonal: the bar of exports
FRAME_CELLS = 1 / 64   # a live frame at rest


@dataclasses.dataclass
class Facts:
    """A scan, and what the checks need to know of it."""

    file: pathlib.Path
    mesh: burnish.Mesh
    diagonal: float
    rim: np.ndarray  # vertices of the surface's edges of exactly one triangle, by place
    path: np.ndarray  # points of a stroke, near the middle
    half: list[float]  # the matrix of a picture whose left half is the lower half of the scan
    side: np.ndarray  # where each vertex is in this picture, from -1 to 1
    is_closed: bool
    has_colours: bool

    @property
    def half_scale(self):
        """The picture's width of a length of 1 along the longest side."""
        return max(abs(x) for x in self.half[:3])


def facts_of(file):
    mesh = burnish.load_ply(file)
    used = np.unique(mesh.faces)
    box = mesh.vertices[used].max(0) - mesh.vertices[used].min(0)
    _, place = np.unique(mesh.vertices, axis=0, return_inverse=True)
    place = place.ravel()
    faces = _surface(place[mesh.faces])
    ways = np.concatenate([faces[:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
    edges, count = np.unique(np.sort(ways, 1), axis=0, return_counts=True)
    up, by_way = np.unique(np.sort(ways, 1)[ways[:, 0] < ways[:, 1]], axis=0, return_counts=True)
    turns = {tuple(e): n for e, n in zip(up.tolist(), by_way.tolist())}
    is_closed = all(2 * turns.get(tuple(e), 0) == n for e, n in zip(edges.tolist(), count.tolist()))
    on_rim = np.zeros(place.max() + 1, bool)
    on_rim[edges[count == 1]] = True
    half, side = _half(mesh.vertices, used)
    return Facts(file, mesh, float(np.linalg.norm(box)), np.nonzero(on_rim[place])[0], _path(
        mesh.vertices[used]), half, side, is_closed, b" red\n" in file.read_bytes()[:4096])


def _surface(faces):
    """Leaves out triangles with two vertices at one place, and copies of others."""
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    faces = faces[whole]
    return faces[np.sort(np.unique(np.sort(faces, 1), axis=0, return_index=True)[1])]


def _path(vertices):
    """Returns the vertices nearest to the middle, and to a place beside it along the longest side."""
    low, high = vertices.min(0), vertices.max(0)
    step = np.where(high - low == (high - low).max(), 0.2 * (high - low), 0)
    places = (low + high) / 2, (low + high) / 2 + step
    return np.array([vertices[np.linalg.norm(vertices - place, axis=1).argmin()] for place in places])


def _half(vertices, used):
    """Returns a matrix that looks across the longest side, and what it makes of this side."""
    low, high = vertices[used].min(0), vertices[used].max(0)
    long, other = np.argsort(low - high)[:2]
    matrix = np.zeros((4, 4))
    for row, axis in enumerate((long, other)):
        matrix[row, axis] = 1.8 / max(high[axis] - low[axis], 1e-300)
        matrix[row, 3] = -matrix[row, axis] * (low[axis] + high[axis]) / 2
    matrix[3, 3] = 1
    return matrix.ravel().tolist(), vertices[:, long] * matrix[0, long] + matrix[0, 3]


def moved_by(facts, out):
    """Returns the distance that each vertex moved. Fails if the file is not finite or has others."""
    result = burnish.load_ply(out)
    assert np.isfinite(result.vertices).all(), "not finite"
    assert result.vertices.shape == facts.mesh.vertices.shape, "other vertices"
    assert np.array_equal(result.faces, facts.mesh.faces), "other triangles"
    return np.linalg.norm(result.vertices - facts.mesh.vertices, axis=1)


def check_report(report):
    assert report["converged"], f"not converged: {report['distance']:.1e}"
    assert report["distance"] <= EXACT_DISTANCE, f"distance {report['distance']:.1e}"
    assert not report["fell_back"], "a step was not sound"


def check_rims(facts, case, report, moved):
    """Held rims move by exactly 0: all of them, if all are held."""
    if case.has("--pin-rims") or not facts.rim.size:
        return
    rims = report["rims"] or {"number": None, "held": 0}
    if rims["held"] == rims["number"]:
        assert not moved[facts.rim].any(), f"a held rim moved by {moved[facts.rim].max():.1e}"
    else:
        still = np.count_nonzero(moved[facts.rim] == 0)
        assert rims["held"] == 0 or still > 0, "no held rim is still"


def check_shown_rims(facts, case, report, moved, shown):
    """A live picture has rims where the export has them: exactly, if they are held."""
    used = np.intersect1d(facts.rim, facts.mesh.faces)
    if not used.size or len(shown.rest) < len(np.unique(facts.mesh.faces)):
        return
    places, of_place = np.unique(facts.mesh.vertices[used], axis=0, return_inverse=True)
    still = np.ones(len(places), bool)
    np.logical_and.at(still, of_place.ravel(), moved[used] == 0)
    seen = _nearest_places(places, shown.rest, shown.step)
    shows = np.linalg.norm(shown.frame.displacements, axis=1)
    far = shows[seen[:, 1]][still[seen[:, 0]]]
    assert not far.any(), f"frames move a held rim by {far.max():.1e}"
    assert not still.any() or far.size, "frames lack the held rims"
    if case.has("--pin-rims") and moved[used].max() > 0.1 * report["grid"]["cell_size"]:
        assert shows[seen[:, 1]].max() > 0, "frames hold a free rim"


def _nearest_places(places, rest, step):
    """Returns pairs of a place and a point that is the place, rounded to the lattice of pages."""
    low = np.minimum(places.min(0), rest.min(0)) - 32 * step
    def key(points, offset):
        x, y, z = ((points - low) / (16 * step)).astype(np.int64).T + offset[:, None]
        return (x << 42) + (y << 21) + z
    order = np.argsort(keys := key(rest, np.zeros(3, np.int64)))
    keys, pairs = keys[order], []
    for offset in np.ndindex(3, 3, 3):
        wanted = key(places, np.array(offset) - 1)
        first, last = np.searchsorted(keys, wanted), np.searchsorted(keys, wanted, "right")
        count = last - first
        place = np.repeat(np.arange(len(places)), count)
        point = order[np.arange(count.sum()) - np.repeat(np.cumsum(count) - count - first, count)]
        near = (np.abs(rest[point] - places[place]) <= 0.5001 * step).all(axis=1)
        pairs.append(np.stack([place[near], point[near]], axis=1))
    return np.concatenate(pairs)


def check_protected(facts, case, report, moved):
    """No vertex moves whose cell and its neighbours lie in the region."""
    if case.has("--protect"):
        inside = facts.side < -2 * report["grid"]["cell_size"] * facts.half_scale
        assert not moved[inside].any(), f"a protected vertex moved by {moved[inside].max():.1e}"
        assert moved.any(), "all is protected"


def check_stroke(case, moved):
    if case.has("--stroke"):
        assert moved.any(), "a stroke moves nothing"


def check_cap(facts, case, settings, moved):
    if case.has("--cap"):
        cap = float(dict(settings)["--cap"])
        assert moved.max() <= cap, f"moved by {moved.max()!r}, the cap is {cap!r}"


def check_kept(facts, case, out):
    """With β = 1 the file comes back byte for byte."""
    if case.name == "beta 1":
        assert out.read_bytes() == facts.file.read_bytes(), "β = 1 changed the file"


def check_volume(facts, case, out):
    if not case.has("--keep-volume"):
        return
    def volume(vertices):
        a, b, c = (vertices[facts.mesh.faces[:, side]] for side in range(3))
        middle = vertices.mean(0)
        return np.einsum("ij,ij->i", a - middle, np.cross(b - middle, c - middle)).sum() / 6
    kept = volume(burnish.load_ply(out).vertices) / volume(facts.mesh.vertices)
    assert abs(kept - 1) <= 1e-6, f"{kept:.8f} of the volume is left"


def check_frame(facts, report, moved, frame):
    """The frame at rest shows what the export wrote, within its step."""
    assert np.isfinite(frame.vertices).all(), "a frame is not finite"
    assert frame.settled, "the frame at rest has not settled"
    cell = report["grid"]["cell_size"]
    shown = np.linalg.norm(frame.displacements, axis=1).max()
    reach = FRAME_CELLS * cell + 1e-4 * facts.diagonal
    if len(frame.displacements) >= len(np.unique(facts.mesh.faces)):
        assert abs(shown - moved.max()) <= reach, (
            f"frames move by {shown:.3e} at most, the export by {moved.max():.3e}")
