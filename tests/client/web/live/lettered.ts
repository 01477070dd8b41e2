// A scan with a picture, finer than its triangles.

import { readFileSync, writeFileSync } from "node:fs";
import type { Lab, Visit } from "./lab";

/** Paints dark letters and stripes on a light ground, and returns the file. */
const painted = (visit: Visit): Promise<string> =>
  visit.page.evaluate(async () => {
    const canvas = new OffscreenCanvas(1024, 1024);
    const context = canvas.getContext("2d")!;
    context.fillStyle = "rgb(230 205 150)";
    context.fillRect(0, 0, 1024, 1024);
    context.fillStyle = "rgb(30 20 90)";
    context.font = "24px sans-serif";
    for (let line = 0; line < 20; ++line) context.fillText(`${line} The quick brown fox jumps over it`, 0, 26 * line);
    for (let x = 0; x < 1024; x += 8) context.fillRect(x, 520, 4, 504);
    let text = "";
    for (const one of new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer()))
      text += String.fromCharCode(one);
    return btoa(text);
  });

/** Lays the picture over a generated tablet, as seen from above. */
function withPicture(obj: string): string {
  const lines = obj.split("\n");
  const at = lines.filter((line) => line.startsWith("v ")).map((line) => line.split(" ").slice(1, 4).map(Number));
  const least = [0, 1].map((axis) => Math.min(...at.map((place) => place[axis]!)));
  const most = [0, 1].map((axis) => Math.max(...at.map((place) => place[axis]!)));
  const part = (place: number[], axis: number) => (place[axis]! - least[axis]!) / (most[axis]! - least[axis]!);
  const vertices = at.flatMap((place) => [`v ${place.join(" ")}`, `vt ${part(place, 0)} ${part(place, 1)}`]);
  const corner = (word: string) => word.split("/")[0] + "/" + word.split("/")[0];
  const faces = lines.filter((line) => line.startsWith("f ")).map((line) => line.split(" ").slice(1).map(corner));
  return ["mtllib skin.mtl", "usemtl skin", ...vertices, ...faces.map((face) => `f ${face.join(" ")}`), ""].join("\n");
}

/** Imports a scan with that picture, "lettered". */
export async function importLettered(lab: Lab): Promise<void> {
  await lab.run("generate", "tablet", "plain.obj", "--vertices", "10000");
  writeFileSync(lab.path("lettered.obj"), withPicture(readFileSync(lab.path("plain.obj"), "utf8")));
  writeFileSync(lab.path("skin.mtl"), "newmtl skin\nmap_Kd skin.png\n");
  await lab.visit(async (visit) => writeFileSync(lab.path("skin.png"), Buffer.from(await painted(visit), "base64")));
  await lab.ask("import", "lettered.obj", "--name", "lettered");
}
