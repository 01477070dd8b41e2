"""Requests within all limits of a message that take much memory and disk."""

import threading
import time

import grpc

import scans
from attack import MIB, Attack
from client import PATIENCE_S, Client, end_of, outcome_of, request

CALLS_IN_FLIGHT = 60
ZIP = 6  # MESH_FORMAT_ZIP


class TinyScanTakesNoGigabytes(Attack):
    """Two triangles at a depth that gives them millions of cells."""
    finding = "H4"
    config = "[limits]\nmemory_bytes_max = 134217728\n"
    growth_mib_max = 250
    disk_mib_max = 250

    def attack(self, server):
        mallory, before = Client(server, "mallory"), server.data_bytes()
        file = scans.two_triangles()
        try:
            mallory.import_scan("tiny", file, self.size(10, 11), scans.sha256(file))
            outcome = "accepted"
        except grpc.RpcError as error:
            outcome = error.code().name + ": " + error.details()
        disk = (server.data_bytes() - before) / MIB
        if disk > self.disk_mib_max:
            self.hole("%d MiB of disk for a scan of %d bytes" % (disk, len(file)))
        return "%d bytes: %s, %d MiB of disk" % (len(file), outcome[:120], disk)


class PicturesTakeNoMemoryForTheirPixels(Attack):
    """An archive of kilobytes with a picture of 224 million pixels."""
    finding = "N4"
    config = "[limits]\nmemory_bytes_max = 300000000\n"
    growth_mib_max = 150
    answer_s_max = 10

    def attack(self, server):
        mallory, file = Client(server, "mallory"), scans.textured_zip(15000, 14900)
        try:
            mallory.import_scan("skin", file, 4, scans.sha256(file), format=ZIP)
            outcome = "accepted"
        except grpc.RpcError as error:
            outcome = error.code().name + ": " + error.details()
        return "%d bytes: %s" % (len(file), outcome[:160])


class OtherRadiiFillNoDisk(Attack):
    """Every averaging radius is another prepared file."""
    finding = "H4"
    scan_rows = 60
    disk_mib_max = 100

    def attack(self, server):
        mallory, before = Client(server, "mallory"), server.data_bytes()
        prepared = 0
        for number in range(self.size(12, 100)):
            call = mallory.read("PrepareScan", scan="scan", depth=7, curvature_radius=10.0 ** -(9 * number))
            prepared += end_of(call) == "OK"
        disk = (server.data_bytes() - before) / MIB
        if disk > self.disk_mib_max:
            self.hole("%d MiB of disk for %d radii of one scan" % (disk, prepared))
        return "%d files, %d MiB" % (prepared, disk)


class DoubledCellsAreRefused(Attack):
    """One cell a million times, in a scan of a few thousand."""
    finding = "M6"

    def attack(self, server):
        mallory = Client(server, "mallory")
        mallory.ask("OpenSession", scan="scan", name="cells")
        cells, uploads = self.size(400_000, 4_000_000), self.size(2, 5)
        cell = self.find_cell(mallory)
        header = request("UploadCellFields", header=dict(session="cells", edit_id="", cells=cells))
        part = request("UploadCellFields", cells=dict(
            cells=[cell] * 50_000))
        before, outcomes = server.data_bytes(), []
        for number in range(uploads):
            header.header.edit_id = "cells-%d" % number
            try:
                mallory.send("UploadCellFields", [header] + [part] * (cells // 50_000))
                outcomes.append("OK")
            except grpc.RpcError as error:
                outcomes.append(error.code().name)
        if "OK" in outcomes:
            self.hole("%d times one cell accepted, %d MiB of disk"
                      % (cells, (server.data_bytes() - before) // MIB))
        return ", ".join(outcomes)

    @staticmethod
    def find_cell(client):
        """Returns a cell of the scan: the line through the middle of the grid meets the sphere."""
        depth = client.ask("GetState", session="cells").session.depth
        for k in range(1 << depth):
            cell = dict(i=1 << (depth - 1), j=1 << (depth - 1), k=k, alpha1=50, alpha2=50, beta=1)
            edit = dict(id="one-%d" % k, cell_fields=dict(cells=[cell]))
            if client.code("Apply", session="cells", edits=[edit]) == "OK":
                return cell
        raise RuntimeError("no cell of the scan was found")


class LookingIsCountedAsOpening(Attack):
    """A viewer's GetState brings sessions into memory, past sessions_per_user."""
    finding = "M6"
    config = "[limits]\nsessions_per_user = 3\n"
    witness_session = ""

    def prepare(self, server):
        for user in ("alice", "bert", "mallory"):
            for number in range(3):
                Client(server, user).ask("OpenSession", scan="scan", name="%s-%d" % (user, number))
        server.restart()

    def attack(self, server):
        vera = Client(server, "vera")
        sessions = [session.name for session in vera.ask("ListSessions").sessions]
        codes = [vera.code("GetState", session=name) for name in sessions]
        in_memory = sum(session.in_memory for session in vera.ask("ListSessions").sessions)
        if in_memory > 3:
            self.hole("one viewer holds %d sessions in memory, sessions_per_user = 3" % in_memory)
        return "%d of %d in memory; last: %s" % (in_memory, len(sessions), codes[-1])


class PageValuesHoldNoWorkersFromOthers(Attack):
    """A viewer asks for the values of as many pages as the scan has, in dozens of calls at once."""
    finding = "H6"
    scan_rows = 300
    answer_s_max = 3
    growth_mib_max = 600
    config = 'workers = 4\n'

    def attack(self, server):
        vera = Client(server, "vera")
        if self.code_of(vera, [0, 0]) != "INVALID_ARGUMENT":
            self.hole("a page may be named twice")
        self.pages = 4096
        while self.pages > 1 and self.code_of(vera, range(self.pages)) == "INVALID_ARGUMENT":
            self.pages -= max(1, self.pages // 4)
        calls = self.size(CALLS_IN_FLIGHT, 3 * CALLS_IN_FLIGHT)
        self.outcomes, self.end = [], time.monotonic() + self.size(8, 60)
        threads = [threading.Thread(target=self.fetch, args=(vera,), daemon=True)
                   for _ in range(calls)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        return "%d calls of %d pages, %d answered in time" % (calls, self.pages,
                                                              self.outcomes.count("OK"))

    @staticmethod
    def code_of(client, pages, timeout=PATIENCE_S):
        return end_of(client.read("GetPageValues", timeout=timeout, session="others",
                                  value="CELL_VALUE_BETA", pages=pages))

    def fetch(self, vera):
        while time.monotonic() < self.end:
            left = max(1, self.end - time.monotonic())
            self.outcomes.append(self.code_of(vera, range(self.pages), left))


class QueueOfMessagesHasAnEnd(PageValuesHoldNoWorkersFromOthers):
    """Large messages that wait behind those calls."""
    finding = "M8"
    growth_mib_max = 500
    answer_s_max = 60  # another attack measures this

    def attack(self, server):
        calls_before = threading.Thread(target=super().attack, args=(server,), daemon=True)
        calls_before.start()
        time.sleep(0.5)
        mallory = Client(server, "mallory")
        name = "x" * (13 << 20)
        messages = self.size(50, 60)
        calls = [mallory.start("Apply", session="others", timeout=15, edits=[
            dict(id="q%d" % number, set_checkpoint=dict(name=name))]) for number in range(messages)]
        codes = [outcome_of(call) for call in calls]
        calls_before.join()
        return "%d messages of 13 MiB: %s" % (messages, ", ".join(sorted(set(codes))))
