// Who draws: the graphics card by WebGL2, or the core with the processor. The second shows its pictures in a plain canvas.

import type { StartMessage } from "../page/src/protocol";
import { glImports } from "./gl";
import { imageOf } from "./image";
import type { CoreMemory } from "./memory";

/** A core, and what it imports to draw. */
export interface Drawing {
  core: string;
  imports: WebAssembly.Imports;
}

const kNoContext = "the browser gives the engine no WebGL2 context";
/** Names of drivers that have no graphics card. */
const kSoftware = /llvmpipe|softpipe|swiftshader|software|basic render/i;

/**
 * Chooses by `start.pictures`, and by what the browser has. Returns null if it took a card for one that is none: a
 * canvas keeps its first kind of context, so another engine must begin. Fails if the card is wanted and is not there.
 */
export function beginDrawing(start: StartMessage, memory: CoreMemory, onLost: () => void): Drawing | null {
  const { canvas, pictures } = start;
  if (pictures === "processor") return processorDrawing(start, memory);
  const isWanted = pictures === "card";
  const gl = canvas.getContext("webgl2", { antialias: false, alpha: false, depth: false });
  if (!gl && isWanted) throw new Error(kNoContext);
  if (!gl) return processorDrawing(start, memory);
  if (!isWanted && kSoftware.test(rendererOf(gl))) return null;
  canvas.addEventListener("webglcontextlost", onLost);
  return { core: start.core, imports: { gl: glImports(gl, memory) } };
}

/** Returns whether an engine is likely to draw with the card; the engine decides. */
export function seemsToHaveCard(pictures: StartMessage["pictures"]): boolean {
  if (pictures !== "best") return pictures === "card";
  const gl = new OffscreenCanvas(1, 1).getContext("webgl2");
  const seems = gl !== null && !kSoftware.test(rendererOf(gl));
  gl?.getExtension("WEBGL_lose_context")?.loseContext();
  return seems;
}

function rendererOf(gl: WebGL2RenderingContext): string {
  const name = gl.getExtension("WEBGL_debug_renderer_info")?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER;
  return String(gl.getParameter(name));
}

function processorDrawing({ canvas, rasterCore }: StartMessage, memory: CoreMemory): Drawing {
  const context = canvas.getContext("2d", { alpha: false, willReadFrequently: true })!; // keeps it in memory
  let image: ImageData | undefined; // of the last picture
  const show_picture = (rgb: number, width: number, height: number) => {
    if (image?.width !== width || image.height !== height) image = undefined;
    image = imageOf(memory.bytes(rgb, 3 * width * height), width, height, image);
    context.putImageData(image, 0, 0);
  };
  return { core: rasterCore, imports: { host: { show_picture } } };
}
