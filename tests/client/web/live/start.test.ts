import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, difference, until, type Visit } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
});
after(() => lab.stop());

/** Returns the picture of a card, once there is one. */
async function cardOf(visit: Visit, session: string) {
  const picture = visit.page.getByRole("button", { name: `Go on with ${session}` }).getByRole("img");
  await picture.waitFor();
  const address = (await picture.getAttribute("src"))!;
  assert.match(address, /^data:image\/jpeg;base64,/);
  return visit.decode(Buffer.from(address.split(",")[1]!, "base64"));
}

test("StartPageShowsHowSessionsLookedLast", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    await visit.choose("File", "Close session");
    const before = await cardOf(visit, session);
    assert.deepEqual([before.width, before.height], [256, 160]);
    await visit.page.getByRole("img", { name: "Picture of tablet", exact: true }).first().waitFor();
    await visit.join(session);
    await visit.page.getByRole("checkbox", { name: "Wireframe" }).click();
    await until(
      () => visit.page.getByRole("checkbox", { name: "Wireframe" }).isChecked(),
      (is) => is,
    );
    await visit.choose("File", "Close session");
    await until(
      async () => difference(before, await cardOf(visit, session)).mean,
      (mean) => mean > 2,
    );
    await visit.screenshot("start");
    await visit.page.reload();
    await cardOf(visit, session); // the browser keeps it
  }));

test("PictureOfADeletedSessionGoes", () =>
  lab.visit(async (visit) => {
    const kept = () =>
      visit.page.evaluate(() => Object.keys(localStorage).filter((key) => key.startsWith("burnish.kept.picture/")).length);
    await visit.openScan("tablet");
    const session = await visit.session();
    await visit.choose("File", "Close session");
    await cardOf(visit, session);
    await visit.page.getByRole("button", { name: `Delete ${session}` }).click();
    await visit.page.getByRole("button", { name: "Delete for good" }).click();
    await visit.page.getByRole("button", { name: `Go on with ${session}` }).waitFor({ state: "detached" });
    await visit.openScan("tablet");
    await until(kept, (count) => count === 1);
  }));
