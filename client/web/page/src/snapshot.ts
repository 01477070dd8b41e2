// The model's state as the page shows it. The core writes it as JSON (client/web/core/snapshot.cpp).
// Lengths are in the scan's units, times in Unix seconds, empty texts mean "none".

export interface Snapshot {
  library: Library;
  activities: Activity[];
  /** Oldest first, without the dismissed ones. */
  messages: Message[];
  presets: Preset[];
  /** The preset that the open session's values are of; null if they are of none. */
  preset: PresetInForce | null;
  /** Pictures of strengths to choose from; null: the user has not asked for them. */
  strengths: Strengths | null;
  /** Version, licence, places of the documents. */
  about: AboutText[];
  /** Commands are being written to a script. */
  recording: boolean;
  /** The scan of which a coarse picture is shown until its session is open. */
  opening: string;
  /** The session that is open; null on the start page and while one opens. */
  document: Document | null;
}

export interface AboutText {
  title: string;
  text: string;
}

export interface Library {
  state: "unconnected" | "connecting" | "connected" | "failed";
  server: string;
  /** The reason of "failed". */
  problem: string;
  /** The server refused the user: it wants a token or another one. */
  wantsToken: boolean;
  scans: Scan[];
  sessions: Session[];
  /** Bytes; 0 if the server does not tell. */
  serverMemory: number;
}

export interface Scan {
  id: string;
  name: string;
  triangles: number;
  closed: boolean;
  bytes: number;
  imported: number;
  unit: string;
  defaultDepth: number;
}

export interface Session {
  id: string;
  name: string;
  scan: string;
  edits: number;
  depth: number;
  begun: number;
  /** When this browser showed it last; 0: never. */
  shown: number;
}

export interface Activity {
  number: number;
  title: string;
  phase: string;
  /** 0 to 1. */
  fraction: number;
  /** Of the whole; -1 if not known. */
  secondsLeft: number;
  /** It writes a file, which is lost if the page is closed. */
  makesFile: boolean;
}

export interface Message {
  number: number;
  severity: "info" | "warning" | "error";
  text: string;
  time: number;
}

export interface Preset {
  name: string;
  /** Its purpose, and what it does to the waves of the open session's scan. */
  description: string;
  /** It does something, so it has a strength. */
  changes: boolean;
  /** The user has made it; the browser keeps it. */
  own: boolean;
}

export interface PresetInForce {
  name: string;
  /** Above 0 to 1; 0 while a drag passes it. */
  strength: number;
  /** "a little", "half", "most", "all". */
  word: string;
  /** Its strengths can be compared by pictures. */
  hasTrial: boolean;
}

export interface Strengths {
  /** Name of the preset. */
  preset: string;
  /** The picture shows something else than the session's values: "trying strength 0.33". */
  trial: string;
  /** Three, by strength. */
  pictures: StrengthPicture[];
}

export interface StrengthPicture {
  strength: number;
  word: string;
  /** Number of the `strength` message that has the picture; 0: it is not there yet. */
  number: number;
}

export interface CurvePoint {
  kappa: number;
  alpha: number;
  /** Place in the plot, 0 to 1; y upwards. */
  x: number;
  y: number;
}

export interface Curve {
  /** "K:A,K:A,..." or one alpha. */
  text: string;
  points: CurvePoint[];
  /** Heights of the drawn line at even places, 0 to 1. */
  line: number[];
  /** Number of the point that is being dragged; -1: none. */
  dragged: number;
  kappaRange: number;
  alphaMax: number;
  contrast: number;
  /** Bars, any scale. */
  histogram: number[];
}

export interface Band {
  size: number;
  gain: number;
  /** "finer than 0.8". */
  details: string;
}

export type FallOff = "smooth" | "linear" | "sharp" | "constant";

export interface Brush {
  radius: number;
  strength: number;
  beta: number;
  fallOff: FallOff;
  /** "beta", "edges", "colour", "texture", "band:2" or "curve:1". */
  paints: string;
  /** Paints through thin walls too. */
  through: boolean;
}

export type ColourBy = "clay" | "beta" | "curvature" | "displacement" | "scan";
export type Role = "viewer" | "editor" | "owner";
export type Tool = "paint" | "look" | "measure";
export type Lasso = "off" | "protect" | "release";

export interface HistoryEntry {
  number: number;
  kind: "edit" | "checkpoint" | "damaged";
  enabled: boolean;
  /** "Smooth stroke"; a checkpoint's name. */
  name: string;
  /** "radius 4.69 mm, β 0, ..."; empty: the name says all. */
  details: string;
  author: string;
  time: number;
  /** A checkpoint whose name was set again later. */
  superseded: boolean;
}

export interface Person {
  connection: number;
  user: string;
  /** 0xRRGGBB, of the ring. */
  colour: number;
  role: Role;
  me: boolean;
}

export interface View {
  colour: ColourBy;
  wireframe: boolean;
  split: boolean;
  /** Part of the picture's width that shows the original. */
  splitAt: number;
  original: boolean;
  orthographic: boolean;
  /** Loading state of the surface in words. */
  status: string;
}

interface UsableWidget {
  /** Unique in its panel. */
  name: string;
  hint?: string;
  disabled?: boolean;
}

export interface SliderWidget extends UsableWidget {
  kind: "slider";
  value: number;
  low: number;
  high: number;
  scale: "linear" | "logarithmic" | "beta";
  /** Of the number; 0: two decimals. */
  digits: number;
  untitled?: boolean;
  /** Behind the title. */
  note?: string;
}

export interface LampWidget extends UsableWidget {
  kind: "lamp";
  azimuth: number;
  elevation: number;
  /** The lamp on the ball, -1 to 1; y upwards. */
  ballX: number;
  ballY: number;
}

/** A part of a panel (client/panels/widgets.h). A text is its own name. */
export type Widget =
  | { kind: "row"; columns: number; widgets: Widget[] }
  | SliderWidget
  | LampWidget
  | (UsableWidget & { kind: "text"; announced?: boolean })
  | (UsableWidget & { kind: "button"; label?: string; pressed?: boolean })
  | (UsableWidget & { kind: "check"; on: boolean })
  | (UsableWidget & { kind: "choice"; labelled?: boolean; value: string; choices: [string, string][] });

/** The meaning of the picture's colours. */
export interface ColourScale {
  title: string;
  low: string;
  middle: string;
  high: string;
  /** Of the pointer, -1 to 1. */
  part: number;
  value: string;
}

/** A name and a value, both to be shown as they are. */
export interface Figure {
  name: string;
  value: string;
}

export interface Numbers {
  /** Empty until the surface has settled. */
  deviation: Figure[];
  /** They are of the surface that is shown, and not of one before. */
  current: boolean;
  /** Areas by move along the normal, inwards first. */
  histogram: number[];
  range: string;
  /** How many points of the ruler are set: 0, 1 or 2. */
  rulerPoints: number;
  ruler: Figure[];
}

/** Lines over the picture. Places are x, y, x, y, ... in pixels of the picture. */
export interface Over {
  /** The line that is being drawn. */
  lasso: number[];
  /** The ruler's ends. */
  ruler: number[];
  /** Empty before the second end. */
  rulerLength: string;
  /** A click of the right button asks for a menu there. `position`: "12.3 4.5 6.7"; empty: beside the surface. */
  menu: { place: number[]; position: string } | null;
}

/** A cut along the ruler. */
export interface Section {
  /** The server has cut it. */
  ready: boolean;
  /** Paths of SVG; the ruler lies level and is 10,000 long, y downwards. */
  original: string;
  edited: string;
  /** Heights are drawn so many times larger than ways. */
  exaggeration: number;
  /** Numbers of both axes. */
  ways: AxisNumber[];
  heights: AxisNumber[];
}

export interface AxisNumber {
  /** In the units of the paths. Heights count upwards, and are not exaggerated. */
  at: number;
  text: string;
}

export interface DepthChoice {
  depth: number;
  text: string;
  possible: boolean;
}

export interface Document {
  session: string;
  sessionId: string;
  scan: string;
  unit: string;
  depth: number;
  depths: DepthChoice[];
  cellSize: number;
  diagonal: number;
  /** L of the scan; the wavelength of alpha is 2 pi L / alpha. */
  lengthUnit: number;
  box: { low: [number, number, number]; high: [number, number, number] };
  /** In which the scan can be exported, its own first: "ply". */
  formats: string[];
  closed: boolean;
  hasColours: boolean;
  link: "connecting" | "live" | "lost" | "ended";
  linkReason: string;
  /** "lost" is short: the session goes on at another server. */
  moving: boolean;
  /** "converging", "settled", "exact", "saving", "trying a strength" or "waiting for the first frame". */
  state: string;
  settled: boolean;
  unsavedEdits: number;
  role: Role;

  beta: number;
  fidelity: number;
  curve: Curve;
  keepsEdges: boolean;
  bands: Band[];
  /** By how much waves are multiplied, from two cells to the diagonal, evenly in log length. */
  response: number[];
  palette: { name: string; colour: number; curve: string }[];
  brush: Brush;
  tool: Tool;
  lasso: Lasso;

  /** By name. */
  panels: Record<string, Widget[]>;

  /** Newest first. */
  history: HistoryEntry[];
  undoHint: string;
  redoHint: string;
  /** The step that the button takes back or makes again; empty: not known, or none. */
  undoName: string;
  redoName: string;
  people: Person[];
  view: View;
  scale: ColourScale | null;
  numbers: Numbers;
  over: Over;
  /** Null: none was asked for. */
  section: Section | null;
  /** Figures of frames and link, in the order of the window. */
  figures: Figure[];
}
