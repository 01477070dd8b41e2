// The figures of tests/bench/publication_bench.

import { existsSync, readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { Lab, type Visit } from "../client/web/live/lab";
import { hasNginx, serveByNginx } from "../client/web/live/nginx";
import { SlowLink, type LinkOptions } from "../client/web/live/slow_link";
import { serve, stopServing } from "../client/web/live/web_server";
import type { Pictures } from "../../client/web/page/src/protocol";
import type { BrowserKind } from "../client/web/browser";

const kVisits = Number(process.env.BURNISH_VISITS ?? 5);
const kQuietMs = 2000;
const kQuietTriesMax = 15;
const kLink: LinkOptions = { megabitsPerSecond: 50, roundTripMs: 40 };
const kWindow = { width: 1280, height: 720 };

/** How a browser draws: OpenGL on the processor, or the core's own pictures where there is no graphics card. */
const kWays: { name: string; pictures: Pictures; browser: BrowserKind }[] = [
  { name: "WebGL by SwiftShader", pictures: "card", browser: "openGl" },
  { name: "processor", pictures: "best", browser: "plain" },
];

/** What the page tells while it is measured: times of performance.now(). */
interface Seen {
  /** When the canvas first showed something before its background. */
  first: number;
  last: number;
  clicked: number;
}

declare global {
  interface Window {
    pictures: Seen;
  }
}

/** Runs in the page, before its scripts. */
function watchPicture(): void {
  const seen: Seen = (window.pictures = { first: 0, last: 0, clicked: 0 });
  addEventListener("click", () => (seen.clicked ||= performance.now()), { capture: true });
  let context: CanvasRenderingContext2D | null = null;
  /** The background is the same along a row. */
  const showsSurface = (picture: HTMLCanvasElement): boolean => {
    context ??= Object.assign(document.createElement("canvas"), { width: 32, height: 2 }).getContext("2d", {
      willReadFrequently: true,
    })!;
    context.drawImage(picture, 0, picture.height / 2, picture.width, 2, 0, 0, 32, 2);
    const { data } = context.getImageData(0, 0, 32, 1);
    return [0, 1, 2].some((channel) => Math.abs(data[channel]! - data[4 * 16 + channel]!) > 12);
  };
  const look = () => {
    const picture = document.querySelector<HTMLCanvasElement>("canvas.picture");
    if (picture && picture.width > 0 && showsSurface(picture)) seen.first = performance.now();
    else requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
  const Engine = Worker;
  window.Worker = class extends Engine {
    constructor(url: string | URL, options?: WorkerOptions) {
      super(url, options);
      this.addEventListener("message", ({ data }) => {
        if (data.kind === "drawn") seen.last = performance.now();
      });
    }
  };
}

const seenBy = (visit: Visit) => visit.page.evaluate(() => window.pictures);

/** Waits until no picture has come for some time. */
async function atRest(visit: Visit): Promise<Seen> {
  for (let seen = await seenBy(visit), tries = 0; ; ++tries) {
    await visit.page.waitForTimeout(kQuietMs);
    const later = await seenBy(visit);
    if ((later.first > 0 && later.last === seen.last) || tries === kQuietTriesMax) return later;
    seen = later;
  }
}

interface View {
  /** From the beginning: of the visit; for the page, of the click on the session. */
  firstMs: number;
  wholeMs: number;
  /** Of the surface alone, all answers together. */
  surfaceKb: number;
  requests: number;
  /** Of the viewer: page, engine, core and what they read. */
  viewerKb: number;
}

const kilobytes = (asked: { bytes: number }[]) => asked.reduce((sum, { bytes }) => sum + bytes, 0) / 1e3;

function report(link: SlowLink, begun: number): void {
  if (!process.env.BURNISH_ASKED) return;
  for (const { path, at, bytes } of link.asked) console.log(`${(at - begun).toFixed(0).padStart(6)} ms ${path} ${bytes}`);
}

async function visitPublication(lab: Lab, address: string): Promise<View> {
  const link = await SlowLink.open(address, kLink);
  let view: View | null = null;
  await lab.visitAt("about:blank", async (visit) => {
    await visit.page.addInitScript(watchPicture);
    const begun = performance.now();
    await visit.page.goto(lab.address(link.address));
    const { first, last } = await atRest(visit);
    report(link, begun);
    console.log(`  first ${first.toFixed(0)}`);
    const isOfSurface = ({ path }: { path: string }) => /\.(parts|index)(\?|$)/.test(path);
    const parts = link.asked.filter(isOfSurface);
    const viewer = link.asked.filter((one) => !isOfSurface(one));
    const surfaceKb = kilobytes(parts);
    view = { firstMs: first, wholeMs: last, surfaceKb, requests: parts.length, viewerKb: kilobytes(viewer) };
  }, { viewport: kWindow });
  link.close();
  return view!;
}

async function visitPage(lab: Lab): Promise<View> {
  const link = await SlowLink.open(lab.address(), kLink);
  let view: View | null = null;
  await lab.visitAt("about:blank", async (visit) => {
    await visit.page.addInitScript(watchPicture);
    await visit.page.goto(lab.address(link.address));
    await visit.page.getByRole("button", { name: "Join bench" }).waitFor();
    const before = kilobytes(link.asked);
    await visit.page.getByRole("button", { name: "Join bench" }).click();
    const { first, last, clicked } = await atRest(visit);
    const surfaceKb = kilobytes(link.asked) - before;
    view = { firstMs: first - clicked, wholeMs: last - clicked, surfaceKb, requests: NaN, viewerKb: before };
  }, { viewport: kWindow });
  link.close();
  return view!;
}

function median(views: View[]): View {
  const middle = (of: (view: View) => number) => {
    const values = views.map(of).sort((one, other) => one - other);
    return Math.round(values[values.length >> 1]!);
  };
  return {
    firstMs: middle((view) => view.firstMs),
    wholeMs: middle((view) => view.wholeMs),
    surfaceKb: middle((view) => view.surfaceKb),
    requests: middle((view) => view.requests),
    viewerKb: middle((view) => view.viewerKb),
  };
}

async function repeat(visit: () => Promise<View>): Promise<View> {
  const views: View[] = [];
  for (let i = 0; i < kVisits; ++i) views.push(await visit());
  return median(views);
}

async function publish(lab: Lab, scan: string, depth: string): Promise<string> {
  const [kind, vertices] = scan.split(":");
  const file = existsSync(scan) ? resolve(scan) : lab.path("scan.ply");
  if (!existsSync(scan)) await lab.run("generate", kind!, file, "--vertices", vertices!);
  const wanted = depth === "0" ? [] : ["--depth", depth];
  await lab.ask("import", file, "--name", "scan", ...wanted);
  await lab.ask("open", "scan", "--session", "bench", ...wanted);
  await lab.ask("edit", "bench", "--beta", "0.2");
  await lab.ask("publish", "bench", "site");
  return lab.path("site");
}

const folderKb = (folder: string): number =>
  readdirSync(folder).reduce((sum, name) => {
    const path = join(folder, name);
    return sum + (statSync(path).isDirectory() ? folderKb(path) : statSync(path).size / 1e3);
  }, 0);

async function main([scan, depth, out]: string[]): Promise<void> {
  const rows: object[] = [];
  for (const { name, pictures, browser } of kWays) {
    const lab = new Lab(pictures, browser);
    await lab.start();
    try {
      const folder = await publish(lab, scan!, depth!);
      const { triangles } = JSON.parse(readFileSync(join(folder, "scan.json"), "utf8")) as { triangles: number };
      const nginx = hasNginx ? await serveByNginx(folder) : null;
      const address = nginx?.address ?? (await serve(folder, "ranges"));
      const published = await repeat(() => visitPublication(lab, address));
      const page = await repeat(() => visitPage(lab));
      await nginx?.stop();
      const of = scan!.replace(/.*\//, "").replace(/\.\w+$/, "");
      rows.push({ scan: of, triangles, drawn: name, folderKb: Math.round(folderKb(folder)), published, page });
      console.log(JSON.stringify(rows.at(-1), null, 1));
    } finally {
      await stopServing();
      await lab.stop();
    }
  }
  if (out) writeFileSync(out, JSON.stringify(rows, null, 1) + "\n");
}

void main(process.argv.slice(2));
