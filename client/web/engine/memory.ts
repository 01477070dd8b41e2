// The core's memory as the host sees it. Views die when the memory grows, so none is kept.

import type { CoreExports } from "./core_exports";

const decoder = new TextDecoder();
const encoder = new TextEncoder();

export class CoreMemory {
  private exports!: CoreExports;

  /** Called once the core is there. */
  bind(exports: CoreExports): void {
    this.exports = exports;
  }

  private get buffer(): ArrayBuffer {
    return this.exports.memory.buffer;
  }

  bytes(at: number, length: number): Uint8Array<ArrayBuffer> {
    return new Uint8Array(this.buffer, at, length);
  }

  /** Returns bytes that stay as they are when the core goes on. */
  copy(at: number, length: number): Uint8Array<ArrayBuffer> {
    return this.bytes(at, length).slice();
  }

  ints(at: number, count: number): Int32Array {
    return new Int32Array(this.buffer, at, count);
  }

  floats(at: number, count: number): Float32Array {
    return new Float32Array(this.buffer, at, count);
  }

  view(): DataView {
    return new DataView(this.buffer);
  }

  text(at: number, length: number): string {
    return decoder.decode(this.bytes(at, length));
  }

  /** Reads a text that ends with a zero. */
  textAt(at: number): string {
    const all = new Uint8Array(this.buffer, at);
    return this.text(at, all.indexOf(0));
  }

  /** Writes a text and a zero, cut to `room` bytes. */
  putText(at: number, room: number, text: string): void {
    if (room <= 0) return;
    const bytes = encoder.encode(text).subarray(0, room - 1);
    this.bytes(at, bytes.length).set(bytes);
    this.view().setUint8(at + bytes.length, 0);
  }

  setInt(at: number, value: number): void {
    this.view().setInt32(at, value, true);
  }

  /** Hands bytes over: calls with their place in the core's memory, which the core frees. */
  give(bytes: ArrayLike<number>): [number, number] {
    const at = this.exports.core_alloc(bytes.length);
    this.bytes(at, bytes.length).set(bytes);
    return [at, bytes.length];
  }

  giveText(text: string): [number, number] {
    return this.give(encoder.encode(text));
  }
}
