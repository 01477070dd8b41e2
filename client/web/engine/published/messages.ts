// Protobuf, as far as a publication needs it: numbers below 2^53, bytes, and messages of both.

export type Fields = Map<number, (number | Uint8Array)[]>;

const kVarint = 0;
const kEight = 1;
const kBytes = 2;
const kFour = 5;

/** Reads numbers and bytes; eight and four bytes of other kinds are skipped. Fails: a message that is cut off. */
export function fieldsOf(message: Uint8Array): Fields {
  const fields: Fields = new Map();
  const reader = new Reader(message);
  while (!reader.isAtEnd()) {
    const key = reader.number();
    const kind = key % 8;
    if (kind === kEight || kind === kFour) reader.bytes(kind === kEight ? 8 : 4);
    else add(fields, Math.floor(key / 8), kind === kVarint ? reader.number() : reader.bytes(reader.number()));
  }
  return fields;
}

function add(fields: Fields, number: number, value: number | Uint8Array): void {
  const values = fields.get(number);
  if (values) values.push(value);
  else fields.set(number, [value]);
}

/** Returns a repeated field of numbers, packed or not. */
export function numbersOf(fields: Fields, number: number): number[] {
  return (fields.get(number) ?? []).flatMap((value) => (typeof value === "number" ? value : unpacked(value)));
}

function unpacked(bytes: Uint8Array): number[] {
  const numbers: number[] = [];
  for (const reader = new Reader(bytes); !reader.isAtEnd(); ) numbers.push(reader.number());
  return numbers;
}

/** Returns a number, 0 where it is absent. */
export const numberOf = (fields: Fields, number: number): number => numbersOf(fields, number).at(-1) ?? 0;

/** Returns the messages of a field. */
export const messagesOf = (fields: Fields, number: number): Uint8Array[] =>
  (fields.get(number) ?? []).filter((value) => typeof value !== "number");

/** Returns a field of a message, whose bytes are these parts. */
export function bytesField(number: number, ...parts: Uint8Array[]): Uint8Array {
  const length = parts.reduce((sum, part) => sum + part.length, 0);
  return joined(varint(8 * number + kBytes), varint(length), ...parts);
}

function varint(value: number): Uint8Array {
  const bytes: number[] = [];
  for (; value >= 128; value = Math.floor(value / 128)) bytes.push((value % 128) + 128);
  return Uint8Array.of(...bytes, value);
}

export function joined(...parts: Uint8Array[]): Uint8Array {
  const all = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    all.set(part, at);
    at += part.length;
  }
  return all;
}

class Reader {
  private at = 0;

  constructor(private readonly from: Uint8Array) {}

  isAtEnd = () => this.at >= this.from.length;

  number(): number {
    let value = 0;
    for (let factor = 1; ; factor *= 128) {
      const byte = this.from[this.at++];
      if (byte === undefined) throw new Error("a message is cut off");
      value += (byte & 127) * factor;
      if (byte < 128) return value;
    }
  }

  bytes(length: number): Uint8Array {
    if (this.at + length > this.from.length) throw new Error("a message is cut off");
    this.at += length;
    return this.from.subarray(this.at - length, this.at);
  }
}
