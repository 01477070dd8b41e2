// The parts of a publication, fetched by ranges of one file. The index has the length of each.

import type { PublishedScan } from "./scan";

/** What the tiles of a page are of, in their order. */
const kTiles = ["surface", "colours", "gains"] as const;
export type Tile = (typeof kTiles)[number];
const kPartsPerPage = 1 + kTiles.length;

/** Parts with less than this between them are fetched together. */
const kGapBytesMax = 4096;
const kRangeBytesMax = 1 << 19;
const kTilesKeptMax = 4096; // of pages that are not shown yet

/** The web server sends whole files alone. Its text is for the user. */
export class NoRanges extends Error {
  constructor() {
    super(
      "This web server does not send parts of files (it answers 200 to a Range request), and the viewer needs them: " +
        "use one that does, such as nginx, Apache or an object store.",
    );
  }
}

/** Parts that are fetched together. */
interface Range {
  parts: number[];
  begin: number;
  end: number;
}

export class Parts {
  private readonly tiles = new Map<number, Promise<Uint8Array>>();

  private constructor(
    private readonly file: string,
    private readonly places: Float64Array, // one more than there are parts
    private readonly counts: PublishedScan["parts"],
  ) {}

  /** `base`: the address of the folder. Fails: as the web server does; an index of another publication. */
  static async open(base: string, counts: PublishedScan["parts"]): Promise<Parts> {
    const answer = await fetch(new URL(counts.index, base));
    if (!answer.ok) throw new Error(`${counts.index}: the web server answers ${answer.status}`);
    const lengths = new Uint32Array(await answer.arrayBuffer());
    const sheets = counts.sheets_per_page > 0 ? counts.blocks + counts.pages * (1 + counts.sheets_per_page) : 0;
    const wanted = counts.blocks + kPartsPerPage * counts.pages + sheets;
    if (lengths.length !== wanted) throw new Error(`${counts.index} has ${lengths.length} parts, not ${wanted}`);
    const places = new Float64Array(lengths.length + 1);
    lengths.forEach((length, part) => (places[part + 1] = places[part]! + length));
    return new Parts(new URL(counts.file, base).href, places, counts);
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

  /** Returns a tile of a page. */
  tile(page: number, tile: Tile): Promise<Uint8Array> {
    const part = this.page(page) + 1 + kTiles.indexOf(tile);
    const kept = this.tiles.get(part);
    this.tiles.delete(part);
    return kept?.catch(() => this.readOne(part)) ?? this.readOne(part);
  }

  /** Returns parts, in their order; one without bytes is not fetched. Each fails as the web server does. */
  read(parts: number[], signal?: AbortSignal): Promise<Uint8Array>[] {
    const empty = Promise.resolve(new Uint8Array());
    const found = new Map<number, Promise<Uint8Array>>();
    for (const range of this.rangesOf(parts)) {
      const bytes = quiet(this.fetchRange(range, signal));
      for (const part of range.parts)
        found.set(part, quiet(bytes.then((all) => all.subarray(this.places[part]! - range.begin, this.places[part + 1]! - range.begin))));
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

  private async fetchRange({ begin, end }: Range, signal?: AbortSignal): Promise<Uint8Array> {
    const answer = await fetch(this.file, { headers: { Range: `bytes=${begin}-${end - 1}` }, signal: signal ?? null });
    if (answer.status === 206) return whole(new Uint8Array(await answer.arrayBuffer()), end - begin);
    await answer.body?.cancel();
    if (answer.status === 200) throw new NoRanges();
    throw new Error(`the web server answers ${answer.status} for a part of ${this.counts.file}`);
  }
}

/** Whoever waits for it hears of a failure; nobody has to wait. */
function quiet<Value>(promise: Promise<Value>): Promise<Value> {
  promise.catch(() => {});
  return promise;
}

function whole(bytes: Uint8Array, length: number): Uint8Array {
  if (bytes.length === length) return bytes;
  throw new Error(`the web server sent ${bytes.length} bytes where ${length} were asked for`);
}
