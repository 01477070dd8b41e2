// A publication in a browser, from a plain web server: it looks as the page does, and asks nobody else.

import assert from "node:assert/strict";
import { spawn, type ChildProcess } from "node:child_process";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Lab, difference, end, type Pixels, type Visit } from "./lab";

const labs = { card: new Lab("card"), processor: new Lab("best", "plain") };
const servers: ChildProcess[] = [];

/** Serves a folder, and returns its address. `kind`: whether the server sends parts of files. */
function serve(folder: string, kind: "ranges" | "whole"): Promise<string> {
  const server = spawn("python3", [join(process.env.BURNISH_LIVE_TESTS!, "web_server.py"), folder, kind], {
    stdio: ["ignore", "pipe", "inherit"],
  });
  servers.push(server);
  return new Promise((resolve, reject) => {
    server.stdout!.once("data", (line: Buffer) => resolve(String(line).trim()));
    server.once("exit", (code) => reject(new Error(`the web server ended with ${code}`)));
  });
}

const prepare = async (lab: Lab) => {
  await lab.start();
  await lab.importTablet();
  await lab.ask("open", "tablet", "--session", "shown");
  await lab.ask("edit", "shown", "--beta", "0.2");
  await lab.ask("publish", "shown", "out", "--title", "A tablet", "--credit", "Museum of Examples, CC BY 4.0");
};
before(() => Promise.all(Object.values(labs).map(prepare)));
after(async () => {
  await Promise.all(servers.map((server) => end(server, "SIGKILL")));
  await Promise.all(Object.values(labs).map((lab) => lab.stop()));
});

const button = (visit: Visit, name: string) => visit.page.getByRole("button", { name, exact: true });

/** Visits the publication, and returns pictures of it by side. Demands that no request goes elsewhere. */
async function publishedPictures(lab: Lab, address: string): Promise<Record<string, Pixels>> {
  const pictures: Record<string, Pixels> = {};
  await lab.visitAt(address, async (visit) => {
    await visit.page.getByText("full detail").waitFor();
    assert.equal(await visit.page.title(), "A tablet");
    await visit.page.getByText("Museum of Examples, CC BY 4.0").waitFor();
    await button(visit, "Top").click();
    await button(visit, "Frame all").click();
    for (const side of ["Edited", "Split", "Original"]) {
      await button(visit, side).click();
      await visit.page.getByRole("button", { name: side, pressed: true }).waitFor();
      await visit.page.getByText("full detail").waitFor();
      pictures[side] = await visit.picture();
      await visit.screenshot(`published-${side}`);
    }
    assert.deepEqual(visit.asked.filter((one) => !one.startsWith(address) && !one.startsWith("blob:")), []);
  });
  return pictures;
}

const kSides: [side: string, line: string][] = [
  ["Edited", "split off"],
  ["Split", "split on"],
  ["Original", "original on"],
];

/** Makes the page's picture as large as this one. */
async function resize(visit: Visit, { width, height }: Pixels): Promise<void> {
  const { width: now, height: high } = await visit.picture();
  const size = visit.page.viewportSize()!;
  await visit.page.setViewportSize({ width: size.width + width - now, height: size.height + height - high });
}

async function looksAsThePage(lab: Lab): Promise<void> {
  const published = await publishedPictures(lab, await serve(lab.path("out"), "ranges"));
  await lab.visit(async (visit) => {
    await visit.join("shown");
    await resize(visit, published.Edited!);
    const wrong: string[] = [];
    for (const [side, line] of kSides) {
      await visit.replay(["view top", "frame", line, "wait"]);
      const found = difference(published[side]!, await visit.picture());
      if (found.mean > 0.5 || found.most > 6) wrong.push(`${side}: ${JSON.stringify(found)}`);
    }
    assert.deepEqual(wrong, []);
    const changed = difference(published.Edited!, published.Original!);
    assert.ok(changed.mean > 0.5, `the edits are not to be seen: ${JSON.stringify(changed)}`);
  });
}

test("APublicationLooksAsThePageByOpenGl", () => looksAsThePage(labs.card));
test("APublicationLooksAsThePageByTheProcessor", () => looksAsThePage(labs.processor));

test("AWebServerWithoutRangesIsToldInASentence", async () => {
  const address = await serve(labs.card.path("out"), "whole");
  await labs.card.visitAt(address, async (visit) => {
    await visit.page.getByRole("alert").getByText(/does not send parts of files/).waitFor();
  });
});
