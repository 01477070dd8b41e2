// Calls of the core over WebSockets, as docs/web.md says: one socket for Edit, up to four for the others. A socket
// carries calls one after the other.

/** What the core hears of its calls. Never called from within a function of Calls. */
export interface CallEvents {
  message(call: number, bytes: Uint8Array): void;
  ended(call: number, code: number, message: string): void;
}

export interface Who {
  user: string;
  token: string;
}

const kSubprotocol = "burnish.v1";
const kOthersMax = 4;
const kEdit = "burnish.v1.Editing/Edit";
const kCancelled = 1;
const kInternal = 13;
const kUnavailable = 14;

interface Call {
  number: number;
  method: string;
  /** Frames that wait for a socket. */
  waiting: (string | Uint8Array)[];
  waitingBytes: number;
  socket: CallSocket | null;
  /** Messages that may be handed over, and those that wait for it. */
  allowed: number;
  heard: Uint8Array[];
  end: { code: number; message: string } | null;
  isCancelled: boolean;
}

/** A socket, and the call that it carries. */
interface CallSocket {
  socket: WebSocket;
  call: Call | null;
  isForEdits: boolean;
}

export class Calls {
  private readonly calls = new Map<number, Call>();
  private readonly line: Call[] = [];
  private readonly sockets = new Set<CallSocket>();
  private last = 0;
  private who: Who = { user: "", token: "" };

  /** `address` is the origin of the page. `soon` runs work in a turn of its own. */
  constructor(
    private readonly address: string,
    private readonly events: CallEvents,
    private readonly soon: (work: () => void) => void,
  ) {}

  /** For calls from here on. */
  setWho(who: Who): void {
    this.who = who;
  }

  open(method: string): number {
    const call: Call = {
      number: ++this.last,
      method,
      waiting: [],
      waitingBytes: 0,
      socket: null,
      allowed: 1,
      heard: [],
      end: null,
      isCancelled: false,
    };
    const { user, token } = this.who;
    call.waiting.push(JSON.stringify({ call: method, ...(token && { token }), ...(user && { user }) }));
    this.calls.set(call.number, call);
    this.line.push(call);
    this.serveLine();
    return call.number;
  }

  /** Needs: bytes that nobody changes. */
  send(number: number, bytes: Uint8Array): void {
    const call = this.calls.get(number);
    if (call && !call.end) this.put(call, bytes);
  }

  /** Says that no message follows. */
  end(number: number): void {
    const call = this.calls.get(number);
    if (call && !call.end) this.put(call, JSON.stringify({ end: true }));
  }

  cancel(number: number): void {
    const call = this.calls.get(number);
    if (!call || call.end || call.isCancelled) return;
    call.isCancelled = true;
    call.heard.length = 0;
    if (call.socket) return this.put(call, JSON.stringify({ cancel: true }));
    this.line.splice(this.line.indexOf(call), 1);
    this.finish(call, kCancelled, "cancelled");
  }

  /** Returns the bytes of a call that are not on the link yet. */
  buffered(number: number): number {
    const call = this.calls.get(number);
    if (!call) return 0;
    return call.waitingBytes + (call.socket?.socket.bufferedAmount ?? 0);
  }

  /** Allows one more message to be handed over. */
  pull(number: number): void {
    const call = this.calls.get(number);
    if (!call) return;
    ++call.allowed;
    if (call.heard.length > 0 || call.end) this.soon(() => this.handOver(call));
  }

  /** Ends all sockets without a word to the core. */
  close(): void {
    for (const { socket } of this.sockets) {
      socket.onmessage = socket.onclose = socket.onopen = null;
      socket.close();
    }
    this.sockets.clear();
    this.calls.clear();
    this.line.length = 0;
  }

  private put(call: Call, frame: string | Uint8Array): void {
    if (call.socket?.socket.readyState === WebSocket.OPEN) return call.socket.socket.send(frame as Uint8Array<ArrayBuffer>);
    call.waiting.push(frame);
    if (typeof frame !== "string") call.waitingBytes += frame.length;
  }

  private flush(call: Call): void {
    for (const frame of call.waiting.splice(0)) call.socket!.socket.send(frame as Uint8Array<ArrayBuffer>);
    call.waitingBytes = 0;
  }

  /** Gives sockets to waiting calls as far as there are any. */
  private serveLine(): void {
    for (const call of [...this.line]) {
      const socket = this.freeSocket(call.method === kEdit);
      if (!socket) continue;
      this.line.splice(this.line.indexOf(call), 1);
      socket.call = call;
      call.socket = socket;
      if (socket.socket.readyState === WebSocket.OPEN) this.flush(call);
    }
  }

  /** Returns null if all sockets of this kind are taken. A new Edit has a new socket, for the last may be ending. */
  private freeSocket(isForEdits: boolean): CallSocket | null {
    const ofKind = [...this.sockets].filter((one) => one.isForEdits === isForEdits);
    const free = ofKind.find((one) => one.call === null && one.socket.readyState <= WebSocket.OPEN);
    if (free) return free;
    return isForEdits || ofKind.length < kOthersMax ? this.openSocket(isForEdits) : null;
  }

  private openSocket(isForEdits: boolean): CallSocket {
    const socket = new WebSocket(this.address.replace(/^http/, "ws") + "/rpc", kSubprotocol);
    const made: CallSocket = { socket, call: null, isForEdits };
    let wasOpen = false;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      wasOpen = true;
      if (made.call) this.flush(made.call);
    };
    socket.onmessage = ({ data }) => this.hear(made, data);
    socket.onclose = ({ reason }) => {
      this.sockets.delete(made);
      const call = made.call;
      const lost = wasOpen ? "the connection to the server was lost" : `cannot reach the server ${this.address}`;
      if (call) this.finish(call, kUnavailable, reason ? `${lost}: ${reason}` : lost);
      this.serveLine();
    };
    this.sockets.add(made);
    return made;
  }

  private hear(from: CallSocket, data: string | ArrayBuffer): void {
    const call = from.call;
    if (!call) return;
    if (typeof data !== "string") {
      if (!call.isCancelled) call.heard.push(new Uint8Array(data));
      return this.handOver(call);
    }
    from.call = null;
    call.socket = null;
    const end = readEnd(data);
    this.finish(call, end.code, end.message);
    this.serveLine();
  }

  private finish(call: Call, code: number, message: string): void {
    call.end = { code, message };
    call.socket = null;
    call.waiting.length = 0;
    call.waitingBytes = 0;
    this.soon(() => this.handOver(call));
  }

  /** The end needs no leave, and comes after all messages. */
  private handOver(call: Call): void {
    if (!this.calls.has(call.number)) return;
    while (call.allowed > 0 && call.heard.length > 0) {
      --call.allowed;
      this.events.message(call.number, call.heard.shift()!);
    }
    if (!call.end || call.heard.length > 0) return;
    this.calls.delete(call.number);
    this.events.ended(call.number, call.end.code, call.end.message);
  }
}

function readEnd(text: string): { code: number; message: string } {
  try {
    const { code, message } = JSON.parse(text) as { code?: unknown; message?: unknown };
    if (typeof code === "number") return { code, message: String(message ?? "") };
  } catch {
    // falls through
  }
  return { code: kInternal, message: "the server's words are not understood" };
}
