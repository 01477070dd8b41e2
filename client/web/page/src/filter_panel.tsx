// Gradient scale, wavelength and presets: the edit outside of painted areas.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Choice, NameField, Title } from "./controls";
import { Slider, betaScale, betaTone, linear, logarithmic } from "./slider";
import type { Document, Preset, PresetInForce, Strengths } from "./snapshot";
import { StrengthPictures } from "./strength_pictures";
import { fixed, short } from "./words";

const kAlphaMin = 0.01;
const kAlphaMax = 1e5;
const kFidelityMin = 1;

/** The wavelength of alpha, and the other way round. Units: as the scan's. */
const swapAlpha = (document: Document, value: number) =>
  (2 * Math.PI * document.lengthUnit) / value;
const alphaOf = (document: Document, wavelength: number) =>
  Math.min(kAlphaMax, Math.max(kAlphaMin, swapAlpha(document, wavelength)));

export interface PanelProps {
  document: Document;
}

export const isViewer = (document: Document) => document.role === "viewer";

export interface PresetProps extends PanelProps {
  presets: Preset[];
  /** The one in force. */
  preset: PresetInForce | null;
  strengths: Strengths | null;
}

export function FilterPanel(props: PresetProps) {
  return (
    <>
      <Presets {...props} />
      <Beta document={props.document} />
      <Wavelength document={props.document} />
      <OwnPreset {...props} />
    </>
  );
}

function Presets({ document, presets, preset, strengths }: PresetProps) {
  const link = useLink();
  const disabled = isViewer(document);
  const shown = preset && presets.find((one) => one.name === preset.name);
  const choose = (name: string) => {
    if (name) link.send(command.preset(name, 1));
  };
  return (
    <>
      <Choice
        name="Presets"
        value={shown?.name ?? ""}
        hint={shown?.description}
        disabled={disabled}
        choices={[["", "Presets"] as const, ...presets.map((one) => [one.name, one.name] as const)]}
        onChange={choose}
      />
      {preset && shown?.changes && (
        <>
          <Title text="Strength" note={`${preset.word} of the preset`} hint={shown.description} />
          <Slider
            name="Strength of the preset"
            value={preset.strength}
            scale={linear(0, 1)}
            format={fixed(2)}
            disabled={disabled}
            onMove={(value) => link.send(command.preview(command.preset(preset.name, value)))}
            onDone={(value) => link.send(command.preset(preset.name, value))}
          />
          {!disabled && preset.hasTrial && <StrengthPictures preset={preset} strengths={strengths} />}
        </>
      )}
    </>
  );
}

/** Keeps what is set under a name, and deletes it again. */
function OwnPreset({ document, presets, preset }: PresetProps) {
  const link = useLink();
  const own = preset && presets.find((one) => one.own && one.name === preset.name);
  return (
    <>
      <NameField
        name="Name for this filter"
        label="name for this filter"
        button="Keep"
        hint="Keeps the gradient scale, the curve and the bands as a preset of your own"
        disabled={isViewer(document)}
        onTake={(name) => link.send(command.presetKeep(name))}
      />
      {own && (
        <Button
          label={`Delete ${own.name}`}
          hint="Deletes this preset of your own. The surface stays as it is."
          onClick={() => link.send(command.presetDelete(own.name))}
        />
      )}
    </>
  );
}

function Beta({ document }: PanelProps) {
  const link = useLink();
  return (
    <>
      <Title
        text="Gradient scale β"
        note={betaTone(document.beta)}
        hint="How much the whole surface is smoothed or sharpened, but for what is painted: on the left it is smoothed, in the middle it stays, on the right it is sharpened. Its slopes are multiplied by β."
      />
      <Slider
        name="Gradient scale β"
        value={document.beta}
        scale={betaScale}
        format={short}
        tone={betaTone(document.beta)}
        disabled={isViewer(document)}
        onMove={(beta) => link.send(command.preview(command.beta(beta)))}
        onDone={(beta) => link.send(command.beta(beta))}
      />
    </>
  );
}

function Wavelength({ document }: PanelProps) {
  const link = useLink();
  const least = swapAlpha(document, document.curve.alphaMax);
  return (
    <>
      <Title
        text="Wavelength"
        note={`fidelity α ${short(document.fidelity)}`}
        hint="In the scan's units. Waves of this length on the surface change by half, shorter ones more; longer waves stay. The slider begins at two cells of the grid."
      />
      <Slider
        name="Wavelength"
        value={swapAlpha(document, document.fidelity)}
        scale={logarithmic(least, swapAlpha(document, kFidelityMin))}
        format={short}
        disabled={isViewer(document)}
        onMove={(length) => link.send(command.preview(command.fidelity(alphaOf(document, length))))}
        onDone={(length) => link.send(command.fidelity(alphaOf(document, length)))}
      />
    </>
  );
}
