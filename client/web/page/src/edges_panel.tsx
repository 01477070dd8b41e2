// Noise goes and edges stay, before the filter smooths or sharpens.

import { command } from "./commands";
import { useLink } from "./context";
import { Choice, Title } from "./controls";
import { isViewer, type PanelProps } from "./filter_panel";
import { Slider, linear, logarithmic, type Scale } from "./slider";
import type { Document, Edges } from "./snapshot";
import { short } from "./words";

/** Says why the server would refuse kept edges; empty if it would not. */
function barToEdges({ bands, controls, edges }: Document): string {
  if (edges.strength > 0) return "";
  if (bands.length > 0) return "Bands have the scan's noise. Remove them to keep edges.";
  return controls.keepVolume ? "The volume stays. Let it change to keep edges." : "";
}
const isDisabled = (document: Document) => isViewer(document) || barToEdges(document) !== "";

export function EdgesPanel({ document }: PanelProps) {
  const link = useLink();
  const { edges, edgePresets } = document;
  const chosen = edges.strength > 0 ? edges.preset || "own" : "off";
  const choices: [string, string][] = [
    ["off", "Off"],
    ["auto", "For this scan"],
    ...edgePresets.map(({ name, title }): [string, string] => [name, title]),
  ];
  if (chosen === "own") choices.push(["own", "Own values"]);
  return (
    <>
      <div class="faint">Noise goes, edges stay, and what is sharpened is the surface without its noise.</div>
      {barToEdges(document) && <div class="faint">{barToEdges(document)}</div>}
      <Choice
        name="Kept edges"
        value={chosen}
        choices={choices}
        disabled={isDisabled(document)}
        onChange={(name) => {
          if (name === "off") link.send(command.noEdges());
          else if (name !== "own") link.send(command.keepEdges(name));
        }}
      />
      {edges.noise && <div class="faint">{edges.noise}</div>}
      <Values document={document} />
    </>
  );
}

interface ValueProps extends PanelProps {
  name: string;
  hint: string;
  scale: Scale;
  shown: number;
  part: (value: number) => Partial<Edges>;
}

function Value({ document, name, hint, scale, shown, part }: ValueProps) {
  const link = useLink();
  const line = (moved: number) => command.edges({ ...document.edges, ...part(moved) });
  return (
    <>
      <Title text={name} hint={hint} />
      <Slider
        name={name}
        value={shown}
        scale={scale}
        format={short}
        disabled={isDisabled(document)}
        onMove={(moved) => link.send(command.preview(line(moved)))}
        onDone={(moved) => link.send(line(moved))}
      />
    </>
  );
}

function Values({ document }: PanelProps) {
  const { edges } = document;
  const sizeOf = (passes: number) => edges.meanEdge * Math.sqrt(passes);
  const passesOf = (size: number) => Math.max(1, Math.min(edges.passesMax, Math.round((size / edges.meanEdge) ** 2)));
  return (
    <>
      <Value
        document={document}
        name="Strength of kept edges"
        hint="How much of the noise goes"
        scale={linear(0, 1)}
        shown={edges.strength}
        part={(strength) => ({ strength })}
      />
      <Value
        document={document}
        name="Crispness"
        hint="Low for relief, high for machined parts"
        scale={linear(0, 1)}
        shown={edges.crispness}
        part={(crispness) => ({ crispness })}
      />
      <Value
        document={document}
        name="Edge angle"
        hint="Degrees: sharper bends are edges, and stay"
        scale={linear(edges.angleMin, edges.angleMax)}
        shown={edges.angle}
        part={(angle) => ({ angle })}
      />
      <Value
        document={document}
        name="Noise size"
        hint="Noise of up to about this length goes, in the scan's units. More takes longer."
        scale={logarithmic(sizeOf(1), sizeOf(edges.passesMax))}
        shown={sizeOf(edges.passes)}
        part={(size) => ({ passes: passesOf(size) })}
      />
    </>
  );
}
