// The server's side of a live session over a publication: nothing moves, and every shown page gets its tile.

import { makeFrame, type FrameChecksum } from "./frames";
import { bytesField, fieldsOf, messagesOf, numberOf, numbersOf, type Fields } from "./messages";
import type { Parts } from "./parts";
import { fromBase64, type PublishedScan } from "./scan";

// Fields of ClientMessage and ServerMessage (proto/burnish/v1/editing.proto).
const kGreeting = 1;
const kCredit = 2;
const kClientHeartbeat = 6;
const kShowPages = 7;
const kFrame = 2;
const kServerHeartbeat = 9;
const kCreditsMax = 8;
// Numbers of pages plus these stand for their colours and gains (common/page_frames/shown_pages.h).
const kColourPages = 2 ** 31;
const kGainBit = 2 ** 30;

/** A frame that was sent, and the pages that it has. */
interface SentFrame {
  sequence: number;
  checksum: bigint;
  pages: Set<number>;
}

export class PublishedStream {
  private credits = 0;
  private revision = 0;
  private shownRevision = 0;
  private readonly pages = new Set<number>();
  private readonly sent: SentFrame[] = [];
  private reference: SentFrame | null = null;
  private sequence = 0;
  private isBusy = false;

  /** `say` takes messages for the client, `fail` the reason why there will be no more. */
  constructor(
    private readonly scan: PublishedScan,
    private readonly parts: Parts,
    private readonly checksumOf: FrameChecksum,
    private readonly say: (message: Uint8Array) => void,
    private readonly fail: (error: unknown) => void,
  ) {}

  hear(message: Uint8Array): void {
    for (const [kind, bodies] of fieldsOf(message)) {
      const body = bodies.at(-1);
      if (!(body instanceof Uint8Array)) continue;
      if (kind === kGreeting) this.say(fromBase64(this.scan.welcome));
      if (kind === kClientHeartbeat) this.say(bytesField(kServerHeartbeat, body));
      if (kind === kCredit) this.takeCredit(fieldsOf(body));
      if (kind === kShowPages) this.change(fieldsOf(body));
    }
    this.showNewest().catch(this.fail);
  }

  private takeCredit(credit: Fields): void {
    this.credits = Math.min(kCreditsMax, this.credits + numberOf(credit, 1));
    const decoded = Math.max(0, ...numbersOf(credit, 2));
    const held = this.sent.find((frame) => frame.sequence === decoded);
    if (held) this.reference = held;
    const isLost = numbersOf(credit, 3).length > 0 || numberOf(credit, 4) > 0;
    if (isLost) this.reference = null;
    if (isLost) this.shownRevision = 0; // the same pages again
    while (this.sent.length > 0 && this.sent[0]!.sequence < decoded) this.sent.shift();
  }

  private change(wish: Fields): void {
    this.revision = numberOf(wish, 1);
    for (const page of numbersOf(wish, 3)) this.pages.delete(page);
    for (const page of numbersOf(wish, 2)) this.pages.add(page);
  }

  private async showNewest(): Promise<void> {
    if (this.isBusy) return;
    this.isBusy = true;
    while (this.credits > 0 && this.shownRevision !== this.revision) await this.show(this.revision);
    this.isBusy = false;
  }

  private async show(revision: number): Promise<void> {
    const pages = [...this.pages].sort((one, other) => one - other);
    const reference = this.reference;
    this.shownRevision = revision;
    const tiles = await Promise.all(pages.map((page) => (reference?.pages.has(page) ? null : this.tileOf(page))));
    const sequence = ++this.sequence;
    const facts = { sequence, reference, revision, largestMove: this.scan.largest_move };
    const { bytes, checksum } = makeFrame(facts, tiles, this.checksumOf);
    --this.credits;
    this.sent.push({ sequence, checksum, pages: new Set(pages) });
    this.say(bytesField(kFrame, bytesField(1, bytes), fromBase64(this.scan.frame)));
  }

  private tileOf = (page: number): Promise<Uint8Array> => {
    const isOfGains = page >= kColourPages + kGainBit;
    return this.parts.tile(page % kGainBit, isOfGains ? "gains" : page >= kColourPages ? "colours" : "surface");
  };
}

/** Returns the parts that FetchPages asks for: blocks, and then pages, in the order of the request. */
export function pagesOfRequest(request: Fields, parts: Parts, signal: AbortSignal): Promise<Uint8Array>[] {
  const blocks = numbersOf(request, 2).map(parts.block);
  return [...parts.read(blocks, signal), ...parts.pages(numbersOf(request, 3), signal)];
}

/** Returns the parts that FetchSheets asks for: blocks, charts and sheets. */
export function sheetsOfRequest(request: Fields, parts: Parts, signal: AbortSignal): Promise<Uint8Array>[] {
  const sheets = messagesOf(request, 4).map((sheet) => {
    const fields = fieldsOf(sheet);
    return parts.sheet(numberOf(fields, 1), numberOf(fields, 2));
  });
  const blocks = numbersOf(request, 2).map(parts.sheetBlock);
  return parts.read([...blocks, ...numbersOf(request, 3).map(parts.charts), ...sheets], signal);
}
