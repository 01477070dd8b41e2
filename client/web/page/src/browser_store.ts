// Texts that the browser keeps for this address. Some browsers keep none: those that block the data of sites, or
// have no room. This page remembers then what they refuse.

class Texts {
  private readonly refused = new Map<string, string>();

  constructor(private readonly name: "localStorage" | "sessionStorage") {}

  get(key: string): string | null {
    return this.refused.get(key) ?? this.storage()?.getItem(key) ?? null;
  }

  /** Returns whether the browser keeps it. */
  set(key: string, text: string): boolean {
    this.refused.set(key, text);
    try {
      window[this.name].setItem(key, text);
    } catch {
      return false;
    }
    this.refused.delete(key);
    return true;
  }

  remove(key: string): void {
    this.refused.delete(key);
    this.storage()?.removeItem(key);
  }

  /** Returns all keys that begin so. */
  keys(begin: string): string[] {
    return [...Object.keys(this.storage() ?? {}), ...this.refused.keys()].filter((key) => key.startsWith(begin));
  }

  /** Returns null where the browser blocks it: to ask for it throws there. */
  private storage(): Storage | null {
    try {
      return window[this.name];
    } catch {
      return null;
    }
  }
}

/** For all tabs, and for the next visit. */
export const keptTexts = new Texts("localStorage");
/** Until the tab is closed. */
export const textsOfTab = new Texts("sessionStorage");
