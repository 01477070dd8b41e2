"""A plain web server for a publication, at /finds/tablet/. Usage: web_server.py FOLDER ranges|whole|plain

Prints the address. `whole` knows no ranges, as http.server; `plain` knows no types of files.
"""

import functools
import http.server
import os
import re
import sys


class Handler(http.server.SimpleHTTPRequestHandler):
    kind = "ranges"
    protocol_version = "HTTP/1.1"

    def translate_path(self, path):
        return super().translate_path(path.removeprefix("/finds/tablet"))

    def guess_type(self, path):
        is_page = self.kind != "plain" or str(path).endswith((".html", "/"))
        return super().guess_type(path) if is_page else "text/plain"

    def do_GET(self):
        wanted = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", ""))
        if wanted and self.kind != "whole" and os.path.exists(self.translate_path(self.path)):
            return self._send_part(int(wanted[1]), int(wanted[2]) + 1)
        return super().do_GET()

    def _send_part(self, begin, end):
        with open(self.translate_path(self.path), "rb") as file:
            size = file.seek(0, 2)
            if begin >= size:
                return self._refuse_part(size)
            file.seek(begin)
            part = file.read(end - begin)
        self.send_response(206)
        self.send_header("Content-Type", "application/octet-stream")
        self.send_header("Content-Range", f"bytes {begin}-{begin + len(part) - 1}/{size}")
        self.send_header("Content-Length", str(len(part)))
        self.end_headers()
        self.wfile.write(part)

    def _refuse_part(self, size):
        self.send_response(416)
        self.send_header("Content-Range", f"bytes */{size}")
        self.send_header("Content-Length", "0")
        self.end_headers()

    def log_message(self, *_):
        pass


class Server(http.server.ThreadingHTTPServer):
    def handle_error(self, request, client_address):
        """Says nothing of browsers that leave in the middle of an answer."""
        if not isinstance(sys.exc_info()[1], ConnectionError):
            super().handle_error(request, client_address)


def main(folder, kind):
    Handler.kind = kind
    handler = functools.partial(Handler, directory=folder)
    with Server(("127.0.0.1", 0), handler) as server:
        print(f"http://127.0.0.1:{server.server_port}/finds/tablet/", flush=True)
        server.serve_forever()


main(*sys.argv[1:])
