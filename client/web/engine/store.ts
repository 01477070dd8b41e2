// Small texts that outlive the page. The page keeps them; the worker has a copy.

import { FileReaderSync } from "./files";
import { imageOf } from "./image";
import { givesPixels } from "./images";
import type { CoreMemory } from "./memory";
import { smallPng } from "./small_png";

const kPictureQuality = 0.85; // some 10 kB a picture: a browser keeps 5 MB for a page

export class Store {
  private readonly texts = new Map<string, string>();
  private asked = new Uint8Array();

  /** `keep` hears of a text that has changed; an empty one is none. */
  constructor(
    private readonly memory: CoreMemory,
    private readonly keep: (key: string, text: string) => void,
  ) {}

  fill(texts: Record<string, string>): void {
    for (const [key, text] of Object.entries(texts)) this.texts.set(key, text);
  }

  imports(): Record<string, WebAssembly.ImportValue> {
    return {
      store_set: (key: number, keyLength: number, text: number, length: number) =>
        this.set(this.memory.text(key, keyLength), this.memory.text(text, length)),
      store_get: (key: number, length: number) => {
        this.asked = new TextEncoder().encode(this.texts.get(this.memory.text(key, length)) ?? "");
        return this.asked.length;
      },
      store_take: (to: number) => this.memory.bytes(to, this.asked.length).set(this.asked),
      picture_keep: (key: number, keyLength: number, rgb: number, width: number, height: number) =>
        void this.keepPicture(this.memory.text(key, keyLength), this.memory.copy(rgb, 3 * width * height), width, height),
    };
  }

  private set(key: string, text: string): void {
    if ((this.texts.get(key) ?? "") === text) return;
    if (text === "") this.texts.delete(key);
    else this.texts.set(key, text);
    this.keep(key, text);
  }

  private async keepPicture(key: string, rgb: Uint8Array, width: number, height: number): Promise<void> {
    const context = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true })!;
    const blob = givesPixels(context) ? await jpegOf(context, rgb, width, height) : await smallPng(rgb, width, height);
    this.set(key, new FileReaderSync().readAsDataURL(blob));
  }
}

function jpegOf(context: OffscreenCanvasRenderingContext2D, rgb: Uint8Array, width: number, height: number): Promise<Blob> {
  Object.assign(context.canvas, { width, height });
  context.putImageData(imageOf(rgb, width, height), 0, 0);
  return context.canvas.convertToBlob({ type: "image/jpeg", quality: kPictureQuality });
}
