import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Worker as Driven } from "playwright-core";
import type { Pictures } from "../../../client/web/page/src/protocol";
import { Bench, type Visit } from "./harness";

const bench = new Bench();
before(() => bench.start());
after(() => bench.stop());

declare global {
  interface Window {
    engine: Worker;
    heard: Record<string, unknown>[];
  }
}

/** Starts the real engine with engine_probe.cpp beside the page's own. */
const withEngine = (test: (engine: Engine) => Promise<void>, pictures: Pictures = "card") =>
  bench.visit(async (visit) => {
    const engine = new Engine(visit);
    await engine.start(pictures);
    await test(engine);
  });

class Engine {
  constructor(readonly visit: Visit) {}

  async start(pictures: Pictures, core = "/assets/core.wasm"): Promise<void> {
    const given = { pictures, core, rasterCore: "/assets/core_raster.wasm" };
    await this.visit.page.evaluate(({ pictures, core, rasterCore }) => {
      const canvas = document.createElement("canvas").transferControlToOffscreen();
      const message = { kind: "start", canvas, width: 64, height: 48, pixelRatio: 1, address: location.origin };
      window.heard = [];
      window.engine = new Worker("/assets/real_engine.js", { type: "module" });
      window.engine.onmessage = ({ data }) => window.heard.push(data);
      const cores = { core: location.origin + core, rasterCore: location.origin + rasterCore };
      const rest = { user: "", token: "s3cret", pictures, kept: { key: "text of before" } };
      window.engine.postMessage({ ...message, ...cores, ...rest }, [canvas]);
    }, given);
  }

  send = (message: object) => this.visit.page.evaluate((sent) => window.engine.postMessage(sent), message);
  line = (line: string) => this.send({ kind: "command", line });

  /** Waits until the engine has said this. */
  async said(message: string): Promise<void> {
    const has = (wanted: string) => window.heard.some((one) => one.message === wanted);
    await this.visit.page.waitForFunction(has, message).catch(async () => {
      assert.fail(`not '${message}' but ${JSON.stringify(await this.heard())}`);
    });
  }

  worker = () => this.visit.page.workers().find((one) => one.url().endsWith("/real_engine.js"))!;
  heard = () => this.visit.page.evaluate(() => window.heard);
}

test("CoreStartsWithWhatWasKept", () => withEngine((engine) => engine.said("started with 'text of before'")));

const saysWho = (who: string) => async (engine: Engine) => {
  await engine.line("who");
  await engine.said(`drawn by the ${who}`);
};
test("CardDrawsWhereItIsWanted", () => withEngine(saysWho("card"), "card"));
test("ProcessorDrawsWhereItIsWanted", () => withEngine(saysWho("processor"), "processor"));
// The tests' browser has OpenGL, but no card behind it.
test("OpenGlWithoutACardIsTold", () =>
  withEngine(async (engine) => {
    await engine.visit.page.waitForFunction(() => window.heard.length > 0);
    assert.deepEqual(await engine.heard(), [{ kind: "noCard" }]);
  }, "best"));

test("TasksThatWaitKeepTheirStacks", () =>
  withEngine(async (engine) => {
    await engine.line("resume"); // of tasks that are not there
    await engine.line("tasks");
    // Two at once count as one, so they go on until all tasks have ended.
    const ended = async () => (await engine.heard()).filter((one) => /^task/.test(String(one.message))).length;
    while ((await ended()) < 3) await engine.line("resume");
    for (let task = 0; task < 3; ++task) await engine.said(`task ${task} kept 21`);
  }));

test("CanvasGetsItsSizeWithThePicture", () =>
  withEngine(async (engine) => {
    await engine.send({ kind: "resize", width: 80, height: 60, pixelRatio: 1 });
    await engine.line("draw");
    await engine.said("resized to 80");
    await engine.said("ticked");
  }));

declare const self: { widths: number[] };

/** Lets the engine note the widths that its canvas is given. */
const noteWidths = (worker: Driven) =>
  worker.evaluate(() => {
    const { get, set } = Object.getOwnPropertyDescriptor(OffscreenCanvas.prototype, "width")!;
    self.widths = [];
    const note = function (this: OffscreenCanvas, width: number) {
      self.widths.push(width);
      set!.call(this, width);
    };
    Object.defineProperty(OffscreenCanvas.prototype, "width", { get, set: note });
  });

test("SizeThatIsTheSameDoesNotEmptyTheCanvas", () =>
  withEngine(async (engine) => {
    await engine.said("started with 'text of before'");
    const worker = engine.worker();
    await noteWidths(worker);
    for (const width of [64, 80, 80]) {
      await engine.send({ kind: "resize", width, height: 48, pixelRatio: 1 });
      await engine.line("draw");
      await engine.said(`resized to ${width}`);
    }
    await engine.line("who");
    await engine.said("drawn by the card");
    assert.deepEqual(await worker.evaluate(() => self.widths), [80]);
  }));

test("PageThatIsNotSeenTicksByTimer", () =>
  withEngine(async (engine) => {
    await engine.send({ kind: "visible", is: false });
    await engine.line("draw");
    await engine.said("ticked");
  }));

test("FileIsReadFromWhereTheCoreWants", () =>
  withEngine(async (engine) => {
    await engine.visit.page.evaluate(() =>
      window.engine.postMessage({ kind: "import", file: new File(["0123456"], "a.ply") }),
    );
    await engine.said("from 2: 23456");
  }));

/** Has the core decode a picture of 8 by 4 pixels, with this size and with another one. */
const importPicture = (engine: Engine) =>
  engine.visit.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(8, 4);
    const context = canvas.getContext("2d", { alpha: false })!;
    context.fillStyle = "rgb(200 100 50)";
    context.fillRect(0, 0, 8, 4);
    const file = new File([await canvas.convertToBlob({ type: "image/webp", quality: 1 })], "8x4.webp");
    window.engine.postMessage({ kind: "import", file });
  });

test("PictureIsDecodedIfItHasTheSizeThatTheCoreKnows", () =>
  withEngine(async (engine) => {
    await importPicture(engine);
    await engine.said("image 1: 200 100 50 255");
    await engine.said("image 2: none");
  }));

/** Runs in the worker: a canvas gives noise for pixels from then on. */
function giveNoise(): void {
  const { getImageData } = OffscreenCanvasRenderingContext2D.prototype;
  OffscreenCanvasRenderingContext2D.prototype.getImageData = function (...place) {
    const image = getImageData.apply(this, place);
    image.data.forEach((_, i) => (image.data[i] = (97 * i) % 256));
    return image;
  };
}

test("NoPictureIsDecodedWhereTheBrowserGivesNoiseForPixels", () =>
  withEngine(async (engine) => {
    await engine.said("started with 'text of before'");
    await engine.worker().evaluate(giveNoise);
    await importPicture(engine);
    await engine.said("image 1: none");
  }));

/** Has the core keep a picture of two pixels, and returns how it begins and what a browser shows of it. */
async function keptPicture(engine: Engine): Promise<[string, number[]]> {
  await engine.line("picture");
  await engine.visit.page.waitForFunction(() => window.heard.some((one) => one.kind === "keep" && one.key === "shown"));
  const text = String((await engine.heard()).find((one) => one.key === "shown")!.text);
  const shown = await engine.visit.page.evaluate(async (address) => {
    const image = new Image();
    image.src = address;
    await image.decode();
    const context = new OffscreenCanvas(2, 1).getContext("2d")!;
    context.drawImage(image, 0, 0);
    return [...context.getImageData(0, 0, 2, 1).data];
  }, text);
  return [text.slice(0, text.indexOf(";")), shown];
}

test("PictureOfASessionIsKeptSmall", () =>
  withEngine(async (engine) => {
    assert.equal((await keptPicture(engine))[0], "data:image/jpeg");
  }));

test("PictureOfASessionIsTrueWhereTheBrowserGivesNoiseForPixels", () =>
  withEngine(async (engine) => {
    await engine.said("started with 'text of before'");
    await engine.worker().evaluate(giveNoise);
    const [begin, shown] = await keptPicture(engine);
    assert.equal(begin, "data:image/png");
    assert.deepEqual(shown, [0x10, 0x20, 0x30, 255, 0xf0, 0x80, 0x08, 255]);
  }));

test("DownloadComesWholeOrNotAtAll", () =>
  withEngine(async (engine) => {
    await engine.line("drop");
    await engine.line("download");
    await engine.visit.page.waitForFunction(() => window.heard.some((one) => one.kind === "download"));
    const texts = await engine.visit.page.evaluate(() =>
      Promise.all(
        window.heard.flatMap((one) => (one.blob instanceof Blob ? [one.blob.text().then((text) => [one.name, text])] : [])),
      ),
    );
    assert.deepEqual(texts, [["a.txt", "one two"]]);
  }));

test("StoredTextIsGivenToThePage", () =>
  withEngine(async (engine) => {
    await engine.line("store");
    await engine.line("store");
    await engine.line("draw");
    await engine.said("ticked");
    const kept = (await engine.heard()).filter((one) => one.kind === "keep");
    assert.deepEqual(kept, [{ kind: "keep", key: "key", text: "kept text" }]);
  }));

test("TrapIsToldOnceAndNothingAfterIt", () =>
  withEngine(async (engine) => {
    await engine.line("trap");
    await engine.visit.page.waitForFunction(() => window.heard.some((one) => one.kind === "stopped"));
    await engine.line("draw");
    const last = (await engine.heard()).at(-1)!;
    assert.equal(last.kind, "stopped");
    assert.match(String(last.message), /unreachable/);
  }));

test("CoreThatDoesNotLoadIsTold", () =>
  bench.visit(async (visit) => {
    const engine = new Engine(visit);
    await engine.start("card", "/assets/page.js");
    await visit.page.waitForFunction(() => window.heard.some((one) => one.kind === "stopped"));
    assert.match(String((await engine.heard())[0]!.message), /^the engine did not load: /);
  }));
