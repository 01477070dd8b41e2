// The same bytes have the same answers inside the wasm as in the program.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const kAnswerBytesMax = 1 << 16;

/** Reads questions: kind, bytes, answer. */
function* questions(file) {
  for (let at = 0; at < file.length; ) {
    const parts = [];
    for (let i = 0; i < 3; ++i) {
      const size = file.readUInt32LE(at);
      parts.push(file.subarray(at + 4, at + 4 + size));
      at += 4 + size;
    }
    yield { kind: parts[0].toString(), bytes: parts[1], answer: parts[2].toString() };
  }
}

async function load() {
  const bytes = readFileSync(`${process.env.BURNISH_CORE}/checks.wasm`);
  let memory;
  const wasi = {
    // Takes all that protobuf says of damaged messages.
    fd_write(_file, parts, count, written) {
      let total = 0;
      for (let i = 0; i < count; ++i) total += memory().getUint32(parts + 8 * i + 4, true);
      memory().setUint32(written, total, true);
      return 0;
    },
    proc_exit: (code) => {
      throw new Error(`the module ended with ${code}`);
    },
  };
  const imports = new Proxy(wasi, { get: (known, name) => known[name] ?? (() => 8) });
  const module = new WebAssembly.Module(bytes);
  assert.deepEqual([...new Set(WebAssembly.Module.imports(module).map((one) => one.module))], ["wasi_snapshot_preview1"]);
  const { exports } = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: imports });
  memory = () => new DataView(exports.memory.buffer);
  exports._initialize();
  const room = exports.take(kAnswerBytesMax);
  return (kind, asked) => {
    const name = exports.take(kind.length + 1);
    const at = exports.take(asked.length);
    const all = new Uint8Array(exports.memory.buffer);
    all.set(Buffer.from(kind + "\0"), name);
    all.set(asked, at);
    const length = exports.answer(name, at, asked.length, room, kAnswerBytesMax);
    return Buffer.from(exports.memory.buffer, room, length).toString();
  };
}

const ask = await load();
const asked = new Map();
for (const question of questions(readFileSync(process.env.BURNISH_VECTORS))) {
  const others = asked.get(question.kind) ?? [];
  asked.set(question.kind, [...others, question]);
}

for (const [kind, all] of asked) {
  test(`${all.length} questions about a ${kind} have the program's answers, damaged ones too`, () => {
    for (const { bytes, answer } of all) assert.equal(ask(kind, bytes), answer);
  });
}

test("every kind is asked, and some answers are no failures", () => {
  assert.deepEqual([...asked.keys()].sort(), ["frames", "hash", "head", "message", "number", "page", "sheet"]);
  assert.ok(asked.get("page").some(({ answer }) => /^\d+ triangles /.test(answer)));
  assert.ok(asked.get("frames").some(({ answer }) => /^layouts .*(\n[0-9a-f]{16}){4}$/.test(answer)));
  const sheets = asked.get("sheet").map(({ answer }) => answer);
  assert.equal(sheets.filter((answer) => /^24x17 texels [0-9a-f]{16}$/.test(answer)).length, 2);
  assert.ok(sheets.some((answer) => answer.includes("the WebP has 25x17 texels, the sheet 24x17")));
  assert.ok(sheets.some((answer) => answer.includes("16383x17")));
  assert.ok(asked.get("message").some(({ answer }) => answer.startsWith("kind ")));
});
