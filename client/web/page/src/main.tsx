// Starts the page with the engine's worker.

import { render } from "preact";
import { EngineLink, type EnginePort } from "./engine_link";
import { Page } from "./page";
import { applyTheme } from "./theme";

const makeWorker = () =>
  new Worker("/assets/engine.js", { type: "module" }) as unknown as EnginePort;

applyTheme();
const link = new EngineLink(makeWorker);
render(<Page link={link} />, document.getElementById("page")!);
