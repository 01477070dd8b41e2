// The section through original and edited surface, with the ruler's way across the plot.

import { command } from "./commands";
import { useLink } from "./context";
import { Button } from "./controls";
import { Slider, logarithmic } from "./slider";
import type { Section } from "./snapshot";
import { short } from "./words";

const kLength = 10_000; // of the ruler
const kMargin = kLength / 18; // the ruler has nine tenths of the width
const kWidth = kLength + 2 * kMargin;
const kHeight = 0.28 * kWidth;
const kNumbers = 1300; // left of the plot
const kNumbersBelow = 400;
const kGap = 90;

export function SectionPlot({ section, ruler }: { section: Section; ruler: string }) {
  const link = useLink();
  const heights = `scale(1 ${section.exaggeration})`;
  const exaggerate = (times: number) => link.send(command.sectionHeights(times));
  return (
    <section class="section-plot" aria-label="Section">
      <div class="section-head">
        <span>
          Section <span class="faint">original</span> <span class="bad">edited</span>{" "}
          <span class="faint">{ruler && `ruler ${ruler}`}</span>
        </span>
        <Button label="Save drawing" disabled={!section.ready} onClick={() => link.send(command.section("save svg"))} />
        <Button label="Save table" disabled={!section.ready} onClick={() => link.send(command.section("save csv"))} />
        <Button label="×" name="Close the section" onClick={() => link.send(command.section("close"))} />
      </div>
      <Slider
        name="Heights of the section"
        value={section.exaggeration}
        scale={logarithmic(1, 50)}
        format={short}
        onMove={exaggerate}
        onDone={exaggerate}
      />
      <svg
        viewBox={`${-kMargin - kNumbers} ${-kHeight / 2} ${kWidth + kNumbers} ${kHeight + kNumbersBelow}`}
        role="img"
        aria-label={section.ready ? "Drawing of the section" : "Drawing of the section: waiting for the server"}
      >
        <Numbers section={section} />
        <svg x={-kMargin} y={-kHeight / 2} width={kWidth} height={kHeight} viewBox={`${-kMargin} ${-kHeight / 2} ${kWidth} ${kHeight}`}>
          <path class="before" d={section.original} transform={heights} />
          <path class="after" d={section.edited} transform={heights} />
        </svg>
      </svg>
    </section>
  );
}

/** Numbers below the plot and left of it, and faint lines through it. */
function Numbers({ section: { ways, heights, exaggeration } }: { section: Section }) {
  const bottom = kHeight / 2;
  const lines = [
    ...ways.map(({ at }) => `M${at} ${-bottom}V${bottom}`),
    ...heights.map(({ at }) => `M${-kMargin} ${-at * exaggeration}h${kWidth}`),
  ];
  return (
    <g class="numbers">
      <path d={lines.join("")} />
      {ways.map(({ at, text }) => (
        <text key={at} class="way" x={at} y={bottom + kGap}>
          {text}
        </text>
      ))}
      {heights.map(({ at, text }) => (
        <text key={at} class="height" x={-kMargin - kGap} y={-at * exaggeration}>
          {text}
        </text>
      ))}
    </g>
  );
}
