// When the core is asked for the next picture: with the screen while the page is seen, by timers otherwise.

const kFrameMs = 20;
const kFrameMsMax = 100; // browsers stop pictures of windows behind others, and of hidden canvases, without a word

export class Pictures {
  private frame = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private dueAt = Infinity;
  private isVisible = true;

  /** `tick` draws, and returns the ms until it wants to be called again at the latest. */
  constructor(private readonly tick: () => number) {}

  setVisible(is: boolean): void {
    this.isVisible = is;
    this.forget();
    this.wake();
  }

  /** Asks for a tick with the next picture. */
  wake(): void {
    if (this.isVisible && this.frame === 0) this.frame = requestAnimationFrame(() => this.now());
    this.setTimer(this.isVisible ? kFrameMsMax : 0);
  }

  /** Forgets what was asked for. */
  forget(): void {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
    this.frame = 0;
    this.dueAt = Infinity;
  }

  private now(): void {
    this.forget();
    const ms = this.tick();
    if (ms < kFrameMs) this.wake();
    else if (Number.isFinite(ms)) this.setTimer(ms);
  }

  private setTimer(ms: number): void {
    const dueAt = performance.now() + ms;
    if (dueAt >= this.dueAt) return;
    clearTimeout(this.timer);
    this.dueAt = dueAt;
    this.timer = setTimeout(() => this.now(), ms);
  }
}
