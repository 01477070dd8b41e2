// Starts the page with the engine's worker.

import { render } from "preact";
import { EngineLink, type EnginePort } from "./engine_link";
import { Page } from "./page";
import type { Pictures } from "./protocol";
import { missingParts } from "./support";
import { applyTheme } from "./theme";
import { Unsupported } from "./unsupported";

const place = document.getElementById("page")!;
const address = (name: string) => new URL(place.dataset[name]!, document.baseURI).href;
const makeWorker = () => new Worker(address("engine"), { type: "module" }) as unknown as EnginePort;

/** Who draws, where the page's address says so: "?pictures=processor". */
const asked = new URLSearchParams(location.search).get("pictures");
const pictures: Pictures = asked === "card" || asked === "processor" ? asked : "best";

applyTheme();
const missing = missingParts();
if (missing.length > 0) render(<Unsupported missing={missing} />, place);
else render(<Page link={new EngineLink(makeWorker, { core: address("core"), rasterCore: address("rasterCore"), pictures })} />, place);
