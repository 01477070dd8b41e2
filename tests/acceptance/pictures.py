"""A textured scan: edited colours go into its pictures, and views show its texels, alike by every front."""

import functools
import pathlib
import tempfile
import zipfile

import burnish
import numpy as np
from png_file import decoded, encoded

import fronts

SIDE = 256  # texels
GUTTER = 4  # texels that the change goes on beyond the triangles
SMOOTH = [("--colour-beta", "0"), ("--colour-alpha", "5")]
STRONG = [("--texture-gain", "2"), ("--remove-light", "0.5")]
LEVEL = [("--level-seams", "1")]
VIEW = ["camera 0 0", "colour scan", "light unlit"]
LIKE_VIEW = ["--view", "0,0", "--light", "unlit", "--size", "320x240"]
WAVE = 12  # texels
PATTERN_SIDE = 8  # units
LARGE_SIDE, LARGE_WAVE = 2048, 5
FACE_SIDE, DRAPERY_SIDE, FACE_WAVE, FACE_ZOOM = 388, 248, 6, 8
FACE_VIEW = ["camera 0 0 9 20 20 0", "colour scan", "light unlit"]
CLOSE_VIEW = ["camera 0 0 0.6 1.7 1.7 0", *VIEW[1:]]


def make_scan(folder, vertices):
    """Writes an OBJ, its material and a noisy picture with a stain. Returns the OBJ's file."""
    plain = folder / "plain.ply"
    fronts.run("generate", "tablet", plain, "--vertices", vertices)
    mesh = burnish.load_ply(plain)
    low, high = mesh.vertices.min(0), mesh.vertices.max(0)
    across, down = np.argsort(low - high)[:2]
    places = (mesh.vertices - low) / (high - low)
    coordinates = 0.1 + 0.8 * places[:, [across, down]]
    lines = ["mtllib skin.mtl", "usemtl skin"]
    lines += ["v " + " ".join(map(repr, place)) for place in mesh.vertices.tolist()]
    lines += [f"vt {u!r} {v!r}" for u, v in coordinates.tolist()]
    lines += ["f " + " ".join(f"{i + 1}/{i + 1}" for i in face) for face in mesh.faces.tolist()]
    y, x = np.mgrid[:SIDE, :SIDE] / SIDE
    stain = 60 * np.exp(-((x - 0.4) ** 2 + (y - 0.5) ** 2) / 0.02)
    noise = np.random.default_rng(1).integers(-8, 9, (SIDE, SIDE, 3))
    texels = (150 - stain[..., None] + noise).astype(np.uint8)
    scan = folder / "scan.obj"
    scan.write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "skin.mtl").write_text("newmtl skin\nmap_Kd skin.png\n", encoding="utf-8")
    (folder / "skin.png").write_bytes(encoded(texels))
    return scan


def check_picture(before, after, stain_gain, grain_gain):
    """The stain is fainter, the grain has its gain, and nothing far from the surface changes."""
    before, after = decoded(before), decoded(after)
    edge = int(0.1 * SIDE) - GUTTER - 1
    far = np.ones((SIDE, SIDE), bool)
    far[edge:-edge, edge:-edge] = False
    assert np.array_equal(before[far], after[far]), "texels beyond the surface changed"
    inner = slice(int(0.2 * SIDE), int(0.8 * SIDE))
    blocks = (16, inner.stop - inner.start)
    def coarse(texels):
        part = texels[inner, inner].astype(float)[:blocks[1] // 16 * 16, :blocks[1] // 16 * 16]
        return part.reshape(blocks[1] // 16, 16, blocks[1] // 16, 16, 3).mean((1, 3))
    assert coarse(after).std() < stain_gain * coarse(before).std(), "the stain is as it was"
    grain = [np.diff(texels[inner, inner], axis=1).std() for texels in (before, after)]
    assert 0.8 < grain[1] / grain[0] / grain_gain < 1.25, f"the grain went from {grain[0]:.1f} to {grain[1]:.1f}"


def check_scan(socket, vertices):
    """Returns how many texels changed. Raises AssertionError for what is not true."""
    with tempfile.TemporaryDirectory(prefix="burnish-") as name:
        folder = pathlib.Path(name)
        scan = make_scan(folder, vertices)
        before = (folder / "skin.png").read_bytes()
        same = folder / "same.zip"
        fronts.run("filter", scan, same, "--beta", 1)
        assert _entry(same, "skin.png") == before, "β = 1 changed the picture"
        fronts.run("filter", scan, folder / "kept.zip", "--texture-gain", 1, "--remove-light", 0)
        assert _entry(folder / "kept.zip", "skin.png") == before, "a gain of 1 changed the picture"
        server = fronts.Server(socket, same)
        _try_settings(scan, SMOOTH, (0.8, 1), server)
        return _try_settings(scan, STRONG, (1, 2), server)


def _try_settings(scan, settings, gains, server):
    """Compares all ways. Returns how many texels changed."""
    folder, words = scan.parent, [word for setting in settings for word in setting]
    before = (folder / "skin.png").read_bytes()
    packed, spread = folder / f"out{gains[1]}.zip", folder / f"out{gains[1]}"
    spread.mkdir()
    told = fronts.run("filter", scan, packed, "--exact", *words)
    assert "1 of 1 pictures changed" in told, told
    after = _entry(packed, "skin.png")
    check_picture(before, after, *gains)
    for entry in ("scan.obj", "skin.mtl"):
        assert _entry(packed, entry) == (folder / entry).read_bytes(), f"{entry} changed"
    fronts.run("filter", scan, spread / "scan.obj", "--exact", *words)
    assert (spread / "skin.png").read_bytes() == after, "files beside the mesh differ"
    assert (folder / "skin.png").read_bytes() == before, "the scan's own picture changed"
    for way in (server.by_commands, server.by_script):
        exported = folder / f"{way.__name__}{gains[1]}.zip"
        way(settings, exported)
        assert _entry(exported, "skin.png") == after, f"{way.__name__} differs from the filter"
    return told.strip().splitlines()[-1].split(", ")[-1]


def check_seams(socket, page):
    """Returns the steps before and after, of the file and of each view. `page`: None without one.

    Raises AssertionError for what is not true.
    """
    with tempfile.TemporaryDirectory(prefix="burnish-") as name:
        folder = pathlib.Path(name)
        scan, seam = make_photos(folder)
        before = (folder / "skin.png").read_bytes()
        packed, same = folder / "level.zip", folder / "photos.zip"
        told = fronts.run("filter", scan, packed, *LEVEL[0])
        assert "seams of 2 charts levelled" in told, told
        after = _entry(packed, "skin.png")
        steps = [_step(decoded(file), seam) for file in (before, after)]
        assert steps[1] <= 0.3 * steps[0], f"the step went from {steps[0]:.1f} to {steps[1]:.1f}"
        fronts.run("filter", scan, same, *LEVEL[0], "--edit", "texture 1 0 0")
        assert _entry(same, "skin.png") == before, "seams that are kept changed the picture"
        server = fronts.Server(socket, same)
        for way in (server.by_commands, server.by_script):
            exported = folder / f"{way.__name__}.zip"
            way(LEVEL, exported)
            assert _entry(exported, "skin.png") == after, f"{way.__name__} differs from the filter"
        return {"file": steps} | _check_views(server, page, steps, folder)


def _check_views(server, page, of_file, folder):
    """Levelled seams are as level in a view as in the file, and undo brings them back."""
    shown = {"script": server.shown_by_script}
    if page:
        shown["page"] = functools.partial(server.shown_by_page, page)
    found = {}
    for name, show in shown.items():
        with server.opened() as session:
            steps = []
            for lines in ([], ["texture 1 0 1"], ["undo"]):
                out = folder / f"{name}{len(steps)}.png"
                show(session, [*VIEW, *lines], out)
                steps.append(_shown_step(decoded(out.read_bytes())))
        for step, wanted in zip(steps, of_file):
            assert abs(step - wanted) < 3, f"{name} shows a step of {step:.1f}, the file has {wanted:.1f}"
        assert steps[1] <= 0.3 * steps[0], f"{name} shows a step from {steps[0]:.1f} to {steps[1]:.1f}"
        assert abs(steps[2] - steps[0]) < 1, f"{name} shows a step of {steps[2]:.1f} after undo"
        found[name] = steps[:2]
    return found


def _shown_step(picture):
    """Returns the step in a picture of VIEW, whose seam is the middle column."""
    rows, columns, _ = picture.shape
    means = picture[rows * 2 // 5:rows * 3 // 5].astype(float).mean((0, 2))
    middle, beside = columns // 2, columns // 40
    return abs(means[middle - beside:middle - 1].mean() - means[middle + 1:middle + beside].mean())


def check_sharpness(socket, page):
    """Returns the contrast of every way to draw, as a part of the pattern's. `page`: None without one.

    Raises AssertionError for what is not true.
    """
    with tempfile.TemporaryDirectory(prefix="burnish-") as name:
        folder = pathlib.Path(name)
        scan = make_pattern(folder)
        packed = folder / "packed.zip"
        fronts.run("filter", scan, packed, "--beta", 1)
        pattern = _contrast(decoded((folder / "skin.png").read_bytes()))
        shown = _drawn_files(scan, packed, folder) | _drawn_session(fronts.Server(socket, packed), page, folder)
        parts = {way: _contrast(picture) / pattern for way, picture in shown.items()}
        for way, part in parts.items():
            assert 0.8 < part < 1.05, f"{way} shows {part:.2f} of the pattern's contrast"
        apart = np.abs(shown["render"] - shown["script"]).max(2)
        assert np.quantile(apart, 0.95) < 12, f"render and script differ by {np.quantile(apart, 0.95)} levels"
        fronts.run("render", scan, folder / "clay.png", "--clay", *LIKE_VIEW)
        clay = _contrast(decoded((folder / "clay.png").read_bytes())) / pattern
        assert clay < 0.1, f"clay shows {clay:.2f} of the pattern's contrast"
        return parts


def check_close_view(socket, page):
    """Returns the contrast of a large picture on few triangles, looked at closely, as check_sharpness() does."""
    with tempfile.TemporaryDirectory(prefix="burnish-") as name:
        folder = pathlib.Path(name)
        packed = folder / "packed.zip"
        fronts.run("filter", make_pattern(folder, 4, LARGE_SIDE, LARGE_WAVE), packed, "--beta", 1)
        pattern = _contrast(decoded((folder / "skin.png").read_bytes()))
        shown = _drawn_session(fronts.Server(socket, packed), page, folder, CLOSE_VIEW)
        parts = {way: _contrast(picture) / pattern for way, picture in shown.items()}
        for way, part in parts.items():
            assert 0.7 < part < 1.05, f"{way} shows {part:.2f} of the pattern's contrast"
        return parts


def check_dense_part(socket, page):
    """Returns the contrast of a face beside a coarser drapery, as check_sharpness() does."""
    with tempfile.TemporaryDirectory(prefix="burnish-") as name:
        folder = pathlib.Path(name)
        scan = make_face(folder)
        packed = folder / "packed.zip"
        fronts.run("filter", scan, packed, "--beta", 1)
        pattern = _contrast(decoded((folder / "skin.png").read_bytes())[:FACE_SIDE, :FACE_SIDE])
        shown = (_drawn_files(scan, packed, folder, FACE_ZOOM)
                 | _drawn_session(fronts.Server(socket, packed), page, folder, FACE_VIEW))
        parts = {way: _contrast(picture) / pattern for way, picture in shown.items()}
        for way, part in parts.items():
            assert 0.7 < part < 1.05, f"{way} shows {part:.2f} of the face's contrast"
        return parts


def check_scale_bar(socket, page):
    """Returns the bar's length in units, by every way to draw. `page`: None without one.

    Raises AssertionError for what is not true.
    """
    with tempfile.TemporaryDirectory(prefix="burnish-") as name:
        folder = pathlib.Path(name)
        scan = make_pattern(folder)
        packed = folder / "packed.zip"
        fronts.run("filter", scan, packed, "--beta", 1)
        fronts.run("render", scan, folder / "render.png", *LIKE_VIEW, "--orthographic", "--scale-bar", "mm")
        shown = {"render": decoded((folder / "render.png").read_bytes())}
        view = ["orthographic on", *VIEW, "scale_bar on"]
        shown |= _drawn_session(fronts.Server(socket, packed), page, folder, view)
        lengths = {way: PATTERN_SIDE * _bar_pixels(picture) / _side_of_pattern(picture)
                   for way, picture in shown.items()}
        for way, length in lengths.items():
            apart = min(abs(length / round_one - 1) for round_one in (0.5, 1, 2, 5))
            assert apart < 0.03, f"{way} has a bar of {length:.2f} units"
        return lengths


def _side_of_pattern(picture):
    """Returns the pixels between the first and the last that is grey in the middle row."""
    row = picture[picture.shape[0] // 2].astype(int)
    grey = np.flatnonzero(np.ptp(row, axis=1) <= 2)
    return grey[-1] + 1 - grey[0]


def _bar_pixels(picture):
    """Returns the longest row of a mark's ink in the lower right."""
    rows, columns, _ = picture.shape
    ink = (picture[rows * 4 // 5:, columns // 2:] == (230, 232, 235)).all(2)
    return ink.sum(1).max()


def _drawn_files(scan, packed, folder, zoom=1):
    """Returns the pictures that are drawn without a server: of a folder's files, and of an archive."""
    out = {way: folder / f"{way}.png" for way in ("render", "render of an archive")}
    fronts.run("render", scan, out["render"], *LIKE_VIEW, "--zoom", zoom)
    fronts.run("render", packed, out["render of an archive"], *LIKE_VIEW, "--zoom", zoom)
    if zoom == 1:
        out["Python"] = folder / "Python.png"
        burnish.render(scan, out["Python"], view=(0, 0), size=(320, 240), light="unlit")
    return {way: decoded(file.read_bytes()) for way, file in out.items()}


def _drawn_session(server, page, folder, view=VIEW):
    ways = {"script": server.shown_by_script}
    if page:
        ways["page"] = functools.partial(server.shown_by_page, page)
    shown = {}
    for way, show in ways.items():
        with server.opened() as session:
            show(session, view, folder / f"{way}.png")
        shown[way] = decoded((folder / f"{way}.png").read_bytes())
    return shown


def _contrast(picture):
    """Returns how much the middle's columns differ."""
    rows, columns, _ = picture.shape
    middle = picture[rows * 2 // 5:rows * 3 // 5, columns * 2 // 5:columns * 3 // 5]
    return middle.astype(float).mean((0, 2)).std()


def make_pattern(folder, side=PATTERN_SIDE, texels=SIDE, wave=WAVE):
    """Writes a square of 2 side² triangles with a picture of texels². Returns the OBJ's file."""
    lines = ["mtllib skin.mtl", "usemtl skin"]
    lines += [f"v {x} {y} {x * y % 3 / 9}" for y in range(side + 1) for x in range(side + 1)]
    lines += [f"vt {x / side} {y / side}" for y in range(side + 1) for x in range(side + 1)]
    for y in range(side):
        for x in range(side):
            a = y * (side + 1) + x + 1
            b, c, d = a + 1, a + side + 2, a + side + 1
            lines += [f"f {a}/{a} {b}/{b} {c}/{c}", f"f {a}/{a} {c}/{c} {d}/{d}"]
    row = 120 + 60 * np.sin(np.arange(texels) * (2 * np.pi / wave))
    picture = np.broadcast_to(row[None, :, None], (texels, texels, 3)).astype(np.uint8)
    scan = folder / "scan.obj"
    scan.write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "skin.mtl").write_text("newmtl skin\nmap_Kd skin.png\n", encoding="utf-8")
    (folder / "skin.png").write_bytes(encoded(picture))
    return scan


def make_face(folder):
    """Writes a square of 3,200 triangles, whose middle shows more texels than the rest. Returns the OBJ's file."""
    side, begin, end, margin = 40, 14, 26, 4
    size = np.array([FACE_SIDE + DRAPERY_SIDE, FACE_SIDE])
    lines = ["mtllib skin.mtl", "usemtl skin"]
    for y in range(side):
        for x in range(side):
            is_face = begin <= x < end and begin <= y < end
            chart = (0, begin, end - begin, FACE_SIDE) if is_face else (FACE_SIDE, 0, side, DRAPERY_SIDE)
            left, first, quads, texels = chart
            for i, j in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)):
                u, v = margin + np.array([i - first, j - first]) / quads * (texels - 2 * margin) + [left, 0]
                lines += [f"v {i} {j} {i * j % 3 / 9}", f"vt {float(u / size[0])!r} {float(1 - v / size[1])!r}"]
            lines += ["f -4/-4 -3/-3 -2/-2", "f -4/-4 -2/-2 -1/-1"]
    picture = np.full((size[1], size[0], 3), 120, np.uint8)
    picture[:, :FACE_SIDE] = (120 + 60 * np.sin(np.arange(FACE_SIDE) * (2 * np.pi / FACE_WAVE)))[None, :, None]
    scan = folder / "scan.obj"
    scan.write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "skin.mtl").write_text("newmtl skin\nmap_Kd skin.png\n", encoding="utf-8")
    (folder / "skin.png").write_bytes(encoded(picture))
    return scan


def make_photos(folder):
    """Writes a square of two charts from photos of different exposure, its material and picture.

    Returns the OBJ's file, and the columns of texels at the seam: on the left, on the right.
    """
    side, half, margin = 16, SIDE // 2, 8
    lines = ["mtllib skin.mtl", "usemtl skin"]
    lines += [f"v {x} {y} {x * y % 3 / 9}" for y in range(side + 1) for x in range(side + 1)]
    for chart in range(2):  # the right one lies on the left of the picture
        for y in range(side + 1):
            for x in range(side // 2 + 1):
                u = (1 - chart) * half + margin + x / (side // 2) * (half - 2 * margin)
                v = margin + y / side * (SIDE - 2 * margin)
                lines.append(f"vt {u / SIDE!r} {1 - v / SIDE!r}")
    def corner(x, y, chart):
        place = chart * (side + 1) * (side // 2 + 1) + y * (side // 2 + 1) + x - chart * side // 2
        return f"{y * (side + 1) + x + 1}/{place + 1}"
    for y in range(side):
        for x in range(side):
            chart = int(x >= side // 2)
            a, b, c, d = (corner(i, j, chart) for i, j in ((x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)))
            lines += [f"f {a} {b} {c}", f"f {a} {c} {d}"]
    texels = np.full((SIDE, SIDE, 3), 110, np.uint8)
    texels[:, :half] = 140
    texels += np.random.default_rng(1).integers(0, 9, (SIDE, SIDE, 1)).astype(np.uint8)
    scan = folder / "scan.obj"
    scan.write_text("\n".join(lines) + "\n", encoding="utf-8")
    (folder / "skin.mtl").write_text("newmtl skin\nmap_Kd skin.png\n", encoding="utf-8")
    (folder / "skin.png").write_bytes(encoded(texels))
    return scan, (SIDE - margin - 1, margin)


def _step(texels, seam):
    rows = texels[SIDE // 4:-SIDE // 4].astype(float).mean(2)
    left, right = (rows[:, column] for column in seam)
    return abs(np.median(left) - np.median(right))


def _entry(archive, name):
    with zipfile.ZipFile(archive) as opened:
        return opened.read(name)
