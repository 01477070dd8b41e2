// Small texts that outlive the page. The page keeps them; the worker has a copy.

import type { CoreMemory } from "./memory";

export class Store {
  private readonly texts = new Map<string, string>();
  private asked = new Uint8Array();

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
    };
  }

  private set(key: string, text: string): void {
    if (this.texts.get(key) === text) return;
    this.texts.set(key, text);
    this.keep(key, text);
  }
}
