// A publication in a browser, from a plain web server: it looks as the page does, and asks nobody else.

import assert from "node:assert/strict";
import { cpSync, existsSync, readdirSync, rmSync, truncateSync } from "node:fs";
import { basename, join } from "node:path";
import { after, before, test } from "node:test";
import { hasFirefox } from "../browser";
import { Lab, difference, until, type Pixels, type Visit } from "./lab";
import { importLettered } from "./lettered";
import { hasNginx, serveByNginx } from "./nginx";
import { serve, stopServing } from "./web_server";

const labs = { card: new Lab("card"), processor: new Lab("best", "plain") };
const prepare = async (lab: Lab) => {
  await lab.start();
  await lab.importTablet();
  await lab.ask("open", "tablet", "--session", "shown");
  await lab.ask("edit", "shown", "--beta", "0.2");
};
before(() => Promise.all(Object.values(labs).map(prepare)));
after(async () => {
  await stopServing();
  await Promise.all(Object.values(labs).map((lab) => lab.stop()));
});

const button = (visit: Visit, name: string) => visit.page.getByRole("button", { name, exact: true });

const kSides: [side: string, line: string][] = [
  ["Edited", "split off"],
  ["Split", "split on"],
  ["Original", "original on"],
];

/** Leaves the page's picture, between its columns, as wide as a publication's usual one. */
const kWide = { viewport: { width: 1542, height: 700 } };

/** Returns the page's pictures of a session from the front, by side. */
async function picturesOfThePage(lab: Lab, session: string): Promise<Record<string, Pixels>> {
  const pictures: Record<string, Pixels> = {};
  await lab.visit(async (visit) => {
    await visit.join(session);
    for (const [side, line] of kSides) {
      await visit.replay(["view front", line, "wait"]);
      pictures[side] = await visit.picture();
    }
  }, kWide);
  return pictures;
}

/** Opens the publication again in a page whose picture is so large: it is framed when it opens. */
async function openAsLargeAs(visit: Visit, { width, height }: Pixels): Promise<void> {
  await visit.page.getByText("full detail").waitFor();
  const { width: now, height: high } = await visit.picture();
  const size = visit.page.viewportSize()!;
  await visit.page.setViewportSize({ width: size.width + width - now, height: size.height + height - high });
  await visit.page.reload();
  await visit.page.getByText("full detail").waitFor();
  await button(visit, "Front").click();
}

/** Demands that a publication comes to look as the page, and asks nobody else. */
async function looksAsThePage(lab: Lab, session: string): Promise<void> {
  const wanted = await picturesOfThePage(lab, session);
  const changed = difference(wanted.Edited!, wanted.Original!);
  assert.ok(changed.mean > 0.5, `the edits are not to be seen: ${JSON.stringify(changed)}`);
  const folder = `out-${session}`;
  await lab.ask("publish", session, folder, "--title", "A tablet", "--credit", "Museum of Examples, CC BY 4.0");
  const address = await serve(lab.path(folder), "ranges");
  await lab.visitAt(address, async (visit) => {
    await openAsLargeAs(visit, wanted.Edited!);
    assert.equal(await visit.page.title(), "A tablet");
    await visit.page.getByText("Museum of Examples, CC BY 4.0").waitFor();
    for (const [side] of kSides) {
      await button(visit, side).click();
      const found = async () => difference(await visit.picture(), wanted[side]!);
      await until(found, ({ mean, most }) => mean < 0.5 && most <= 6); // texels come after the pages
      await visit.screenshot(`published-${session}-${side}`);
    }
    assert.deepEqual(visit.asked.filter((one) => !one.startsWith(address) && !one.startsWith("blob:")), []);
  });
}

test("APublicationLooksAsThePageByOpenGl", () => looksAsThePage(labs.card, "shown"));
test("APublicationLooksAsThePageByTheProcessor", () => looksAsThePage(labs.processor, "shown"));

test("APublicationShowsTexelsEditedColoursAndGains", async () => {
  const lab = labs.processor;
  await importLettered(lab);
  await lab.ask("open", "lettered", "--session", "painted");
  await lab.ask("edit", "painted", "--beta", "0.5", "--colour-beta", "0.2", "--colour-alpha", "20", "--texture-gain", "0.6");
  await looksAsThePage(lab, "painted");
});

test("NginxShowsAPublicationAsItComes", { skip: hasNginx ? false : "there is no nginx" }, async () => {
  const nginx = await serveByNginx(await publishOnce());
  try {
    await labs.card.visitAt(nginx.address, (visit) => visit.page.getByText("full detail").waitFor());
  } finally {
    await nginx.stop();
  }
});

test("FirefoxShowsAPublication", { skip: hasFirefox ? false : "there is no firefox-esr" }, async () => {
  const lab = new Lab("best", "firefox");
  const address = await serve(await publishOnce(), "ranges");
  try {
    await lab.begin(address);
    await lab.visitAt(address, (visit) => visit.page.getByText("full detail").waitFor(), {}, /style-src-elem/);
  } finally {
    await lab.stop();
  }
});

/** Publishes the session of the tablet, and returns the folder. Later calls return the same. */
async function publishOnce(): Promise<string> {
  const folder = labs.card.path("out");
  if (!existsSync(folder)) await labs.card.ask("publish", "shown", "out");
  return folder;
}

// What goes wrong on the way to a web server.

/** Visits a publication that cannot be shown, and waits for the sentence that says why. */
const isTold = (address: string, sentence: RegExp) =>
  labs.card.visitAt(address, (visit) => visit.page.getByText(sentence).first().waitFor(), {}, /./);

test("AWebServerWithoutRangesIsToldInASentence", async () =>
  isTold(await serve(await publishOnce(), "whole"), /does not send parts of files/));

test("AWebServerThatSendsScriptsAsTextIsToldInASentence", async () =>
  isTold(await serve(await publishOnce(), "plain"), /must have assets\/page\.js.*send it as JavaScript/));

test("APageThatIsOpenedFromTheDiskSaysThatItNeedsAWebServer", async () =>
  isTold(`file://${await publishOnce()}/index.html`, /the\s+whole folder on a web server/));

const kDamages: [what: string, file: RegExp, bytesLeft: number | null, sentence: RegExp][] = [
  ["scan.json is missing", /^scan\.json$/, null, /has no scan\.json beside this page: it answers 404/],
  ["scan.json is cut off", /^scan\.json$/, 100, /scan\.json beside this page is cut off/],
  ["the index is missing", /\.index$/, null, /does not send scan-\w+\.index.*answers 404/],
  ["the index is cut off", /\.index$/, 8, /scan-\w+\.index has 8 bytes, not \d+: it is cut off/],
  ["the parts are missing", /\.parts$/, null, /does not send scan-\w+\.parts.*answers 404/],
  ["the parts are cut off", /\.parts$/, 1000, /scan-\w+\.parts has 1000 bytes, not \d+: it is cut off/],
  ["the engine is missing", /^engine\.js$/, null, /engine did not load.*assets\/engine\.js/],
  ["the core is missing", /^core\.packed$/, null, /engine did not load: .*core\.packed.*404/],
  ["the core is cut off", /^core\.packed$/, 1000, /engine did not load: .*core\.packed is damaged or cut off/],
];

for (const [what, file, bytesLeft, sentence] of kDamages)
  test(`AVisitorIsToldInASentenceThat: ${what}`, async () => {
    const folder = labs.card.path(`damaged-${file.source.replace(/\W/g, "")}-${bytesLeft}`);
    cpSync(await publishOnce(), folder, { recursive: true });
    const place = [folder, join(folder, "assets")].flatMap((one) => readdirSync(one).map((name) => join(one, name)));
    const path = place.find((one) => file.test(basename(one)))!;
    if (bytesLeft === null) rmSync(path);
    else truncateSync(path, bytesLeft);
    await isTold(await serve(folder, "ranges"), sentence);
  });
