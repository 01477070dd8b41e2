"""A plain web server for a publication, at /finds/tablet/. Usage: web_server.py FOLDER ranges|whole

Prints the address. `whole` knows no ranges, as http.server.
"""

import functools
import http.server
import re
import sys


class Handler(http.server.SimpleHTTPRequestHandler):
    ranges = True
    protocol_version = "HTTP/1.1"

    def translate_path(self, path):
        return super().translate_path(path.removeprefix("/finds/tablet"))

    def do_GET(self):
        wanted = re.fullmatch(r"bytes=(\d+)-(\d+)", self.headers.get("Range", ""))
        if wanted and self.ranges:
            return self._send_part(int(wanted[1]), int(wanted[2]) + 1)
        return super().do_GET()

    def _send_part(self, begin, end):
        with open(self.translate_path(self.path), "rb") as file:
            size = file.seek(0, 2)
            file.seek(begin)
            part = file.read(end - begin)
        self.send_response(206)
        self.send_header("Content-Type", "application/octet-stream")
        self.send_header("Content-Range", f"bytes {begin}-{begin + len(part) - 1}/{size}")
        self.send_header("Content-Length", str(len(part)))
        self.end_headers()
        self.wfile.write(part)

    def log_message(self, *_):
        pass


def main(folder, kind):
    Handler.ranges = kind == "ranges"
    handler = functools.partial(Handler, directory=folder)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as server:
        print(f"http://127.0.0.1:{server.server_port}/finds/tablet/", flush=True)
        server.serve_forever()


main(*sys.argv[1:])
