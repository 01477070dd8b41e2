// The filter of the scan's colours.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Title } from "./controls";
import { alphaOf, isViewer, swapAlpha, type PanelProps } from "./filter_panel";
import { Slider, betaScale, betaTone, linear, logarithmic } from "./slider";
import { short } from "./words";

const kWaveCellsMin = 2;

export function ColourPanel({ document }: PanelProps) {
  const link = useLink();
  const { beta, alpha } = document.colours;
  const disabled = isViewer(document);
  const least = kWaveCellsMin * document.cellSize;
  const most = document.diagonal;
  const ofSize = (size: number) => command.colours(beta, alphaOf(document, size));
  return (
    <>
      {document.view.colour !== "scan" && (
        <Button label="Show colours" class="wide" onClick={() => link.send(command.colour("scan"))} />
      )}
      <Title
        text="Gradient scale of colours"
        hint="Left evens the colours out, right makes them differ more. The shape does not move. Spots finer than a cell of the grid stay: a larger depth reaches them."
      />
      <Slider
        name="Gradient scale of colours"
        value={beta}
        scale={betaScale}
        format={short}
        tone={betaTone(beta)}
        disabled={disabled}
        onMove={(moved) => link.send(command.preview(command.colours(moved, alpha)))}
        onDone={(moved) => link.send(command.colours(moved, alpha))}
      />
      <Title
        text="Longest detail"
        hint="Colours that change over longer ways stay. In the scan's units"
      />
      <Slider
        name="Longest detail"
        value={Math.min(most, Math.max(least, swapAlpha(document, alpha)))}
        scale={logarithmic(least, most)}
        format={short}
        disabled={disabled}
        onMove={(size) => link.send(command.preview(ofSize(size)))}
        onDone={(size) => link.send(ofSize(size))}
      />
      <Button
        label="Keep colours"
        class="wide"
        hint="Sets the gradient scale to 1. Painted colours stay painted."
        disabled={disabled}
        onClick={() => link.send(command.colours(1, alpha))}
      />
      <Texture document={document} />
    </>
  );
}

export const kTextureGainMax = 4;

function Texture({ document }: PanelProps) {
  const link = useLink();
  const { gain, removeLight, levelSeams, seams, hasPictures } = document.texture;
  return (
    <>
      <Title
        text="Texture gain"
        hint="Details of the colours that are finer than a cell of the grid: left fades them, right makes them stronger"
      />
      <Slider
        name="Texture gain"
        value={gain}
        scale={linear(0, kTextureGainMax)}
        format={short}
        disabled={isViewer(document)}
        onMove={(moved) => link.send(command.preview(command.texture(moved, removeLight, levelSeams)))}
        onDone={(moved) => link.send(command.texture(moved, removeLight, levelSeams))}
      />
      <Title
        text="Remove light"
        hint="How much goes of the light that was there when the colours were taken"
      />
      <Slider
        name="Remove light"
        value={removeLight}
        scale={linear(0, 1)}
        format={short}
        disabled={isViewer(document)}
        onMove={(moved) => link.send(command.preview(command.texture(gain, moved, levelSeams)))}
        onDone={(moved) => link.send(command.texture(gain, moved, levelSeams))}
      />
      {hasPictures && (
        <>
          <Title
            text="Level seams"
            hint="How much goes of the steps of brightness between photos. The server bakes them anew"
          />
          <Slider
            name="Level seams"
            value={levelSeams}
            scale={linear(0, 1)}
            format={short}
            disabled={isViewer(document)}
            onMove={(moved) => link.send(command.preview(command.texture(gain, removeLight, moved)))}
            onDone={(moved) => link.send(command.texture(gain, removeLight, moved))}
          />
        </>
      )}
      {seams && <div class="faint">{seams}</div>}
    </>
  );
}
