// The parts of a publication, fetched by ranges of one file. The index has the length of each.

import type { PublishedScan } from "./scan";

/** The parts of a page that tiles are of, in their order. */
const kTiles = ["surface", "colours", "gains"] as const;
export type Tile = (typeof kTiles)[number];
const kPartsPerPage = 1 + kTiles.length;

/** Parts with less than this between them are fetched together. */
const kGapBytesMax = 4096;
const kRangeBytesMax = 1 << 19;
const kEarlyBytesMax = 1 << 17;
const kTilesKeptMax = 4096; // of pages that are not shown yet

/** The folder or its web server can never do, however often it is tried. Its text is for the user. */
export class Useless extends Error {}

const kNoRanges =
  "This web server does not send parts of files (it answers 200 to a Range request), and the viewer needs them: " +
  "use one that does, such as nginx, Apache or an object store.";
const kCopyAgain = "Copy the whole folder again, and scan.json last.";

/** Parts that are fetched together. */
interface Range {
  parts: number[];
  begin: number;
  end: number;
}

/** Parts from `first` to before `end` that come before anybody asks for them. */
interface Early {
  first: number;
  end: number;
  bytes: Promise<Uint8Array>;
}

export class Parts {
  private readonly tiles = new Map<number, Promise<Uint8Array>>();
  private early: Early[] = [];
  /**
   * Fails if what came early is useless. Each part waits for it: of a file that a web server sent as a whole, a browser
   * may have kept it all, and makes parts of it, but only of a small one.
   */
  private checked: Promise<unknown> = Promise.resolve();

  private constructor(
    private readonly file: string,
    private readonly places: Float64Array, // one more than there are parts
    private readonly counts: PublishedScan["parts"],
  ) {}

  /** `base`: the address of the folder. Fails: as the web server does; Useless for an index of another publication. */
  static async open(base: string, counts: PublishedScan["parts"]): Promise<Parts> {
    const answer = await fetch(new URL(counts.index, base));
    if (!answer.ok) throw refusal(counts.index, answer.status);
    const bytes = await answer.arrayBuffer();
    const sheets = counts.sheets_per_page > 0 ? counts.blocks + counts.pages * (1 + counts.sheets_per_page) : 0;
    const wanted = counts.blocks + kPartsPerPage * counts.pages + sheets;
    checkSize(counts.index, bytes.byteLength, 4 * wanted);
    const lengths = new Uint32Array(bytes);
    const places = new Float64Array(lengths.length + 1);
    lengths.forEach((length, part) => (places[part + 1] = places[part]! + length));
    return new Parts(new URL(counts.file, base).href, places, counts);
  }

  /** Begins to fetch what the first picture needs: the directory, and the coarsest pages, which are last. */
  comeEarly(): void {
    const { blocks, pages } = this.counts;
    const end = this.page(pages);
    const bytesFrom = (page: number) => this.places[end]! - this.places[this.page(page)]!;
    let page = pages;
    while (page > 0 && bytesFrom(page - 1) <= kEarlyBytesMax) --page;
    if (this.places[blocks]! <= kEarlyBytesMax) this.begin(0, blocks);
    this.begin(this.page(page), end);
  }

  private begin(first: number, end: number): void {
    const range = { begin: this.places[first]!, end: this.places[end]! };
    if (range.begin === range.end) return;
    const early = { first, end, bytes: quiet(this.fetchRange(range)) };
    this.early.push(early);
    const checked = early.bytes.catch((error) => {
      if (error instanceof Useless) throw error;
      this.early = this.early.filter((one) => one !== early); // the next reader asks again
    });
    this.checked = quiet(Promise.all([this.checked, checked]));
  }

  // The order of client/publish/page_parts.h.
  block = (number: number) => number;
  page = (number: number) => this.counts.blocks + kPartsPerPage * number;
  sheetBlock = (number: number) => this.page(this.counts.pages) + number;
  charts = (page: number) => this.sheetBlock(this.counts.blocks) + page * (1 + this.counts.sheets_per_page);
  sheet = (page: number, halving: number) => this.charts(page) + 1 + halving;

  /** Returns pages, in their order. Their tiles come along. */
  pages(numbers: number[], signal: AbortSignal): Promise<Uint8Array>[] {
    const wanted = numbers.flatMap((number) => [...Array(kPartsPerPage).keys()].map((part) => this.page(number) + part));
    const fetched = this.read(wanted, signal);
    return numbers.map((_, at) => {
      const first = kPartsPerPage * at;
      for (let part = 1; part < kPartsPerPage; ++part) this.keep(wanted[first + part]!, fetched[first + part]!);
      return fetched[first]!;
    });
  }

  /** Returns a tile of a page, as client/publish/published_tile.h made it before it was packed. */
  tile(page: number, tile: Tile): Promise<Uint8Array> {
    const part = this.page(page) + 1 + kTiles.indexOf(tile);
    const kept = this.tiles.get(part);
    this.tiles.delete(part);
    return (kept?.catch(() => this.readOne(part)) ?? this.readOne(part)).then(unpacked);
  }

  /** Returns parts, in their order; one without bytes is not fetched. Each fails as the web server does. */
  read(parts: number[], signal?: AbortSignal): Promise<Uint8Array>[] {
    const empty = Promise.resolve(new Uint8Array());
    const found = new Map<number, Promise<Uint8Array>>();
    const take = (part: number, begin: number, bytes: Promise<Uint8Array>) => {
      const [from, to] = [this.places[part]! - begin, this.places[part + 1]! - begin];
      found.set(part, quiet(this.checked.then(() => bytes).then((all) => all.subarray(from, to))));
    };
    for (const part of parts) {
      const early = this.early.find(({ first, end }) => first <= part && part < end);
      if (early) take(part, this.places[early.first]!, early.bytes);
    }
    for (const range of this.rangesOf(parts.filter((part) => !found.has(part)))) {
      const bytes = quiet(this.fetchRange(range, signal));
      for (const part of range.parts) take(part, range.begin, bytes);
    }
    return parts.map((part) => found.get(part) ?? empty);
  }

  private readOne = (part: number): Promise<Uint8Array> => this.read([part])[0]!;

  private keep(part: number, tile: Promise<Uint8Array>): void {
    this.tiles.set(part, tile);
    if (this.tiles.size > kTilesKeptMax) this.tiles.delete(this.tiles.keys().next().value!);
  }

  private rangesOf(parts: number[]): Range[] {
    const ranges: Range[] = [];
    for (const part of [...new Set(parts)].sort((one, other) => one - other)) {
      const begin = this.places[part];
      const end = this.places[part + 1];
      if (begin === undefined || end === undefined) throw new Error(`the publication has no part ${part}`);
      const last = ranges.at(-1);
      if (begin === end) continue;
      if (last && begin - last.end <= kGapBytesMax && end - last.begin <= kRangeBytesMax) {
        last.parts.push(part);
        last.end = end;
      } else ranges.push({ parts: [part], begin, end });
    }
    return ranges;
  }

  private async fetchRange({ begin, end }: Pick<Range, "begin" | "end">, signal?: AbortSignal): Promise<Uint8Array> {
    // An address of its own: Chromium fetches parts of one address one after the other, to keep them.
    const range = `bytes=${begin}-${end - 1}`;
    const answer = await fetch(`${this.file}?${range}`, { headers: { Range: range }, signal: signal ?? null });
    this.checkWhole(answer.headers.get("Content-Range"));
    if (answer.status === 206) return whole(new Uint8Array(await answer.arrayBuffer()), end - begin);
    await answer.body?.cancel();
    if (answer.status === 200) throw new Useless(kNoRanges);
    throw refusal(this.counts.file, answer.status);
  }

  /** A file that was cut off is told with the first of its parts. `range`: "bytes 0-9/200" or "bytes *\/200". */
  private checkWhole(range: string | null): void {
    const size = /^bytes .*\/(\d+)$/.exec(range ?? "")?.[1];
    if (size !== undefined) checkSize(this.counts.file, Number(size), this.places.at(-1)!);
  }
}

/** Says that a web server does not send a file. It may be busy or down, and then comes back. */
function refusal(file: string, status: number): Error {
  const comesBack = status >= 500 || status === 408 || status === 429;
  if (comesBack) return new Error(`the web server answers ${status} for ${file}`);
  return new Useless(`The web server does not send ${file}, which belongs to this page: it answers ${status}. ${kCopyAgain}`);
}

function checkSize(file: string, bytes: number, wanted: number): void {
  if (bytes === wanted) return;
  throw new Useless(`${file} has ${bytes} bytes, not ${wanted}: it is cut off, or of another publication. ${kCopyAgain}`);
}

/** A caller that waits hears of a failure; nobody has to wait. */
function quiet<Value>(promise: Promise<Value>): Promise<Value> {
  promise.catch(() => {});
  return promise;
}

/** Fails: bytes that zlib's format does not allow, or whose checksum differs. */
async function unpacked(bytes: Uint8Array): Promise<Uint8Array> {
  if (bytes.length === 0) return bytes;
  const stream = new Blob([bytes.slice()]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

function whole(bytes: Uint8Array, length: number): Uint8Array {
  if (bytes.length === length) return bytes;
  throw new Error(`the web server sent ${bytes.length} bytes where ${length} were asked for`);
}
