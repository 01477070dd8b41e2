import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, difference, until, type Visit } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
});
after(() => lab.stop());

/** Opens a new session of the tablet, and runs the test with its name. */
const edit = (test: (visit: Visit, session: string) => Promise<void>) =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await test(visit, await visit.session());
  });

const edits = (session: string, count: number) =>
  until(
    () => lab.state(session),
    (state) => state.edits === count,
  );

test("ScanIsDrawn", () =>
  edit(async (visit) => {
    const { data } = await visit.pixels();
    const shades = new Set<number>();
    for (let i = 0; i < data.length; i += 4) shades.add(data[i]!);
    assert.ok(shades.size > 50, `${shades.size} shades of red are no lit surface`);
    await visit.screenshot("session");
  }));

test("BetaSliderMovesTheSurface", () =>
  edit(async (visit, session) => {
    const before = await visit.picture();
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("Home");
    const state = await edits(session, 1);
    assert.equal(state.beta, 0);
    await until(
      async () => difference(before, await visit.picture()).mean,
      (mean) => mean > 0.5,
    );
  }));

test("TypedBetaIsAnEditAndUndoTakesItBack", () =>
  edit(async (visit, session) => {
    const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
    await field.fill("0,35");
    await field.press("Enter");
    assert.equal((await edits(session, 1)).beta, 0.35);
    await visit.choose("Edit", "Undo");
    await until(
      () => lab.state(session),
      (state) => state.beta === 1,
    );
    await visit.choose("Edit", "Redo");
    await until(
      () => lab.state(session),
      (state) => state.beta === 0.35,
    );
  }));

test("MousePaintsAStroke", () =>
  edit(async (visit, session) => {
    await visit.page.getByRole("button", { name: "Smooth", exact: true }).click();
    await visit.drag([0.45, 0.5], [0.6, 0.55]);
    await edits(session, 1);
    const [entry] = await lab.history(session);
    assert.equal(entry?.kind, "stroke");
    await visit.page.getByRole("checkbox", { name: /^Entry 1: / }).waitFor();
  }));

test("CurveIsDrawnInItsPlot", () =>
  edit(async (visit, session) => {
    const plot = await visit.section("Transfer curve α(κ)");
    const box = (await plot.getByLabel("Plot of the transfer curve").boundingBox())!;
    await visit.page.mouse.click(box.x + 0.3 * box.width, box.y + 0.3 * box.height);
    await edits(session, 1);
    const { curve } = await lab.state(session);
    assert.match(curve, /^-?[\d.]+:[\d.]+(,-?[\d.]+:[\d.]+)+$/);
  }));

test("EdgesForThisScanAreKeptAndItsNoiseIsSaid", () =>
  edit(async (visit, session) => {
    const panel = await visit.section("Keep edges");
    await panel.getByRole("combobox", { name: "Kept edges" }).selectOption("For this scan");
    await panel.getByText(/^noise about [\d.e-]+/).waitFor();
    await edits(session, 2);
    await visit.screenshot("for-this-scan");
  }));

test("HistorySwitchesAnEditOffAndACheckpointComesBack", () =>
  edit(async (visit, session) => {
    const slider = visit.page.getByRole("slider", { name: "Gradient scale β", exact: true });
    await slider.press("Home");
    await edits(session, 1);
    await visit.page.getByRole("textbox", { name: "Name of a checkpoint or fork" }).fill("smooth");
    await visit.page.getByRole("button", { name: "Checkpoint" }).click();
    await visit.page.getByRole("button", { name: "Restore smooth" }).waitFor();
    await visit.page.getByRole("checkbox", { name: /^Entry 1: / }).click();
    await until(
      () => lab.history(session),
      (entries) => entries.some((entry) => entry.kind !== "checkpoint" && !entry.enabled),
    );
    await visit.page.getByRole("button", { name: "Restore smooth" }).click();
    await until(
      () => lab.state(session),
      (state) => state.beta === 0,
    );
  }));
