import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Bench, type Visit } from "./harness";
import { library, session } from "./sample";

const bench = new Bench();
before(() => bench.start());
after(() => bench.stop());

test("MousePaintsInPixelsOfThePicture", () =>
  bench.visitSession(
    async (visit) => {
      const canvas = visit.page.getByRole("img", { name: "Picture of tablet" });
      const box = (await canvas.boundingBox())!;
      await visit.page.mouse.move(box.x + 40, box.y + 30);
      await visit.page.keyboard.down("Shift");
      await visit.page.mouse.down();
      await visit.page.mouse.move(box.x + 60, box.y + 30);
      await visit.page.mouse.up();
      await visit.page.keyboard.up("Shift");
      await visit.page.mouse.wheel(0, -200);
      const press = await visit.message("pointer", { what: "press" });
      assert.deepEqual([press.x, press.y, press.button, press.modifiers, press.pen], [80, 60, 0, 1, false]);
      await visit.message("pointer", { what: "move", x: 120 });
      await visit.message("pointer", { what: "release" });
      const wheel = await visit.message("pointer", { what: "wheel" });
      assert.ok(Number(wheel.delta) > 0, "away from the user comes nearer");
      const resize = await visit.message("resize", { width: Math.round(box.width * 2) });
      assert.equal(resize.pixelRatio, 2);
    },
    { deviceScaleFactor: 2 },
  ));

test("PictureHasThePixelsOfTheScreenThatLieBetweenItsEdges", () =>
  bench.visitSession(
    async (visit) => {
      const box = (await visit.page.getByRole("img", { name: "Picture of tablet" }).boundingBox())!;
      const pixel = (at: number) => Math.round(at * 1.25);
      const width = pixel(box.x + box.width) - pixel(box.x);
      assert.notEqual(width, pixel(box.width), "its edges lie between pixels");
      await visit.message("resize", { width, height: pixel(box.y + box.height) - pixel(box.y) });
    },
    { deviceScaleFactor: 1.25, viewport: { width: 1024, height: 700 } },
  ));

test("TwoFingersTurnAndPinchButDoNotPaint", () =>
  bench.visitSession(async (visit) => {
    const box = (await visit.page.getByRole("img", { name: "Picture of tablet" }).boundingBox())!;
    const touch = await visit.page.context().newCDPSession(visit.page);
    const at = (...xs: number[]) => xs.map((x, id) => ({ x: box.x + x, y: box.y + 100, id }));
    const send = (type: "touchStart" | "touchMove" | "touchEnd", ...xs: number[]) =>
      touch.send("Input.dispatchTouchEvent", { type, touchPoints: at(...xs) });
    await send("touchStart", 100);
    await send("touchStart", 100, 200);
    await visit.message("pointer", { what: "press", button: 1, x: 150 });
    await visit.sent("cancel");
    await send("touchMove", 100, 300);
    const pinch = await visit.message("pointer", { what: "pinch" });
    assert.equal(pinch.delta, 2);
    await send("touchEnd");
    await visit.message("pointer", { what: "release", button: 1 });
  }, { hasTouch: true }));

test("PenTellsItsPressure", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("img", { name: "Picture of tablet" }).evaluate((canvas) => {
      const event = { pointerId: 1, pointerType: "pen", pressure: 0.25, clientX: 500, clientY: 300, bubbles: true };
      canvas.setPointerCapture = () => {};
      canvas.dispatchEvent(new PointerEvent("pointerdown", event));
    });
    const press = await visit.message("pointer", { what: "press" });
    assert.deepEqual([press.pen, press.pressure], [true, 0.25]);
  }));

test("KeysAreThoseOfTheWindow", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("img", { name: "Picture of tablet" }).focus();
    const keys: [string, string][] = [
      ["Control+z", "undo"],
      ["Control+Shift+Z", "redo"],
      ["w", "wireframe on"],
      ["s", "split on"],
      ["n", "tool look"],
      ["m", "tool measure"],
      ["1", "view front"],
      ["Shift+Digit7", "view bottom"],
      ["5", "orthographic on"],
      ["Home", "frame"],
      ["b", "bookmark add"],
      ["f", "brush_drag radius"],
      ["Shift+F", "brush_drag strength"],
      ["]", "brush 4.6 0.5 0 smooth beta"],
      ["Escape", "cancel"],
    ];
    for (const [key, line] of keys) {
      await visit.page.keyboard.press(key);
      await visit.sent(line);
    }
    await visit.page.keyboard.down("Space");
    await visit.sent("original on");
    await visit.page.keyboard.up("Space");
    await visit.sent("original off");
  }));

test("ArrowsTurnTheViewInThePictureAlone", () =>
  bench.visitSession(async (visit) => {
    const picture = visit.page.getByRole("img", { name: "Picture of tablet" });
    const arrows: [string, string][] = [
      ["ArrowLeft", "turn -15 0"],
      ["ArrowRight", "turn 15 0"],
      ["ArrowUp", "turn 0 15"],
      ["ArrowDown", "turn 0 -15"],
    ];
    for (const [key, line] of arrows) {
      await picture.press(key);
      await visit.sent(line);
    }
    await visit.forget();
    await visit.page.getByRole("list", { name: "Entries" }).press("ArrowDown");
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("ArrowRight");
    await visit.sentSome("beta ");
    assert.ok(!(await visit.lines()).some((line) => line.startsWith("turn")));
  }));

test("ASessionGivesTheKeysToThePictureAndHasAHeading", () =>
  bench.visit(async (visit) => {
    await visit.openSession();
    await visit.page.waitForFunction(() => document.activeElement?.classList.contains("picture"));
    await visit.page.getByRole("main").getByRole("heading", { level: 1, name: "tablet · inscription" }).waitFor();
  }));

test("AClickOfTheRightButtonOpensTheMenuOfThePoint", () =>
  bench.visitSession(async (visit) => {
    const menu = visit.page.getByRole("menu", { name: "Picture" });
    const open = async (position: string) => {
      await menu.waitFor({ state: "detached" });
      await visit.document({ over: { lasso: [], ruler: [], rulerLength: "", menu: { place: [90, 60], position } } });
      await menu.waitFor();
    };
    await open("1.5 -2 0.25");
    assert.match(await menu.getByRole("menuitem", { name: "Undo" }).innerText(), /Undo: Smooth stroke/);
    await visit.forget();
    await menu.getByRole("menuitem", { name: "Look at this point" }).click();
    await visit.sent("menu close");
    assert.deepEqual(await visit.lines(), ["focus", "menu close"]);
    await open("");
    assert.ok(await menu.getByRole("menuitem", { name: "Look at this point" }).isDisabled());
    assert.ok(await menu.getByRole("menuitem", { name: "Copy position" }).isDisabled());
    await visit.page.keyboard.press("ArrowDown");
    await visit.page.keyboard.press("Enter");
    await visit.sent("view front");
    await open("1 2 3");
    await visit.forget();
    await visit.page.keyboard.press("Escape");
    await visit.sent("menu close");
  }));

test("ThePositionIsCopiedWithoutTheClipboardOfASecurePage", () =>
  bench.visitSession(async (visit) => {
    await visit.page.evaluate(() => Object.defineProperty(navigator, "clipboard", { value: undefined }));
    await visit.document({
      over: { lasso: [], ruler: [], rulerLength: "", menu: { place: [90, 60], position: "1.5 -2 0.25" } },
    });
    await visit.page.getByRole("menuitem", { name: "Copy position" }).click();
    await visit.page.getByText("copied 1.5 -2 0.25").waitFor();
  }));

test("AboutSaysVersionLicenceAndWhereTheManualIs", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("button", { name: "Help" }).click();
    await visit.page.getByRole("menuitem", { name: "About and manual" }).click();
    const dialog = visit.page.getByRole("dialog", { name: "About Burnish" });
    await dialog.getByText("Burnish 0.1.0").waitFor();
    await dialog.getByText("MIT License").waitFor();
    await dialog.getByText("docs/window.md").waitFor();
    await visit.page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
  }));

test("LettersInANameFieldAreNoKeys", () =>
  bench.visitSession(async (visit) => {
    await visit.forget();
    const name = visit.page.getByRole("textbox", { name: "Name of a checkpoint or fork" });
    await name.pressSequentially("wns?");
    assert.equal(await name.inputValue(), "wns?");
    assert.deepEqual(await visit.lines(), []);
  }));

test("HomeMovesASliderAndNotTheCamera", () =>
  bench.visitSession(async (visit) => {
    await visit.forget();
    await visit.page.getByRole("slider", { name: "Gradient scale β", exact: true }).press("Home");
    await visit.sent("beta 0");
    assert.ok(!(await visit.lines()).includes("frame"));
  }));

test("TabReachesEveryPanelFromTheMenus", () =>
  bench.visitSession(async (visit) => {
    const reached = new Set<string>();
    for (let i = 0; i < 110; ++i) {
      await visit.page.keyboard.press("Tab");
      const section = await visit.page.evaluate(() => {
        const at = document.activeElement;
        return at?.closest("section")?.getAttribute("aria-label") ?? at?.tagName ?? "";
      });
      reached.add(section);
    }
    for (const name of ["Filter", "Transfer curve α(κ)", "Brush", "Limits", "Keep edges", "Equaliser", "Palette", "CANVAS", "View", "History", "People", "Numbers", "Light", "Camera"])
      assert.ok(reached.has(name), `Tab does not reach ${name}`);
  }));

test("MenuExportsRecordsReplaysAndCloses", () =>
  bench.visitSession(async (visit) => {
    const choose = async (menu: string, item: string) => {
      await visit.page.getByRole("button", { name: menu, exact: true }).click();
      await visit.page.getByRole("menuitem", { name: item }).click();
    };
    await choose("File", "Export…");
    const dialog = visit.page.getByRole("dialog", { name: "Export" });
    assert.equal(await dialog.getByRole("combobox", { name: "Format" }).inputValue(), "zip", "that of the scan");
    await dialog.getByRole("textbox", { name: "Name of the file" }).fill("my tablet A/B");
    await dialog.getByRole("combobox", { name: "Format" }).selectOption(".obj");
    await dialog.getByRole("button", { name: "Export" }).click();
    await visit.sent("export my-tablet-A-B.obj exact");
    await choose("File", "Record a script");
    await visit.sent("record start");
    await visit.page.getByText("recording", { exact: true }).waitFor();
    const chooser = visit.page.waitForEvent("filechooser");
    await choose("File", "Replay a script…");
    await (await chooser).setFiles({ name: "a.burnish", mimeType: "", buffer: Buffer.from("undo\n") });
    await visit.message("replay", { name: "a.burnish" });
    await choose("File", "Open again at depth…");
    await visit.page.getByRole("button", { name: "Depth 7: details from 1.2 mm" }).click();
    await visit.sent("depth 7");
    await choose("File", "Close session");
    await visit.sent("close");
    await visit.page.getByRole("heading", { name: "Recent" }).waitFor();
  }));

test("DepthsAreOfferedInADialog", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("button", { name: "File", exact: true }).click();
    await visit.page.getByRole("menuitem", { name: "Open again at depth…" }).click();
    const dialog = visit.page.getByRole("dialog", { name: "Open again at depth" });
    assert.ok(await dialog.getByRole("button", { name: "Depth 8: details from 0.6 mm" }).isDisabled(), "it is open");
    assert.ok(await dialog.getByRole("button", { name: "Depth 9: needs 14 GB more" }).isDisabled());
    await dialog.getByRole("button", { name: "Cancel" }).click();
    await dialog.waitFor({ state: "detached" });
  }));

test("PanelsGiveTheirRoomToThePictureOfATablet", () =>
  bench.visitSession(
    async (visit) => {
      const picture = visit.page.getByRole("img", { name: "Picture of tablet" });
      const before = (await picture.boundingBox())!.width;
      const panels = visit.page.getByRole("button", { name: "Panels" });
      await panels.click();
      await visit.page.getByRole("region", { name: "Filter" }).waitFor({ state: "detached" });
      const width = (await picture.boundingBox())!.width;
      assert.equal(width, 768);
      await visit.message("resize", { width });
      await panels.click();
      await visit.page.getByRole("region", { name: "Filter" }).waitFor();
      assert.equal((await picture.boundingBox())!.width, before);
    },
    { viewport: { width: 768, height: 1024 } },
  ));

test("NumbersOfThreeDigitsFitTheirFields", () =>
  bench.visitSession(async (visit) => {
    const cut = await visit.page.evaluate(() => {
      const fields = [...document.querySelectorAll<HTMLInputElement>(".slider > .number")];
      fields[0]!.value = "0.00469";
      return fields[0]!.scrollWidth - fields[0]!.clientWidth;
    });
    assert.equal(cut, 0);
  }));

test("CtrlSSaysWhetherAllIsSaved", () =>
  bench.visitSession(async (visit) => {
    await visit.page.keyboard.press("Control+s");
    await visit.page.getByText("all edits are saved").waitFor();
    await visit.document({ unsavedEdits: 2 });
    await visit.document({ session: "with edits" });
    await visit.page.waitForFunction(() => document.title.startsWith("with edits"));
    await visit.page.keyboard.press("Control+s");
    await visit.page.getByText("2 edits are not saved yet").waitFor();
  }));

/** Returns whether the browser would ask before it closes the page. */
const asksBeforeItLeaves = (visit: Visit) =>
  visit.page.evaluate(() => {
    const event = new Event("beforeunload", { cancelable: true });
    window.dispatchEvent(event);
    return event.defaultPrevented;
  });

test("BrowserAsksBeforeItLeavesEditsThatWait", () =>
  bench.visitSession(async (visit) => {
    assert.equal(await asksBeforeItLeaves(visit), false);
    await visit.document({ link: "lost", unsavedEdits: 2 });
    await visit.page.getByText("2 edits wait for the server.").waitFor();
    assert.equal(await asksBeforeItLeaves(visit), true);
  }));

test("BrowserAsksBeforeItLeavesAnExport", () =>
  bench.visitSession(async (visit) => {
    const work = { number: 1, title: "Exporting a.ply", phase: "writing", fraction: 0.4, secondsLeft: -1 };
    await visit.change({ activities: [{ ...work, makesFile: false }] });
    await visit.page.getByRole("progressbar", { name: "Exporting a.ply" }).waitFor();
    assert.equal(await asksBeforeItLeaves(visit), false);
    await visit.change({ activities: [{ ...work, title: "Exporting b.ply", makesFile: true }] });
    await visit.page.getByRole("progressbar", { name: "Exporting b.ply" }).waitFor();
    assert.equal(await asksBeforeItLeaves(visit), true);
  }));

test("SessionIsClosedOverEditsThatWaitOnlyAfterAQuestion", () =>
  bench.visitSession(async (visit) => {
    const close = async () => {
      await visit.page.getByRole("button", { name: "File", exact: true }).click();
      await visit.page.getByRole("menuitem", { name: "Close session" }).click();
    };
    await visit.document({ link: "lost", unsavedEdits: 2 });
    await visit.page.getByRole("alert").getByText("2 edits wait for the server.").waitFor();
    await close();
    const question = visit.page.getByRole("dialog", { name: "Edits are not saved yet" });
    await question.getByText("2 edits wait for the server.").waitFor();
    await question.getByRole("button", { name: "Stay" }).click();
    await question.waitFor({ state: "detached" });
    assert.ok(!(await visit.lines()).includes("close"));
    await close();
    await question.getByRole("button", { name: "Discard and close" }).click();
    await visit.sent("close");
  }));

test("AddressNamesTheSession", () =>
  bench.visitSession(async (visit) => {
    await visit.page.waitForURL(/#session=s1$/);
    await visit.forget();
    await visit.page.reload();
    await visit.sent("session join s1");
    await visit.page.getByRole("region", { name: "Filter" }).waitFor();
    await visit.page.goBack();
    await visit.page.getByRole("heading", { name: "Recent" }).waitFor();
    assert.ok((await visit.lines()).includes("close"));
    await visit.page.goForward();
    await visit.page.getByRole("region", { name: "Filter" }).waitFor();
    assert.equal(new URL(visit.page.url()).hash, "#session=s1");
  }));

test("BackStaysWhileEditsWait", () =>
  bench.visitSession(async (visit) => {
    await visit.document({ link: "lost", unsavedEdits: 1 });
    await visit.page.getByText("1 edit waits for the server.").waitFor();
    await visit.page.goBack();
    await visit.page.getByText("the session stays open").waitFor();
    await visit.page.waitForURL(/#session=s1$/);
    assert.ok(!(await visit.lines()).includes("close"));
  }));

test("AddressOfASessionThatIsGoneLeadsToTheStartPage", () =>
  bench.visit(async (visit) => {
    await visit.page.goto(visit.page.url() + "#session=gone");
    await visit.page.reload();
    await visit.page.getByText("the server has no such session any more").waitFor();
    await visit.page.getByRole("button", { name: "Join inscription" }).waitFor();
  }));

/** Lets the engine lose its context, and returns how the next one is started. */
async function lose(visit: Visit) {
  await visit.forget();
  await visit.order({ post: { kind: "lost" } });
  return visit.message("start");
}

test("EngineThatLostItsContextIsReplacedWithinTheSession", () =>
  bench.visitSession(async (visit) => {
    await visit.page.evaluate(() => {
      const left = () => !document.querySelector(".session") && window.seen.push({ kind: "left" });
      new MutationObserver(left).observe(document.body, { childList: true, subtree: true, attributes: true });
    });
    const start = await lose(visit);
    assert.equal(start.hasCanvas, true);
    await visit.sent("session join s1");
    await visit.page.getByRole("region", { name: "Filter" }).waitFor();
    await visit.page.getByRole("checkbox", { name: "Wireframe" }).click();
    await visit.sent("panel commit on View/Wireframe");
    assert.deepEqual((await visit.seen()).filter((one) => one.kind === "left"), []);
  }));

test("EngineThatLostItsContextSendsItsEditsFirst", () =>
  bench.visitSession(async (visit) => {
    await visit.document({ unsavedEdits: 2 });
    await visit.forget();
    await visit.order({ post: { kind: "lost" } });
    await visit.document({ unsavedEdits: 1, session: "still there" });
    await visit.page.waitForFunction(() => document.title.startsWith("still there"));
    assert.deepEqual((await visit.seen()).filter((one) => one.kind === "start"), []);
    await visit.document({ unsavedEdits: 0 });
    await visit.message("start");
  }));

test("NextEngineOpensTheSessionWhenItHasTheList", () =>
  bench.visitSession(async (visit) => {
    await visit.order({ post: { kind: "keep", key: "list", text: "late" } });
    await visit.page.waitForFunction(() => localStorage.getItem("burnish.kept.list") === "late");
    await lose(visit);
    await visit.change({ recording: false });
    assert.deepEqual(await visit.lines(), []);
    await visit.change({ library });
    await visit.sent("session join s1");
  }));

test("EngineThatLosesContextsAgainAndAgainIsReplacedByOneWithoutACard", () =>
  bench.visitSession(async (visit) => {
    for (let i = 0; i < 3; ++i) assert.equal((await lose(visit)).pictures, "best");
    assert.equal((await lose(visit)).pictures, "processor");
    assert.equal(await visit.page.getByRole("dialog").count(), 0);
  }));

test("EngineThatFindsNoCardIsReplacedByOneOfTheProcessor", () =>
  bench.visitSession(async (visit) => {
    await visit.forget();
    await visit.order({ post: { kind: "noCard" } });
    assert.equal((await visit.message("start")).pictures, "processor");
    await visit.sent("session join s1");
  }));

test("AddressOfThePageChoosesWhoDraws", () =>
  bench.visit(async (visit) => {
    for (const [query, pictures] of [["card", "card"], ["processor", "processor"], ["else", "best"]] as const) {
      await visit.page.goto(new URL(`/?pictures=${query}`, visit.page.url()).href);
      assert.equal((await visit.message("start")).pictures, pictures);
    }
  }));

test("KeptTextsAreGivenToTheNextEngine", () =>
  bench.visit(async (visit) => {
    await visit.order({ post: { kind: "keep", key: "view", text: "front" } });
    await visit.page.waitForFunction(() => localStorage.getItem("burnish.kept.view") === "front");
    await visit.page.reload();
    const start = await visit.message("start");
    assert.deepEqual(start.kept, { view: "front" });
    assert.match(String(start.core), /^http:.*\/assets\/core\.wasm$/);
    assert.match(String(start.rasterCore), /^http:.*\/assets\/core_raster\.wasm$/);
  }));

test("DownloadHasItsName", () =>
  bench.visitSession(async (visit) => {
    const download = visit.page.waitForEvent("download");
    await visit.page.evaluate(() =>
      window.orders.postMessage({ post: { kind: "download", name: "tablet.ply", blob: new Blob(["ply"]) } }),
    );
    assert.equal((await download).suggestedFilename(), "tablet.ply");
  }));

test("ScanIsSeenBeforeItsSessionIsOpen", () =>
  bench.visitSession(async (visit) => {
    const picture = visit.page.getByRole("img", { name: "Picture of skull" });
    await visit.change({ document: null, opening: "skull" });
    await picture.waitFor();
    await visit.page.getByText("The session is being opened.").waitFor();
    assert.equal(await visit.page.getByRole("button", { name: "Open a scan…" }).count(), 0);
    assert.equal(await visit.page.getByRole("slider").count(), 0);
    const before = (await picture.boundingBox())!;
    await visit.page.mouse.move(before.x + 40, before.y + 30);
    await visit.page.mouse.down();
    await visit.message("pointer", { what: "press" });
    await visit.page.mouse.up();
    await visit.change({ document: { ...session, scan: "skull" }, opening: "" });
    await visit.page.getByRole("slider").first().waitFor();
    assert.deepEqual(await picture.boundingBox(), before, "the picture stays in its place");
    await visit.change({ document: null });
    await visit.page.getByRole("button", { name: "Open a scan…" }).waitFor();
  }));

test("LostConnectionIsSaidAndGoesAway", () =>
  bench.visitSession(async (visit) => {
    await visit.document({ link: "lost", linkReason: "the socket closed", unsavedEdits: 2 });
    await visit.page.getByRole("alert").getByText("2 edits wait for the server.").waitFor();
    await visit.document({ link: "live", linkReason: "", unsavedEdits: 0 });
    await visit.page.getByRole("alert").waitFor({ state: "detached" });
  }));

test("NoteOfALostConnectionLetsStrokesThrough", () =>
  bench.visitSession(async (visit) => {
    await visit.document({ link: "lost", linkReason: "the socket closed" });
    const box = (await visit.page.getByRole("alert").boundingBox())!;
    await visit.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await visit.page.mouse.down();
    await visit.message("pointer", { what: "press" });
    await visit.page.mouse.up();
  }));

test("RefusedCommandIsSaidInTheCoresWords", () =>
  bench.visitSession(async (visit) => {
    await visit.order({ post: { kind: "answer", line: "beta 11", message: "beta 11 is outside 0 to 10" } });
    await visit.page.getByText("beta 11 is outside 0 to 10").waitFor();
  }));

test("HelpListsTheKeys", () =>
  bench.visitSession(async (visit) => {
    await visit.page.keyboard.press("?");
    const dialog = visit.page.getByRole("dialog", { name: "Keys" });
    await dialog.getByText("Undo your last edit").waitFor();
    await visit.page.keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
  }));
