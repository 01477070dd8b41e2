// All keys, which users may change, and what the mouse and the fingers do.

import { useState } from "preact/hooks";
import { Button, Row } from "./controls";
import { Dialog } from "./dialog";
import { chooseKey, keyActions, keysOf, type KeyAction } from "./key_actions";
import { keyOf } from "./keys";
import { forgetOwnKeys, ownKeys } from "./own_keys";

const kPointer = [
  ["Left", "Paint with the brush"],
  ["Ctrl+Left", "Paint the opposite: sharpen instead of smooth"],
  ["Shift+Left", "Restore the original (β = 1)"],
  ["Middle, Alt+Left", "Turn"],
  ["Shift+Middle, Right", "Move"],
  ["Click, right", "Menu of the point: look there, views, its position"],
  ["Double click, middle", "Turn about the point and come nearer"],
  ["Ctrl+Shift+Right", "Move the lamp"],
  ["Wheel", "Zoom at the cursor"],
  ["Space (hold)", "Show the original"],
  ["One finger", "Paint with the brush"],
  ["Two fingers", "Turn, and zoom by their distance"],
] as const;

const Table = ({ name, rows }: { name: string; rows: readonly (readonly [string, string])[] }) => (
  <table aria-label={name}>
    <tbody>
      {rows.map(([key, means]) => (
        <tr key={key}>
          <th scope="row">{key}</th>
          <td>{means}</td>
        </tr>
      ))}
    </tbody>
  </table>
);

const kModifiers = ["Shift", "Control", "Alt", "Meta", "AltGraph"];

/** The keys of actions. A press of a button there waits for the next key. */
function Keys() {
  const [changed, setChanged] = useState<KeyAction | null>(null);
  const [problem, setProblem] = useState("");
  const take = (event: KeyboardEvent, action: KeyAction) => {
    if (kModifiers.includes(event.key)) return;
    event.preventDefault();
    event.stopPropagation();
    setProblem(event.key === "Escape" ? "" : chooseKey(action, keyOf(event)));
    setChanged(null);
  };
  const textOf = (action: KeyAction) => (changed === action ? "press a key" : keysOf(action).join(", "));
  const button = (action: KeyAction) => (
    <button
      type="button"
      class="key"
      aria-label={`Change ${textOf(action)}: ${action.means}`}
      aria-pressed={changed === action}
      onClick={() => setChanged(changed === action ? null : action)}
      onBlur={() => setChanged(null)}
      onKeyDown={(event) => changed === action && take(event, action)}
    >
      {textOf(action)}
    </button>
  );
  return (
    <div>
      <table aria-label="Keys">
        <tbody>
          {keyActions.map((one) => (
            <tr key={one.name}>
              <th scope="row">{one.name === "cancel" ? "Escape" : button(one)}</th>
              <td>{one.means}</td>
            </tr>
          ))}
        </tbody>
      </table>
      <p class={problem ? "bad" : "faint"} role="status">
        {problem || "A press of a key here changes it."}
      </p>
    </div>
  );
}

export function KeyHelp({ onClose }: { onClose: () => void }) {
  const [resets, setResets] = useState(0);
  return (
    <Dialog title="Keys" onClose={onClose}>
      <div class="keys">
        <Table name="Mouse and fingers" rows={kPointer} />
        <Keys key={resets} />
      </div>
      <Row>
        <Button label="Close" onClick={onClose} />
        <Button
          label="Default keys"
          disabled={Object.keys(ownKeys()).length === 0}
          onClick={() => {
            forgetOwnKeys();
            setResets(resets + 1);
          }}
        />
      </Row>
    </Dialog>
  );
}
