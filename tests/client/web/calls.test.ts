import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";
import { Calls } from "../../../client/web/engine/calls";
import type { CallEnd } from "../../../client/web/engine/heard";

/** A socket whose other end is the test. */
class FakeSocket {
  static readonly OPEN = 1;
  static made: FakeSocket[] = [];
  readyState = 0;
  bufferedAmount = 0;
  readonly sent: (string | Uint8Array)[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: string | ArrayBuffer }) => void) | null = null;
  onclose: ((event: { reason: string }) => void) | null = null;

  constructor(
    readonly url: string,
    readonly protocol: string,
  ) {
    FakeSocket.made.push(this);
  }

  send(frame: string | Uint8Array): void {
    this.sent.push(frame);
  }

  open(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen?.();
  }

  say = (end: object) => this.onmessage?.({ data: JSON.stringify(end) });
  bring = (...bytes: number[]) => this.onmessage?.({ data: new Uint8Array(bytes).buffer });

  close(reason = ""): void {
    this.readyState = 3;
    this.onclose?.({ reason });
  }
}
Object.assign(globalThis, { WebSocket: FakeSocket });

const kEdit = "burnish.v1.Editing/Edit";
const kList = "burnish.v1.Library/ListScans";
let heard: string[];
let later: (() => void)[];
let calls: Calls;

/** Runs what was put off, as the event loop does. */
function settle(): void {
  while (later.length > 0) later.shift()!();
}

beforeEach(() => {
  heard = [];
  later = [];
  FakeSocket.made = [];
  const events = {
    message: (call: number, bytes: Uint8Array) => void heard.push(`${call}: ${[...bytes]}`),
    ended: (call: number, { code, message, details }: CallEnd) =>
      void heard.push(`${call} ended ${code} ${message}` + (details.length > 0 ? ` with ${[...details]}` : "")),
  };
  calls = new Calls("https://lab:7443", events, (work) => later.push(work));
});

const socket = (number: number) => FakeSocket.made[number]!;

test("CallIsSentOnceTheSocketIsOpen", () => {
  calls.setWho({ user: "mia", token: "s3cret" });
  const call = calls.open(kList);
  calls.send(call, new Uint8Array([7, 8]));
  calls.end(call);
  assert.equal(calls.buffered(call), 2);
  assert.deepEqual([socket(0).url, socket(0).protocol], ["wss://lab:7443/rpc", "burnish.v1"]);
  socket(0).open();
  assert.deepEqual(socket(0).sent, [
    JSON.stringify({ call: kList, token: "s3cret", user: "mia" }),
    new Uint8Array([7, 8]),
    JSON.stringify({ end: true }),
  ]);
  socket(0).bufferedAmount = 5;
  assert.equal(calls.buffered(call), 5);
});

test("CallWithoutUserSaysNone", () => {
  calls.open(kList);
  socket(0).open();
  assert.deepEqual(socket(0).sent, [JSON.stringify({ call: kList })]);
});

test("SocketCarriesTheNextCallAfterTheEndOfTheLast", () => {
  const first = calls.open(kList);
  socket(0).open();
  socket(0).bring(1);
  socket(0).say({ code: 0, message: "" });
  settle();
  const second = calls.open(kList);
  assert.equal(FakeSocket.made.length, 1);
  socket(0).say({ code: 5, message: "no scan has it" });
  settle();
  assert.deepEqual(heard, [`${first}: 1`, `${first} ended 0 `, `${second} ended 5 no scan has it`]);
});

test("FifthCallWaitsForASocketAndEditDoesNot", () => {
  for (let i = 0; i < 5; ++i) calls.open(kList);
  assert.equal(FakeSocket.made.length, 4);
  calls.open(kEdit);
  assert.equal(FakeSocket.made.length, 5);
  FakeSocket.made.forEach((one) => one.open());
  socket(2).say({ code: 0, message: "" });
  assert.equal(socket(2).sent.length, 2);
});

test("MessagesWaitForLeaveAndTheEndForMessages", () => {
  const call = calls.open(kEdit);
  socket(0).open();
  for (const byte of [1, 2, 3]) socket(0).bring(byte);
  socket(0).say({ code: 14, message: "drained" });
  settle();
  assert.deepEqual(heard, [`${call}: 1`]);
  calls.pull(call);
  assert.equal(heard.length, 1); // not within a call of the core
  settle();
  assert.deepEqual(heard, [`${call}: 1`, `${call}: 2`]);
  calls.pull(call);
  settle();
  assert.deepEqual(heard.slice(2), [`${call}: 3`, `${call} ended 14 drained`]);
});

test("CancelledCallHearsItsEndAlone", () => {
  const running = calls.open(kEdit);
  socket(0).open();
  socket(0).bring(1);
  socket(0).bring(2);
  calls.cancel(running);
  calls.cancel(running);
  socket(0).bring(3);
  socket(0).say({ code: 1, message: "cancelled" });
  settle();
  assert.deepEqual(socket(0).sent.slice(1), [JSON.stringify({ cancel: true })]);
  assert.deepEqual(heard, [`${running}: 1`, `${running} ended 1 cancelled`]);
});

test("CallThatWaitsInLineIsCancelledWithoutASocket", () => {
  const all = Array.from({ length: 5 }, () => calls.open(kList));
  calls.cancel(all[4]!);
  settle();
  assert.deepEqual(heard, [`${all[4]} ended 1 cancelled`]);
  socket(0).open();
  socket(0).say({ code: 0, message: "" });
  assert.equal(socket(0).sent.length, 1);
});

test("LostSocketEndsItsCallAsUnavailable", () => {
  const lost = calls.open(kEdit);
  socket(0).open();
  socket(0).close("frame against the rules");
  const refused = calls.open(kEdit);
  socket(1).close();
  settle();
  assert.deepEqual(heard, [
    `${lost} ended 14 the connection to the server was lost: frame against the rules`,
    `${refused} ended 14 cannot reach the server https://lab:7443`,
  ]);
  assert.equal(FakeSocket.made.length, 2);
});

test("LostIdleSocketIsReplaced", () => {
  calls.open(kList);
  socket(0).open();
  socket(0).say({ code: 0, message: "" });
  socket(0).close();
  settle();
  assert.equal(heard.length, 1);
  calls.open(kList);
  assert.equal(FakeSocket.made.length, 2);
});

test("WordsThatAreNoEndAreAnInternalError", () => {
  const call = calls.open(kList);
  socket(0).open();
  socket(0).onmessage?.({ data: "{" });
  settle();
  assert.deepEqual(heard, [`${call} ended 13 the server's words are not understood`]);
});

test("EndHasTheDetailsOfGrpc", () => {
  const call = calls.open(kEdit);
  socket(0).open();
  socket(0).say({ code: 9, message: "moved", details: "0a036fff" });
  settle();
  assert.deepEqual(heard, [`${call} ended 9 moved with 10,3,111,255`]);
});

test("CallForAServerOfAFleetHasASocketThatNamesIt", () => {
  calls.open(kEdit, "two & more");
  assert.equal(socket(0).url, "wss://lab:7443/rpc?node=two%20%26%20more");
  for (let i = 0; i < 4; ++i) calls.open(kList);
  FakeSocket.made.slice(1).forEach((one) => one.open());
  calls.open(kList, "two"); // waits
  assert.equal(FakeSocket.made.length, 5);
  socket(3).say({ code: 0, message: "" });
  assert.equal(socket(5).url, "wss://lab:7443/rpc?node=two");
  assert.equal(socket(3).readyState, 3); // made room
});
