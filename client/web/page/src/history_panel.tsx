// The session's edits, newest first. Each can be switched off.

import { useState } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button, Row } from "./controls";
import { isViewer, type PanelProps } from "./filter_panel";
import type { Document, HistoryEntry } from "./snapshot";
import { timeOf } from "./words";

export function HistoryPanel({ document }: PanelProps) {
  const link = useLink();
  const disabled = isViewer(document);
  const isNamed = document.people.some((one) => one.me && one.user !== "");
  return (
    <>
      <Row>
        <Button
          label="Undo"
          hint={document.undoHint + (isNamed ? "" : " The start page asks for yours.")}
          disabled={disabled}
          onClick={() => link.send(command.undo())}
        />
        <Button
          label="Redo"
          hint={document.redoHint}
          disabled={disabled}
          onClick={() => link.send(command.redo())}
        />
      </Row>
      <ul class="entries" aria-label="Entries" tabIndex={0}>
        {document.history.map((entry) => (
          <Entry key={entry.number} {...{ document, entry }} />
        ))}
        {document.history.length === 0 && <li class="faint">no edits yet</li>}
      </ul>
      <Checkpoint document={document} />
    </>
  );
}

function Entry({ document, entry }: { document: Document; entry: HistoryEntry }) {
  const link = useLink();
  const disabled = isViewer(document);
  const made = `${timeOf(entry.time)}\nby ${entry.author || "somebody"}, number ${entry.number}`;
  const title = [entry.name, entry.details, made].filter((text) => text).join("\n");
  if (entry.kind === "checkpoint" && entry.superseded)
    return <li class="faint" title={title}>{`${entry.name}, set again later`}</li>;
  if (entry.kind === "checkpoint")
    return (
      <li title={title}>
        <Button
          label="Restore"
          name={`Restore ${entry.name}`}
          hint="Goes back to this state. The edits after it are switched off."
          disabled={disabled}
          onClick={() => link.send(command.restore(entry.name))}
        />
        <span class="accent">{entry.name}</span>
        <Author {...{ document, entry }} />
      </li>
    );
  return (
    <li title={title}>
      <label class={entry.enabled ? "check" : "check faint"}>
        <input
          type="checkbox"
          aria-label={`Entry ${entry.number}: ${entry.name}`}
          checked={entry.enabled}
          disabled={disabled || entry.kind === "damaged"}
          onChange={(event) => {
            event.currentTarget.checked = entry.enabled; // the server's answer switches it
            link.send(command.switchEntry(entry.number, !entry.enabled));
          }}
        />
        {entry.name}
      </label>
      <Author {...{ document, entry }} />
    </li>
  );
}

/** Names who made an edit, where several people did. */
function Author({ document, entry }: { document: Document; entry: HistoryEntry }) {
  if (document.history.every((one) => one.author === entry.author)) return null;
  return <span class="faint author">{entry.author || "guest"}</span>;
}

function Checkpoint({ document }: PanelProps) {
  const link = useLink();
  const [typed, setTyped] = useState("");
  const name = typed.trim();
  const isThere = document.history.some(
    (entry) => entry.kind === "checkpoint" && entry.name === name,
  );
  const set = () => {
    if (isThere)
      return link.refuse(`checkpoint ${name} is there already; choose another name`);
    link.send(command.checkpoint(name));
    setTyped("");
  };
  const fork = () => {
    link.send(command.fork(name));
    setTyped("");
  };
  return (
    <>
      <input
        type="text"
        class="wide"
        aria-label="Name of a checkpoint or fork"
        placeholder="name of a checkpoint or fork"
        title="A checkpoint needs a name. A fork without one gets a name from the server."
        maxLength={200}
        value={typed}
        onInput={(event) => setTyped(event.currentTarget.value)}
      />
      <Row>
        <Button
          label="Checkpoint"
          hint="Gives the current state a name, so that you can come back to it."
          disabled={name === "" || isViewer(document)}
          onClick={set}
        />
        <Button label="Fork" hint="Opens a new session with all edits of this session." onClick={fork} />
      </Row>
    </>
  );
}
