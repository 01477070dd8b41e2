// Says what the browser lacks, in place of the page.

import type { MissingPart } from "./support";

export function Unsupported({ missing, does }: { missing: MissingPart[]; does: "edit" | "show" }) {
  return (
    <main class="start">
      <h1>Burnish</h1>
      <p role="alert">{`This browser cannot ${does} scans. It lacks:`}</p>
      <ul>
        {missing.map((one) => (
          <li key={one.name}>
            {one.name}, which has been in {one.since}
          </li>
        ))}
      </ul>
      {does === "edit" && (
        <p class="faint">
          The programs burnish (a window) and burnish edit (a command) work with the same server, without a browser.
        </p>
      )}
    </main>
  );
}
