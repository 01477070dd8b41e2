// A panel that client/panels describes: the window draws the same widgets.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Choice, Title } from "./controls";
import type { PanelProps } from "./filter_panel";
import { Lamp } from "./lamp";
import { Slider, betaScale, betaTone, linear, logarithmic } from "./slider";
import type { SliderWidget, Widget } from "./snapshot";
import { fixed, short } from "./words";

export const WidgetPanel = ({ document, name }: PanelProps & { name: string }) => (
  <Widgets panel={name} widgets={document.panels[name] ?? []} />
);

export const Widgets = ({ panel, widgets }: { panel: string; widgets: Widget[] }) => (
  <>
    {widgets.map((widget) => (
      <Drawn key={widget.name} {...{ widget }} place={`${panel}/${widget.name}`} />
    ))}
  </>
);

const scaleOf = ({ scale, low, high }: SliderWidget) =>
  scale === "beta" ? betaScale : scale === "linear" ? linear(low, high) : logarithmic(low, high);

function Drawn({ widget, place }: { widget: Widget; place: string }) {
  const link = useLink();
  const commit = (value: number | string) => link.send(command.panel("commit", value, place));
  switch (widget.kind) {
    case "text":
      return <div class="faint">{widget.name}</div>;
    case "button":
      return <Button {...widget} name={undefined} label={widget.name} class={widget.wide ? "wide" : undefined} onClick={() => commit("press")} />;
    case "choice":
      return <Choice {...widget} onChange={commit} />;
    case "lamp":
      return <Lamp {...widget} />;
    case "slider":
      return (
        <>
          <Title text={widget.name} hint={widget.hint} />
          <Slider
            {...widget}
            scale={scaleOf(widget)}
            format={widget.twoDecimals ? fixed(2) : short}
            tone={widget.scale === "beta" ? betaTone(widget.value) : undefined}
            onMove={(value) => link.send(command.panel("preview", value, place))}
            onDone={commit}
          />
        </>
      );
  }
}
