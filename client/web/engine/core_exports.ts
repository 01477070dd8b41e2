// The exports of core.wasm (client/web/core).

export interface CoreExports {
  memory: { buffer: ArrayBuffer };
  __stack_pointer: WebAssembly.Global;
  _initialize(): void;
  core_alloc(bytes: number): number;
  core_free(at: number): void;
  core_hear(at: number, length: number): void;
  core_tick(nowMs: number): number;
  core_call_message(call: number, at: number, length: number): void;
  core_call_ended(call: number, code: number, at: number, length: number, details: number, detailsLength: number): void;
  core_frame_checksum(frame: number, length: number): bigint;
  core_image_decoded(image: number, rgba: number): void;
  core_task(task: number): void;
  core_stack(task: number): number;
}
