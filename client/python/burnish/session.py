"""Sessions: the editing states of scans."""

from __future__ import annotations

import pathlib
import secrets
import tempfile
from typing import Any, Iterator

import numpy as np
import numpy.typing as npt

from burnish.v1 import common_pb2, editing_pb2, library_pb2

from ._arguments import with_change
from ._calls import Calls
from ._channel import PathLike
from .cells import CELL_VALUES, SingleCells, cell_messages
from .edits import Change, EdgeFilter, GradientScale, TransferCurve, rows
from .files import format_of, receive
from .history import Deviation, Entry, Exported, State
from .live import Live
from .mesh import Mesh, load_ply
from .people import People, role_of
from .progress import Progress, whole
from .scan import EdgeProposal, Prepared, prepared_of, propose_edges

EDITS_MAX = 64
LINES = tuple[list[npt.NDArray[np.float64]], list[npt.NDArray[np.float64]]]


def edit_of(change: Change) -> editing_pb2.Edit:
    """Returns an edit with a random id: a session knows an id that it has seen."""
    return editing_pb2.Edit(id=secrets.token_hex(10), **with_change(change).to_wire())


class Session:
    """A session of a server. Edits come to all that are in it."""

    def __init__(self, calls: Calls, info: editing_pb2.SessionInfo) -> None:
        self._calls, self._editing, self._info = calls, calls.editing, info

    def __repr__(self) -> str:
        return f"<Session {self.name} of scan {self.scan_id[:12]} at depth {self.depth}>"

    @property
    def id(self) -> str:
        """16 hexadecimal digits."""
        return self._info.id

    @property
    def name(self) -> str:
        return self._info.name

    @property
    def scan_id(self) -> str:
        return self._info.scan_id

    @property
    def depth(self) -> int:
        """The grid has 2^depth cells a side."""
        return self._info.depth

    def apply(self, *changes: Change) -> list[int]:
        """Applies 1 to 64 edits, all or none. Returns the number of the entry that each made.

        They are on the server's disk when this returns. Raises Refused.
        """
        cells = [change for change in changes if isinstance(change, SingleCells)]
        if cells and len(changes) == 1:
            return self._upload(cells[0])
        return self._apply(*map(edit_of, changes))

    def _apply(self, *edits: editing_pb2.Edit) -> list[int]:
        request = editing_pb2.ApplyRequest(session=self.id, edits=edits)
        return list(self._calls.ask(self._editing.Apply, request).entries)

    def _upload(self, edit: SingleCells) -> list[int]:
        messages = list(cell_messages(edit, self.id, secrets.token_hex(10)))

        def send() -> Any:
            return self._calls.ask_once(self._editing.UploadCellFields, iter(messages))
        return list(self._calls.repeat(send).entries)

    def set_beta(self, beta: float) -> int:
        """Sets the gradient scale of the whole scan: below 1 smooths, above 1 sharpens; 0 to 10."""
        return self.apply(GradientScale(beta))[0]

    def set_alpha(self, alpha: float) -> int:
        """Sets the fidelity weight (times L): the larger, the finer the detail that is changed."""
        return self.apply(TransferCurve.constant(alpha))[0]

    def set_wavelength(self, wavelength: float) -> int:
        """Sets the fidelity as a length in the scan's units: beta 0 halves waves of this length."""
        return self.set_alpha(self._prepared().alpha_of(wavelength))

    def set_preset(self, name: str, strength: float = 1.0) -> list[int]:
        """Sets beta, the fidelity, the bands and kept edges as a preset of `burnish` does.

        `strength`: how much of it, 0 to 1. `presets()` has the names. Raises NotFound.
        """
        return self.apply(*self.preset(name, strength))

    def preset(self, name: str, strength: float = 1.0) -> list[Change]:
        """Returns the edits that set_preset() makes. Has the server measure the noise if needed."""
        prepared, state = self._prepared(), self.state()
        can_keep_edges = not state.controls.keep_volume
        found = prepared.preset_changes(name, strength, None, can_keep_edges)
        proposal = self.propose_edges() if found.follows_noise else None
        if proposal:
            found = prepared.preset_changes(name, strength, proposal, can_keep_edges)
        changes: list[Change] = [found.curve, found.beta]
        if found.edges == "off" and state.edges.strength > 0:
            changes.insert(0, EdgeFilter(0.0))
        if found.bands.bands or state.bands:
            changes.append(found.bands)
        keeps = found.edges == "auto" and proposal and proposal.filter.strength > 0
        if keeps and proposal and state.edges.strength == 0:
            changes.append(proposal.filter)
        return changes

    def _prepared(self) -> Prepared:
        return prepared_of(self._calls.ask(self._calls.library.DescribeScan, (
            library_pb2.DescribeScanRequest(scan=self.scan_id, depth=self.depth))).prepared)

    def propose_edges(self) -> EdgeProposal:
        """Has the server measure the scan's noise, and say how to keep edges. Changes nothing."""
        return propose_edges(self._calls, self.scan_id)

    def undo(self) -> int:
        """Switches off your newest entry that is on. Raises FailedPrecondition if there is none."""
        return self._apply(_edit(undo=editing_pb2.Undo()))[0]

    def redo(self) -> int:
        """Switches on what your last undo switched off. Raises FailedPrecondition."""
        return self._apply(_edit(redo=editing_pb2.Redo()))[0]

    def switch(self, entry: int, enabled: bool) -> None:
        """Switches an entry of the history, by its number, off or on. Raises NotFound."""
        self._apply(_edit(switch_entry=editing_pb2.SwitchEntry(entry=entry, enabled=enabled)))

    def checkpoint(self, name: str) -> None:
        """Names the present state."""
        self._apply(_edit(set_checkpoint=editing_pb2.SetCheckpoint(name=name)))

    def restore(self, name: str) -> None:
        """Switches every entry to its state at the checkpoint. Raises NotFound."""
        self._apply(_edit(restore_checkpoint=editing_pb2.RestoreCheckpoint(name=name)))

    def history(self) -> Iterator[Entry]:
        """Yields all entries, on and off, by number."""
        after, complete = 0, False
        while not complete:
            page = self._calls.ask(self._editing.GetHistory, editing_pb2.GetHistoryRequest(
                session=self.id, after=after))
            yield from map(Entry.of, page.entries)
            complete = page.complete
            after = page.entries[-1].number if page.entries else after

    def state(self) -> State:
        """Returns how the session is set, and how far it is solved."""
        return State.of(self._calls.ask(self._editing.GetState, editing_pb2.GetStateRequest(
            session=self.id)))

    def deviation(self) -> Deviation:
        """Measures how far the edits moved the surface, as it is now."""
        return Deviation.of(self._calls.ask(self._editing.GetDeviation, (
            editing_pb2.GetDeviationRequest(session=self.id))))

    def section(self, point: npt.ArrayLike, direction: npt.ArrayLike) -> LINES:
        """Cuts the scan and the present surface with the plane through `point` across `direction`.

        Returns the lines of both, each n x 2 (right, up from `point`), the scan's units.
        """
        found = self._calls.ask(self._editing.GetSection, editing_pb2.GetSectionRequest(
            session=self.id, point=_point(point), direction=_point(direction)))
        return _lines(found.original), _lines(found.edited)

    def cells(self, value: str) -> npt.NDArray[np.float32]:
        """Returns a value per cell of the surface, in Morton order.

        `value`: beta, kappa1, kappa2, alpha1, alpha2 (all times L), protected or curve.
        """
        if value not in CELL_VALUES:
            raise ValueError(f"value {value!r} is not one of {', '.join(CELL_VALUES)}")
        request = editing_pb2.GetCellsRequest(session=self.id, value=CELL_VALUES[value])
        chunks: list[common_pb2.Chunk] = self._calls.repeat(lambda: list(self._calls.stream(
            self._editing.GetCells, request)))
        return np.frombuffer(b"".join(chunk.data for chunk in chunks), "<f4")

    def export(self, path: PathLike, *, exact: bool = False, cycles: int = 0,
               progress: Progress | None = None) -> Exported:
        """Solves, and writes the edited mesh. In the scan's own format it is the imported file with
        other positions.

        It solves to rest; with `exact` to the accuracy of final results; with `cycles` for 1 to
        10000 cycles. An archive (.zip) has the files that came with the scan. The file is in its
        place when it is whole. Raises Refused, Damaged, OSError.
        """
        until: dict[str, Any] = {"exact": True} if exact else {}
        if cycles:
            until["cycles"] = cycles
        request = editing_pb2.ExportRequest(session=self.id, format=format_of(path), **until)

        with whole(progress) as of:
            def write() -> Any:
                return receive(self._calls.stream(self._editing.Export, request), path, of)
            return Exported.of(self._calls.repeat(write))

    def mesh(self, *, exact: bool = False) -> Mesh:
        """Solves, and returns the edited mesh, in the order of the scan's file.

        Raises InvalidArgument for a scan in a PLY with text or with other faces than triangles.
        """
        with tempfile.TemporaryDirectory(prefix="burnish-") as folder:
            path = pathlib.Path(folder) / "mesh.ply"
            self.export(path, exact=exact)
            return load_ply(path)

    def live(self, *, triangles_max: int = 1_000_000, level: int | None = None,
             vertices: npt.ArrayLike | None = None) -> Live:
        """Joins the session. See Live.

        With `vertices`, n x 3, those of the scan's file, frames are in their order. All of the scan
        is shown then, at most 4096 pages of it. Raises ValueError if they are not the scan's.
        """
        return Live(self._calls, self._info, triangles_max=triangles_max, level=level,
                    vertices=vertices)

    def people(self) -> People:
        """Returns who may do what here, and who is there."""
        return People.of(self._calls.ask(self._editing.GetPeople, editing_pb2.GetPeopleRequest(
            session=self.id)))

    def set_role(self, user: str, role: str) -> None:
        """Gives a user the role viewer, editor or owner; "" is everybody without one of their own."""
        self._calls.ask(self._editing.SetRole, editing_pb2.SetRoleRequest(
            session=self.id, user=user, role=role_of(role)))

    def fork(self, name: str = "", *, until: int | str | None = None, depth: int = 0) -> Session:
        """Returns a new session with the edits of this one, up to a number or a checkpoint.

        At another `depth` edits of single cells set nothing; 0: at this one.
        """
        request = editing_pb2.ForkSessionRequest(session=self.id, name=name, depth=depth)
        if isinstance(until, str):
            request.checkpoint = until
        elif until is not None:
            request.number = until
        return Session(self._calls, self._calls.ask_once(self._editing.ForkSession,
                                                         request).session)

    def rename(self, name: str) -> None:
        """Gives the session another name. Raises AlreadyExists."""
        self._info = self._calls.ask(self._editing.RenameSession, (
            editing_pb2.RenameSessionRequest(session=self.id, name=name)))

    def close(self) -> None:
        """Sends all users out and unloads the session. Its edits stay."""
        self._calls.ask(self._editing.CloseSession, editing_pb2.CloseSessionRequest(
            session=self.id))

    def delete(self) -> None:
        """Closes the session and deletes its edits."""
        self._calls.ask_once(self._editing.DeleteSession, editing_pb2.DeleteSessionRequest(
            session=self.id))


def _edit(**change: Any) -> editing_pb2.Edit:
    return editing_pb2.Edit(id=secrets.token_hex(10), **change)


def _point(values: npt.ArrayLike) -> common_pb2.Point:
    (x, y, z), = rows(np.reshape(values, (1, -1)), 3, "a point")
    return common_pb2.Point(x=x, y=y, z=z)


def _lines(lines: Any) -> list[npt.NDArray[np.float64]]:
    return [np.array(line.points, np.float64).reshape(-1, 2) for line in lines]
