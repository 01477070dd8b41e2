import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab, until } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
});
after(() => lab.stop());

test("SectionAlongTheRulerIsDrawnAndSaved", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await visit.page.keyboard.press("m");
    for (const place of [[0.35, 0.5], [0.65, 0.55]] as const) {
      await visit.hover([...place]);
      await visit.page.mouse.down();
      await visit.page.mouse.up();
    }
    await visit.page.getByRole("img", { name: /^Ruler: \d/ }).waitFor();
    const numbers = await visit.section("Numbers");
    await numbers.getByRole("button", { name: "Section" }).click();
    const plot = visit.page.getByRole("region", { name: "Section", exact: true });
    await plot.getByRole("img", { name: "Drawing of the section", exact: true }).waitFor();
    const along = await plot.locator("text.way").allTextContents();
    assert.ok(along.includes("0") && along.length >= 4, `numbers along the ruler: ${along}`);
    assert.ok((await plot.locator("text.height").count()) >= 3);
    await visit.screenshot("section");
    const path = (kind: string) => plot.locator(`path.${kind}`).getAttribute("d");
    assert.equal(await path("before"), await path("after"), "nothing has been edited");
    assert.ok((await path("before"))!.split("L").length > 50);
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("Home");
    await until(
      async () => (await path("before")) !== (await path("after")),
      (differs) => differs,
    );
    for (const [button, name, begin] of [["Save drawing", "tablet-section.svg", "<svg"], ["Save table", "tablet-section.csv", "surface,line,right,up"]] as const) {
      const download = visit.page.waitForEvent("download");
      await plot.getByRole("button", { name: button }).click();
      const file = await download;
      assert.equal(file.suggestedFilename(), name);
      assert.ok(readFileSync(await file.path(), "utf8").includes(begin));
    }
    await plot.getByRole("button", { name: "Close the section" }).click();
    await plot.waitFor({ state: "detached" });
  }));

test("MovesOfTheMouseSetTheBrushsRadius", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const radius = visit.page.getByRole("textbox", { name: "Radius as a number" });
    const before = Number(await radius.inputValue());
    await visit.hover([0.5, 0.5]);
    await visit.page.keyboard.press("f");
    await visit.hover([0.6, 0.5], 1); // one move, so that the first larger value is the last
    const larger = await until(
      async () => Number(await radius.inputValue()),
      (value) => value > before,
    );
    await visit.page.mouse.down(); // ends it, and paints nothing
    await visit.page.mouse.up();
    await visit.hover([0.7, 0.5]);
    assert.equal((await lab.state(await visit.session())).edits, 0);
    assert.equal(Number(await radius.inputValue()), larger);
  }));
