// A slow network in this process, as tests/system/link.h: it takes connections on a port of the loopback, and passes
// bytes to a web server and back with limited speed and a delay. It also tells what was asked for.

import { connect, createServer, type AddressInfo, type Server, type Socket } from "node:net";

export interface LinkOptions {
  /** Each direction, for all connections together. */
  megabitsPerSecond: number;
  roundTripMs: number;
}

/** A request, as the link saw it. */
export interface Asked {
  path: string;
  /** Of performance.now(). */
  at: number;
  /** Of its answer, with headers, so far. */
  bytes: number;
}

const kWaitingBytesMax = 1 << 16; // of a connection, as in a router

/** One direction of the link. */
class Direction {
  private freeAt = 0;

  constructor(private readonly options: LinkOptions) {}

  /** Returns when bytes that set out now, or at `from`, have crossed. */
  arrival(bytes: number, from = 0): number {
    const bytesPerMs = this.options.megabitsPerSecond * 125;
    this.freeAt = Math.max(performance.now(), from, this.freeAt) + bytes / bytesPerMs;
    return this.freeAt + this.options.roundTripMs / 2;
  }
}

/** The bytes of a connection on their way in one direction, in their order. */
class Way {
  private readonly queue: { at: number; bytes: Buffer }[] = [];
  private waiting = 0;
  private isRunning = false;

  constructor(
    private readonly direction: Direction,
    private readonly from: Socket,
    private readonly to: Socket,
    private readonly opensAt: number,
    private readonly see: (bytes: Buffer) => void,
  ) {
    from.on("data", (bytes: Buffer) => this.send(bytes));
    from.on("end", () => this.send(Buffer.alloc(0)));
    from.on("error", () => to.destroy());
  }

  private send(bytes: Buffer): void {
    this.queue.push({ at: this.direction.arrival(bytes.length, this.opensAt), bytes });
    this.waiting += bytes.length;
    if (this.waiting > kWaitingBytesMax) this.from.pause();
    if (!this.isRunning) this.run();
  }

  private run(): void {
    this.isRunning = this.queue.length > 0;
    if (this.isRunning) setTimeout(() => this.deliver(), Math.max(0, this.queue[0]!.at - performance.now()));
  }

  private deliver(): void {
    while (this.queue.length > 0 && this.queue[0]!.at <= performance.now()) {
      const { bytes } = this.queue.shift()!;
      this.waiting -= bytes.length;
      if (bytes.length > 0) this.to.write(bytes);
      else this.to.end();
      this.see(bytes);
    }
    if (this.waiting <= kWaitingBytesMax) this.from.resume();
    this.run();
  }
}

export class SlowLink {
  readonly asked: Asked[] = [];
  private readonly sockets = new Set<Socket>();

  private constructor(
    private readonly server: Server,
    /** The address to visit in place of the web server's. */
    readonly address: string,
  ) {}

  /** `target`: the address of a page. */
  static open(target: string, options: LinkOptions): Promise<SlowLink> {
    const url = new URL(target);
    const server = createServer({ noDelay: true });
    return new Promise((resolve) =>
      server.listen(0, "127.0.0.1", () => {
        const { port } = server.address() as AddressInfo;
        const link = new SlowLink(server, `http://127.0.0.1:${port}${url.pathname}`);
        const [up, down] = [new Direction(options), new Direction(options)];
        server.on("connection", (near: Socket) => link.join(near, url, up, down, options.roundTripMs));
        resolve(link);
      }),
    );
  }

  close(): void {
    this.server.close();
    for (const socket of this.sockets) socket.destroy();
  }

  /** A connection opens after a round trip: the browser sends nothing before. */
  private join(near: Socket, { hostname, port }: URL, up: Direction, down: Direction, roundTripMs: number): void {
    const far = connect({ host: hostname, port: Number(port), noDelay: true });
    for (const socket of [near, far]) {
      this.sockets.add(socket);
      socket.on("close", () => this.sockets.delete(socket));
    }
    let last: Asked | undefined; // the answers of a connection come in the order of its requests
    const seeRequest = (bytes: Buffer) => {
      const path = /^GET (\S+) HTTP/.exec(bytes.toString("latin1"))?.[1];
      if (path) this.asked.push((last = { path, at: performance.now(), bytes: 0 }));
    };
    const seeAnswer = (bytes: Buffer) => {
      if (last) last.bytes += bytes.length;
    };
    new Way(up, near, far, performance.now() + roundTripMs, seeRequest);
    new Way(down, far, near, 0, seeAnswer);
  }
}
