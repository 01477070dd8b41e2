"""Edits, each with its own id."""

import itertools

from burnish.v1 import common_pb2, editing_pb2

edit_ids = (f"python-{number}" for number in itertools.count())


def edit(**change):
    return editing_pb2.Edit(id=next(edit_ids), **change)


def slider(beta):
    return edit(gradient_scale=editing_pb2.SetGradientScale(beta=beta))


def curve(*points):
    points = [editing_pb2.CurvePoint(kappa=kappa, alpha=alpha) for kappa, alpha in points]
    return edit(transfer_curve=editing_pb2.SetTransferCurve(points=points))


def controls(pin_rims):
    return edit(controls=editing_pb2.Controls(pin_rims=pin_rims))


def stroke(path, radius, beta):
    brush = editing_pb2.Brush(radius=radius, strength=0.8, beta=beta,
                              fall_off=editing_pb2.FALL_OFF_SMOOTH)
    points = [common_pb2.Point(x=x, y=y, z=z) for x, y, z in path]
    return edit(stroke=editing_pb2.Stroke(brush=brush, path=points))
