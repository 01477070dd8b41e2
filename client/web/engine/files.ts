// Files that the user gives, and files for the user.

import type { CoreMemory } from "./memory";

/** Of workers; TypeScript knows those of pages. */
interface FileReaderSync {
  readAsArrayBuffer(blob: Blob): ArrayBuffer;
  readAsDataURL(blob: Blob): string;
}
export const { FileReaderSync } = self as unknown as { FileReaderSync: new () => FileReaderSync };

const kPartBytes = 8 << 20; // parts of a Blob may lie on the disk

/** A file as the core hears of it. */
export interface FileHandle {
  handle: number;
  name: string;
  size: number;
}

interface Download {
  name: string;
  done: Blob[];
  begun: Uint8Array<ArrayBuffer>[];
  begunBytes: number;
}

export class Files {
  private readonly files = new Map<number, File>();
  private readonly downloads = new Map<number, Download>();
  private readonly reader = new FileReaderSync();
  private last = 0;

  constructor(
    private readonly memory: CoreMemory,
    private readonly deliver: (name: string, blob: Blob) => void,
  ) {}

  add(file: File): FileHandle {
    this.files.set(++this.last, file);
    return { handle: this.last, name: file.name, size: file.size };
  }

  imports(): Record<string, WebAssembly.ImportValue> {
    return {
      file_size: (file: number) => this.files.get(file)?.size ?? 0,
      file_read: (file: number, offset: number, to: number, room: number) => this.read(file, offset, to, room),
      download_begin: (at: number, length: number) => this.begin(this.memory.text(at, length)),
      download_add: (download: number, at: number, length: number) =>
        this.append(download, this.memory.copy(at, length) as Uint8Array<ArrayBuffer>),
      download_end: (download: number, keep: number) => this.end(download, keep !== 0),
    };
  }

  /** Returns how many bytes were read: less than asked at the end, or where the file has changed. */
  private read(number: number, offset: number, to: number, room: number): number {
    const file = this.files.get(number);
    if (!file) return 0;
    try {
      const part = this.reader.readAsArrayBuffer(file.slice(offset, offset + room));
      this.memory.bytes(to, part.byteLength).set(new Uint8Array(part));
      return part.byteLength;
    } catch {
      return 0; // the browser reads no file that has changed or gone
    }
  }

  private begin(name: string): number {
    this.downloads.set(++this.last, { name, done: [], begun: [], begunBytes: 0 });
    return this.last;
  }

  private append(number: number, bytes: Uint8Array<ArrayBuffer>): void {
    const download = this.downloads.get(number)!;
    download.begun.push(bytes);
    download.begunBytes += bytes.length;
    if (download.begunBytes >= kPartBytes) this.close(download);
  }

  private close(download: Download): void {
    download.done.push(new Blob(download.begun));
    download.begun = [];
    download.begunBytes = 0;
  }

  private end(number: number, keep: boolean): void {
    const download = this.downloads.get(number)!;
    this.downloads.delete(number);
    if (!keep) return;
    this.close(download);
    this.deliver(download.name, new Blob(download.done));
  }
}
