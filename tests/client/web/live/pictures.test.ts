import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab, difference } from "./lab";

const labs = { card: new Lab("card"), processor: new Lab("best", "plain") };
const prepare = async (lab: Lab) => {
  await lab.start();
  await lab.importTablet();
  await lab.ask("open", "tablet", "--session", "shown");
  await lab.ask("edit", "shown", "--beta", "0.5");
};
before(() => Promise.all(Object.values(labs).map(prepare)));
after(() => Promise.all(Object.values(labs).map((lab) => lab.stop())));

/** Lines that lead to a picture, and how far it may be from the window's: mean and 99th percentile, of 255. */
const kViews: [name: string, lines: string[], mean: number, most: number][] = [
  ["clay", [], 0.3, 4],
  ["wireframe", ["wireframe on"], 1.5, 30], // drivers draw lines in ways of their own
  ["flat", ["flat on"], 3, 40], // and derivatives at the edges of triangles
  ["split", ["split on"], 0.3, 4],
  ["displacement", ["colour displacement"], 0.3, 4],
  ["top", ["view top", "orthographic on"], 0.3, 4],
  ["raking", ["light raking"], 0.3, 4],
  ["bronze", ["light bronze"], 0.3, 4],
  ["radiance", ["light radiance"], 1.5, 12],
  ["occlusion", ["occlusion 1"], 1.5, 12],
];

const arePicturesOfTheWindow = (lab: Lab) =>
  lab.visit(async (visit) => {
    await visit.join("shown");
    await visit.hideScaleBar();
    const wrong: string[] = [];
    for (const [name, lines, mean, most] of kViews) {
      const undo = lines.map((line) => line.replace(/ on$/, " off"));
      await visit.replay(["camera 25 20", ...lines]);
      const shown = await visit.picture();
      const script = ["join shown", "wait", `size ${shown.width}x${shown.height}`, "camera 25 20", ...lines];
      writeFileSync(lab.path("view.txt"), [...script, `screenshot ${name}.png`, ""].join("\n"));
      await lab.ask("window", "--script", "view.txt");
      const wanted = await visit.decode(lab.bytes(name + ".png"));
      const found = difference(shown, wanted);
      if (found.mean > mean || found.most > most) wrong.push(`${name}: ${JSON.stringify(found)}`);
      await visit.replay([...undo.filter((line) => / off$/.test(line)), "light clay", "occlusion 0", "colour clay"]);
    }
    assert.deepEqual(wrong, []);
  });

test("PicturesOfOpenGlAreThoseOfTheWindow", () => arePicturesOfTheWindow(labs.card));
test("PicturesOfTheProcessorAreThoseOfTheWindow", () => arePicturesOfTheWindow(labs.processor));
