// A panel that client/panels describes: the window draws the same widgets.

import { command } from "./commands";
import { useLink } from "./context";
import { Button, Choice, Title } from "./controls";
import type { PanelProps } from "./filter_panel";
import { Slider, betaScale, betaTone, linear, logarithmic } from "./slider";
import type { SliderWidget, Widget } from "./snapshot";
import { fixed, short } from "./words";

export const WidgetPanel = ({ document, name }: PanelProps & { name: string }) => (
  <>
    {document.panels[name]?.map((widget) => (
      <Drawn key={widget.name} {...{ widget }} place={`${name}/${widget.name}`} />
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
      return <Button {...widget} name={undefined} label={widget.name} class="wide" onClick={() => commit("press")} />;
    case "choice":
      return <Choice {...widget} onChange={commit} />;
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
