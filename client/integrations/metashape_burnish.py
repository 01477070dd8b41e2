"""Filters the model of the active chunk in Agisoft Metashape with the program `burnish`.

In Metashape: Tools, Run Script, this file. It adds the menu Burnish. Textures, cameras and the region stay;
the new model replaces the old one, which Metashape's undo does not bring back, so it asks first.
Written by Metashape's reference of Python; not tried in the program, which Debian does not have.
"""

import pathlib
import shutil
import subprocess
import tempfile

import Metashape

PRESETS = ("Reduce scanner noise", "Soften", "Bring out an inscription")


def program():
    """Returns the path of the program. Raises RuntimeError where there is none."""
    found = shutil.which("burnish")
    if found is None:
        raise RuntimeError("the program 'burnish' is not in the PATH of Metashape")
    return found


def filtered(model, target, options):
    """Runs the program. Raises RuntimeError with its last line."""
    run = subprocess.run([program(), "filter", str(model), str(target), *options],
                         stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if run.returncode:
        lines = run.stderr.strip().splitlines() or [f"it ended with {run.returncode}"]
        raise RuntimeError(f"burnish: {lines[-1]}")


def filter_model(options):
    """Filters the active chunk's model. `options`: words of `burnish filter`."""
    chunk = Metashape.app.document.chunk
    if chunk is None or chunk.model is None:
        raise RuntimeError("the active chunk has no model")
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        # The model in the chunk's own coordinates: no shift, no turn, and the same on the way back.
        way = {"format": Metashape.ModelFormatOBJ, "crs": None}
        source = pathlib.Path(folder) / "model.obj"
        target = pathlib.Path(folder) / "edited" / "model.obj"
        target.parent.mkdir()
        chunk.exportModel(path=str(source), binary=False, precision=9, save_texture=True, save_uv=True,
                          save_normals=True, save_colors=True, **way)
        filtered(source, target, options)
        chunk.importModel(path=str(target), **way)


def ask_and_filter(options):
    """Filters the model if the user agrees, and says what failed."""
    if not Metashape.app.getBool("Replace the chunk's model by the filtered one?"):
        return
    try:
        filter_model(options)
    except RuntimeError as error:
        Metashape.app.messageBox(str(error))


def ask_for_beta():
    beta = Metashape.app.getFloat("Gradient scale: below 1 smooths, above 1 sharpens", 0.5)
    if beta is not None:
        ask_and_filter([f"--beta={beta}"])


def add_menu():
    Metashape.app.addMenuItem("Burnish/Gradient scale...", ask_for_beta)
    Metashape.app.addMenuItem("Burnish/Take noise, keep edges", lambda: ask_and_filter(["--keep-edges=auto"]))
    for preset in PRESETS:
        Metashape.app.addMenuItem(f"Burnish/{preset}",
                                  lambda preset=preset: ask_and_filter([f"--preset={preset}"]))


add_menu()
