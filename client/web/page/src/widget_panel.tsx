// A panel that client/panels describes: the window draws the same widgets.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Check, Choice, Title } from "./controls";
import type { PanelProps } from "./filter_panel";
import { Lamp } from "./lamp";
import { Slider, betaScale, betaTone, linear, logarithmic } from "./slider";
import type { SliderWidget, Widget } from "./snapshot";
import { fixed, rounded } from "./words";

export const WidgetPanel = ({ document, name }: PanelProps & { name: string }) => (
  <Widgets panel={name} widgets={document.panels[name] ?? []} />
);

/** Classes by the count of columns. */
const kRows: Record<number, string> = { 2: "row", 3: "thirds", 6: "sixths" };

export const Widgets = ({ panel, widgets }: { panel: string; widgets: Widget[] }) => (
  <>
    {widgets.map((widget, i) =>
      widget.kind === "row" ? (
        <div key={i} class={kRows[widget.columns]}>
          <Widgets panel={panel} widgets={widget.widgets} />
        </div>
      ) : (
        <Drawn key={widget.name} {...{ widget }} place={`${panel}/${widget.name}`} />
      ),
    )}
  </>
);

const scaleOf = ({ scale, low, high }: SliderWidget) =>
  scale === "beta" ? betaScale : scale === "linear" ? linear(low, high) : logarithmic(low, high);

function Drawn({ widget, place }: { widget: Exclude<Widget, { kind: "row" }>; place: string }) {
  const link = useLink();
  const commit = (value: number | string) => link.send(command.panel("commit", value, place));
  switch (widget.kind) {
    case "text":
      return (
        <div class="faint" title={widget.hint} role={widget.announced ? "status" : undefined}>
          {widget.name}
        </div>
      );
    case "button":
      return (
        <Button
          label={widget.label ?? widget.name}
          name={widget.label && widget.name}
          hint={widget.hint}
          pressed={widget.pressed}
          disabled={widget.disabled}
          onClick={() => commit("press")}
        />
      );
    case "check":
      return <Check {...widget} label={widget.name} onChange={(on) => commit(on ? "on" : "off")} />;
    case "choice":
      return <Choice {...widget} onChange={commit} />;
    case "lamp":
      return <Lamp {...widget} />;
    case "slider":
      return (
        <>
          {!widget.untitled && <Title text={widget.name} note={widget.note} hint={widget.hint} />}
          <Slider
            {...widget}
            scale={scaleOf(widget)}
            format={widget.digits === 0 ? fixed(2) : rounded(widget.digits)}
            tone={widget.scale === "beta" ? betaTone(widget.value) : undefined}
            onMove={(value) => link.send(command.panel("preview", value, place))}
            onDone={commit}
          />
        </>
      );
  }
}
