// Keys that the user has chosen, by the names of actions. The browser keeps them for this address.

import { keptTexts } from "./browser_store";

const kKeys = "burnish.keys";

export function ownKeys(): Record<string, string> {
  try {
    const kept: unknown = JSON.parse(keptTexts.get(kKeys) ?? "{}");
    return typeof kept === "object" && kept !== null ? (kept as Record<string, string>) : {};
  } catch {
    return {}; // damaged
  }
}

/** null: the default. */
export function keepOwnKey(name: string, key: string | null): void {
  const { [name]: _last, ...others } = ownKeys();
  keptTexts.set(kKeys, JSON.stringify(key === null ? others : { ...others, [name]: key }));
}

export function forgetOwnKeys(): void {
  keptTexts.remove(kKeys);
}
