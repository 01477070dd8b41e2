// Cores as they come from a web server.

/** Ends the names of cores that a publication has packed by gzip: few web servers pack them on their way. */
const kPacked = ".packed";

/** Compiles a core while it comes, whatever type the web server gives it. Fails with a sentence for the user. */
export async function compileCore(address: string): Promise<WebAssembly.Module> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address}: the server answers ${answer.status}`);
  return WebAssembly.compileStreaming(plain(address, answer)).catch((error) => {
    throw new Error(`${address} is damaged or cut off (${error})`);
  });
}

/** Returns an answer of the right type, not packed. An answer as it came lets the browser keep what it compiles. */
function plain(address: string, answer: Response): Response {
  const isPacked = address.endsWith(kPacked);
  if (!isPacked && answer.headers.get("Content-Type")?.startsWith("application/wasm")) return answer;
  const body = isPacked ? answer.body!.pipeThrough(new DecompressionStream("gzip")) : answer.body;
  return new Response(body, { headers: { "Content-Type": "application/wasm" } });
}
