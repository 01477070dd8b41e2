// The curves that a brush can paint.

import { command, type PaletteText } from "./commands";
import { useLink } from "./context";
import { Button, NameField, useOver } from "./controls";
import { isViewer, type PanelProps } from "./filter_panel";
import type { Document } from "./snapshot";
import { hexColour } from "./words";

const kCurvesMax = 8;
// Colours that are easy to tell apart.
const kColours = [
  0xd9534f, 0x4a7fd0, 0x4caf6d, 0xe0a030, 0x9b6bd3, 0x36b3b3, 0xd06fa8, 0x8a8a5a,
];

export function PalettePanel({ document }: PanelProps) {
  useOver("curves");
  const link = useLink();
  const palette = document.palette;
  const disabled = isViewer(document);
  const add = (name: string) => {
    const colour = kColours[palette.length % kColours.length]!;
    link.send(command.palette([...palette, { name, colour, curve: document.curve.text }]));
  };
  return (
    <>
      {palette.map((curve, i) => (
        <CurveRow key={i} {...{ document, curve }} index={i} />
      ))}
      {palette.length < kCurvesMax && (
        <NameField
          name="Name of the curve"
          label="name for this curve"
          button="Add"
          hint="Adds the transfer curve as it is. A brush then paints where it rules."
          disabled={disabled}
          onTake={add}
        />
      )}
      {palette.length > 0 && (
        <Button
          label="Remove the last curve"
          class="wide"
          disabled={disabled}
          onClick={() => link.send(command.palette(palette.slice(0, -1)))}
        />
      )}
    </>
  );
}

function CurveRow(props: { document: Document; curve: PaletteText; index: number }) {
  const { document, curve, index } = props;
  const link = useLink();
  const disabled = isViewer(document);
  const word = `curve:${index + 1}`;
  const isPainted = document.brush.paints === word;
  const line = (part: Partial<PaletteText>) =>
    command.palette(document.palette.map((one, i) => (i === index ? { ...one, ...part } : one)));
  const colourOf = (event: Event) =>
    parseInt((event.target as HTMLInputElement).value.slice(1), 16);
  return (
    <div class="palette-row">
      <input
        type="color"
        aria-label={`Colour of ${curve.name}`}
        value={hexColour(curve.colour)}
        disabled={disabled}
        onInput={(event) => link.send(command.preview(line({ colour: colourOf(event) })))}
        onChange={(event) => link.send(line({ colour: colourOf(event) }))}
      />
      <Button
        label={curve.name}
        class="name"
        hint="The brush paints where this curve rules"
        pressed={isPainted}
        disabled={disabled}
        onClick={() =>
          link.send(command.panel("commit", isPainted ? "beta" : word, "Brush/Paints"))
        }
      />
      <Button
        label="set"
        name={`Set ${curve.name}`}
        hint="Takes the transfer curve as it is above"
        disabled={disabled}
        onClick={() => link.send(line({ curve: document.curve.text }))}
      />
      <Button
        label="show"
        name={`Show ${curve.name}`}
        hint="Makes it the transfer curve of all that is not painted"
        disabled={disabled}
        onClick={() => link.send(command.curve(curve.curve))}
      />
    </div>
  );
}
