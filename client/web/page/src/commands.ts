// The lines that the page sends. Lines of the script language do the same in `burnish --script`.

import type { Brush, ColourBy, FallOff, Role, Tool } from "./snapshot";

/** A line of a front: its form and its meaning. */
export interface FrontCommand {
  form: string;
  means: string;
}

/** Lines that only a front needs. The core reads them in client/web/core/front_commands.cpp. */
export const frontCommands: readonly FrontCommand[] = [
  { form: "preview beta X", means: "shows a gradient scale during a drag; `beta X` ends it" },
  { form: "preview preset NAME STRENGTH", means: "shows a strength of a preset during a drag; `preset` ends it" },
  { form: "strengths open", means: "makes pictures of three strengths of the preset in force; they become `strength` messages" },
  { form: "strengths choose N", means: "sets the strength of picture N, from 0" },
  { form: "strengths close", means: "forgets the pictures" },
  { form: "preview fidelity ALPHA", means: "shows a fidelity during a drag; `fidelity ALPHA` ends it" },
  { form: "preview bands [SIZE:GAIN]...", means: "shows bands during a drag; `bands` ends it" },
  { form: "preview palette CURVE RRGGBB NAME [; ...]", means: "shows a palette during a drag" },
  { form: "panel preview|commit VALUE PANEL/WIDGET", means: "moves a slider, or lets it go; chooses; presses a button" },
  { form: "plot grab X Y REACH_X REACH_Y", means: "takes the curve's point there, or adds one" },
  { form: "plot take N", means: "takes the curve's point N, from 0" },
  { form: "plot drag X Y", means: "moves the taken point to a place of the plot, 0 to 1" },
  { form: "plot drop", means: "ends the drag and commits the curve if it has changed" },
  { form: "plot remove N", means: "removes the curve's point N and commits the curve" },
  { form: "library refresh", means: "asks the server for its scans and sessions" },
  { form: "scan open ID [anew] [depth N]", means: "opens a scan where its editing goes on" },
  { form: "scan rename ID NAME", means: "gives a scan another name" },
  { form: "scan delete ID", means: "deletes a scan and its sessions" },
  { form: "session join ID", means: "opens a session" },
  { form: "session rename ID NAME", means: "gives a session another name" },
  { form: "session delete ID", means: "deletes a session" },
  { form: "activity cancel N", means: "ends long work" },
  { form: "role USER viewer|editor|owner", means: "changes a role; the role is the last word" },
  { form: "message dismiss N", means: "drops a message from the snapshot" },
  { form: "tool paint|look|measure", means: "sets what the left button does" },
  { form: "brush_drag radius|strength", means: "lets the pointer's moves set it until a click" },
  { form: "section cut", means: "cuts the surface along the ruler, in the direction of the view" },
  { form: "section heights X", means: "draws heights so many times larger than ways, 1 to 50" },
  { form: "section close", means: "forgets the section" },
  { form: "section save svg|csv", means: "downloads the section as a drawing or a table" },
  { form: "ruler clear", means: "forgets the ruler's points" },
  { form: "preset_keep NAME", means: "keeps gradient scale, curve and bands as a preset of one's own" },
  { form: "preset_delete NAME", means: "deletes a preset of one's own" },
  { form: "unit [NAME]", means: "names the unit of the scan's coordinates for everybody" },
  { form: "depth N", means: "opens a fork of the session at another depth" },
  { form: "bands first", means: "makes bands to begin with" },
  { form: "split_at X", means: "puts the line of the split at a part of the width" },
  { form: "lamp X Y", means: "puts the lamp where the ball shows X Y, -1 to 1, y upwards" },
  { form: "turn AZIMUTH ELEVATION", means: "moves the eye around its target, to the right and upwards by degrees" },
  { form: "bookmark add", means: "remembers this view" },
  { form: "focus", means: "turns around the point under the pointer" },
  { form: "menu close", means: "forgets the menu that a click of the right button has asked for" },
  { form: "cancel", means: "cancels the stroke or the lasso" },
  { form: "figures on|off", means: "says whether the figures are shown, which costs snapshots" },
  { form: "over protection|curves on|off", means: "shows the region, or where the palette's curves rule" },
  { form: "record start", means: "begins a script of what is done" },
  { form: "record stop", means: "ends it and downloads it" },
  { form: "picture NAME", means: "downloads the picture as PNG" },
];

/** Writes a number with at most six digits, as the core reads it. */
export const number = (value: number) => String(Number(value.toPrecision(6)));
/** A file's name without what systems refuse in one, and without spaces. */
const fileName = (text: string) => text.trim().replace(/[\s/\\:*?"<>|]+/g, "-");
const onOff = (on: boolean) => (on ? "on" : "off");
const words = (...parts: (string | number)[]) =>
  parts.map((part) => (typeof part === "number" ? number(part) : part)).join(" ");
/** A name within a line: no line ends, and no spaces around it. */
const name = (text: string) => text.replace(/\s+/g, " ").trim();

export interface PaletteText {
  name: string;
  colour: number;
  curve: string;
}

const bandsText = (bands: { size: number; gain: number }[]) =>
  ["bands", ...bands.map((band) => `${number(band.size)}:${number(band.gain)}`)].join(" ");
const hex = (colour: number) => colour.toString(16).padStart(6, "0");
const paletteText = (curves: PaletteText[]) =>
  ["palette", curves.map((one) => words(one.curve, hex(one.colour), name(one.name))).join(" ; ")]
    .join(" ")
    .trim();

/** Each function returns one line. */
export const command = {
  beta: (value: number) => words("beta", value),
  fidelity: (alpha: number) => words("fidelity", alpha),
  preset: (preset: string, strength: number) => words("preset", preset, strength),
  openStrengths: () => "strengths open",
  chooseStrength: (picture: number) => words("strengths choose", picture),
  closeStrengths: () => "strengths close",
  presetKeep: (text: string) => words("preset_keep", name(text)),
  presetDelete: (text: string) => words("preset_delete", text),
  bands: bandsText,
  firstBands: () => "bands first",
  palette: paletteText,
  preview: (line: string) => "preview " + line,
  panel: (how: "preview" | "commit", value: number | string, place: string) => words("panel", how, value, place),

  curve: (text: string) => words("curve", text),
  plotGrab: (x: number, y: number, reachX: number, reachY: number) =>
    words("plot grab", x, y, reachX, reachY),
  plotTake: (point: number) => words("plot take", point),
  plotDrag: (x: number, y: number) => words("plot drag", x, y),
  plotDrop: () => "plot drop",
  plotRemove: (point: number) => words("plot remove", point),

  brush: (brush: Brush) =>
    words("brush", brush.radius, brush.strength, brush.beta, brush.fallOff satisfies FallOff, brush.paints) +
    (brush.through ? " through" : ""),
  brushDrag: (what: "radius" | "strength") => words("brush_drag", what),
  tool: (tool: Tool) => words("tool", tool),

  undo: () => "undo",
  redo: () => "redo",
  switchEntry: (entry: number, on: boolean) => words("switch", entry, onOff(on)),
  checkpoint: (text: string) => words("checkpoint", name(text)),
  restore: (text: string) => words("restore", name(text)),
  fork: (text: string) => words("fork", name(text)).trim(),
  role: (user: string, role: Role) => words("role", user, role),

  colour: (by: ColourBy) => words("colour", by),
  wireframe: (on: boolean) => words("wireframe", onOff(on)),
  split: (on: boolean) => words("split", onOff(on)),
  splitAt: (part: number) => words("split_at", part),
  original: (on: boolean) => words("original", onOff(on)),
  orthographic: (on: boolean) => words("orthographic", onOff(on)),
  view: (view: string) => words("view", view),
  frame: () => "frame",
  focus: () => "focus",
  turn: (azimuth: number, elevation: number) => words("turn", azimuth, elevation),
  bookmarkAdd: () => "bookmark add",
  lamp: (x: number, y: number) => words("lamp", x, y),
  lightDirection: (azimuth: number, elevation: number) => words("light_direction", azimuth, elevation),
  figures: (on: boolean) => words("figures", onOff(on)),
  over: (what: "protection" | "curves", on: boolean) => words("over", what, onOff(on)),
  unit: (text: string) => words("unit", name(text)).trim(),
  section: (what: "cut" | "close" | "save svg" | "save csv") => words("section", what),
  sectionHeights: (times: number) => words("section heights", times),
  rulerClear: () => "ruler clear",

  refresh: () => "library refresh",
  openScan: (id: string, anew = false) => words("scan open", id, ...(anew ? ["anew"] : [])),
  renameScan: (id: string, text: string) => words("scan rename", id, name(text)),
  deleteScan: (id: string) => words("scan delete", id),
  joinSession: (id: string) => words("session join", id),
  renameSession: (id: string, text: string) => words("session rename", id, name(text)),
  deleteSession: (id: string) => words("session delete", id),
  close: () => "close",
  depth: (depth: number) => words("depth", depth),
  cancelActivity: (activity: number) => words("activity cancel", activity),
  dismiss: (message: number) => words("message dismiss", message),
  exportMesh: (file: string, exact: boolean, record: boolean) =>
    words("export", fileName(file), ...(exact ? ["exact"] : []), ...(record ? ["record"] : [])),
  picture: (file: string) => words("picture", fileName(file)),
  record: (on: boolean) => (on ? "record start" : "record stop"),
  closeMenu: () => "menu close",
  cancel: () => "cancel",
};
