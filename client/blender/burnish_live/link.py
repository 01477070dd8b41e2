"""A mesh object of Blender, and the live session that moves a shape key of it."""

import contextlib

import numpy as np

import burnish

KEY = "Burnish"


def places_of(mesh):
    """Returns a mesh's own positions, n x 3."""
    found = np.empty(3 * len(mesh.vertices), np.float32)
    mesh.vertices.foreach_get("co", found)
    return found.reshape(-1, 3)


def triangles_of(mesh):
    """Returns m x 3 indices of vertices. Polygons are split as Blender draws them."""
    mesh.calc_loop_triangles()
    found = np.empty(3 * len(mesh.loop_triangles), np.int32)
    mesh.loop_triangles.foreach_get("vertices", found)
    return found.reshape(-1, 3)


def weights_of(mesh_object, group):
    """Returns n weights of a vertex group, 0 to 1. Raises ValueError for a name that is none."""
    index = mesh_object.vertex_groups.find(group)
    if index < 0:
        names = ", ".join(one.name for one in mesh_object.vertex_groups) or "no vertex group"
        raise ValueError(f"'{group}' is not a vertex group: {mesh_object.name} has {names}")
    weights = np.zeros(len(mesh_object.data.vertices))
    for vertex in mesh_object.data.vertices:
        for member in vertex.groups:
            if member.group == index:
                weights[vertex.index] = member.weight
    return weights


class Link:
    """Sends an object's mesh, or joins a session of it; frames move its shape key `Burnish`."""

    def __init__(self, mesh_object, address="", session=""):
        """`address`: HOST:PORT or unix:PATH; empty starts a server. `session`: one to join, or the name of a
        new one. Raises burnish.Error; ValueError if the session's scan is another mesh."""
        self._places = places_of(mesh_object.data)
        self._shown = None  # a gesture and its edit: the server shows one of a client
        self._kept_for_next = {}  # by kind: the newest edit that was shown when another kind came
        self._made_together = []  # how many entries each call has made
        self._proposal = None  # by the scan's noise, once a preset needs it
        with contextlib.ExitStack() as made:
            self.server = made.enter_context(
                contextlib.closing(burnish.connect(address) if address else burnish.serve()))
            self.session = self._open(mesh_object, session)
            self.live = made.enter_context(self.session.live(vertices=self._places))
            scan = self.server.scan(self.session.scan_id)
            self.prepared = scan.prepared(self.session.depth)
            self._made = made.pop_all()
        self._key = shape_key_of(mesh_object)

    def _open(self, mesh_object, name):
        if name in {one.name for one in self.server.sessions()}:
            return self.server.session(name)
        mesh = burnish.Mesh(self._places, triangles_of(mesh_object.data))
        return self.server.open_session(self.server.import_scan(mesh, mesh_object.name), name)

    def close(self):
        """Leaves the session; a server of one's own ends. The shape key stays."""
        self._made.close()

    def update(self, mesh_object):
        """Puts the newest frame into the shape key. Returns whether there was one."""
        frame = self.live.poll()
        if frame is not None:
            self._write(mesh_object, frame.vertices)
        return frame is not None

    def sliders(self, beta, wavelength):
        """Returns the edits of a gradient scale and a wavelength; 0: as the session has it."""
        changes = [burnish.GradientScale(beta)]
        if wavelength > 0:
            changes.append(burnish.TransferCurve.constant(self.prepared.alpha_of(wavelength)))
        return changes

    def preset(self, name, strength):
        """Returns the edits of a preset, as the window makes them. Raises burnish.Error."""
        return self.session.preset(name, strength)

    def strength(self, name, strength):
        """Returns the edit that changes with a preset's strength while its curve stays."""
        if self._proposal is None:
            self._proposal = self.session.propose_edges()
        _, beta, bands = self.prepared.preset(name, strength, self._proposal)
        return bands if bands.bands else beta

    def show(self, change):
        """Lets everybody in the session see an edit. One of another kind that was shown is kept first."""
        if self._shown and type(self._shown[1]) is not type(change):
            gesture, before = self._shown
            gesture.keep(before)
            self._kept_for_next[type(before)] = before
            self._made_together.append(1)
            self._shown = None
        gesture = self._shown[0] if self._shown else self.live.gesture()
        gesture.show(change)
        self._shown = gesture, change

    def keep(self, changes):
        """Applies the edits. One undo takes all back, but for what show() has kept."""
        new = [change for change in changes if self._kept_for_next.get(type(change)) != change]
        if new:
            self._made_together.append(len(self.session.apply(*new)))
        self._kept_for_next.clear()
        self.drop()

    def drop(self, kind=object):
        """Shows the session without the edit that was shown and not kept, if it is of this kind."""
        if self._shown and isinstance(self._shown[1], kind):
            self._shown[0].drop()
            self._shown = None

    def paint(self, mesh_object, group, what, value):
        """Edits where a vertex group is; vertices of weight 0 stay. `what`: "beta" or "texture", a weight of 1
        is `value`; "edges", it takes all noise; "protection", half and more protects."""
        weights = weights_of(mesh_object, group)
        inside = np.where(weights > 0, weights, np.nan)
        edits = {"beta": lambda: self.live.cell_fields(1 + inside * (value - 1)),
                 "texture": lambda: self.live.cell_texture(1 + inside * (value - 1)),
                 "edges": lambda: self.live.cell_edges(inside),
                 "protection": lambda: self.live.cell_protection(inside)}
        self._made_together.append(len(self.live.apply(edits[what]())))

    def undo(self):
        """Undoes the newest edit of this user, with those that were made together with it."""
        self._kept_for_next.clear()
        for _ in range(self._made_together.pop() if self._made_together else 1):
            self.session.undo()

    def finish(self, mesh_object):
        """Solves to the accuracy of final results, and puts all digits into the shape key."""
        self._write(mesh_object, self.session.mesh(exact=True).vertices)

    def _write(self, mesh_object, vertices):
        shape_key_of(mesh_object).data.foreach_set("co", np.float32(vertices).ravel())
        mesh_object.data.update()


def shape_key_of(mesh_object):
    """Returns the object's shape key `Burnish`; makes it, and shows it, if there is none."""
    keys = mesh_object.data.shape_keys
    if keys is None:
        mesh_object.shape_key_add(name="Basis", from_mix=False)
        keys = mesh_object.data.shape_keys
    if KEY not in keys.key_blocks:
        mesh_object.shape_key_add(name=KEY, from_mix=False).value = 1
    return keys.key_blocks[KEY]
