"""Sessions and live streams that a user may open, turned against other users."""

import threading
import time

import grpc

from attack import Attack
from client import Client, Live, end_of, outcome_of


class OpenerWhoGivesUpTakesNobodysEdits(Attack):
    """Two users open one new session; the first gives up while the server makes it."""
    finding = "C3"
    users = False
    scan_rows = 60
    rounds = property(lambda self: self.size(4, 12))
    growth_mib_max = property(lambda self: 250 * self.rounds)  # the sessions stay in memory

    def attack(self, server):
        told, lost = 0, 0
        for round_number in range(self.rounds):
            session = "team-%d" % round_number
            # another radius each time makes the opening take long
            wish = dict(scan="scan", name=session, depth=7,
                        curvature_radius=0.01 + 0.001 * round_number)
            first, second = Client(server), Client(server)
            opening = first.start("OpenSession", **wish)
            if not self.wait_for(second, session, opening):
                continue
            edit = second.start("Apply", session=session, edits=[dict(id="e", gradient_scale={})])
            joining = second.start("OpenSession", **wish) if round_number % 2 else None
            time.sleep(0.05)
            opening.cancel()
            told += outcome_of(edit) == "OK" or (joining is not None and outcome_of(joining) == "OK")
            lost += self.is_lost(second, session, outcome_of(edit) == "OK", joining)
        if lost:
            self.hole("%d of %d sessions that others had been told of are gone" % (lost, told))
        if not told:
            return "no round in which the second had an answer"
        return "%d rounds in which the second was told of success" % told

    @staticmethod
    def wait_for(client, session, opening):
        while not opening.done():
            if any(known.name == session for known in client.ask("ListSessions").sessions):
                return True
        return False

    @staticmethod
    def is_lost(client, session, edit_is_acknowledged, joining):
        attached = joining is not None and outcome_of(joining) == "OK"
        if not edit_is_acknowledged and not attached:
            return False
        try:
            entries = client.ask("GetHistory", session=session).entries
        except grpc.RpcError:
            return True
        return edit_is_acknowledged and [entry.edit_id for entry in entries] != ["e"]


class LargeStrokesStopNobodyElse(Attack):
    """Strokes back and forth between two points, wider than the scan: every dab touches each cell."""
    finding = "H5"
    scan_rows = 100
    answer_s_max = 3

    def attack(self, server):
        mallory = Client(server, "mallory")
        mallory.ask("OpenSession", scan="scan", name="painted")
        live = Live(mallory, "painted")
        live.next("welcome")
        path = [dict(x=0, y=0, z=1), dict(x=0, y=0.5, z=0.87)] * 1900
        stroke = dict(brush=dict(radius=4, strength=0.5, beta=0.5, fall_off=1), path=path)
        live.say(apply=dict(edits=[dict(id="s%d" % number, stroke=stroke)
                                   for number in range(self.size(16, 64))]))
        answer = live.next("acknowledged", "refused")
        live.close()
        return answer.WhichOneof("message") + " " + answer.refused.message[:100]


class ExportsStarveNoLiveStream(Attack):
    """Viewers export the session in which the witness edits, in a loop."""
    finding = "H7"
    users = False
    scan_rows = 200
    witness_session = "shared"
    answer_s_max = 3

    def attack(self, server):
        self.outcomes, self.end = [], time.monotonic() + self.size(6, 30)
        loops = [threading.Thread(target=self.export, args=(server,)) for _ in range(6)]
        for loop in loops:
            loop.start()
        for loop in loops:
            loop.join()
        return "%d exports: %s" % (len(self.outcomes), ", ".join(sorted(set(self.outcomes))))

    def export(self, server):
        client = Client(server, "viewer")
        while time.monotonic() < self.end and server.is_alive():
            left = max(1, self.end - time.monotonic())
            self.outcomes.append(end_of(client.read("Export", left, session="shared", format=1,
                                                    exact=True)))


class PreviewsWithLongIdsAreNotKept(Attack):
    finding = "H8"

    def attack(self, server):
        Client(server, "alice").ask("OpenSession", scan="scan", name="work")
        live = Live(Client(server, "vera"), "work", timeout=20)
        live.next("welcome")
        before = server.log_bytes()
        previews = self.size(20, 70)
        for number in range(previews):
            live.say(preview=dict(edit_id="x" * (15 << 20), gradient_scale=dict(beta=1)))
            while live._waiting.qsize() > 1 and live.answers.is_active():
                time.sleep(0.01)
        time.sleep(1)
        live.close()
        if server.log_bytes() - before > 1 << 20:
            self.hole("%d MiB of log" % ((server.log_bytes() - before) >> 20))
        return "%d previews of 15 MiB sent, no answer read" % previews


class IdleWatcherGetsNoFrames(Attack):
    finding = "M9"
    answer_s_max = 4
    witness_session = "others"

    def attack(self, server):
        Client(server, "alice").ask("OpenSession", scan="scan", name="idle")
        vera = Client(server, "vera")
        messages = vera.read("Watch", greeting=dict(session="idle", pages=True), timeout=self.size(4, 30))
        settled = frames = size = 0
        try:
            for message in messages:
                if not message.HasField("frame"):
                    continue
                if settled:
                    frames += 1
                    size += len(message.frame.data)
                settled = settled or message.frame.state == 2
        except grpc.RpcError:
            pass
        if frames > 10:  # some may be on their way, and an exact one may follow
            self.hole("%d frames, %d bytes, of a surface that does not move" % (frames, size))
        return "%d frames after the settled one" % frames


class StreamsAtRestAreNotCut(Attack):
    """Not an attack. A defence must not end a stream that sends something every 10 s, or a
    watcher of a surface at rest."""

    def attack(self, server):
        Client(server, "alice").ask("OpenSession", scan="scan", name="rest")
        live = Live(Client(server, "alice"), "rest", timeout=200)
        live.next("welcome")
        messages = Client(server, "vera").read("Watch", greeting=dict(session="rest", pages=True), timeout=200)
        next(messages)
        end = time.monotonic() + self.size(2, 75)
        while time.monotonic() < end:
            live.say(heartbeat=dict(client_time_us=1))
            live.next("heartbeat")
            time.sleep(min(10, max(0, end - time.monotonic())))
        live.slide("late", 0.25)
        live.next("acknowledged")
        changed = any(message.HasField("history") and message.history.gradient_scale == 0.25
                      for message in messages)
        if not changed:
            self.hole("the watcher was cut off")
        return "both heard of an edit after %d s" % self.size(2, 75)

    def check(self, server):
        state = self.owner.ask("GetState", session="rest")
        if state.gradient_scale != 0.25:
            self.hole("the edit after the rest did not arrive")


class RolesOfASessionHaveALimit(Attack):
    """Each message about people names each person with a role, and goes to everybody there."""
    is_known = True
    users = False
    witness_session = "shared"
    growth_mib_max = 100

    def attack(self, server):
        client, codes = Client(server, "mallory"), []
        for begin in range(0, self.size(1100, 30_000), 100):
            calls = [client.start("SetRole", session="shared", role=2,
                                  user="%05d" % number + "x" * 190)
                     for number in range(begin, begin + 100)]
            codes += [outcome_of(call) for call in calls]
        roles = len(client.ask("GetPeople", session="shared").roles)
        if roles > 1000:
            self.hole("%d people have roles in one session" % roles)
        return "%d roles; %s" % (roles, ", ".join(sorted(set(codes))))


class MovesOfABrushFloodNobody(Attack):
    is_known = True
    users = False
    answer_s_max = 3
    witness_session = "shared"

    def attack(self, server):
        streams = [Live(Client(server, "m%d" % number), "shared", timeout=30) for number in range(8)]
        for stream in streams:
            stream.next("welcome")
        end, moves = time.monotonic() + self.size(4, 20), 0
        while time.monotonic() < end:
            for stream in streams:
                if stream._waiting.qsize() < 100:
                    for _ in range(50):
                        stream.say(move_brush=dict(ring=dict(centre=dict(x=moves % 7), radius=0.1)))
                        moves += 1
            time.sleep(0.001)
        for stream in streams:
            stream.close()
        return "%d moves on 8 streams, no answer read" % moves


class EditorTakesNotEverySession(Attack):
    """Editors open and fork until refused. Another editor and an owner must still find room."""
    finding = "N5"
    config = "[limits]\nsessions_max = 16\nkept_sessions_per_user = 6\nsessions_for_owners = 3\n"
    witness_session = ""

    def attack(self, server):
        made = [self.take(server, name) for name in ("mallory", "walt")]
        if max(made) > 6:
            self.hole("one editor has %d sessions, limit 6" % max(made))
        if Client(server, "bert").code("OpenSession", scan="scan", name="bert") != "OK":
            self.hole("another editor can open nothing")
        self.take(server, "alice")
        if self.owner.code("OpenSession", scan="scan", name="owner") != "OK":
            self.hole("an owner can open nothing")
        return "%d and %d sessions" % tuple(made)

    @staticmethod
    def take(server, user):
        client = Client(server, user)
        codes = [client.code("OpenSession", scan="scan", name=user + "s")]
        codes += [client.code("ForkSession", session=user + "s", name="%s-%d" % (user, number))
                  for number in range(40)]
        return codes.count("OK")


class HistoryHasAnEnd(Attack):
    """One editor sends strokes until refused. Undo and deletion must still work."""
    finding = "N7"
    config = "[limits]\nhistory_bytes_per_session = 2000000\nhistory_bytes_per_user = 5000000\n"
    witness_session = ""

    def attack(self, server):
        mallory = Client(server, "mallory")
        path, accepted, before = [dict(x=0, y=0, z=1)] * 3000, 0, server.data_bytes()
        stroke = dict(brush=dict(radius=0.01, strength=0.5, beta=0.5, fall_off=1), path=path)
        for session in ("one", "two", "three", "four"):
            mallory.ask("OpenSession", scan="scan", name=session)
            for number in range(self.size(60, 600)):
                accepted += mallory.code("Apply", session=session,
                                         edits=[dict(id="s%d" % number, stroke=stroke)]) == "OK"
        if accepted * len(path) * 12 > 6_000_000:
            self.hole("%d strokes of 3000 points were accepted" % accepted)
        if mallory.code("Apply", session="one", edits=[dict(id="u", undo={})]) != "OK":
            self.hole("a full history cannot be undone")
        if mallory.code("DeleteSession", session="one") != "OK":
            self.hole("a session with a full history cannot be deleted")
        grown = (server.data_bytes() - before) >> 20
        return "%d strokes accepted, %d MiB of disk" % (accepted, grown)


class ForksHoldUpNobody(Attack):
    """Copies of a session with many edits, one after the other."""
    users = False

    def attack(self, server):
        client = Client(server, "mallory")
        client.ask("OpenSession", scan="scan", name="long")
        path = [dict(x=0, y=0, z=1)] * 3000
        for number in range(self.size(10, 60)):
            stroke = dict(brush=dict(radius=0.01, strength=0.5, beta=0.5, fall_off=1), path=path)
            client.ask("Apply", session="long", edits=[
                dict(id="s%d-%d" % (number, part), stroke=stroke) for part in range(8)])
        end, codes = time.monotonic() + self.size(4, 20), []
        while time.monotonic() < end:
            calls = [client.start("ForkSession", session="long", name="fork-%d-%d" % (len(codes), n))
                     for n in range(8)]
            codes += [outcome_of(call) for call in calls]
        return "%d forks: %s" % (len(codes), ", ".join(sorted(set(codes))))
