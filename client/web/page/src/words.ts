// Numbers and days as the window writes them.

/** A count of significant digits. */
export const rounded = (digits: number) => (value: number) => String(Number(value.toPrecision(digits)));
export const short = rounded(3);

/** A number with a fixed count of digits behind the point. */
export const fixed = (digits: number) => (value: number) => value.toFixed(digits);

export function counted(count: number): string {
  if (count < 10_000) return String(count);
  return count < 10_000_000 ? `${(count / 1e3).toFixed(0)} k` : `${(count / 1e6).toFixed(1)} M`;
}

export const editsWait = (edits: number) => `${edits} ${edits === 1 ? "edit waits" : "edits wait"} for the server.`;

export function megabytes(bytes: number): string {
  return `${(bytes / 1e6).toFixed(bytes < 10_000_000 ? 1 : 0)} MB`;
}

/** "2026-11-24", in the user's own time zone. */
export function dayOf(unixSeconds: number): string {
  return new Date(unixSeconds * 1000).toLocaleDateString("sv-SE");
}

export function timeOf(unixSeconds: number): string {
  return new Date(unixSeconds * 1000).toLocaleString("sv-SE");
}

export const hexColour = (colour: number) => "#" + colour.toString(16).padStart(6, "0");

export const capital = (text: string) => text.charAt(0).toUpperCase() + text.slice(1);
