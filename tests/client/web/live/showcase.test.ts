import { after, before, test } from "node:test";
import { Lab, until } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.run("generate", "tablet", "tablet.ply", "--vertices", "60000");
  await lab.ask("import", "tablet.ply", "--name", "tablet");
});
after(() => lab.stop());

// Leaves the README's picture: BURNISH_SCREENSHOTS=deploy/pictures tests/client/web/run_live BIN showcase
test("SmoothedTabletIsPaintedWithASharpBrush", () =>
  lab.visit(
    async (visit) => {
      await visit.openScan("tablet");
      const session = await visit.session();
      const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
      await field.fill("0.2");
      await field.press("Enter");
      await visit.page.getByRole("button", { name: "Sharpen", exact: true }).click();
      await visit.drag([0.42, 0.45], [0.62, 0.45]);
      await visit.drag([0.42, 0.55], [0.62, 0.55]);
      await until(
        () => lab.state(session),
        ({ edits }) => edits === 3,
      );
      await visit.page.getByRole("checkbox", { name: /^Entry 3: / }).waitFor();
      await visit.settled();
      await visit.picture(); // comes after the picture of the last frame
      await visit.screenshot("browser");
    },
    { viewport: { width: 1280, height: 800 }, colorScheme: "dark" },
  ));
