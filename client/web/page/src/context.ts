// The link to the engine for every part of the page.

import { createContext } from "preact";
import { useContext } from "preact/hooks";
import type { EngineLink } from "./engine_link";

export const LinkContext = createContext<EngineLink | null>(null);

/** Needs: inside the page. */
export function useLink(): EngineLink {
  const link = useContext(LinkContext);
  if (!link) throw new Error("no engine link around this part of the page");
  return link;
}
