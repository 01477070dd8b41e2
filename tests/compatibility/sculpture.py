"""The sessions that a version keeps for later ones: what is in them, and how they look from outside."""

import numpy as np

import burnish
import scan

SCAN, DEPTH, SPLITS = "sphere", 5, 3  # 642 vertices
PATH = np.array([[10.0, y, 0] for y in np.linspace(-3, 3, 7)])


def mesh():
    """The scan of the kept data folder: a bumpy sphere."""
    return burnish.Mesh(*scan.bumpy_sphere(SPLITS))


def path_on(surface):
    """Returns vertices of the scan along the path."""
    near = [np.linalg.norm(surface.vertices - point, axis=1).argmin() for point in PATH]
    return surface.vertices[near]


def edit(server, connect):
    """Makes two sessions. connect(USER) returns another user's connection."""
    surface = mesh()
    ball = server.import_scan(surface, SCAN, depth=DEPTH)
    carving = server.open_session(ball, "carving", depth=DEPTH)
    carving.set_role("bert", "editor")
    carving.set_role("", "viewer")
    carving.apply(burnish.GradientScale(0.2), burnish.TransferCurve({-3: 20, 0: 40, 3: 80}))
    brush = burnish.Brush(2, beta=2.5)
    carving.apply(burnish.Stroke(brush, path_on(surface)))
    carving.checkpoint("painted")
    bert = connect("bert").session("carving")
    bert.set_beta(1.5)
    bert.undo()
    carving.apply(burnish.Stroke(brush, -path_on(surface)))
    carving.switch(2, False)
    bands = server.open_session(ball, "bands", depth=DEPTH)
    bands.apply(burnish.Equaliser([burnish.Band(2, 0.5), burnish.Band(6, 2)]),
                burnish.Controls(cap=0.3))
    bands.apply(burnish.ProtectCurvature(8, 1e9))


def view(server, folder):
    """Returns all that a client sees, and writes each session's exact export into the folder."""
    seen = {}
    for session in sorted(server.sessions(), key=lambda one: one.name):
        session = server.open_session(SCAN, session.name, depth=DEPTH)
        session.export(folder / f"{session.name}.ply", exact=True)
        seen[session.name] = {
            "history": [[one.number, one.author, one.kind, one.summary, one.enabled]
                        for one in session.history()],
            "roles": session.people().roles, "edits": session.state().edits,
            "beta": session.state().beta, "depth": session.depth, "scan": session.scan_id}
    return seen
