// The figures of tests/bench/page_bench.

import { existsSync, writeFileSync } from "node:fs";
import { resolve } from "node:path";
import { gzipSync } from "node:zlib";
import { Lab, type Visit } from "../client/web/live/lab";

const kVisits = 3;
const kQuietMs = 2000;
const kQuietTriesMax = 15;
const kWindow = { width: 1024, height: 700 };
const kSmallWindow = { width: 640, height: 480 }; // for ages: without a graphics card a picture takes longer than a frame
const kSeconds = 8; // of frames
const kMoveMs = 8; // between two moves of the mouse
const kReadsPerSecond = 10; // of the native client that looks on
const kPicturesPerSecond = 60; // of the one that drags

/** What the page tells while it is measured. Times are those of performance.now(). */
interface Watch {
  clicked: number;
  drawn: number[];
  longTasks: number[];
  /** By the figures over the picture, one for each snapshot with frames under way. */
  ages: number[];
}

declare global {
  interface Window {
    watch: Watch;
  }
}

/** Runs in the page, before its scripts. */
function watchPage(): void {
  const watch: Watch = (window.watch = { clicked: 0, drawn: [], longTasks: [], ages: [] });
  addEventListener("click", () => (watch.clicked ||= performance.now()), { capture: true });
  new PerformanceObserver((list) => watch.longTasks.push(...list.getEntries().map((one) => one.duration))).observe({
    type: "longtask",
    buffered: true,
  });
  const hear = ({ data }: MessageEvent) => {
    if (data.kind === "drawn") watch.drawn.push(performance.now());
    const figures = (data.snapshot?.document?.figures ?? []) as { name: string; value: string }[];
    const valueOf = (name: string) => parseFloat(figures.find((one) => one.name === name)?.value ?? "0");
    if (valueOf("frames") > 0) watch.ages.push(valueOf("frame age"));
  };
  const Engine = Worker;
  window.Worker = class extends Engine {
    constructor(url: string | URL, options?: WorkerOptions) {
      super(url, options);
      this.addEventListener("message", hear);
    }
  };
}

function percentile(values: number[], part: number): number {
  const sorted = [...values].sort((one, other) => one - other);
  return sorted[Math.floor(part * (sorted.length - 1))] ?? NaN;
}

interface Percentiles {
  p50: number;
  p95: number;
}

interface Opened {
  /** While the page came. */
  startingLongestTaskMs: number;
  firstPictureMs: number;
  /** Until the picture became no finer. */
  lastPictureMs: number;
  pictures: number;
  longestTaskMs: number;
}

const watchOf = (visit: Visit) => visit.page.evaluate(() => window.watch);
const longest = (watch: Watch) => Math.max(0, ...watch.longTasks);

/** Waits until no picture has come for some time. */
async function lastPicture(visit: Visit): Promise<Watch> {
  for (let watch = await watchOf(visit), tries = 0; ; ++tries) {
    await visit.page.waitForTimeout(kQuietMs);
    const later = await watchOf(visit);
    if (later.drawn.length === watch.drawn.length || tries === kQuietTriesMax) return later;
    watch = later;
  }
}

/** Opens the session in a browser that has never seen it. */
async function open(visit: Visit): Promise<Opened> {
  const button = visit.page.getByRole("button", { name: "Join bench" });
  await button.waitFor();
  const startingLongestTaskMs = longest(await watchOf(visit));
  await visit.page.evaluate(() => void (window.watch.drawn.length = window.watch.longTasks.length = 0));
  await button.click();
  await visit.page.waitForFunction(() => window.watch.drawn.length > 0);
  await visit.settled();
  const watch = await lastPicture(visit);
  return {
    startingLongestTaskMs,
    firstPictureMs: watch.drawn[0]! - watch.clicked,
    lastPictureMs: watch.drawn.at(-1)! - watch.clicked,
    pictures: watch.drawn.length,
    longestTaskMs: longest(watch),
  };
}

interface Ages {
  /** A frame is seen when its picture is drawn: up to two intervals of pictures later than its age says. */
  page: { p50: number; p95: number; count: number; pictureMs: Percentiles; roundTripMs: number; longestTaskMs: number };
  native: { p50: number; p95: number; count: number };
}

/** Moves the slider to and fro as a hand does, and lets it go. */
async function dragSlider(visit: Visit): Promise<void> {
  const slider = visit.page.getByRole("slider", { name: "Gradient scale β", exact: true });
  const box = (await slider.boundingBox())!;
  const at = (turn: number) => box.x + box.width * (0.5 + 0.3 * Math.sin(turn));
  const mouse = visit.page.mouse;
  await mouse.move(at(0), box.y + box.height / 2);
  await mouse.down();
  const begun = performance.now();
  for (let ms = 0; ms < 1000 * kSeconds; ms = performance.now() - begun) {
    await mouse.move(at(ms / 300), box.y + box.height / 2);
    await visit.page.waitForTimeout(kMoveMs);
  }
  await mouse.up();
}

/** Returns the ages of the frames of a native client. */
async function nativeAges(lab: Lab, mix: string, rate: number): Promise<Ages["native"]> {
  const words = ["bench", "serve", "--session", "bench", "--mix", mix, "--seconds", `${kSeconds}`];
  const report = await lab.ask(...words, "--rate", `${rate}`, "--pages", "32", "--json");
  const { p50, p95, count } = (JSON.parse(report) as { frame_age_ms: Ages["native"] }).frame_age_ms;
  return { p50, p95, count };
}

/** The page drags the slider beside a native client that looks on; then a native client drags, and the page looks on. */
async function compareAges(lab: Lab, visit: Visit): Promise<Ages> {
  await visit.page.evaluate(() => {
    const { ages, drawn, longTasks } = window.watch;
    ages.length = drawn.length = longTasks.length = 0;
  });
  await Promise.all([dragSlider(visit), nativeAges(lab, "draw=1", kReadsPerSecond)]);
  const watch = await watchOf(visit);
  const intervals = watch.drawn.slice(1).map((time, i) => time - watch.drawn[i]!);
  const roundTrip = await visit.page.locator(".figures div", { hasText: "round trip" }).first().innerText();
  return {
    page: {
      p50: percentile(watch.ages, 0.5),
      p95: percentile(watch.ages, 0.95),
      count: watch.ages.length,
      pictureMs: { p50: percentile(intervals, 0.5), p95: percentile(intervals, 0.95) },
      roundTripMs: parseFloat(/([\d.]+) ms/.exec(roundTrip)?.[1] ?? "NaN"),
      longestTaskMs: longest(watch),
    },
    native: await nativeAges(lab, "drag=1", kPicturesPerSecond),
  };
}

async function importScan(lab: Lab, scan: string, depth: string): Promise<void> {
  const [kind, vertices] = scan.split(":");
  const file = existsSync(scan) ? resolve(scan) : lab.path("scan.ply");
  if (!existsSync(scan)) await lab.run("generate", kind!, file, "--vertices", vertices!);
  const wanted = depth === "0" ? [] : ["--depth", depth];
  await lab.ask("import", file, "--name", "scan", ...wanted);
  await lab.ask("open", "scan", "--session", "bench", ...wanted);
}

/** Returns the bytes of the core, plain and packed as the gateway sends it. */
async function coreBytes(lab: Lab): Promise<{ plain: number; packed: number }> {
  const index = await (await fetch(lab.address())).text();
  const core = /data-core="([^"]+)"/.exec(index)![1]!;
  const bytes = new Uint8Array(await (await fetch(new URL(core, lab.address()))).arrayBuffer());
  return { plain: bytes.length, packed: gzipSync(bytes, { level: 9 }).length };
}

async function main([scan, depth, out]: string[]): Promise<void> {
  const lab = new Lab();
  await lab.start();
  try {
    await importScan(lab, scan!, depth!);
    const opened: Opened[] = [];
    let ages: Ages | null = null;
    const visit = (measure: (visit: Visit) => Promise<void>, viewport: { width: number; height: number }) =>
      lab.visit(
        async (visit) => {
          await visit.page.addInitScript(watchPage);
          await visit.page.reload();
          await measure(visit);
        },
        { viewport },
      );
    for (let i = 0; i < kVisits; ++i) await visit(async (visit) => void opened.push(await open(visit)), kWindow);
    await visit(async (visit) => {
      await open(visit);
      ages = await compareAges(lab, visit);
    }, kSmallWindow);
    const figures = { scan: scan!.replace(/.*\//, ""), core: await coreBytes(lab), opened, ages };
    const text = JSON.stringify(figures, null, 2);
    console.log(text);
    if (out) writeFileSync(out, text + "\n");
  } finally {
    await lab.stop();
  }
}

void main(process.argv.slice(2));
