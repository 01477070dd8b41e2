// Starts the page with the engine's worker.

import { render } from "preact";
import type { PublicationStart } from "../../engine/published/calls";
import { readScan } from "../../engine/published/scan";
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

const linkTo = (publication: PublicationStart | null) =>
  new EngineLink(makeWorker, { core: address("core"), rasterCore: address("rasterCore"), pictures, publication });

/** Shows the files beside this page. */
async function showPublication(base: string): Promise<void> {
  try {
    const scan = await readScan(base);
    render(<Viewer scan={scan} link={linkTo({ scan, base })} />, place);
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
else render(<Page link={linkTo(null)} />, place);
