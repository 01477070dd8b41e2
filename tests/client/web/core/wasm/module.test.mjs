// What core.wasm takes from its host, and how large it is.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

const kBytesMax = 1_000_000;
const kPackedBytesMax = 390_000;

const bytes = readFileSync(`${process.env.BURNISH_CORE}/core.wasm`);
const module = new WebAssembly.Module(bytes);
const importsOf = (from) =>
  WebAssembly.Module.imports(module)
    .filter((one) => one.module === from)
    .map((one) => one.name)
    .sort();

test("the host's functions are those of client/web/core/host/imports.h", () => {
  assert.deepEqual(importsOf("host"), [
    "call_buffered", "call_cancel", "call_end", "call_open", "call_pull", "call_send",
    "download_add", "download_begin", "download_end", "file_read", "picture_keep", "say",
    "store_get", "store_set", "store_take", "task_resume", "task_start", "task_suspend", "wake",
  ]);
});

test("of WASI it takes clocks, randomness, the environment, and the end with its words", () => {
  const allowed = new Set([
    "clock_time_get", "environ_get", "environ_sizes_get", "fd_close", "fd_fdstat_get", "fd_prestat_dir_name",
    "fd_prestat_get", "fd_read", "fd_seek", "fd_write", "proc_exit", "random_get",
  ]);
  assert.deepEqual(importsOf("wasi_snapshot_preview1").filter((name) => !allowed.has(name)), []);
});

test("nothing else is imported, and the worker finds what it calls", () => {
  const modules = new Set(WebAssembly.Module.imports(module).map((one) => one.module));
  assert.deepEqual([...modules].sort(), ["gl", "host", "wasi_snapshot_preview1"]);
  const exported = WebAssembly.Module.exports(module).map((one) => one.name);
  for (const name of ["memory", "_initialize", "__stack_pointer", "core_alloc", "core_free", "core_hear", "core_tick",
    "core_call_message", "core_call_ended", "core_stack", "core_task"])
    assert.ok(exported.includes(name), name);
});

test(`it has at most ${kBytesMax} bytes, packed ${kPackedBytesMax}`, () => {
  assert.ok(bytes.length <= kBytesMax, `${bytes.length} bytes`);
  const packed = gzipSync(bytes, { level: 9 }).length;
  assert.ok(packed <= kPackedBytesMax, `${packed} bytes packed`);
});
