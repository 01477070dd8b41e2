"""Another user, in its own process. It asks for the scans and edits in a session while an attack
runs. It records how long the answers take and how much memory the server holds. It ends a server
above the limit, so that no attack takes the whole machine.

Reads a JSON object from its first argument and prints "ready". At the end of its input it writes
its record as JSON."""

import itertools
import json
import os
import signal
import sys
import threading
import time
from types import SimpleNamespace

import grpc

from client import Client, Live
from server import rss_bytes

ASK_S_MAX = 15  # a missing answer counts as this long
PAUSE_S = 0.02


class Stopwatch:
    """Times of answers, including the one that is still missing."""

    def __init__(self):
        self.seconds, self.failures, self._begin = [], [], None

    def measure(self, what):
        self._begin = time.monotonic()
        try:
            what()
        except (grpc.RpcError, StopIteration) as error:
            name = error.code().name if isinstance(error, grpc.RpcError) else "stream ended"
            self.failures.append(name)
            if name == "DEADLINE_EXCEEDED":
                self.seconds.append(time.monotonic() - self._begin)
        else:
            self.seconds.append(time.monotonic() - self._begin)
        self._begin = None

    def report(self):
        begin = self._begin
        times = self.seconds + ([time.monotonic() - begin] if begin else [])
        return dict(answers=len(self.seconds), median_s=sorted(times)[len(times) // 2] if times else 0,
                    worst_s=max(times, default=0), failures=len(self.failures),
                    failure=self.failures[0] if self.failures else "")


class Witness:
    def __init__(self, wish):
        self.wish = wish
        self.server = SimpleNamespace(**wish["server"])
        self.lists, self.acks = Stopwatch(), Stopwatch()
        self.rss_peak, self.killed, self.stopping = 0, False, False
        self.client = Client(self.server, "walt")

    def watch_memory(self):
        while not self.stopping:
            rss = rss_bytes(self.server.pid)
            self.rss_peak = max(self.rss_peak, rss)
            if rss > self.wish["rss_bytes_max"]:
                os.kill(self.server.pid, signal.SIGKILL)
                self.killed = True
                return
            time.sleep(0.01)

    def ask_for_scans(self):
        client = Client(self.server, "walt") if self.wish["fresh_connections"] else self.client
        client.ask("ListScans", ASK_S_MAX)
        if client is not self.client:
            client.channel.close()

    def keep_asking(self):
        while not self.stopping:
            self.lists.measure(self.ask_for_scans)
            time.sleep(PAUSE_S)

    def keep_editing(self):
        stream = None
        for number in itertools.count():
            if self.stopping:
                return
            if stream is None:
                stream = Live(self.client, self.wish["session"], timeout=600)
            edit_id = "walt-%d" % number
            failures = len(self.acks.failures)
            self.acks.measure(lambda: self.edit(stream, edit_id))
            if len(self.acks.failures) > failures:
                stream = None
            time.sleep(PAUSE_S)

    @staticmethod
    def edit(stream, edit_id):
        stream.say(heartbeat=dict(client_time_us=1))
        stream.slide(edit_id, 0.5)
        stream.next("acknowledged", "refused")

    def run(self):
        work = [self.watch_memory, self.keep_asking]
        if self.wish["session"]:
            work.append(self.keep_editing)
        before = self.rss_peak = rss_bytes(self.server.pid)
        for what in work:
            threading.Thread(target=what, daemon=True).start()
        self.wait_for_first_answers()
        print("ready", flush=True)
        sys.stdin.read()
        time.sleep(0.1)
        report = dict(rss_before=before, rss_peak=self.rss_peak, rss_after=rss_bytes(self.server.pid),
                      killed=self.killed, lists=self.lists.report(), acks=self.acks.report())
        self.stopping = True
        print(json.dumps(report), flush=True)
        os._exit(0)  # threads may hang in calls

    def wait_for_first_answers(self):
        end = time.monotonic() + ASK_S_MAX
        while time.monotonic() < end:
            if self.lists.seconds and (self.acks.seconds or not self.wish["session"]):
                return
            time.sleep(0.01)


if __name__ == "__main__":
    Witness(json.loads(sys.argv[1])).run()
