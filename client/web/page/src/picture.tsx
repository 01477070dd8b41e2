// The canvas of the picture. The worker draws into it; the page hands it over once.

import { useEffect, useRef } from "preact/hooks";
import { isWide } from "./columns";
import { useLink } from "./context";
import { PicturePointer } from "./pointer";
import type { Document } from "./snapshot";

/** Gives the keys to the picture. */
export const focusPicture = () => document.querySelector<HTMLElement>("canvas.picture")?.focus();

/**
 * `opening`: the scan that is shown before a document is there; empty: none.
 * Needs: another key for each start of the engine, for a canvas is handed over once.
 */
export function Picture({ document, opening = "" }: { document: Document | null; opening?: string }) {
  const link = useLink();
  const place = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const around = place.current!;
    const size = sizeOf(around);
    link.start(canvas.current!, size.width, size.height);
    const pointer = new PicturePointer(canvas.current!, link);
    const stopListening = pointer.listen();
    const watch = new ResizeObserver(() => {
      if (around.clientWidth > 0) link.post({ kind: "resize", ...sizeOf(around), pixelRatio: devicePixelRatio });
    });
    watch.observe(around);
    return () => {
      watch.disconnect();
      stopListening();
    };
  }, []);
  // Keys are the picture's, unless the user is elsewhere already.
  useEffect(() => {
    const isNowhere = window.document.activeElement === window.document.body;
    if (document && isNowhere) canvas.current!.focus();
  }, [document?.sessionId]);
  const scan = document?.scan ?? opening;
  const isGrey = document !== null && document.link !== "live";
  return (
    <div ref={place} class={isGrey ? "place grey" : "place"} hidden={scan === ""}>
      <canvas
        ref={canvas}
        class="picture"
        tabIndex={0}
        role="img"
        aria-label={scan ? `Picture of ${scan}` : "No picture"}
      />
    </div>
  );
}

/**
 * The size that the picture has, or will have: a session that opens is framed for it. Browsers lay a box's edges on
 * pixels of the screen: a canvas of another size would be scaled, and blurred.
 */
function sizeOf(place: HTMLElement): { width: number; height: number } {
  const shown = [place, place.parentElement!].find((one) => one.clientWidth > 0);
  const box = shown?.getBoundingClientRect() ?? expectedBox(place);
  const pixel = (at: number) => Math.round(at * devicePixelRatio);
  return {
    width: Math.max(16, pixel(box.right) - pixel(box.left)),
    height: Math.max(16, pixel(box.bottom) - pixel(box.top)),
  };
}

/** Lays an empty session out where the start page is. */
function expectedBox(place: HTMLElement): DOMRect {
  const start = place.closest(".no-session")!;
  const session = document.createElement("div");
  session.className = isWide() ? "session wide" : "session";
  for (const part of ["column left", "middle", "column right"])
    session.appendChild(document.createElement("div")).className = part;
  start.after(session);
  start.classList.add("away");
  const box = session.children[1]!.getBoundingClientRect();
  start.classList.remove("away");
  session.remove();
  return box;
}
