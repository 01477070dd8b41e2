import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Lab, difference, until } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
  await lab.ask("open", "tablet", "--session", "shared");
});
after(() => lab.stop());

test("TwoBrowsersSeeEachOthersEditsAndRings", () =>
  lab.visit(async (one) => {
    await one.join("shared");
    await lab.visit(async (other) => {
      await other.join("shared");
      for (const visit of [one, other])
        await until(
          () => visit.page.getByRole("list", { name: "People here" }).getByRole("listitem").count(),
          (count) => count === 2,
        );
      await one.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("Home");
      const field = other.page.getByRole("textbox", { name: "Gradient scale β as a number" });
      await until(
        () => field.inputValue(),
        (value) => value === "0",
      );
      await other.settled();
      const without = await until(
        async () => [await other.picture(), await other.picture()] as const,
        ([first, second]) => difference(first, second).mean === 0,
      );
      await one.hover([0.5, 0.5]);
      const { mean } = await until(
        async () => difference(without[1], await other.picture()),
        (changed) => changed.mean > 0,
      );
      assert.ok(mean < 5, `a ring changes few pixels, not ${mean} of 255`);
      await other.screenshot("ring");
    });
  }));

test("CommandLineAndBrowserEditOneSession", () =>
  lab.visit(async (visit) => {
    await visit.join("shared");
    await lab.ask("edit", "shared", "--beta", "2.5");
    await until(
      () => visit.page.getByRole("textbox", { name: "Gradient scale β as a number" }).inputValue(),
      (value) => value === "2.5",
    );
  }));

test("KilledServerComesBackAndNoEditIsLost", () =>
  lab.visit(
    async (visit) => {
      await visit.join("shared");
      const before = (await lab.state("shared")).edits;
      await lab.kill();
      await visit.page.getByRole("alert").getByText("Connection lost.").waitFor();
      const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
      await field.fill("0.7");
      await field.press("Enter");
      await visit.page.getByText("1 edit waits for the server.").waitFor();
      await lab.revive();
      await visit.page.getByRole("alert").waitFor({ state: "detached" });
      const state = await until(
        () => lab.state("shared"),
        ({ edits }) => edits > before,
      );
      assert.deepEqual([state.edits, state.beta], [before + 1, 0.7]);
    },
    {},
    /WebSocket connection to .* failed/,
  ));
