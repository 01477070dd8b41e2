// A scan of two photos of different exposure: its brightness steps where their charts meet.

import { writeFileSync } from "node:fs";
import type { Lab, Visit } from "./lab";

const kSide = 16; // cells along a side; the seam is in the middle
const kMargin = 0.03; // around a chart, of the picture

/** Returns a square whose right half lies on the left of the picture. */
function square(): string {
  const half = kSide / 2;
  const vertices: string[] = [];
  const faces: string[] = [];
  for (let y = 0; y <= kSide; ++y)
    for (let x = 0; x <= kSide; ++x) vertices.push(`v ${x} ${y} ${((x * y) % 3) / 9}`);
  for (const chart of [0, 1])
    for (let y = 0; y <= kSide; ++y)
      for (let x = 0; x <= half; ++x) {
        const u = (1 - chart) / 2 + kMargin + (x / half) * (0.5 - 2 * kMargin);
        vertices.push(`vt ${u} ${kMargin + (y / kSide) * (1 - 2 * kMargin)}`);
      }
  const corner = (x: number, y: number, chart: number) => {
    const place = chart * (kSide + 1) * (half + 1) + y * (half + 1) + x - chart * half;
    return `${y * (kSide + 1) + x + 1}/${place + 1}`;
  };
  for (let y = 0; y < kSide; ++y)
    for (let x = 0; x < kSide; ++x) {
      const chart = x < half ? 0 : 1;
      const at = (dx: number, dy: number) => corner(x + dx, y + dy, chart);
      faces.push(`f ${at(0, 0)} ${at(1, 0)} ${at(1, 1)}`, `f ${at(0, 0)} ${at(1, 1)} ${at(0, 1)}`);
    }
  return ["mtllib photos.mtl", "usemtl photos", ...vertices, ...faces, ""].join("\n");
}

/** Paints the two exposures of one grey, and returns the file. */
const painted = (visit: Visit): Promise<string> =>
  visit.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(256, 256);
    const context = canvas.getContext("2d")!;
    context.fillStyle = "rgb(110 110 110)";
    context.fillRect(0, 0, 256, 256);
    context.fillStyle = "rgb(140 140 140)";
    context.fillRect(0, 0, 128, 256);
    let text = "";
    for (const one of new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer()))
      text += String.fromCharCode(one);
    return btoa(text);
  });

/** Imports that scan, "photos". */
export async function importPhotos(lab: Lab): Promise<void> {
  writeFileSync(lab.path("photos.obj"), square());
  writeFileSync(lab.path("photos.mtl"), "newmtl photos\nmap_Kd photos.png\n");
  await lab.visit(async (visit) => writeFileSync(lab.path("photos.png"), Buffer.from(await painted(visit), "base64")));
  await lab.ask("import", "photos.obj", "--name", "photos");
}
