// A plain web server for tests: web_server.py.

import { spawn, type ChildProcess } from "node:child_process";
import { join } from "node:path";
import { end } from "./lab";

const servers: ChildProcess[] = [];

/** Serves a folder, and returns its address. `kind`: whether the server sends parts of files, and knows their types. */
export function serve(folder: string, kind: "ranges" | "whole" | "plain"): Promise<string> {
  const program = join(process.env.BURNISH_LIVE_TESTS!, "web_server.py");
  const server = spawn("python3", [program, folder, kind], { stdio: ["ignore", "pipe", "inherit"] });
  servers.push(server);
  return new Promise((resolve, reject) => {
    server.stdout!.once("data", (line: Buffer) => resolve(String(line).trim()));
    server.once("exit", (code) => reject(new Error(`the web server ended with ${code}`)));
  });
}

export const stopServing = () => Promise.all(servers.map((server) => end(server, "SIGKILL")));
