"""Edits files on this computer, without a server, by the program `burnish`."""

from __future__ import annotations

import collections
import dataclasses
import json
import os
import pathlib
import signal
import subprocess
import tempfile
import threading
from typing import TYPE_CHECKING, Any, Sequence, TypeVar, cast, overload

import numpy.typing as npt

from ._channel import PathLike
from .arrays import ArrayFile
from .errors import Error, InvalidArgument, error_of
from .libraries import held
from .options import Options, OptionWords, edits_colours, options_of, shows_options
from .program import find_program
from .progress import Progress, Whole, whole

if TYPE_CHECKING:
    from typing import Unpack

AnyMesh = TypeVar("AnyMesh")
USAGE = 2  # the program's exit code for wrong options


@dataclasses.dataclass(frozen=True)
class Filtered:
    """What became of a file."""

    source: pathlib.Path
    target: pathlib.Path
    outcome: str
    """done, skipped (the target was there) or failed."""
    error: Error | None
    facts: dict[str, Any]
    """Of a file that is done: vertices, triangles, depth, cycles, converged, distance (over the
    box's diagonal), seconds."""


@shows_options
def filter(source: PathLike, target: PathLike, *, progress: Progress | None = None,
           overwrite: bool = True, **options: Unpack[OptionWords]) -> Filtered:
    """Edits a mesh file and writes `target`. `options` are the fields of Options.

    In the format of `source` the file keeps all that it has. With `overwrite=False` a file that is
    there stays, and the outcome is "skipped". Raises Refused, Error.
    """
    with whole(progress) as of:
        one, = _run([source, target], [] if overwrite else ["--no-clobber"], options_of(options), of)
        if one.error is not None:
            raise one.error
    return one


@shows_options
def filter_all(sources: Sequence[PathLike], folder: PathLike, *,
               progress: Progress | None = None, overwrite: bool = True,
               **options: Unpack[OptionWords]) -> list[Filtered]:
    """Edits files, and writes each under its name into `folder`, which is made.

    A file that fails does not end the work: its entry has the error. Each file has a process of its
    own, so one that ends for want of memory is one such entry. `progress` gets phases with the
    file's name: "a.ply: solve". `options` are the fields of Options. Raises InvalidArgument for two
    files of one name, or a wrong option.
    """
    names = collections.Counter(pathlib.Path(source).name for source in sources)
    if twice := [name for name, count in names.items() if count > 1]:
        raise InvalidArgument(f"{names[twice[0]]} files have the name '{twice[0]}', 1 at most")
    words = [f"--out-dir={os.fspath(folder)}", *([] if overwrite else ["--no-clobber"])]
    done: list[Filtered] = []
    for i, source in enumerate(sources):
        name = pathlib.Path(source).name
        with whole(progress, i / len(sources), (i + 1) / len(sources), f"{name}: ") as of:
            try:
                done += _run([source], words, options_of(options), of)
            except _Ended as error:
                target = pathlib.Path(folder) / name
                done.append(Filtered(pathlib.Path(source), target, "failed", error, {}))
    return done


class _Ended(Error):
    """The program has ended without an answer."""


@overload
def filter_vertices(vertices: npt.ArrayLike, faces: Any, *, colours: None = None,
                    progress: Progress | None = None, **options: Unpack[OptionWords]) -> npt.NDArray[Any]: ...


@overload
def filter_vertices(vertices: npt.ArrayLike, faces: Any, *, colours: npt.ArrayLike,
                    progress: Progress | None = None,
                    **options: Unpack[OptionWords]) -> tuple[npt.NDArray[Any], npt.NDArray[Any]]: ...


@shows_options
def filter_vertices(vertices: Any, faces: Any, *, colours: Any = None,
                    progress: Progress | None = None, **options: Unpack[OptionWords]) -> Any:
    """Returns the vertices of an edited surface, n x 3, in the order and float type of `vertices`.

    `faces`: m x 3, m x 4, m x k with -1 behind a face's last vertex, flat as VTK has them
    (n i0 i1 ... n i0 i1 ...), or a sequence of sequences. `colours`: n x 3 or n x 4, uint8 or floats
    of 0 to 1; with them it returns a pair, the vertices and the colours, whose alpha stays.
    `options` are the fields of Options. Raises ValueError, TypeError for arrays that are not a
    surface; Refused, Error.
    """
    file, chosen = ArrayFile(vertices, faces, colours), options_of(options)
    with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
        source, target = pathlib.Path(folder) / "in.ply", pathlib.Path(folder) / "out.ply"
        source.write_bytes(file.to_bytes())
        try:
            with whole(progress) as of:
                one, = _run([source, target], [], chosen, of)
                if one.error is not None:
                    raise one.error
        except Error as error:
            raise type(error)(error.message.replace(str(source), "the mesh")) from None
        places, edited = file.read(target.read_bytes())
    return places if edited is None else (places, edited)


@shows_options
def filter_mesh(mesh: AnyMesh, *, progress: Progress | None = None, **options: Unpack[OptionWords]) -> AnyMesh:
    """Returns an edited copy of a mesh, of the same type; the given one stays as it is.

    `mesh` is a Mesh, or one of trimesh, Open3D, PyVista, VTK, meshio, PyMeshLab or Blender. What
    the library keeps beside the positions stays, normals too. `options` are the fields of Options;
    `colour_beta`, `texture_gain` and `remove_light` edit the colours of vertices. Raises TypeError
    for other things; ValueError; Refused, Error.
    """
    given = held(mesh)
    if given.colours is None or not edits_colours(options):
        return cast(AnyMesh, given.rebuild(filter_vertices(
            given.vertices, given.faces, progress=progress, **options), None))
    return cast(AnyMesh, given.rebuild(*filter_vertices(
        given.vertices, given.faces, colours=given.colours, progress=progress, **options)))


def _run(files: Sequence[PathLike], words: list[str], options: Options,
         of: Whole) -> list[Filtered]:
    command = [find_program(), "filter", "--json", "--progress=json", *words, *options.words(),
               "--", *(os.fspath(file) for file in files)]
    process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    found: list[str] = []
    assert process.stdout is not None and process.stderr is not None
    reader = threading.Thread(target=lambda: found.append(process.stdout.read()))  # type: ignore
    reader.start()
    messages: list[str] = []
    try:
        for line in process.stderr:
            _take_line(line, of, messages)
        code = process.wait()
    finally:
        process.kill()
        process.wait()
        reader.join()
        process.stdout.close()
        process.stderr.close()
    if code == USAGE:
        raise InvalidArgument("".join(messages).strip())
    if code < 0:
        raise _Ended(f"burnish filter was ended by {_name_of(-code)}")
    return _outcomes(found[0], messages)


def _name_of(number: int) -> str:
    try:
        name = f"signal {number} ({signal.Signals(number).name})"
    except ValueError:
        name = f"signal {number}"
    return name + ", as a machine without memory does" if number == signal.SIGKILL else name


def _take_line(line: str, of: Whole, messages: list[str]) -> None:
    if not line.startswith("{"):
        messages.append(line)
    else:
        step = json.loads(line)
        of.tell(step["phase"], step["fraction"])


def _outcomes(text: str, messages: list[str]) -> list[Filtered]:
    try:
        answer = json.loads(text)
    except ValueError:
        raise _Ended("burnish filter: " + "".join(messages).strip()) from None
    if "code" in answer:
        raise error_of(answer["code"], answer["message"])
    return [Filtered(pathlib.Path(one.pop("in")), pathlib.Path(one.pop("out")),
                     one.pop("outcome"),
                     error_of(one["code"], one["message"]) if "code" in one else None, one)
            for one in answer["files"]]
