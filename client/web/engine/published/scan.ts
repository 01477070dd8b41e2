// scan.json of a publication: docs/formats.md describes it, client/publish/scan_json.cpp writes it.

export interface PublishedScan {
  burnish_publication: number;
  title: string;
  credit: string;
  scan: string;
  session: string;
  unit: string;
  triangles: number;
  record: { session_id: string };
  parts: { file: string; index: string; blocks: number; pages: number; sheets_per_page: number };
  /** The message that answers each call, in base64. */
  answers: Record<string, string>;
  /** The first message of the live session, and a Frame without data. */
  welcome: string;
  frame: string;
  /** Of the whole surface, cells. */
  largest_move: number;
}

const kVersion = 1;

/** Fails with a sentence for the user. */
export async function readScan(address: string): Promise<PublishedScan> {
  const answer = await fetch(address, { cache: "no-cache" }).catch((error) => {
    throw new Error(`The web server does not answer for scan.json (${error}). Load the page again.`);
  });
  if (!answer.ok) throw new Error(`The web server has no scan.json beside this page: it answers ${answer.status}.`);
  const scan = (await answer.json().catch(() => null)) as PublishedScan | null;
  if (!scan?.burnish_publication)
    throw new Error("scan.json beside this page is cut off, or not of a publication: copy the whole folder again.");
  if (scan.burnish_publication === kVersion) return scan;
  throw new Error(`scan.json has version ${scan.burnish_publication}; this viewer reads version ${kVersion}.`);
}

export const fromBase64 = (text: string): Uint8Array => Uint8Array.from(atob(text), (one) => one.charCodeAt(0));
