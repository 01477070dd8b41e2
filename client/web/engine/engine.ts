// The engine's worker: hosts the core, which has the model, and gives it a canvas, sockets, files and time.

import type { CoreMessage, StartMessage, ToPage, ToWorker } from "../page/src/protocol";
import { Calls } from "./calls";
import { compileCore } from "./core_module";
import type { CoreExports } from "./core_exports";
import { beginDrawing } from "./drawing";
import { Entries } from "./entries";
import { Files } from "./files";
import type { CallEvents, Transport } from "./heard";
import { Images } from "./images";
import { CoreMemory } from "./memory";
import { Pictures } from "./pictures";
import { PublishedCalls } from "./published/calls";
import { Store } from "./store";
import { Exit, wasi } from "./wasi";

const scope = self as unknown as {
  postMessage(message: ToPage): void;
  onmessage: ((event: MessageEvent<ToWorker>) => void) | null;
};

type ResizeMessage = Extract<ToWorker, { kind: "resize" }>;

const kLinesMax = 4;

/** One core with all that it needs. */
class Engine {
  private readonly memory = new CoreMemory();
  private readonly entries = new Entries((error) => this.stop(this.wordsOf(error)));
  private readonly pictures = new Pictures(() => this.tick());
  private readonly files = new Files(this.memory, (name, blob) => scope.postMessage({ kind: "download", name, blob }));
  private readonly store = new Store(this.memory, (key, text) => scope.postMessage({ kind: "keep", key, text }));
  private readonly images = new Images(this.memory, (image, rgba) =>
    this.entries.soon(() => this.handImage(image, rgba)),
  );
  private readonly calls: Transport;
  private readonly canvas: OffscreenCanvas;
  /** Of the next picture: a canvas of another size is empty, so both come together. */
  private resized: ResizeMessage | null = null;
  /** Takes the core from the page; null if the page could not have it. */
  takeCore: (module: WebAssembly.Module | null) => void = () => {};
  private readonly handed = new Promise<WebAssembly.Module | null>((resolve) => (this.takeCore = resolve));
  /** The last lines that the core wrote: a check that fails says why. */
  private readonly lines: string[] = [];

  constructor(private readonly start: StartMessage) {
    this.canvas = start.canvas;
    this.calls = this.transport();
    this.calls.setWho(start);
    this.store.fill(start.kept);
  }

  /** Returns what carries the core's calls: to the server of the page, or to the files of a publication. */
  private transport(): Transport {
    const { address, publication } = this.start;
    const events: CallEvents = {
      message: (call, bytes) =>
        this.entries.enter((core) => core.core_call_message(call, ...this.memory.give(bytes))),
      ended: (call, { code, message, details }) =>
        this.entries.enter((core) =>
          core.core_call_ended(call, code, ...this.memory.giveText(message), ...this.memory.give(details)),
        ),
    };
    const soon = (work: () => void) => this.entries.soon(work);
    if (!publication) return new Calls(address, events, soon);
    const checksum = (frame: Uint8Array) =>
      BigInt.asUintN(64, this.entries.enter((core) => core.core_frame_checksum(...this.memory.give(frame))) ?? 0n);
    return new PublishedCalls(publication, events, soon, checksum, (sentence) => this.stop(sentence));
  }

  /** Loads the core. The page hears of it by the core's first snapshot. */
  async load(): Promise<void> {
    this.setSize(this.start);
    const drawing = beginDrawing(this.start, this.memory, () => this.lose());
    if (!drawing) return scope.postMessage({ kind: "noCard" });
    const imports = {
      ...drawing.imports,
      host: { ...this.hostImports(), ...drawing.imports.host },
      wasi_snapshot_preview1: wasi(this.memory, (line) => this.write(line)),
    };
    const handed = this.start.handedCore === drawing.core ? await this.handed : null;
    const module = handed ?? (await compileCore(drawing.core));
    const instance = await WebAssembly.instantiate(module, imports);
    const exports = instance.exports as unknown as CoreExports;
    this.memory.bind(exports);
    this.entries.bind(exports);
    const { canvas: _canvas, core: _core, rasterCore: _raster, kept: _kept, publication: _files, handedCore: _handed, ...rest } = this.start;
    this.tell(rest);
    this.pictures.wake();
  }

  hear(message: Exclude<ToWorker, StartMessage | CoreMessage>): void {
    if (message.kind === "connect") this.calls.setWho(message);
    if (message.kind === "visible") this.pictures.setVisible(message.is);
    if (message.kind === "kept") return this.store.fill({ [message.key]: message.text });
    if (message.kind === "resize") this.resized = message;
    else if (message.kind === "import" || message.kind === "replay")
      this.tell({ ...message, file: this.files.add(message.file) });
    else this.tell(message);
    this.pictures.wake();
  }

  stop(message: string): void {
    this.entries.stop();
    this.pictures.forget();
    this.calls.close();
    scope.postMessage({ kind: "stopped", message });
    scope.onmessage = null;
  }

  /** Draws no more, but sends what waits for the server. Another engine goes on. */
  private lose(): void {
    this.pictures.setVisible(false);
    if (isLoaded) this.tell({ kind: "lost" });
    scope.postMessage({ kind: "lost" });
  }

  /** A size that is set empties the canvas, also the same one: then the core would see no reason to draw. */
  private setSize({ width, height }: { width: number; height: number }): void {
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
  }

  private handImage(image: number, rgba: Uint8ClampedArray | null): void {
    this.entries.enter((core) => core.core_image_decoded(image, rgba ? this.memory.give(rgba)[0] : 0));
  }

  private tell(message: object): void {
    this.entries.enter((core) => core.core_hear(...this.memory.giveText(JSON.stringify(message))));
  }

  private tick(): number {
    if (this.resized) {
      this.setSize(this.resized);
      this.tell(this.resized);
      this.resized = null;
    }
    return this.entries.enter((core) => core.core_tick(performance.now())) ?? Infinity;
  }

  private hostImports(): Record<string, WebAssembly.ImportValue> {
    const { memory, calls } = this;
    return {
      ...this.entries.imports(),
      ...this.files.imports(),
      ...this.images.imports(),
      ...this.store.imports(),
      say: (at: number, length: number) => scope.postMessage(JSON.parse(memory.text(at, length)) as ToPage),
      wake: () => this.pictures.wake(),
      call_open: (at: number, length: number, node: number, nodeLength: number) =>
        calls.open(memory.text(at, length), memory.text(node, nodeLength)),
      call_send: (call: number, at: number, length: number) => calls.send(call, memory.copy(at, length)),
      call_end: (call: number) => calls.end(call),
      call_cancel: (call: number) => calls.cancel(call),
      call_buffered: (call: number) => calls.buffered(call),
      call_pull: (call: number) => calls.pull(call),
      now_unix: () => Date.now() / 1000,
      random: () => crypto.getRandomValues(new Uint32Array(1))[0]! / 2 ** 32,
    };
  }

  private write(line: string): void {
    console.warn(line);
    this.lines.push(line);
    if (this.lines.length > kLinesMax) this.lines.shift();
  }

  private wordsOf(error: unknown): string {
    if (error instanceof Exit && this.lines.length === 0) return error.message;
    return [...this.lines, error instanceof Exit ? "" : String(error)].filter(Boolean).join("\n");
  }
}

let engine: Engine | null = null;
// Messages that come before the core is there.
const early: Exclude<ToWorker, StartMessage | CoreMessage>[] = [];
let isLoaded = false;

scope.onmessage = ({ data }) => {
  if (data.kind === "core") return engine?.takeCore(data.module);
  if (data.kind !== "start") return void (isLoaded ? engine?.hear(data) : early.push(data));
  const begun = (engine = new Engine(data));
  begun.load().then(
    () => {
      isLoaded = true;
      for (const message of early.splice(0)) begun.hear(message);
    },
    (error) => begun.stop(`the engine did not load: ${error instanceof Error ? error.message : error}`),
  );
};
