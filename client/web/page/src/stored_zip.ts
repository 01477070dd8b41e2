// Puts files into a ZIP archive as they are. Their bytes stay with the browser, which may have them on the disk.

import { crc32 } from "../../engine/crc32";

async function crcOf(file: Blob): Promise<number> {
  let crc = 0;
  const parts = file.stream().getReader();
  for (let part = await parts.read(); !part.done; part = await parts.read()) crc = crc32(part.value, crc);
  return crc;
}

/** Writes numbers of two ("h") or four bytes ("i"), as `form` has them. */
function packed(form: string, numbers: number[]): Uint8Array<ArrayBuffer> {
  const view = new DataView(new ArrayBuffer(2 * form.length + 2 * form.split("i").length - 2));
  let at = 0;
  numbers.forEach((one, i) => {
    if (form[i] === "h") view.setUint16(at, one, true);
    else view.setUint32(at, one, true);
    at += form[i] === "h" ? 2 : 4;
  });
  return new Uint8Array(view.buffer);
}

const kVersion = 20;
const kUtf8 = 0x800;
const kFirstDay = 0x21; // 1 January 1980: the same files give the same bytes

/** Returns an archive. Needs: less than 4 GB and 65,536 files in all. */
export async function storedZip(files: readonly File[], name: string): Promise<File> {
  const parts: BlobPart[] = [];
  const directory: BlobPart[] = [];
  let at = 0;
  let directoryBytes = 0;
  for (const file of files) {
    const called = new TextEncoder().encode(file.name);
    const facts = [kVersion, kUtf8, 0, 0, kFirstDay, await crcOf(file), file.size, file.size, called.length, 0];
    const head = packed("ihhhhhiiihh", [0x04034b50, ...facts]);
    const entry = packed("ihhhhhhiiihhhhhii", [0x02014b50, kVersion, ...facts, 0, 0, 0, 0, at]);
    parts.push(head, called, file);
    directory.push(entry, called);
    at += head.length + called.length + file.size;
    directoryBytes += entry.length + called.length;
  }
  const end = packed("ihhhhiih", [0x06054b50, 0, 0, files.length, files.length, directoryBytes, at, 0]);
  return new File([...parts, ...directory, end], name);
}
