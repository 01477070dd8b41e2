// Calls of the core, answered by a publication's files in place of a server: docs/decisions/84.

import { Heard, type CallEvents, type Transport } from "../heard";
import type { FrameChecksum } from "./frames";
import { fieldsOf, type Fields } from "./messages";
import { Parts, Useless } from "./parts";
import { fromBase64, type PublishedScan } from "./scan";
import { PublishedStream, pagesOfRequest, sheetsOfRequest } from "./stream";

const kEdit = "burnish.v1.Editing/Edit";
const kFetchPages = "burnish.v1.Library/FetchPages";
const kFetchSheets = "burnish.v1.Library/FetchSheets";

const kOk = 0;
const kCancelled = 1;
const kUnimplemented = 12;
const kUnavailable = 14;

interface PublishedCall {
  method: string;
  /** Of the live session. */
  stream: PublishedStream | null;
  abort: AbortController;
}

/** A publication as the page hands it to the engine. */
export interface PublicationStart {
  scan: PublishedScan;
  /** Address of its folder. */
  base: string;
}

export class PublishedCalls implements Transport {
  private readonly calls = new Map<number, PublishedCall>();
  private readonly heard: Heard;
  private opened: Promise<Parts> | null = null;
  private last = 0;

  /** `soon` runs work in a turn of its own. `onUseless` hears why the web server can never do. */
  constructor(
    private readonly publication: PublicationStart,
    events: CallEvents,
    private readonly soon: (work: () => void) => void,
    private readonly checksumOf: FrameChecksum,
    private readonly onUseless: (sentence: string) => void,
  ) {
    this.heard = new Heard(events, soon);
    this.parts().then((parts) => parts.comeEarly()).catch(() => {}); // each call tells of a failure
  }

  setWho(): void {}

  open(method: string): number {
    this.calls.set(++this.last, { method, stream: null, abort: new AbortController() });
    this.heard.begin(this.last);
    return this.last;
  }

  send(number: number, bytes: Uint8Array): void {
    const call = this.calls.get(number);
    if (!call) return;
    const done = call.method === kEdit ? this.converse(number, call, bytes) : this.answer(number, call, fieldsOf(bytes));
    done.catch((error) => this.fail(number, error));
  }

  end(number: number): void {
    if (this.calls.get(number)?.method === kEdit) this.finish(number, kOk);
  }

  cancel(number: number): void {
    this.calls.get(number)?.abort.abort();
    this.heard.drop(number);
    this.finish(number, kCancelled, "cancelled");
  }

  buffered(): number {
    return 0;
  }

  pull(number: number): void {
    this.heard.pull(number);
  }

  close(): void {
    for (const call of this.calls.values()) call.abort.abort();
    this.calls.clear();
    this.heard.clear();
  }

  /** Opens the parts. The next call tries again what failed. */
  private parts(): Promise<Parts> {
    const { base, scan } = this.publication;
    this.opened ??= Parts.open(base, scan.parts).catch((error) => {
      this.opened = null;
      throw error;
    });
    return this.opened;
  }

  private async converse(number: number, call: PublishedCall, message: Uint8Array): Promise<void> {
    const parts = await this.parts();
    call.stream ??= new PublishedStream(
      this.publication.scan,
      parts,
      this.checksumOf,
      (said) => this.say(number, said),
      (error) => this.fail(number, error),
    );
    call.stream.hear(message);
  }

  private async answer(number: number, { method, abort }: PublishedCall, request: Fields): Promise<void> {
    const answer = this.publication.scan.answers[method];
    const isFetch = method === kFetchPages || method === kFetchSheets;
    if (isFetch) {
      const of = method === kFetchPages ? pagesOfRequest : sheetsOfRequest;
      for (const part of of(request, await this.parts(), abort.signal)) this.say(number, await part);
    } else if (answer === undefined) {
      return this.finish(number, kUnimplemented, "a publication cannot do that");
    } else this.say(number, fromBase64(answer));
    this.finish(number, kOk);
  }

  private say(number: number, message: Uint8Array): void {
    this.soon(() => this.heard.message(number, message));
  }

  private fail(number: number, error: unknown): void {
    if (error instanceof Useless) this.onUseless(error.message);
    this.finish(number, kUnavailable, error instanceof Error ? error.message : String(error));
  }

  private finish(number: number, code: number, message = ""): void {
    if (!this.calls.delete(number)) return;
    this.soon(() => this.heard.end(number, { code, message, details: new Uint8Array() }));
  }
}
