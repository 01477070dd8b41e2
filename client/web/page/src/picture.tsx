// The canvas of the picture. The worker draws into it; the page hands it over once.

import { useEffect, useRef } from "preact/hooks";
import { useLink } from "./context";
import { PicturePointer } from "./pointer";
import type { Document } from "./snapshot";

/** Needs: another key for each start of the engine, for a canvas is handed over once. */
export function Picture({ document }: { document: Document | null }) {
  const link = useLink();
  const place = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const around = place.current!;
    const size = sizeOf(around);
    link.start(canvas.current!, size.width, size.height);
    const pointer = new PicturePointer(canvas.current!, link);
    const stopListening = pointer.listen();
    const watch = new ResizeObserver(() =>
      link.post({ kind: "resize", ...sizeOf(around), pixelRatio: devicePixelRatio }),
    );
    watch.observe(around);
    return () => {
      watch.disconnect();
      stopListening();
    };
  }, []);
  const isGrey = document !== null && document.link !== "live";
  return (
    <div ref={place} class={isGrey ? "place grey" : "place"} hidden={document === null}>
      <canvas
        ref={canvas}
        class="picture"
        tabIndex={0}
        role="img"
        aria-label={document ? `Picture of ${document.scan}` : "No picture"}
      />
    </div>
  );
}

function sizeOf(place: HTMLElement): { width: number; height: number } {
  const box = place.getBoundingClientRect();
  const pixels = (length: number) => Math.max(16, Math.round(length * devicePixelRatio));
  return { width: pixels(box.width), height: pixels(box.height) };
}
