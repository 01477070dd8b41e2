// No call of OpenGL fails in the page. The engine asks rarely for errors, so here a question follows each call.

import { after, before, test } from "node:test";
import { Lab, type Visit } from "./lab";
import { importLettered } from "./lettered";

const lab = new Lab("card");
before(async () => {
  await lab.start();
  await lab.importTablet();
  await importLettered(lab);
});
after(() => lab.stop());

/** Runs in the engine: a question follows each call. An error goes to the console, which a visit wants to be empty. */
function askAfterEachCall(): void {
  const { prototype } = WebGL2RenderingContext;
  const { getError } = prototype;
  const functions = prototype as unknown as Record<string, (this: WebGL2RenderingContext, ...parts: unknown[]) => unknown>;
  const tell = (what: string, gl: WebGL2RenderingContext) => {
    for (let error = getError.call(gl); error !== 0; error = getError.call(gl)) console.error(`${what}: OpenGL error ${error}`);
  };
  for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(prototype))) {
    if (typeof value !== "function" || name === "getError" || name === "constructor") continue;
    functions[name] = function (...parts) {
      tell(`before ${name}`, this);
      const answer: unknown = value.apply(this, parts);
      tell(`${name}(${parts.map((one) => (typeof one === "number" ? one : typeof one)).join(", ")})`, this);
      return answer;
    };
  }
}

const kLooks = [
  ["wireframe on", "wireframe off"],
  ["split on", "split off"],
  ["flat on", "flat off"],
  ["original on", "original off"],
  ["colour displacement", "colour clay"],
  ["light radiance", "light clay"],
  ["light cavity", "light clay"],
  ["occlusion 1", "wireframe on", "light radiance", "split on", "split off", "wireframe off", "occlusion 0", "light clay"],
  ["orthographic on", "view top", "orthographic off"],
];

async function useEverything(visit: Visit): Promise<void> {
  for (const lines of kLooks)
    for (const line of lines) {
      await visit.replay([line]);
      await visit.picture();
    }
  for (const [width, height] of [[700, 500], [1300, 900], [1024, 700]] as const) {
    await visit.page.setViewportSize({ width, height });
    await visit.replay(["occlusion 1", "light radiance"]);
    await visit.picture();
    await visit.replay(["occlusion 0", "light clay"]);
    await visit.picture();
  }
  await visit.drag([0.4, 0.5], [0.6, 0.5]);
  await visit.settled();
  await visit.replay(["camera 25 20 100", "wait", "camera 25 20", "wait", "undo", "wait"]);
}

test("NoCallOfOpenGlFails", () =>
  lab.visit(async (visit) => {
    await visit.page.getByText(/^connected to/).waitFor();
    await visit.page.workers()[0]!.evaluate(askAfterEachCall);
    for (const scan of ["tablet", "lettered"]) {
      await visit.openScan(scan);
      if (scan === "lettered") await visit.replay(["colour scan", "light unlit", "wait"]);
      await useEverything(visit);
      await visit.choose("File", "Close session");
    }
  }));
