// The listeners that a page has for its whole window.

import { useEffect } from "preact/hooks";
import type { EngineLink } from "./engine_link";

/** Listens to keys, and tells the engine whether the page is to be seen. */
export function useKeyListeners(
  link: EngineLink,
  down: (event: KeyboardEvent) => void,
  up: (event: KeyboardEvent) => void,
): void {
  useEffect(() => {
    const visible = () => link.post({ kind: "visible", is: !window.document.hidden });
    window.addEventListener("keydown", down);
    window.addEventListener("keyup", up);
    window.document.addEventListener("visibilitychange", visible);
    return () => {
      window.removeEventListener("keydown", down);
      window.removeEventListener("keyup", up);
      window.document.removeEventListener("visibilitychange", visible);
    };
  });
}
