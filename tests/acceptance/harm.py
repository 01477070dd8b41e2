"""What presets may do to a scan that nobody has looked at: none may destroy anything."""

import dataclasses
import json

import burnish
import numpy as np

import checks
import fronts

FLIPPED_MAX = 0.005  # of the area, beside slivers: triangles that turn over
OUTLINE_MAX = 0.04   # of the diagonal: how far the scan may lose or gain in any direction
VOLUME_MAX = 0.15    # of a closed scan's: what is narrow at a coarse grid has most of it
MOVE_MAX = 0.05      # of the diagonal: of any vertex
NOISE_MAX = 1.5      # times its deviation: what is taken for noise, root mean square
SLIVER = 1e-6        # of the mean area
STRENGTHS = (1, 0.5)

DIRECTIONS = np.array([way for way in np.ndindex(3, 3, 3) if way != (1, 1, 1)]) - 1.0
DIRECTIONS /= np.linalg.norm(DIRECTIONS, axis=1)[:, None]


@dataclasses.dataclass(frozen=True)
class Harm:
    """What a filter did to a scan. Lengths are parts of the diagonal, areas of the whole."""

    move: float
    outline: float
    volume: float
    flipped: float

    def __str__(self):
        return (f"moved {self.move:.1e}, outline {self.outline:.1e}, volume {self.volume:+.1%}, "
                f"turned over {self.flipped:.1e}")


def harm_of(facts, vertices):
    """Measures a result."""
    before, after = (_normals(points, facts.mesh.faces) for points in (facts.mesh.vertices, vertices))
    area = np.linalg.norm(before, axis=1)
    is_over = (np.einsum("ij,ij->i", before, after) < 0) & (area > SLIVER * area.mean())
    used = np.unique(facts.mesh.faces)
    far = [(points[used] @ DIRECTIONS.T).max(0) for points in (facts.mesh.vertices, vertices)]
    left = _volume(facts, vertices) / _volume(facts, facts.mesh.vertices) if facts.is_closed else 1
    moved = np.linalg.norm(vertices - facts.mesh.vertices, axis=1)
    return Harm(moved.max() / facts.diagonal, np.abs(far[1] - far[0]).max() / facts.diagonal, left - 1,
                area[is_over].sum() / area.sum())


def _normals(points, faces):
    a, b, c = (points[faces[:, side]] for side in range(3))
    return np.cross(b - a, c - a)


def _volume(facts, points):
    middle = facts.mesh.vertices.mean(0)
    return np.einsum("ij,ij->", points[facts.mesh.faces[:, 0]] - middle,
                     _normals(points - middle, facts.mesh.faces)) / 6


def check(facts, preset, strength, folder):
    """Filters a scan by a preset. Returns what it did. Raises AssertionError for harm."""
    out, report = folder / "preset.ply", folder / "preset.json"
    fronts.run("filter", facts.file, out, "--preset", preset, "--strength", strength, "--report", report)
    checks.moved_by(facts, out)
    vertices = burnish.load_ply(out).vertices
    harm = harm_of(facts, vertices)
    assert harm.flipped <= FLIPPED_MAX, f"{harm.flipped:.1%} of the surface turned over"
    assert harm.outline <= OUTLINE_MAX, f"the outline moved by {harm.outline:.1%} of the diagonal"
    assert harm.move <= MOVE_MAX, f"a vertex moved by {harm.move:.1%} of the diagonal"
    assert abs(harm.volume) <= VOLUME_MAX, f"the volume changed by {harm.volume:+.1%}"
    if preset == "Reduce scanner noise":
        noise = json.loads(report.read_text(encoding="utf-8"))["edges"]["noise"]
        _check_noise(facts, vertices, noise)
    return harm


def _check_noise(facts, vertices, noise):
    moved = vertices - facts.mesh.vertices
    taken = np.sqrt((moved ** 2).sum(1).mean())
    assert taken <= NOISE_MAX * noise, f"{taken:.2e} is taken for noise of {noise:.2e}"
