"""Burnish in Blender: a panel in the sidebar of the 3D view, tab Burnish."""

import contextlib

import bpy

import burnish

from .link import Link

bl_info = {"name": "Burnish", "author": "The Burnish authors", "version": (0, 1, 0), "blender": (3, 4, 0),
           "location": "3D View > Sidebar > Burnish", "category": "Mesh",
           "description": "Smooths and sharpens scans live"}
SECONDS_BETWEEN_FRAMES = 0.05

SLIDERS = "SLIDERS"
PAINTS = (("beta", "Gradient scale", "The painted scale where the weight is 1"),
          ("texture", "Texture gain", "The painted gain where the weight is 1; of scans with colours or pictures"),
          ("edges", "Kept edges", "Takes noise and keeps edges, all of it where the weight is 1"),
          ("protection", "Protection", "Nothing moves where the weight is half or more"))

links = {}
"""The live sessions, by the names of their objects."""

choices = []
"""The presets as Blender shows them; it needs the texts for as long as it shows them."""


def presets(settings=None, context=None):
    """Returns the choices of presets: those of the window and the user's own, by the program burnish."""
    if not choices:
        choices.append((SLIDERS, "None", "As the sliders say"))
        with contextlib.suppress(burnish.Error, OSError):
            choices.extend((name, name, text) for name, text in burnish.presets().items())
    return choices


def changes_of(link, settings):
    """Returns the edits that the sliders, or the preset, say."""
    if settings.preset == SLIDERS:
        return link.sliders(settings.beta, settings.wavelength)
    return link.preset(settings.preset, settings.strength)


def updater(work):
    """Returns what Blender calls when a field has changed: `work` with the live session and the settings."""
    def update(settings, context):
        link = links.get(context.object.name) if context.object else None
        if link is None:
            return
        try:
            work(link, settings)
        except (burnish.Error, ValueError, OSError) as error:  # nobody sees what a field's update raises
            print(f"burnish: {error}")
    return update


def choose(link, settings):
    """Applies a preset, as the window does."""
    link.drop()
    if settings.preset != SLIDERS:
        link.keep(changes_of(link, settings))


show_beta = updater(lambda link, settings: link.show(link.sliders(settings.beta, 0)[0]))
show_wavelength = updater(lambda link, settings: link.show(link.sliders(0, settings.wavelength)[-1])
                          if settings.wavelength > 0 else link.drop(burnish.TransferCurve))
show_strength = updater(lambda link, settings: link.show(
    link.strength(settings.preset, settings.strength)) if settings.preset != SLIDERS else None)


class Settings(bpy.types.PropertyGroup):
    """What the panel's fields say."""

    __annotations__ = {
        "address": bpy.props.StringProperty(
            name="Server", description="HOST:PORT or unix:PATH; empty starts a server on this computer"),
        "session": bpy.props.StringProperty(
            name="Session", description="A session to join, or the name of a new one"),
        "beta": bpy.props.FloatProperty(
            name="Gradient scale", default=1, min=0, max=10, soft_max=4, update=show_beta,
            description="Below 1 smooths, 1 keeps, above 1 sharpens"),
        "wavelength": bpy.props.FloatProperty(
            name="Wavelength", default=0, min=0, update=show_wavelength,
            description="At gradient scale 0 waves of this length are halved; 0: as the session has it"),
        "preset": bpy.props.EnumProperty(
            name="Preset", items=presets, update=updater(choose),
            description="Sets the gradient scale, the curve and the bands, as in the window"),
        "strength": bpy.props.FloatProperty(
            name="Strength", default=1, min=0, max=1, subtype="FACTOR", update=show_strength,
            description="How much of the preset"),
        "paints": bpy.props.EnumProperty(name="Paints", items=PAINTS, description="What Paint edits"),
        "group": bpy.props.StringProperty(
            name="Vertex group", description="Where Paint edits, and how much"),
        "painted": bpy.props.FloatProperty(
            name="Painted scale", default=0, min=0, max=10, soft_max=4,
            description="The gradient scale where the weight is 1; at weight 0 the surface stays"),
        "gain": bpy.props.FloatProperty(
            name="Painted gain", default=2, min=0, max=4,
            description="The texture gain where the weight is 1; at weight 0 the texels stay")}


class Step(bpy.types.Operator):
    """Is an operator on the live session of the active object; errors become Blender's reports."""

    bl_options = {"REGISTER"}

    @classmethod
    def poll(cls, context):
        return context.object is not None and context.object.name in links

    def execute(self, context):
        try:
            self.work(context.object, context.scene.burnish)
        except (burnish.Error, ValueError, OSError) as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        return {"FINISHED"}


class Begin(Step):
    bl_idname, bl_label = "burnish.begin", "Edit live"
    bl_description = "Send the mesh to a server, or join a session of it"

    @classmethod
    def poll(cls, context):
        one = context.object
        return one is not None and one.type == "MESH" and one.mode == "OBJECT" and one.name not in links

    def work(self, one, settings):
        links[one.name] = Link(one, settings.address, settings.session)
        if not bpy.app.timers.is_registered(update_all):
            bpy.app.timers.register(update_all)


class End(Step):
    bl_idname, bl_label = "burnish.end", "End"
    bl_description = "Leave the session; the shape key stays"

    def work(self, one, settings):
        links.pop(one.name).close()


class Keep(Step):
    bl_idname, bl_label = "burnish.keep", "Keep"
    bl_description = "Apply what the preset or the sliders show as an edit of the session"

    def work(self, one, settings):
        links[one.name].keep(changes_of(links[one.name], settings))


class Paint(Step):
    bl_idname, bl_label = "burnish.paint", "Paint"
    bl_description = "Edit where the vertex group is, by its weights"

    def work(self, one, settings):
        value = settings.gain if settings.paints == "texture" else settings.painted
        links[one.name].paint(one, settings.group, settings.paints, value)


class Undo(Step):
    bl_idname, bl_label = "burnish.undo", "Undo"
    bl_description = "Undo your newest edit of the session"

    def work(self, one, settings):
        links[one.name].undo()


class Finish(Step):
    bl_idname, bl_label = "burnish.finish", "Exact"
    bl_description = "End with the result in all its digits as the shape key"

    def work(self, one, settings):
        links[one.name].drop()
        links[one.name].finish(one)
        links.pop(one.name).close()


class Panel(bpy.types.Panel):
    bl_idname, bl_label, bl_category = "VIEW3D_PT_burnish", "Burnish", "Burnish"
    bl_space_type, bl_region_type = "VIEW_3D", "UI"

    def draw(self, context):
        settings, layout = context.scene.burnish, self.layout
        layout.use_property_split = True
        if context.object is None or context.object.name not in links:
            layout.prop(settings, "address")
            layout.prop(settings, "session")
            layout.operator("burnish.begin")
            return
        layout.prop(settings, "preset")
        for name in ("beta", "wavelength") if settings.preset == SLIDERS else ("strength",):
            layout.prop(settings, name, slider=name != "wavelength")
        layout.operator("burnish.keep")
        layout.prop_search(settings, "group", context.object, "vertex_groups")
        layout.prop(settings, "paints")
        if settings.paints == "beta":
            layout.prop(settings, "painted", slider=True)
        if settings.paints == "texture":
            layout.prop(settings, "gain", slider=True)
        for name in ("paint", "undo", "finish", "end"):
            layout.operator(f"burnish.{name}")


def update_all():
    """Puts new frames into shape keys. Ends with the last session. Returns the seconds to the next call."""
    for name, link in list(links.items()):
        one = bpy.data.objects.get(name)
        try:
            if one is not None:
                link.update(one)
                continue
        except burnish.Error as error:
            print(f"burnish: {name}: {error}")
        links.pop(name).close()
    return SECONDS_BETWEEN_FRAMES if links else None


CLASSES = (Settings, Begin, End, Keep, Paint, Undo, Finish, Panel)


def register():
    for one in CLASSES:
        bpy.utils.register_class(one)
    bpy.types.Scene.burnish = bpy.props.PointerProperty(type=Settings)


def unregister():
    while links:
        links.popitem()[1].close()
    del bpy.types.Scene.burnish
    for one in reversed(CLASSES):
        bpy.utils.unregister_class(one)
