import assert from "node:assert/strict";
import { test } from "node:test";
import { glImports } from "../../../client/web/engine/gl";
import type { CoreMemory } from "../../../client/web/engine/memory";

/** Has any function; those that are not given return null. */
const fake = (given: object) =>
  new Proxy(given, { get: (of, name) => (name in of ? Reflect.get(of, name) : () => null) });

/** The core's imports over a context with these errors, the first one first. */
function importsWith(errors: number[]) {
  const gl = fake({ NO_ERROR: 0, CONTEXT_LOST_WEBGL: 37442, getError: () => errors.shift() ?? 0 });
  const imports = glImports(gl as WebGL2RenderingContext, fake({}) as CoreMemory);
  return (name: string) => (imports[name] as (...parts: number[]) => number)(0, 0, 0, 0);
}

test("ErrorsOfCallsBeforeAreNotThoseOfTheNextOne", () => {
  const call = importsWith([1282, 1286]);
  call("glBufferData");
  assert.equal(call("glGetError"), 1282);
  call("glBufferData");
  assert.equal(call("glGetError"), 0);
});

test("NoErrorIsAskedForUnlessACallMayFail", () => {
  const errors = [1282];
  const call = importsWith(errors);
  assert.equal(call("glGetError"), 0);
  assert.equal(errors.length, 1);
});
