// Pictures that the browser decodes for the core: beside it, on threads of its own.

import type { CoreMemory } from "./memory";

export class Images {
  private last = 0;
  private givesPixels: boolean | undefined;
  /** Pictures are opaque: a canvas would mix others with its black. */
  private readonly canvas = new OffscreenCanvas(1, 1).getContext("2d", { alpha: false, willReadFrequently: true })!;

  /**
   * `decoded` hears of each picture, not within image_decode(): null if it is not one of its size, or if the browser
   * gives no page its pixels.
   */
  constructor(
    private readonly memory: CoreMemory,
    private readonly decoded: (image: number, rgba: Uint8ClampedArray | null) => void,
  ) {}

  imports(): Record<string, WebAssembly.ImportValue> {
    return {
      image_decode: (at: number, length: number, width: number, height: number) => {
        const image = ++this.last;
        const pixels = this.pixelsOf(new Blob([this.memory.copy(at, length)], { type: "image/webp" }), width, height);
        pixels.catch(() => null).then((rgba) => this.decoded(image, rgba));
        return image;
      },
    };
  }

  private async pixelsOf(file: Blob, width: number, height: number): Promise<Uint8ClampedArray | null> {
    if (!(this.givesPixels ??= givesPixels(this.canvas))) return null;
    const bitmap = await createImageBitmap(file, { colorSpaceConversion: "none" });
    if (bitmap.width !== width || bitmap.height !== height) return null;
    Object.assign(this.canvas.canvas, { width, height });
    this.canvas.drawImage(bitmap, 0, 0);
    bitmap.close();
    return this.canvas.getImageData(0, 0, width, height).data;
  }
}

const kNoiseMax = 8; // of a byte: some browsers change a few by 1

/** Returns whether a canvas gives back what was drawn. Some browsers give noise instead, so that no page knows them again. */
export function givesPixels(context: OffscreenCanvasRenderingContext2D): boolean {
  Object.assign(context.canvas, { width: 4, height: 4 });
  const drawn = new ImageData(Uint8ClampedArray.from({ length: 64 }, (_, i) => (i % 4 === 3 ? 255 : (37 * i) % 256)), 4);
  context.putImageData(drawn, 0, 0);
  return context.getImageData(0, 0, 4, 4).data.every((byte, i) => Math.abs(byte - drawn.data[i]!) <= kNoiseMax);
}
