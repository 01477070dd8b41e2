// What the cores take from their host, and how large they are.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { gzipSync } from "node:zlib";

const importsOf = (module, from) =>
  WebAssembly.Module.imports(module)
    .filter((one) => one.module === from)
    .map((one) => one.name)
    .sort();

/** Each core, the module that it alone imports, the function of the host that it alone calls, and its size. */
const kCores = [
  { name: "core", modules: ["gl"], drawing: [], bytesMax: 930_000, packedBytesMax: 403_700 },
  { name: "core_raster", modules: [], drawing: ["show_picture"], bytesMax: 977_500, packedBytesMax: 412_300 },
];

for (const { name, modules, drawing, bytesMax, packedBytesMax } of kCores) {
  const bytes = readFileSync(`${process.env.BURNISH_CORE}/${name}.wasm`);
  const module = new WebAssembly.Module(bytes);

  test(`the host's functions of ${name} are those of client/web/core/host/imports.h`, () => {
    assert.deepEqual(importsOf(module, "host"), [
      "call_buffered", "call_cancel", "call_end", "call_open", "call_pull", "call_send",
      "download_add", "download_begin", "download_end", "file_read", "image_decode", "picture_keep", "say", ...drawing,
      "store_get", "store_set", "store_take", "task_resume", "task_start", "task_suspend", "wake",
    ]);
  });

  test(`of WASI ${name} takes clocks, randomness, the environment, and the end with its words`, () => {
    const allowed = new Set([
      "clock_time_get", "environ_get", "environ_sizes_get", "fd_close", "fd_fdstat_get", "fd_prestat_dir_name",
      "fd_prestat_get", "fd_read", "fd_seek", "fd_write", "proc_exit", "random_get",
    ]);
    assert.deepEqual(importsOf(module, "wasi_snapshot_preview1").filter((one) => !allowed.has(one)), []);
  });

  test(`nothing else is imported by ${name}, and the worker finds what it calls`, () => {
    const imported = new Set(WebAssembly.Module.imports(module).map((one) => one.module));
    assert.deepEqual([...imported].sort(), [...modules, "host", "wasi_snapshot_preview1"]);
    const exported = WebAssembly.Module.exports(module).map((one) => one.name);
    for (const one of ["memory", "_initialize", "__stack_pointer", "core_alloc", "core_free", "core_hear", "core_tick",
      "core_call_message", "core_call_ended", "core_frame_checksum", "core_image_decoded", "core_stack", "core_task"])
      assert.ok(exported.includes(one), one);
  });

  test(`${name} has at most ${bytesMax} bytes, packed ${packedBytesMax}`, () => {
    assert.ok(bytes.length <= bytesMax, `${bytes.length} bytes`);
    const packed = gzipSync(bytes, { level: 9 }).length;
    assert.ok(packed <= packedBytesMax, `${packed} bytes packed`);
  });
}
