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
    rim: np.ndarray  # vertices of edges of exactly one triangle, by place
    is_closed: bool
    has_colours: bool


def facts_of(file):
    mesh = burnish.load_ply(file)
    used = np.unique(mesh.faces)
    box = mesh.vertices[used].max(0) - mesh.vertices[used].min(0)
    _, place = np.unique(mesh.vertices, axis=0, return_inverse=True)
    place = place.ravel()
    faces = place[mesh.faces]
    whole = (faces[:, 0] != faces[:, 1]) & (faces[:, 1] != faces[:, 2]) & (faces[:, 2] != faces[:, 0])
    ways = np.concatenate([faces[whole][:, [a, b]] for a, b in ((0, 1), (1, 2), (2, 0))])
    edges, count = np.unique(np.sort(ways, 1), axis=0, return_counts=True)
    up, by_way = np.unique(np.sort(ways, 1)[ways[:, 0] < ways[:, 1]], axis=0, return_counts=True)
    turns = {tuple(e): n for e, n in zip(up.tolist(), by_way.tolist())}
    is_closed = all(2 * turns.get(tuple(e), 0) == n for e, n in zip(edges.tolist(), count.tolist()))
    on_rim = np.zeros(place.max() + 1, bool)
    on_rim[edges[count == 1]] = True
    colours = getattr(mesh, "colours", None)
    return Facts(file, mesh, float(np.linalg.norm(box)), np.nonzero(on_rim[place])[0], is_closed,
                 colours is not None and len(colours) > 0)


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
    limit = 2e-3 if case.has("--cap") else 1e-6  # the cap wins
    assert abs(kept - 1) <= limit, f"{kept:.8f} of the volume is left"


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
