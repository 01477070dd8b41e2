// The checksum of ZIP and PNG.

const kPolynomial = 0xedb88320;
const kTable = Uint32Array.from({ length: 256 }, (_, byte) => {
  let rest = byte;
  for (let bit = 0; bit < 8; ++bit) rest = rest & 1 ? (rest >>> 1) ^ kPolynomial : rest >>> 1;
  return rest;
});

/** Returns the checksum of bytes behind others, whose checksum is `before`. */
export function crc32(bytes: Uint8Array, before = 0): number {
  let crc = ~before;
  for (const byte of bytes) crc = (crc >>> 8) ^ kTable[(crc ^ byte) & 0xff]!;
  return ~crc >>> 0;
}
