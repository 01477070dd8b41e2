"""The kits for fleets name only what exists: keys, flags and metrics of the server, names of each other."""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import tomllib
import unittest

import yaml

DEPLOY = pathlib.Path(__file__).parents[2] / "deploy"
SERVER = os.environ["BURNISH_SERVER_BINARY"]


def text_of(name):
    return (DEPLOY / name).read_text(encoding="utf-8")


def yaml_of(name):
    return list(yaml.safe_load_all(text_of(name)))


def keys_of(table, prefix=""):
    """Returns all keys of a parsed configuration, with their dots."""
    found = set()
    for key, value in table.items():
        found |= keys_of(value, prefix + key + ".") if isinstance(value, dict) else {prefix + key}
    return found


def words_of(expression):
    return set(re.findall(r"\bburnish_[a-z_]+", expression))


class Kits(unittest.TestCase):
    def test_configurations_have_only_keys_that_the_server_knows(self):
        known = keys_of(tomllib.loads(text_of("server.example.toml")))
        for name in ("compose/fleet.toml", "fleet.example.toml", "kubernetes/server.toml"):
            used = keys_of(tomllib.loads(text_of(name)))
            self.assertEqual(used - known, set(), name)

    def test_configurations_in_comments_have_only_keys_that_the_server_knows(self):
        known = keys_of(tomllib.loads(text_of("server.example.toml")))
        for name in ("haproxy-fleet.cfg", "haproxy.cfg"):
            lines = re.findall(r"^#     (.*)$", text_of(name), re.M)
            self.assertEqual(keys_of(tomllib.loads("\n".join(lines))) - known, set(), name)

    def test_commands_have_only_flags_that_the_server_knows(self):
        help_text = subprocess.run([SERVER, "--help"], check=True, capture_output=True, text=True).stdout
        known = set(re.findall(r"--[a-z-]+", help_text))
        for name in ("burnish-server@.service", "burnish-server.service", "slurm/burnish.sbatch"):
            line = re.search(r"burnish-server --(?:.|\\\n)*", text_of(name))[0]
            self.assertEqual(set(re.findall(r"(?<= )--[a-z-]+", line)) - known, set(), name)
        compose = yaml_of("compose/fleet.yaml")[0]["services"]
        pods = {one["kind"]: one for one in yaml_of("kubernetes/servers.yaml")}
        container = pods["StatefulSet"]["spec"]["template"]["spec"]["containers"][0]
        for words in (compose["one"]["command"], compose["two"]["command"], container["args"]):
            self.assertEqual({word for word in words if word.startswith("--")} - known, set())

    def test_rules_and_the_page_read_only_metrics_that_exist(self):
        sources = "".join(path.read_text(encoding="utf-8")
                          for folder in ("metrics/prometheus", "main")
                          for path in (DEPLOY.parent / "server" / folder).glob("*.cpp"))
        known = set(re.findall(r'"(burnish_[a-z_]+)"', sources))
        known |= {name + "_bucket" for name in known}
        rules = [rule for group in yaml_of("monitoring/burnish.rules.yaml")[0]["groups"]
                 for rule in group["rules"]]
        page = json.loads(text_of("monitoring/grafana.json"))
        expressions = [rule["expr"] for rule in rules]
        expressions += [target["expr"] for panel in page["panels"] for target in panel["targets"]]
        self.assertGreater(len(expressions), 20)
        for expression in expressions:
            self.assertEqual(words_of(expression) - known, set(), expression)

    def test_the_proxies_know_the_servers_by_their_names(self):
        compose = yaml_of("compose/fleet.yaml")[0]["services"]
        proxy = text_of("haproxy-fleet.cfg")
        for name in ("one", "two"):
            self.assertIn(name, compose[name]["command"])
            self.assertIn(f"  server {name} {name}:7411", proxy)
        pods = text_of("kubernetes/haproxy.cfg")
        set_of_pods = next(one for one in yaml_of("kubernetes/servers.yaml")
                           if one["kind"] == "StatefulSet")
        for pod in range(set_of_pods["spec"]["replicas"]):
            self.assertIn(f"  server burnish-{pod} burnish-{pod}.burnish-servers:7411", pods)
        self.assertEqual(set_of_pods["spec"]["serviceName"], "burnish-servers")

    def test_both_proxies_lead_by_the_same_rules(self):
        def rules(name):
            backend = text_of(name).split("backend fleet\n")[1]
            return [line for line in backend.splitlines() if not line.startswith("  server ")]
        self.assertEqual(rules("haproxy-fleet.cfg"), rules("kubernetes/haproxy.cfg"))

    def test_the_kustomization_names_its_files(self):
        names = yaml_of("kubernetes/kustomization.yaml")[0]
        files = names["resources"] + [file for config in names["configMapGenerator"]
                                      for file in config["files"]]
        there = {path.name for path in (DEPLOY / "kubernetes").iterdir()} - {"kustomization.yaml"}
        self.assertEqual(set(files), there)

    def test_both_units_are_hardened_alike(self):
        def hardening(name):
            unit = text_of(name).split("# The server needs its data")[1]
            return [line for line in unit.splitlines() if "=" in line and not line.startswith("#")]
        self.assertEqual(hardening("burnish-server.service"), hardening("burnish-server@.service"))

    @unittest.skipUnless(shutil.which("systemd-analyze"), "there is no systemd-analyze here")
    def test_systemd_understands_the_units(self):
        for name in ("burnish-server.service", "burnish-server@.service"):
            with self.subTest(name), tempfile.TemporaryDirectory(prefix="burnish-") as folder:
                # The programs of the unit need not be installed, and its instance needs a name.
                unit = pathlib.Path(folder) / name.replace("@", "@0")
                unit.write_text(text_of(name).replace("/usr/bin/burnish-server", "/bin/true"),
                                encoding="utf-8")
                found = subprocess.run(["systemd-analyze", "verify", "--man=no", unit], check=False,
                                       capture_output=True, text=True)
                self.assertEqual((found.returncode, found.stderr), (0, ""))

    def test_time_to_drain_fits_into_the_kits(self):
        drain = tomllib.loads(text_of("server.example.toml"))["drain_seconds"]
        pods = next(one for one in yaml_of("kubernetes/servers.yaml") if one["kind"] == "StatefulSet")
        self.assertGreater(pods["spec"]["template"]["spec"]["terminationGracePeriodSeconds"], drain + 2)
        stop = re.search(r"^TimeoutStopSec=(\d+)", text_of("burnish-server@.service"), re.M)[1]
        self.assertGreater(int(stop), drain)
        warning = re.search(r"--signal=B:TERM@(\d+)", text_of("slurm/burnish.sbatch"))[1]
        self.assertGreater(int(warning), drain)


if __name__ == "__main__":
    unittest.main()
