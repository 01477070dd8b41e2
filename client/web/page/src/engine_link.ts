// The page's side of the engine's worker.

import type { Message, Snapshot } from "./snapshot";
import type { PointerMessage, ToPage, ToWorker } from "./protocol";

/** A Worker, or what stands for one in tests. */
export interface EnginePort {
  postMessage(message: ToWorker, transfer?: Transferable[]): void;
  onmessage: ((event: MessageEvent<ToPage>) => void) | null;
  onerror: ((event: ErrorEvent) => void) | null;
  terminate(): void;
}

/** What the page shows. A new object for each change. */
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
const kUser = "burnish.user";
const kToken = "burnish.token";

/** Keeps the state, and talks with one worker at a time. */
export class EngineLink {
  state: PageState = { snapshot: null, refusals: [], stopped: "", starts: 0 };
  onchange: () => void = () => {};
  private port: EnginePort | null = null;
  private refused = 0;

  constructor(private readonly makePort: () => EnginePort) {}

  /** Takes the canvas for good. */
  start(canvas: HTMLCanvasElement, width: number, height: number): void {
    this.port?.terminate();
    const port = this.makePort();
    port.onmessage = (event) => this.take(event.data);
    port.onerror = (event) => this.stop(event.message || "the engine did not load");
    this.port = port;
    const offscreen = canvas.transferControlToOffscreen();
    const user = sessionStorage.getItem(kUser) ?? "";
    const token = sessionStorage.getItem(kToken) ?? "";
    const size = { width, height, pixelRatio: devicePixelRatio };
    port.postMessage(
      { kind: "start", canvas: offscreen, ...size, address: location.origin, user, token },
      [offscreen],
    );
  }

  startAgain(): void {
    this.change({ stopped: "", snapshot: null, starts: this.state.starts + 1 });
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
    sessionStorage.setItem(kUser, user);
    sessionStorage.setItem(kToken, token);
    this.post({ kind: "connect", user, token });
  }

  user(): string {
    return sessionStorage.getItem(kUser) ?? "";
  }

  /** Dismisses a message. Negative numbers are refusals. */
  dismiss(number: number): void {
    if (number >= 0) return this.send(`message dismiss ${number}`);
    this.change({ refusals: this.state.refusals.filter((one) => one.number !== number) });
  }

  refuse(text: string): void {
    const refusal: Message = {
      number: -++this.refused,
      severity: "error",
      text,
      time: Date.now() / 1000,
    };
    this.change({ refusals: [...this.state.refusals, refusal].slice(-kRefusalsMax) });
  }

  private take(message: ToPage): void {
    if (message.kind === "snapshot") this.change({ snapshot: message.snapshot });
    if (message.kind === "answer") this.refuse(message.message);
    if (message.kind === "download") download(message.name, message.blob);
    if (message.kind === "stopped") this.stop(message.message);
  }

  private stop(message: string): void {
    this.port?.terminate();
    this.port = null;
    this.change({ stopped: message });
  }

  private change(change: Partial<PageState>): void {
    this.state = { ...this.state, ...change };
    this.onchange();
  }
}

function download(name: string, blob: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  const kKeptMs = 60_000; // the browser reads the address after the click
  setTimeout(() => URL.revokeObjectURL(link.href), kKeptMs);
}
