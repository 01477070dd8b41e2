import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Bench, type Visit } from "./harness";
import { library } from "./sample";

const bench = new Bench();
before(() => bench.start());
after(() => bench.stop());

test("StartGivesTheEngineACanvasAndNoToken", () =>
  bench.visit(async (visit) => {
    const start = await visit.message("start");
    assert.equal(start.hasCanvas, true);
    assert.equal(start.token, "");
    assert.equal(start.address, new URL(visit.page.url()).origin);
  }));

test("ScansAndSessionsOpenByName", () =>
  bench.visit(async (visit) => {
    await visit.page.getByRole("button", { name: "New session of tablet" }).click();
    await visit.sent("scan open a1 anew");
    await visit.order({ change: { document: null } });
    await visit.page.getByRole("button", { name: "Open portrait head" }).click();
    await visit.sent("scan open b2");
    await visit.order({ change: { document: null } });
    await visit.page.getByRole("button", { name: "Go on with inscription" }).click();
    await visit.sent("session join s1");
  }));

test("ReturnFromASessionShowsTheServerOnce", () =>
  bench.visitSession(async (visit) => {
    await visit.change({ document: null });
    const server = visit.page.getByText("connected to lab:7443");
    await server.waitFor();
    assert.equal(await server.count(), 1);
    assert.equal(await visit.page.getByRole("main").count(), 1);
  }));

test("RenameAsksForAName", () =>
  bench.visit(async (visit) => {
    await visit.page.getByRole("button", { name: "Rename tablet" }).click();
    await visit.page.getByRole("textbox", { name: "New name" }).fill("clay  tablet");
    await visit.page.keyboard.press("Enter");
    await visit.sent("scan rename a1 clay tablet");
    assert.equal(await visit.page.getByRole("dialog").count(), 0);
  }));

test("DeleteAsksFirst", () =>
  bench.visit(async (visit) => {
    await visit.page.getByRole("button", { name: "Delete tablet" }).click();
    const dialog = visit.page.getByRole("dialog", { name: "Delete tablet" });
    await dialog.getByText("and 1 session with its edits").waitFor();
    await dialog.getByRole("button", { name: "Cancel" }).click();
    await visit.page.getByRole("button", { name: "Delete inscription" }).click();
    await visit.page.getByRole("button", { name: "Delete for good" }).click();
    await visit.sent("session delete s1");
    assert.ok(!(await visit.lines()).includes("scan delete a1"));
  }));

test("ImportByButtonAndByDrop", () =>
  bench.visit(async (visit) => {
    const chooser = visit.page.waitForEvent("filechooser");
    await visit.page.getByRole("button", { name: "Open a scan…" }).click();
    await (await chooser).setFiles({ name: "vase.ply", mimeType: "", buffer: Buffer.from("ply") });
    assert.equal((await visit.message("import", { name: "vase.ply" })).size, 3);
    await visit.page.evaluate(() => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File(["solid"], "dropped.stl"));
      document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    });
    await visit.message("import", { name: "dropped.stl" });
  }));

/** Drops files on the page, by name and text. */
const drop = (visit: Visit, files: [string, string][]) =>
  visit.page.evaluate((files) => {
    const dataTransfer = new DataTransfer();
    for (const [name, text] of files) dataTransfer.items.add(new File([text], name));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
  }, files);

test("FilesBesideAScanGoWithItInAnArchive", () =>
  bench.visit(async (visit) => {
    await drop(visit, [["skin.png", "png"], ["vase.obj", "mtllib vase.mtl"], ["vase.mtl", "map_Kd skin.png"]]);
    const { size } = await visit.message("import", { name: "vase.zip" });
    const names = "skin.png".length + "vase.obj".length + "vase.mtl".length;
    const texts = "png".length + "mtllib vase.mtl".length + "map_Kd skin.png".length;
    assert.equal(size, 22 + 3 * (30 + 46) + 2 * names + texts);
  }));

test("SeveralScansAreImportedAndOthersNamed", () =>
  bench.visit(async (visit) => {
    await drop(visit, [["one.stl", "solid"], ["notes.txt", "x"], ["two.ply", "ply"]]);
    await visit.message("import", { name: "one.stl" });
    await visit.message("import", { name: "two.ply" });
    await visit.page.getByText("notes.txt is not a mesh file; it was left out").waitFor();
  }));

test("NameOfTheUserIsAskedForAndKept", () =>
  bench.visit(async (visit) => {
    await visit.page.getByText("Without a name you are a guest").waitFor();
    await visit.page.getByRole("textbox", { name: "Your name" }).fill(" mia ");
    await visit.page.keyboard.press("Tab");
    await visit.message("connect", { user: "mia", token: "" });
    await visit.page.getByText("Without a name you are a guest").waitFor({ state: "detached" });
    await visit.forget();
    await visit.page.reload();
    assert.equal((await visit.message("start")).user, "mia");
  }));

test("PageWorksWhereTheBrowserKeepsNothing", () =>
  bench.visit(async (visit) => {
    await visit.page.addInitScript(() => {
      for (const name of ["localStorage", "sessionStorage"])
        Object.defineProperty(window, name, {
          get() {
            throw new DOMException("blocked", "SecurityError");
          },
        });
    });
    await visit.page.reload();
    await visit.page.getByText("connected to lab:7443").waitFor();
    await visit.page.getByRole("textbox", { name: "Your name" }).fill("mia");
    await visit.page.keyboard.press("Tab");
    await visit.message("connect", { user: "mia" });
    await visit.page.getByRole("button", { name: "View", exact: true }).click();
    await visit.page.getByRole("menuitem", { name: "Light" }).click();
    await visit.page.waitForFunction(() => document.documentElement.dataset.theme === "light");
    await visit.openSession();
    await visit.page.getByRole("region", { name: "Camera" }).getByRole("button", { name: "Camera" }).click();
    await visit.order({ post: { kind: "keep", key: "view", text: "x" } });
    await visit.page.getByText("the browser keeps no more for this page").waitFor();
  }));

test("LongWorkShowsProgressAndCanBeCancelled", () =>
  bench.visit(async (visit) => {
    const work = { number: 7, title: "import vase.ply", phase: "uploading", fraction: 0.4, secondsLeft: 12, makesFile: false };
    await visit.change({ activities: [work] });
    const bar = visit.page.getByRole("progressbar", { name: "import vase.ply" });
    await bar.waitFor();
    assert.equal(await bar.evaluate((one: HTMLProgressElement) => one.value), 0.4);
    await visit.page.getByText("uploading, 12 s left").waitFor();
    await visit.page.getByRole("button", { name: "Cancel import vase.ply" }).click();
    await visit.sent("activity cancel 7");
  }));

test("RefusedUserIsAskedForATokenThatStaysInTheTab", () =>
  bench.visit(async (visit) => {
    const refused = { ...library, state: "failed" as const, problem: "the token is not known", wantsToken: true };
    await visit.change({ library: refused });
    await visit.page.getByText("the token is not known").waitFor();
    await visit.page.getByRole("textbox", { name: "User" }).fill("mia");
    await visit.page.getByLabel("Token").fill("s3cret");
    await visit.page.getByRole("button", { name: "Connect" }).click();
    await visit.message("connect", { user: "mia", token: "s3cret" });
    const kept = await visit.page.evaluate(() => [sessionStorage.length, JSON.stringify(localStorage)]);
    assert.equal(kept[0], 2);
    assert.ok(!String(kept[1]).includes("s3cret"));
  }));

test("MessagesAreToastsThatCanBeDismissed", () =>
  bench.visit(async (visit) => {
    await visit.change({ messages: [{ number: 3, severity: "warning", text: "a band is missing", time: 1 }] });
    await visit.page.getByRole("button", { name: "Dismiss: a band is missing" }).click();
    await visit.sent("message dismiss 3");
  }));

test("MessageLeavesByItselfAndStaysInTheList", () =>
  bench.visit(async (visit) => {
    await visit.change({ messages: [{ number: 3, severity: "info", text: "a band is missing", time: 1 }] });
    const toast = visit.page.getByRole("log").getByText("a band is missing");
    await toast.waitFor();
    await visit.page.evaluate(() => document.getAnimations().forEach((one) => one.finish()));
    await toast.waitFor({ state: "detached" });
    await visit.page.keyboard.press("l");
    await visit.page.getByRole("dialog", { name: "Messages" }).getByText("a band is missing").waitFor();
  }));

test("NamesInTheListsHaveRoom", () =>
  bench.visit(
    async (visit) => {
      const name = "dragon_poisson_d10_open";
      await visit.change({ library: { ...library, scans: [{ ...library.scans[0]!, name }] } });
      const button = visit.page.getByRole("button", { name: `Open ${name}` });
      await button.waitFor();
      const height = await button.evaluate((one) => {
        const range = document.createRange();
        range.selectNodeContents(one);
        return new Set([...range.getClientRects()].map((line) => line.top)).size;
      });
      assert.equal(height, 1, "the name takes one line");
    },
    { viewport: { width: 1366, height: 768 } },
  ));

test("StoppedEngineStartsAgainWithANewCanvas", () =>
  bench.visit(async (visit) => {
    await visit.forget();
    await visit.order({ post: { kind: "stopped", message: "unreachable executed" } });
    await visit.page.getByRole("dialog", { name: "The engine has stopped" }).getByText("unreachable executed").waitFor();
    await visit.page.getByRole("button", { name: "Start again" }).click();
    assert.equal((await visit.message("start")).hasCanvas, true);
    await visit.page.getByText("connected to lab:7443").waitFor();
  }));
