// The few functions of WASI that the core's C library asks for. There are no files.

import type { CoreMemory } from "./memory";

const kSuccess = 0;
const kBadFile = 8;
const kSeekOnPipe = 70;
const kNanosecondsPerMs = 1_000_000n;

export class Exit extends Error {}

/** `say` hears lines of standard output and standard error. */
export function wasi(memory: CoreMemory, say: (line: string) => void): Record<string, WebAssembly.ImportValue> {
  let begun = "";
  return {
    fd_write(file: number, parts: number, count: number, written: number): number {
      if (file !== 1 && file !== 2) return kBadFile;
      let total = 0;
      for (let i = 0; i < count; ++i) {
        const [at, length] = memory.ints(parts + 8 * i, 2) as unknown as [number, number];
        begun += memory.text(at >>> 0, length);
        total += length;
      }
      memory.setInt(written, total);
      const lines = begun.split("\n");
      begun = lines.pop()!;
      lines.forEach(say);
      return kSuccess;
    },
    fd_close: () => kBadFile,
    fd_seek: () => kSeekOnPipe,
    fd_read: () => kBadFile,
    fd_fdstat_get: () => kBadFile,
    fd_fdstat_set_flags: () => kBadFile,
    fd_prestat_get: () => kBadFile,
    fd_prestat_dir_name: () => kBadFile,
    path_open: () => kBadFile,
    environ_sizes_get(count: number, bytes: number): number {
      memory.setInt(count, 0);
      memory.setInt(bytes, 0);
      return kSuccess;
    },
    environ_get: () => kSuccess,
    /** clock 0 counts from 1970, the others from the worker's begin. */
    clock_time_get(clock: number, _precision: bigint, to: number): number {
      const ms = clock === 0 ? Date.now() : performance.now();
      memory.view().setBigUint64(to, BigInt(Math.round(ms * 1000)) * (kNanosecondsPerMs / 1000n), true);
      return kSuccess;
    },
    random_get(to: number, length: number): number {
      crypto.getRandomValues(memory.bytes(to, length) as Uint8Array<ArrayBuffer>);
      return kSuccess;
    },
    sched_yield: () => kSuccess,
    proc_exit(code: number): never {
      throw new Exit(`the core ended with ${code}`);
    },
  };
}
