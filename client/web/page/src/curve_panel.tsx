// The transfer curve over the histogram of curvature. The core moves the points; the plot sends
// places from 0 to 1, y upwards.

import { useRef } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { isViewer, type PanelProps } from "./filter_panel";
import type { Curve, CurvePoint } from "./snapshot";
import { short } from "./words";

const kWidth = 240;
const kHeight = 132;
const kReach = 12; // pixels around a point that take it
const kStep = 0.02; // of an arrow key
const kContrastWarn = 100;

const left = (x: number) => x * kWidth;
const top = (y: number) => (1 - y) * kHeight;

export function CurvePanel({ document }: PanelProps) {
  const link = useLink();
  const plot = useRef<SVGSVGElement>(null);
  const dragging = useRef(false);
  const curve = document.curve;
  const disabled = isViewer(document);
  const placeOf = (event: PointerEvent) => {
    const box = plot.current!.getBoundingClientRect();
    return {
      x: (event.clientX - box.left) / box.width,
      y: 1 - (event.clientY - box.top) / box.height,
      reachX: kReach / box.width,
      reachY: kReach / box.height,
    };
  };
  const press = (event: PointerEvent) => {
    if (disabled || event.button !== 0) return;
    const at = placeOf(event);
    plot.current!.setPointerCapture(event.pointerId);
    dragging.current = true;
    link.send(command.plotGrab(at.x, at.y, at.reachX, at.reachY));
  };
  const move = (event: PointerEvent) => {
    if (!dragging.current) return;
    const at = placeOf(event);
    link.send(command.plotDrag(at.x, at.y));
  };
  const release = () => {
    if (!dragging.current) return;
    dragging.current = false;
    link.send(command.plotDrop());
  };
  return (
    <>
      <svg
        ref={plot}
        class="plot"
        viewBox={`0 0 ${kWidth} ${kHeight}`}
        preserveAspectRatio="none"
        role="group"
        aria-label="Plot of the transfer curve"
        onPointerDown={press}
        onPointerMove={move}
        onPointerUp={release}
        onPointerCancel={release}
        onContextMenu={(event) => event.preventDefault()}
      >
        <Histogram bars={curve.histogram} />
        <line class="middle" x1={left(0.5)} x2={left(0.5)} y1={0} y2={kHeight} />
        <polyline class="line" points={lineOf(curve)} />
        {curve.points.map((point, number) => (
          <Point key={number} {...{ point, number, disabled }} dragged={curve.dragged === number} />
        ))}
        <text x={4} y={14}>{`α ${Math.round(curve.alphaMax)}`}</text>
        <text x={4} y={kHeight - 5}>
          1
        </text>
        <text x={kWidth - 4} y={14} text-anchor="end">
          convex κ →
        </text>
      </svg>
      <Legend curve={curve} />
    </>
  );
}

const lineOf = (curve: Curve) =>
  curve.line
    .map((y, i) => `${left(i / (curve.line.length - 1)).toFixed(1)},${top(y).toFixed(1)}`)
    .join(" ");

// The root lifts the tails, which hold the detail that users edit.
function Histogram({ bars }: { bars: number[] }) {
  const tallest = Math.max(0, ...bars);
  if (tallest <= 0) return null;
  const path = bars
    .map((bar, i) => {
      const height = top(0.92 * Math.sqrt(bar / tallest)).toFixed(1);
      const from = left(i / bars.length).toFixed(1);
      return `M${from} ${kHeight}V${height}H${left((i + 1) / bars.length).toFixed(1)}V${kHeight}Z`;
    })
    .join("");
  return <path class="bars" d={path} />;
}

function Point(props: { point: CurvePoint; number: number; dragged: boolean; disabled: boolean }) {
  const { point, number, dragged, disabled } = props;
  const link = useLink();
  const remove = () => !disabled && link.send(command.plotRemove(number));
  const step = (x: number, y: number) => {
    link.send(command.plotTake(number));
    link.send(command.plotDrag(point.x + x, point.y + y));
    link.send(command.plotDrop());
  };
  const key = (event: KeyboardEvent) => {
    const steps: Record<string, [number, number]> = {
      ArrowLeft: [-kStep, 0],
      ArrowRight: [kStep, 0],
      ArrowUp: [0, kStep],
      ArrowDown: [0, -kStep],
    };
    const move = steps[event.key];
    if (disabled || (!move && event.key !== "Delete")) return;
    event.preventDefault();
    event.stopPropagation();
    if (move) step(...move);
    else remove();
  };
  return (
    <circle
      class={dragged ? "point dragged" : "point"}
      cx={left(point.x)}
      cy={top(point.y)}
      r={dragged ? 7 : 5.5}
      role="slider"
      tabindex={disabled ? -1 : 0}
      aria-label={`Point ${number + 1}`}
      aria-valuenow={Number(short(point.alpha))}
      aria-valuetext={`κ ${short(point.kappa)}, α ${short(point.alpha)}`}
      onKeyDown={key}
      onContextMenu={(event) => {
        event.preventDefault();
        remove();
      }}
    />
  );
}

function Legend({ curve }: { curve: Curve }) {
  const point = curve.points[curve.dragged];
  if (point) return <div class="faint">{`κ ${short(point.kappa)}   α ${short(point.alpha)}`}</div>;
  if (curve.contrast > kContrastWarn)
    return <div class="busy">{`contrast ${Math.round(curve.contrast)}: settles slowly`}</div>;
  return <div class="faint">click adds a point, right click or Delete removes</div>;
}
