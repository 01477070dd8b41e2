// Offers the depths of the grid to open the session at.

import { command } from "./commands";
import { useLink } from "./context";
import { Button } from "./controls";
import { Dialog } from "./dialog";
import type { Document } from "./snapshot";
import { capital } from "./words";

export function DepthDialog({ document, onClose }: { document: Document; onClose: () => void }) {
  const link = useLink();
  return (
    <Dialog title="Open again at depth" onClose={onClose}>
      <p class="faint">Opens a copy of the session with all its edits.</p>
      <ul class="depths">
        {document.depths.map((one) => (
          <li key={one.depth}>
            <Button
              label={one.possible ? capital(one.text) : `Depth ${one.depth}: ${one.text}`}
              pressed={one.depth === document.depth}
              disabled={!one.possible || one.depth === document.depth}
              onClick={() => {
                link.send(command.depth(one.depth));
                onClose();
              }}
            />
          </li>
        ))}
      </ul>
      <Button label="Cancel" onClick={onClose} />
    </Dialog>
  );
}
