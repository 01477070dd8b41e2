// A burnish-server with its gateway for browsers, the command line, and browsers that visit it.

import assert from "node:assert/strict";
import { execFile, spawn, type ChildProcess } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import type { Pictures } from "../../../../client/web/page/src/protocol";
import { launchBrowser, type BrowserKind } from "../browser";

const kBin = process.env.BURNISH_BIN;
const kPatienceMs = 60_000;

/** A running server. */
export interface Server {
  process: ChildProcess;
  /** Addresses of gRPC and of the page. */
  rpc: string;
  web: string;
}

export function startServer(flags: string[]): Promise<Server> {
  assert.ok(kBin, "BURNISH_BIN names the folder of the programs");
  const process = spawn(join(kBin, "burnish-server"), flags, { stdio: ["ignore", "pipe", "pipe"] });
  let said = "";
  return new Promise((resolve, reject) => {
    const hear = (bytes: Buffer) => {
      said += bytes;
      const web = /^web on (\S+)$/m.exec(said)?.[1];
      const rpc = /^listening on (\S+)$/m.exec(said)?.[1];
      if (web && rpc) resolve({ process, rpc, web });
    };
    process.stdout!.on("data", hear);
    process.stderr!.on("data", hear);
    process.on("exit", (code) => reject(new Error(`burnish-server ended with ${code}: ${said}`)));
  });
}

/** Ends a program, and waits for its end. */
export async function end(process: ChildProcess, signal: NodeJS.Signals): Promise<void> {
  if (process.exitCode !== null || process.signalCode !== null) return;
  process.removeAllListeners("exit");
  const ended = new Promise((resolve) => process.once("exit", resolve));
  process.kill(signal);
  await ended;
}

/** Waits until a question has this answer. */
export async function until<Answer>(ask: () => Promise<Answer>, wanted: (answer: Answer) => boolean): Promise<Answer> {
  const end = Date.now() + kPatienceMs;
  for (;;) {
    const answer = await ask();
    if (wanted(answer)) return answer;
    if (Date.now() > end) assert.fail(`waited for another answer than ${JSON.stringify(answer)}`);
    await new Promise((resolve) => setTimeout(resolve, 50)); // the server is another process
  }
}

export interface SessionState {
  edits: number;
  beta: number;
  curve: string;
}

export interface HistoryEntry {
  kind: string;
  enabled: boolean;
  summary: string;
}

/** RGBA, rows from above. */
export interface Pixels {
  width: number;
  height: number;
  data: Uint8Array;
}

/** Returns the mean of the differences of all bytes, and the difference that 99 of 100 do not exceed. */
export function difference(one: Pixels, other: Pixels): { mean: number; most: number } {
  assert.deepEqual([one.width, one.height], [other.width, other.height]);
  const counts = new Array<number>(256).fill(0);
  one.data.forEach((value, i) => ++counts[Math.abs(value - other.data[i]!)]!);
  let sum = 0;
  counts.forEach((count, size) => (sum += count * size));
  let left = one.data.length / 100;
  let most = 255;
  while (most > 0 && (left -= counts[most]!) > 0) --most;
  return { mean: sum / one.data.length, most };
}

/** A visit of the page. */
export class Visit {
  readonly console: string[] = [];
  /** Addresses of all requests. */
  readonly asked: string[] = [];
  private replayed = 0;

  constructor(readonly page: Page) {
    page.setDefaultTimeout(kPatienceMs);
    page.on("console", (message) => this.console.push(message.text()));
    page.on("pageerror", (error) => this.console.push(String(error)));
    page.on("request", (request) => this.asked.push(request.url()));
  }

  /** Returns all text of the page, its messages too. */
  text = (): Promise<string> => this.page.locator("body").innerText().catch(String);

  /** Opens a scan by its name in the list, and waits for the picture of its settled surface. */
  async openScan(name: string): Promise<void> {
    await this.page.getByRole("button", { name: `New session of ${name}` }).click();
    await this.settled();
  }

  async join(session: string): Promise<void> {
    await this.page.getByRole("button", { name: `Join ${session}`, exact: true }).click();
    await this.settled();
  }

  settled(): Promise<void> {
    return this.page.getByText(/^(settled|exact)\b/).first().waitFor();
  }

  /** Switches the scale bar off: pictures of a script have one only if it says so. */
  async hideScaleBar(): Promise<void> {
    await this.page.getByRole("checkbox", { name: "Scale bar", exact: true }).click();
    await this.page.getByRole("img", { name: /^Scale bar:/ }).waitFor({ state: "detached" });
  }

  /** Returns the picture as the browser shows it, with what lies over it. */
  async pixels(): Promise<Pixels> {
    return this.decode(await this.page.getByRole("img", { name: /^Picture of/ }).screenshot({ type: "png" }));
  }

  /** Returns the picture that the core has drawn, as the user saves it. */
  async picture(): Promise<Pixels> {
    const download = this.page.waitForEvent("download");
    await this.page.keyboard.press("F9");
    return this.decode(readFileSync(await (await download).path()));
  }

  async decode(png: Buffer): Promise<Pixels> {
    const read = await this.page.evaluate(async (base64) => {
      const bytes = Uint8Array.from(atob(base64), (one) => one.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes]));
      const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      const context = canvas.getContext("2d")!;
      context.drawImage(bitmap, 0, 0);
      const { data } = context.getImageData(0, 0, bitmap.width, bitmap.height);
      let text = "";
      for (const one of data) text += String.fromCharCode(one);
      return { width: bitmap.width, height: bitmap.height, data: btoa(text) };
    }, png.toString("base64"));
    return { ...read, data: new Uint8Array(Buffer.from(read.data, "base64")) };
  }

  /** Returns the name of the open session. */
  async session(): Promise<string> {
    return (await this.page.title()).replace(/ – Burnish$/, "");
  }

  /** Unfolds a section, and returns it. */
  async section(name: string) {
    const section = this.page.getByRole("region", { name, exact: true });
    const fold = section.getByRole("button", { name, exact: true });
    if ((await fold.getAttribute("aria-expanded")) === "false") await fold.click();
    return section;
  }

  /** Begins to run lines of the script language, as a file that the user replays. Returns the file's name. */
  async begin(lines: string[]): Promise<string> {
    const chooser = this.page.waitForEvent("filechooser");
    await this.choose("File", "Replay a script…");
    const buffer = Buffer.from([...lines, ""].join("\n"));
    const name = `lines-${++this.replayed}.burnish`;
    await (await chooser).setFiles({ name, mimeType: "text/plain", buffer });
    return name;
  }

  /** Runs lines of the script language to their end. */
  async replay(lines: string[]): Promise<void> {
    const name = await this.begin(lines);
    await this.page.getByText(`replayed ${name}`).waitFor();
  }

  /** Moves the pointer over the picture, to a place from 0 to 1. */
  async hover([x, y]: [number, number], steps = 4): Promise<void> {
    const box = (await this.page.getByRole("img", { name: /^Picture of/ }).boundingBox())!;
    await this.page.mouse.move(box.x + x * box.width, box.y + y * box.height, { steps });
  }

  /** Drags over the picture, between places from 0 to 1. */
  async drag(from: [number, number], to: [number, number]): Promise<void> {
    const box = (await this.page.getByRole("img", { name: /^Picture of/ }).boundingBox())!;
    const at = ([x, y]: [number, number]) => [box.x + x * box.width, box.y + y * box.height] as const;
    await this.page.mouse.move(...at(from));
    await this.page.mouse.down();
    await this.page.mouse.move(...at(to), { steps: 12 });
    await this.page.mouse.up();
  }

  /** Presses a menu's item. */
  async choose(menu: string, item: string): Promise<void> {
    await this.page.getByRole("button", { name: menu, exact: true }).click();
    await this.page.getByRole("menuitem", { name: item }).click();
  }

  async screenshot(name: string): Promise<void> {
    const folder = process.env.BURNISH_SCREENSHOTS;
    if (folder) await this.page.screenshot({ path: join(folder, name + ".png") });
  }
}

/** What the tests of a file share. OpenGL draws, unless they ask for another way. */
export class Lab {
  readonly folder = mkdtempSync(join(tmpdir(), "burnish-web-"));
  private server: Server | null = null;
  private browser: Browser | null = null;
  private page = "";
  private flags: string[] = [];

  constructor(
    private readonly pictures: Pictures = "card",
    private readonly kind: BrowserKind = "openGl",
  ) {}

  /** Starts with a scan, "tablet", and these flags of the server. */
  async start(flags: string[] = []): Promise<void> {
    this.flags = ["--data", join(this.folder, "data"), ...flags];
    this.server = await startServer(["--listen", "127.0.0.1:0", "--web", "127.0.0.1:0", ...this.flags]);
    await this.begin(this.server.web);
  }

  /** Starts without a server of its own: the page is at this address. */
  async begin(address: string): Promise<void> {
    this.page = address;
    this.browser = await launchBrowser(this.kind);
  }

  async stop(): Promise<void> {
    await this.browser?.close();
    if (this.server) await this.kill();
    rmSync(this.folder, { recursive: true });
  }

  /** Ends the server as a power cut would. */
  kill = () => end(this.server!.process, "SIGKILL");

  /** Starts a killed server again, at its old addresses. */
  async revive(): Promise<void> {
    const { rpc, web } = this.server!;
    this.server = await startServer(["--listen", rpc, "--web", new URL(web).host, ...this.flags]);
  }

  path = (name: string) => join(this.folder, name);
  bytes = (name: string) => readFileSync(this.path(name));
  address = (page = `${this.page}/`) => `${page}?pictures=${this.pictures}`;

  /** Runs the command line without a server. */
  run(...words: string[]): Promise<string> {
    return new Promise((resolve, reject) =>
      execFile(join(kBin!, "burnish"), words, { cwd: this.folder }, (error, out, problem) =>
        error ? reject(new Error(`burnish ${words.join(" ")}: ${problem}`)) : resolve(out),
      ),
    );
  }

  /** Runs a command against the server. */
  ask = (...words: string[]) => this.run(...words, "--server", this.server!.rpc);

  async state(session: string): Promise<SessionState> {
    return JSON.parse(await this.ask("sessions", session, "--json")) as SessionState;
  }

  async history(session: string): Promise<HistoryEntry[]> {
    return JSON.parse(await this.ask("history", session, "--json")) as HistoryEntry[];
  }

  /** Generates a scan and imports it. */
  async importTablet(): Promise<void> {
    await this.run("generate", "tablet", "tablet.ply", "--vertices", "10000");
    await this.ask("import", "tablet.ply", "--name", "tablet");
  }

  /** Visits the page, and demands an empty console at the end. `wanted`: lines that the test expects there. */
  visit(test: (visit: Visit) => Promise<void>, options: BrowserContextOptions = {}, wanted: RegExp = /^$/): Promise<void> {
    return this.visitAt(`${this.page}/`, test, options, wanted);
  }

  /** Visits another page likewise. */
  async visitAt(
    address: string,
    test: (visit: Visit) => Promise<void>,
    options: BrowserContextOptions = {},
    wanted: RegExp = /^$/,
  ): Promise<void> {
    const context = await this.browser!.newContext({ viewport: { width: 1024, height: 700 }, ...options });
    const visit = new Visit(await context.newPage());
    try {
      await visit.page.goto(this.address(address));
      await test(visit);
      assert.deepEqual(visit.console.filter((line) => !wanted.test(line)), []);
    } catch (error) {
      await visit.screenshot("failed");
      const seen = `\nconsole: ${visit.console.join("\n")}\npage: ${await visit.text()}`;
      if (error instanceof Error) error.message += seen;
      throw error;
    } finally {
      await context.close();
    }
  }
}
