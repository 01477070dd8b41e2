// The airbrush.

import { useRef } from "preact/hooks";
import { command } from "./commands";
import { kTextureGainMax } from "./colour_panel";
import { useLink } from "./context";
import { Button, Check, Choice, Row, Title } from "./controls";
import { isViewer, type PanelProps } from "./filter_panel";
import { Slider, betaScale, betaTone, linear, logarithmic } from "./slider";
import type { Axis, Brush, Document, FallOff } from "./snapshot";
import { fixed, short } from "./words";

const kAxes: Axis[] = ["x", "y", "z"];
const kModes = [
  ["Smooth", 0],
  ["Restore", 1],
  ["Sharpen", 2],
] as const;
const kEdgeModes = [
  ["Keep here", 0],
  ["Denoise here", 1],
] as const;
const kTextureModes = [
  ["Fade", 0],
  ["Restore", 1],
  ["Strengthen", 2],
] as const;
/** What is no β: the buttons, the slider's name, its most, and the first value. */
const kOwnValues: Record<string, { modes: readonly (readonly [string, number])[]; name: string; most: number; first: number }> = {
  edges: { modes: kEdgeModes, name: "Painted strength", most: 1, first: 1 },
  texture: { modes: kTextureModes, name: "Painted gain", most: kTextureGainMax, first: 2 },
};
const kFallOffs = [
  ["smooth", "Smooth"],
  ["linear", "Linear"],
  ["sharp", "Sharp"],
  ["constant", "Constant"],
] as const;

const kOfColours: [string, string][] = [
  ["colour", "Gradient scale of colours"],
  ["texture", "Texture gain"],
];

/** Returns what a brush of this session can paint, with the words of the window. */
export function paintable(document: Document): [string, string][] {
  return [
    ["beta", "Gradient scale β"],
    ["edges", "Strength of kept edges"],
    ...(document.hasColours ? kOfColours : []),
    ...document.bands.map((band, i): [string, string] => [`band:${i + 1}`, `Gain of ${band.details}`]),
    ...document.palette.map((one, i): [string, string] => [`curve:${i + 1}`, `Curve ${one.name}`]),
  ];
}

export function BrushPanel({ document }: PanelProps) {
  const link = useLink();
  const brush = document.brush;
  const disabled = isViewer(document);
  const paintsCurve = brush.paints.startsWith("curve:");
  const change = (part: Partial<Brush>) => link.send(command.brush({ ...brush, ...part }));
  const beta = useRef(0); // of the brush, while it paints something else
  const paintInstead = (paints: string) => {
    const [before, after] = [kOwnValues[brush.paints], kOwnValues[paints]];
    if (before === after) return change({ paints });
    if (!before) beta.current = brush.beta;
    change({ paints, beta: after ? after.first : beta.current });
  };
  const modes = kOwnValues[brush.paints]?.modes ?? kModes;
  return (
    <>
      <Row>
        {modes.map(([label, beta]) => (
          <Button
            key={label}
            label={label}
            pressed={brush.beta === beta}
            disabled={disabled || paintsCurve}
            onClick={() => change({ beta })}
          />
        ))}
      </Row>
      <Choice
        name="Paints"
        labelled
        value={brush.paints}
        choices={paintable(document)}
        disabled={disabled}
        onChange={paintInstead}
      />
      {!paintsCurve && <PaintedValue {...{ document, change }} />}
      <Title text="Radius" note="in the scan's units" />
      <Slider
        name="Radius"
        value={brush.radius}
        scale={logarithmic(1e-4 * document.diagonal, 0.5 * document.diagonal)}
        format={short}
        disabled={disabled}
        onDone={(radius) => change({ radius })}
        onMove={(radius) => change({ radius })}
      />
      <Title text="Strength" />
      <Slider
        name="Strength"
        value={brush.strength}
        scale={linear(0.01, 1)}
        format={fixed(2)}
        disabled={disabled}
        onDone={(strength) => change({ strength })}
      />
      {document.hasPen && (
        <Check
          label="Pen pressure"
          on={document.penPressure}
          disabled={disabled}
          hint="The harder the pen presses, the stronger the brush. Full pressure has the strength above."
          onChange={(on) => link.send(command.pen(on))}
        />
      )}
      <Choice<FallOff>
        name="Fall-off"
        labelled
        value={brush.fallOff}
        choices={kFallOffs}
        disabled={disabled}
        onChange={(fallOff) => change({ fallOff })}
      />
      <Check
        label="Through walls"
        on={brush.through}
        disabled={disabled}
        hint="Paints all surface in the ball, the other side of a thin wall too. Without it the brush paints what hangs together with the place under the pointer."
        onChange={(through) => change({ through })}
      />
      <Mirror document={document} />
    </>
  );
}

function PaintedValue(props: PanelProps & { change: (part: Partial<Brush>) => void }) {
  const brush = props.document.brush;
  const own = kOwnValues[brush.paints];
  const name = own?.name ?? (brush.paints.startsWith("band:") ? "Painted gain" : "Painted β");
  return (
    <>
      <Title text={name} />
      <Slider
        name={name}
        value={brush.beta}
        scale={own ? linear(0, own.most) : betaScale}
        format={short}
        tone={own ? undefined : betaTone(brush.beta)}
        disabled={isViewer(props.document)}
        onDone={(beta) => props.change({ beta })}
      />
    </>
  );
}

function Mirror({ document }: PanelProps) {
  const link = useLink();
  const mirror = document.mirror;
  const axis = mirror ? kAxes.indexOf(mirror.axis) : -1;
  return (
    <>
      <Choice<Axis | "off">
        name="Mirror"
        labelled
        hint="Paints each stroke on both sides of a plane, as one step."
        value={mirror?.axis ?? "off"}
        disabled={isViewer(document)}
        choices={[["off", "Off"], ["x", "Across x"], ["y", "Across y"], ["z", "Across z"]]}
        onChange={(chosen) => link.send(command.mirror(chosen))}
      />
      {mirror && (
        <Slider
          name="Mirror plane"
          value={mirror.at}
          scale={linear(document.box.low[axis]!, document.box.high[axis]!)}
          format={(value) => String(Number(value.toPrecision(4)))}
          disabled={isViewer(document)}
          onMove={(at) => link.send(command.mirror(mirror.axis, at))}
          onDone={(at) => link.send(command.mirror(mirror.axis, at))}
        />
      )}
    </>
  );
}
