// What the program is, and where its documents are.

import { Button, Row } from "./controls";
import { Dialog } from "./dialog";
import type { AboutText } from "./snapshot";

export function AboutDialog({ texts, onClose }: { texts: AboutText[]; onClose: () => void }) {
  return (
    <Dialog title="About Burnish" onClose={onClose}>
      <dl class="about">
        {texts.map(({ title, text }) => (
          <div key={title}>
            <dt class="faint">{title}</dt>
            <dd>{text}</dd>
          </div>
        ))}
      </dl>
      <Row>
        <Button label="Close" onClick={onClose} />
      </Row>
    </Dialog>
  );
}
