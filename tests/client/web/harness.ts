// Serves the built page as the gateway does, and drives it in Chromium.

import { readFileSync, readdirSync, statSync } from "node:fs";
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import { join, relative } from "node:path";
import assert from "node:assert/strict";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import type { Snapshot } from "../../../client/web/page/src/snapshot";
import { launchBrowser } from "./browser";
import type { Order } from "./fake_engine";

// As the gateway sends it (server/web).
const kPolicy =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; style-src 'self'; " +
  "img-src 'self' blob: data:; connect-src 'self'; worker-src 'self'; font-src 'self'; " +
  "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
const kPatienceMs = 60_000; // of a loaded machine
const kTypes: Record<string, string> = {
  html: "text/html",
  js: "text/javascript",
  css: "text/css",
  ico: "image/x-icon",
  wasm: "application/wasm",
};
const filesOf = (folder: string): string[] =>
  readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    return statSync(path).isDirectory() ? filesOf(path) : [path];
  });

function serve(folder: string): Promise<Server> {
  const files = new Map(filesOf(folder).map((path) => ["/" + relative(folder, path), readFileSync(path)]));
  const server = createServer((request, response) => {
    const path = (request.url ?? "").split("?")[0]!;
    const target = path === "/" ? "/index.html" : path;
    const body = files.get(target);
    const type = kTypes[target.split(".").pop() ?? ""] ?? "application/octet-stream";
    const headers = { "Content-Type": type, "Content-Security-Policy": kPolicy, "X-Content-Type-Options": "nosniff" };
    response.writeHead(body ? 200 : 404, headers).end(body);
  });
  return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

/** A message as the fake engine tells of it. */
export type Seen = { kind: string; line?: string } & Record<string, unknown>;

declare global {
  interface Window {
    seen: Seen[];
    orders: BroadcastChannel;
  }
}

/** A page with the fake engine behind it. */
export class Visit {
  readonly console: string[] = [];

  constructor(readonly page: Page) {
    page.setDefaultTimeout(kPatienceMs);
    page.on("console", (message) => this.console.push(message.text()));
    page.on("pageerror", (error) => this.console.push(String(error)));
  }

  async order(order: Order): Promise<void> {
    await this.page.evaluate((sent) => window.orders.postMessage(sent), order);
  }

  change = (change: Partial<Snapshot>) => this.order({ change });
  document = (document: object) => this.order({ document });

  seen = (): Promise<Seen[]> => this.page.evaluate(() => window.seen);

  async lines(): Promise<string[]> {
    return (await this.seen()).flatMap((one) => (one.kind === "command" ? [one.line!] : []));
  }

  /** Waits until the engine has seen this line. */
  async sent(line: string): Promise<void> {
    const has = (wanted: string) => window.seen.some((one) => one.line === wanted);
    await this.page.waitForFunction(has, line, { timeout: kPatienceMs }).catch(async () => {
      assert.fail(`no line '${line}' among ${JSON.stringify((await this.lines()).slice(-12))}`);
    });
  }

  /** Waits until the engine has seen a line that begins so. */
  async sentSome(begin: string): Promise<void> {
    const has = (wanted: string) => window.seen.some((one) => one.line?.startsWith(wanted));
    await this.page.waitForFunction(has, begin, { timeout: kPatienceMs });
  }

  /** Waits until the engine has seen a message of this kind, and returns it. */
  async message(kind: string, part: Record<string, unknown> = {}): Promise<Seen> {
    const find = ({ kind, part }: { kind: string; part: Record<string, unknown> }) =>
      window.seen.find(
        (one) => one.kind === kind && Object.keys(part).every((key) => one[key] === part[key]),
      );
    const found = await this.page.waitForFunction(find, { kind, part }, { timeout: kPatienceMs });
    return (await found.jsonValue()) as Seen;
  }

  async forget(): Promise<void> {
    await this.page.evaluate(() => void (window.seen.length = 0));
  }

  async openSession(): Promise<void> {
    await this.page.getByRole("button", { name: "Join inscription" }).click();
    await this.page.getByRole("region", { name: "Camera", exact: true }).waitFor(); // the last one
  }

  /** Unfolds a section, and returns it. */
  async section(name: string) {
    const section = this.page.getByRole("region", { name, exact: true });
    const fold = section.getByRole("button", { name, exact: true });
    if ((await fold.getAttribute("aria-expanded")) === "false") await fold.click();
    return section;
  }

  async screenshot(name: string): Promise<void> {
    const folder = process.env.BURNISH_SCREENSHOTS;
    if (folder) await this.page.screenshot({ path: join(folder, name + ".png") });
  }
}

/** A server and a browser for the tests of a file. */
export class Bench {
  private server!: Server;
  private browser!: Browser;

  async start(): Promise<void> {
    const folder = process.env.BURNISH_PAGE;
    assert.ok(folder, "BURNISH_PAGE names the folder of the built page");
    this.server = await serve(folder);
    this.browser = await launchBrowser();
  }

  async stop(): Promise<void> {
    await this.browser.close();
    this.server.close();
  }

  /** Visits the page, and demands an empty console at the end. */
  async visit(test: (visit: Visit) => Promise<void>, options: BrowserContextOptions = {}): Promise<void> {
    const context = await this.browser.newContext({ viewport: { width: 1280, height: 800 }, ...options });
    const visit = new Visit(await context.newPage());
    await visit.page.addInitScript(() => {
      window.seen = [];
      window.orders = new BroadcastChannel("engine-orders");
      new BroadcastChannel("engine-seen").onmessage = ({ data }) => window.seen.push(data);
    });
    await visit.page.goto(`http://127.0.0.1:${(this.server.address() as AddressInfo).port}/`);
    await visit.page.getByText("connected to lab:7443").waitFor();
    await test(visit);
    assert.deepEqual(visit.console, []);
    await context.close();
  }

  visitSession(test: (visit: Visit) => Promise<void>, options: BrowserContextOptions = {}): Promise<void> {
    return this.visit(async (visit) => {
      await visit.openSession();
      await test(visit);
    }, options);
  }
}
