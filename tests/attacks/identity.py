"""Users' identities and their rights."""

import signal
import threading
import time

import grpc

from attack import Attack
from client import Client, Live, outcome_of


class NameOfAnIdTakesNobodysSession(Attack):
    finding = "C1"

    def attack(self, server):
        alice, mallory = Client(server, "alice"), Client(server, "mallory")
        hers = alice.ask("OpenSession", scan="scan", name="hers").session.id
        forged = mallory.code("OpenSession", scan="scan", name=hers)
        alice.slide(hers, "by-id")
        if alice.ask("GetState", session="hers").session.edits != 1:
            self.hole("alice's edit by id went to mallory's session")
        return "OpenSession(name = her id): " + forged


class LoopsOverANameThatIsAnIdEndNothing(Attack):
    finding = "C1"
    users = False

    def attack(self, server):
        self.acknowledged = []
        opener = Client(server)
        hers = opener.ask("OpenSession", scan="scan", name="hers").session.id
        forged = opener.code("OpenSession", scan="scan", name=hers)
        self.end = time.monotonic() + (self.size(8, 20) if forged == "OK" else 1)
        loops = [threading.Thread(target=self.repeat, args=(server, method, fields))
                 for method, fields in (("OpenSession", dict(scan="scan", name="hers")),
                                        ("CloseSession", dict(session="hers")))]
        loops.append(threading.Thread(target=self.edit, args=(server,)))
        for loop in loops:
            loop.start()
        for loop in loops:
            loop.join()
        return "OpenSession(name = an id): %s; %d edits acknowledged" % (forged,
                                                                         len(self.acknowledged))

    def repeat(self, server, method, fields):
        client = Client(server)
        while time.monotonic() < self.end and server.is_alive():
            client.code(method, 5, **fields)

    def edit(self, server):
        client = Client(server)
        for number in range(100000):
            if time.monotonic() > self.end or not server.is_alive():
                return
            edit_id = "edit-%d" % number
            if outcome_of(client.start("Apply", 5, session="hers",
                                       edits=[dict(id=edit_id, gradient_scale={})])) == "OK":
                self.acknowledged.append(edit_id)

    def check(self, server):
        found, after = [], 0
        while True:
            page = self.owner.ask("GetHistory", session="hers", after=after)
            found += [entry.edit_id for entry in page.entries]
            if page.complete:
                break
            after = page.entries[-1].number
        if sorted(set(found)) != sorted(found) or set(self.acknowledged) - set(found):
            self.hole("of %d acknowledged edits %d are in the history"
                      % (len(self.acknowledged), len(found)))


class ViewerEditsByNoStream(Attack):
    finding = "C2"

    def attack(self, server):
        Client(server, "bert").ask("OpenSession", scan="scan", name="work")
        Client(server, "bert").slide("work", "berts")
        vera = Client(server, "vera")
        live = Live(vera, "work", timeout=10)
        role = live.next("welcome").welcome.role
        for number, change in enumerate((dict(gradient_scale=dict(beta=0)),
                                         dict(switch_entry=dict(entry=1, enabled=False)),
                                         dict(set_checkpoint=dict(name="vera was here")))):
            live.say(apply=dict(edits=[dict(id="v%d" % number, **change)]))
            if live.next("acknowledged", "refused").HasField("acknowledged"):
                self.hole("a viewer's %s was acknowledged" % next(iter(change)))
        live.close()
        if role != 1:
            self.hole("welcomed with role %d" % role)
        return "Apply: " + vera.code("Apply", session="work",
                                     edits=[dict(id="v9", gradient_scale={})])


class OwnerOfTheServerEndsAnySession(Attack):
    finding = "M3"

    def attack(self, server):
        Client(server, "mallory").ask("OpenSession", scan="scan", name="mallory's")
        olga = Client(server, "olga")
        outcomes = [(method, olga.code(method, session="mallory's", **more))
                    for method, more in (("SetRole", dict(user="bert", role=2)),
                                         ("CloseSession", {}), ("DeleteSession", {}))]
        for method, code in outcomes:
            if code != "OK":
                self.hole("the server's owner got %s from %s" % (code, method))
        return ", ".join("%s: %s" % outcome for outcome in outcomes)


class DismissedUserEditsNoLonger(Attack):
    finding = "M5"

    def attack(self, server):
        bert = Client(server, "bert")
        bert.ask("OpenSession", scan="scan", name="work")
        live = Live(bert, "work", timeout=30)
        live.slide("before")
        live.next("acknowledged")
        server.write_users([name for name in ("olga", "alice", "walt", "vera")])
        server.process.send_signal(signal.SIGHUP)
        end = time.monotonic() + 10
        while bert.code("ListScans") != "UNAUTHENTICATED" and time.monotonic() < end:
            time.sleep(0.05)
        acknowledged = 0
        try:
            for number in range(10):
                live.slide("after-%d" % number)
                acknowledged += live.next("acknowledged", "refused").HasField("acknowledged")
        except (StopIteration, grpc.RpcError):
            pass
        if acknowledged:
            self.hole("%d edits acknowledged after he was taken out" % acknowledged)
        return "%d edits after new calls were UNAUTHENTICATED" % acknowledged
