import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, until, type Visit } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
});
after(() => lab.stop());

const presets = (visit: Visit) => visit.page.getByRole("combobox", { name: "Presets" });

async function keep(visit: Visit, beta: string, name: string): Promise<void> {
  const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
  await field.fill(beta);
  await field.press("Enter");
  await visit.page.getByRole("textbox", { name: "Name for this filter" }).fill(name);
  await visit.page.getByRole("button", { name: "Keep", exact: true }).click();
  await presets(visit).getByRole("option", { name }).waitFor({ state: "attached" });
}

test("OwnPresetIsThereAfterAReloadAndInAnotherSession", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await keep(visit, "0.25", "faint lines");
    await visit.choose("File", "Close session");
    await visit.page.getByRole("heading", { name: "Recent" }).waitFor();
    await visit.page.reload();
    await visit.openScan("tablet");
    await presets(visit).selectOption("faint lines");
    const session = await visit.session();
    await until(
      () => lab.state(session),
      ({ beta }) => beta === 0.25,
    );
    await visit.page.getByRole("button", { name: "Delete faint lines" }).click();
    await presets(visit).getByRole("option", { name: "faint lines" }).waitFor({ state: "detached" });
  }));

test("StrengthIsChosenByItsPictureOfTheSession", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await presets(visit).selectOption("Soften");
    await visit.page.getByRole("button", { name: "Compare strengths" }).click();
    const pictures = visit.page.getByRole("group", { name: "Pictures of strengths" });
    await pictures.locator("img").nth(2).waitFor();
    const sources = await pictures.locator("img").evaluateAll((all) => all.map((one) => (one as HTMLImageElement).src));
    assert.equal(new Set(sources).size, 3);
    const widths = await pictures.locator("img").evaluateAll((all) => all.map((one) => (one as HTMLImageElement).naturalWidth));
    assert.deepEqual(widths, [240, 240, 240]);
    const session = await visit.session();
    const full = (await lab.state(session)).beta;
    assert.ok(full < 1);
    await pictures.getByRole("button", { name: "Strength 0.33, a little of the preset" }).click();
    await until(
      () => lab.state(session),
      ({ beta }) => Math.abs(beta - (1 - (1 - full) / 3)) < 1e-6,
    );
    await pictures.getByRole("button", { name: "Strength 0.33, a little of the preset", pressed: true }).waitFor();
  }));

test("OwnKeyIsThereAfterAReload", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    await visit.page.keyboard.press("?");
    const dialog = visit.page.getByRole("dialog", { name: "Keys" });
    await dialog.getByRole("button", { name: /^Change Ctrl\+Z:/ }).click();
    await visit.page.keyboard.press("u");
    await dialog.getByRole("button", { name: /^Change U:/ }).waitFor();
    await visit.page.reload();
    await visit.settled();
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("Home");
    const isEnabled = async () => (await lab.history(session)).map(({ enabled }) => enabled);
    await until(isEnabled, (all) => all.length === 1 && all[0] === true);
    await visit.page.keyboard.press("u");
    await until(isEnabled, (all) => all[0] === false);
  }));

test("BuiltInNamesAreRefused", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await visit.page.getByRole("textbox", { name: "Name for this filter" }).fill("Soften");
    await visit.page.getByRole("button", { name: "Keep", exact: true }).click();
    await visit.page.getByText("preset 'Soften' is built in").first().waitFor();
  }));

test("TwoTabsKeepEachOthersPresets", () =>
  lab.visit(async (one) => {
    await one.openScan("tablet");
    const page = await one.page.context().newPage();
    await page.goto(lab.address());
    await page.getByRole("button", { name: "New session of tablet" }).click();
    const name = page.getByRole("textbox", { name: "Name for this filter" });
    await name.waitFor();
    await keep(one, "0.5", "first");
    await name.fill("second");
    await page.getByRole("button", { name: "Keep", exact: true }).click();
    const options = await until(
      () => page.getByRole("combobox", { name: "Presets" }).getByRole("option").allInnerTexts(),
      (texts) => texts.includes("second"),
    );
    assert.ok(options.includes("first"), options.join(", "));
  }));
