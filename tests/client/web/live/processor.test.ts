// A browser without a graphics card, and one that loses it.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { hasFirefox } from "../browser";
import { Lab, difference, until, type Pixels, type Visit } from "./lab";

const without = new Lab("best", "plain");
const losing = new Lab("card");
const inFirefox = new Lab("best", "firefox");
const labs = hasFirefox ? [without, losing, inFirefox] : [without, losing];
before(async () => {
  for (const lab of labs) {
    await lab.start();
    await lab.importTablet();
  }
});
after(async () => {
  for (const lab of labs) await lab.stop();
});

declare const self: { lastContext?: WebGL2RenderingContext };

/** Returns the name of the core that the page's engine has loaded, else of the one that the page has handed it. */
async function coreOf(visit: Visit): Promise<string> {
  const loaded = () => performance.getEntriesByType("resource").map((one) => one.name);
  const names = [...(await visit.page.workers()[0]!.evaluate(loaded)), ...(await visit.page.evaluate(loaded))];
  return /\/(core\w*)-[^/]*\.wasm$/.exec(names.find((name) => name.endsWith(".wasm")) ?? "")?.[1] ?? "";
}

/**
 * Returns means of parts of a picture's middle: figures and words lie over the rest, and browsers show a picture some
 * part of a pixel away from where the core has it.
 */
function parts({ width, height, data }: Pixels): Pixels {
  const kParts = 8;
  const [across, down] = [Math.floor(width / 3 / kParts), Math.floor(height / 3 / kParts)];
  const sums = new Float64Array(4 * kParts * kParts);
  for (let y = 0; y < kParts * down; ++y)
    for (let at = 0; at < 4 * kParts * across; ++at) {
      const part = Math.floor(y / down) * kParts + Math.floor(at / (4 * across));
      const from = 4 * ((Math.floor(height / 3) + y) * width + Math.floor(width / 3)) + at;
      sums[4 * part + (at % 4)]! += data[from]!;
    }
  return { width: kParts, height: kParts, data: Uint8Array.from(sums, (sum) => sum / (across * down)) };
}

/** Returns the saved picture, when the canvas shows the same. */
async function shown(visit: Visit): Promise<Pixels> {
  const drawn = await visit.picture();
  await until(
    async () => difference(parts(await visit.pixels()), parts(drawn)).mean,
    (mean) => mean < 1,
  );
  return drawn;
}

test("CanvasShowsWhatTheProcessorDraws", () =>
  without.visit(async (visit) => {
    await visit.openScan("tablet");
    assert.equal(await coreOf(visit), "core_raster");
    const before = await shown(visit);
    await visit.screenshot("processor");
    await visit.replay(["camera 60 10"]);
    const turned = await shown(visit);
    assert.ok(difference(parts(before), parts(turned)).mean > 2);
    await visit.replay(["beta 0", "wait"]);
    const smooth = await shown(visit);
    assert.ok(difference(turned, smooth).mean > 0.5);
  }));

test("MouseTurnsAndPaintsWithoutACard", () =>
  without.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    const before = await shown(visit);
    await visit.drag([0.4, 0.5], [0.6, 0.5]);
    await until(
      async () => (await without.state(session)).edits,
      (edits) => edits === 1,
    );
    await visit.settled();
    assert.ok(difference(before, await shown(visit)).mean > 0);
  }));

test("SavedPictureHasSmoothEdgesThoughTheCameraMoves", () =>
  without.visit(async (visit) => {
    await visit.openScan("tablet");
    await visit.replay(["camera 25 20"]);
    const still = await visit.picture();
    await visit.replay(["camera 26 20", "camera 25 20"]);
    assert.deepEqual(difference(still, await visit.picture()), { mean: 0, most: 0 });
  }));

const noFirefox = hasFirefox ? false : "there is no firefox-esr; deploy/setup --web installs it";

test("FirefoxKeepsItsPictureAtFullDetailAndDrawsTheNext", { skip: noFirefox }, () =>
  inFirefox.visit(
    async (visit) => {
      await visit.openScan("tablet");
      await visit.page.getByText("full detail").first().waitFor();
      const before = parts(await visit.pixels());
      const changed = async () => difference(before, parts(await visit.pixels())).mean;
      for (const height of [701, 700]) await visit.page.setViewportSize({ width: 1024, height });
      await until(changed, (mean) => mean < 1);
      await visit.replay(["camera 60 10"]);
      await until(changed, (mean) => mean > 2);
      const session = await visit.session();
      await visit.drag([0.4, 0.5], [0.6, 0.5]);
      await until(
        async () => (await inFirefox.state(session)).edits,
        (edits) => edits === 1,
      );
    },
    {},
    /style-src-elem/, // the driver's own, for its screenshots
  ));

/** Takes the graphics context away, as a driver does. */
async function loseContext(visit: Visit): Promise<void> {
  const worker = visit.page.workers()[0]!;
  await worker.evaluate(() => {
    const { clear } = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.clear = function (what) {
      self.lastContext = this;
      clear.call(this, what);
    };
  });
  await visit.picture(); // draws
  const isLost = visit.page.waitForEvent("worker");
  await worker.evaluate(() => self.lastContext!.getExtension("WEBGL_lose_context")!.loseContext());
  await isLost;
}

test("SessionGoesOnAfterLostContextsAndWithoutACardAtLast", () =>
  losing.visit(
    async (visit) => {
      await visit.openScan("tablet");
      const session = await visit.session();
      await visit.replay(["camera 60 10", "beta 0", "wait"]);
      const before = await visit.picture();
      for (let losses = 1; losses <= 4; ++losses) {
        await loseContext(visit);
        await visit.settled();
        assert.equal(await visit.session(), session);
        const core = await until(
          () => coreOf(visit),
          (name) => name !== "",
        );
        assert.equal(core, losses <= 3 ? "core" : "core_raster");
      }
      const after = difference(before, await visit.picture());
      assert.ok(after.mean < 1, JSON.stringify(after));
      await visit.replay(["beta 0.5", "wait"]);
      assert.equal((await losing.state(session)).beta, 0.5);
    },
    {},
    /CONTEXT_LOST_WEBGL/,
  ));
