// Asks before a session is closed over edits that wait for the server.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Row } from "./controls";
import { Dialog } from "./dialog";
import { editsWait } from "./words";

export function LeaveQuestion({ edits, onClose }: { edits: number; onClose: () => void }) {
  const link = useLink();
  const discard = () => {
    onClose();
    link.send(command.close());
  };
  return (
    <Dialog title="Edits are not saved yet" onClose={onClose}>
      <p>{edits === 0 ? "All edits are saved now." : editsWait(edits)}</p>
      <Row>
        <Button label="Stay" class="strong" onClick={onClose} />
        <Button label={edits === 0 ? "Close session" : "Discard and close"} class="danger" onClick={discard} />
      </Row>
    </Dialog>
  );
}
