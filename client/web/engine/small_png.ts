// Pictures as files, for browsers whose canvas gives noise for pixels.

import { crc32 } from "./crc32";

const kSignature = Uint8Array.of(0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a);
const kBits = 8;
const kColours = 2; // red, green and blue
const kLeft = 1; // a byte is told by its difference to that of the pixel on its left

function chunk(name: string, data: Uint8Array): Uint8Array<ArrayBuffer> {
  const whole = new Uint8Array(12 + data.length);
  const view = new DataView(whole.buffer);
  view.setUint32(0, data.length);
  whole.set(new TextEncoder().encode(name), 4);
  whole.set(data, 8);
  view.setUint32(8 + data.length, crc32(whole.subarray(4, 8 + data.length)));
  return whole;
}

/** Returns a PNG of a picture of three bytes a pixel. */
export async function smallPng(rgb: Uint8Array, width: number, height: number): Promise<Blob> {
  const row = 3 * width;
  const rows = new Uint8Array(height * (row + 1));
  for (let y = 0; y < height; ++y) {
    rows[y * (row + 1)] = kLeft;
    for (let x = 0; x < row; ++x) rows[y * (row + 1) + 1 + x] = rgb[y * row + x]! - (x < 3 ? 0 : rgb[y * row + x - 3]!);
  }
  const head = new DataView(new ArrayBuffer(13));
  head.setUint32(0, width);
  head.setUint32(4, height);
  head.setUint8(8, kBits);
  head.setUint8(9, kColours);
  const packing = new Blob([rows]).stream().pipeThrough(new CompressionStream("deflate"));
  const packed = new Uint8Array(await new Response(packing).arrayBuffer());
  const parts = [kSignature, chunk("IHDR", new Uint8Array(head.buffer)), chunk("IDAT", packed), chunk("IEND", new Uint8Array())];
  return new Blob(parts, { type: "image/png" });
}
