// The airbrush.

import { useRef } from "preact/hooks";
import { command } from "./commands";
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
const kFallOffs = [
  ["smooth", "Smooth"],
  ["linear", "Linear"],
  ["sharp", "Sharp"],
  ["constant", "Constant"],
] as const;

/** Returns what a brush of this session can paint, with the words of the window. */
export function paintable(document: Document): [string, string][] {
  return [
    ["beta", "Gradient scale β"],
    ["edges", "Strength of kept edges"],
    ...(document.hasColours ? ([["colour", "Gradient scale of colours"]] as [string, string][]) : []),
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
  const beta = useRef(0); // of the brush, while it paints a strength of kept edges
  const paintInstead = (paints: string) => {
    const paintsEdges = paints === "edges";
    if (paintsEdges === (brush.paints === "edges")) return change({ paints });
    if (paintsEdges) beta.current = brush.beta;
    change({ paints, beta: paintsEdges ? 1 : beta.current });
  };
  const modes = brush.paints === "edges" ? kEdgeModes : kModes;
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
  const paintsEdges = brush.paints === "edges";
  const name = paintsEdges
    ? "Painted strength"
    : brush.paints.startsWith("band:") ? "Painted gain" : "Painted β";
  return (
    <>
      <Title text={name} />
      <Slider
        name={name}
        value={brush.beta}
        scale={paintsEdges ? linear(0, 1) : betaScale}
        format={short}
        tone={paintsEdges ? undefined : betaTone(brush.beta)}
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
