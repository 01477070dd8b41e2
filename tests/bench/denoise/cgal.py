"""Filters of CGAL, which has headers alone: compiles a program that applies them."""

import functools
import pathlib
import subprocess
import tempfile

from .shape import read_ply

SOURCE = pathlib.Path(__file__).with_name("cgal_filters.cpp")


BUILD = tempfile.TemporaryDirectory()  # ends with this process


@functools.cache
def _program() -> pathlib.Path:
    program = pathlib.Path(BUILD.name) / "cgal_filters"
    subprocess.run(["g++", "-std=c++17", "-O2", "-DNDEBUG", "-I/usr/include/eigen3", SOURCE,
                    "-o", program, "-lgmp"], check=True)
    return program


def filters(shape):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        shape.write_welded(folder / "in.ply")
        results = folder / "results"
        results.mkdir()
        subprocess.run([_program(), folder / "in.ply", results], check=True)
        for path in sorted(results.iterdir()):
            yield path.stem, read_ply(path)[0]
