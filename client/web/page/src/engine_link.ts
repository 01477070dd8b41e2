// The page's side of the engine's worker.

import type { PublicationStart } from "../../engine/published/calls";
import { keptTexts, textsOfTab } from "./browser_store";
import { command } from "./commands";
import type { Message, Snapshot } from "./snapshot";
import type { Guides, Pictures, PointerMessage, ToPage, ToWorker } from "./protocol";

/** A Worker, or what stands for one in tests. */
export interface EnginePort {
  postMessage(message: ToWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToPage>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

/** The state that the page shows. A new object for each change. */
export interface PageState {
  snapshot: Snapshot | null;
  /** Refused commands, as messages of the page's own. */
  refusals: Message[];
  /** Why the engine stopped; empty while it runs. */
  stopped: string;
  /** Counts the starts: each needs a new canvas. */
  starts: number;
}

const kRefusalsMax = 5;
const kNoEngine =
  "The engine did not load: the web server does not send assets/engine.js, or does not send it as JavaScript.";
const kNoGuides: Guides = { bar: null, axes: null };
const kStrengthsMax = 3; // pictures of a strip
const kName = "burnish.name";
const kUser = "burnish.user";
const kToken = "burnish.token";
const kKept = "burnish.kept.";
const kLossesMax = 3; // of graphics contexts: then the card is left alone until the page is loaded again

/** Addresses of what an engine loads, and who draws. */
export interface EngineParts {
  core: string;
  rasterCore: string;
  handedCore: string;
  pictures: Pictures;
  publication: PublicationStart | null;
}

/** Keeps the state, and talks with one worker at a time. */
export class EngineLink {
  state: PageState = { snapshot: null, refusals: [], stopped: "", starts: 0 };
  onchange: () => void = () => {};
  /** Changes with each picture while the view moves, so it is no part of the state. */
  guides: Guides = kNoGuides;
  onguides: () => void = () => {};
  /** Addresses of the last small pictures of strengths, by number. */
  private readonly strengths = new Map<number, string>();
  private port: EnginePort | null = null;
  private refused = 0;
  private losses = 0;
  private isLost = false;
  /** The session that the next engine opens; empty: none, or it is open. */
  private wanted: string;
  private isJoining = false;
  private hasSaidRoom = false;

  constructor(
    private readonly makePort: () => EnginePort,
    private readonly parts: EngineParts,
    /** That of `parts.handedCore`; null if the page could not have it. */
    private readonly core?: Promise<WebAssembly.Module | null>,
  ) {
    this.wanted = parts.publication?.scan.record.session_id ?? "";
  }

  /** Hears what other pages of this browser keep, so that none overwrites it. Returns a function that stops. */
  listen(): () => void {
    const hear = ({ key, newValue }: StorageEvent) => {
      if (key?.startsWith(kKept)) this.post({ kind: "kept", key: key.slice(kKept.length), text: newValue ?? "" });
    };
    addEventListener("storage", hear);
    return () => removeEventListener("storage", hear);
  }

  /** Takes the canvas for good. */
  start(canvas: HTMLCanvasElement, width: number, height: number): void {
    this.port?.terminate();
    const port = this.makePort();
    port.onmessage = (event) => this.take(event.data);
    port.onerror = (event) => this.stop(event.message || kNoEngine);
    this.port = port;
    const offscreen = canvas.transferControlToOffscreen();
    const size = { width, height, pixelRatio: devicePixelRatio };
    const known = this.parts.publication ? kNothingKept : keptByBrowser();
    port.postMessage(
      { kind: "start", canvas: offscreen, ...size, address: location.origin, ...known, ...this.parts },
      [offscreen],
    );
    void this.core?.then((module) => port.postMessage({ kind: "core", module }));
  }

  startAgain(): void {
    this.change({ stopped: "", snapshot: null, starts: this.state.starts + 1 });
  }

  /** Lets another engine go on in the session. The panels stay, as those of a session that connects. */
  private goOn(): void {
    this.leaveEngine();
    const { snapshot, starts } = this.state;
    const document = snapshot?.document && { ...snapshot.document, link: "connecting" as const };
    this.change({ snapshot: snapshot && { ...snapshot, document: document ?? null }, starts: starts + 1 });
  }

  private leaveEngine(): void {
    this.port?.terminate();
    this.port = null;
    this.wanted = this.state.snapshot?.document?.sessionId ?? this.wanted;
    this.isJoining = this.isLost = false;
  }

  send(line: string): void {
    this.post({ kind: "command", line });
  }

  point(event: Omit<PointerMessage, "kind">): void {
    this.post({ kind: "pointer", ...event });
  }

  post(message: ToWorker): void {
    this.port?.postMessage(message);
  }

  /** Keeps user and token for this tab alone. */
  connect(user: string, token: string): void {
    textsOfTab.set(kUser, user);
    textsOfTab.set(kToken, token);
    this.post({ kind: "connect", user, token });
  }

  user(): string {
    return textsOfTab.get(kUser) ?? "";
  }

  /** Whether the user has proved who they are in this tab. */
  hasToken(): boolean {
    return (textsOfTab.get(kToken) ?? "") !== "";
  }

  /** The name that stands beside the user's edits where no token tells it; empty: none. */
  ownName(): string {
    return keptTexts.get(kName) ?? "";
  }

  takeName(name: string): void {
    if (name === "") keptTexts.remove(kName);
    else keptTexts.set(kName, name);
    textsOfTab.remove(kUser);
    this.post({ kind: "connect", user: name, token: "" });
    this.change({});
  }

  /** Dismisses a message. Negative numbers are refusals. */
  dismiss(number: number): void {
    if (number >= 0) return this.send(`message dismiss ${number}`);
    this.change({ refusals: this.state.refusals.filter((one) => one.number !== number) });
  }

  refuse(text: string): void {
    this.tell(text, "error");
  }

  /** Says something as a message of the page's own. */
  tell(text: string, severity: Message["severity"] = "info"): void {
    const refusal: Message = {
      number: -++this.refused,
      severity,
      text,
      time: Date.now() / 1000,
    };
    this.change({ refusals: [...this.state.refusals, refusal].slice(-kRefusalsMax) });
  }

  private take(message: ToPage): void {
    if (message.kind === "snapshot") this.show(message.snapshot);
    if (message.kind === "guides") this.showGuides(message);
    if (message.kind === "answer") this.refuse(message.message);
    if (message.kind === "download") download(message.name, message.blob);
    if (message.kind === "keep") this.keep(message.key, message.text);
    if (message.kind === "strength") this.keepStrength(message.number, message.address);
    if (message.kind === "stopped") this.stop(message.message);
    if (message.kind === "noCard") this.leaveCard();
    if (message.kind === "lost") this.lose();
  }

  private showGuides(guides: Guides): void {
    this.guides = guides;
    this.onguides();
  }

  /** Returns a text that an engine has kept; empty: none. */
  kept(key: string): string {
    return keptTexts.get(kKept + key) ?? "";
  }

  /** Returns the address of a small picture of a strength; empty: it is not there. */
  strengthPicture(number: number): string {
    return this.strengths.get(number) ?? "";
  }

  private keepStrength(number: number, address: string): void {
    this.strengths.set(number, address);
    const oldest = [...this.strengths.keys()].slice(0, -kStrengthsMax);
    for (const one of oldest) this.strengths.delete(one);
    this.change({});
  }

  private keep(key: string, text: string): void {
    if (this.parts.publication) return;
    if (text === "") keptTexts.remove(kKept + key);
    else if (!keptTexts.set(kKept + key, text) && !this.hasSaidRoom) {
      this.hasSaidRoom = true;
      this.refuse("the browser keeps no more for this page: its room is full, or it is not allowed");
    }
    this.change({});
  }

  /** Opens a session once the server's list has it. Until then the start page is there. */
  want(session: string): void {
    this.wanted = session;
  }

  private show(snapshot: Snapshot): void {
    const isKept = this.parts.publication !== null || this.state.snapshot?.document;
    if (snapshot.document) this.wanted = "";
    else if (this.wanted && this.awaitsSession(snapshot) && isKept) return;
    this.change({ snapshot });
    if (this.isLost) this.goOnWhenSent();
  }

  /** Opens the wanted session once the list has it. Returns whether it may still come. */
  private awaitsSession({ library, activities }: Snapshot): boolean {
    if (library.state === "failed") return false;
    if (library.sessions.length === 0) return true; // the list comes after the connection
    if (this.isJoining) return activities.length > 0;
    this.isJoining = library.sessions.some((one) => one.id === this.wanted);
    if (this.isJoining) this.send(command.joinSession(this.wanted));
    else this.forgetWanted();
    return this.isJoining;
  }

  private forgetWanted(): void {
    this.wanted = "";
    this.refuse("the server has no such session any more");
  }

  private stop(message: string): void {
    this.leaveEngine();
    this.change({ stopped: message });
  }

  /** Leaves the graphics card alone from now on. */
  private leaveCard(): void {
    this.parts.pictures = "processor";
    this.goOn();
  }

  private lose(): void {
    this.isLost = true;
    if (++this.losses > kLossesMax) this.parts.pictures = "processor";
    this.goOnWhenSent();
  }

  /** The old engine alone has the edits that wait for the server. */
  private goOnWhenSent(): void {
    if (!this.state.snapshot?.document?.unsavedEdits) this.goOn();
  }

  private change(change: Partial<PageState>): void {
    this.state = { ...this.state, ...change };
    this.onchange();
  }
}

/** A publication keeps nothing: its neighbours have the same address, and frames of other pages may not. */
const kNothingKept = { user: "", token: "", kept: {} };

function keptByBrowser(): typeof kNothingKept {
  const keys = keptTexts.keys(kKept);
  return {
    user: textsOfTab.get(kUser) ?? keptTexts.get(kName) ?? "",
    token: textsOfTab.get(kToken) ?? "",
    kept: Object.fromEntries(keys.map((key) => [key.slice(kKept.length), keptTexts.get(key)!])),
  };
}

function download(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  const kKeptMs = 60_000; // the browser reads the address after the click
  setTimeout(() => URL.revokeObjectURL(link.href), kKeptMs);
}
