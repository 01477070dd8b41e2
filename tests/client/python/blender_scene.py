"""Runs in Blender, for blender_test.py: edits a mesh by the add-on, and prints facts as JSON."""

import json
import pathlib
import sys

import bpy
import numpy as np

import burnish

FOLDER, = sys.argv[sys.argv.index("--") + 1:]
bpy.ops.preferences.addon_install(filepath=f"{FOLDER}/burnish_live.zip")
bpy.ops.preferences.addon_enable(module="burnish_live")
import burnish_live
from burnish_live.link import places_of, triangles_of

bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32)
ball = bpy.context.object
before = places_of(ball.data)
bumps = before * (1 + 0.02 * np.sin(20 * before).sum(axis=1))[:, None]
ball.data.vertices.foreach_set("co", np.float32(bumps).ravel())
bumps = places_of(ball.data)
facts, settings = {}, bpy.context.scene.burnish


def add_twin(name, scale):
    """Adds an object with the same mesh, scaled, and makes it the active one."""
    twin = bpy.data.objects.new(name, ball.data.copy())
    twin.data.vertices.foreach_set("co", np.float32(bumps * scale).ravel())
    twin.shape_key_clear()
    bpy.context.collection.objects.link(twin)
    bpy.context.view_layer.objects.active = twin
    return twin


def shown(ball=ball):
    found = np.empty(bumps.size, np.float32)
    ball.data.shape_keys.key_blocks["Burnish"].data.foreach_get("co", found)
    return found.reshape(-1, 3)


def moved(of=slice(None)):
    return float(np.abs(shown() - bumps)[of].max())


def wait_until(is_done):
    """Takes frames until the condition holds; the test's own limit of time ends it."""
    while not is_done():
        burnish_live.update_all()


bpy.ops.burnish.begin()
link = burnish_live.links[ball.name]
settings.beta = 0
wait_until(lambda: moved() > 0.01)
facts["slider moves the key"] = moved()
settings.beta = 1
wait_until(lambda: moved() < 0.001)
facts["slider takes it back"] = moved()
facts["edits before keep"] = len(list(link.session.history()))
settings.beta, settings.wavelength = 0.2, 0.5
bpy.ops.burnish.keep()
facts["edits after keep"] = [entry.kind for entry in link.session.history()]
wait_until(lambda: moved() > 0.005)

facts["presets"] = [name for name, _, _ in burnish_live.presets()]
count = len(facts["edits after keep"])
settings.preset = "Reduce scanner noise"
facts["edits of a preset"] = [entry.kind for entry in link.session.history()][count:]
settings.strength = 0.25
facts["edits while its strength moves"] = len(list(link.session.history())) - count
bpy.ops.burnish.keep()
state = link.session.state()
curve, beta, _ = link.prepared.preset("Reduce scanner noise", 0.25, link.session.propose_edges())
facts["preset at a strength"] = [state.beta == beta.beta, state.curve == curve]
bpy.ops.burnish.undo()
bpy.ops.burnish.undo()
facts["beta after undo"] = link.session.state().beta
settings.preset = burnish_live.SLIDERS
for settings.beta, settings.wavelength in (0.5, 0.4), (0.7, 0.6):
    pass  # each slider's move shows an edit, and keeps the one that the other showed
settings.beta = 0.5
bpy.ops.burnish.keep()
facts["the sliders' last places are kept"] = link.session.state().beta
for _ in range(5):
    bpy.ops.burnish.undo()
facts["beta after all undos"] = link.session.state().beta

settings.address, settings.session = link.server.calls.address, link.session.name
twin = add_twin("twin", 1)
bpy.ops.burnish.begin()
wait_until(lambda: np.abs(shown(twin) - bumps).max() > 0.005)
facts["who joins sees the edits"] = float(np.abs(shown(twin) - bumps).max())
bpy.ops.burnish.end()
add_twin("larger", 1.5)
try:
    bpy.ops.burnish.begin()
except RuntimeError as error:
    facts["another mesh"] = str(error)
bpy.context.view_layer.objects.active = ball

other = burnish.connect(link.server.calls.address, user="Anna").session(link.session.id)
other.set_beta(1)
wait_until(lambda: moved() < 0.001)
facts["edit of another is seen"] = moved()

group = ball.vertex_groups.new(name="top")
top = np.flatnonzero(bumps[:, 2] > 0.3)
group.add(top.tolist(), 1.0, "REPLACE")
settings.group, settings.painted = "top", 0
bpy.ops.burnish.paint()
wait_until(lambda: moved(top) > 0.005)
facts["group"] = [moved(top), moved(np.flatnonzero(bumps[:, 2] < -0.5))]
count = len(list(link.session.history()))
for settings.paints in ("edges", "protection"):
    bpy.ops.burnish.paint()
facts["painted weights"] = [entry.summary.split(" in ")[0].split(" of ")[0]
                            for entry in link.session.history()][count:]
facts["protected"] = float(link.session.cells("protected").mean())
for _ in range(2):
    bpy.ops.burnish.undo()
settings.group = "none"
try:
    bpy.ops.burnish.paint()
except RuntimeError as error:
    facts["wrong group"] = str(error)

coloured = pathlib.Path(FOLDER) / "coloured.ply"
coloured.write_text("\n".join(
    ["ply", "format ascii 1.0", f"element vertex {len(bumps)}",
     *(f"property float {axis}" for axis in "xyz"),
     *(f"property uchar {channel}" for channel in ("red", "green", "blue")),
     f"element face {len(triangles_of(ball.data))}", "property list uchar int vertex_indices", "end_header",
     *(" ".join([*map(repr, place), *map(str, [60 + 130 * (i % 2)] * 3)])
       for i, place in enumerate(bumps.tolist())),
     *(f"3 {a} {b} {c}" for a, b, c in triangles_of(ball.data).tolist())]) + "\n", "utf-8")
session = link.server.open_session(link.server.import_scan(coloured, "coloured"), "coloured")
settings.session, settings.group, settings.paints, settings.gain = session.name, "top", "texture", 3
painted = add_twin("painted", 1)
painted.vertex_groups.new(name="top").add(top.tolist(), 1.0, "REPLACE")
bpy.ops.burnish.begin()
bpy.ops.burnish.paint()
facts["painted gain"] = [entry.summary.split(" in ")[0] for entry in session.history()]
bpy.ops.burnish.end()
bpy.context.view_layer.objects.active = ball
settings.group = "top"
try:
    bpy.ops.burnish.paint()
except RuntimeError as error:
    facts["gain without colours"] = str(error)
exact = link.session.mesh(exact=True).vertices
bpy.ops.burnish.finish()
facts["exact"] = float(np.abs(shown() - exact).max())
facts["basis stays"] = bool((places_of(ball.data) == bumps).all())
facts["links"] = len(burnish_live.links)
bpy.ops.preferences.addon_disable(module="burnish_live")
print("FACTS", json.dumps(facts), flush=True)
