// Stands for the engine in tests: keeps a snapshot, tells the tests what it was sent, and does what
// they say. It obeys a few lines, so that the page sees its own changes.

import type { ToPage, ToWorker } from "../../../client/web/page/src/protocol";
import type { Snapshot, Widget } from "../../../client/web/page/src/snapshot";
import { session, snapshot } from "./sample";

/** What a test tells the engine. */
export type Order = { post: ToPage } | { change: Partial<Snapshot> } | { document: object };

const scope = self as unknown as {
  postMessage(message: ToPage): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
};
const seen = new BroadcastChannel("engine-seen");
const orders = new BroadcastChannel("engine-orders");
let now: Snapshot = structuredClone(snapshot);

function change(part: Partial<Snapshot>): void {
  now = { ...now, ...part };
  scope.postMessage({ kind: "snapshot", snapshot: now });
}

function changeDocument(part: object): void {
  if (now.document) change({ document: { ...now.document, ...part } });
}

/** Switches, moves or chooses one widget: "Light/Lamp". */
function usePanel(value: string, place: string): void {
  if (!now.document) return;
  const [panel, name] = place.split("/") as [string, string];
  const used = (one: Widget): Widget => {
    if (one.kind === "row") return { ...one, widgets: one.widgets.map(used) };
    if (one.name !== name) return one;
    if (one.kind === "check") return { ...one, on: value === "on" };
    if (one.kind === "slider") return { ...one, value: Number(value) };
    return one.kind === "choice" ? { ...one, value } : one;
  };
  changeDocument({ panels: { ...now.document.panels, [panel]: now.document.panels[panel]!.map(used) } });
}

/** Obeys the lines whose effect a test looks at. */
function obey(line: string): void {
  const words = line.replace(/^preview /, "").split(" ");
  if (line.startsWith("session join") || line.startsWith("scan open"))
    change({ document: structuredClone(session) });
  if (line === "close") change({ document: null });
  if (words[0] === "beta") changeDocument({ beta: Number(words[1]) });
  if (words[0] === "tool") changeDocument({ tool: words[1] });
  if (words[0] === "wireframe" && now.document)
    changeDocument({ view: { ...now.document.view, wireframe: words[1] === "on" } });
  if (line === "menu close" && now.document) changeDocument({ over: { ...now.document.over, menu: null } });
  if (words[0] === "panel") usePanel(words[2]!, words.slice(3).join(" "));
  if (line === "record start" || line === "record stop") change({ recording: line === "record start" });
}

scope.onmessage = ({ data }) => {
  if (data.kind === "start") {
    const { canvas, ...rest } = data;
    seen.postMessage({ ...rest, hasCanvas: canvas instanceof OffscreenCanvas });
    const isLate = data.kept.list === "late"; // the list comes by an order
    return change(isLate ? { library: { ...now.library, scans: [], sessions: [] } } : {});
  }
  if (data.kind === "import" || data.kind === "replay")
    return seen.postMessage({ kind: data.kind, name: data.file.name, size: data.file.size });
  // No channel carries a compiled core.
  seen.postMessage(data.kind === "core" ? { kind: data.kind } : data);
  if (data.kind === "command") obey(data.line);
};

orders.onmessage = ({ data }: MessageEvent<Order>) => {
  if ("post" in data) scope.postMessage(data.post);
  if ("change" in data) change(data.change);
  if ("document" in data) changeDocument(data.document);
};
