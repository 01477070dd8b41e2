// All keys, and what the mouse and the fingers do.

import { Button } from "./controls";
import { Dialog } from "./dialog";
import { keyActions } from "./keys";

const kPointer = [
  ["Left", "Paint with the brush"],
  ["Ctrl+Left", "Paint the opposite: sharpen instead of smooth"],
  ["Shift+Left", "Restore the original (β = 1)"],
  ["Middle, Alt+Left", "Turn"],
  ["Shift+Middle, Right", "Move"],
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

export function KeyHelp({ onClose }: { onClose: () => void }) {
  return (
    <Dialog title="Keys" onClose={onClose}>
      <div class="keys">
        <Table name="Mouse and fingers" rows={kPointer} />
        <Table name="Keys" rows={keyActions.map((one) => [one.keys.join(", "), one.means] as const)} />
      </div>
      <Button label="Close" onClick={onClose} />
    </Dialog>
  );
}
