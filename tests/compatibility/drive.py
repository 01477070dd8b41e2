"""Drives a server with the package that PYTHONPATH names, by its documented names alone.

Usage: drive.py ADDRESS FOLDER      prints how many frames came; fails where something is amiss
"""

import pathlib
import sys

import numpy as np

import burnish


def bumpy_sheet():
    """A square of 24 x 24 quads with waves on it."""
    side = np.linspace(0, 10, 25)
    x, y = np.meshgrid(side, side)
    z = 0.3 * np.sin(3 * x) * np.cos(2 * y)
    index = np.arange(25 * 25).reshape(25, 25)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[:-1, 1:], index[1:, 1:],
                                            index[1:, :-1]))
    return burnish.Mesh(np.stack([x.ravel(), y.ravel(), z.ravel()], axis=1),
                        np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)]))


def main(address, folder):
    folder = pathlib.Path(folder)
    mesh = bumpy_sheet()
    with burnish.connect(address, user="older") as server:
        scan = server.import_scan(mesh, "sheet", depth=5)
        assert (scan.triangles, len(server.scans())) == (len(mesh.faces), 1)
        session = server.open_session(scan, "older work", depth=5)
        middle = mesh.vertices[300:320]
        session.apply(burnish.GradientScale(0.3), burnish.TransferCurve({-5: 20, 5: 60}),
                      burnish.Stroke(burnish.Brush(1, beta=2), middle))
        session.undo()
        session.redo()
        session.checkpoint("painted")
        session.apply(burnish.Controls(cap=0.2), burnish.Equaliser([burnish.Band(1, 0.5)]))
        session.restore("painted")
        frames = 0
        with session.live() as live:
            live.apply(burnish.GradientScale(0.1))
            for frame in live.frames():
                frames += 1
            moved = np.abs(frame.displacements).max()
        assert moved > 0.05 and frame.settled
        fork = session.fork("older fork")
        assert [one.kind for one in fork.history()].count("stroke") == 1
        session.set_role("newer", "editor")
        assert session.people().roles["newer"] == "editor"
        session.export(folder / "older.ply", exact=True)
        edited = burnish.load_ply(folder / "older.ply")
        assert np.abs(edited.vertices - mesh.vertices).max() > 0.05
        try:
            server.session("absent")
            raise AssertionError("a session that is absent was found")
        except burnish.NotFound as error:
            assert "absent" in error.message
    print(frames)


if __name__ == "__main__":
    main(*sys.argv[1:])
