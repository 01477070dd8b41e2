"""Runs in Blender, for deploy/pictures/blender: edits a tablet by the add-on, and keeps a picture of the window."""

import ctypes
import os
import sys

sys.path.insert(0, os.environ["BURNISH_PACKAGE"])

import bpy
import numpy as np

import burnish

bpy.context.preferences.view.show_splash = False
bpy.ops.preferences.addon_install(filepath=os.path.abspath("burnish_live.zip"))
bpy.ops.preferences.addon_enable(module="burnish_live")
import burnish_live

for one in list(bpy.data.objects):
    bpy.data.objects.remove(one)
tablet = burnish.load_ply("tablet.ply")
places = tablet.vertices - tablet.vertices.mean(axis=0)
mesh = bpy.data.meshes.new("tablet")
mesh.from_pydata((places * 2 / np.ptp(places)).tolist(), [], tablet.faces.tolist())
scan = bpy.data.objects.new("tablet", mesh)
bpy.context.collection.objects.link(scan)
bpy.context.view_layer.objects.active = scan
scan.select_set(True)

# The sidebar has its own tab Item, and now the add-on's below it.
TAB = 1044, 158
for panel in bpy.types.Panel.__subclasses__():
    is_beside = getattr(panel, "bl_space_type", "") == "VIEW_3D" and getattr(panel, "bl_region_type", "") == "UI"
    if is_beside and panel is not burnish_live.Panel and panel.is_registered:
        bpy.utils.unregister_class(panel)


def click(x, y):
    """Clicks as a user does: Blender 3.4 has no other way to choose a tab of the sidebar."""
    x11, xtst = ctypes.CDLL("libX11.so.6"), ctypes.CDLL("libXtst.so.6")
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = ctypes.c_void_p(x11.XOpenDisplay(None))
    xtst.XTestFakeMotionEvent(display, -1, x, y, ctypes.c_ulong(0))
    for is_pressed in (1, 0):
        xtst.XTestFakeButtonEvent(display, 1, is_pressed, ctypes.c_ulong(0))
    x11.XFlush(display)


def view():
    """Returns the window and the area of the 3D view, and shows the scan in it."""
    window = bpy.context.window_manager.windows[0]
    area = next(one for one in window.screen.areas if one.type == "VIEW_3D")
    space = area.spaces.active
    space.show_region_ui = True
    space.overlay.show_overlays = False
    space.shading.show_cavity = True
    return window, area


def steps():
    """Yields the seconds until the next step: Blender draws between them."""
    window, area = view()
    region = next(one for one in area.regions if one.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        bpy.ops.view3d.view_axis(type="TOP")
        bpy.ops.view3d.view_selected()
    bpy.ops.burnish.begin()
    yield 1
    bpy.context.scene.burnish.preset = "Bring out an inscription"
    live = burnish_live.links["tablet"].live
    while not live.settle().settled:
        yield 0.1
    burnish_live.links["tablet"].finish(scan)
    yield 1
    click(*TAB)
    yield 3
    bpy.ops.screen.screenshot(filepath=os.environ["BURNISH_PICTURE"])
    burnish_live.unregister()
    bpy.ops.wm.quit_blender()


course = steps()
bpy.app.timers.register(lambda: next(course, None), first_interval=2)
