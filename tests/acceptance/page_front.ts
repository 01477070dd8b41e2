// The page as a front of the gate: replays scripts in sessions and keeps what they export.
// Usage: node page_front.cjs ADDRESS PATIENCE_S
//   Reads lines {"session", "script", "out"} as JSON, and answers each by {}, {"refused": SENTENCE} or {"failed": WHY}.

import { createInterface } from "node:readline";
import { readFileSync } from "node:fs";
import { launchBrowser } from "../client/web/browser";
import { Visit } from "../client/web/live/lab";

interface Order {
  session: string;
  script: string;
  out: string;
}

const [, , address, patience] = process.argv;

/** Returns the sentence of a script that the page refused, or "" and the file is there. */
async function follow(visit: Visit, { session, script, out }: Order): Promise<string> {
  visit.page.setDefaultTimeout(1000 * Number(patience));
  await visit.page.goto(address!);
  await visit.join(session);
  const download = visit.page.waitForEvent("download").then(async (file) => {
    await file.saveAs(out);
    return "";
  });
  download.catch(() => {}); // a refused script downloads nothing
  await visit.begin(readFileSync(script, "utf8").split("\n"));
  const refusal = visit.page.getByRole("log").getByText(/^replay: /).first().textContent();
  refusal.catch(() => {}); // a script that is done says nothing
  return (await Promise.race([download, refusal])) ?? "";
}

async function answer(visit: Visit, order: Order): Promise<object> {
  try {
    const refused = await follow(visit, order);
    if (visit.console.length > 0) return { failed: visit.console.join("; ") };
    return refused ? { refused } : {};
  } catch (error) {
    return { failed: [String(error), ...visit.console].join("; ") };
  }
}

async function main(): Promise<void> {
  const browser = await launchBrowser();
  for await (const line of createInterface({ input: process.stdin })) {
    const context = await browser.newContext({ viewport: { width: 1024, height: 700 } });
    const visit = new Visit(await context.newPage());
    console.log(JSON.stringify(await answer(visit, JSON.parse(line) as Order)));
    await context.close();
  }
  await browser.close();
}

void main();
