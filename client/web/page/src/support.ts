// What the engine needs of a browser.

export interface MissingPart {
  name: string;
  /** Browsers that have it. */
  since: string;
}

const kSuspending = { name: "WebAssembly that waits (JSPI)", since: "Chrome and Edge 137, Firefox 153, Safari 27" };
const kPictures = { name: "WebGL2", since: "Chrome and Edge 56, Firefox 51, Safari 15, with a graphics card that they trust" };
const kWorkers = { name: "pictures from workers (OffscreenCanvas)", since: "Chrome and Edge 69, Firefox 105, Safari 17" };

/** Returns what this browser lacks. Makes no context, for which the page would wait; the engine tells if it gets none. */
export function missingParts(): MissingPart[] {
  const missing: MissingPart[] = [];
  if (typeof WebAssembly !== "object" || !("Suspending" in WebAssembly)) missing.push(kSuspending);
  if (!("transferControlToOffscreen" in HTMLCanvasElement.prototype)) missing.push(kWorkers);
  if (!("WebGL2RenderingContext" in window)) missing.push(kPictures);
  return missing;
}
