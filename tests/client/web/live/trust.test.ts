import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { writeFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { Lab } from "./lab";

const kMakeToken = process.env.BURNISH_MAKE_TOKEN!;
const lab = new Lab();
let token = "";

before(async () => {
  const made = execFileSync(kMakeToken, ["mia", "editor"], { encoding: "utf8" });
  token = made.split("\n")[1]!.slice(0, 64);
  writeFileSync(lab.path("users.toml"), made.slice(made.indexOf("[[user]]")));
  await lab.start(["--users", lab.path("users.toml")]);
});
after(() => lab.stop());

test("PageAsksForATokenAndConnectsWithIt", () =>
  lab.visit(async (visit) => {
    const form = visit.page.getByRole("form", { name: "Connect" });
    await form.getByLabel("Token").fill("wrong");
    await form.getByRole("button", { name: "Connect" }).click();
    await form.waitFor();
    await form.getByLabel("Token").fill(token);
    await form.getByRole("button", { name: "Connect" }).click();
    await visit.page.getByText(/^connected to/).waitFor();
    await visit.page.reload();
    await visit.page.getByText(/^connected to/).waitFor();
    const stored = await visit.page.evaluate(() => JSON.stringify(localStorage) + location.href + document.cookie);
    assert.ok(!stored.includes(token));
  }));

test("BrowserWithoutJspiHearsWhatItLacks", () =>
  lab.visit(async (visit) => {
    await visit.page.addInitScript(() => Reflect.deleteProperty(WebAssembly, "Suspending"));
    await visit.page.reload();
    await visit.page.getByRole("alert").waitFor();
    await visit.page.getByText(/JSPI.*Chrome and Edge 137/).waitFor();
  }));
