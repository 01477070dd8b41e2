"""Filters of MeshLab by its program for scripts."""

import pathlib
import subprocess
import tempfile

from .shape import read_ply

TWO_STEP = [(smooth, angle, normal) for smooth in (1, 3, 10) for angle in (20, 40, 60)
            for normal in (5, 20)]
STEPS = (1, 2, 5, 10, 20, 50)
HC_STEPS = (1, 2, 4, 8, 16)


def _filter(name, **values):
    """Returns a filter in MeshLab's XML."""
    kinds = {int: "RichInt", float: "RichFloat", bool: "RichBool"}
    inner = "".join(f'<Param type="{kinds[type(value)]}" name="{key}" '
                    f'value="{str(value).lower()}"/>' for key, value in values.items())
    return f'<filter name="{name}">{inner}</filter>'


def settings():
    """Returns a script's filters by its setting in words."""
    scripts = {}
    for smooth, angle, normal in TWO_STEP:
        scripts[f"two-step {smooth}, {angle}°, {normal}"] = _filter(
            "TwoStep Smooth", stepSmoothNum=smooth, normalThr=float(angle), stepNormalNum=normal,
            stepFitNum=20, Selected=False)
    for steps in STEPS:
        scripts[f"Taubin {steps}"] = _filter("Taubin Smooth", **{"lambda": 0.5}, mu=-0.53,
                                             stepSmoothNum=steps, Selected=False)
    for steps in HC_STEPS:
        scripts[f"HC {steps}"] = _filter("HC Laplacian Smooth") * steps
    return scripts


def filters(shape):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shape.write_welded(folder / "in.ply")
        for setting, script in settings().items():
            (folder / "script.mlx").write_text("<!DOCTYPE FilterScript>\n<FilterScript>"
                                               f"{script}</FilterScript>\n")
            # It draws nothing, but does not start without a screen.
            subprocess.run(["xvfb-run", "-a", "meshlabserver", "-i", folder / "in.ply",
                            "-s", folder / "script.mlx", "-o", folder / "out.ply"],
                           check=True, capture_output=True)
            yield setting, read_ply(folder / "out.ply")[0]
