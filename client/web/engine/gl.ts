// OpenGL for client/gl by WebGL2: each function of client/web/core/gl/epoxy/gl.h. Pointers are addresses in the core's
// memory.

import { Names, Uniforms } from "./gl_names";
import type { CoreMemory } from "./memory";

const kVersion = 0x1f02;
const kRenderer = 0x1f01;
const kFreeMemory = 0x9049;

/** After these the core hears of errors. Others fail by mistakes in the code alone, of which the browser's console tells. */
const kRisky = ["glBufferData", "glRenderbufferStorageMultisample", "glTexImage2D", "glTexImage3D"] as const;

/** The functions of the module "gl" that the core imports. */
export function glImports(gl: WebGL2RenderingContext, memory: CoreMemory): Record<string, WebAssembly.ImportValue> {
  gl.getExtension("EXT_color_buffer_float"); // GBufferSamples draws into RGBA16F
  const all = {
    ...states(gl, memory),
    ...buffers(gl, memory),
    ...targets(gl, memory),
    ...programs(gl, memory),
    ...drawing(gl, memory),
    ...fences(gl),
  };
  return { ...all, ...errors(gl, all) };
}

/** A question for errors waits for the graphics card, so it is passed on only where there may be one. */
function errors(gl: WebGL2RenderingContext, all: Record<(typeof kRisky)[number], (...parts: never[]) => void>) {
  let mayFail = false;
  const watched = kRisky.map((name) => [
    name,
    (...parts: never[]) => {
      mayFail = true;
      all[name](...parts);
    },
  ]);
  return {
    ...Object.fromEntries(watched),
    glGetError(): number {
      if (!mayFail) return gl.NO_ERROR;
      mayFail = false;
      const error = gl.getError();
      // Calls before may have left others, which would count as the next call's.
      for (let other = error; other !== gl.NO_ERROR && other !== gl.CONTEXT_LOST_WEBGL; ) other = gl.getError();
      return error;
    },
  };
}

/** glGen and glDelete of one kind of object. */
function generate<Object>(
  memory: CoreMemory,
  names: Names<Object>,
  make: () => Object | null,
  drop: (object: Object) => void,
) {
  return {
    gen(count: number, to: number): void {
      for (let i = 0; i < count; ++i) {
        const made = make(); // null once the context is lost
        memory.setInt(to + 4 * i, made === null ? 0 : names.add(made));
      }
    },
    remove(count: number, from: number): void {
      for (const name of memory.ints(from, count)) {
        const object = names.remove(name);
        if (object !== null) drop(object);
      }
    },
  };
}

function states(gl: WebGL2RenderingContext, memory: CoreMemory) {
  const renderer = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  const texts: Record<number, () => string> = {
    [kVersion]: () => "OpenGL ES 3.0 (WebGL 2.0)",
    [kRenderer]: () => String(gl.getParameter(renderer)),
  };
  return {
    glGetText: (name: number, to: number, room: number) => memory.putText(to, room, texts[name]?.() ?? ""),
    glGetIntegerv: (name: number, to: number) => memory.setInt(to, name === kFreeMemory ? 0 : gl.getParameter(name)),
    glEnable: (what: number) => gl.enable(what),
    glDisable: (what: number) => gl.disable(what),
    glBlendFuncSeparate: (source: number, destination: number, sourceAlpha: number, destinationAlpha: number) =>
      gl.blendFuncSeparate(source, destination, sourceAlpha, destinationAlpha),
    glColorMask: (red: number, green: number, blue: number, alpha: number) =>
      gl.colorMask(red !== 0, green !== 0, blue !== 0, alpha !== 0),
    glPixelStorei: (name: number, value: number) => gl.pixelStorei(name, value),
    glPolygonOffset: (factor: number, units: number) => gl.polygonOffset(factor, units),
    glScissor: (x: number, y: number, width: number, height: number) => gl.scissor(x, y, width, height),
    glViewport: (x: number, y: number, width: number, height: number) => gl.viewport(x, y, width, height),
  };
}

function buffers(gl: WebGL2RenderingContext, memory: CoreMemory) {
  const named = new Names<WebGLBuffer>();
  const arrays = new Names<WebGLVertexArrayObject>();
  const ofBuffers = generate(memory, named, () => gl.createBuffer(), (one) => gl.deleteBuffer(one));
  const ofArrays = generate(memory, arrays, () => gl.createVertexArray(), (one) => gl.deleteVertexArray(one));
  return {
    glGenBuffers: ofBuffers.gen,
    glDeleteBuffers: ofBuffers.remove,
    glBindBuffer: (target: number, name: number) => gl.bindBuffer(target, named.get(name)),
    glBufferData(target: number, size: number, from: number, usage: number): void {
      if (from === 0) gl.bufferData(target, size, usage);
      else gl.bufferData(target, memory.bytes(from, size), usage);
    },
    glBufferSubData: (target: number, offset: number, size: number, from: number) =>
      gl.bufferSubData(target, offset, memory.bytes(from, size)),
    glCopyBufferSubData: (from: number, to: number, readAt: number, writeAt: number, size: number) =>
      gl.copyBufferSubData(from, to, readAt, writeAt, size),
    glGenVertexArrays: ofArrays.gen,
    glDeleteVertexArrays: ofArrays.remove,
    glBindVertexArray: (name: number) => gl.bindVertexArray(arrays.get(name)),
    glEnableVertexAttribArray: (index: number) => gl.enableVertexAttribArray(index),
    glVertexAttribPointer: (
      index: number,
      size: number,
      type: number,
      normalized: number,
      stride: number,
      offset: number,
    ) => gl.vertexAttribPointer(index, size, type, normalized !== 0, stride, offset),
    glVertexAttribIPointer: (index: number, size: number, type: number, stride: number, offset: number) =>
      gl.vertexAttribIPointer(index, size, type, stride, offset),
  };
}

function targets(gl: WebGL2RenderingContext, memory: CoreMemory) {
  const textures = new Names<WebGLTexture>();
  const framebuffers = new Names<WebGLFramebuffer>();
  const renderbuffers = new Names<WebGLRenderbuffer>();
  const ofTextures = generate(memory, textures, () => gl.createTexture(), (one) => gl.deleteTexture(one));
  const ofFrames = generate(memory, framebuffers, () => gl.createFramebuffer(), (one) => gl.deleteFramebuffer(one));
  const ofBuffers = generate(memory, renderbuffers, () => gl.createRenderbuffer(), (one) => gl.deleteRenderbuffer(one));
  return {
    glGenTextures: ofTextures.gen,
    glDeleteTextures: ofTextures.remove,
    glActiveTexture: (unit: number) => gl.activeTexture(unit),
    glBindTexture: (target: number, name: number) => gl.bindTexture(target, textures.get(name)),
    glTexParameteri: (target: number, name: number, value: number) => gl.texParameteri(target, name, value),
    glTexImage2D(
      target: number,
      level: number,
      stored: number,
      width: number,
      height: number,
      border: number,
      format: number,
      type: number,
      from: number,
    ): void {
      const parts = format === gl.RGB ? 3 : 4; // pixels come in bytes, without gaps
      const pixels = from === 0 ? null : memory.bytes(from, parts * width * height);
      gl.texImage2D(target, level, stored, width, height, border, format, type, pixels);
    },
    glTexImage3D(
      target: number,
      level: number,
      stored: number,
      width: number,
      height: number,
      depth: number,
      border: number,
      format: number,
      type: number,
      from: number,
    ): void {
      const pixels = from === 0 ? null : memory.bytes(from, 4 * width * height * depth);
      gl.texImage3D(target, level, stored, width, height, depth, border, format, type, pixels);
    },
    glTexSubImage3D(
      target: number,
      level: number,
      x: number,
      y: number,
      z: number,
      width: number,
      height: number,
      depth: number,
      format: number,
      type: number,
      from: number,
    ): void {
      const pixels = memory.bytes(from, 4 * width * height * depth);
      gl.texSubImage3D(target, level, x, y, z, width, height, depth, format, type, pixels);
    },
    glTexImage2DMultisample(): never {
      throw new Error("WebGL2 has no textures with samples");
    },
    glGenFramebuffers: ofFrames.gen,
    glDeleteFramebuffers: ofFrames.remove,
    glBindFramebuffer: (target: number, name: number) => gl.bindFramebuffer(target, framebuffers.get(name)),
    glFramebufferTexture2D: (target: number, attachment: number, kind: number, name: number, level: number) =>
      gl.framebufferTexture2D(target, attachment, kind, textures.get(name), level),
    glFramebufferRenderbuffer: (target: number, attachment: number, kind: number, name: number) =>
      gl.framebufferRenderbuffer(target, attachment, kind, renderbuffers.get(name)),
    glCheckFramebufferStatus: (target: number) => gl.checkFramebufferStatus(target),
    glDrawBuffers: (count: number, from: number) => gl.drawBuffers([...memory.ints(from, count)]),
    glReadBuffer: (source: number) => gl.readBuffer(source),
    glReadPixels: (x: number, y: number, width: number, height: number, format: number, type: number, to: number) =>
      gl.readPixels(x, y, width, height, format, type, memory.bytes(to, 4 * width * height)),
    glBlitFramebuffer: (...parts: Parameters<WebGL2RenderingContext["blitFramebuffer"]>) =>
      gl.blitFramebuffer(...parts),
    glGenRenderbuffers: ofBuffers.gen,
    glDeleteRenderbuffers: ofBuffers.remove,
    glBindRenderbuffer: (target: number, name: number) => gl.bindRenderbuffer(target, renderbuffers.get(name)),
    glRenderbufferStorageMultisample: (
      target: number,
      samples: number,
      format: number,
      width: number,
      height: number,
    ) => gl.renderbufferStorageMultisample(target, samples, format, width, height),
  };
}

function programs(gl: WebGL2RenderingContext, memory: CoreMemory) {
  const shaders = new Names<WebGLShader>();
  const linked = new Names<WebGLProgram>();
  const uniforms = new Uniforms(gl);
  const place = (number: number) => uniforms.place(number);
  const putLog = (log: string | null, room: number, length: number, to: number) => {
    memory.putText(to, room, log ?? "");
    if (length !== 0) memory.setInt(length, Math.min(room - 1, log?.length ?? 0));
  };
  return {
    glCreateShader: (kind: number) => shaders.add(gl.createShader(kind)!),
    glDeleteShader: (name: number) => gl.deleteShader(shaders.get(name)), // asked for its state below, so it keeps its number
    glShaderSource(name: number, count: number, sources: number): void {
      const parts = [...memory.ints(sources, count)].map((at) => memory.textAt(at >>> 0));
      gl.shaderSource(shaders.get(name)!, parts.join(""));
    },
    glCompileShader: (name: number) => gl.compileShader(shaders.get(name)!),
    glGetShaderiv: (name: number, what: number, to: number) =>
      memory.setInt(to, Number(gl.getShaderParameter(shaders.get(name)!, what))),
    glGetShaderInfoLog: (name: number, room: number, length: number, to: number) =>
      putLog(gl.getShaderInfoLog(shaders.get(name)!), room, length, to),
    glCreateProgram: () => linked.add(gl.createProgram()),
    glAttachShader: (program: number, shader: number) => gl.attachShader(linked.get(program)!, shaders.get(shader)!),
    glLinkProgram: (name: number) => gl.linkProgram(linked.get(name)!),
    glUseProgram: (name: number) => gl.useProgram(linked.get(name)),
    glGetProgramiv: (name: number, what: number, to: number) =>
      memory.setInt(to, Number(gl.getProgramParameter(linked.get(name)!, what))),
    glGetProgramInfoLog: (name: number, room: number, length: number, to: number) =>
      putLog(gl.getProgramInfoLog(linked.get(name)!), room, length, to),
    glDeleteProgram(name: number): void {
      uniforms.forget(name);
      gl.deleteProgram(linked.remove(name));
    },
    glGetUniformLocation: (program: number, name: number) =>
      uniforms.number(program, linked.get(program)!, memory.textAt(name)),
    glUniform1f: (number: number, value: number) => gl.uniform1f(place(number), value),
    glUniform1i: (number: number, value: number) => gl.uniform1i(place(number), value),
    glUniform2iv: (number: number, count: number, from: number) =>
      gl.uniform2iv(place(number), memory.ints(from, 2 * count)),
    glUniform2fv: (number: number, count: number, from: number) =>
      gl.uniform2fv(place(number), memory.floats(from, 2 * count)),
    glUniform3fv: (number: number, count: number, from: number) =>
      gl.uniform3fv(place(number), memory.floats(from, 3 * count)),
    glUniform4fv: (number: number, count: number, from: number) =>
      gl.uniform4fv(place(number), memory.floats(from, 4 * count)),
    glUniformMatrix4fv: (number: number, count: number, transpose: number, from: number) =>
      gl.uniformMatrix4fv(place(number), transpose !== 0, memory.floats(from, 16 * count)),
  };
}

function drawing(gl: WebGL2RenderingContext, memory: CoreMemory) {
  const multiple = gl.getExtension("WEBGL_multi_draw");
  return {
    glClear: (what: number) => gl.clear(what),
    glClearColor: (red: number, green: number, blue: number, alpha: number) => gl.clearColor(red, green, blue, alpha),
    glClearBufferfv: (buffer: number, drawn: number, from: number) =>
      gl.clearBufferfv(buffer, drawn, memory.floats(from, 4)),
    glFinish: () => gl.finish(),
    glDrawArrays: (mode: number, first: number, count: number) => gl.drawArrays(mode, first, count),
    glDrawElements: (mode: number, count: number, type: number, offset: number) =>
      gl.drawElements(mode, count, type, offset),
    glMultiDrawElements(mode: number, counts: number, type: number, offsets: number, draws: number): void {
      const count = memory.ints(counts, draws);
      const offset = memory.ints(offsets, draws);
      if (multiple) return multiple.multiDrawElementsWEBGL(mode, count, 0, type, offset, 0, draws);
      for (let i = 0; i < draws; ++i) gl.drawElements(mode, count[i]!, type, offset[i]!);
    },
  };
}

function fences(gl: WebGL2RenderingContext) {
  const named = new Names<WebGLSync>();
  return {
    glFenceSync(condition: number, flags: number): number {
      const made = gl.fenceSync(condition, flags); // null once the context is lost
      return made === null ? 0 : named.add(made);
    },
    /** Browsers answer at once, and tell news only from one turn of the event loop to the next. */
    glClientWaitSync: (name: number, flags: number, timeout: bigint) =>
      gl.clientWaitSync(named.get(name)!, flags, Number(timeout)),
    glDeleteSync: (name: number) => gl.deleteSync(named.remove(name)),
  };
}
