import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { Fleet, lacksFleet, type Node } from "./fleet";
import { Lab, until, type HistoryEntry } from "./lab";

const skip = lacksFleet();
const fleet = new Fleet();
const lab = new Lab();
before(async () => {
  if (skip) return;
  await fleet.start();
  await lab.begin(fleet.address());
  await lab.run("generate", "tablet", "tablet.ply", "--vertices", "10000");
  await ask("one", "import", "tablet.ply", "--name", "tablet");
  for (const node of ["one", "two"] as const) await ask(node, "open", "tablet", "--session", `of-${node}`);
});
after(async () => {
  if (skip) return;
  await lab.stop();
  await fleet.stop();
});

const ask = (node: Node, ...words: string[]) => lab.run(...words, "--server", fleet.rpc(node));
const history = async (node: Node, session: string) =>
  (JSON.parse(await ask(node, "history", session, "--json")) as HistoryEntry[]).map(({ summary }) => summary);

// The proxy chooses the first server, so one of the two sessions is elsewhere.
test("PageFollowsASessionToItsServer", { skip }, () =>
  lab.visit(async (visit) => {
    for (const node of ["one", "two"] as const) {
      await visit.join(`of-${node}`);
      const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
      await field.fill("0.5");
      await field.press("Enter");
      await until(
        () => history(node, `of-${node}`),
        (entries) => entries.length === 1,
      );
      await visit.choose("File", "Close session");
    }
  }));

test("SessionGoesOnAtAnotherServerAndUnsentEditsStay", { skip }, () =>
  lab.visit(
    async (visit) => {
      await visit.join("of-one");
      const field = visit.page.getByRole("textbox", { name: "Gradient scale β as a number" });
      const drained = fleet.drain("one");
      for (const value of ["0.6", "0.7", "0.8"]) {
        await field.fill(value);
        await field.press("Enter");
      }
      await drained;
      await until(
        () => history("two", "of-one"),
        (entries) => entries.length === 4,
      );
      assert.deepEqual(await history("two", "of-one"), ["beta 0.5", "beta 0.6", "beta 0.7", "beta 0.8"]);
      await visit.page.getByRole("alert").waitFor({ state: "detached" });
      await visit.settled();
    },
    {},
    /WebSocket connection to .* failed/,
  ));
