// The columns of panels beside the picture. A narrow page has one.

import { useEffect, useState } from "preact/hooks";
import { Section, Figures, useOver } from "./controls";
import { CurvePanel } from "./curve_panel";
import { EqualiserPanel } from "./equaliser_panel";
import { FilterPanel, type PanelProps, type PresetProps } from "./filter_panel";
import { Gradual } from "./gradual";
import { HistoryPanel } from "./history_panel";
import { NumbersPanel } from "./numbers_panel";
import { PalettePanel } from "./palette_panel";
import { PeoplePanel } from "./people_panel";
import { WidgetPanel } from "./widget_panel";

const kWide = "(min-width: 960px)";

/** Returns whether there is room for two columns. */
export const isWide = () => matchMedia(kWide).matches;

export function useIsWide(): boolean {
  const [wide, setIsWide] = useState(isWide);
  useEffect(() => {
    const media = matchMedia(kWide);
    const change = () => setIsWide(media.matches);
    media.addEventListener("change", change);
    return () => media.removeEventListener("change", change);
  }, []);
  return wide;
}

const SharedPanel = (props: PanelProps & { name: string; folded?: boolean }) => (
  <Section name={props.name} folded={props.folded}>
    <WidgetPanel {...props} />
  </Section>
);

export function EditColumn(props: PresetProps & { children?: preact.ComponentChildren }) {
  const { document, presets, preset, strengths } = props;
  return (
    <aside class="column left" aria-label="Edit">
      <Gradual>
        <Section name="Filter">
          <FilterPanel {...{ document, presets, preset, strengths }} />
        </Section>
        <Section name="Transfer curve α(κ)">
          <CurvePanel document={document} />
        </Section>
        <SharedPanel document={document} name="Brush" />
        <Section name="Limits">
          <LimitsPanel document={document} />
        </Section>
        <SharedPanel document={document} name="Keep edges" folded />
        <Section name="Equaliser" folded>
          <EqualiserPanel document={document} />
        </Section>
        <Section name="Palette" folded>
          <PalettePanel document={document} />
        </Section>
        {document.hasColours && <SharedPanel document={document} name="Colours" folded />}
        {props.children}
      </Gradual>
    </aside>
  );
}

function LimitsPanel({ document }: PanelProps) {
  useOver("protection");
  return (
    <>
      <WidgetPanel document={document} name="Limits" />
      {document.lasso !== "off" && (
        <div class="faint" role="status">
          by keys: Tab leads to a pen in the picture
        </div>
      )}
    </>
  );
}

export function ShowSections({ document, figures }: PanelProps & { figures: boolean }) {
  return (
    <Gradual>
      <SharedPanel document={document} name="View" />
      <Section name="History">
        <HistoryPanel document={document} />
      </Section>
      <Section name="People">
        <PeoplePanel document={document} />
      </Section>
      <Section name="Numbers">
        <NumbersPanel document={document} />
      </Section>
      <SharedPanel document={document} name="Light" folded />
      <SharedPanel document={document} name="Camera" folded />
      {figures && (
        <Section name="Figures">
          <Figures figures={document.figures} />
        </Section>
      )}
    </Gradual>
  );
}
