import assert from "node:assert/strict";
import { createHash } from "node:crypto";
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
    assert.ok(bytes.equals(lab.bytes("wanted.obj")), `${bytes.length} bytes differ from the command line's`);
  }));

/** Drags a point of the curve's plot upwards. */
async function dragCurve(visit: Visit): Promise<void> {
  const box = (await visit.page.getByRole("group", { name: "Plot of the transfer curve" }).boundingBox())!;
  await visit.page.mouse.move(box.x + 0.7 * box.width, box.y + 0.6 * box.height);
  await visit.page.mouse.down();
  await visit.page.mouse.move(box.x + 0.72 * box.width, box.y + 0.43 * box.height, { steps: 5 });
  await visit.page.mouse.up();
}

/** Ends a recording, and returns its lines. */
async function recorded(visit: Visit): Promise<string[]> {
  const download = visit.page.waitForEvent("download");
  await visit.choose("File", "Stop recording");
  const file = await download;
  assert.match(file.suggestedFilename(), /\.script$/);
  return readFileSync(await file.path(), "utf8").split("\n");
}

/** Runs a recorded script in another session. */
async function replayIn(session: string, lines: string[]): Promise<void> {
  await lab.ask("open", "tablet", "--session", session);
  const rest = lines.filter((line) => !/^join /.test(line));
  writeFileSync(lab.path("edits.txt"), [`join ${session}`, ...rest].join("\n"));
  await lab.ask("window", "--script", "edits.txt");
}

test("ExportHasAProcessingRecordBesideIt", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    await setBeta(visit, "0.5");
    await visit.choose("File", "Export…");
    const dialog = visit.page.getByRole("dialog", { name: "Export" });
    await dialog.getByRole("textbox", { name: "Name of the file" }).fill("carved");
    await dialog.getByRole("checkbox", { name: "Processing record" }).click();
    const downloads = new Map<string, Promise<string>>();
    visit.page.on("download", (file) => downloads.set(file.suggestedFilename(), file.path()));
    await dialog.getByRole("button", { name: "Export" }).click();
    await until(
      async () => [...downloads.keys()].sort().join(" "),
      (names) => names === "carved-record.html carved-record.json carved.ply",
    );
    const read = async (name: string) => readFileSync(await downloads.get(name)!);
    const record = JSON.parse((await read("carved-record.json")).toString()) as {
      output: { file: string; sha256: string };
      edits: { what: string }[];
    };
    assert.equal(record.output.file, "carved.ply");
    assert.equal(record.output.sha256, createHash("sha256").update(await read("carved.ply")).digest("hex"));
    assert.deepEqual(
      record.edits.map(({ what }) => what),
      ["beta 0.5"],
    );
    assert.match((await read("carved-record.html")).toString(), /Gradient scale 0\.5/);
  }));

test("RecordedScriptGivesTheSameExportByteForByte", () =>
  lab.visit(async (visit) => {
    await visit.openScan("tablet");
    const session = await visit.session();
    await visit.choose("File", "Record a script");
    await visit.page.getByText("recording", { exact: true }).waitFor();
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("PageDown");
    await dragCurve(visit);
    await visit.page.getByRole("button", { name: "Sharpen", exact: true }).click();
    await visit.drag([0.45, 0.5], [0.6, 0.55]);
    await visit.drag([0.4, 0.4], [0.5, 0.6]);
    await visit.page.keyboard.press("Control+z");
    const limits = await visit.section("Limits");
    await limits.getByRole("button", { name: "Protect" }).click();
    await visit.drag([0.3, 0.3], [0.5, 0.45]);
    await limits.getByRole("button", { name: "Piece" }).click();
    await until(
      async () => (await lab.history(session)).filter(({ enabled }) => !enabled).length,
      (undone) => undone === 1,
    );
    const { bytes } = await exportBy(visit, ".ply");
    const entries = (await lab.history(session)).map(({ summary }) => summary);
    const lines = await recorded(visit);
    assert.match(lines[0]!, /^join /);
    assert.ok(lines.some((line) => /^export .*\.ply exact$/.test(line)), lines.join("\n"));
    await replayIn("replayed", lines);
    assert.deepEqual(
      (await lab.history("replayed")).map(({ summary }) => summary),
      entries,
    );
    await lab.ask("export", "replayed", "replayed.ply", "--exact");
    assert.ok(bytes.equals(lab.bytes("replayed.ply")), "the exports differ");
  }));
