// Gains by the size of detail, over a plot of what they do.

import { useState } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { Button, Check, Row } from "./controls";
import { isViewer, type PanelProps } from "./filter_panel";
import { Slider, linear, logarithmic } from "./slider";
import type { Band, Document } from "./snapshot";
import { fixed, short } from "./words";

const kGainShown = 3; // the sliders' end; larger gains are typed
const kBandRatioMin = 1.2;
const kWaveCellsMin = 2;

export function EqualiserPanel({ document }: PanelProps) {
  const link = useLink();
  const [showsSizes, setShowsSizes] = useState(false);
  const disabled = isViewer(document);
  const bands = document.bands;
  if (bands.length === 0)
    return (
      <>
        <Button
          label="Make bands"
          class="wide"
          hint="Splits the surface's detail by size. Each band gets a gain, and a brush can paint it."
          disabled={disabled || document.keepsEdges}
          onClick={() => link.send(command.firstBands())}
        />
        {document.keepsEdges && (
          <div class="faint">Bands have the scan's noise. Keep no edges to make them.</div>
        )}
      </>
    );
  return (
    <>
      <Response values={document.response} />
      {bands.map((band, i) => (
        <BandSliders key={i} {...{ document, band, showsSizes }} number={i + 1} />
      ))}
      <Check
        label="Sizes"
        on={showsSizes}
        hint="Shows the size at which each band ends, in the scan's units"
        onChange={setShowsSizes}
      />
      <Row>
        <Button
          label="All gains 1"
          disabled={disabled}
          onClick={() => link.send(command.bands(bands.map((band) => ({ ...band, gain: 1 }))))}
        />
        <Button label="Remove bands" disabled={disabled} onClick={() => link.send(command.bands([]))} />
      </Row>
    </>
  );
}

function Response({ values }: { values: number[] }) {
  const kWidth = 240;
  const kHeight = 70;
  const most = Math.max(2, 1.1 * Math.max(0, ...values));
  const y = (value: number) => (kHeight * (1 - value / most)).toFixed(1);
  const points = values.map((value, i) => `${(i * kWidth) / (values.length - 1)},${y(value)}`);
  return (
    <svg
      class="response"
      viewBox={`0 0 ${kWidth} ${kHeight}`}
      preserveAspectRatio="none"
      role="img"
      aria-label="How much of a wave is left or added, from two cells of the grid to the whole scan"
    >
      <line class="one" x1={0} x2={kWidth} y1={y(1)} y2={y(1)} />
      <polyline points={points.join(" ")} />
    </svg>
  );
}

function sizeScale(document: Document, number: number) {
  const before = document.bands[number - 2];
  const after = document.bands[number];
  const least = before ? kBandRatioMin * before.size : kWaveCellsMin * document.cellSize;
  const most = after ? after.size / kBandRatioMin : document.diagonal;
  return least < most ? logarithmic(least, most) : null;
}

function BandSliders(props: { document: Document; band: Band; number: number; showsSizes: boolean }) {
  const { document, band, number, showsSizes } = props;
  const link = useLink();
  const disabled = isViewer(document);
  const line = (part: Partial<Band>) =>
    command.bands(document.bands.map((one, i) => (i === number - 1 ? { ...one, ...part } : one)));
  const sizes = showsSizes ? sizeScale(document, number) : null;
  return (
    <>
      <div class="faint">{band.details}</div>
      <Slider
        name={`Gain of band ${number}`}
        value={band.gain}
        scale={linear(0, Math.max(kGainShown, band.gain))}
        format={fixed(2)}
        disabled={disabled}
        onMove={(gain) => link.send(command.preview(line({ gain })))}
        onDone={(gain) => link.send(line({ gain }))}
      />
      {sizes && (
        <Slider
          name={`Size of band ${number}`}
          value={band.size}
          scale={sizes}
          format={short}
          disabled={disabled}
          onMove={(size) => link.send(command.preview(line({ size })))}
          onDone={(size) => link.send(line({ size }))}
        />
      )}
    </>
  );
}
