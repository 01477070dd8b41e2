// The section through original and edited surface, with the ruler's way across the plot.

import { useState } from "preact/hooks";
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

export function SectionPlot({ section, ruler }: { section: Section; ruler: string }) {
  const link = useLink();
  const [exaggeration, setExaggeration] = useState(1);
  const heights = `scale(1 ${exaggeration})`;
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
        value={exaggeration}
        scale={logarithmic(1, 50)}
        format={short}
        onMove={setExaggeration}
        onDone={setExaggeration}
      />
      <svg
        viewBox={`${-kMargin} ${-kHeight / 2} ${kWidth} ${kHeight}`}
        role="img"
        aria-label={section.ready ? "Drawing of the section" : "Drawing of the section: waiting for the server"}
      >
        <path class="before" d={section.original} transform={heights} />
        <path class="after" d={section.edited} transform={heights} />
      </svg>
    </section>
  );
}
