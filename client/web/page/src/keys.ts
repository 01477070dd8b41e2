// The keys of client/model/bindings.cpp and what they do here.

import { command } from "./commands";
import type { EngineLink } from "./engine_link";
import type { Document } from "./snapshot";

/** What keys reach beyond commands. */
export interface PageActions {
  open(): void;
  exportMesh(): void;
  toggleLog(): void;
  toggleHelp(): void;
  closeOpen(): void;
}

interface Context {
  link: EngineLink;
  document: Document | null;
  page: PageActions;
}

export interface KeyAction {
  /** Modifiers Ctrl, Shift, Alt in that order, and a name. */
  keys: string[];
  means: string;
  /** True if the key needs an open session. */
  session?: boolean;
  run(context: Context): void;
}

const kRadiusStep = 1.15;
const kStrengthStep = 0.1;

const sends = (keys: string[], means: string, line: (document: Document) => string): KeyAction => ({
  keys,
  means,
  session: true,
  run: ({ link, document }) => document && link.send(line(document)),
});
const view = (key: string, name: string, means: string) => sends([key], means, () => command.view(name));
const radius = (key: string, factor: number, means: string) =>
  sends([key], means, ({ brush, diagonal }) => {
    const moved = Math.min(0.5 * diagonal, Math.max(1e-4 * diagonal, brush.radius * factor));
    return command.brush({ ...brush, radius: moved });
  });
const strength = (key: string, step: number, means: string) =>
  sends([key], means, ({ brush }) => {
    const moved = Math.min(1, Math.max(0.01, brush.strength + step));
    return command.brush({ ...brush, strength: moved });
  });

export const keyActions: readonly KeyAction[] = [
  { keys: ["Ctrl+O"], means: "Open a scan", run: ({ page }) => page.open() },
  sends(["Ctrl+Z"], "Undo your last edit", command.undo),
  sends(["Ctrl+Shift+Z", "Ctrl+Y"], "Redo it", command.redo),
  sends(["Home"], "Show the whole scan", command.frame),
  sends(["C"], "Turn around the point under the cursor", command.focus),
  sends(["F"], "Move the mouse to set the brush's radius", () => command.brushDrag("radius")),
  sends(["Shift+F"], "Move the mouse to set the brush's strength", () => command.brushDrag("strength")),
  radius("[", 1 / kRadiusStep, "Smaller brush"),
  radius("]", kRadiusStep, "Larger brush"),
  strength("{", -kStrengthStep, "Weaker brush"),
  strength("}", kStrengthStep, "Stronger brush"),
  sends(["N"], "Left button turns instead of painting", ({ tool }) =>
    command.tool(tool === "look" ? "paint" : "look"),
  ),
  sends(["M"], "Left button measures distances", ({ tool }) =>
    command.tool(tool === "measure" ? "paint" : "measure"),
  ),
  sends(["W"], "Show the triangles' edges", ({ view }) => command.wireframe(!view.wireframe)),
  sends(["S"], "Original on the left, edited on the right", ({ view }) => command.split(!view.split)),
  { keys: ["Ctrl+E"], means: "Export the edited scan", session: true, run: ({ page }) => page.exportMesh() },
  sends(["F9"], "Save a picture of the surface", (document) =>
    command.picture(`${document.session}.png`),
  ),
  sends(["B"], "Remember this view", command.bookmarkAdd),
  view("1", "front", "View from the front"),
  view("Shift+1", "back", "View from the back"),
  view("3", "right", "View from the right"),
  view("Shift+3", "left", "View from the left"),
  view("7", "top", "View from above"),
  view("Shift+7", "bottom", "View from below"),
  sends(["5"], "With or without perspective", ({ view }) => command.orthographic(!view.orthographic)),
  { keys: ["L"], means: "Show all messages", run: ({ page }) => page.toggleLog() },
  { keys: ["?", "F1"], means: "Show the keys", run: ({ page }) => page.toggleHelp() },
  {
    keys: ["Escape"],
    means: "Cancel the stroke; close what is open",
    run: ({ link, document, page }) => {
      page.closeOpen();
      if (document) link.send(command.cancel());
    },
  },
];

/** Returns e.g. "Ctrl+Shift+Z". The name of a letter is upper case. */
export function keyOf(event: KeyboardEvent): string {
  const digit = /^Digit(\d)$/.exec(event.code)?.[1]; // Shift makes another letter of it
  const letter = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const isSymbol = event.key.length === 1 && event.key.toLowerCase() === event.key.toUpperCase();
  const shiftedDigit = event.shiftKey && isSymbol && digit !== undefined && event.key !== digit;
  const name = shiftedDigit ? digit : letter;
  const hasShift = event.shiftKey && (!isSymbol || shiftedDigit);
  const parts = [event.ctrlKey || event.metaKey ? "Ctrl" : "", hasShift ? "Shift" : ""];
  return [...parts, event.altKey ? "Alt" : "", name].filter((part) => part).join("+");
}

/** Returns true if the focus takes letters for itself. */
function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return target.type === "text" || target.type === "password";
  return target instanceof HTMLSelectElement;
}

const kSliderKeys = ["Home", "End", "PageUp", "PageDown"];

/** Returns true if the key moves a slider that has the focus. */
function movesSlider(target: EventTarget | null, key: string): boolean {
  return target instanceof HTMLInputElement && target.type === "range" && kSliderKeys.includes(key);
}

export function handleKeyDown(event: KeyboardEvent, context: Context): void {
  const key = keyOf(event);
  if (event.isComposing || event.defaultPrevented) return;
  if (movesSlider(event.target, key)) return;
  if (isTyping(event.target) && key !== "Escape" && key !== "F1") return;
  if (key === " " && context.document && isPicture(event.target)) {
    event.preventDefault();
    if (!event.repeat) context.link.send(command.original(true));
    return;
  }
  const action = keyActions.find((one) => one.keys.includes(key));
  if (!action || (action.session && !context.document)) return;
  if (key !== "Escape") event.preventDefault();
  action.run(context);
}

/** Ends what a held key does. */
export function handleKeyUp(event: KeyboardEvent, context: Context): void {
  if (event.key === " " && context.document && isPicture(event.target))
    context.link.send(command.original(false));
}

// Space presses a button that has the focus.
const isPicture = (target: EventTarget | null) =>
  target === document.body || (target instanceof HTMLElement && target.classList.contains("picture"));
