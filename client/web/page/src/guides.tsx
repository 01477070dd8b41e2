// The scale bar and the scan's axes over the picture, as client/app/overlay/guides_overlay.cpp draws them.

import { useEffect, useState } from "preact/hooks";
import { useLink } from "./context";
import type { Axes, AxisEnd } from "./protocol";

/** `raised`: the scale of colours is in the corner. */
export function Guides({ raised = false }: { raised?: boolean }) {
  const link = useLink();
  const [{ bar, axes }, setGuides] = useState(link.guides);
  useEffect(() => {
    link.onguides = () => setGuides(link.guides);
    setGuides(link.guides);
    return () => (link.onguides = () => {});
  }, [link]);
  return (
    <>
      {bar && (
        <div class={raised ? "scale-bar raised" : "scale-bar"} role="img" aria-label={`Scale bar: ${bar.text}`}>
          <div>{bar.text}</div>
          <div class="length" style={{ width: `${bar.pixels / devicePixelRatio}px` }} />
        </div>
      )}
      {axes && <AxesDrawing axes={axes} />}
    </>
  );
}

const inCss = (pixels: number) => pixels / devicePixelRatio;
const isPositive = ({ name }: AxisEnd) => !name.startsWith("-");

function AxesDrawing({ axes }: { axes: Axes }) {
  const middle = inCss(axes.middle);
  return (
    <svg class="axes" role="img" aria-label="Axes of the scan">
      <circle class="behind" cx={middle} cy={middle} r={inCss(axes.radius)} />
      {axes.ends.map((end) => (
        <g key={end.name} class={`axis ${end.name.replace("-", "")}`} data-axis={end.name}>
          {isPositive(end) && <line x1={middle} y1={middle} x2={inCss(end.x)} y2={inCss(end.y)} />}
          <circle class="ground" cx={inCss(end.x)} cy={inCss(end.y)} r={inCss(axes.endRadius)} />
          <circle
            class={`end${isPositive(end) ? "" : " far"}${end.pointed ? " pointed" : ""}`}
            cx={inCss(end.x)}
            cy={inCss(end.y)}
            r={inCss(axes.endRadius)}
          />
          {(isPositive(end) || end.pointed) && (
            <text x={inCss(end.x)} y={inCss(end.y)}>
              {end.name}
            </text>
          )}
        </g>
      ))}
    </svg>
  );
}
