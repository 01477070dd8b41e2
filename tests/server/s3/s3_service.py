"""An S3 service for tests: OpenStack Swift with its S3 middleware, in one process, with objects in memory.

Usage: s3_service.py FOLDER PORT ID SECRET [CERTIFICATE KEY]. ID is ACCOUNT:USER. Prints "port N" when it serves on
127.0.0.1; port 0 takes a free one. FOLDER keeps the lists of buckets and keys, so that a service that is started again
has its buckets, and has lost its objects. Ends with the process that has started it.
"""

import logging
import os
import pathlib
import sys

import eventlet
import eventlet.wsgi
from swift.common import utils

utils.eventlet_monkey_patch()

from swift.account.server import AccountController  # noqa: E402
from swift.common.middleware import listing_formats, slo, tempauth  # noqa: E402
from swift.common.middleware.s3api import s3api  # noqa: E402
from swift.common.ring import RingBuilder  # noqa: E402
from swift.container.server import ContainerController  # noqa: E402
from swift.obj.mem_server import ObjectController  # noqa: E402
from swift.proxy.server import Application  # noqa: E402

LOG = logging.getLogger("s3")


class Cache:
    """What the middleware asks of memcached."""

    def __init__(self):
        self.values = {}

    def get(self, key, **_):
        return self.values.get(key)

    def set(self, key, value, **_):
        self.values[key] = value

    def delete(self, key, **_):
        self.values.pop(key, None)


def with_cache(application):
    cache = Cache()

    def call(environment, start):
        environment["swift.cache"] = cache
        return application(environment, start)
    return call


def serve_part(folder, kind, controller):
    """Serves a part of Swift at a port of its own, and tells the proxy by a ring of one disk."""
    listener = eventlet.listen(("127.0.0.1", 0))
    builder = RingBuilder(0, 1, 0)
    builder.add_dev({"id": 0, "region": 0, "zone": 0, "weight": 1, "ip": "127.0.0.1", "device": "disk",
                     "port": listener.getsockname()[1]})
    builder.rebalance()
    builder.get_ring().save(str(folder / f"{kind}.ring.gz"))
    eventlet.spawn(eventlet.wsgi.server, listener, controller, LOG, log_output=False)


def front(settings, user_id, secret):
    account, user = user_id.split(":")
    pipeline = Application({**settings, "account_autocreate": "true"})
    pipeline = slo.filter_factory({})(pipeline)
    pipeline = tempauth.filter_factory({f"user_{account}_{user}": f"{secret} .admin"})(pipeline)
    pipeline = s3api.filter_factory({"auth_pipeline_check": "false", "min_segment_size": "1",
                                     "max_upload_part_num": "10000", "storage_domain": "localhost"})(pipeline)
    return with_cache(listing_formats.filter_factory({})(pipeline))


def end_with(parent):
    while os.getppid() == parent:
        eventlet.sleep(0.5)
    os._exit(0)


def main(folder, port, user_id, secret, certificate=None, key=None):
    folder = pathlib.Path(folder)
    (folder / "disk").mkdir(exist_ok=True)
    utils.HASH_PATH_SUFFIX = b"burnish"
    settings = {"devices": str(folder), "mount_check": "false", "swift_dir": str(folder)}
    for kind, controller in (("account", AccountController), ("container", ContainerController),
                             ("object", ObjectController)):
        serve_part(folder, kind, controller(settings))
    eventlet.spawn(end_with, os.getppid())
    listener = eventlet.listen(("127.0.0.1", int(port)))
    number = listener.getsockname()[1]
    if certificate:
        listener = eventlet.wrap_ssl(listener, certfile=certificate, keyfile=key, server_side=True)
    print("port", number, flush=True)
    eventlet.wsgi.server(listener, front(settings, user_id, secret), LOG, log_output=False)


main(*sys.argv[1:])
