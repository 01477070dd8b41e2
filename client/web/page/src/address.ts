// The open session in the page's address, so that a reload, a link and the browser's Back find it.

import { useEffect, useRef } from "preact/hooks";
import { command } from "./commands";
import type { EngineLink } from "./engine_link";

const kBegin = "#session=";

/** Returns the id of the session that the address names; empty: none. */
export const sessionOfAddress = (): string =>
  location.hash.startsWith(kBegin) ? location.hash.slice(kBegin.length) : "";

/** `session`: the id of the open one; empty: none. */
export function useAddress(link: EngineLink, session: string): void {
  const last = useRef("");
  useEffect(() => {
    if (session === last.current) return;
    last.current = session;
    if (session === sessionOfAddress()) return;
    const address = session ? kBegin + session : location.pathname + location.search;
    const isStep = session !== "" && sessionOfAddress() === "";
    history[isStep ? "pushState" : "replaceState"](null, "", address);
  }, [session]);
  useEffect(() => {
    const go = () => goTo(link, sessionOfAddress());
    addEventListener("popstate", go);
    return () => removeEventListener("popstate", go);
  }, []);
}

/** Follows the browser's Back and Forward. Stays while edits wait for the server. */
function goTo(link: EngineLink, session: string): void {
  const open = link.state.snapshot?.document;
  if (open?.sessionId === session) return;
  if (open?.unsavedEdits) {
    history.pushState(null, "", kBegin + open.sessionId);
    return link.refuse("edits wait for the server; the session stays open");
  }
  if (open) link.send(command.close());
  if (session) link.send(command.joinSession(session));
}
