// Asks for the name and the kind of an exported mesh.

import { useState } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button, Check, Choice, Row } from "./controls";
import { Dialog } from "./dialog";
import type { Document } from "./snapshot";

export function ExportDialog({ document, onClose }: { document: Document; onClose: () => void }) {
  const link = useLink();
  const [name, setName] = useState(document.session);
  const [kind, setKind] = useState(document.formats[0] ?? "ply");
  const [exact, setExact] = useState(true);
  const [record, setRecord] = useState(false);
  const take = () => {
    link.send(command.exportMesh(`${name.trim()}.${kind}`, exact, record));
    onClose();
  };
  return (
    <Dialog title="Export" onClose={onClose}>
      <div class="labelled">
        <span aria-hidden="true">Name</span>
        <input
          type="text"
          aria-label="Name of the file"
          value={name}
          onInput={(event) => setName(event.currentTarget.value)}
        />
      </div>
      <Choice
        name="Format"
        labelled
        value={kind}
        choices={document.formats.map((one) => [one, "." + one] as const)}
        onChange={setKind}
      />
      <Check
        label="Exact"
        on={exact}
        hint="Solves to the last digit first, which takes longer."
        onChange={setExact}
      />
      <Check
        label="Processing record"
        on={record}
        hint="Also writes who did what, how far the surface moved, and the hashes of both files: a page to print and JSON, beside the file."
        onChange={setRecord}
      />
      <p class="faint">The browser keeps the file among its downloads.</p>
      <Row>
        <Button label="Export" class="strong" disabled={name.trim() === ""} onClick={take} />
        <Button label="Cancel" onClick={onClose} />
      </Row>
    </Dialog>
  );
}
