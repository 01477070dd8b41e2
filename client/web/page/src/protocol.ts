// The messages between the page and the engine's worker.

import type { PublicationStart } from "../../engine/published/calls";
import type { Snapshot } from "./snapshot";

export type PointerWhat = "press" | "move" | "release" | "leave" | "wheel" | "pinch";

/** Modifier keys, added up. */
export const Modifier = { shift: 1, control: 2, alt: 4 } as const;

/** An event over the picture. Places are in pixels of the picture, from its upper left corner. */
export interface PointerMessage {
  kind: "pointer";
  what: PointerWhat;
  x: number;
  y: number;
  /** 0 left, 1 middle, 2 right: as in PointerEvent. */
  button: number;
  /** Sum of Modifier. */
  modifiers: number;
  /** 0 to 1; 1 for what has no pressure. */
  pressure: number;
  /** True for a pen. */
  pen: boolean;
  /** wheel: steps, positive away from the user. pinch: the ratio of the fingers' distances. */
  delta: number;
}

export type Pictures = "best" | "card" | "processor";

/** Begins, or begins again after `stopped`. Sent once with each canvas. */
export interface StartMessage {
  kind: "start";
  canvas: OffscreenCanvas;
  /** Pixels of the picture, not of CSS. */
  width: number;
  height: number;
  pixelRatio: number;
  /** Origin of the page, e.g. "https://workstation:7443". */
  address: string;
  /** Empty if the user has given none. */
  user: string;
  token: string;
  /** Addresses of core.wasm, which draws with the graphics card, and core_raster.wasm, which needs none. */
  core: string;
  rasterCore: string;
  /** The one of both that the page hands over by a CoreMessage; empty: neither. */
  handedCore: string;
  /** Who draws. `best`: the card if there is one. */
  pictures: Pictures;
  /** The files that are shown where there is no server; null: the page's server. */
  publication: PublicationStart | null;
  /** The contents of `keep` messages of earlier engines. */
  kept: Record<string, string>;
}

/** Hands over a core that the page had while the engine's script came; null: the engine must fetch it. */
export interface CoreMessage {
  kind: "core";
  module: WebAssembly.Module | null;
}

export type ToWorker =
  | StartMessage
  | CoreMessage
  | PointerMessage
  /** Connects anew with another user or token. */
  | { kind: "connect"; user: string; token: string }
  /** A line of commands.ts. */
  | { kind: "command"; line: string }
  | { kind: "resize"; width: number; height: number; pixelRatio: number }
  /** Imports a mesh file and opens it. */
  | { kind: "import"; file: File }
  /** Runs a recorded script, line after line. Its first error ends it and becomes a message. */
  | { kind: "replay"; file: File }
  /** Another page of this browser has kept a text. */
  | { kind: "kept"; key: string; text: string }
  /** A page that is not seen needs no pictures. */
  | { kind: "visible"; is: boolean };

/** What lies over the picture and follows the camera. Lengths are in pixels of the picture. */
export interface Guides {
  /** Null: it is off. */
  bar: { text: string; pixels: number } | null;
  /** Null: they are off, or have no room. */
  axes: Axes | null;
}

/** The scan's axes, in the picture's upper left corner. The core takes what the pointer does there. */
export interface Axes {
  /** From both edges of the picture. */
  middle: number;
  radius: number;
  endRadius: number;
  /** The farthest first. */
  ends: AxisEnd[];
}

export interface AxisEnd {
  /** "x", "y", "z", "-x", "-y" or "-z". */
  name: string;
  pointed: boolean;
  x: number;
  y: number;
}

export type ToPage =
  | { kind: "snapshot"; snapshot: Snapshot }
  | ({ kind: "guides" } & Guides)
  /** A command was refused; `message` has the core's words. */
  | { kind: "answer"; line: string; message: string }
  /** A file that the user asked for: an export, a picture or a script. */
  | { kind: "download"; name: string; blob: Blob }
  /** The engine has stopped and answers no more. */
  | { kind: "stopped"; message: string }
  /** The browser took the graphics context away. This engine draws no more, but sends its edits. */
  | { kind: "lost" }
  /** There is no graphics card, as the engine knows now. An engine with `processor` can draw in another canvas. */
  | { kind: "noCard" }
  /** A small text that outlives the page. */
  | { kind: "keep"; key: string; text: string }
  /** The small picture of a strength, as the address of an image. */
  | { kind: "strength"; number: number; address: string }
  /** Pictures drawn so far. */
  | { kind: "drawn"; count: number };
