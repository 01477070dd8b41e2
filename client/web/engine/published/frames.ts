// Frames of the live session, made of the tiles of a publication (client/publish/published_tile.h). A tile is what a key
// frame of its page alone has, so the streams of a frame's body are those of its tiles, one behind the other:
// common/page_frames/page_frame_header.h.

import { joined } from "./messages";

const kHeaderBytes = 56;
const kChecksumAt = 48;
const kGroupValues = 16;
const kValues = 1;
const kGain = 2;
/** What a group of each width takes in the streams "packed", "byte 0", "byte 1", "bytes 2, 3". */
const kGroupBytes = [
  [0, 2, 4, 8, 0, 0, 0],
  [0, 0, 0, 0, 16, 16, 16],
  [0, 0, 0, 0, 0, 16, 16],
  [0, 0, 0, 0, 0, 0, 32],
];

export interface FrameFacts {
  sequence: number;
  /** A frame that the client holds; null makes a key frame. */
  reference: { sequence: number; checksum: bigint } | null;
  revision: number;
  /** Cells. */
  largestMove: number;
}

/** Computes the checksum of a frame whose checksum is not set yet. */
export type FrameChecksum = (frame: Uint8Array) => bigint;

export interface MadeFrame {
  bytes: Uint8Array;
  checksum: bigint;
}

/** `tiles`: one for each shown page, in the order of their numbers; null if the reference has it. */
export function makeFrame(facts: FrameFacts, tiles: (Uint8Array | null)[], checksumOf: FrameChecksum): MadeFrame {
  const body = bodyOf(tiles.map(readTile));
  const frame = joined(headerOf(facts, tiles, body.length), ...zstdFrame(body));
  const checksum = checksumOf(frame);
  new DataView(frame.buffer).setBigUint64(kChecksumAt, checksum, true);
  return { bytes: frame, checksum };
}

/** The streams of a page, in the order of a body: gain, widths, and those of the groups. */
interface ReadTile {
  flags: number;
  streams: Uint8Array[];
}

const kNothing: ReadTile = { flags: 0, streams: [] };

function readTile(tile: Uint8Array | null): ReadTile {
  if (!tile || tile.length === 0) return kNothing;
  const flags = tile[2]!;
  let at = 3;
  const take = (length: number) => tile.subarray(at, (at += length));
  const gain = take(flags & kGain ? 1 : 0);
  if (!(flags & kValues)) return { flags, streams: [gain] };
  const groups = Math.ceil((tile[0]! + 256 * tile[1]!) / kGroupValues);
  const widths = take(3 * Math.ceil(groups / 2));
  const lengths = kGroupBytes.map((bytes) => sumOverGroups(widths, bytes));
  return { flags, streams: [gain, widths, ...lengths.map(take)] };
}

/** An odd axis ends with half a byte of width 0, which takes nothing. */
function sumOverGroups(widths: Uint8Array, bytes: number[]): number {
  let sum = 0;
  for (const two of widths) sum += bytes[two & 15]! + bytes[two >> 4]!;
  return sum;
}

function bodyOf(tiles: ReadTile[]): Uint8Array {
  const flags = Uint8Array.from(tiles, (tile) => tile.flags);
  const streams = [0, 1, 2, 3, 4, 5].flatMap((stream) => tiles.map((tile) => tile.streams[stream] ?? new Uint8Array()));
  return joined(flags, ...streams);
}

function headerOf(facts: FrameFacts, tiles: (Uint8Array | null)[], bodyBytes: number): Uint8Array {
  const header = new Uint8Array(kHeaderBytes);
  const view = new DataView(header.buffer);
  header.set([0x42, 0x6e, 0x46, 0x72, 2, 0, 0, 0]); // "BnFr", version, kind of vertices, step_shift
  view.setBigUint64(8, BigInt(facts.sequence), true);
  view.setBigUint64(16, BigInt(facts.reference?.sequence ?? 0), true);
  view.setBigUint64(24, facts.reference?.checksum ?? 0n, true);
  view.setUint32(32, facts.revision, true);
  view.setFloat32(36, facts.largestMove, true);
  view.setUint32(40, tiles.filter((tile) => tile && tile.length > 0 && tile[2]! & kValues).length, true);
  view.setUint32(44, bodyBytes, true);
  return header;
}

/** Returns a zstd frame (RFC 8878) of blocks that are not compressed: the groups are packed already. */
function zstdFrame(body: Uint8Array): Uint8Array[] {
  const kBlockBytesMax = 1 << 17;
  const parts: Uint8Array[] = [Uint8Array.of(0x28, 0xb5, 0x2f, 0xfd, 0xa0, ...littleEndian(body.length, 4))];
  for (let at = 0; at === 0 || at < body.length; at += kBlockBytesMax) {
    const block = body.subarray(at, at + kBlockBytesMax);
    const isLast = at + kBlockBytesMax >= body.length;
    parts.push(Uint8Array.from(littleEndian(8 * block.length + (isLast ? 1 : 0), 3)), block);
  }
  return parts;
}

const littleEndian = (value: number, bytes: number) => Array.from({ length: bytes }, (_, byte) => (value >>> (8 * byte)) & 255);
