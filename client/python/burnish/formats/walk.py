"""The walk of a page: its triangles in the order in which they come (docs/protocol.md, section 6)."""

from __future__ import annotations

import dataclasses
from typing import Iterator, Sequence

from .wire import require


@dataclasses.dataclass(slots=True, eq=False)
class Edge:
    start: int
    end: int
    apex: int
    patch: int
    before: Edge | None = None
    after: Edge | None = None
    is_open: bool = True


def join(before: Edge | None, after: Edge | None) -> None:
    require(before is not None and after is not None, "the walk leaves its ring")
    assert before is not None and after is not None
    before.after, after.before = after, before


class Walk:
    """The triangles, the patches and the predictors of new vertices, in the order of the walk.

    `origins` has the vertices (a, b, c) for each vertex: its position is predicted as a + b - c.
    """

    def __init__(self, steps: Sequence[int], vertices: Sequence[int], turns: Sequence[int],
                 patches: Sequence[int]) -> None:
        self.triangles: list[tuple[int, int, int]] = []
        self.patches: list[int] = []
        self.origins: list[tuple[int, int, int]] = []
        self._edges: list[Edge] = []
        self._newest: dict[int, Edge] = {}
        self._vertices: Iterator[int] = iter(vertices)
        self._turns: Iterator[int] = iter(turns)
        self._names: Iterator[int] = iter(patches)
        try:
            self._take(steps)
        except StopIteration:
            require(False, "the walk names more than the page has")

    def _take(self, steps: Sequence[int]) -> None:
        current, edges = 0, self._edges
        for step in steps:
            while current < len(edges) and not edges[current].is_open:
                current += 1
            if current == len(edges):
                self._start(step)
            else:
                self._step(edges[current], step)

    def _named(self) -> int:
        vertex = len(self.origins) - 1 - next(self._vertices)
        require(vertex >= 0, "the walk names a vertex before the first")
        return vertex

    def _new(self, a: int, b: int, c: int) -> int:
        self.origins.append((a, b, c))
        return len(self.origins) - 1

    def _add(self, triangle: tuple[int, int, int], patch: int) -> int:
        self.triangles.append(triangle)
        self.patches.append(next(self._names) if next(self._turns) else patch)
        return self.patches[-1]

    def _edge(self, start: int, end: int, apex: int, patch: int) -> Edge:
        edge = Edge(start, end, apex, patch)
        self._edges.append(edge)
        self._newest[start] = edge
        return edge

    def _start(self, step: int) -> None:
        require(8 <= step < 16, "a start is needed")
        corners = []
        for bit in range(3):
            before = max(len(self.origins) - 1, 0)
            corners.append(self._named() if step >> bit & 1 else self._new(before, before, before))
        a, b, c = corners
        patch = self._add((a, b, c), self.patches[-1] if self.patches else 0)
        ring = [self._edge(a, b, c, patch), self._edge(b, c, a, patch),
                self._edge(c, a, b, patch)]
        for k in range(3):
            join(ring[k], ring[(k + 1) % 3])

    def _apex(self, edge: Edge, step: int) -> int:
        assert edge.before is not None and edge.after is not None
        if step == 0:
            return self._new(edge.start, edge.end, edge.apex)
        if step == 1:
            return edge.before.start
        return edge.after.end if step == 2 else self._named()

    def _step(self, edge: Edge, step: int) -> None:
        require(step <= 4, "no start is needed")
        edge.is_open = False
        if step == 3:
            return
        before, after = edge.before, edge.after
        assert before is not None and after is not None
        w = self._apex(edge, step)
        patch = self._add((edge.end, edge.start, w), edge.patch)
        keeps_before, keeps_after = before.start != w, after.end != w
        cut = self._newest.get(w)
        left, right = before.before, after.after
        if keeps_before:
            left = self._edge(edge.start, w, edge.end, patch)
            join(before, left)
        else:
            before.is_open = False
        if keeps_after:
            right = self._edge(w, edge.end, edge.start, patch)
            join(right, after)
        else:
            after.is_open = False
        if keeps_before and keeps_after and cut is not None and cut.is_open:
            join(cut.before, right)
            right = cut
        join(left, right)
