// Calls of the core over WebSockets, as docs/web.md says: one socket for Edit, up to four for the others. A socket
// carries calls one after the other.

import { Heard, type CallEnd, type CallEvents, type Transport, type Who } from "./heard";

const kSubprotocol = "burnish.v1";
const kOthersMax = 4;
const kEdit = "burnish.v1.Editing/Edit";
const kCancelled = 1;
const kInternal = 13;
const kUnavailable = 14;

interface Call {
  number: number;
  method: string;
  node: string;
  /** Frames that wait for a socket. */
  waiting: (string | Uint8Array)[];
  waitingBytes: number;
  socket: CallSocket | null;
  isCancelled: boolean;
}

/** A socket, and the call that it carries. */
interface CallSocket {
  socket: WebSocket;
  call: Call | null;
  isForEdits: boolean;
  /** The server of a fleet to which a proxy leads it; empty: any. */
  node: string;
}

const kNoDetails = new Uint8Array();

export class Calls implements Transport {
  /** Those that have not ended. */
  private readonly calls = new Map<number, Call>();
  private readonly heard: Heard;
  private readonly line: Call[] = [];
  private readonly sockets = new Set<CallSocket>();
  private last = 0;
  private who: Who = { user: "", token: "" };

  /** `address` is the origin of the page. `soon` runs work in a turn of its own. */
  constructor(
    private readonly address: string,
    events: CallEvents,
    soon: (work: () => void) => void,
  ) {
    this.heard = new Heard(events, soon);
  }

  /** For calls from here on. */
  setWho(who: Who): void {
    this.who = who;
  }

  open(method: string, node = ""): number {
    const call: Call = {
      number: ++this.last,
      method,
      node,
      waiting: [],
      waitingBytes: 0,
      socket: null,
      isCancelled: false,
    };
    const { user, token } = this.who;
    call.waiting.push(JSON.stringify({ call: method, ...(token && { token }), ...(user && { user }) }));
    this.calls.set(call.number, call);
    this.heard.begin(call.number);
    this.line.push(call);
    this.serveLine();
    return call.number;
  }

  send(number: number, bytes: Uint8Array): void {
    const call = this.calls.get(number);
    if (call) this.put(call, bytes);
  }

  end(number: number): void {
    const call = this.calls.get(number);
    if (call) this.put(call, JSON.stringify({ end: true }));
  }

  cancel(number: number): void {
    const call = this.calls.get(number);
    if (!call || call.isCancelled) return;
    call.isCancelled = true;
    this.heard.drop(number);
    if (call.socket) return this.put(call, JSON.stringify({ cancel: true }));
    this.line.splice(this.line.indexOf(call), 1);
    this.finish(call, { code: kCancelled, message: "cancelled", details: kNoDetails });
  }

  buffered(number: number): number {
    const call = this.calls.get(number);
    if (!call) return 0;
    return call.waitingBytes + (call.socket?.socket.bufferedAmount ?? 0);
  }

  pull(number: number): void {
    this.heard.pull(number);
  }

  close(): void {
    for (const one of [...this.sockets]) this.closeSocket(one);
    this.calls.clear();
    this.heard.clear();
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
      const socket = this.freeSocket(call.method === kEdit, call.node);
      if (!socket) continue;
      this.line.splice(this.line.indexOf(call), 1);
      socket.call = call;
      call.socket = socket;
      if (socket.socket.readyState === WebSocket.OPEN) this.flush(call);
    }
  }

  /** Returns null if all sockets of this kind are taken. A new Edit has a new socket, for the last may be ending. */
  private freeSocket(isForEdits: boolean, node: string): CallSocket | null {
    const ofKind = [...this.sockets].filter((one) => one.isForEdits === isForEdits);
    const free = ofKind.filter((one) => one.call === null && one.socket.readyState <= WebSocket.OPEN);
    const there = free.find((one) => one.node === node);
    if (there) return there;
    if (!isForEdits && ofKind.length >= kOthersMax) {
      if (free.length === 0) return null;
      this.closeSocket(free[0]!); // it leads to another server
    }
    return this.openSocket(isForEdits, node);
  }

  private closeSocket(one: CallSocket): void {
    one.socket.onmessage = one.socket.onclose = one.socket.onopen = null;
    one.socket.close();
    this.sockets.delete(one);
  }

  private openSocket(isForEdits: boolean, node: string): CallSocket {
    const query = node && `?node=${encodeURIComponent(node)}`;
    const socket = new WebSocket(this.address.replace(/^http/, "ws") + "/rpc" + query, kSubprotocol);
    const made: CallSocket = { socket, call: null, isForEdits, node };
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
      const message = reason ? `${lost}: ${reason}` : lost;
      if (call) this.finish(call, { code: kUnavailable, message, details: kNoDetails });
      this.serveLine();
    };
    this.sockets.add(made);
    return made;
  }

  private hear(from: CallSocket, data: string | ArrayBuffer): void {
    const call = from.call;
    if (!call) return;
    if (typeof data !== "string") {
      if (!call.isCancelled) this.heard.message(call.number, new Uint8Array(data));
      return;
    }
    from.call = null;
    call.socket = null;
    this.finish(call, readEnd(data));
    this.serveLine();
  }

  private finish(call: Call, end: CallEnd): void {
    this.calls.delete(call.number);
    call.socket = null;
    this.heard.end(call.number, end);
  }
}

function readEnd(text: string): CallEnd {
  try {
    const { code, message, details } = JSON.parse(text) as { code?: unknown; message?: unknown; details?: unknown };
    if (typeof code === "number")
      return { code, message: String(message ?? ""), details: bytesOf(String(details ?? "")) };
  } catch {
    // falls through
  }
  return { code: kInternal, message: "the server's words are not understood", details: kNoDetails };
}

/** Reads two hexadecimal digits for each byte. */
const bytesOf = (hex: string) => Uint8Array.from(hex.match(/../g) ?? [], (digits) => parseInt(digits, 16));
