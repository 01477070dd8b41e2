"""Names, ids and paths in hostile spellings."""

import random
import urllib.request

import grpc

import scans
from attack import Attack
from client import METHODS, Client, Live, end_of

FORGED = "[2026-11-23 12:00:00.000] [info] user root logged in"


class NamesForgeNoLogLines(Attack):
    finding = "M1"

    def attack(self, server):
        mallory = Client(server, "mallory")
        name = "x\n%s \x1b[31m" % FORGED
        before = server.log_bytes()
        codes = [end_of(mallory.read("Export", session=name, format=1)),
                 end_of(mallory.read("Watch", greeting=dict(session=name, pages=True))),
                 mallory.code("GetState", session=name),
                 mallory.code("OpenSession", scan=name, name=name)]
        live = Live(mallory, name, timeout=10)
        codes.append(end_of(live.answers))
        log = server.log_text()
        if "\n" + FORGED in log:
            self.hole("%d forged lines in the log" % log.count("\n" + FORGED))
        if "\x1b[31m" in log:
            self.hole("the log has escape sequences")
        long = "y" * (4 << 20)
        for method, fields in (("Export", dict(session=long, format=1)),
                               ("Watch", dict(greeting=dict(session=long, pages=True)))):
            end_of(mallory.read(method, **fields))
        written = server.log_bytes() - before
        if written > 64 << 10:
            self.hole("%d KiB of log for 7 calls" % (written >> 10))
        return ", ".join(codes) + "; %d bytes of log" % written


class NamesLeadNowhereElse(Attack):
    """Names in use, look-alikes, and beginnings of ids: each would change what a reference means."""
    finding = "names"
    witness_session = ""

    def attack(self, server):
        olga, mallory = self.owner, Client(server, "mallory")
        file = scans.sphere(5)
        there = olga.import_scan("precious", file, 4, scans.sha256(file))
        wanted = ["precious", "Precious", "precious ", "\u3000precious", "precious\u200b",
                  "\ufeffprecious", "pre\u00adcious", "pre\u200dcious", "ｐrecious", "   ",
                  there[:4], there[:8].upper(), there[:12], there[:63], there]
        for number, name in enumerate(wanted):
            if self.imports(mallory, name, scans.sphere(6 + number), exact_name=True):
                self.hole("a scan was imported as %r" % name)
            self.imports(mallory, name, scans.sphere(6 + number))  # gets another name
        spare = scans.sphere(30)
        mallory.import_scan("spare", spare, 4, scans.sha256(spare))
        for name in wanted:
            if mallory.code("RenameScan", scan="spare", name=name) == "OK":
                self.hole("a scan was renamed to %r" % name)
                mallory.code("RenameScan", scan=name, name="spare")
        names = [scan.name for scan in olga.ask("ListScans").scans]
        for name in wanted[1:]:
            if name in names:
                self.hole("a scan is called %r" % name)
        for reference in ("precious", there[:4], there[:8], there[:12], there):
            if olga.ask("DescribeScan", scan=reference).scan.id != there:
                self.hole("%r leads to another scan" % reference)
        if not self.imports(mallory, "precious", file):
            self.hole("the same bytes cannot be imported again")
        return "%d names tried; scans %s; %d sessions" % (len(wanted), names, self.open_all(mallory))

    @staticmethod
    def imports(client, name, file, **header):
        try:
            client.import_scan(name, file, 4, scans.sha256(file), **header)
            return True
        except grpc.RpcError:
            return False

    def open_all(self, client):
        names = ("open", "open ", " open", "open\u200b", "\ufeffopen", "   ")
        opened = [name for name in names
                  if client.code("OpenSession", scan="precious", name=name, depth=4) == "OK"]
        if len(opened) > 1:
            self.hole("sessions of one look: %r" % opened)
        return len(opened)


class LongNameIsAnsweredAsItself(Attack):
    """A refusal that repeats the name must not be too long to arrive."""
    finding = "protocol 6"

    def attack(self, server):
        mallory = Client(server, "mallory")
        codes = {}
        for size in (300, 10_000, 1 << 20):
            codes[size] = mallory.code("GetState", session="z" * size)
            if codes[size] not in ("NOT_FOUND", "INVALID_ARGUMENT"):
                self.hole("GetState of %d bytes: %s" % (size, codes[size]))
        return ", ".join("%d bytes: %s" % entry for entry in codes.items())


class UserWithoutUtf8EndsNobodysSession(Attack):
    finding = "H3"
    users = False
    witness_session = "shared"

    def attack(self, server):
        latin = Client(server, b"M\xfcller")
        code = latin.code("Apply", session="shared", edits=[dict(id="l", gradient_scale={})])
        present = Live(latin, "shared", timeout=3)
        welcomed = end_of(present.answers)
        present.close()
        return "Apply: %s, stream: %s" % (code, welcomed)

    def check(self, server):
        for method in ("GetHistory", "GetPeople"):
            code = self.owner.code(method, session="shared")
            if code != "OK":
                self.hole("%s of the session: %s" % (method, code))


class UnknownMethodsMakeNoMetrics(Attack):
    finding = "H9"
    flags = ("--metrics", "127.0.0.1:0")
    scrape_kib_max = 2000

    def attack(self, server):
        port = server.announced(rb"metrics on port (\d+)", 0)
        before = self.scrape(port)
        stranger, calls = Client(server), self.size(500, 5000)
        for number in range(calls):
            path = "/evil.%d/%s" % (number, "x" * 1000)
            try:
                stranger.channel.unary_unary(path)(b"", 10)
            except grpc.RpcError:
                pass
        grown = self.scrape(port) - before
        if grown > self.scrape_kib_max << 10:
            self.hole("a scrape is %d KiB larger" % (grown >> 10))
        return "%d unknown methods, a scrape is %d KiB larger" % (calls, grown >> 10)

    @staticmethod
    def scrape(port):
        with urllib.request.urlopen("http://127.0.0.1:%s/metrics" % port, timeout=30) as answer:
            return len(answer.read())


class MutatedMessagesEndNothing(Attack):
    """Random bytes, and valid requests with bytes changed, to every RPC."""
    users = False

    def attack(self, server):
        chance, client, tried = random.Random(7), Client(server, "mallory"), 0
        client.ask("OpenSession", scan="scan", name="fuzzed")
        for _ in range(self.size(40, 2000)):
            for method in METHODS.values():
                kind = "%s_%s" % ("stream" if method.name in ("Edit", "Import", "UploadCellFields") else "unary",
                                  "stream" if method.output_type.name.endswith(("Event", "ServerMessage", "Chunk")) else "unary")
                path = "/%s/%s" % (method.containing_service.full_name, method.name)
                message = self.message(chance, method)
                call = getattr(client.channel, kind)(path)
                sent = iter([message] * 3) if kind.startswith("stream") else message
                self.finish(call, sent, kind)
                tried += 1
            if not server.is_alive():
                break
        return "%d calls" % tried

    @staticmethod
    def message(chance, method):
        fields = b"".join(bytes([number << 3 | 2, 6]) + chance.choice([b"fuzzed", b"\x0a\x04scan"])
                          for number in range(1, 1 + chance.randrange(4)))
        message = bytearray(fields or chance.randbytes(30))
        for _ in range(chance.randrange(4)):
            message[chance.randrange(len(message))] = chance.randrange(256)
        return bytes(message)

    @staticmethod
    def finish(call, sent, kind):
        try:
            answer = call(sent, timeout=1)
            if kind.endswith("stream"):
                for _ in zip(answer, range(3)):
                    pass
                answer.cancel()
        except grpc.RpcError:
            pass
