// Keys that are pressed.

import { command } from "./commands";
import { keyActions, keysOf, type Context } from "./key_actions";

/** Returns e.g. "Ctrl+Shift+Z". The name of a letter is upper case. */
export function keyOf(event: KeyboardEvent): string {
  const digit = /^Digit(\d)$/.exec(event.code)?.[1]; // Shift makes another letter of it
  const letter = event.key.length === 1 ? event.key.toUpperCase() : event.key;
  const isSymbol = event.key.length === 1 && event.key.toLowerCase() === event.key.toUpperCase();
  const shiftedDigit = event.shiftKey && isSymbol && digit !== undefined && event.key !== digit;
  const name = shiftedDigit ? digit : letter;
  const hasShift = event.shiftKey && (!isSymbol || shiftedDigit);
  const parts = [event.ctrlKey || event.metaKey ? "Ctrl" : "", hasShift ? "Shift" : ""];
  return [...parts, event.altKey ? "Alt" : "", name].filter((part) => part).join("+");
}

/** Returns true if the focus takes letters for itself. */
function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return target.type === "text" || target.type === "password";
  return target instanceof HTMLSelectElement;
}

const kSliderKeys = ["Home", "End", "PageUp", "PageDown"];

/** Returns true if the key moves a slider that has the focus. */
function movesSlider(target: EventTarget | null, key: string): boolean {
  return target instanceof HTMLInputElement && target.type === "range" && kSliderKeys.includes(key);
}

export function handleKeyDown(event: KeyboardEvent, context: Context): void {
  const key = keyOf(event);
  if (event.isComposing || event.defaultPrevented) return;
  if (movesSlider(event.target, key)) return;
  if (isTyping(event.target) && key !== "Escape" && key !== "F1") return;
  if (key === " " && context.document && isPicture(event.target)) {
    event.preventDefault();
    if (!event.repeat) context.link.send(command.original(true));
    return;
  }
  const action = keyActions.find((one) => keysOf(one).includes(key));
  if (!action || (action.session && !context.document)) return;
  if (action.picture && !isPicture(event.target)) return;
  if (key !== "Escape") event.preventDefault();
  action.run(context);
}

/** Ends what a held key does. */
export function handleKeyUp(event: KeyboardEvent, context: Context): void {
  if (event.key === " " && context.document && isPicture(event.target))
    context.link.send(command.original(false));
}

// Space presses a button that has the focus.
const isPicture = (target: EventTarget | null) =>
  target === document.body || (target instanceof HTMLElement && target.classList.contains("picture"));
