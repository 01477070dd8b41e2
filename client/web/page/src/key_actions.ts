// The actions of keys, as client/model/input/bindings.cpp has them, and what they do here.

import { command } from "./commands";
import type { EngineLink } from "./engine_link";
import { keepOwnKey, ownKeys } from "./own_keys";
import type { Document } from "./snapshot";

/** The actions of keys beyond commands. */
export interface PageActions {
  open(): void;
  exportMesh(): void;
  chooseDepth(): void;
  closeSession(): void;
  toggleLog(): void;
  toggleHelp(): void;
  closeOpen(): void;
}

export interface Context {
  link: EngineLink;
  document: Document | null;
  page: PageActions;
}

export interface KeyAction {
  /** As the window's preferences call it, where it has it. */
  name: string;
  /** Modifiers Ctrl, Shift, Alt in that order, and a name. Users may have another key in the place of the first. */
  keys: string[];
  means: string;
  /** True if the key needs an open session. */
  session?: boolean;
  /** True if the key is the picture's alone: elsewhere it moves sliders, lists and columns. */
  picture?: boolean;
  run(context: Context): void;
}

const kRadiusStep = 1.15;
const kStrengthStep = 0.1;

const sends = (name: string, keys: string[], means: string, line: (document: Document) => string): KeyAction => ({
  name,
  keys,
  means,
  session: true,
  run: ({ link, document }) => document && link.send(line(document)),
});
const view = (key: string, name: string, means: string) => sends(name, [key], means, () => command.view(name));
const kTurnStep = 15; // degrees
const turn = (key: string, name: string, azimuth: number, elevation: number, means: string): KeyAction => ({
  ...sends(name, [key], means, () => command.turn(azimuth * kTurnStep, elevation * kTurnStep)),
  picture: true,
});
const radius = (name: string, key: string, factor: number, means: string) =>
  sends(name, [key], means, ({ brush, diagonal }) => {
    const moved = Math.min(0.5 * diagonal, Math.max(1e-4 * diagonal, brush.radius * factor));
    return command.brush({ ...brush, radius: moved });
  });
const strength = (name: string, key: string, step: number, means: string) =>
  sends(name, [key], means, ({ brush }) => {
    const moved = Math.min(1, Math.max(0.01, brush.strength + step));
    return command.brush({ ...brush, strength: moved });
  });

export const keyActions: readonly KeyAction[] = [
  { name: "open", keys: ["Ctrl+O"], means: "Open a scan", run: ({ page }) => page.open() },
  sends("undo", ["Ctrl+Z"], "Undo your last edit", command.undo),
  sends("redo", ["Ctrl+Shift+Z", "Ctrl+Y"], "Redo it", command.redo),
  sends("frame_all", ["Home"], "Show the whole scan", command.frame),
  sends("focus", ["C"], "Turn around the point under the cursor", command.focus),
  sends("brush_radius", ["F"], "Move the mouse to set the brush's radius", () => command.brushDrag("radius")),
  sends("brush_strength", ["Shift+F"], "Move the mouse to set the brush's strength", () => command.brushDrag("strength")),
  radius("radius_down", "[", 1 / kRadiusStep, "Smaller brush"),
  radius("radius_up", "]", kRadiusStep, "Larger brush"),
  strength("strength_down", "{", -kStrengthStep, "Weaker brush"),
  strength("strength_up", "}", kStrengthStep, "Stronger brush"),
  sends("navigate_mode", ["N"], "Left button turns instead of painting", ({ tool }) =>
    command.tool(tool === "look" ? "paint" : "look"),
  ),
  sends("measure_mode", ["M"], "Left button measures distances", ({ tool }) =>
    command.tool(tool === "measure" ? "paint" : "measure"),
  ),
  sends("wireframe", ["W"], "Show the triangles' edges", ({ view }) => command.wireframe(!view.wireframe)),
  sends("split", ["S"], "Original on the left, edited on the right", ({ view }) => command.split(!view.split)),
  { name: "export", keys: ["Ctrl+E"], means: "Export the edited scan", session: true, run: ({ page }) => page.exportMesh() },
  sends("screenshot", ["F9"], "Save a picture of the surface", (document) =>
    command.picture(`${document.session}.png`),
  ),
  sends("bookmark", ["B"], "Remember this view", command.bookmarkAdd),
  view("1", "front", "View from the front"),
  view("Shift+1", "back", "View from the back"),
  view("3", "right", "View from the right"),
  view("Shift+3", "left", "View from the left"),
  view("7", "top", "View from above"),
  view("Shift+7", "bottom", "View from below"),
  sends("orthographic", ["5"], "With or without perspective", ({ view }) => command.orthographic(!view.orthographic)),
  turn("ArrowLeft", "turn_left", -1, 0, "Turn the view to the left, in the picture"),
  turn("ArrowRight", "turn_right", 1, 0, "Turn the view to the right, in the picture"),
  turn("ArrowUp", "turn_up", 0, 1, "Turn the view upwards, in the picture"),
  turn("ArrowDown", "turn_down", 0, -1, "Turn the view downwards, in the picture"),
  {
    name: "save",
    keys: ["Ctrl+S"],
    means: "Say whether all edits are saved",
    session: true,
    run: ({ link, document }) => document && tellSaved(link, document.unsavedEdits),
  },
  { name: "log", keys: ["L"], means: "Show all messages", run: ({ page }) => page.toggleLog() },
  { name: "help", keys: ["?", "F1"], means: "Show the keys", run: ({ page }) => page.toggleHelp() },
  {
    name: "cancel",
    keys: ["Escape"],
    means: "Cancel the stroke; close what is open",
    run: ({ link, document, page }) => {
      page.closeOpen();
      if (document) link.send(command.cancel());
    },
  },
];

/** Each edit is saved as it is made, so there is nothing to do. */
function tellSaved(link: EngineLink, unsaved: number): void {
  if (unsaved === 0) return link.tell("all edits are saved; Export writes a file");
  link.tell(`${unsaved} ${unsaved === 1 ? "edit is" : "edits are"} not saved yet`, "warning");
}

/** Returns the keys of an action; the first is the user's own, if there is one. */
export function keysOf(action: KeyAction): string[] {
  const own = ownKeys()[action.name];
  return own ? [own, ...action.keys.slice(1)] : action.keys;
}

/** Returns the first key of an action. */
export const keyNamed = (name: string) => keysOf(keyActions.find((one) => one.name === name)!)[0]!;

// They lead through the page, and press what has the focus.
const kKeysOfPages = ["Tab", "Shift+Tab", "Enter", " "];

/** Gives an action another first key. Returns why not, if so. */
export function chooseKey(action: KeyAction, key: string): string {
  if (kKeysOfPages.includes(key)) return `${key === " " ? "Space" : key} moves through the page`;
  const other = keyActions.find((one) => one !== action && keysOf(one).includes(key));
  if (other) return `${key} is taken: ${other.means}`;
  keepOwnKey(action.name, key === action.keys[0] ? null : key);
  return "";
}
