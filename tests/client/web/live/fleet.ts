// Two servers of a fleet with the web part of deploy/haproxy-fleet-web.cfg before them, and PostgreSQL behind them.

import assert from "node:assert/strict";
import { execFileSync, spawn, type ChildProcess } from "node:child_process";
import { chownSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { createServer, type AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { end, startServer, until, type Server } from "./lab";

const kPrograms = "/usr/lib/postgresql";
const kHaproxy = "/usr/sbin/haproxy";

/** Says why a fleet cannot be tried here; false if it can. */
export const lacksFleet = (): string | false =>
  !existsSync(kHaproxy) ? "haproxy is not installed" : !existsSync(kPrograms) ? "PostgreSQL is not installed" : false;

/** PostgreSQL refuses to run as root. */
function runAsDatabaseUser(program: string, words: string[]): void {
  const version = readdirSync(kPrograms).sort().pop()!;
  const path = join(kPrograms, version, "bin", program);
  const isRoot = process.getuid!() === 0;
  const [run, all] = isRoot ? ["runuser", ["-u", "postgres", "--", path, ...words]] : [path, words];
  execFileSync(run as string, all as string[], { cwd: "/", stdio: "ignore" });
}

function freePort(): Promise<number> {
  const server = createServer();
  return new Promise((resolve) =>
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    }),
  );
}

export type Node = "one" | "two";

export class Fleet {
  readonly folder = mkdtempSync(join(tmpdir(), "burnish-fleet-"));
  readonly servers = new Map<Node, Server>();
  private readonly database = mkdtempSync(join(tmpdir(), "burnish-database-"));
  private proxy: ChildProcess | null = null;
  private port = 0;

  async start(): Promise<void> {
    if (process.getuid!() === 0) {
      const id = Number(execFileSync("id", ["-u", "postgres"], { encoding: "utf8" }));
      chownSync(this.database, id, id);
    }
    const data = join(this.database, "data");
    runAsDatabaseUser("initdb", ["-D", data, "-A", "trust", "-U", "burnish", "-E", "UTF8", "--locale=C"]);
    const options = `-k ${this.database} -c listen_addresses= -c fsync=off`;
    runAsDatabaseUser("pg_ctl", ["-w", "-D", data, "-l", join(this.database, "log"), "-o", options, "start"]);
    mkdirSync(join(this.folder, "shared"));
    for (const node of ["one", "two"] as const) await this.startServer(node);
    await this.startProxy();
  }

  async stop(): Promise<void> {
    if (this.proxy) await end(this.proxy, "SIGKILL");
    for (const { process } of this.servers.values()) await end(process, "SIGKILL");
    runAsDatabaseUser("pg_ctl", ["-D", join(this.database, "data"), "-m", "immediate", "stop"]);
    rmSync(this.database, { recursive: true });
    rmSync(this.folder, { recursive: true });
  }

  address = () => `http://127.0.0.1:${this.port}`;
  rpc = (node: Node) => this.servers.get(node)!.rpc;
  /** Stops a server in order: its sessions are free for the others. */
  drain = (node: Node) => end(this.servers.get(node)!.process, "SIGTERM");

  private async startServer(node: Node): Promise<void> {
    const config = join(this.folder, `${node}.toml`);
    writeFileSync(
      config,
      `listen = "127.0.0.1:0"
data = "${join(this.folder, node)}"
journal = "postgresql://burnish@/postgres?host=${this.database}"
[web]
listen = "127.0.0.1:0"
[limits]
connections_per_peer = 256
[library]
shared = "${join(this.folder, "shared")}"
[fleet]
name = "${node}"
lease_ms = 3000
heartbeat_ms = 1000
`,
    );
    this.servers.set(node, await startServer(["--config", config]));
  }

  private async startProxy(): Promise<void> {
    this.port = await freePort();
    const deploy = process.env.BURNISH_DEPLOY!;
    const shared = readFileSync(join(deploy, "haproxy-fleet.cfg"), "utf8");
    let pages = readFileSync(join(deploy, "haproxy-fleet-web.cfg"), "utf8");
    const replace = (pattern: RegExp, by: string) => {
      assert.match(pages, pattern);
      pages = pages.replace(pattern, by);
    };
    replace(/^  bind :7443 .*$/m, `  bind 127.0.0.1:${this.port}`);
    for (const [node, { web }] of this.servers)
      replace(new RegExp(`^  server ${node} .*$`, "m"), `  server ${node} ${new URL(web).host}`);
    replace(/^  server three .*\n/m, "");
    const file = join(this.folder, "haproxy.cfg");
    writeFileSync(file, shared.slice(0, shared.indexOf("frontend clients")) + pages);
    this.proxy = spawn(kHaproxy, ["-db", "-f", file], { stdio: ["ignore", "ignore", "inherit"] });
    await until(
      () => fetch(this.address()).then(({ ok }) => ok, () => false),
      (ok) => ok,
    );
  }
}
