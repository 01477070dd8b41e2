// The lines over the picture, as client/app/app_drawing.cpp and overlay/ruler_overlay.cpp draw them: between original
// and edited surface, the lasso and the ruler.

import { useEffect, useRef } from "preact/hooks";
import { command } from "./commands";
import { useLink } from "./context";
import { LassoPen } from "./lasso_pen";
import type { PanelProps } from "./filter_panel";
import { PictureMenu } from "./picture_menu";

const kSplitMin = 0.05;
const kSplitMax = 0.95;
const kStep = 0.01; // of an arrow key
const kLargeStep = 0.1;
const kSame = 1e-3;

/** Text of a polyline for pixels of the picture: x, y, x, y, ... */
const pointsOf = (pixels: number[]) => pixels.map((one) => one / devicePixelRatio).join(" ");

/** `trial`: says that the picture is not of the session's values; empty or absent: it is. */
export function OverPicture({ document, trial }: PanelProps & { trial?: string }) {
  const { view, over } = document;
  return (
    <div class="over">
      <svg aria-hidden="true">
        {over.lasso.length > 0 && <polygon class="lasso" points={pointsOf(over.lasso)} />}
      </svg>
      <RulerLine document={document} />
      {view.original && <span class="side whole">original</span>}
      {trial && <span class="side whole above">{trial}</span>}
      {view.split && !view.original && <SplitLine at={view.splitAt} />}
      <PictureMenu document={document} />
      {document.lasso !== "off" && document.role !== "viewer" && <LassoPen />}
    </div>
  );
}

function RulerLine({ document }: PanelProps) {
  const { ruler, rulerLength } = document.over;
  const ends = [];
  for (let i = 0; i < ruler.length; i += 2)
    ends.push({ x: ruler[i]! / devicePixelRatio, y: ruler[i + 1]! / devicePixelRatio });
  if (ends.length === 0) return null;
  const [first, second] = ends;
  return (
    <svg role="img" aria-label={rulerLength ? `Ruler: ${rulerLength}` : "Ruler: first point"}>
      {first && second && <polyline class="ruler under" points={pointsOf(ruler)} />}
      {first && second && <polyline class="ruler" points={pointsOf(ruler)} />}
      {ends.map((end, number) => (
        <circle key={number} class="ruler" cx={end.x} cy={end.y} r={4} />
      ))}
      {first && second && (
        <text x={(first.x + second.x) / 2 + 8} y={(first.y + second.y) / 2 + 16}>
          {rulerLength}
        </text>
      )}
    </svg>
  );
}

/** The line between original and edited surface. It moves by the pointer and by keys. */
function SplitLine({ at }: { at: number }) {
  const link = useLink();
  const line = useRef<HTMLDivElement>(null);
  // The line's next place: a key may come before the snapshot that has the last move.
  const sent = useRef<number | null>(null);
  useEffect(() => {
    if (sent.current !== null && Math.abs(sent.current - at) < kSame) sent.current = null;
  }, [at]);
  const move = (to: number) => {
    sent.current = Math.min(kSplitMax, Math.max(kSplitMin, to));
    link.send(command.splitAt(sent.current));
  };
  const drag = (event: PointerEvent) => {
    if (!line.current!.hasPointerCapture(event.pointerId)) return;
    const box = line.current!.parentElement!.getBoundingClientRect();
    move((event.clientX - box.left) / box.width);
  };
  const key = (event: KeyboardEvent) => {
    const from = sent.current ?? at;
    const places: Record<string, number> = {
      ArrowLeft: from - kStep,
      ArrowRight: from + kStep,
      PageDown: from - kLargeStep,
      PageUp: from + kLargeStep,
      Home: kSplitMin,
      End: kSplitMax,
    };
    const to = places[event.key];
    if (to === undefined) return;
    event.preventDefault();
    move(to);
  };
  return (
    <div
      ref={line}
      class="split-line"
      style={{ left: `${100 * at}%` }}
      role="separator"
      aria-orientation="vertical"
      aria-label="Line between original and edited"
      aria-valuemin={100 * kSplitMin}
      aria-valuemax={100 * kSplitMax}
      aria-valuenow={Math.round(100 * at)}
      tabIndex={0}
      onPointerDown={(event) => {
        if (event.button === 0) line.current!.setPointerCapture(event.pointerId);
      }}
      onPointerMove={drag}
      onKeyDown={key}
    >
      <span class="side before">original</span>
      <span class="side after">edited</span>
    </div>
  );
}
