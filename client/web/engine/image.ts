// Pictures of the core, as browsers have them.

/** Returns a picture of three bytes a pixel as one of four. */
export function imageOf(rgb: Uint8Array, width: number, height: number, image = new ImageData(width, height)): ImageData {
  const pixels = new Uint32Array(image.data.buffer);
  for (let i = 0, at = 0; i < pixels.length; ++i, at += 3)
    pixels[i] = 0xff000000 | (rgb[at + 2]! << 16) | (rgb[at + 1]! << 8) | rgb[at]!;
  return image;
}
