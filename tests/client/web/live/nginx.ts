// Debian's nginx as a web server for tests, with the settings that its package brings.

import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { createServer, type AddressInfo } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { end, until } from "./lab";

const kNginx = process.env.BURNISH_NGINX ?? "/usr/sbin/nginx";

export const hasNginx = existsSync(kNginx);

const freePort = (): Promise<number> =>
  new Promise((resolve) => {
    const server = createServer();
    server.listen(0, "127.0.0.1", () => {
      const { port } = server.address() as AddressInfo;
      server.close(() => resolve(port));
    });
  });

const settings = (home: string, folder: string, port: number) => `
daemon off; pid ${home}/pid; error_log ${home}/errors;
events {}
http {
  include /etc/nginx/mime.types; default_type application/octet-stream;
  sendfile on; tcp_nopush on; gzip on; access_log off;
  client_body_temp_path ${home}; proxy_temp_path ${home}; fastcgi_temp_path ${home};
  uwsgi_temp_path ${home}; scgi_temp_path ${home};
  server { listen 127.0.0.1:${port}; location /finds/tablet/ { alias ${folder}/; } }
}
`;

/** Serves a folder at /finds/tablet/. Returns its address, and what ends the server. */
export async function serveByNginx(folder: string): Promise<{ address: string; stop: () => Promise<void> }> {
  const home = mkdtempSync(join(tmpdir(), "burnish-nginx-"));
  const port = await freePort();
  writeFileSync(join(home, "nginx.conf"), "user root;" + settings(home, folder, port));
  const server = spawn(kNginx, ["-c", join(home, "nginx.conf"), "-e", join(home, "errors")], { stdio: "inherit" });
  const address = `http://127.0.0.1:${port}/finds/tablet/`;
  await until(() => fetch(address).then((answer) => answer.status, () => 0), (status) => status === 200);
  const stop = async () => {
    await end(server, "SIGTERM");
    rmSync(home, { recursive: true });
  };
  return { address, stop };
}
