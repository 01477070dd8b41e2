import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, difference, until, type Pixels, type Visit } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
});
after(() => lab.stop());

/** Returns the columns of a picture between two parts of its width. */
function columns({ width, height, data }: Pixels, from: number, to: number): Pixels {
  const [left, right] = [Math.round(from * width), Math.round(to * width)];
  const rows = Array.from({ length: height }, (_, y) => data.subarray(4 * (y * width + left), 4 * (y * width + right)));
  return { width: right - left, height, data: new Uint8Array(Buffer.concat(rows)) };
}

const check = (visit: Visit, name: string) => visit.page.getByRole("checkbox", { name, exact: true });

test("SplitLinePartsOriginalAndEdited", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("Home");
    await until(
      async () => (await lab.state(await visit.session())).edits,
      (edits) => edits === 1,
    );
    await visit.settled();
    await visit.hover([0.02, 0.02]); // beside the surface: no ring
    const edited = await visit.picture();
    await check(visit, "Original").click();
    const original = await until(
      () => visit.picture(),
      (picture) => difference(edited, picture).mean > 0.1,
    );
    await check(visit, "Original").click();
    await check(visit, "Split").click();
    const line = visit.page.getByRole("separator", { name: "Line between original and edited" });
    const box = (await line.boundingBox())!;
    const picture = (await visit.page.getByRole("img", { name: /^Picture of/ }).boundingBox())!;
    await visit.page.mouse.move(box.x + box.width / 2, box.y + 60);
    await visit.page.mouse.down();
    await visit.page.mouse.move(picture.x + 0.7 * picture.width, box.y + 80, { steps: 5 });
    await visit.page.mouse.up();
    const isAt = (part: string) =>
      until(
        () => line.getAttribute("aria-valuenow"),
        (value) => value === part,
      );
    await line.press("ArrowLeft");
    await isAt("69");
    await visit.hover([0.02, 0.02]);
    const split = await visit.picture();
    await visit.screenshot("split");
    assert.ok(difference(columns(original, 0, 0.68), columns(split, 0, 0.68)).mean < 0.05);
    assert.ok(difference(columns(edited, 0.7, 1), columns(split, 0.7, 1)).mean < 0.05);
    assert.ok(difference(columns(edited, 0, 0.68), columns(split, 0, 0.68)).mean > 0.1);
  }));

test("ScaleBarFollowsTheCameraAndIsInTheSavedPicture", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const bar = visit.page.getByRole("img", { name: /^Scale bar: \d/ });
    const text = async () => (await bar.textContent())!;
    const before = await text();
    await visit.hover([0.5, 0.5]);
    await visit.page.mouse.wheel(0, -1000);
    await until(text, (now) => Number.parseFloat(now) < Number.parseFloat(before));
    await visit.settled();
    await visit.hover([0.02, 0.98]); // beside the surface: no ring
    await visit.screenshot("guides");
    const barred = await visit.picture();
    await check(visit, "Scale bar").click();
    await bar.waitFor({ state: "detached" });
    const plain = await visit.picture();
    assert.ok(difference(columns(barred, 0.6, 1), columns(plain, 0.6, 1)).mean > 0.1);
    assert.ok(difference(columns(barred, 0, 0.6), columns(plain, 0, 0.6)).mean < 0.05);
  }));

test("ClickOnAnEndOfAnAxisLooksFromThere", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const end = (name: string) => visit.page.locator(`.axes [data-axis="${name}"] circle.end`);
    const middle = await visit.page.locator(".axes .behind").getAttribute("cx");
    for (const name of ["x", "y", "-z", "z"]) {
      const box = (await end(name).boundingBox())!;
      await visit.page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
      const is = async () => [await end(name).getAttribute("cx"), await end(name).getAttribute("cy")];
      await until(is, (place) => place.every((one) => one === middle));
      await visit.page.keyboard.press("Home");
      await until(is, (place) => !place.every((one) => one === middle));
    }
    assert.equal((await lab.state(await visit.session())).edits, 0);
    await check(visit, "Axes").click();
    await end("x").waitFor({ state: "detached" });
  }));

const regions = async (session: string) =>
  (await lab.history(session)).filter(({ summary }) => /protect/i.test(summary)).length;

test("LassoIsSeenAndProtects", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    const limits = await visit.section("Limits");
    const protect = limits.getByRole("button", { name: "Protect" });
    await protect.click();
    const box = (await visit.page.getByRole("img", { name: /^Picture of/ }).boundingBox())!;
    const at = (x: number, y: number) => [box.x + x * box.width, box.y + y * box.height] as const;
    await visit.page.mouse.move(...at(0.4, 0.4));
    await visit.page.mouse.down();
    await visit.page.mouse.move(...at(0.6, 0.4), { steps: 4 });
    await visit.page.mouse.move(...at(0.6, 0.6), { steps: 4 });
    const line = visit.page.locator("polygon.lasso");
    await until(
      async () => ((await line.getAttribute("points")) ?? "").split(" ").length,
      (numbers) => numbers >= 12,
    );
    await visit.screenshot("lasso");
    await visit.page.mouse.up();
    await line.waitFor({ state: "detached" });
    await until(
      () => regions(session),
      (count) => count === 1,
    );
  }));

test("LassoIsDrawnByKeysAlone", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    const limits = await visit.section("Limits");
    await limits.getByRole("button", { name: "Protect" }).press("Enter");
    const pen = visit.page.getByRole("button", { name: "Pen of the lasso" });
    await pen.press("Enter");
    for (const key of ["ArrowRight", "ArrowDown", "ArrowLeft"]) for (let i = 0; i < 3; ++i) await pen.press(`Shift+${key}`);
    await pen.press("Enter");
    await pen.waitFor({ state: "detached" });
    await until(
      () => regions(session),
      (count) => count === 1,
    );
  }));
