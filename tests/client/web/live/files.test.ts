import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab, until, type Visit } from "./lab";

const lab = new Lab();
before(async () => {
  await lab.start();
  await lab.importTablet();
});
after(() => lab.stop());

/** Exports by the dialog, and returns what the browser keeps. */
async function exportBy(visit: Visit, format: string): Promise<{ name: string; bytes: Buffer }> {
  await visit.choose("File", "Export…");
  const dialog = visit.page.getByRole("dialog", { name: "Export" });
  await dialog.getByRole("combobox", { name: "Format" }).selectOption(format);
  await dialog.getByRole("checkbox", { name: "Exact" }).click();
  const download = visit.page.waitForEvent("download");
  await dialog.getByRole("button", { name: "Export" }).click();
  const file = await download;
  return { name: file.suggestedFilename(), bytes: readFileSync(await file.path()) };
}

const setBeta = async (visit: Visit, value: string) => {
  const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
  await field.fill(value);
  await field.press("Enter");
};

test("FileIsImportedWithProgressAndOpened", () =>
  lab.visit(async (visit) => {
    await lab.run("generate", "blob", "vase.ply", "--vertices", "60000");
    const chooser = visit.page.waitForEvent("filechooser");
    await visit.page.getByRole("button", { name: "Open a scan…" }).click();
    await (await chooser).setFiles(lab.path("vase.ply"));
    await visit.page.getByRole("progressbar").first().waitFor();
    await visit.settled();
    const meshes = JSON.parse(await lab.ask("meshes", "--json")) as { name: string }[];
    assert.ok(meshes.some((one) => one.name === "vase"), JSON.stringify(meshes));
    await visit.screenshot("imported");
  }));

for (const format of ["ply", "obj"])
  test(`${format.toUpperCase()}ThatIsNotEditedIsThatOfTheCommandLine`, () =>
    lab.visit(async (visit) => {
      await visit.openScan("tablet");
      const session = await visit.session();
      const { name, bytes } = await exportBy(visit, "." + format);
      assert.equal(name, `${session.replaceAll(" ", "-")}.${format}`);
      await lab.ask("export", session, "wanted." + format, "--exact");
      assert.ok(bytes.equals(lab.bytes("wanted." + format)), `${bytes.length} bytes differ from the command line's`);
    }));

/** Returns the numbers of an OBJ file's vertices. */
const positions = (obj: Buffer) =>
  obj
    .toString()
    .split("\n")
    .filter((line) => line.startsWith("v "))
    .flatMap((line) => line.split(" ").slice(1, 4).map(Number));

/** Each export solves on from the last one, so those of an edited session agree to the solver's accuracy. */
function assertNear(one: Buffer, other: Buffer): void {
  const [a, b] = [positions(one), positions(other)];
  assert.equal(a.length, b.length);
  const [low, high] = [Math.min(...a), Math.max(...a)];
  const farthest = Math.max(...a.map((value, i) => Math.abs(value - b[i]!)));
  assert.ok(farthest < 1e-5 * (high - low), `a vertex is ${farthest} away, of ${high - low}`);
}

test("EditedExportIsThatOfTheCommandLine", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    await setBeta(visit, "0.5");
    await until(
      () => lab.state(session),
      ({ edits }) => edits === 1,
    );
    const { bytes } = await exportBy(visit, ".obj");
    await lab.ask("export", session, "wanted.obj", "--exact");
    assertNear(bytes, lab.bytes("wanted.obj"));
  }));

test("RecordedScriptGivesTheSameExport", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    await visit.choose("File", "Record a script");
    await setBeta(visit, "0.4");
    await visit.page.getByRole("button", { name: "Sharpen", exact: true }).click();
    await visit.drag([0.45, 0.5], [0.6, 0.55]);
    await until(
      () => lab.state(session),
      ({ edits }) => edits === 2,
    );
    const download = visit.page.waitForEvent("download");
    await visit.choose("File", "Stop recording");
    const script = readFileSync(await (await download).path(), "utf8");
    await lab.ask("open", "tablet", "--session", "replayed");
    const lines = script.split("\n").filter((line) => !/^(open|join) /.test(line));
    writeFileSync(lab.path("edits.txt"), ["join replayed", ...lines, "export replayed.obj exact", ""].join("\n"));
    await lab.ask("window", "--script", "edits.txt");
    await lab.ask("export", session, "original.obj", "--exact");
    assertNear(lab.bytes("replayed.obj"), lab.bytes("original.obj"));
  }));
