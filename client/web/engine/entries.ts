// How the core is entered. Each entry is a turn of the event loop of its own, on one shadow stack: that of the
// worker's own calls, or that of a task. So no two of them ever run in each other.

import type { CoreExports } from "./core_exports";

/** WebAssembly with the parts that suspend stacks (JSPI), which TypeScript does not know yet. */
export const jspi = WebAssembly as unknown as {
  promising(run: (task: number) => void): (task: number) => Promise<void>;
  Suspending: new (wait: (task: number) => Promise<void>) => WebAssembly.ImportValue;
};

interface Task {
  /** Of its shadow stack, while it is suspended. */
  stackPointer: number;
  /** Lets it go on; null while it runs. */
  goOn: (() => void) | null;
  /** It was told to go on before it waited. */
  isResumed: boolean;
}

export class Entries {
  private exports!: CoreExports;
  private top = 0;
  private stopped = false;
  private readonly tasks = new Map<number, Task>();
  private readonly due: (() => void)[] = [];
  private readonly turn = new MessageChannel();

  /** `onTrap` hears once why the core cannot go on. */
  constructor(private readonly onTrap: (error: unknown) => void) {
    this.turn.port1.onmessage = () => this.due.shift()?.();
  }

  /** Called once the core is there. */
  bind(exports: CoreExports): void {
    this.exports = exports;
    exports._initialize();
    this.top = exports.__stack_pointer.value;
  }

  stop(): void {
    this.stopped = true;
  }

  /** Calls into the core on the worker's own stack. Needs: the core is not running. */
  enter<Answer>(call: (core: CoreExports) => Answer): Answer | undefined {
    if (this.stopped) return undefined;
    this.exports.__stack_pointer.value = this.top;
    try {
      return call(this.exports);
    } catch (error) {
      this.trap(error);
      return undefined;
    }
  }

  /** The functions of tasks that the core imports. */
  imports(): Record<string, WebAssembly.ImportValue> {
    return {
      task_start: (task: number) => this.begin(task),
      task_suspend: new jspi.Suspending((task) => this.suspend(task)),
      task_resume: (task: number) => this.resume(task),
    };
  }

  /** Runs work in a turn of its own, after all that wait for theirs. */
  soon(work: () => void): void {
    this.due.push(work);
    this.turn.port2.postMessage(null);
  }

  private begin(number: number): void {
    const task: Task = { stackPointer: 0, goOn: null, isResumed: false };
    this.tasks.set(number, task);
    this.soon(() => this.run(number, task));
  }

  private run(number: number, task: Task): void {
    if (this.stopped) return;
    const stack = this.enter((core) => core.core_stack(number));
    if (stack === undefined) return;
    this.exports.__stack_pointer.value = stack;
    jspi.promising(this.exports.core_task)(number).then(
      () => {
        if (this.tasks.get(number) === task) this.tasks.delete(number); // a new one may have the number
      },
      (error) => this.trap(error),
    );
  }

  private suspend(number: number): Promise<void> {
    const task = this.tasks.get(number)!;
    task.stackPointer = this.exports.__stack_pointer.value;
    return new Promise((resolve) => {
      task.goOn = resolve;
      if (task.isResumed) this.resume(number);
    });
  }

  private resume(number: number): void {
    const task = this.tasks.get(number);
    if (!task) return;
    task.isResumed = task.goOn === null;
    if (task.goOn === null) return;
    const goOn = task.goOn;
    task.goOn = null;
    this.soon(() => {
      if (this.stopped) return;
      this.exports.__stack_pointer.value = task.stackPointer;
      goOn(); // the stack goes on when this turn's microtasks run, before any other entry
    });
  }

  private trap(error: unknown): void {
    if (this.stopped) return;
    this.stopped = true;
    this.onTrap(error);
  }
}
