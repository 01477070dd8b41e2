// Turns pointer events over the picture into messages: mouse, pen, one finger, two fingers.

import type { EngineLink } from "./engine_link";
import { Modifier, type PointerWhat } from "./protocol";

const kMiddle = 1;
const kWheelPixels = 100; // of one step
const kLinePixels = 33;

interface Finger {
  x: number;
  y: number;
}

export class PicturePointer {
  private readonly fingers = new Map<number, Finger>();
  private pinching = false;

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly link: EngineLink,
  ) {}

  /** Returns a function that stops listening. */
  listen(): () => void {
    const pairs: [string, (event: never) => void][] = [
      ["pointerdown", this.down],
      ["pointermove", this.move],
      ["pointerup", this.up],
      ["pointercancel", this.up],
      ["pointerleave", this.leave],
      ["wheel", this.wheel],
      ["contextmenu", (event: Event) => event.preventDefault()],
    ];
    for (const [name, listener] of pairs)
      this.canvas.addEventListener(name, listener as EventListener, { passive: false });
    return () => {
      for (const [name, listener] of pairs)
        this.canvas.removeEventListener(name, listener as EventListener);
    };
  }

  private send(what: PointerWhat, event: MouseEvent, part: Partial<{ x: number; y: number; delta: number; button: number }> = {}): void {
    const { x, y } = this.placeOf(event);
    const pen = event instanceof PointerEvent && event.pointerType === "pen";
    const modifiers =
      (event.shiftKey ? Modifier.shift : 0) +
      (event.ctrlKey ? Modifier.control : 0) +
      (event.altKey ? Modifier.alt : 0);
    const pressure = pen ? (event as PointerEvent).pressure : 1;
    const button = Math.max(0, event.button);
    this.link.point({ what, x, y, button, modifiers, pressure, pen, delta: 0, ...part });
  }

  private placeOf(event: MouseEvent): Finger {
    const box = this.canvas.getBoundingClientRect();
    return {
      x: (event.clientX - box.left) * devicePixelRatio,
      y: (event.clientY - box.top) * devicePixelRatio,
    };
  }

  private readonly down = (event: PointerEvent): void => {
    event.preventDefault();
    this.canvas.focus();
    this.canvas.setPointerCapture(event.pointerId);
    if (event.pointerType !== "touch") return this.send("press", event);
    this.fingers.set(event.pointerId, this.placeOf(event));
    if (this.fingers.size === 1) this.send("press", event);
    if (this.fingers.size === 2) this.beginPinch(event);
  };

  // The first finger's stroke ends, and both turn the view like the middle button.
  private beginPinch(event: PointerEvent): void {
    this.link.send("cancel");
    this.send("release", event, { button: 0 });
    this.pinching = true;
    this.send("press", event, { ...this.middle(), button: kMiddle });
  }

  private readonly move = (event: PointerEvent): void => {
    if (event.pointerType !== "touch") {
      // A fast pen moves several times between two pictures.
      for (const each of coalesced(event)) this.send("move", each, { button: 0 });
      return;
    }
    if (!this.fingers.has(event.pointerId)) return;
    const before = this.spread();
    this.fingers.set(event.pointerId, this.placeOf(event));
    if (!this.pinching) {
      if (this.fingers.size === 1) this.send("move", event, { button: 0 });
      return;
    }
    if (this.fingers.size !== 2) return;
    this.send("move", event, { ...this.middle(), button: kMiddle });
    const after = this.spread();
    if (before > 0 && after > 0)
      this.send("pinch", event, { ...this.middle(), button: kMiddle, delta: after / before });
  };

  private readonly up = (event: PointerEvent): void => {
    if (event.pointerType !== "touch") return this.send("release", event);
    const middle = this.middle();
    if (!this.fingers.delete(event.pointerId)) return;
    if (!this.pinching) return this.send("release", event, { button: 0 });
    if (this.fingers.size === 1) this.send("release", event, { ...middle, button: kMiddle });
    if (this.fingers.size === 0) this.pinching = false;
  };

  private readonly leave = (event: PointerEvent): void => {
    if (event.pointerType !== "touch" && event.buttons === 0) this.send("leave", event);
  };

  private readonly wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const pixels = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? kLinePixels : 1;
    this.send("wheel", event, { delta: (-event.deltaY * pixels) / kWheelPixels });
  };

  private middle(): Finger {
    const all = [...this.fingers.values()];
    const sum = all.reduce((to, one) => ({ x: to.x + one.x, y: to.y + one.y }), { x: 0, y: 0 });
    return { x: sum.x / Math.max(1, all.length), y: sum.y / Math.max(1, all.length) };
  }

  private spread(): number {
    const [first, second] = [...this.fingers.values()];
    return first && second ? Math.hypot(first.x - second.x, first.y - second.y) : 0;
  }
}

function coalesced(event: PointerEvent): PointerEvent[] {
  const all = event.getCoalescedEvents?.() ?? [];
  return all.length > 0 ? all : [event];
}
