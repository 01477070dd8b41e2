"""A server behind HAProxy with deploy/haproxy.cfg: TLS ends at the proxy, a Unix socket behind it."""

import os
import re
import socket
import subprocess

from server import START_S_MAX, Server, guard_child

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
HAPROXY = "/usr/sbin/haproxy"


def replace_once(pattern, by, text):
    changed, count = re.subn(pattern, by, text, flags=re.MULTILINE)
    if count != 1:
        raise RuntimeError("deploy/haproxy.cfg has %d lines like %s, not one" % (count, pattern))
    return changed


class ProxiedServer(Server):
    """`address` is the proxy's, `pid` the server's."""

    proxy = None

    def listen_keys(self):
        return 'listen = ""\nsocket = "%s"\n' % self.socket

    socket = property(lambda self: os.path.join(self.folder, "server.sock"))

    def start(self):
        super().start()
        if self.proxy is None:
            self.start_proxy()
        self.address = "localhost:%d" % self.port

    def start_proxy(self):
        """The configuration as it is installed, except for its user and the places of files and sockets."""
        tls = os.path.join(self.folder, "tls")
        subprocess.run([os.path.join(ROOT, "deploy/make-certificates"), tls, "localhost"], check=True,
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        read = lambda name: open(os.path.join(tls, name)).read()
        self.ca = read("ca.pem")
        with open(os.path.join(tls, "proxy.pem"), "w") as file:
            file.write(read("server.pem") + read("server.key"))
        listening = socket.create_server(("127.0.0.1", 0))
        self.port = listening.getsockname()[1]
        with open(os.path.join(ROOT, "deploy/haproxy.cfg")) as file:
            config = file.read()
        config = replace_once(r"^  bind :7411 ssl crt \S+", "  bind fd@%d ssl crt %s/proxy.pem"
                              % (listening.fileno(), tls), config)
        config = replace_once(r"^  bind :7443 ssl crt \S+", "  bind unix@%s/pages.sock ssl crt %s/proxy.pem"
                              % (self.folder, tls), config)
        config = replace_once(r"^  server burnish \S+", "  server burnish unix@" + self.socket, config)
        config = replace_once(r"^  user haproxy\n  group burnish\n", "", config)
        path = os.path.join(self.folder, "haproxy.cfg")
        with open(path, "w") as file:
            file.write(config)
        with open(os.path.join(self.folder, "haproxy.log"), "ab") as log:
            self.proxy = subprocess.Popen([HAPROXY, "-db", "-f", path], stdout=log, stderr=log,
                                          pass_fds=[listening.fileno()], preexec_fn=lambda: guard_child(8192))
        listening.close()

    def stop(self):
        if self.proxy is not None:
            self.proxy.kill()
            self.proxy.wait(START_S_MAX)
        super().stop()
