"""The protocol's Python modules, made by protoc from proto/."""

import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def make_stubs(folder):
    """Makes them in a folder, for this process and for its children."""
    proto = os.path.join(ROOT, "proto")
    files = [os.path.join(proto, "burnish/v1", name)
             for name in ("common.proto", "editing.proto", "library.proto")]
    subprocess.run(["protoc", "-I", proto, "--python_out", folder, *files], check=True)
    for path in (folder, HERE):
        sys.path.insert(0, path)
    os.environ["PYTHONPATH"] = folder + os.pathsep + HERE
    os.environ.setdefault("GRPC_VERBOSITY", "NONE")
