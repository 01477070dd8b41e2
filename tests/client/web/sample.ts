// A snapshot for tests: a server with two scans, and a session that shows every part of a panel.

import type { Guides } from "../../../client/web/page/src/protocol";
import type { Document, Library, SliderWidget, Snapshot } from "../../../client/web/page/src/snapshot";

const kNoon = 1_790_000_000;

export const library: Library = {
  state: "connected",
  server: "lab:7443",
  problem: "",
  wantsToken: false,
  serverMemory: 8e9,
  scans: [
    { id: "a1", name: "tablet", triangles: 20_000, closed: false, bytes: 4_200_000, imported: kNoon, unit: "mm", defaultDepth: 8 },
    { id: "b2", name: "portrait head", triangles: 1_204_000, closed: true, bytes: 98_000_000, imported: kNoon - 90_000, unit: "mm", defaultDepth: 9 },
  ],
  sessions: [
    { id: "s1", name: "inscription", scan: "a1", edits: 12, depth: 8, begun: kNoon, shown: kNoon + 60 },
    { id: "s2", name: "a name that is much longer than the card on which it stands", scan: "b2", edits: 1, depth: 9, begun: kNoon, shown: kNoon },
  ],
};

const slider = (name: string, hint: string, value: number, low: number, high: number): SliderWidget =>
  ({ kind: "slider", name, hint, value, low, high, scale: "linear", digits: 3 });

const line = Array.from({ length: 49 }, (_, i) => 0.63 + 0.2 * Math.sin(i / 8));

export const session: Document = {
  session: "inscription",
  sessionId: "s1",
  scan: "tablet",
  unit: "mm",
  depth: 8,
  depths: [
    { depth: 7, text: "depth 7: details from 1.2 mm", possible: true },
    { depth: 8, text: "depth 8: details from 0.6 mm", possible: true },
    { depth: 9, text: "needs 14 GB more", possible: false },
  ],
  cellSize: 0.6,
  diagonal: 150,
  lengthUnit: 43,
  box: { low: [-50, -50, -5], high: [50, 50, 5] },
  formats: ["zip", "ply", "obj", "stl", "glb"],
  closed: false,
  hasColours: true,
  link: "live",
  linkReason: "",
  moving: false,
  state: "settled",
  settled: true,
  unsavedEdits: 0,
  role: "owner",
  beta: 1,
  fidelity: 50,
  curve: {
    text: "-20:50,20:120",
    points: [
      { kappa: -20, alpha: 50, x: 0.2, y: 0.63 },
      { kappa: 20, alpha: 120, x: 0.8, y: 0.77 },
    ],
    line,
    dragged: -1,
    kappaRange: 200,
    alphaMax: 500,
    contrast: 2.4,
    histogram: Array.from({ length: 64 }, (_, i) => Math.exp(-(((i - 32) / 9) ** 2))),
  },
  keepsEdges: true,
  bands: [
    { size: 2, gain: 1, details: "finer than 2" },
    { size: 8, gain: 1.5, details: "2 to 8" },
  ],
  response: Array.from({ length: 97 }, (_, i) => 1 + 0.5 * Math.exp(-(((i - 40) / 14) ** 2))),
  palette: [{ name: "soft", colour: 0xd9534f, curve: "50" }],
  brush: { radius: 4, strength: 0.5, beta: 0, fallOff: "smooth", paints: "beta", through: false },
  tool: "paint",
  lasso: "off",
  panels: {
    "Keep edges": [
      { kind: "text", name: "Noise goes, edges stay, and what is sharpened is the surface without its noise." },
      {
        kind: "choice",
        name: "Kept edges",
        hint: "For reliefs and inscriptions",
        value: "relief",
        choices: [["off", "Off"], ["auto", "For this scan"], ["machined", "Machined part"], ["relief", "Relief and inscription"]],
      },
      slider("Strength of kept edges", "How much of the noise goes", 1, 0, 1),
      slider("Edge angle", "Degrees: sharper bends are edges, and stay", 35, 5, 120),
      { ...slider("Noise size", "Noise of up to about this length goes, in the scan's units.", 1, 0.5, 5), scale: "logarithmic" },
    ],
    Brush: [
      {
        kind: "row",
        columns: 3,
        widgets: [
          { kind: "button", name: "Smooth", pressed: true },
          { kind: "button", name: "Restore", pressed: false },
          { kind: "button", name: "Sharpen", pressed: false },
        ],
      },
      { kind: "choice", name: "Paints", labelled: true, value: "beta", choices: [["beta", "Gradient scale β"], ["edges", "Strength of kept edges"], ["band:2", "Gain of 2 to 8"]] },
      { ...slider("Painted β", "", 0, 0, 10), scale: "beta" },
      { ...slider("Radius", "", 4, 0.015, 75), scale: "logarithmic", note: "in the scan's units" },
      { ...slider("Strength", "", 0.5, 0.01, 1), digits: 0 },
      { kind: "check", name: "Pen pressure", hint: "The harder the pen presses, the stronger the brush.", on: true },
      { kind: "choice", name: "Fall-off", labelled: true, value: "smooth", choices: [["smooth", "Smooth"], ["sharp", "Sharp"]] },
      { kind: "check", name: "Through walls", on: false },
      { kind: "choice", name: "Mirror", labelled: true, value: "off", choices: [["off", "Off"], ["x", "Across x"]] },
      { ...slider("Mirror plane", "", 0, -50, 50), digits: 4, untitled: true },
    ],
    Limits: [
      {
        kind: "row",
        columns: 2,
        widgets: [
          { kind: "check", name: "Rims stay", hint: "The rims of an open scan stay where they are.", on: true },
          { kind: "check", name: "Volume stays", disabled: true, on: false },
        ],
      },
      { kind: "text", name: "rims: 3 of 5 stay", hint: "The others are small holes, or run over another piece" },
      { kind: "text", name: "Walls: 24 % of the surface is thinner than a cell; an edit of one side moves the other." },
      { ...slider("Largest move", "No point of the surface moves farther.", 150, 1.5e-4, 150), scale: "logarithmic", note: "at the right: any" },
      {
        kind: "row",
        columns: 3,
        widgets: [
          { kind: "button", name: "Protect", pressed: false },
          { kind: "button", name: "Release", pressed: true },
          { kind: "check", name: "Through", on: false },
        ],
      },
      {
        kind: "row",
        columns: 3,
        widgets: [
          { kind: "button", name: "Grow" },
          { kind: "button", name: "Shrink" },
          { kind: "button", name: "Invert" },
        ],
      },
      {
        kind: "row",
        columns: 3,
        widgets: [
          { kind: "button", name: "Piece" },
          { kind: "button", name: "Clear" },
        ],
      },
      { kind: "text", name: "the protected region is hatched", announced: true },
    ],
    View: [
      { kind: "choice", name: "Colour", value: "clay", choices: [["clay", "Clay"], ["displacement", "Displacement"]] },
      {
        kind: "row",
        columns: 2,
        widgets: [
          { kind: "check", name: "Flat", hint: "Gives each triangle one shade.", on: false },
          { kind: "check", name: "Wireframe", on: false },
        ],
      },
      { ...slider("Place of the split", "", 0.5, 0.05, 0.95), digits: 0, untitled: true },
      {
        kind: "row",
        columns: 2,
        widgets: [
          { kind: "button", name: "Frame all" },
          { kind: "button", name: "Bookmark" },
        ],
      },
      {
        kind: "row",
        columns: 6,
        widgets: [
          { kind: "button", name: "Bookmark 1", label: "1" },
          { kind: "button", name: "Bookmark 2", label: "2" },
        ],
      },
      { kind: "text", name: "all 20 k triangles shown" },
    ],
    Camera: [
      { kind: "choice", name: "Up", hint: "The scan's axis that points up.", labelled: true, value: "z", choices: [["x", "x"], ["z", "z"], ["-z", "-z"]] },
      { kind: "row", columns: 3, widgets: ["Front", "Back", "Right"].map((name) => ({ kind: "button", name })) },
      { kind: "row", columns: 3, widgets: ["Left", "Top", "Bottom"].map((name) => ({ kind: "button", name })) },
      { kind: "check", name: "Orthographic", on: false },
    ],
    Light: [
      { kind: "choice", name: "Light", hint: "A lamp, the sky and a weak second lamp.", value: "clay", choices: [["clay", "Clay"], ["raking", "Raking light"]] },
      { kind: "lamp", name: "Lamp", azimuth: 137, elevation: 25, ballX: -0.5, ballY: 0.5 },
      { ...slider("Occlusion", "", 0, 0, 1), digits: 0 },
      { kind: "button", name: "As at first" },
    ],
    Colours: [
      { kind: "button", name: "Show colours" },
      { ...slider("Gradient scale of colours", "Left evens the colours out.", 1, 0, 10), scale: "beta" },
      { kind: "button", name: "Keep colours", hint: "Sets the gradient scale to 1. Painted colours stay painted." },
      { ...slider("Texture gain", "Left fades them, right makes them stronger", 1, 0, 4), digits: 0 },
    ],
  },
  history: [
    { number: 4, kind: "edit", enabled: true, name: "Smooth stroke", details: "radius 4.69 mm, β 0, 12 points", author: "mia", time: kNoon, superseded: false },
    { number: 3, kind: "checkpoint", enabled: true, name: "before carving", details: "", author: "ole", time: kNoon, superseded: false },
    { number: 2, kind: "edit", enabled: false, name: "Gradient scale 3", details: "", author: "ole", time: kNoon, superseded: false },
    { number: 1, kind: "checkpoint", enabled: true, name: "before carving", details: "", author: "ole", time: kNoon, superseded: true },
  ],
  undoHint: "Takes back your last edit, not those of others: Smooth stroke.",
  redoHint: "Makes the edit again that you took back.",
  undoName: "Smooth stroke",
  redoName: "",
  people: [
    { connection: 1, user: "ole", colour: 0xd9534f, role: "owner", me: true },
    { connection: 2, user: "mia", colour: 0x4a7fd0, role: "editor", me: false },
  ],
  view: {
    colour: "clay",
    wireframe: false,
    split: false,
    splitAt: 0.5,
    original: false,
    orthographic: false,
    status: "all 20 k triangles shown",
  },
  scale: { title: "displacement", low: "-0.6 mm", middle: "0", high: "0.6 mm", part: 0.3, value: "0.18 mm" },
  numbers: {
    deviation: [
      { name: "largest move", value: "0.42 mm" },
      { name: "mean", value: "0.03 mm" },
    ],
    current: true,
    histogram: Array.from({ length: 32 }, (_, i) => Math.exp(-(((i - 16) / 4) ** 2))),
    range: "0.5 mm",
    rulerPoints: 2,
    ruler: [{ name: "distance", value: "12.1 mm" }],
  },
  over: { lasso: [], ruler: [], rulerLength: "", menu: null },
  section: null,
  figures: [
    { name: "residual", value: "3.1e-07" },
    { name: "distance", value: "2.0e-05 of the diagonal" },
    { name: "cycles", value: "9 (CPU)" },
    { name: "server", value: "1.0 + 4.2 + 0.8 ms" },
    { name: "frame age", value: "12 ms" },
    { name: "round trip", value: "1.0 ms" },
    { name: "frames", value: "42/s, 8.1 Mbit/s" },
  ],
};

export const snapshot: Snapshot = {
  library,
  activities: [],
  messages: [],
  presets: [
    { name: "Reduce scanner noise", description: "Smooths the ripple of a few cells that scanners leave", changes: true, own: false },
    { name: "Sharpen all", description: "Enhances detail everywhere", changes: true, own: false },
  ],
  preset: null,
  strengths: null,
  about: [
    { title: "Version", text: "Burnish 0.1.0" },
    { title: "Licence", text: "MIT License" },
    { title: "Manual", text: "docs/window.md and docs/web.md in the source" },
  ],
  recording: false,
  opening: "",
  document: null,
};

const axis = (name: string, x: number, y: number, pointed = false) => ({ name, x, y, pointed });

export const guides: Guides = {
  bar: { text: "20 mm", pixels: 120 },
  axes: {
    middle: 50,
    radius: 42,
    endRadius: 9,
    ends: [
      axis("-z", 63, 57), axis("-x", 21, 44), axis("-y", 50, 80, true),
      axis("x", 79, 56), axis("y", 50, 20), axis("z", 37, 43),
    ],
  },
};
