// Starts the page with the engine's worker.

import { render } from "preact";
import { compileCore } from "../../engine/core_module";
import { seemsToHaveCard } from "../../engine/drawing";
import { readScan } from "../../engine/published/scan";
import { sessionOfAddress } from "./address";
import { EngineLink, type EnginePort } from "./engine_link";
import { Page } from "./page";
import type { Pictures } from "./protocol";
import { missingParts } from "./support";
import { applyTheme, chosenTheme } from "./theme";
import { Unsupported } from "./unsupported";
import { Useless, Viewer } from "./viewer";

const place = document.getElementById("page")!;
const address = (name: string) => new URL(place.dataset[name]!, document.baseURI).href;
const makeWorker = () => new Worker(address("engine"), { type: "module" }) as unknown as EnginePort;

/** Who draws, where the page's address says so: "?pictures=processor". */
const asked = new URLSearchParams(location.search).get("pictures");
const pictures: Pictures = asked === "card" || asked === "processor" ? asked : "best";

const cores = { core: address("core"), rasterCore: address("rasterCore"), pictures };

/** The core that comes while the engine does, which would ask for it a round trip later. */
const handedCore = seemsToHaveCard(pictures) ? cores.core : cores.rasterCore;
const handed = () => compileCore(handedCore).catch(() => null); // the engine tries again, and says why

/** Begins to load an engine now. Returns what hands it out first, and then others. */
function earlyWorker(): () => EnginePort {
  let early: EnginePort | null = makeWorker();
  let failure: ErrorEvent | null = null;
  early.onerror = (event) => (failure = event);
  return () => {
    const port = early ?? makeWorker();
    if (early && failure) queueMicrotask(() => port.onerror?.(failure!));
    early = null;
    return port;
  };
}

/** Shows the files beside this page. Each round trip counts, so engine and core come while scan.json does. */
async function showPublication(base: string): Promise<void> {
  const coming = readScan(base);
  coming.catch(() => {}); // it is told below
  const makePort = earlyWorker();
  const core = handed();
  try {
    const scan = await coming;
    const link = new EngineLink(makePort, { ...cores, handedCore, publication: { scan, base } }, core);
    render(<Viewer scan={scan} link={link} />, place);
  } catch (error) {
    render(<Useless reason={error instanceof Error ? error.message : String(error)} />, place);
  }
}

const isPublication = "scan" in place.dataset;
applyTheme(isPublication ? "system" : chosenTheme());
place.replaceChildren();
const missing = missingParts();
if (missing.length > 0) render(<Unsupported missing={missing} does={isPublication ? "show" : "edit"} />, place);
else if (isPublication) void showPublication(address("scan"));
else {
  const link = new EngineLink(makeWorker, { ...cores, handedCore, publication: null }, handed());
  link.want(sessionOfAddress());
  render(<Page link={link} />, place);
}
