// Says what the browser lacks, in place of the page.

import type { MissingPart } from "./support";

export function Unsupported({ missing }: { missing: MissingPart[] }) {
  return (
    <main class="start">
      <h1>Burnish</h1>
      <p role="alert">This browser cannot edit scans. It lacks:</p>
      <ul>
        {missing.map((one) => (
          <li key={one.name}>
            {one.name}, which has been in {one.since}
          </li>
        ))}
      </ul>
      <p class="faint">
        The programs burnish (a window) and burnish edit (a command) work with the same server, without a browser.
      </p>
    </main>
  );
}
