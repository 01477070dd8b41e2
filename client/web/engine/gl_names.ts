// OpenGL's numbers of objects for the objects of WebGL. 0 is none.

export class Names<Object> {
  private readonly objects: (Object | null)[] = [null];
  private readonly free: number[] = [];

  add(object: Object): number {
    const name = this.free.pop() ?? this.objects.length;
    this.objects[name] = object;
    return name;
  }

  get(name: number): Object | null {
    return this.objects[name] ?? null;
  }

  remove(name: number): Object | null {
    const object = this.get(name);
    if (object === null) return null;
    this.objects[name] = null;
    this.free.push(name);
    return object;
  }
}

/** Numbers of the uniforms of programs, so that each is looked up once. */
export class Uniforms {
  private readonly places: (WebGLUniformLocation | null)[] = [];
  private readonly ofProgram = new Map<number, Map<string, number>>();

  constructor(private readonly gl: WebGL2RenderingContext) {}

  /** Returns -1 if the program has no such uniform. */
  number(program: number, object: WebGLProgram, name: string): number {
    const known = this.ofProgram.get(program) ?? new Map<string, number>();
    this.ofProgram.set(program, known);
    const number = known.get(name);
    if (number !== undefined) return number;
    const place = this.gl.getUniformLocation(object, name);
    const made = place ? this.places.push(place) - 1 : -1;
    known.set(name, made);
    return made;
  }

  place(number: number): WebGLUniformLocation | null {
    return this.places[number] ?? null;
  }

  forget(program: number): void {
    for (const number of this.ofProgram.get(program)?.values() ?? []) if (number >= 0) this.places[number] = null;
    this.ofProgram.delete(program);
  }
}
