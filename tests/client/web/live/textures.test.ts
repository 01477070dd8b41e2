// A scan with a picture, finer than its triangles: the page shows each texel, as the window does.

import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab, difference, type Pixels, type Visit } from "./lab";
import { importLettered } from "./lettered";
import { importPhotos } from "./photos";

const labs = { card: new Lab("card"), processor: new Lab("best", "plain") };
const prepare = async (lab: Lab) => {
  await lab.start();
  await importLettered(lab);
  await lab.ask("open", "lettered", "--session", "shown");
};
before(() => Promise.all(Object.values(labs).map(prepare)));
after(() => Promise.all(Object.values(labs).map((lab) => lab.stop())));

/** Returns how often a row of a picture's middle turns from dark to light or back. */
function turns({ width, height, data }: Pixels): number {
  const row = Math.floor(0.62 * height);
  let count = 0;
  let isDark = false;
  for (let x = Math.floor(0.3 * width); x < 0.7 * width; ++x) {
    const red = data[4 * (row * width + x)]!;
    if (isDark ? red > 160 : red < 100) (isDark = !isDark), ++count;
  }
  return count;
}

/** Returns the window's picture of the same session and lines. */
async function windowPicture(lab: Lab, visit: Visit, { width, height }: Pixels, lines: string[]): Promise<Pixels> {
  const script = ["join shown", "wait", `size ${width}x${height}`, ...lines, "wait", "screenshot window.png", ""];
  writeFileSync(lab.path("view.txt"), script.join("\n"));
  await lab.ask("window", "--script", "view.txt");
  return visit.decode(lab.bytes("window.png"));
}

const kTexels = ["colour scan", "light unlit"];
/** Lines that lead to a picture, how many stripes it has at least, and how often it shows what texels differ by. */
const kViews: [name: string, lines: string[], turns: number, gain: number][] = [
  ["aslant", ["camera 25 20", ...kTexels], 40, 1],
  ["near", ["camera 10 70 250 0 -60 0", ...kTexels], 10, 1],
  ["lit", ["camera 25 20", "colour scan", "light clay"], 0, 1],
  ["edited", ["camera 25 20", ...kTexels, "colours 0.2 20"], 0, 1],
  ["strong", ["camera 25 20", ...kTexels, "texture 2 0.5"], 0, 2],
];

/** Visits the page anew for each view: finer texels of another view would stay. */
async function showTheTexelsOfTheWindow(lab: Lab, mean: number, most: number): Promise<void> {
  const wrong: string[] = [];
  for (const [name, lines, stripes, gain] of kViews)
    await lab.visit(async (visit) => {
      await visit.join("shown");
      await visit.hideScaleBar();
      await visit.replay([...lines, "wait"]);
      const shown = await visit.picture();
      await visit.screenshot(`textures-${name}`);
      const found = difference(shown, await windowPicture(lab, visit, shown, lines));
      if (found.mean > gain * mean || found.most > gain * most || turns(shown) < stripes)
        wrong.push(`${name}: ${JSON.stringify(found)}, ${turns(shown)} turns`);
    });
  assert.deepEqual(wrong, []);
}

// OpenGL's samples and filters differ a little from those of processors.
test("TexelsOfOpenGlAreThoseOfTheWindow", () => showTheTexelsOfTheWindow(labs.card, 1, 24));
test("TexelsOfTheProcessorAreThoseOfTheWindow", () => showTheTexelsOfTheWindow(labs.processor, 0.01, 0));

test("FilesThatAreGivenTogetherAreOneTexturedScanWhichGoesOutAsAnArchive", () => {
  const lab = labs.processor;
  writeFileSync(lab.path("given.obj"), lab.bytes("lettered.obj") + "# given\n");
  return lab.visit(async (visit) => {
    const chooser = visit.page.waitForEvent("filechooser");
    await visit.page.getByRole("button", { name: "Open a scan…" }).click();
    await (await chooser).setFiles(["given.obj", "skin.mtl", "skin.png"].map((name) => lab.path(name)));
    await visit.settled();
    await visit.replay(["camera 25 20", ...kTexels, "wait"]);
    const stripes = turns(await visit.picture());
    assert.ok(stripes >= 40, `${stripes} turns`);
    await visit.choose("File", "Export…");
    const dialog = visit.page.getByRole("dialog", { name: "Export" });
    assert.equal(await dialog.getByRole("combobox", { name: "Format" }).inputValue(), "zip");
    const download = visit.page.waitForEvent("download");
    await dialog.getByRole("button", { name: "Export" }).click();
    assert.equal((await download).suggestedFilename(), "given.zip");
  });
});

/** Returns how much brightness steps between near pixels around the middle of a picture. */
function step({ width, height, data }: Pixels): number {
  const red = (x: number) => data[4 * (Math.floor(height / 2) * width + x)]!;
  let most = 0;
  for (let x = Math.floor(0.4 * width); x < 0.6 * width; ++x) most = Math.max(most, Math.abs(red(x + 3) - red(x)));
  return most;
}

test("SeamsThatASessionLevelsAreLevelInThePageAndTheWindow", async () => {
  const lab = labs.processor;
  await importPhotos(lab);
  await lab.ask("open", "photos", "--session", "level");
  await lab.visit(async (visit) => {
    await visit.join("level");
    await visit.hideScaleBar();
    await visit.replay(["camera 0 0", ...kTexels, "wait"]);
    const before = step(await visit.picture());
    assert.ok(before > 20, `the step is ${before}`);
    await visit.replay(["texture 1 0 1", "wait"]);
    const shown = await visit.picture();
    assert.ok(step(shown) < 0.3 * before, `the step went from ${before} to ${step(shown)}`);
    const lines = ["join level", "wait", `size ${shown.width}x${shown.height}`, "camera 0 0", ...kTexels, "wait"];
    writeFileSync(lab.path("level.txt"), [...lines, "screenshot level.png", ""].join("\n"));
    await lab.ask("window", "--script", "level.txt");
    assert.ok(difference(shown, await visit.decode(lab.bytes("level.png"))).most <= 1);
    await visit.replay(["undo", "wait"]);
    assert.ok(Math.abs(step(await visit.picture()) - before) <= 1);
  });
});
