// Messages of calls on their way to the core: one whenever the core allows it, and the end behind the last.

/** The core's end of its calls. Never called from within a function that the core calls. */
export interface CallEvents {
  message(call: number, bytes: Uint8Array): void;
  ended(call: number, end: CallEnd): void;
}

/** As gRPC has it. */
export interface CallEnd {
  code: number;
  message: string;
  details: Uint8Array;
}

/** Carries the core's calls: by sockets to a server, or from the files of a publication. */
export interface Transport {
  setWho(who: Who): void;
  /** Begins a call. `node`: the server of a fleet that it is for; empty: any. */
  open(method: string, node?: string): number;
  /** Needs: bytes that nobody changes. */
  send(call: number, bytes: Uint8Array): void;
  /** Says that no message follows. */
  end(call: number): void;
  cancel(call: number): void;
  /** Returns the bytes of a call that are not on the link yet. */
  buffered(call: number): number;
  /** Allows one more message to be handed over. */
  pull(call: number): void;
  /** Ends all calls without a word to the core. */
  close(): void;
}

export interface Who {
  user: string;
  token: string;
}

interface HeardCall {
  allowed: number;
  waiting: Uint8Array[];
  end: CallEnd | null;
}

export class Heard {
  private readonly calls = new Map<number, HeardCall>();

  /** `soon` runs work in a turn of its own. */
  constructor(
    private readonly events: CallEvents,
    private readonly soon: (work: () => void) => void,
  ) {}

  begin(call: number): void {
    this.calls.set(call, { allowed: 1, waiting: [], end: null });
  }

  /** Needs: a turn in which the core does not run. */
  message(call: number, bytes: Uint8Array): void {
    this.calls.get(call)?.waiting.push(bytes);
    this.handOver(call);
  }

  end(number: number, end: CallEnd): void {
    const call = this.calls.get(number);
    if (!call) return;
    call.end = end;
    this.soon(() => this.handOver(number));
  }

  pull(number: number): void {
    const call = this.calls.get(number);
    if (!call) return;
    ++call.allowed;
    if (call.waiting.length > 0 || call.end) this.soon(() => this.handOver(number));
  }

  /** Drops messages that wait. */
  drop(call: number): void {
    const heard = this.calls.get(call);
    if (heard) heard.waiting.length = 0;
  }

  clear(): void {
    this.calls.clear();
  }

  /** The end needs no leave, and comes after all messages. */
  private handOver(number: number): void {
    const call = this.calls.get(number);
    if (!call) return;
    while (call.allowed > 0 && call.waiting.length > 0) {
      --call.allowed;
      this.events.message(number, call.waiting.shift()!);
    }
    if (!call.end || call.waiting.length > 0) return;
    this.calls.delete(number);
    this.events.ended(number, call.end);
  }
}
