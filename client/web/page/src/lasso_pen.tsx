// A pen for the lasso that keys move: arrows move it, Enter or Space puts it down and lifts it.

import { useRef, useState } from "preact/hooks";
import { useLink } from "./context";
import type { PointerWhat } from "./protocol";

const kStep = 0.01; // of the picture's height
const kLargeStep = 0.05; // with Shift

interface Place {
  x: number;
  y: number;
}

/** Needs: a parent of the picture's size. */
export function LassoPen() {
  const link = useLink();
  const pen = useRef<HTMLButtonElement>(null);
  const [at, setAt] = useState<Place | null>(null);
  const [isDown, setIsDown] = useState(false);

  const boxOf = () => pen.current!.parentElement!.getBoundingClientRect();
  const middle = (box: DOMRect): Place => ({ x: box.width / 2, y: box.height / 2 });
  const send = (what: PointerWhat, { x, y }: Place) =>
    link.point({
      what,
      x: x * devicePixelRatio,
      y: y * devicePixelRatio,
      button: 0,
      modifiers: 0,
      pressure: 1,
      pen: false,
      delta: 0,
    });
  const key = (event: KeyboardEvent) => {
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [-1, 0],
      ArrowRight: [1, 0],
      ArrowUp: [0, -1],
      ArrowDown: [0, 1],
    };
    if (event.key === "Escape") focusPicture();
    const step = steps[event.key];
    if (!step) return;
    event.preventDefault();
    const box = boxOf();
    const length = (event.shiftKey ? kLargeStep : kStep) * box.height;
    const from = at ?? middle(box);
    const to = {
      x: Math.min(box.width - 1, Math.max(0, from.x + step[0] * length)),
      y: Math.min(box.height - 1, Math.max(0, from.y + step[1] * length)),
    };
    setAt(to);
    send("move", to);
  };
  const click = () => {
    const place = at ?? middle(boxOf());
    send("move", place);
    send(isDown ? "release" : "press", place);
    setIsDown(!isDown);
    if (isDown) focusPicture();
  };
  return (
    <button
      ref={pen}
      type="button"
      class="lasso-pen"
      aria-label="Pen of the lasso"
      aria-pressed={isDown}
      title="Arrow keys move the pen, Enter puts it down and lifts it, Escape gives up."
      style={at ? { left: `${at.x}px`, top: `${at.y}px` } : { left: "50%", top: "50%" }}
      onKeyDown={key}
      onClick={click}
    />
  );
}

/** The pen goes with its line, and would take the focus along. */
function focusPicture(): void {
  document.querySelector<HTMLElement>("canvas.picture")?.focus();
}
