"""The suite's own burnish-server, on a free loopback port. It ends with the suite."""

import ctypes
import hashlib
import os
import re
import resource
import signal
import subprocess
import tempfile
import time

START_S_MAX = 20
ADDRESS_SPACE_BYTES_MAX = 16 << 30  # the second guard; the first is the witness, which watches RSS
PR_SET_PDEATHSIG = 1

# The users of a server with authentication. A token is the word "token-" and the name.
ROLES = {"olga": "owner", "alice": "editor", "bert": "editor", "mallory": "editor",
         "walt": "editor", "vera": "viewer"}


def token_of(user):
    return "token-" + user


def users_file(names):
    entry = '[[user]]\nname = "%s"\nrole = "%s"\ntoken_sha256 = "%s"\n'
    return "\n".join(entry % (name, ROLES[name], hashlib.sha256(token_of(name).encode()).hexdigest())
                     for name in names)


def guard_child(descriptors_max=1024):
    """Ends the child with the suite, and keeps it from taking the machine with it."""
    ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
    resource.setrlimit(resource.RLIMIT_AS, (ADDRESS_SPACE_BYTES_MAX,) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_NOFILE, (descriptors_max, descriptors_max))


class Server:
    """`config` is TOML below the keys that every server of the suite has."""

    ca = None  # PEM of its certificate's CA, with TLS

    def __init__(self, binary, users, config="", flags=(), descriptors_max=1024):
        self.descriptors_max = descriptors_max
        self.binary, self.flags, self.users = binary, list(flags), users
        self._folder = tempfile.TemporaryDirectory(prefix="burnish-attack-")
        self.folder = self._folder.name
        self.log = os.path.join(self.folder, "server.log")
        keys = self.listen_keys() + 'backend = "cpu"\ndata = "%s"\n' % self.data
        if users:
            self.write_users(ROLES)
            keys += 'users = "%s"\n' % self._users
        with open(self._config, "w") as file:
            file.write(keys + config)
        self.start()

    def listen_keys(self):
        return 'listen = "127.0.0.1:0"\n'

    data = property(lambda self: os.path.join(self.folder, "data"))
    _users = property(lambda self: os.path.join(self.folder, "users.toml"))
    _config = property(lambda self: os.path.join(self.folder, "server.toml"))
    pid = property(lambda self: self.process.pid)

    def write_users(self, names):
        with open(self._users + ".new", "w") as file:
            file.write(users_file(names))
        os.replace(self._users + ".new", self._users)

    def start(self):
        with open(self.log, "ab") as log:
            begin = log.tell()
            self.process = subprocess.Popen([self.binary, "--config", self._config, *self.flags],
                                            stdout=log, stderr=log, stdin=subprocess.DEVNULL,
                                            preexec_fn=lambda: guard_child(self.descriptors_max))
        self.address = self.announced(rb"listening on (\S+)", begin)

    def announced(self, pattern, begin):
        end = time.monotonic() + START_S_MAX
        while time.monotonic() < end:
            with open(self.log, "rb") as log:
                log.seek(begin)
                found = re.search(pattern, log.read())
            if found:
                return found.group(1).decode()
            if not self.is_alive():
                break
            time.sleep(0.01)
        raise RuntimeError("the server did not start: " + self.log_text()[-2000:])

    def is_alive(self):
        return self.process.poll() is None

    def halt(self, politely=False):
        """Ends the process; its data stay."""
        if self.is_alive():
            self.process.send_signal(signal.SIGTERM if politely else signal.SIGKILL)
        self.process.wait(START_S_MAX)

    def restart(self):
        self.halt(politely=True)
        self.start()

    def stop(self):
        self.halt()
        self._folder.cleanup()

    def log_text(self):
        with open(self.log, "rb") as log:
            return log.read().decode("latin-1")

    def log_bytes(self):
        return os.path.getsize(self.log)

    def data_bytes(self):
        """Returns the bytes of the data folder on the disk. Does not count files that disappear."""
        total = 0
        for folder, _, files in os.walk(self.data):
            for name in files:
                try:
                    total += os.stat(os.path.join(folder, name)).st_blocks * 512
                except FileNotFoundError:
                    pass
        return total

    def end_in_words(self):
        code = self.process.poll()
        if code is None:
            return "alive"
        return signal.Signals(-code).name if code < 0 else "exit %d" % code


def rss_bytes(pid):
    """Returns the resident memory; 0 after the end of the process."""
    try:
        with open("/proc/%d/statm" % pid) as file:
            return int(file.read().split()[1]) * resource.getpagesize()
    except (FileNotFoundError, ProcessLookupError):
        return 0
