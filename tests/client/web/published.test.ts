// A publication's side of the conversation, without a browser: ranges, frames, and the live session.

import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { deflateSync } from "node:zlib";
import { PublishedCalls } from "../../../client/web/engine/published/calls";
import { makeFrame } from "../../../client/web/engine/published/frames";
import { bytesField, fieldsOf, messagesOf, numbersOf } from "../../../client/web/engine/published/messages";
import { Parts, Useless } from "../../../client/web/engine/published/parts";
import type { PublishedScan } from "../../../client/web/engine/published/scan";

const kBase = "https://museum.example/finds/42/";
const kCounts = { file: "scan-1.parts", index: "scan-1.index", blocks: 1, pages: 3, sheets_per_page: 2 };
/** The key frame of docs/protocol.md, section 8: its page has five values, and this body. */
const kTile = Uint8Array.of(5, 0, 3, 1, 4, 0, 2, 0xf4, 3, 0, 0, 0x80, ...new Uint8Array(15));

const packed = (tile: string | Uint8Array) => new Uint8Array(deflateSync(tile));

/** The parts of a scan of three pages; the second has gains alone, the third has one sheet. */
const kParts = [
  "block", "page 0", packed(kTile), "", "", "page 1", "", "", packed(kTile),
  "page 2", packed(kTile), packed("colours 2"), packed("gains 2"),
  "sheet block", "charts 0", "0a", "0b", "charts 1", "1a", "1b", "charts 2", "2a", "",
].map((part) => (typeof part === "string" ? new TextEncoder().encode(part) : part));
const kBytes = Uint8Array.from(kParts.flatMap((part) => [...part]));

let ranges: string[];
let answerRange: (begin: number, end: number) => Response;

beforeEach(() => {
  ranges = [];
  answerRange = (begin, end) => new Response(kBytes.slice(begin, end + 1), { status: 206 });
  Object.assign(globalThis, {
    fetch: async (address: string | URL, { headers }: { headers?: { Range: string } } = {}) => {
      if (String(address) === kBase + kCounts.index) return new Response(Uint32Array.from(kParts, (part) => part.length));
      assert.equal(String(address), `${kBase}${kCounts.file}?${headers!.Range}`);
      const [, begin, end] = /^bytes=(\d+)-(\d+)$/.exec(headers!.Range)!;
      ranges.push(`${begin}-${end}`);
      return answerRange(Number(begin), Number(end));
    },
  });
});

/** Demands an error that no repetition cures. */
const useless = (words: RegExp) => (error: unknown) => error instanceof Useless && words.test(error.message);

const textOf = (bytes: Uint8Array) => new TextDecoder().decode(bytes);
const never = new AbortController().signal;

test("PartsThatLieTogetherAreFetchedTogether", async () => {
  const parts = await Parts.open(kBase, kCounts);
  const found = await Promise.all(parts.pages([2, 0], never));
  assert.deepEqual(found.map(textOf), ["page 2", "page 0"]);
  assert.deepEqual(await parts.tile(0, "surface"), kTile);
  assert.equal(textOf(await parts.tile(2, "colours")), "colours 2");
  assert.equal(textOf(await parts.tile(2, "gains")), "gains 2");
  assert.equal(ranges.length, 1);
});

test("APartWithoutBytesIsNotFetched", async () => {
  const parts = await Parts.open(kBase, kCounts);
  assert.equal((await parts.tile(1, "surface")).length, 0);
  assert.deepEqual(ranges, []);
});

test("TheDirectoryAndTheCoarsestPagesComeBeforeTheyAreAskedFor", async () => {
  const parts = await Parts.open(kBase, kCounts);
  parts.comeEarly();
  assert.equal(ranges.length, 2);
  assert.equal(textOf(await parts.read([parts.block(0)])[0]!), "block");
  assert.deepEqual((await Promise.all(parts.pages([2, 0], never))).map(textOf), ["page 2", "page 0"]);
  assert.deepEqual(await parts.tile(0, "surface"), kTile);
  assert.equal(ranges.length, 2);
});

test("WhatDidNotComeEarlyIsAskedForAgain", async () => {
  const parts = await Parts.open(kBase, kCounts);
  const good = answerRange;
  answerRange = () => new Response("", { status: 503 });
  parts.comeEarly();
  await assert.rejects(parts.read([parts.block(0)])[0]!);
  answerRange = good;
  assert.equal(textOf(await parts.read([parts.block(0)])[0]!), "block");
});

test("AWebServerWithoutRangesIsToldThoughTheBrowserKeepsItsAnswer", async () => {
  const parts = await Parts.open(kBase, kCounts);
  const good = answerRange;
  answerRange = (begin, end) => (begin === 0 ? new Response(kBytes) : good(begin, end));
  parts.comeEarly();
  for (const page of parts.pages([2, 0], never)) await assert.rejects(page, useless(/does not send parts/));
});

test("SheetsAreFoundByPageAndHalving", async () => {
  const parts = await Parts.open(kBase, kCounts);
  const wanted = [parts.sheetBlock(0), parts.charts(1), parts.sheet(1, 1), parts.sheet(2, 0)];
  assert.deepEqual((await Promise.all(parts.read(wanted))).map(textOf), ["sheet block", "charts 1", "1b", "2a"]);
});

test("AWebServerWithoutRangesIsToldInASentence", async () => {
  answerRange = () => new Response(kBytes);
  const parts = await Parts.open(kBase, kCounts);
  await assert.rejects(parts.read([0])[0]!, useless(/does not send parts/));
});

test("AFileThatIsNotThereIsToldByItsNameAndTheAnswer", async () => {
  answerRange = () => new Response("", { status: 404 });
  const parts = await Parts.open(kBase, kCounts);
  await assert.rejects(parts.read([0])[0]!, useless(/scan-1\.parts.*404.*Copy the whole folder/));
});

test("AFileThatIsCutOffIsToldByItsLength", async () => {
  const headers = { "Content-Range": `bytes 0-4/${kBytes.length - 9}` };
  const parts = await Parts.open(kBase, kCounts);
  for (const status of [206, 416]) {
    answerRange = () => new Response(kBytes.slice(0, 5), { status, headers });
    const words = new RegExp(`scan-1\\.parts has ${kBytes.length - 9} bytes, not ${kBytes.length}`);
    await assert.rejects(parts.read([0])[0]!, useless(words));
  }
});

test("ABusyWebServerIsAskedAgain", async () => {
  answerRange = () => new Response("", { status: 503 });
  const parts = await Parts.open(kBase, kCounts);
  await assert.rejects(parts.read([0])[0]!, (error) => !(error instanceof Useless) && /503/.test(String(error)));
});

test("APartThatIsCutShortIsAnError", async () => {
  answerRange = (begin, end) => new Response(kBytes.slice(begin, end), { status: 206 });
  const parts = await Parts.open(kBase, kCounts);
  await assert.rejects(parts.read([0])[0]!, /sent 4 bytes where 5 were asked for/);
});

test("AnIndexOfAnotherPublicationIsRefused", async () => {
  await assert.rejects(Parts.open(kBase, { ...kCounts, pages: 4 }), useless(/scan-1\.index has 92 bytes, not 120/));
});

/** Returns the body of a frame whose blocks are not compressed. */
function bodyOf(frame: Uint8Array): number[] {
  assert.deepEqual([...frame.subarray(56, 61)], [0x28, 0xb5, 0x2f, 0xfd, 0xa0]);
  return [...frame.subarray(68)];
}

test("AFrameOfOneTileHasItsBody", () => {
  const facts = { sequence: 1, reference: null, revision: 1, largestMove: 0.25 };
  const { bytes } = makeFrame(facts, [kTile], () => 0n);
  assert.deepEqual(bodyOf(bytes), [...kTile.subarray(2)]);
  const view = new DataView(bytes.buffer);
  assert.deepEqual([view.getUint32(40, true), view.getUint32(44, true)], [1, 25]);
});

test("TheStreamsOfAFrameAreThoseOfItsTiles", () => {
  const facts = { sequence: 2, reference: { sequence: 1, checksum: 7n }, revision: 2, largestMove: 0 };
  const { bytes } = makeFrame(facts, [kTile, null, kTile, new Uint8Array()], () => 5n);
  const zeros = [...new Uint8Array(15)];
  const widths = [4, 0, 2];
  const packed = [0xf4, 3, 0, 0];
  const wanted = [3, 0, 3, 0, 1, 1, ...widths, ...widths, ...packed, ...packed, 0x80, ...zeros, 0x80, ...zeros];
  assert.deepEqual(bodyOf(bytes), wanted);
  const view = new DataView(bytes.buffer);
  assert.deepEqual([view.getBigUint64(16, true), view.getBigUint64(24, true), view.getBigUint64(48, true)], [1n, 7n, 5n]);
});

// The live session.

const kScan = {
  answers: { "burnish.v1.Library/ListScans": btoa("scans") },
  welcome: btoa("welcome"),
  frame: btoa("\x10\x02"),
  largest_move: 1,
  parts: kCounts,
} as unknown as PublishedScan;
const kEdit = "burnish.v1.Editing/Edit";

/** Calls, and what the core hears of them. */
function talk() {
  const heard: Uint8Array[] = [];
  const ends: string[] = [];
  const events = {
    message: (_: number, bytes: Uint8Array) => (heard.push(bytes), calls.pull(1)),
    ended: (_: number, end: { code: number; message: string }) => void ends.push(`${end.code} ${end.message}`.trim()),
  };
  const useless: string[] = [];
  const calls: PublishedCalls = new PublishedCalls(
    { scan: kScan, base: kBase },
    events,
    (work) => void setImmediate(work),
    () => 9n,
    (sentence) => void useless.push(sentence),
  );
  return { calls, heard, ends, useless };
}

/** Waits until something is so. */
async function until(isSo: () => boolean): Promise<void> {
  while (!isSo()) await new Promise((resolve) => setImmediate(resolve));
}

test("ACallIsAnsweredByTheMessageOfThePublication", async () => {
  const { calls, heard, ends } = talk();
  calls.send(calls.open("burnish.v1.Library/ListScans"), new Uint8Array());
  await until(() => ends.length > 0);
  assert.deepEqual([heard.map(textOf), ends], [["scans"], ["0"]]);
});

test("ACallThatNoPublicationHasIsUnimplemented", async () => {
  const { calls, ends } = talk();
  calls.send(calls.open("burnish.v1.Editing/Apply"), new Uint8Array());
  await until(() => ends.length > 0);
  assert.deepEqual(ends, ["12 a publication cannot do that"]);
});

test("ShownPagesGetTheirTilesOnceTheClientGrantsACredit", async () => {
  const { calls, heard } = talk();
  const edit = calls.open(kEdit);
  const say = (kind: number, ...body: number[]) => calls.send(edit, bytesField(kind, Uint8Array.from(body)));
  say(1);
  say(7, 8, 1, 18, 2, 1, 2); // revision 1 shows pages 1 and 2
  say(2, 8, 1); // a credit
  await until(() => heard.length === 2);
  assert.equal(textOf(heard[0]!), "welcome");
  const frame = fieldsOf(messagesOf(fieldsOf(heard[1]!), 2)[0]!);
  assert.deepEqual(numbersOf(frame, 2), [2]);
  assert.deepEqual(bodyOf(messagesOf(frame, 1)[0]!), [0, ...kTile.subarray(2)]);

  say(2, 8, 1, 18, 1, 1); // the client holds frame 1, and grants another one
  say(7, 8, 2, 18, 1, 0, 26, 1, 1); // revision 2 shows page 0 in place of page 1
  await until(() => heard.length === 3);
  const next = messagesOf(fieldsOf(messagesOf(fieldsOf(heard[2]!), 2)[0]!), 1)[0]!;
  assert.equal(new DataView(next.buffer, next.byteOffset).getBigUint64(16, true), 1n);
  assert.equal(bodyOf(next)[1], 0); // the reference has page 2
});

test("GainsOfAPageAreAPageOfTheirOwn", async () => {
  const { calls, heard } = talk();
  const edit = calls.open(kEdit);
  const say = (kind: number, ...body: number[]) => calls.send(edit, bytesField(kind, Uint8Array.from(body)));
  say(7, 8, 1, 18, 5, 0x81, 0x80, 0x80, 0x80, 0x0c); // the gains of page 1
  say(2, 8, 1);
  await until(() => heard.length === 1);
  const frame = fieldsOf(messagesOf(fieldsOf(heard[0]!), 2)[0]!);
  assert.deepEqual(bodyOf(messagesOf(frame, 1)[0]!), [...kTile.subarray(2)]);
});

test("AHeartbeatComesBackAsItIs", async () => {
  const { calls, heard } = talk();
  calls.send(calls.open(kEdit), bytesField(6, Uint8Array.of(8, 77)));
  await until(() => heard.length > 0);
  assert.deepEqual(heard[0], bytesField(9, Uint8Array.of(8, 77)));
});

test("AFetchWithoutRangesEndsTheViewer", async () => {
  const { calls, ends, useless } = talk();
  answerRange = () => new Response(kBytes);
  calls.send(calls.open("burnish.v1.Library/FetchPages"), bytesField(3, Uint8Array.of(0)));
  await until(() => ends.length > 0);
  assert.equal(useless.length, 1);
});
