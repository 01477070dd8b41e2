import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Locator } from "playwright-core";
import { Bench, type Visit } from "./harness";
import { guides, session, snapshot } from "./sample";

const bench = new Bench();
before(() => bench.start());
after(() => bench.stop());

const slider = (visit: Visit, name: string) => visit.page.getByRole("slider", { name, exact: true });

test("FilterPreviewsWhileTheSliderMovesAndCommitsAtItsEnd", () =>
  bench.visitSession(async (visit) => {
    await slider(visit, "Gradient scale β").focus();
    await visit.page.keyboard.press("ArrowRight");
    await visit.sentSome("beta ");
    const [first, second] = (await visit.lines()).filter((line) => / ?beta /.test(line)).slice(-2);
    assert.match(first!, /^preview beta 1/);
    assert.equal(second, first!.replace("preview ", ""));
    await visit.page.getByRole("textbox", { name: "Gradient scale β as a number" }).fill("2.5");
    await visit.page.keyboard.press("Enter");
    await visit.sent("beta 2.5");
  }));

/** Types and presses a key within one turn of the page's thread, as a slow machine gives it both. */
const typeAtOnce = (field: Locator, text: string, key: string) =>
  field.evaluate(
    (input: HTMLInputElement, [text, key]) => {
      input.focus();
      input.value = text!;
      input.dispatchEvent(new InputEvent("input", { bubbles: true }));
      input.dispatchEvent(new KeyboardEvent("keydown", { key: key!, bubbles: true }));
      input.blur();
    },
    [text, key],
  );

test("NumberTypedWithinOneTurnIsTakenOnce", () =>
  bench.visitSession(async (visit) => {
    const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
    await typeAtOnce(field, "2.5", "Enter");
    await visit.sent("beta 2.5");
    await typeAtOnce(field, "3.5", "Escape");
    await typeAtOnce(field, "4.5", "Enter");
    await visit.sent("beta 4.5");
    assert.deepEqual(
      (await visit.lines()).filter((line) => line.startsWith("beta ")),
      ["beta 2.5", "beta 4.5"],
    );
  }));

test("NumberReplacesAValueThatComesAfterTheClickIntoItsField", () =>
  bench.visitSession(async (visit) => {
    const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
    await field.click();
    await visit.document({ beta: 0.7 });
    await visit.page.waitForFunction(() => (window.document.activeElement as HTMLInputElement).value === "0.7");
    await visit.page.keyboard.insertText("0.8");
    await visit.page.keyboard.press("Enter");
    await visit.sent("beta 0.8");
  }));

test("NumberAfterNumberIsTakenWithoutANewClick", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("textbox", { name: "Gradient scale β as a number" }).click();
    for (const number of ["2.5", "3.5"]) {
      await visit.page.keyboard.type(number);
      await visit.page.keyboard.press("Enter");
      await visit.sent(`beta ${number}`);
    }
  }));

test("NumberThatIsShownBeforeTheAnswerIsTaken", () =>
  bench.visitSession(async (visit) => {
    const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
    const shown = await field.inputValue();
    await field.evaluate((input: HTMLInputElement, shown) => {
      input.focus();
      for (const text of ["2.5", shown]) {
        input.value = text;
        input.dispatchEvent(new InputEvent("input", { bubbles: true }));
        input.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
      }
    }, shown);
    await visit.sent("beta 2.5");
    await visit.sent(`beta ${shown}`);
  }));

test("NumberThatIsShownIsNoEdit", () =>
  bench.visitSession(async (visit) => {
    const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
    await field.fill(await field.inputValue());
    await field.press("Enter");
    await field.fill("2.5");
    await field.press("Enter");
    await visit.sent("beta 2.5");
    assert.deepEqual(
      (await visit.lines()).filter((line) => line.startsWith("beta ")),
      ["beta 2.5"],
    );
  }));

test("NumberOfAFieldThatGoesAwayIsTaken", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Equaliser");
    const field = panel.getByRole("textbox", { name: "Gain of band 1 as a number" });
    await field.fill("0.5");
    await visit.document({ bands: [] });
    await field.waitFor({ state: "detached" });
    await visit.sent("bands 2:0.5 8:1.5");
  }));

test("NumberBeyondTheLimitBecomesTheLimitWithAMessage", () =>
  bench.visitSession(async (visit) => {
    const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
    await field.fill("11");
    await field.press("Enter");
    await visit.sent("beta 10");
    await visit.page.getByText("11 is outside 0 to 10").waitFor();
    await field.fill("many");
    await field.press("Enter");
    await visit.page.getByText("'many' is not a number").waitFor();
  }));

test("PresetsHaveAStrength", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("combobox", { name: "Presets" }).selectOption("Sharpen all");
    await visit.sent("preset Sharpen all 1");
    await visit.change({ preset: { name: "Sharpen all", strength: 1, word: "all", hasTrial: true } });
    await visit.page.getByText("all of the preset").waitFor();
    await slider(visit, "Strength of the preset").fill("500");
    await visit.sent("preview preset Sharpen all 0.5");
    await visit.sent("preset Sharpen all 0.5");
  }));

/** Pictures of strengths, of which these numbers are there. */
const strengths = (numbers: [number, number, number], trial = "") => ({
  preset: "Sharpen all",
  trial,
  pictures: [0.33, 0.67, 1].map((strength, i) => ({ strength, word: ["a little", "most", "all"][i]!, number: numbers[i]! })),
});

const kAllOfSharpen = { preset: { name: "Sharpen all", strength: 1, word: "all", hasTrial: true } };
const kRedDot =
  "data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==";

test("StrengthIsChosenByItsPicture", () =>
  bench.visitSession(async (visit) => {
    const { page } = visit;
    await visit.change(kAllOfSharpen);
    const button = page.getByRole("button", { name: "Compare strengths" });
    await button.focus();
    await page.keyboard.press("Enter");
    await visit.sent("strengths open");
    for (const number of [1, 2, 3]) await visit.order({ post: { kind: "strength", number, address: kRedDot } });
    await visit.change({ strengths: strengths([0, 2, 3], "trying strength 0.33") });
    const panel = page.getByRole("group", { name: "Pictures of strengths" });
    await page.locator(".over").getByText("trying strength 0.33").waitFor();
    assert.equal(await panel.getByRole("button", { name: "Strength 0.33, a little of the preset" }).getAttribute("aria-busy"), "true");
    await visit.change({ strengths: strengths([1, 2, 3]) });
    await panel.locator("img").nth(2).waitFor();
    const pressed = panel.getByRole("button", { pressed: true });
    assert.equal(await pressed.getAttribute("aria-label"), "Strength 1.00, all of the preset");
    await visit.screenshot("strengths");
    await page.keyboard.press("Tab"); // the button kept the focus
    await page.keyboard.press("Tab");
    await page.keyboard.press("Enter");
    await visit.sent("strengths choose 1");
    await page.getByRole("button", { name: "Close the pictures" }).click();
    await visit.sent("strengths close");
  }));

test("PicturesOfStrengthsEndWithTheirPanel", () =>
  bench.visitSession(async (visit) => {
    await visit.change({ ...kAllOfSharpen, strengths: strengths([0, 0, 0]) });
    const panel = visit.page.getByRole("group", { name: "Pictures of strengths" });
    await panel.waitFor();
    await visit.page.getByRole("button", { name: "Filter", exact: true }).click();
    await visit.sent("strengths close");
    await panel.waitFor({ state: "detached" });
  }));

test("ViewersHaveNoPicturesOfStrengths", () =>
  bench.visitSession(async (visit) => {
    await visit.change(kAllOfSharpen);
    const button = visit.page.getByRole("button", { name: "Compare strengths" });
    await button.waitFor();
    await visit.document({ role: "viewer" });
    await button.waitFor({ state: "detached" });
  }));

test("PresetWhoseStrengthsCannotBeTriedHasNoPicturesOfThem", () =>
  bench.visitSession(async (visit) => {
    await visit.change(kAllOfSharpen);
    const button = visit.page.getByRole("button", { name: "Compare strengths" });
    await button.waitFor();
    await visit.change({ preset: { ...kAllOfSharpen.preset, hasTrial: false } });
    await button.waitFor({ state: "detached" });
    await slider(visit, "Strength of the preset").waitFor();
  }));

test("PresetBoxSaysWhatTheSessionHas", () =>
  bench.visitSession(async (visit) => {
    const box = visit.page.getByRole("combobox", { name: "Presets" });
    await box.selectOption("Sharpen all");
    await visit.change({ preset: { name: "Sharpen all", strength: 1, word: "all", hasTrial: true } });
    await slider(visit, "Strength of the preset").waitFor();
    await visit.change({ preset: null });
    await slider(visit, "Strength of the preset").waitFor({ state: "detached" });
    assert.equal(await box.inputValue(), "");
  }));

test("WavelengthIsSentAsFidelity", () =>
  bench.visitSession(async (visit) => {
    const field = visit.page.getByRole("textbox", { name: "Wavelength as a number" });
    await field.fill("10");
    await field.press("Enter");
    await visit.sent("fidelity 27.0177");
  }));

test("OwnPresetIsKeptChosenAndDeleted", () =>
  bench.visitSession(async (visit) => {
    const panel = visit.page.getByRole("region", { name: "Filter" });
    await panel.getByRole("textbox", { name: "Name for this filter" }).fill("faint lines");
    await panel.getByRole("button", { name: "Keep", exact: true }).click();
    await visit.sent("preset_keep faint lines");
    await visit.change({
      presets: [{ name: "faint lines", description: "Your own", changes: true, own: true }, ...snapshot.presets],
      preset: { name: "faint lines", strength: 1, word: "all", hasTrial: true },
    });
    await panel.getByRole("slider", { name: "Strength of the preset" }).waitFor();
    assert.equal(await panel.getByRole("combobox", { name: "Presets" }).inputValue(), "faint lines");
    await panel.getByRole("button", { name: "Delete faint lines" }).click();
    await visit.sent("preset_delete faint lines");
    await visit.change({ presets: snapshot.presets, preset: null });
    await panel.getByRole("slider", { name: "Strength of the preset" }).waitFor({ state: "detached" });
    assert.equal(await panel.getByRole("combobox", { name: "Presets" }).inputValue(), "");
  }));

test("CurveIsDraggedByMouseAndByKeys", () =>
  bench.visitSession(async (visit) => {
    const plot = visit.page.getByRole("group", { name: "Plot of the transfer curve" });
    const box = (await plot.boundingBox())!;
    await visit.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    await visit.page.mouse.down();
    await visit.page.mouse.move(box.x + box.width / 2, box.y + box.height / 4);
    await visit.page.mouse.up();
    await visit.sent("plot drop");
    const lines = (await visit.lines()).filter((line) => line.startsWith("plot"));
    assert.match(lines[0]!, /^plot grab 0\.5 0\.5 /);
    assert.equal(lines[1], "plot drag 0.5 0.75");
    await visit.forget();
    await slider(visit, "Point 2").press("ArrowUp");
    await visit.sent("plot drop");
    assert.deepEqual(await visit.lines(), ["plot take 1", "plot drag 0.8 0.79", "plot drop"]);
    await slider(visit, "Point 1").press("Delete");
    await visit.sent("plot remove 0");
    await slider(visit, "Point 2").click({ button: "right" });
    await visit.sent("plot remove 1");
  }));

test("BrushHasModesShapeAndMirror", () =>
  bench.visitSession(async (visit) => {
    const panel = visit.page.getByRole("region", { name: "Brush" });
    await panel.getByRole("button", { name: "Smooth", pressed: true }).waitFor();
    await panel.getByRole("button", { name: "Sharpen" }).click();
    await visit.sent("panel commit press Brush/Sharpen");
    await panel.getByRole("combobox", { name: "Paints" }).selectOption("Gain of 2 to 8");
    await visit.sent("panel commit band:2 Brush/Paints");
    await panel.getByRole("combobox", { name: "Fall-off" }).selectOption("Sharp");
    await visit.sent("panel commit sharp Brush/Fall-off");
    await panel.getByRole("textbox", { name: "Radius as a number" }).fill("2");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 2 Brush/Radius");
    await panel.getByRole("checkbox", { name: "Through walls" }).click();
    await visit.sent("panel commit on Brush/Through walls");
    await panel.getByRole("checkbox", { name: "Pen pressure" }).click();
    await visit.sent("panel commit off Brush/Pen pressure");
    await panel.getByRole("combobox", { name: "Mirror" }).selectOption("Across x");
    await visit.sent("panel commit x Brush/Mirror");
    await panel.getByRole("slider", { name: "Mirror plane" }).fill("750");
    await visit.sent("panel commit 25 Brush/Mirror plane");
  }));

test("LimitsHoldRimsMovesAndRegions", () =>
  bench.visitSession(async (visit) => {
    const panel = visit.page.getByRole("region", { name: "Limits" });
    await visit.sent("over protection on");
    await panel.getByText("rims: 3 of 5 stay").waitFor();
    await panel.getByText("Walls: 24 % of the surface").waitFor();
    await panel.getByRole("checkbox", { name: "Rims stay" }).click();
    await visit.sent("panel commit off Limits/Rims stay");
    assert.ok(await panel.getByRole("checkbox", { name: "Volume stays" }).isDisabled());
    await panel.getByText("at the right: any").waitFor();
    await panel.getByRole("textbox", { name: "Largest move as a number" }).fill("0.5");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 0.5 Limits/Largest move");
    await panel.getByRole("button", { name: "Protect", pressed: false }).click();
    await visit.sent("panel commit press Limits/Protect");
    await panel.getByRole("button", { name: "Release", pressed: true }).waitFor();
    assert.equal(await panel.getByRole("status").textContent(), "the protected region is hatched");
    for (const name of ["Grow", "Invert", "Piece", "Clear"]) {
      await panel.getByRole("button", { name }).click();
      await visit.sent(`panel commit press Limits/${name}`);
    }
  }));

test("EdgesAreKeptByAPresetOrByValues", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Keep edges");
    const choice = panel.getByRole("combobox", { name: "Kept edges" });
    assert.equal(await choice.getAttribute("title"), "For reliefs and inscriptions");
    await choice.selectOption("Machined part");
    await visit.sent("panel commit machined Keep edges/Kept edges");
    await panel.getByRole("slider", { name: "Strength of kept edges" }).fill("500");
    await visit.sent("panel preview 0.5 Keep edges/Strength of kept edges");
    await visit.sent("panel commit 0.5 Keep edges/Strength of kept edges");
    await panel.getByRole("textbox", { name: "Noise size as a number" }).fill("2");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 2 Keep edges/Noise size");
    await panel.getByRole("textbox", { name: "Edge angle as a number" }).fill("200");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 120 Keep edges/Edge angle");
    await visit.page.getByText("200 is outside 5 to 120").waitFor();
    await choice.selectOption("Off");
    await visit.sent("panel commit off Keep edges/Kept edges");
  }));

test("APanelFollowsItsWidgets", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Keep edges");
    const choice = panel.getByRole("combobox", { name: "Kept edges" });
    const strength = panel.getByRole("slider", { name: "Strength of kept edges" });
    const widgets = session.panels["Keep edges"]!;
    const show = (shown: object[]) => visit.document({ panels: { "Keep edges": shown } });
    await show([...widgets.map((one) => ({ ...one, disabled: true })), { kind: "text", name: "noise about 0.12 mm" }]);
    await panel.getByText("noise about 0.12 mm").waitFor();
    assert.ok(await choice.isDisabled());
    assert.ok(await strength.isDisabled());
    const own = { value: "", choices: [["off", "Off"], ["", "Own values"]] };
    await show(widgets.map((one) => (one.kind === "choice" ? { ...one, ...own } : one)));
    await choice.getByText("Own values").waitFor({ state: "attached" });
    assert.equal(await choice.inputValue(), "");
    assert.ok(await strength.isEnabled());
  }));

test("EqualiserSendsAllBands", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Equaliser");
    await panel.getByRole("slider", { name: "Gain of band 1" }).fill("0");
    await visit.sent("preview bands 2:0 8:1.5");
    await visit.sent("bands 2:0 8:1.5");
    await panel.getByRole("checkbox", { name: "Sizes" }).click();
    await panel.getByRole("textbox", { name: "Size of band 2 as a number" }).fill("10");
    await visit.page.keyboard.press("Enter");
    await visit.sent("bands 2:1 10:1.5");
    await panel.getByRole("button", { name: "All gains 1" }).click();
    await visit.sent("bands 2:1 8:1");
    await panel.getByRole("button", { name: "Remove bands" }).click();
    await visit.sent("bands");
    await visit.document({ bands: [], keepsEdges: false });
    await panel.getByRole("button", { name: "Make bands" }).click();
    await visit.sent("bands first");
  }));

test("BandsAndAVolumeThatStaysAreNotOfferedBesideKeptEdges", () =>
  bench.visitSession(async (visit) => {
    const bands = await visit.section("Equaliser");
    await visit.document({ bands: [], closed: true });
    await bands.getByText("Keep no edges to make them").waitFor();
    assert.ok(await bands.getByRole("button", { name: "Make bands" }).isDisabled());
    const limits = visit.page.getByRole("region", { name: "Limits" });
    assert.ok(await limits.getByRole("checkbox", { name: "Volume stays" }).isDisabled());
  }));

test("PaletteAddsPaintsAndRemovesCurves", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Palette");
    await visit.sent("over curves on");
    await panel.getByRole("textbox", { name: "Name of the curve" }).fill("gentle relief");
    await panel.getByRole("button", { name: "Add" }).click();
    await visit.sent("palette 50 d9534f soft ; -20:50,20:120 4a7fd0 gentle relief");
    await panel.getByRole("button", { name: "soft", exact: true }).click();
    await visit.sent("panel commit curve:1 Brush/Paints");
    await panel.getByRole("button", { name: "Set soft" }).click();
    await visit.sent("palette -20:50,20:120 d9534f soft");
    await panel.getByRole("button", { name: "Show soft" }).click();
    await visit.sent("curve 50");
    await panel.getByRole("button", { name: "Remove the last curve" }).click();
    await visit.sent("palette");
  }));

test("ColoursAreFilteredAndShown", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Colours");
    await panel.getByRole("button", { name: "Show colours" }).click();
    await visit.sent("panel commit press Colours/Show colours");
    await panel.getByRole("textbox", { name: "Gradient scale of colours as a number" }).fill("0.5");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 0.5 Colours/Gradient scale of colours");
    await panel.getByRole("button", { name: "Keep colours" }).click();
    await visit.sent("panel commit press Colours/Keep colours");
    const gain = panel.getByRole("textbox", { name: "Texture gain as a number" });
    assert.equal(await gain.inputValue(), "1.00");
    await gain.fill("2.5");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 2.5 Colours/Texture gain");
  }));

test("HistorySwitchesRestoresAndForks", () =>
  bench.visitSession(async (visit) => {
    const panel = visit.page.getByRole("region", { name: "History" });
    await panel.getByRole("checkbox", { name: "Entry 4: Smooth stroke" }).click();
    await visit.sent("switch 4 off");
    const first = panel.getByRole("listitem").first();
    assert.match(await first.innerText(), /mia$/, "several people made edits");
    assert.match((await first.getAttribute("title"))!, /^Smooth stroke\nradius 4.69 mm, β 0, 12 points\n/);
    await panel.getByRole("button", { name: "Undo" }).click();
    await visit.sent("undo");
    await panel.getByRole("button", { name: "Restore before carving" }).click();
    await visit.sent("restore before carving");
    const name = panel.getByRole("textbox", { name: "Name of a checkpoint or fork" });
    await name.fill("before carving");
    await panel.getByRole("button", { name: "Checkpoint" }).click();
    await visit.page.getByText("is there already").waitFor();
    await name.fill("nach dem Glätten");
    await panel.getByRole("button", { name: "Checkpoint" }).click();
    await visit.sent("checkpoint nach dem Glätten");
    await name.fill("copy");
    await panel.getByRole("button", { name: "Fork" }).click();
    await visit.sent("fork copy");
  }));

test("UndoSaysWhoseEditsItTakesBack", () =>
  bench.visitSession(async (visit) => {
    const undo = visit.page.getByRole("region", { name: "History" }).getByRole("button", { name: "Undo" });
    assert.match((await undo.getAttribute("title"))!, /others: Smooth stroke.$/);
    await visit.document({ people: [{ connection: 1, user: "", colour: 0xd9534f, role: "owner", me: true }] });
    await visit.page.getByText("guest (you)").waitFor();
    assert.match((await undo.getAttribute("title"))!, /The start page asks for yours.$/);
  }));

test("OwnersChangeRolesAndOthersSeeThem", () =>
  bench.visitSession(async (visit) => {
    await visit.page.getByRole("combobox", { name: "Role of mia" }).selectOption("viewer");
    await visit.sent("role mia viewer");
    await visit.document({ role: "viewer" });
    await visit.page.getByRole("combobox", { name: "Role of mia" }).waitFor({ state: "detached" });
    await visit.page.getByRole("region", { name: "People" }).getByText("editor").waitFor();
    assert.ok(await visit.page.getByRole("button", { name: "Undo" }).isDisabled());
    assert.ok(await slider(visit, "Gradient scale β").isDisabled());
  }));

test("ViewHasColoursSplitAndBookmarks", () =>
  bench.visitSession(async (visit) => {
    const panel = visit.page.getByRole("region", { name: "View", exact: true });
    await panel.getByRole("combobox", { name: "Colour" }).selectOption("Displacement");
    await visit.sent("panel commit displacement View/Colour");
    for (const [name, value] of [["Flat", "on"], ["Wireframe", "on"]] as const) {
      await panel.getByRole("checkbox", { name }).click();
      await visit.sent(`panel commit ${value} View/${name}`);
    }
    await panel.getByRole("checkbox", { name: "Flat", checked: true }).waitFor();
    await panel.getByRole("slider", { name: "Place of the split" }).fill("250");
    await visit.sent("panel preview 0.275 View/Place of the split");
    await panel.getByRole("button", { name: "Frame all" }).click();
    await visit.sent("panel commit press View/Frame all");
    await panel.getByRole("button", { name: "Bookmark 2" }).click();
    await visit.sent("panel commit press View/Bookmark 2");
    const camera = await visit.section("Camera");
    await camera.getByRole("combobox", { name: "Up" }).selectOption("-z");
    await visit.sent("panel commit -z Camera/Up");
    await camera.getByRole("button", { name: "Bottom" }).click();
    await visit.sent("panel commit press Camera/Bottom");
    await camera.getByRole("checkbox", { name: "Orthographic" }).click();
    await visit.sent("panel commit on Camera/Orthographic");
  }));

test("KeysOfOnesOwnStayAndTakeNoOther", () =>
  bench.visitSession(async (visit) => {
    const { keyboard } = visit.page;
    const dialog = visit.page.getByRole("dialog", { name: "Keys" });
    const key = (keys: string) => dialog.getByRole("button", { name: `Change ${keys}: Show the triangles' edges` });
    await keyboard.press("?");
    await key("W").click();
    await keyboard.press("s");
    await dialog.getByText("S is taken: Original on the left, edited on the right").waitFor();
    await key("W").click();
    await keyboard.press("Escape"); // changes nothing, and the dialog stays
    await key("W").press("Enter");
    await keyboard.press("Shift+G");
    await key("Shift+G").waitFor();
    await visit.screenshot("keys");
    await keyboard.press("Escape");
    await dialog.waitFor({ state: "detached" });
    await visit.page.reload();
    await visit.page.getByRole("region", { name: "Camera", exact: true }).waitFor();
    await visit.forget();
    await keyboard.press("w");
    await keyboard.press("Shift+G");
    await visit.sent("wireframe on");
    assert.equal((await visit.lines()).filter((line) => line === "wireframe on").length, 1);
    await visit.page.getByRole("button", { name: "View", exact: true }).first().click();
    await visit.page.getByRole("menuitemcheckbox", { name: /Wireframe/ }).getByText("Shift+G").waitFor();
    await keyboard.press("Escape");
    await keyboard.press("?");
    await dialog.getByRole("button", { name: "Default keys" }).click();
    await key("W").waitFor();
  }));

test("SimplifiedPictureIsSaidOverIt", () =>
  bench.visitSession(async (visit) => {
    const over = visit.page.getByRole("group", { name: "Figures over the picture" });
    const show = (status: string) => visit.document({ view: { ...session.view, status } });
    await show("40 % of 2.25 M triangles: loading, 1.3 MB left");
    await over.getByText("simplified, 40 %").waitFor();
    for (const status of ["100 % of 20000 triangles: moving", "full detail"]) {
      await show(status);
      await over.getByText("simplified").waitFor({ state: "detached" });
    }
  }));

test("SplitLineOverThePictureMovesByPointerAndKeys", () =>
  bench.visitSession(async (visit) => {
    const line = visit.page.getByRole("separator", { name: "Line between original and edited" });
    assert.equal(await line.count(), 0);
    await visit.document({ view: { ...session.view, split: true, splitAt: 0.5 } });
    await line.press("ArrowRight");
    await visit.sent("split_at 0.51");
    await line.press("Home");
    await visit.sent("split_at 0.05");
    const box = (await line.boundingBox())!;
    const picture = (await visit.page.getByRole("img", { name: /^Picture of/ }).boundingBox())!;
    await visit.forget();
    await visit.page.mouse.move(box.x + box.width / 2, box.y + 100);
    await visit.page.mouse.down();
    await visit.page.mouse.move(picture.x + 0.25 * picture.width, box.y + 120);
    await visit.page.mouse.up();
    await visit.sent("split_at 0.25");
    await line.press("ArrowRight"); // the snapshot still has 0.5
    await visit.sent("split_at 0.26");
    await visit.document({ view: { ...session.view, split: true, splitAt: 0.26 } });
    await visit.document({ view: { ...session.view, split: true, splitAt: 0.7 } });
    await visit.page.locator(".split-line[aria-valuenow='70']").waitFor();
    await line.press("PageUp");
    await visit.sent("split_at 0.8");
    assert.ok((await visit.seen()).every((one) => one.kind !== "pointer" || one.what !== "press"));
    assert.match(await visit.page.locator(".split-line").innerText(), /original\s+edited/);
    await visit.document({ view: { ...session.view, split: true, original: true } });
    await line.waitFor({ state: "detached" });
    await visit.page.getByText("original", { exact: true }).waitFor();
  }));

test("LassoAndRulerLieOverThePicture", () =>
  bench.visitSession(async (visit) => {
    await visit.document({ over: { lasso: [10, 10, 60, 12, 30, 50], ruler: [100, 90, 140, 90], rulerLength: "12.1 mm" } });
    await visit.page.getByRole("img", { name: "Ruler: 12.1 mm" }).waitFor();
    assert.equal(await visit.page.locator("polygon.lasso").getAttribute("points"), "10 10 60 12 30 50");
  }));

test("LassoIsDrawnByKeys", () =>
  bench.visitSession(async (visit) => {
    await visit.document({ lasso: "protect" });
    const pen = visit.page.getByRole("button", { name: "Pen of the lasso" });
    await pen.press("Enter");
    await pen.press("Shift+ArrowRight");
    await pen.press("ArrowDown");
    await pen.press("Enter");
    await visit.message("pointer", { what: "release" });
    const points = (await visit.seen()).filter((one) => one.kind === "pointer");
    assert.deepEqual(
      points.map((one) => one.what),
      ["move", "press", "move", "move", "move", "release"],
    );
    const at = (number: number) => points[number] as unknown as { x: number; y: number };
    assert.ok(at(5).x > at(1).x && at(5).y > at(1).y && at(5).x - at(1).x > at(5).y - at(1).y);
    await visit.document({ lasso: "off" });
    await pen.waitFor({ state: "detached" });
    const focused = await visit.page.evaluate(() => document.activeElement?.className);
    assert.equal(focused, "picture");
  }));

test("LightHasALampOnABall", () =>
  bench.visitSession(async (visit) => {
    const panel = await visit.section("Light");
    await panel.getByRole("combobox", { name: "Light" }).selectOption("Raking light");
    await visit.sent("panel commit raking Light/Light");
    const lamp = panel.getByRole("slider", { name: "Lamp" });
    await lamp.press("ArrowUp");
    await visit.sent("light_direction 137 30");
    await lamp.click();
    await visit.sentSome("lamp ");
    await panel.getByRole("textbox", { name: "Occlusion as a number" }).fill("0.5");
    await visit.page.keyboard.press("Enter");
    await visit.sent("panel commit 0.5 Light/Occlusion");
    await panel.getByRole("button", { name: "As at first" }).click();
    await visit.sent("panel commit press Light/As at first");
  }));

test("FiguresOfASurfaceBeforeAreGrey", () =>
  bench.visitSession(async (visit) => {
    const { numbers } = session;
    await (await visit.section("Numbers")).getByText("largest move").waitFor();
    assert.equal(await visit.page.locator(".stale").count(), 0);
    await visit.document({ numbers: { ...numbers, current: false } });
    await visit.page.locator(".stale").getByText("largest move").waitFor();
  }));

test("ScaleBarAndAxesAreDrawnAsTheEngineSays", () =>
  bench.visitSession(async (visit) => {
    const bar = visit.page.getByRole("img", { name: "Scale bar: 20 mm" });
    const axes = visit.page.getByRole("img", { name: "Axes of the scan" });
    await visit.order({ post: { kind: "guides", ...guides } });
    await bar.waitFor();
    assert.equal((await bar.locator(".length").boundingBox())!.width, 120);
    assert.deepEqual(await axes.locator("text").allTextContents(), ["-y", "x", "y", "z"]);
    await visit.screenshot("guides");
    await visit.document({ scale: null });
    const low = (await bar.boundingBox())!.y;
    await visit.document({ scale: session.scale });
    await visit.page.getByRole("img", { name: /^Scale of colours/ }).waitFor();
    const scale = (await visit.page.getByRole("img", { name: /^Scale of colours/ }).boundingBox())!;
    const { y, height } = (await bar.boundingBox())!;
    assert.ok(y < low && y + height <= scale.y, "the scale of colours covers the bar");
    await visit.order({ post: { kind: "guides", bar: null, axes: null } });
    await bar.waitFor({ state: "detached" });
    await axes.waitFor({ state: "detached" });
  }));

test("NumbersNameTheUnitAndMeasure", () =>
  bench.visitSession(async (visit) => {
    const panel = visit.page.getByRole("region", { name: "Numbers" });
    await panel.getByRole("textbox", { name: "Unit" }).fill("cm");
    await visit.page.keyboard.press("Enter");
    await visit.sent("unit cm");
    await panel.getByText("0.42 mm").waitFor();
    await panel.getByRole("checkbox", { name: "Measure" }).click();
    await visit.sent("tool measure");
    await panel.getByRole("button", { name: "Section" }).click();
    await visit.sent("section cut");
    const section = { ready: true, original: "M0 0L10000 0", edited: "M0 5L10000 9", exaggeration: 1 };
    const ways = [0, 4000, 8000].map((at) => ({ at, text: at < 8000 ? `${at / 200}` : "40 mm" }));
    const heights = [-1000, 0, 1000].map((at) => ({ at, text: at < 1000 ? `${at / 200}` : "5 mm" }));
    await visit.document({ section: { ...section, ways, heights } });
    const plot = visit.page.getByRole("region", { name: "Section" });
    await plot.getByRole("img", { name: "Drawing of the section", exact: true }).waitFor();
    await plot.getByRole("textbox", { name: "Heights of the section as a number" }).fill("10");
    await visit.page.keyboard.press("Enter");
    await visit.sent("section heights 10");
    await visit.document({ section: { ...section, exaggeration: 10, ways, heights: heights.slice(1) } });
    await plot.locator("path.after[transform='scale(1 10)']").waitFor();
    assert.deepEqual(await plot.locator("text").allTextContents(), ["0", "20", "40 mm", "0", "5 mm"]);
    assert.equal(await plot.getByText("5 mm").getAttribute("y"), "-10000");
    await visit.screenshot("section-plot");
    await plot.getByRole("button", { name: "Save drawing" }).click();
    await visit.sent("section save svg");
    await plot.getByRole("button", { name: "Close the section" }).click();
    await visit.sent("section close");
    await panel.getByRole("button", { name: "Clear the ruler" }).click();
    await visit.sent("ruler clear");
  }));
