// Files that the user gives together: several scans, or one with the pictures that it names.

import type { EngineLink } from "./engine_link";
import { kMeshKinds } from "./start_page";
import { storedZip } from "./stored_zip";

const kNamingOthers = ["obj", "gltf", "ply"]; // formats that may name pictures and materials
const kZipBytesMax = 4e9;

const kindOf = (file: File) => file.name.toLowerCase().split(".").pop() ?? "";
const isMesh = (file: File) => kMeshKinds.some((kind) => kind === kindOf(file));

/** Imports all scans among the files. The files beside a single scan that may name them go with it, in an archive. */
export async function importFiles(link: EngineLink, files: readonly File[]): Promise<void> {
  const meshes = files.filter(isMesh);
  const others = files.filter((file) => !isMesh(file));
  const [mesh] = meshes;
  if (files.length === 1 || !mesh) return files.forEach((file) => link.post({ kind: "import", file }));
  if (meshes.length > 1 || others.length === 0 || !kNamingOthers.includes(kindOf(mesh))) {
    for (const file of others) link.refuse(`${file.name} is not a mesh file; it was left out`);
    return meshes.forEach((file) => link.post({ kind: "import", file }));
  }
  if (files.reduce((sum, file) => sum + file.size, 0) > kZipBytesMax)
    return link.refuse(`${mesh.name}: the files together have more than 4 GB; make a .zip of them`);
  try {
    link.post({ kind: "import", file: await storedZip(files, mesh.name.replace(/\.\w+$/, ".zip")) });
  } catch {
    link.refuse(`${mesh.name}: the browser could not read the files beside it`);
  }
}
