// The needs of the engine from a browser.

export interface MissingPart {
  name: string;
  /** Browsers that have it. */
  since: string;
}

const kSuspending = { name: "WebAssembly that waits (JSPI)", since: "Chrome and Edge 137, Firefox 153, Safari 27" };
const kWorkers = { name: "pictures from workers (OffscreenCanvas)", since: "Chrome and Edge 69, Firefox 105, Safari 17" };

/** Returns what this browser lacks. */
export function missingParts(): MissingPart[] {
  const missing: MissingPart[] = [];
  if (typeof WebAssembly !== "object" || !("Suspending" in WebAssembly)) missing.push(kSuspending);
  if (!("transferControlToOffscreen" in HTMLCanvasElement.prototype)) missing.push(kWorkers);
  return missing;
}
