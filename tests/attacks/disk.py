"""A disk without a byte left. Needs the right to mount, and says so without it."""

import contextlib
import ctypes
import os
import subprocess

import grpc

import scans
from attack import Attack
from client import Client

CLONE_NEWNS = 0x20000


def may_mount():
    """Gives this program, and the programs that it starts, mounts that nobody else sees."""
    if ctypes.CDLL(None).unshare(CLONE_NEWNS) != 0:
        return False
    return subprocess.run(["mount", "--make-rprivate", "/"], capture_output=True).returncode == 0


@contextlib.contextmanager
def small_disk(folder, mib):
    subprocess.run(["mount", "-t", "tmpfs", "-o", "mode=700,size=%dm" % mib, "tmpfs", folder],
                   check=True)
    try:
        yield
    finally:
        subprocess.run(["umount", folder], check=True)


def fill(folder):
    """Leaves no byte free there."""
    part = 1 << 20
    with open(os.path.join(folder, "other-program.log"), "ab", buffering=0) as file:
        while part:
            try:
                file.write(b"x" * part)
            except OSError:
                part //= 2


class FullDiskLeavesAServerThatStarts(Attack):
    """Another program fills the disk again after each start. Both kinds of end leave other files, and so
    does an end before anybody has edited on the full disk."""
    finding = "N6"
    disk_mib = 400
    starts = property(lambda self: self.size(4, 8))

    def prepare(self, server):
        self.story = "not tried: this user may not mount a disk"
        if not may_mount():
            return
        server.halt()
        with small_disk(server.data, self.disk_mib):
            server.start()
            self.fill_and_start(server)
            server.halt()
        server.start()

    def fill_and_start(self, server):
        owner = Client(server, "olga")
        for name, rows in (("kept", 20), ("spare", 22)):
            owner.import_scan(name, scans.sphere(rows))
        owner.ask("OpenSession", scan="kept", name="work")
        owner.slide("work", "before")
        for start in range(self.starts):
            if start >= 2:
                self.edit_on_the_full_disk(server, start)
            server.halt(politely=start % 2 == 1)
            fill(server.data)
            server.start()
        self.check_that_the_owner_makes_room(server)
        self.story = "%d starts without a free byte" % self.starts

    def edit_on_the_full_disk(self, server, start):
        fill(server.data)
        if Client(server, "olga").code("Apply", session="work", edits=[
                dict(id="full-%d" % start, gradient_scale=dict(beta=2))]) == "OK":
            self.hole("an edit was acknowledged without a byte to write it to")

    def check_that_the_owner_makes_room(self, server):
        owner = Client(server, "olga")
        try:
            owner.ask("DeleteScan", scan="spare")
        except grpc.RpcError as error:
            self.hole("on a full disk an owner cannot delete a scan: " + error.details())
            return
        owner.slide("work", "after")
        edits = [entry.edit_id for entry in owner.ask("GetHistory", session="work").entries]
        if edits != ["before", "after"]:
            self.hole("the history has " + ", ".join(edits))

    def attack(self, server):
        return self.story
